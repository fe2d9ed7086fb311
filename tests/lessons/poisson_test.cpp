// Poisson's ratio: the narrowing of a cube by the law, by the estimate and by finite elements, and locking.
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

Runner run_cube(const Runner::Assignments& assignments) {
    Runner runner(find_lesson("elasticity/poisson"), assignments);
    advance(runner, Until::at_rest());
    return runner;
}

// What small steps must give: each narrows the width that is left by nu times its own strain.
Real narrowed_in_steps(Real nu, Real strain, int steps) {
    Real width = 1, length = 1;
    for (int k = 0; k < steps; ++k) {
        width *= 1 - nu * (strain / steps) / length;
        length += strain / steps;
    }
    return 1 - width;
}

}  // namespace

TEST_CASE("poisson: the law and the estimate at nu = 0.3 and half as much again", "[poisson]") {
    const Runner runner = run_cube({});
    CHECK_THAT(value(runner, "narrowing_by_law"), WithinAbs(0.114532507, 1e-9));
    CHECK_THAT(value(runner, "narrowing_by_estimate"), WithinAbs(0.15, 1e-12));
    CHECK_THAT(value(runner, "strain"), WithinAbs(0.5, 1e-12));
    CHECK_THAT(exact(runner, "volume_ratio"), WithinAbs(std::pow(1.5, 0.4), 1e-12));
}

TEST_CASE("poisson: finite elements do what the method says, on every mesh, to rounding", "[poisson]") {
    const auto [nu, strain] = GENERATE(std::pair{0.3, 0.5}, std::pair{-0.9, 1.5}, std::pair{0.0, 0.7}, std::pair{0.4999, -0.5},
                                       std::pair{0.45, 2.0}, std::pair{-0.4, -0.9});
    const int steps = GENERATE(1, 7, 40);
    const char* cells = GENERATE("1", "3");
    INFO(nu << " " << strain << " " << steps << " " << cells);
    const Runner runner = run_cube({{"poisson_ratio", format_exact(nu)},
                                    {"axial_strain", format_exact(strain)},
                                    {"increments", std::to_string(steps)},
                                    {"resolution", cells}});
    const Real narrowing = narrowed_in_steps(nu, strain, steps);
    CHECK_THAT(value(runner, "narrowing"), WithinAbs(narrowing, 1e-9));
    CHECK_THAT(value(runner, "volume_ratio"), WithinRel((1 + strain) * (1 - narrowing) * (1 - narrowing), 1e-8));
}

TEST_CASE("poisson: small steps tend to the law with order 1, and one linear step is the estimate", "[poisson]") {
    Real last = 0;
    for (const int steps : {10, 20, 40, 80}) {
        const Real error = value(run_cube({{"increments", std::to_string(steps)}}), "narrowing_error");
        if (last > 0) CHECK_THAT(std::log2(last / error), WithinAbs(1, 0.05));
        last = error;
    }
    const Runner linear = run_cube({{"method", "linear"}});
    CHECK_THAT(value(linear, "narrowing"), WithinAbs(0.15, 1e-12));
}

TEST_CASE("poisson: the volume is kept at one half and only there; a negative ratio widens the cube", "[poisson]") {
    CHECK_THAT(exact(run_cube({{"poisson_ratio", "0.4999999"}}), "volume_ratio"), WithinAbs(1, 1e-6));
    CHECK(exact(run_cube({{"poisson_ratio", "0.3"}}), "volume_ratio") > 1.15);
    CHECK(value(run_cube({{"poisson_ratio", "-0.5"}}), "narrowing") < -0.1);
    CHECK_THAT(value(run_cube({{"poisson_ratio", "0"}}), "narrowing"), WithinAbs(0, 1e-13));
    CHECK_THAT(exact(run_cube({{"poisson_ratio", "0"}}), "narrowing"), WithinAbs(0, 1e-15));
}

TEST_CASE("poisson: where the estimate is off by 1 % and 5 %", "[poisson]") {
    const char* nu = GENERATE("0.3", "-0.5", "0", "0.49");
    const Runner runner = run_cube({{"poisson_ratio", nu}});
    for (const auto& [probe, share] : {std::pair{"strain_off_by_1_percent", 0.01}, std::pair{"strain_off_by_5_percent", 0.05}}) {
        const Real strain = value(runner, probe), ratio = std::stod(nu);
        const Real law = ratio == 0 ? std::log1p(strain) : 1 - std::pow(1 + strain, -ratio);
        CHECK_THAT((ratio == 0 ? strain : ratio * strain) / law - 1, WithinAbs(share, 1e-9));
        // To first order the estimate is off by (1 + nu) / 2 of the strain.
        CHECK_THAT(strain * (1 + ratio) / 2, WithinRel(share, 3 * share));
    }
}

TEST_CASE("poisson: Cook's membrane locks as an independent package finds", "[poisson]") {
    for (const auto& [nu, coarse, fine] : {std::tuple{"0.3", 15.61, 19.60},
                                           {"0.45", 11.10, 15.37},
                                           {"0.49", 7.395, 10.49},
                                           {"0.499", 5.549, 6.334},
                                           {"0.4999", 5.247, 5.365}}) {
        INFO(nu);
        const auto at = [nu = nu](const char* cells) {
            return run_cube({{"scene", "bending"}, {"poisson_ratio", nu}, {"membrane_cells", cells}});
        };
        CHECK_THAT(value(at("4"), "deflection"), WithinRel(coarse, 1e-3));
        CHECK_THAT(value(at("8"), "deflection"), WithinRel(fine, 1e-3));
    }
    const Runner locked = run_cube({{"scene", "bending"}, {"poisson_ratio", "0.4999"}});
    CHECK(value(locked, "times_too_stiff") > 3);
    CHECK_THAT(exact(locked, "deflection"), WithinAbs(18.46, 1e-9));
    CHECK(!holds(assumption(locked, "no locking")));
    // The parabola between the converged values meets those that it was not made from.
    CHECK_THAT(exact(run_cube({{"scene", "bending"}, {"poisson_ratio", "0.49"}}), "deflection"), WithinAbs(18.69, 0.006));
    const Runner unknown = run_cube({{"scene", "bending"}, {"poisson_ratio", "0"}});
    CHECK(!unknown.value(unknown.lesson().probe("times_too_stiff")));
}

TEST_CASE("poisson: a step that would leave no width is refused, with what to do", "[poisson]") {
    CHECK_THROWS_WITH(run_cube({{"method", "linear"}, {"axial_strain", "4"}}),
                      ContainsSubstring("no width") && ContainsSubstring("axial_strain"));
    CHECK_THROWS_WITH(run_cube({{"increments", "1"}, {"axial_strain", "4"}}), ContainsSubstring("more increments"));
    CHECK_NOTHROW(run_cube({{"axial_strain", "4"}}));
    CHECK_NOTHROW(run_cube({{"axial_strain", "-0.999"}, {"poisson_ratio", "-0.99"}}));
    CHECK_THROWS_AS(run_cube({{"poisson_ratio", "0.5"}}), Refused);
    CHECK_THROWS_AS(run_cube({{"axial_strain", "-1"}}), Refused);
}

TEST_CASE("poisson: fixes mend, explanations hold within the loop and in corner cases", "[poisson]") {
    for (const auto& [name, parameters] : {std::pair{"estimate good enough", Runner::Assignments{{"axial_strain", "1"}}},
                                           {"enough steps", {{"increments", "1"}}},
                                           {"no locking", {{"poisson_ratio", "0.4999"}}}}) {
        INFO(name);
        Runner runner = run_cube(parameters);
        const Assumption& checked = assumption(runner, name);
        REQUIRE(!holds(checked));
        const auto fix = checked.fix();
        REQUIRE(fix);
        runner.assign(Runner::Assignments(fix->assign.begin(), fix->assign.end()));
        advance(runner, Until::at_rest());
        CHECK(holds(checked));
    }
    for (const Runner::Assignments& parameters : {Runner::Assignments{{"axial_strain", "0"}},
                                                  {{"poisson_ratio", "0"}},
                                                  {{"increments", "3"}, {"axial_strain", "-0.5"}},
                                                  {{"scene", "bending"}, {"membrane_cells", "2"}}}) {
        Runner runner(find_lesson("elasticity/poisson"), parameters);
        check_every_stage(runner, "poisson");
        runner.step();
        check_probes(runner, "a stretch that is over");
    }
}

TEST_CASE("poisson: a long stretch of a cube that widens stays within its bounds", "[poisson]") {
    for (const char* method : {"incremental", "linear"})
        for (const char* nu : {"-0.9", "-0.99", "0.4999"}) {
            if (std::string_view(method) == "linear" && *nu != '-') continue;  // it would leave no width
            INFO(method << " " << nu);
            Runner runner(find_lesson("elasticity/poisson"),
                          {{"method", method}, {"poisson_ratio", nu}, {"axial_strain", "99.9"}, {"increments", "1000"}});
            CHECK_NOTHROW(advance(runner, Until::at_rest()));
        }
}
