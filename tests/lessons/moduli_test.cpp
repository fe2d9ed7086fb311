// The virtual material tests: what they measure is what the material was made of.
#include "readings.h"

#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/text/format.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner run_test(const Runner::Assignments& assignments) {
    Runner runner(find_lesson("elasticity/moduli"), assignments);
    advance(runner, Until::at_rest());
    return runner;
}

}  // namespace

TEST_CASE("moduli: every test measures its modulus, for soft and stiff, thin and flat blocks", "[moduli]") {
    const char* test = GENERATE("tension", "shear", "pressure");
    const char* youngs_modulus = GENERATE("1e6", "200e9", "1e-3");
    const char* nu = GENERATE("0.3", "0", "-0.9", "0.45");
    const auto [length, width] = GENERATE(std::pair{"0.2", "0.1"}, std::pair{"0.0371", "0.173"}, std::pair{"2", "0.01"});
    const Real load = std::stod(youngs_modulus) * 0.01;
    const Runner runner = run_test({{"test", test},
                                    {"youngs_modulus", youngs_modulus},
                                    {"poisson_ratio", nu},
                                    {"load", format_exact(load)},
                                    {"length", length},
                                    {"width", width},
                                    {"resolution", "3"}});
    INFO(test << " Y " << youngs_modulus << " nu " << nu << " length " << length << " width " << width);
    for (const char* probe : {"measured_modulus", "force", "area", "stress", "strain"}) {
        INFO(probe);
        CHECK_THAT(value(runner, probe), WithinRel(exact(runner, probe), 1e-9));
    }
    const Real strain = std::abs(value(runner, "strain"));
    CHECK_THAT(value(runner, "transverse_strain"), WithinAbs(exact(runner, "transverse_strain"), 1e-9 * strain));
    CHECK_THAT(value(runner, "volume_change"), WithinAbs(exact(runner, "volume_change"), 1e-8 * strain));
    CHECK_THAT(value(runner, "strain_energy"), WithinRel(exact(runner, "strain_energy"), 1e-8));
    CHECK(runner.holds(0) == Holds::yes);
}

TEST_CASE("moduli: a steel bar of 2 m and 1e-4 m^2 under 1000 N grows by 0.1 mm", "[moduli]") {
    const Runner runner =
        run_test({{"youngs_modulus", "200e9"}, {"load", "1e7"}, {"length", "2"}, {"width", "0.01"}, {"resolution", "1"}});
    CHECK_THAT(value(runner, "force"), WithinRel(1000.0, 1e-9));
    CHECK_THAT(value(runner, "strain") * 2, WithinRel(1e-4, 1e-9));
    CHECK_THAT(value(runner, "transverse_strain") / value(runner, "strain"), WithinRel(-0.3, 1e-9));
}

TEST_CASE("moduli: strain is negative in compression and under pressure", "[moduli]") {
    CHECK(value(run_test({{"load", "-1e4"}}), "strain") < 0);
    CHECK(value(run_test({{"load", "1e4"}, {"test", "pressure"}}), "strain") < 0);
    CHECK(value(run_test({{"load", "-1e4"}, {"test", "pressure"}}), "strain") > 0);
    CHECK_THAT(value(run_test({{"load", "-1e4"}, {"test", "pressure"}}), "measured_modulus"), WithinRel(1e6 / 1.2, 1e-9));
}

TEST_CASE("moduli: without a load nothing moves and no modulus is defined", "[moduli]") {
    const char* test = GENERATE("tension", "shear", "pressure");
    const Runner runner = run_test({{"test", test}, {"load", "0"}});
    CHECK(!runner.value(runner.lesson().probe("measured_modulus")));
    CHECK(value(runner, "strain") == 0);
    CHECK(value(runner, "force") == 0);
    CHECK(runner.holds(0) == Holds::yes);
}

TEST_CASE("moduli: the number of loads changes neither the slope nor the end", "[moduli]") {
    const Runner one = run_test({{"load_levels", "1"}}), many = run_test({{"load_levels", "17"}});
    CHECK_THAT(value(one, "measured_modulus"), WithinRel(value(many, "measured_modulus"), 1e-9));
    CHECK_THAT(value(one, "strain"), WithinRel(value(many, "strain"), 1e-9));
    Curve curve;
    many.lesson().lines[0].sample(curve);
    CHECK(curve.position.size() == 18);
}

TEST_CASE("moduli: one step is the whole test and further ones change nothing", "[moduli]") {
    const char* tolerance = GENERATE("1e-12", "1e-15", "0.1");
    Runner runner(find_lesson("elasticity/moduli"), {{"tolerance", tolerance}});
    CHECK(!runner.lesson().at_rest());
    runner.step();
    CHECK(runner.lesson().at_rest());
    const auto hash = state_hash(runner.lesson());
    const Real modulus = value(runner, "measured_modulus");
    advance(runner, Until::after_steps(3));
    CHECK(state_hash(runner.lesson()) == hash);
    CHECK(value(runner, "measured_modulus") == modulus);
}

TEST_CASE("moduli: solving on from the middle of a solve gives the same bits", "[moduli]") {
    Runner straight(find_lesson("elasticity/moduli")), wandering(find_lesson("elasticity/moduli"));
    straight.step();
    for (int i = 0; i < 9; ++i) wandering.step_pass();
    const Place here = wandering.place();
    for (int i = 0; i < 5; ++i) wandering.step_pass();
    REQUIRE(wandering.go_to(here));
    while (wandering.inside_step()) wandering.step_pass();
    CHECK(state_hash(wandering.lesson()) == state_hash(straight.lesson()));
}

TEST_CASE("moduli: the unit of length changes no strain, to a million times larger or smaller", "[moduli]") {
    const Real unit = GENERATE(1e-6, 1e6);
    const Runner metre = run_test({{"length", "1.3"}, {"width", "1"}});
    const Runner other = run_test({{"length", format_exact(1.3 * unit)}, {"width", format_exact(unit)}});
    CHECK_THAT(value(other, "strain"), WithinRel(value(metre, "strain"), 1e-6));
    CHECK_THAT(value(other, "measured_modulus"), WithinRel(1e6, 1e-9));
}

TEST_CASE("moduli: what is no material or no block is refused by name", "[moduli]") {
    const LessonEntry& entry = find_lesson("elasticity/moduli");
    for (const char* nu : {"0.5", "0.6", "-1", "-1.2", "nan", "inf"})
        CHECK_THROWS_WITH(Runner(entry, {{"poisson_ratio", nu}}), ContainsSubstring("poisson_ratio"));
    for (const char* youngs_modulus : {"0", "-1", "nan", "inf"})
        CHECK_THROWS_WITH(Runner(entry, {{"youngs_modulus", youngs_modulus}}), ContainsSubstring("youngs_modulus"));
    for (const char* key : {"length", "width", "resolution", "load_levels", "tolerance"})
        for (const char* bad : {"0", "-1", "nan"}) CHECK_THROWS_WITH(Runner(entry, {{key, bad}}), ContainsSubstring(key));
    CHECK_THROWS_WITH(Runner(entry, {{"length", "1"}, {"width", "1e-6"}}),
                      ContainsSubstring("length") && ContainsSubstring("width"));
}

TEST_CASE("moduli: at nu = 0.4999 uniform tests stay exact, and the lesson warns of locking", "[moduli]") {
    const char* test = GENERATE("tension", "shear", "pressure");
    const Runner runner = run_test({{"test", test}, {"poisson_ratio", "0.4999"}});
    CHECK_THAT(value(runner, "measured_modulus"), WithinRel(exact(runner, "measured_modulus"), 1e-7));
    const auto& assumptions = runner.lesson().assumptions;
    const auto locking =
        std::find_if(assumptions.begin(), assumptions.end(), [](const Assumption& a) { return a.name == "compressible enough"; });
    REQUIRE(locking != assumptions.end());
    CHECK(locking->value() > locking->limit());
}

TEST_CASE("moduli: a loose tolerance saves iterations and costs digits", "[moduli]") {
    const Runner tight = run_test({{"tolerance", "1e-12"}}), loose = run_test({{"tolerance", "1e-2"}});
    CHECK(value(loose, "solver_iterations") < 0.5 * value(tight, "solver_iterations"));
    const Real error_loose = std::abs(value(loose, "measured_modulus") / 1e6 - 1),
               error_tight = std::abs(value(tight, "measured_modulus") / 1e6 - 1);
    CHECK(error_tight < 1e-10);
    CHECK(error_loose > 100 * error_tight);
}

TEST_CASE("moduli: a solver that is stopped early is told by name and residual, and leaves finite numbers", "[moduli]") {
    const Runner runner = run_test({{"max_iterations", "1"}});
    CHECK(value(runner, "solver_iterations") == 5);
    CHECK(value(runner, "solver_residual") > 1e-3);
    CHECK(std::isfinite(value(runner, "measured_modulus")));
    const auto& assumptions = runner.lesson().assumptions;
    const auto converged =
        std::find_if(assumptions.begin(), assumptions.end(), [](const Assumption& a) { return a.name == "solver converged"; });
    REQUIRE(converged != assumptions.end());
    CHECK(converged->value() > converged->limit());
}

TEST_CASE("finite strain: the curves touch the linear one at rest and follow the closed forms beyond it", "[moduli]") {
    for (const char* test : {"tension", "shear", "pressure"}) {
        INFO(test);
        Runner runner(find_lesson("elasticity/moduli"), {{"test", test}, {"resolution", "2"}, {"load", "1e5"}});
        runner.step();
        const Lesson& lesson = runner.lesson();
        const Real modulus = *runner.exact(lesson.probe("measured_modulus")) * (std::string_view(test) == "pressure" ? -1 : 1);
        const Line& line = *std::ranges::find(lesson.lines, "measured_stress", &Line::name);
        REQUIRE(line.others.size() == 2);
        for (const CompareCurve& other : line.others) {
            Curve curve;
            other.sample(curve);
            REQUIRE(curve.position.size() > 10);
            CHECK(curve.value[0] == 0);
            CHECK(std::abs(curve.value[1] / curve.position[1] / modulus - 1) < 0.05);
            // Far out it is another material; only in shear is the neo-Hookean one straight.
            const Real bend = std::abs(curve.value.back() / curve.position.back() / modulus - 1);
            if (other.name == "neo-Hookean" && std::string_view(test) == "shear")
                CHECK(bend < 1e-9);
            else
                CHECK(bend > 0.005);
        }
        if (std::string_view(test) != "tension") continue;
        Curve stvk;
        line.others[1].sample(stvk);
        const Real s = 1 + stvk.position.back();
        CHECK(std::abs(stvk.value.back() / (1e6 * s * (s * s - 1) / 2) - 1) < 1e-9);
    }
}

TEST_CASE("finite strain: at 30 % both laws pull as the walkthrough says", "[moduli]") {
    Runner runner(find_lesson("elasticity/moduli"), {{"test", "tension"}, {"resolution", "2"}, {"load", "3e5"}});
    runner.step();
    const Line& line = *std::ranges::find(runner.lesson().lines, "measured_stress", &Line::name);
    for (const CompareCurve& other : line.others) {
        Curve curve;
        other.sample(curve);
        const auto after = static_cast<std::size_t>(std::ranges::lower_bound(curve.position, Real(0.3)) - curve.position.begin());
        REQUIRE(after > 0);
        REQUIRE(after < curve.position.size());
        const Real part = (0.3 - curve.position[after - 1]) / (curve.position[after] - curve.position[after - 1]);
        const Real stress = std::lerp(curve.value[after - 1], curve.value[after], part);
        CHECK(std::abs(stress - (other.name == "neo-Hookean" ? 248.5e3 : 448.5e3)) < 500);
    }
}

TEST_CASE("moduli: while a load is solved, what is measured is that of the loads before", "[moduli]") {
    Runner runner(find_lesson("elasticity/moduli"));
    for (int k = 0; k < 2; ++k) runner.run_to_stage("fit_modulus");
    const Real before = runner.value("measured_modulus");
    const auto points = [&] {
        for (const Line& line : runner.lesson().lines)
            if (line.name == "measured_stress") return curve_of(line.sample).value.size();
        return std::size_t{0};
    };
    CHECK(points() == 3);
    runner.run_to_stage("apply_load");
    runner.step_pass();
    CHECK(runner.value("measured_modulus") == before);
    CHECK(points() == 3);
    Scene picture;
    runner.lesson().draw(picture);
    for (const std::string& note : picture.notes) CHECK_THAT(note, !ContainsSubstring("= 0 Pa"));
    runner.run_to_stage("fit_modulus");
    CHECK(points() == 4);
}
