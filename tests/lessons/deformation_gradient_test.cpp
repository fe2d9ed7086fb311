// The deformation gradient lesson: what it shows of each map is what the map does.
#include "readings.h"

#include <pliant/continuum/deformation.h>
#include <pliant/math/line_fit.h>
#include <pliant/study/claims.h>
#include <pliant/text/format.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "why_checks.h"

#include <cmath>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner done(const Runner::Assignments& assignments) {
    Runner runner(find_lesson("elasticity/deformation_gradient"), assignments);
    runner.step();
    return runner;
}

std::span<const Real> numbers(const Runner& runner, std::string_view field) { return runner.lesson().field(field).view(); }
Vec<3> vector(const Runner& runner, std::string_view field, Index row = 0) {
    return Eigen::Map<const Vec<3>>(numbers(runner, field).data() + 3 * row);
}
Mat<3> tensor(const Runner& runner, std::string_view field, Index row = 0) {
    return Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>(numbers(runner, field).data() + 9 * row);
}

Curve line(const Runner& runner) {
    Curve curve;
    runner.lesson().lines[0].sample(curve);
    return curve;
}

const Runner::Assignments inverted{{"map", "stretch"}, {"stretch_x", "-1.2"}, {"stretch_y", "0.9"}, {"stretch_z", "1.1"}};
const Runner::Assignments flattened{{"map", "stretch"}, {"stretch_x", "1"}, {"stretch_y", "0"}, {"stretch_z", "0"}};

}  // namespace

TEST_CASE("deformation gradient: every probe with a closed form meets it, in every map", "[deformation]") {
    const char* map = GENERATE("translation", "rotation", "stretch", "shear", "free", "bend", "twist");
    const Runner runner = done({{"map", map}});
    INFO(map);
    for (const Probe& probe : runner.lesson().probes) {
        INFO(probe.name);
        if (const auto closed = runner.exact(probe))
            CHECK_THAT(runner.value(probe).value(), WithinAbs(*closed, 1e-12 * (1 + std::abs(*closed))));
    }
    CHECK(runner.holds(0) == Holds::yes);
    CHECK(runner.holds(1) == Holds::yes);
}

TEST_CASE("deformation gradient: a translation displaces all points alike, F = I and nothing is strained", "[deformation]") {
    const Runner runner = done({{"map", "translation"}, {"shift_x", "0.7"}, {"shift_y", "-0.4"}, {"shift_z", "1.9"}});
    const std::span<const Real> u = numbers(runner, "displacement");
    for (std::size_t k = 0; k < u.size(); k += 3) {
        CHECK_THAT(u[k], WithinAbs(0.7, 1e-15));
        CHECK_THAT(u[k + 1], WithinAbs(-0.4, 1e-15));
        CHECK_THAT(u[k + 2], WithinAbs(1.9, 1e-15));
    }
    CHECK(tensor(runner, "point_deformation") == Mat<3>::Identity());
    CHECK(std::ranges::all_of(numbers(runner, "green_strain"), [](Real x) { return x == 0; }));
    CHECK(vector(runner, "relative_displacement").norm() < 1e-15);
}

TEST_CASE("deformation gradient: the vectors close: dx = dX + du leads from p to q", "[deformation]") {
    const char* map = GENERATE("rotation", "stretch", "shear", "free", "bend", "twist");
    const Runner runner = done({{"map", map}});
    const Vec<3> p = vector(runner, "point_position", 0), q = vector(runner, "point_position", 1);
    CHECK((p + vector(runner, "deformed_vector") - q).norm() < 1e-15);
    CHECK((vector(runner, "mapped_vector") + vector(runner, "taylor_gap") - vector(runner, "deformed_vector")).norm() < 1e-15);
}

TEST_CASE("deformation gradient: a line of length 1 along x grows as |F dX| says", "[deformation]") {
    const Runner runner = done(
        {{"map", "shear"}, {"shear", "1"}, {"P_x", "0"}, {"P_y", "0"}, {"Q_x", "0"}, {"Q_y", "0.2"}, {"P_z", "0"}, {"Q_z", "0"}});
    CHECK_THAT(value(runner, "length_ratio"), WithinRel(std::sqrt(2.0), 1e-12));
    CHECK_THAT(value(runner, "mapped_length_ratio"), WithinRel(std::sqrt(2.0), 1e-12));
    CHECK_THAT(value(runner, "stretch_1"), WithinRel((1 + std::sqrt(5.0)) / 2, 1e-12));
}

TEST_CASE("deformation gradient: the error over the distance has slope 2 where the map bends", "[deformation]") {
    const Runner runner = done({{"map", GENERATE("bend", "twist")}});
    const Curve curve = line(runner);
    std::vector<Real> x, y;
    for (std::size_t k = 0; k < curve.position.size(); ++k) {
        REQUIRE(curve.position[k] > 0);
        REQUIRE(curve.value[k] > 0);
        if (curve.position[k] > 9e-4 && curve.position[k] < 0.05)
            x.push_back(std::log(curve.position[k])), y.push_back(std::log(curve.value[k]));
    }
    CHECK_THAT(fit_line(x, y)->slope, WithinAbs(2, 0.05));
    Curve reference;
    runner.lesson().lines[0].reference(reference);
    CHECK(reference.position.size() > 10);
}

TEST_CASE("deformation gradient: where F is the same everywhere the error is rounding and the plot stays whole",
          "[deformation]") {
    const Runner runner = done({{"map", GENERATE("translation", "rotation", "stretch", "shear", "free")}});
    CHECK(value(runner, "taylor_error") < 1e-15);
    const Curve curve = line(runner);
    CHECK(std::ranges::all_of(curve.value, [](Real error) { return error > 0 && error < 1e-14; }));
    Curve reference;
    runner.lesson().lines[0].reference(reference);
    CHECK(reference.position.empty());
}

TEST_CASE("deformation gradient: Q on P leaves ratios undefined and everything else whole", "[deformation]") {
    Runner runner = done({{"Q_x", "-0.25"}, {"Q_y", "-0.1"}, {"Q_z", "0.2"}});
    CHECK(!runner.value(runner.lesson().probe("length_ratio")));
    CHECK(value(runner, "taylor_error") == 0);
    CHECK(!line(runner).position.empty());
    check_every_stage(runner, "Q on P");
    Scene scene;
    runner.lesson().draw(scene);
    for (const LineMarks& marks : scene.lines)
        for (const Position& end : marks.ends) REQUIRE(std::isfinite(end[0] + end[1] + end[2]));
}

TEST_CASE("deformation gradient: an inverted or flattened body still has a proper rotation", "[deformation]") {
    const Runner inside_out = done(inverted), no_volume = done(flattened);
    CHECK_THAT(value(inside_out, "det_F"), WithinRel(-1.2 * 0.9 * 1.1, 1e-12));
    CHECK_THAT(value(inside_out, "stretch_3"), WithinRel(-0.9, 1e-12));
    CHECK_THAT(tensor(inside_out, "point_rotation").determinant(), WithinAbs(1, 1e-12));
    CHECK(value(no_volume, "det_F") == 0);
    CHECK_THAT(tensor(no_volume, "point_rotation").determinant(), WithinAbs(1, 1e-12));
    for (const auto& parameters : {inverted, flattened}) {
        Runner runner(find_lesson("elasticity/deformation_gradient"), parameters);
        check_every_stage(runner, "no proper body");
    }
}

TEST_CASE("deformation gradient: stays finite at the ends of what is accepted", "[deformation]") {
    const char* map = GENERATE("translation", "rotation", "stretch", "shear", "free", "bend", "twist");
    const LessonEntry& entry = find_lesson("elasticity/deformation_gradient");
    const auto made = entry.make();
    for (const bool high : {false, true}) {
        Runner::Assignments ends{{"map", map}};
        for (const Parameter* p : made->parameters)
            if (p->info.kind == Kind::number)
                ends.emplace_back(p->info.key, p->text(high ? p->accepted().max : p->accepted().min));
        Runner runner(entry, ends);
        REQUIRE_NOTHROW(runner.step());
        for (const Probe& probe : runner.lesson().probes) REQUIRE_NOTHROW(runner.value(probe));
    }
}

TEST_CASE("deformation gradient: explained in every map, gentle or not", "[deformation]") {
    for (const char* map : {"translation", "rotation", "stretch", "shear", "free", "bend", "twist"}) {
        Runner runner(find_lesson("elasticity/deformation_gradient"), {{"map", map}});
        check_every_stage(runner, map);
    }
    for (const Runner::Assignments& parameters : {Runner::Assignments{{"map", "bend"}, {"bend_curvature", "0"}},
                                                  {{"map", "bend"}, {"bend_curvature", "1e-5"}},
                                                  {{"map", "bend"}, {"bend_curvature", "-2.9"}},
                                                  {{"map", "twist"}, {"twist_rate", "0"}},
                                                  {{"map", "rotation"}, {"axis", "y"}},
                                                  {{"map", "rotation"}, {"axis", "x"}, {"angle", "-135"}}}) {
        Runner runner(find_lesson("elasticity/deformation_gradient"), parameters);
        check_every_stage(runner, parameters.back().second);
    }
}

TEST_CASE("deformation gradient: P and Q are handles", "[deformation]") {
    Runner runner = done({});
    CHECK(runner.lesson().can_pull() == On::particle);
    const auto values = runner.lesson().dragged({1, Vec<3>::Zero(), {0.1, 0.2, -0.05}});
    REQUIRE(values.size() == 3);
    for (const auto& [key, value] : values) runner.assign(key, value);
    runner.step();
    CHECK((vector(runner, "rest_vector") - Vec<3>(0.35, 0.3, -0.25)).norm() < 1e-15);
    CHECK(runner.lesson().dragged({0, Vec<3>::Zero(), {0, 0, 0}}).front().first == "P_x");
    CHECK(runner.lesson().dragged({7, Vec<3>::Zero(), {0, 0, 0}}).empty());
}

TEST_CASE("deformation gradient: its fixes mend what they promise", "[deformation]") {
    const Runner::Assignments negative{{"map", "free"}, {"F11", "-1"}};
    const std::vector<std::pair<std::string, Runner::Assignments>> broken{{"Q near P", {}},
                                                                          {"not inside out", {{"bend_curvature", "3.6"}}},
                                                                          {"not inside out", inverted},
                                                                          {"not inside out", negative}};
    for (const auto& [name, parameters] : broken) {
        INFO(name);
        Runner runner = done(parameters);
        const auto& all = runner.lesson().assumptions;
        const Assumption& checked = *std::ranges::find(all, name, &Assumption::name);
        REQUIRE(checked.value() > checked.limit());
        const auto fix = checked.fix();
        REQUIRE(fix);
        runner.assign(Runner::Assignments(fix->assign.begin(), fix->assign.end()));
        runner.step();
        CHECK(checked.value() <= checked.limit());
    }
}

TEST_CASE("deformation gradient: the claims E8 and E9 are found as expected", "[deformation]") {
    for (const char* id : {"E8", "E9"}) {
        const Claim& claim = find_claim(id);
        const Finding finding = claim.measure();
        INFO(id << ": " << finding.text);
        CHECK(finding.verdict == claim.expected);
        CHECK_NOTHROW(Runner(find_lesson(claim.lesson), claim.scene));
    }
}
