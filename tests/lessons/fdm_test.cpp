// Finite differences: the triangle wave, orders, the limit of the step, equilibria beside finite elements, and what a hand does.
#include "readings.h"

#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/text/format.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <string>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using FdmSettings = Runner::Assignments;

Runner start_fdm(const FdmSettings& settings) { return Runner(find_lesson("mesh/fdm"), settings); }

Runner fdm_solved(const FdmSettings& settings) {
    Runner runner = start_fdm(settings);
    runner.step();
    CHECK(runner.lesson().at_rest());
    check_laws(runner);
    return runner;
}

Runner fdm_after(Index steps, const FdmSettings& settings) {
    Runner runner = start_fdm(settings);
    for (Index k = 0; k < steps; ++k) runner.step();
    return runner;
}

// Does the run blow up within so many steps?
bool fdm_blows_up(Index steps, const FdmSettings& settings) try {
    const Runner runner = fdm_after(steps, settings);
    return false;
} catch (const Diverged&) {
    return true;
}

}  // namespace

TEST_CASE("fdm: a released rod is a triangle wave, exact at the limit of the step", "[fdm]") {
    Runner rod = start_fdm({{"resolution", "100"}, {"time_step", "5e-4"}});
    CHECK_THAT(value(rod, "stable_time_step"), WithinRel(1e-3, 1e-12));
    for (const auto& [t, tip] : {std::pair{0.05, 0.005}, {0.1, 0.0}, {0.2, -0.01}, {0.3, 0.0}, {0.4, 0.01}}) {
        advance(rod, Until::after_time(t - rod.time()));
        CHECK_THAT(value(rod, "tip"), WithinAbs(tip, 2e-4));
        CHECK_THAT(exact(rod, "tip"), WithinAbs(tip, 1e-12));
    }
    check_laws(rod);
    advance(rod, Until::after_time(2));
    CHECK_THAT(value(rod, "frequency"), WithinRel(2.5, 2e-3));
    CHECK(exact(rod, "frequency") == 2.5);
    CHECK_THAT(value(rod, "energy"), WithinRel(0.5 * 1e4 * 1e-4, 2e-3));
    // Verlet with one cell a step.
    CHECK(value(fdm_after(173, {{"resolution", "16"}, {"time_step", "6.25e-3"}}), "nodal_error") < 1e-13);
    // The mean error over all nodes shrinks with the spacing; the kinks keep it from doing so as its square.
    const auto off = [](const char* n) {
        return value(fdm_after(100, {{"resolution", n}, {"time_step", "5e-4"}}), "nodal_error");
    };
    CHECK(off("64") < 0.7 * off("16"));
}

TEST_CASE("fdm: a manufactured field is met at second order by both forms", "[fdm]") {
    const Runner linear = fdm_solved({{"scene", "manufactured"}, {"resolution", "16"}});
    CHECK_THAT(value(linear, "observed_order"), WithinAbs(2, 0.2));
    CHECK_THAT(value(linear, "nodal_error"), WithinRel(5.4827e-4, 1e-3));
    CHECK_THAT(value(linear, "finite_elements_error"), WithinRel(8.9387e-4, 1e-3));
    const Runner metric =
        fdm_solved({{"scene", "manufactured"}, {"resolution", "16"}, {"form", "metric_tensor"}, {"amplitude", "0.03"}});
    CHECK_THAT(value(metric, "observed_order"), WithinAbs(2, 0.2));
}

TEST_CASE("fdm: a disc in stairs is of first order, and finite elements beside it are not", "[fdm]") {
    const Runner coarse = fdm_solved({{"scene", "disc"}, {"resolution", "8"}}),
                 fine = fdm_solved({{"scene", "disc"}, {"resolution", "32"}});
    const Real order = std::log(value(coarse, "nodal_error") / value(fine, "nodal_error")) / std::log(4);
    CHECK_THAT(order, WithinAbs(1, 0.25));
    CHECK(value(fine, "finite_elements_error") < 0.05 * value(fine, "nodal_error"));
    CHECK_FALSE(holds(fine, "boundary_on_grid"));
}

TEST_CASE("fdm: the block comes to rest where a fine mesh of finite elements has it; the other form sinks more", "[fdm]") {
    const FdmSettings block{{"scene", "block"}, {"resolution", "32"}, {"time_step", "2e-3"}, {"damping", "20"}};
    Runner runner = start_fdm(block);
    advance(runner, Until::at_rest());
    check_laws(runner);
    // Quadratic triangles on 96 × 96 cells: 0.744 mm and -40.886 mm.
    CHECK_THAT(value(runner, "u_y_corner"), WithinRel(-0.040886, 2e-3));
    CHECK_THAT(value(runner, "u_x_corner"), WithinAbs(7.44e-4, 1.5e-4));
    CHECK_THAT(value(runner, "u_y_top_middle"), WithinRel(-0.0447, 5e-3));
    // The supports carry the weight.
    Real carried = 0;
    const auto reaction = field(runner, "reaction");
    for (std::size_t k = 1; k < reaction.size(); k += 2) carried += reaction[k];
    CHECK_THAT(carried, WithinRel(1000, 1e-2));
    FdmSettings metric = block;
    metric.emplace_back("form", "metric_tensor");
    Runner other = start_fdm(metric);
    advance(other, Until::at_rest());
    CHECK(value(other, "u_y_top_middle") < 1.1 * value(runner, "u_y_top_middle"));
    // Small strains are the same to both.
    for (FdmSettings* settings : {&metric}) settings->emplace_back("body_force", "1");
    Runner small = start_fdm(metric);
    advance(small, Until::at_rest());
    CHECK_THAT(1000 * value(small, "u_y_top_middle"), WithinRel(value(runner, "u_y_top_middle"), 2e-3));
}

TEST_CASE("fdm: steps are bounded below Δx/√(c_p² + c_s²) and blow up above it", "[fdm]") {
    for (const char* integrator : {"velocity_verlet", "semi_implicit_euler"})
        for (const char* scene : {"rod", "block"}) {
            FdmSettings settings{{"scene", scene}, {"integrator", integrator}, {"resolution", "24"}, {"damping", "0"}};
            const Real limit = value(start_fdm(settings), "stable_time_step");
            CAPTURE(integrator, scene, limit);
            const auto at = [&](Real share) {
                FdmSettings with_step = settings;
                with_step.emplace_back("time_step", format_exact(share * limit));
                return with_step;
            };
            CHECK_FALSE(fdm_blows_up(1500, at(0.99)));
            CHECK(fdm_blows_up(1500, at(1.01)));
            CHECK(holds(start_fdm(at(0.99)), "stability"));
            CHECK_FALSE(holds(start_fdm(at(1.01)), "stability"));
        }
    // Damped as the block is at first, too.
    const FdmSettings damped{{"scene", "block"}, {"resolution", "16"}};
    const Real limit = value(start_fdm(damped), "stable_time_step");
    CHECK_FALSE(fdm_blows_up(1500, {{"scene", "block"}, {"resolution", "16"}, {"time_step", format_exact(0.99 * limit)}}));
    CHECK(fdm_blows_up(1500, {{"scene", "block"}, {"resolution", "16"}, {"time_step", format_exact(1.01 * limit)}}));
}

TEST_CASE("fdm: edges of a block with ν near ½ lower the limit, which is told before it is passed", "[fdm]") {
    FdmSettings settings{{"scene", "block"}, {"resolution", "16"}, {"poisson_ratio", "0.45"}, {"damping", "0"}};
    const Runner still = start_fdm(settings);
    const Real inside = value(still, "stable_time_step"), limit = value(still, "longest_step");
    CHECK_THAT(limit / inside, WithinAbs(0.9204, 2e-3));
    for (const auto& [share, fails] : {std::pair{0.99, false}, {1.02, true}}) {
        FdmSettings with_step = settings;
        with_step.emplace_back("time_step", format_exact(share * limit));
        CHECK(fdm_blows_up(1500, with_step) == fails);
    }
}

TEST_CASE("fdm: metric tensors do not feel a turn, and small strains do", "[fdm]") {
    Runner runner = start_fdm({{"scene", "block"}, {"resolution", "8"}, {"form", "metric_tensor"}, {"body_force", "0"}});
    runner.step();
    CHECK(value(runner, "energy") == 0);
    CHECK(value(runner, "force_sum") == 0);
    CHECK(runner.lesson().at_rest());
}

TEST_CASE("fdm: a hand pulls a node, and lets go", "[fdm]") {
    Runner runner = start_fdm({{"scene", "block"}, {"resolution", "8"}, {"body_force", "0"}, {"damping", "20"}});
    const Index corner = 80;
    runner.pull(Pull{.index = corner, .from = {1, 1, 0}, .to = {1.2, 1, 0}});
    for (int k = 0; k < 800; ++k) runner.step();
    CHECK(value(runner, "u_x_corner") > 0.02);
    CHECK(value(runner, "u_x_corner") < 0.2);
    runner.pull(std::nullopt);
    advance(runner, Until::at_rest());
    CHECK(std::abs(value(runner, "u_x_corner")) < 1e-3);
    runner.pull(Pull{.index = 81});
    CHECK_THROWS_AS(runner.step(), Refused);
}

TEST_CASE("fdm: a body in units a million times as large is the same body", "[fdm]") {
    const Runner metres = fdm_solved({{"scene", "disc"}, {"resolution", "8"}});
    const Runner large = fdm_solved({{"scene", "disc"}, {"resolution", "8"}, {"length", "1e6"}, {"body_force", "1e-3"}});
    CHECK_THAT(value(large, "nodal_error"), WithinRel(1e6 * value(metres, "nodal_error"), 1e-9));
    const Runner rod = fdm_after(40, {}), small = fdm_after(40, {{"length", "1e-6"}, {"time_step", "1e-9"}});
    CHECK_THAT(value(small, "tip"), WithinRel(1e-6 * value(rod, "tip"), 1e-9));
}
