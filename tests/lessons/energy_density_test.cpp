// Energy densities as a lesson: known stresses and energies through its parameters, and what each energy does when squeezed.
#include "readings.h"

#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/text/format.h>

#include "why_checks.h"

#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner run_density(const Runner::Assignments& assignments) {
    Runner runner(find_lesson("elasticity/energy_density"), assignments);
    advance(runner, Until::at_rest());
    return runner;
}

}  // namespace

TEST_CASE("energy_density: a general F has the stress and the energy of the catalogue", "[energy]") {
    struct Known {
        const char* energy;
        Real P11, P12, P13, psi;
    };
    for (const auto& [energy, P11, P12, P13, psi] : {Known{"stvk", 440480.769, 203293.269, 35769.231, 74323.1671},
                                                     Known{"corotated", 290365.966, 139190.233, 15482.497, 57948.6062},
                                                     Known{"neo_hookean", 224753.963, 114188.734, 10762.932, 50116.2458}}) {
        INFO(energy);
        const Runner runner = run_density({{"path", "free"}, {"energy", energy}});
        CHECK_THAT(value(runner, "P11"), WithinAbs(P11, 0.6e-3));
        CHECK_THAT(value(runner, "P12"), WithinAbs(P12, 0.6e-3));
        CHECK_THAT(value(runner, "P13"), WithinAbs(P13, 0.6e-3));
        CHECK_THAT(value(runner, "psi"), WithinAbs(psi, 0.6e-4));
        CHECK_THAT(value(runner, "det_F"), WithinAbs(1.1895, 1e-12));
        CHECK(value(runner, "derivative_check") < 1e-8);
        CHECK(runner.holds(0) == Holds::yes);
    }
}

TEST_CASE("energy_density: known paths, and every closed form that the lesson states", "[energy]") {
    CHECK_THAT(value(run_density({}), "P11"), WithinRel(448500.0, 1e-12));
    CHECK_THAT(value(run_density({}), "lateral_stretch"), WithinAbs(0.890505474, 1e-9));
    CHECK_THAT(value(run_density({{"energy", "neo_hookean"}, {"stretch", "0.5"}}), "P11"), WithinAbs(-935352.06, 0.006));
    CHECK_THAT(value(run_density({{"energy", "neo_hookean"}, {"stretch", "2"}}), "P11"), WithinAbs(646744.66, 0.006));
    int compared = 0;
    for (const char* energy : {"linear", "stvk", "corotated", "neo_hookean"})
        for (const char* path : {"uniaxial", "held", "volumetric", "shear"})
            for (const char* stretch : {"0.4", "0.9", "1", "1.6"}) {
                const Runner runner = run_density(
                    {{"energy", energy}, {"path", path}, {"stretch", stretch}, {"shear", stretch}, {"poisson_ratio", "0.4"}});
                INFO(energy << " " << path << " " << stretch);
                CHECK(value(runner, "derivative_check") < 1e-7);
                for (const char* probe : {"psi", "P11", "P12"})
                    if (const auto exact = runner.exact(runner.lesson().probe(probe))) {
                        CHECK_THAT(value(runner, probe), WithinAbs(*exact, 1e-9 * (std::abs(*exact) + 1e3)));
                        ++compared;
                    }
                if (std::string(path) == "uniaxial") CHECK_THAT(value(runner, "P22"), WithinAbs(0, 1e-6));
            }
    CHECK(compared > 60);
}

TEST_CASE("energy_density: StVK softens below 1/sqrt(3), the others do not", "[energy]") {
    CHECK(holds(run_density({{"stretch", "0.578"}}), "does not soften"));
    CHECK(!holds(run_density({{"stretch", "0.577"}}), "does not soften"));
    CHECK_THAT(value(run_density({{"stretch", format_exact(1 / std::sqrt(3.0))}}), "stiffness"), WithinAbs(0, 1e-8));
    CHECK_THAT(value(run_density({{"stretch", "0"}}), "P11"), WithinAbs(0, 1e-9));
    for (const char* energy : {"linear", "corotated", "neo_hookean"})
        for (const char* stretch : {"0.05", "0.3", "1.5"})
            CHECK(holds(run_density({{"energy", energy}, {"stretch", stretch}}), "does not soften"));
}

TEST_CASE("energy_density: three energies go through inversion and say so, neo-Hookean refuses it", "[energy]") {
    for (const char* energy : {"linear", "stvk", "corotated"})
        for (const char* stretch : {"0", "-0.25"}) {
            const Runner runner = run_density({{"energy", energy}, {"stretch", stretch}});
            INFO(energy << " " << stretch);
            CHECK(!holds(runner, "not inside out"));
            CHECK(value(runner, "derivative_check") < 1e-6);
            Scene scene;
            runner.lesson().draw(scene);
            CHECK(std::ranges::any_of(scene.notes, [](const std::string& note) { return note.starts_with("det F"); }));
        }
    for (const Runner::Assignments& flat : {Runner::Assignments{{"stretch", "0"}},
                                            {{"stretch", "-0.2"}},
                                            {{"path", "free"}, {"F11", "-1"}},
                                            {{"path", "held"}, {"stretch", "0"}}}) {
        Runner::Assignments all = flat;
        all.emplace_back("energy", "neo_hookean");
        CHECK_THROWS_WITH(run_density(all), ContainsSubstring("infinite"));
    }
    CHECK_THROWS_WITH(run_density({{"energy", "neo_hookean"}, {"poisson_ratio", "-0.9"}, {"stretch", "0.5"}}),
                      ContainsSubstring("no width"));
    CHECK_THROWS_WITH(run_density({{"energy", "corotated"}, {"stretch", "5"}}), ContainsSubstring("corotated"));
}

TEST_CASE("energy_density: nearly flat and stretched far, everything stays a number", "[energy]") {
    for (const char* energy : {"linear", "stvk", "corotated", "neo_hookean"})
        for (const char* path : {"uniaxial", "held", "volumetric"})
            for (const char* nu : {"0", "0.3", "0.4999"})
                for (const char* stretch : {"1e-6", "0.01", "3"}) {
                    INFO(energy << " " << path << " " << nu << " " << stretch);
                    const Runner runner =
                        run_density({{"energy", energy}, {"path", path}, {"stretch", stretch}, {"poisson_ratio", nu}});
                    for (const Probe& p : runner.lesson().probes) CHECK_NOTHROW(runner.value(p));
                    for (const Line& line : runner.lesson().lines) {
                        Curve curve;
                        line.sample(curve);
                        CHECK(curve.position.size() > 5);
                        for (const CompareCurve& other : line.others) other.sample(curve);
                        CHECK(std::ranges::all_of(curve.value, [](Real x) { return std::isfinite(x); }));
                    }
                }
}

TEST_CASE("energy_density: the curves hold the other energies and the cube's own point", "[energy]") {
    const Runner runner = run_density({{"energy", "neo_hookean"}, {"stretch", "0.6"}});
    const Line& stress = runner.lesson().lines[0];
    std::vector<std::string_view> drawn;
    for (const CompareCurve& other : stress.others) {
        Curve curve;
        other.sample(curve);
        if (!curve.position.empty()) drawn.push_back(other.name);
        if (other.name == "the cube now") {
            REQUIRE(curve.position == std::vector<Real>{0.6});
            CHECK_THAT(curve.value[0], WithinRel(value(runner, "P11"), 1e-12));
        }
        if (other.points && other.name.starts_with("StVK")) {
            CHECK_THAT(curve.position[0], WithinAbs(0.57735, 1e-5));
            CHECK_THAT(curve.value[0], WithinRel(-1e6 / (3 * std::sqrt(3.0)), 1e-12));
        }
    }
    CHECK(drawn.size() == 5);
    CHECK(std::ranges::find(drawn, "neo-Hookean") == drawn.end());
}

TEST_CASE("energy_density: dragged corners set the deformation", "[energy]") {
    const auto dragged = [](const Runner::Assignments& parameters, Index corner, const Vec<3>& to) {
        const Runner runner(find_lesson("elasticity/energy_density"), parameters);
        return runner.lesson().dragged({.index = corner, .from = Vec<3>::Zero(), .to = to});
    };
    using Values = std::vector<std::pair<std::string, Real>>;
    CHECK(dragged({}, 1, {0.7, 9, 9}) == Values{{"stretch", 0.7}});
    CHECK(dragged({}, 2, {0.7, 0, 0}).empty());
    CHECK(dragged({{"path", "shear"}}, 3, {1.4, 1, 0})[0].first == "shear");
    CHECK_THAT(dragged({{"path", "shear"}}, 3, {1.4, 1, 0})[0].second, WithinAbs(0.4, 1e-12));
    CHECK_THAT(dragged({{"path", "volumetric"}}, 7, {1.5, 1.5, 1.5})[0].second, WithinAbs(1.5, 1e-12));
    CHECK(dragged({{"path", "free"}}, 4, {0.1, 0.2, 0.9}) == Values{{"F13", 0.1}, {"F23", 0.2}, {"F33", 0.9}});
}

TEST_CASE("energy_density: explanations hold on every path, and fixes mend", "[energy]") {
    for (const char* energy : {"linear", "stvk", "corotated", "neo_hookean"})
        for (const char* path : {"uniaxial", "held", "volumetric", "shear", "free"})
            for (const char* stretch : {"0.5", "1", "3"}) {
                if (std::string(stretch) == "3" && std::string(path) == "free") continue;
                Runner runner(find_lesson("elasticity/energy_density"),
                              {{"energy", energy}, {"path", path}, {"stretch", stretch}, {"poisson_ratio", "0.2"}});
                check_every_stage(runner, std::string(energy) + " " + path);
            }
    for (const auto& [name, parameters] : {std::pair{"does not soften", Runner::Assignments{{"stretch", "0.3"}}},
                                           {"does not soften", {{"stretch", "-0.1"}}},
                                           {"not inside out", {{"stretch", "-0.1"}, {"energy", "linear"}}},
                                           {"not inside out", {{"path", "free"}, {"F11", "-1"}}},
                                           {"small displacement gradient", {{"energy", "linear"}, {"stretch", "1.5"}}}}) {
        INFO(name);
        Runner runner = run_density(parameters);
        REQUIRE(!holds(runner, name));
        const Assumption& a = *std::ranges::find(runner.lesson().assumptions, name, &Assumption::name);
        const auto fix = a.fix();
        REQUIRE(fix);
        runner.assign(Runner::Assignments(fix->assign.begin(), fix->assign.end()));
        advance(runner, Until::at_rest());
        CHECK(holds(runner, name));
    }
}

TEST_CASE("energy_density: a block on sliding ends does what the cube does, and glued ends hold it back", "[energy]") {
    for (const char* energy : {"linear", "stvk", "corotated", "neo_hookean"})
        for (const char* stretch : {"0.8", "1.2", "1.6"}) {
            INFO(energy << " " << stretch);
            const Runner::Assignments along{{"energy", energy}, {"stretch", stretch}, {"path", "uniaxial"}};
            const auto at_end = [&](const char* ends, std::string_view probe) {
                Runner::Assignments all = along;
                all.emplace_back("ends", ends);
                const Runner runner = run_density(all);
                CHECK(holds(runner, "block in equilibrium"));
                return *runner.value(runner.lesson().probe(probe));
            };
            const Real cube = at_end("sliding", "P11");
            CHECK(std::abs(at_end("sliding", "block_stress") / cube - 1) < 1e-6);
            // What may not narrow (or widen) at its ends takes more force.
            CHECK(std::abs(at_end("glued", "block_stress")) > 1.001 * std::abs(cube));
        }
}

// Values of a computation with sixty digits. A step that mirrors the block in both directions across ends in a proper body again,
// turned by half a turn and as good as pulled through itself.
TEST_CASE("energy_density: nearly incompressible and stretched far, the cube and the block keep their numbers", "[energy]") {
    const Runner runner =
        run_density({{"energy", "neo_hookean"}, {"path", "uniaxial"}, {"poisson_ratio", "0.4999"}, {"stretch", "5"}});
    CHECK_THAT(value(runner, "lateral_stretch"), WithinAbs(0.4472494, 5e-8));
    CHECK_THAT(value(runner, "P11"), WithinAbs(1.653441e6, 0.5));
    CHECK_THAT(value(runner, "psi"), WithinAbs(3.733561e6, 0.5));
    for (const char* poisson_ratio : {"0", "0.3", "0.49", "0.4999"})
        for (const char* stretch : {"0.01", "0.1", "2", "4", "5", "6", "8", "10"}) {
            INFO("poisson_ratio = " << poisson_ratio << ", stretch = " << stretch);
            const Runner pulled =
                run_density({{"energy", "neo_hookean"}, {"poisson_ratio", poisson_ratio}, {"stretch", stretch}});
            CHECK(holds(pulled, "block in equilibrium"));
            CHECK_THAT(value(pulled, "block_width"), WithinRel(value(pulled, "lateral_stretch"), 1e-5));
            CHECK_THAT(value(pulled, "block_stress"), WithinRel(value(pulled, "P11"), 1e-5));
        }
}

TEST_CASE("energy_density: a block that gives up never takes the cube's numbers along", "[energy]") {
    int given_up = 0;
    for (const char* energy : {"linear", "stvk", "corotated", "neo_hookean"})
        for (const char* ends : {"sliding", "glued"})
            for (const char* poisson_ratio : {"-0.5", "0.3", "0.4999", "0.499999"})
                for (const char* stretch : {"-0.9", "-0.2", "0", "1e-9", "0.3", "5", "10"}) {
                    INFO(energy << " " << ends << " " << poisson_ratio << " " << stretch);
                    std::optional<Runner> runner;
                    try {
                        runner.emplace(
                            find_lesson("elasticity/energy_density"),
                            Runner::Assignments{
                                {"energy", energy}, {"ends", ends}, {"poisson_ratio", poisson_ratio}, {"stretch", stretch}});
                    } catch (const Refused&) {
                        continue;  // no width in equilibrium: told before the first step
                    }
                    advance(*runner, Until::at_rest());
                    for (const Probe& p : runner->lesson().probes) CHECK_NOTHROW(runner->value(p));
                    if (runner->value(runner->lesson().probe("block_stress"))) continue;
                    ++given_up;
                    CHECK(!holds(*runner, "block in equilibrium"));
                }
    CHECK(given_up > 0);
}
