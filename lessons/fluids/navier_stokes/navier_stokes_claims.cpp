// F1 and F6: what the lectures say of splitting and of compressible fluids, measured stage by stage.
#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/isothermal_gas.h>
#include <pliant/fluids/projection.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::navier_stokes {
namespace {

using std::numbers::pi;

Runner start(const Runner::Assignments& parameters) { return Runner(find_lesson("fluids/navier_stokes"), parameters); }

VecX numbers_of(const Runner& runner, std::string_view field) {
    const auto view = runner.lesson().field(field).view();
    return Eigen::Map<const VecX>(view.data(), static_cast<Index>(view.size()));
}

void run_for(Runner& runner, int steps) {
    for (int k = 0; k < steps; ++k) runner.step();
}

// ------------------------------------------------------------------------------------------------------------------ F1

// How far the forces are from adding Δt f, relative to it: a uniform force on a fluid that moves already.
Real error_of_forces() {
    Runner runner = start({{"scene", "poiseuille"}, {"resolution", "16"}, {"body_force", "0.5"}, {"viscosity", "0.1"}});
    run_for(runner, 3);
    const VecX before = numbers_of(runner, "u_on_faces");
    runner.run_to_stage("external_forces");
    const VecX added = numbers_of(runner, "u_on_faces") - before;
    return (added.array() / (0.5 * runner.time_step()) - 1).abs().maxCoeff();
}

// How far a short step of advection is from what its term says of the vortices u = sin 2πx cos 2πy, v = −cos 2πx sin 2πy,
// where u·∇u = π sin 4πx: largest difference of Δu/Δt from −u·∇u, over π. Doing nothing is off by 1.
Real error_of_advection(Index cells) {
    Runner runner = start({{"scene", "taylor_green"},
                           {"resolution", std::to_string(cells)},
                           {"viscosity", "0"},
                           {"time_step", format_exact(Real(0.5) / static_cast<Real>(cells))}});
    const VecX before = numbers_of(runner, "u_on_faces");
    runner.run_to_stage("advection");
    const VecX rate = (numbers_of(runner, "u_on_faces") - before) / runner.time_step();
    const Index faces = rate.size() / cells;  // in a row
    Real worst = 0;
    for (Index k = 0; k < rate.size(); ++k) {
        const Real x = static_cast<Real>(k % faces) / static_cast<Real>(cells);
        worst = std::max(worst, std::abs(rate[k] / pi + std::sin(4 * pi * x)));
    }
    return worst;
}

// How far the viscosity is from multiplying the wave sin 2πx cos 2πy by 1/(1 + 8 r sin²(πΔx)).
Real error_of_viscosity() {
    Runner runner = start({{"scene", "taylor_green"},
                           {"resolution", "32"},
                           {"viscosity", "0.01"},
                           {"with_advection", "false"},
                           {"time_step", "0.02"}});
    const VecX before = numbers_of(runner, "u_on_faces");
    runner.run_to_stage("viscosity");
    const VecX after = numbers_of(runner, "u_on_faces");
    const Real dx = Real(1) / 32, r = 0.01 * 0.02 / (dx * dx), sine = std::sin(pi * dx);
    return (after - before / (1 + 8 * r * sine * sine)).lpNorm<Eigen::Infinity>();
}

// The divergence that a step leaves, over that which its projection found.
Real left_by(const char* order) {
    Runner runner = start({{"resolution", "32"}, {"order", order}, {"tolerance", "1e-8"}});
    run_for(runner, 20);
    return runner.value("divergence_left") / runner.value("max_divergence_before");
}

// The order of the splitting: the energy of a cavity that sets out, at one time on one grid, with three time steps.
Real order_of_splitting() {
    const auto energy = [](const char* time_step, int steps) {
        Runner runner = start({{"scene", "cavity"}, {"resolution", "16"}, {"time_step", time_step}, {"tolerance", "1e-9"}});
        run_for(runner, steps);
        return runner.value("kinetic_energy");
    };
    const Real coarse = energy("0.02", 20), middle = energy("0.01", 40), fine = energy("0.005", 80);
    return std::log2(std::abs((coarse - middle) / (middle - fine)));
}

Finding splitting() {
    const Real forces = error_of_forces(), viscosity = error_of_viscosity();
    const Real coarse = error_of_advection(64), fine = error_of_advection(128), carried = std::log2(coarse / fine);
    const Real lecture = left_by("lecture"), first = left_by("projection_first"), order = order_of_splitting();
    const Real figure = std::max({forces, viscosity, lecture});
    const bool holds = figure < 1e-7 && coarse < 0.3 && std::abs(carried - 1) < 0.2 && first > 0.1 && std::abs(order - 1) < 0.3;
    return {
        .figure = figure,
        .verdict = holds ? Verdict::reproduced : Verdict::refuted,
        .text = fmt::format(
            "Forces add Δt f to {}; advection changes vortices by −Δt u·∇u, {} off on 64 cells and {} on 128, so with order {}; "
            "viscosity damps a wave by its factor to {}; the projection leaves {} of the divergence. With the projection first, "
            "a step ends with {} times the divergence that it removed. The error of splitting is of order {} in Δt.",
            steady_figure(forces), format_quantity(coarse, "", 2), format_quantity(fine, "", 2), format_quantity(carried, "", 2),
            steady_figure(viscosity), steady_figure(lecture), format_quantity(first, "", 2), format_quantity(order, "", 2))};
}

const ClaimRegistration f1{"F1", splitting};

// ------------------------------------------------------------------------------------------------------------------ F6

constexpr Index tube_cells = 128;
constexpr Real push = 0.5;  // of the speed of sound

// The same start for both fluids in a tube that closes onto itself: u = ½ c sin 2πx, squeezed in one place, thinned in another.
Real speed_at(Real x) { return push * std::sin(2 * pi * x); }

struct GasRun {
    Real rate_error, mass_error, densest, thinnest;
};
GasRun compressible() {
    IsothermalGas gas({.cells = tube_cells, .dx = Real(1) / tube_cells, .ends = TubeEnds::periodic});
    for (Index i = 0; i < tube_cells; ++i) gas.momentum()[i] = speed_at((static_cast<Real>(i) + 0.5) / tube_cells);
    const Real mass = gas.mass();
    GasRun run{0, 0, 1, 1};
    // In a first, short step the density has to change as ρ_t = −ρ ∂u/∂x, with ∂u/∂x = 2π · ½ c cos 2πx.
    IsothermalGas short_run = gas;
    const Real dt = 1e-3 * gas.stable_step();
    short_run.step(dt);
    for (Index i = 0; i < tube_cells; ++i) {
        const Real stretching = 2 * pi * push * std::cos(2 * pi * (static_cast<Real>(i) + 0.5) / tube_cells);
        run.rate_error = std::max(run.rate_error, std::abs((short_run.density()[i] - 1) / dt + stretching) / (2 * pi * push));
    }
    for (int k = 0; k < 300; ++k) {
        gas.step(0.9 * gas.stable_step());
        run.mass_error = std::max(run.mass_error, std::abs(gas.mass() / mass - 1));
        run.densest = std::max(run.densest, gas.density().maxCoeff());
        run.thinnest = std::min(run.thinnest, gas.density().minCoeff());
    }
    return run;
}

// What flows out of the worst cell per time over what did before the projection: the rate at which the density would change.
Real incompressible() {
    StaggeredGridInfo<2> info;
    info.cells = {tube_cells, 1};
    info.dx = Real(1) / tube_cells;
    info.periodic = {true, true};
    const StaggeredGrid<2> grid(info);
    FaceField<2> u = grid.zero_velocity();
    for (Index i = 0; i < tube_cells; ++i) u[0][i] = 0.25 + speed_at(static_cast<Real>(i) / tube_cells);
    const Real before = max_divergence(grid, u);
    PressureProjection<2>(grid, {.tolerance = 1e-10}).project(u, 0.01);
    return max_divergence(grid, u) / before;
}

Finding mass_of_a_gas() {
    const GasRun gas = compressible();
    const Real left = incompressible();
    const bool holds = gas.rate_error < 0.02 && gas.mass_error < 1e-12 && gas.densest > 1.2 && gas.thinnest < 0.9 && left < 1e-9;
    return {
        .figure = gas.rate_error,
        .verdict = holds ? Verdict::reproduced : Verdict::refuted,
        .text = fmt::format(
            "Where the flow runs together the gas gets denser, as ρ_t = −ρ ∇·u says, to {} of the largest rate; later its "
            "density runs from {} to {} of what it was, with the mass kept to {}, which finite volumes do by construction. The "
            "incompressible fluid, pushed in the same way, keeps its density: the projection takes the divergence to {} of "
            "what it was, and the tube flows as one.",
            format_quantity(gas.rate_error, "", 2), format_quantity(gas.thinnest, "", 3), format_quantity(gas.densest, "", 3),
            steady_figure(gas.mass_error, "", 1e-12), steady_figure(left))};
}

const ClaimRegistration f6{"F6", mass_of_a_gas};

}  // namespace
}  // namespace pliant::navier_stokes
