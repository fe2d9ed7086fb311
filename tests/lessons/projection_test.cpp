// The projection lesson: what it leaves of known fields, on both grids, and what it says when there is no solution.
#include "readings.h"

#include <pliant/fluids/collocated.h>
#include <pliant/study/claims.h>
#include <pliant/text/format.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "why_checks.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

Runner lesson(const Runner::Assignments& assignments) { return Runner(find_lesson("fluids/projection"), assignments); }

Runner done(const Runner::Assignments& assignments) {
    Runner runner = lesson(assignments);
    runner.step();
    return runner;
}

std::vector<Real> numbers(const Runner& runner, std::string_view field) {
    const auto view = runner.lesson().field(field).view();
    return {view.begin(), view.end()};
}

const Line& residual(const Runner& runner) { return *std::ranges::find(runner.lesson().lines, "residual", &Line::name); }

const std::vector<std::string> solvers{"cg", "jacobi", "incomplete_cholesky", "multigrid"};

}  // namespace

TEST_CASE("projection: every field and solver is freed of its divergence, without energy from nowhere", "[projection]") {
    for (const char* field : {"swirl", "source_sink", "jet", "random", "checkerboard", "gradient", "drawn", "through_flow"}) {
        for (const std::string& solver : solvers) {
            const Runner runner = done({{"field", field}, {"solver", solver}, {"tolerance", "1e-9"}, {"resolution", "17"}});
            INFO(field << " " << solver);
            CHECK(value(runner, "max_divergence") <= 1.01e-9 * value(runner, "max_divergence_before"));
            for (std::size_t k = 0; k < runner.lesson().conserved.size(); ++k) CHECK(runner.holds(k) != Holds::no);
            if (std::string_view(field) == "through_flow") continue;
            CHECK(value(runner, "kinetic_energy") <= value(runner, "kinetic_energy_before"));
            CHECK(std::abs(value(runner, "orthogonality")) < 1e-12);
        }
    }
}

TEST_CASE("projection: all solvers end at the same velocity", "[projection]") {
    const auto velocity = [](const std::string& solver) {
        return numbers(done({{"field", "random"}, {"obstacle", "disc"}, {"solver", solver}, {"tolerance", "1e-11"}}),
                       "u_on_faces");
    };
    const std::vector<Real> reference = velocity("multigrid");
    for (const std::string& solver : solvers) {
        const std::vector<Real> u = velocity(solver);
        for (std::size_t k = 0; k < u.size(); ++k) REQUIRE_THAT(u[k], WithinAbs(reference[k], 1e-8));
    }
}

TEST_CASE("projection: a gradient is taken out whole, and its pressure is the potential", "[projection]") {
    const Runner runner = done({{"field", "gradient"}, {"tolerance", "1e-11"}, {"resolution", "32"}, {"time_step", "0.5"}});
    CHECK(value(runner, "energy_left") < 1e-20);
    // ũ = U sin 2πx cos 2πy is ∇φ with φ = −U/(2π) cos 2πx cos 2πy; sampled differences are those of φ times (πΔx)/sin(πΔx).
    const std::vector<Real> p = numbers(runner, "pressure");
    const Real dx = 1.0 / 32, scale = pi * dx / std::sin(pi * dx) / (2 * pi);
    for (Index c = 0; c < 1024; ++c) {
        const Real x = (static_cast<Real>(c % 32) + 0.5) * dx, y = (static_cast<Real>(c / 32) + 0.5) * dx;
        REQUIRE_THAT(0.5 * p[static_cast<std::size_t>(c)], WithinAbs(-scale * std::cos(2 * pi * x) * std::cos(2 * pi * y), 1e-9));
    }
}

TEST_CASE("projection: the pressure is inverse to the time step, and the velocity does not know it", "[projection]") {
    const Runner whole = done({{"time_step", "1"}, {"tolerance", "1e-11"}}),
                 half = done({{"time_step", "0.5"}, {"tolerance", "1e-11"}});
    CHECK_THAT(value(half, "cell_pressure"), WithinRel(2 * value(whole, "cell_pressure"), 1e-9));
    CHECK_THAT(value(half, "kinetic_energy"), WithinRel(value(whole, "kinetic_energy"), 1e-12));
}

TEST_CASE("projection: pressure is low where the field flows apart and high where it runs together", "[projection]") {
    const Runner runner = done({{"field", "source_sink"}, {"cell_x", "0.3"}, {"cell_y", "0.5"}});
    CHECK(value(runner, "cell_pressure") < -0.1);
    CHECK(value(done({{"field", "source_sink"}, {"cell_x", "0.7"}, {"cell_y", "0.5"}}), "cell_pressure") > 0.1);
}

TEST_CASE("projection: gradient and solenoidal part add up to what was given", "[projection]") {
    for (const char* grid : {"staggered", "collocated"}) {
        for (const char* boundary : {"box", "periodic"}) {
            const Runner::Assignments scene{{"field", "drawn"}, {"grid", grid}, {"boundary", boundary}, {"tolerance", "1e-10"}};
            const Runner runner = done(scene);
            const std::vector<Real> given = numbers(lesson(scene), "velocity"), g = numbers(runner, "gradient_part"),
                                    s = numbers(runner, "solenoidal_part");
            Vec<2> mean = Vec<2>::Zero();  // what is neither
            Real worst = 0;
            for (std::size_t k = 0; k < given.size(); ++k) {
                const Real rest = given[k] - g[k] - s[k];
                if (k < 2) mean[static_cast<Index>(k)] = rest;
                worst = std::max(worst, std::abs(rest - mean[static_cast<Index>(k % 2)]));
            }
            INFO(grid << " " << boundary);
            CHECK(worst < 1e-13);
            CHECK((mean.norm() > 1e-3) == (std::string_view(boundary) == "periodic"));
        }
    }
}

TEST_CASE("projection: a checkerboard survives on the collocated grid alone", "[projection]") {
    const Runner::Assignments board{{"field", "checkerboard"}, {"boundary", "periodic"}, {"resolution", "8"}};
    Runner::Assignments collocated = board;
    collocated.emplace_back("grid", "collocated");
    const Runner on_faces = done(board), in_cells = done(collocated);
    CHECK(value(on_faces, "energy_left") < 1e-20);
    CHECK(value(in_cells, "energy_left") == 1);
    CHECK(value(on_faces, "null_dimension") == 1);
    CHECK(value(in_cells, "null_dimension") == 4);
    // The light of what the grid does not see, and what mends it.
    const auto& light =
        *std::ranges::find(in_cells.lesson().assumptions, "pressures that the grid does not see", &Assumption::name);
    REQUIRE(light.in_use());
    CHECK(light.value() > light.limit());
    CHECK(light.fix()->assign == Runner::Assignments{{"grid", "staggered"}});
}

TEST_CASE("projection: a checkerboard of the pressure is felt by the staggered grid alone", "[projection]") {
    for (const char* grid : {"collocated", "staggered"}) {
        const Runner::Assignments scene{{"boundary", "periodic"}, {"resolution", "16"}, {"grid", grid}};
        Runner::Assignments disturbed_scene = scene;
        disturbed_scene.emplace_back("pressure_checkerboard", "0.5");
        const Runner plain = done(scene), disturbed = done(disturbed_scene);
        const std::vector<Real> p = numbers(plain, "pressure"), q = numbers(disturbed, "pressure");
        CHECK_THAT(q[0] - p[0], WithinAbs(0.5, 1e-12));
        CHECK_THAT(q[1] - p[1], WithinAbs(-0.5, 1e-12));
        const std::vector<Real> u = numbers(plain, "velocity"), v = numbers(disturbed, "velocity");
        const bool seen = std::string_view(grid) == "staggered";
        CHECK((value(disturbed, "kinetic_energy") > 100 * value(plain, "kinetic_energy")) == seen);
        for (std::size_t k = 0; k < u.size() && !seen; ++k) REQUIRE_THAT(v[k], WithinAbs(u[k], 1e-12));
        // The laws say so.
        for (std::size_t k = 0; k < disturbed.lesson().conserved.size(); ++k) CHECK((disturbed.holds(k) == Holds::no) == seen);
    }
}

TEST_CASE("projection: one pass of the stage is one pass of the solver", "[projection]") {
    Runner runner = lesson({{"solver", "incomplete_cholesky"}, {"resolution", "40"}});
    runner.run_to_stage("divergence");
    Real last = value(runner, "max_divergence_before");
    for (int k = 1; k <= 5; ++k) {
        runner.step_pass();
        CHECK(value(runner, "solver_iterations") == k);
        CHECK(value(runner, "max_divergence") < 3 * last);
        last = value(runner, "max_divergence");
    }
    Curve curve;
    residual(runner).sample(curve);
    REQUIRE(curve.value.size() == 5);
    CHECK_THAT(curve.value[4], WithinRel(last / value(runner, "max_divergence_before"), 1e-12));
    // Back by a pass, and forward again.
    REQUIRE(runner.pass_back());
    CHECK(value(runner, "solver_iterations") == 4);
    runner.step();
    CHECK(value(runner, "max_divergence") <= 1.01e-6 * value(runner, "max_divergence_before"));
}

TEST_CASE("projection: the other solvers stand beside the chosen one", "[projection]") {
    const Runner runner = done({{"solver", "jacobi"}, {"resolution", "48"}, {"field", "random"}});
    const Line& line = residual(runner);
    std::vector<std::size_t> passes;
    for (const CompareCurve& other : line.others) {
        Curve curve;
        other.sample(curve);
        passes.push_back(curve.value.size());
    }
    REQUIRE(passes.size() == 4);
    Curve chosen;
    line.sample(chosen);
    CHECK(passes[1] == chosen.value.size());  // in its own colour too, whichever is chosen
    CHECK(static_cast<Real>(chosen.value.size()) == value(runner, "solver_iterations"));
    CHECK(passes[0] > 3 * passes[2]);
    CHECK(passes[2] > 2 * passes[3]);
    CHECK(chosen.value.size() > 3 * passes[2]);
}

TEST_CASE("projection: the collocated grid has one solver and one curve", "[projection]") {
    const Runner runner = done({{"grid", "collocated"}, {"field", "random"}, {"resolution", "20"}});
    Curve curve, other;
    residual(runner).sample(curve);
    CHECK(static_cast<Real>(curve.value.size()) == value(runner, "solver_iterations"));
    CHECK(curve.value.size() > 10);
    CHECK(curve.value.back() <= 1e-6);
    for (const CompareCurve& c : residual(runner).others) {
        c.sample(other);
        CHECK(other.value.empty());
    }
}

TEST_CASE("projection: walls that do not balance stop the run with the net flux and a way out", "[projection]") {
    Runner runner = lesson({{"field", "through_flow"}, {"outflow", "0.75"}, {"speed", "2"}});
    CHECK_THAT(value(runner, "net_inflow"), WithinRel(0.5, 1e-12));
    CHECK_THROWS_WITH(runner.step(), ContainsSubstring("net 0.5 m^2/s"));
    REQUIRE(runner.failure());
    CHECK(runner.failure()->stage == "pressure");
    const auto fix = runner.lesson().fix(*runner.failure());
    REQUIRE(fix);
    runner.assign(fix->assign);
    CHECK_NOTHROW(runner.step());
}

TEST_CASE("projection: a solver at its cap says how far it came", "[projection]") {
    for (const std::string& solver : solvers) {
        Runner runner = lesson({{"solver", solver}, {"max_iterations", "1"}, {"field", "random"}});
        CHECK_THROWS_WITH(runner.step(),
                          ContainsSubstring("after 1 iterations the residual is") && ContainsSubstring("divergence left"));
        const auto fix = runner.lesson().fix(*runner.failure());
        REQUIRE(fix);
        runner.assign(fix->assign);
        CHECK_NOTHROW(runner.step());
    }
    Runner collocated = lesson({{"grid", "collocated"}, {"max_iterations", "1"}, {"field", "random"}});
    CHECK_THROWS_WITH(collocated.step(), ContainsSubstring("divergence left"));
}

TEST_CASE("projection: nothing to solve is solved at once", "[projection]") {
    for (const char* obstacle : {"all_solid", "one_cell"}) {
        const Runner runner = done({{"field", "random"}, {"obstacle", obstacle}, {"resolution", "9"}});
        INFO(obstacle);
        CHECK(value(runner, "solver_iterations") == 0);
        CHECK(value(runner, "kinetic_energy") == 0);
        CHECK(value(runner, "max_divergence") == 0);
        for (const Real p : numbers(runner, "pressure")) CHECK(p == 0);
    }
    // Two rooms: a constant of the pressure for each.
    const Runner rooms = done({{"field", "random"}, {"obstacle", "two_rooms"}, {"resolution", "9"}});
    CHECK(value(rooms, "null_dimension") == 2);
    const std::vector<Real> p = numbers(rooms, "pressure");
    Real left = 0, right = 0;
    for (std::size_t c = 0; c < p.size(); ++c) (c % 9 < 4 ? left : right) += p[c];
    CHECK(std::abs(left) < 1e-12);
    CHECK(std::abs(right) < 1e-12);
}

TEST_CASE("projection: handles set the cell and the arrows", "[projection]") {
    const Runner runner = done({{"field", "drawn"}});
    const auto dragged = [&](Index handle, Real x, Real y) {
        return runner.lesson().dragged({.index = handle, .from = Vec<3>::Zero(), .to = Vec<3>(x, y, 0)});
    };
    using Values = std::vector<std::pair<std::string, Real>>;
    CHECK(dragged(0, 0.2, 0.4) == Values{{"cell_x", 0.2}, {"cell_y", 0.4}});
    CHECK(dragged(2, 0.1, 0.9) == Values{{"arrow2_x", 0.1}, {"arrow2_y", 0.9}});
    // The head of the first arrow, which begins at (0.25, 0.3): 0.15 m in the picture are 1 m/s.
    const Values tip = dragged(4, 0.25 + 0.15, 0.3 - 0.075);
    REQUIRE(tip.size() == 2);
    CHECK(tip[0].first == "arrow1_u");
    CHECK_THAT(tip[0].second, WithinAbs(1, 1e-12));
    CHECK_THAT(tip[1].second, WithinAbs(-0.5, 1e-12));
    CHECK(dragged(99, 0, 0).empty());
    CHECK(done({{"field", "jet"}}).lesson().dragged({.index = 2, .from = Vec<3>::Zero(), .to = Vec<3>::Zero()}).empty());
}

TEST_CASE("projection: the numbers explain themselves in corner cases", "[projection]") {
    const std::vector<Runner::Assignments> scenes{
        {{"field", "through_flow"}, {"obstacle", "disc"}, {"resolution", "11"}},
        {{"field", "through_flow"}, {"speed", "-2"}, {"outflow", "1"}, {"resolution", "3"}},
        {{"field", "random"}, {"obstacle", "two_rooms"}, {"boundary", "periodic"}, {"resolution", "7"}},
        {{"field", "drawn"}, {"boundary", "periodic"}, {"resolution", "2"}},
        {{"field", "random"}, {"resolution", "1"}},
        {{"field", "random"}, {"resolution", "1"}, {"boundary", "periodic"}},
        {{"field", "random"}, {"grid", "collocated"}, {"resolution", "1"}},
        {{"field", "random"}, {"grid", "collocated"}, {"resolution", "2"}, {"boundary", "periodic"}},
        {{"field", "random"}, {"grid", "collocated"}, {"resolution", "3"}},
        {{"field", "jet"}, {"obstacle", "disc"}, {"resolution", "9"}, {"pressure_checkerboard", "-0.3"}},
        {{"field", "jet"}, {"grid", "collocated"}, {"resolution", "5"}, {"pressure_checkerboard", "2"}},
        {{"field", "jet"}, {"grid", "collocated"}, {"resolution", "6"}, {"boundary", "periodic"}, {"speed", "0"}}};
    for (const Runner::Assignments& scene : scenes) {
        Runner runner = lesson(scene);
        check_every_stage(runner, fmt::format("{}={}", scene[1].first, scene[1].second), 1, 1);
    }
}
