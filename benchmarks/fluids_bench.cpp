// Cost of the stages of a grid fluid, per cell.
#include <pliant/fluids/advection.h>
#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/forces.h>
#include <pliant/fluids/liquid.h>
#include <pliant/fluids/projection.h>
#include <pliant/math/parallel.h>

#include <benchmark/benchmark.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

using namespace pliant;

namespace {

template <int Dim>
StaggeredGrid<Dim> unit_box(Index n) {
    StaggeredGridInfo<Dim> info;
    info.cells.fill(n);
    info.dx = 1 / static_cast<Real>(n);
    return StaggeredGrid<Dim>(info);
}

// Large and small vortices, not free of divergence.
template <int Dim>
FaceField<Dim> swirls(const StaggeredGrid<Dim>& grid) {
    FaceField<Dim> u = grid.zero_velocity();
    for (int a = 0; a < Dim; ++a) {
        for (Index i = 0; i < u[a].size(); ++i) {
            const GridPlace<Dim> x = grid.faces(a).place(grid.faces(a).coordinates(i));
            const Real p = 6 * x[0] * grid.dx(), q = 6 * x[1] * grid.dx();
            u[a][i] = std::sin(p + a) * std::cos(q - a) + 0.2 * std::sin(5 * p) * std::cos(7 * q + a);
        }
    }
    grid.impose_walls(u);
    return u;
}

template <int Dim>
Vec<Dim> buoyancy(const Vec<Dim>& x) {
    Vec<Dim> f = Vec<Dim>::Zero();
    f[1] = x[0] < 0.5 ? 1 : -1;
    return f;
}

// Seconds to copy one number from memory to memory, the best of some tries: what no step over all cells can do without.
double seconds_per_copied_number() {
    static const double seconds = [] {
        const std::vector<Real> from(1 << 22, 1.0);
        std::vector<Real> to(from.size());
        double best = 1;
        for (int k = 0; k < 10; ++k) {
            const auto start = std::chrono::steady_clock::now();
            std::copy(from.begin(), from.end(), to.begin());
            benchmark::ClobberMemory();
            best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        return best / static_cast<double>(from.size());
    }();
    return seconds;
}

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Time per cell, and as a multiple of what copying one number takes. watch: started before the loop.
void per_cell(benchmark::State& state, const Stopwatch& watch, Index cells) {
    const double seconds = watch.seconds();
    state.counters["copies"] = seconds / (static_cast<double>(state.iterations() * cells) * seconds_per_copied_number());
    state.counters["time_per_cell"] = benchmark::Counter(
        static_cast<double>(cells), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <int Dim>
void forces(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    FaceField<Dim> u = swirls(grid);
    const Stopwatch watch;
    for (auto _ : state) add_force(grid, u, 1e-9, buoyancy<Dim>);
    per_cell(state, watch, grid.cells().size());
}

// Courant number 2.
template <int Dim>
void advection(benchmark::State& state, AdvectionSettings settings) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    SemiLagrangian<Dim> advection(grid, settings);
    FaceField<Dim> u = swirls(grid);
    const Stopwatch watch;
    for (auto _ : state) advection.advect(u, 2 * grid.dx());
    per_cell(state, watch, grid.cells().size());
}

template <int Dim>
void advection_linear(benchmark::State& state) {
    advection<Dim>(state, {});
}
void advection_euler(benchmark::State& state) { advection<2>(state, {BackTrace::euler}); }
void advection_cubic(benchmark::State& state) { advection<2>(state, {BackTrace::midpoint, Interpolation::monotone_cubic}); }
void advection_mac_cormack(benchmark::State& state) { advection<2>(state, {BackTrace::midpoint, Interpolation::linear, true}); }

// Diffusion number 1.
template <int Dim>
void implicit_viscosity(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    Viscosity<Dim> viscosity(grid);
    const FaceField<Dim> before = swirls(grid);
    FaceField<Dim> u = before;
    const Stopwatch watch;
    for (auto _ : state) {
        u = before;
        viscosity.diffuse_implicitly(u, grid.dx() * grid.dx(), 1);
    }
    per_cell(state, watch, grid.cells().size());
}

// From p = 0, relative residual 1e-5.
template <int Dim, PressurePreconditioner preconditioner = PressurePreconditioner::multigrid>
void projection(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    PressureProjection<Dim> projection(grid, {1e-5, 10000, preconditioner});
    const FaceField<Dim> before = swirls(grid);
    FaceField<Dim> u = before;
    Index iterations = 0;
    const Stopwatch watch;
    for (auto _ : state) {
        u = before;
        projection.pressure().setZero();
        iterations += projection.project(u, 0.01);
    }
    per_cell(state, watch, grid.cells().size());
    state.counters["iterations"] = benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
}

// Forces, advection and projection, to 1e-5 in 2D and 1e-6 in 3D, one step after the other; the second argument: threads.
template <int Dim>
void whole_step(benchmark::State& state) {
    set_threads(static_cast<int>(state.range(1)));
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    SemiLagrangian<Dim> advection(grid);
    PressureProjection<Dim> projection(grid, {Dim == 2 ? 1e-5 : 1e-6, 100});
    FaceField<Dim> u = swirls(grid);
    const Real dt = 2 * grid.dx();
    Index iterations = 0;
    const Stopwatch watch;
    for (auto _ : state) {
        add_force(grid, u, dt, buoyancy<Dim>);
        advection.advect(u, dt);
        iterations += projection.project(u, dt);
    }
    per_cell(state, watch, grid.cells().size());
    state.counters["iterations"] = benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
    set_threads(1);
}

// A column of liquid that falls, 2 to 1 as wide as high; cells: of the whole tank.
void liquid_step(benchmark::State& state) {
    StaggeredGridInfo<2> tank;
    tank.cells = {state.range(0), state.range(0) / 2};
    tank.dx = 1 / static_cast<Real>(state.range(0));
    const auto column = [](const Vec<2>& x) { return std::max(x[0] - 0.4, x[1] - 0.4); };
    Liquid<2> liquid(tank, {.projection = {1e-5, 300}});
    liquid.fill(column);
    Index iterations = 0;
    const Stopwatch watch;
    for (auto _ : state) iterations += liquid.step({0, -9.81}, 0.5 * tank.dx);
    per_cell(state, watch, liquid.grid().cells().size());
    state.counters["iterations"] = benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
}

}  // namespace

BENCHMARK(forces<2>)->Name("fluids/forces_2d")->Arg(256);
BENCHMARK(advection_linear<2>)->Name("fluids/advection_2d")->Arg(64)->Arg(256)->Arg(1024);
BENCHMARK(advection_linear<3>)->Name("fluids/advection_3d")->Arg(64);
BENCHMARK(advection_euler)->Name("fluids/advection_euler_2d")->Arg(256);
BENCHMARK(advection_cubic)->Name("fluids/advection_cubic_2d")->Arg(256);
BENCHMARK(advection_mac_cormack)->Name("fluids/advection_mac_cormack_2d")->Arg(256);
BENCHMARK(implicit_viscosity<2>)->Name("fluids/implicit_viscosity_2d")->Arg(256);
BENCHMARK(projection<2>)->Name("fluids/projection_2d")->Arg(64)->Arg(255)->Arg(256)->Arg(1024);
BENCHMARK(projection<3>)->Name("fluids/projection_3d")->Arg(32)->Arg(64)->Arg(128);
BENCHMARK(projection<2, PressurePreconditioner::none>)->Name("fluids/projection_plain_2d")->Arg(64)->Arg(256);
BENCHMARK(projection<2, PressurePreconditioner::jacobi>)->Name("fluids/projection_jacobi_2d")->Arg(64)->Arg(256);
BENCHMARK(projection<2, PressurePreconditioner::incomplete_cholesky>)->Name("fluids/projection_cholesky_2d")->Arg(64)->Arg(256);
BENCHMARK(projection<3, PressurePreconditioner::none>)->Name("fluids/projection_plain_3d")->Arg(64);
BENCHMARK(projection<3, PressurePreconditioner::jacobi>)->Name("fluids/projection_jacobi_3d")->Arg(64);
BENCHMARK(projection<3, PressurePreconditioner::incomplete_cholesky>)->Name("fluids/projection_cholesky_3d")->Arg(64);
BENCHMARK(whole_step<2>)->Name("fluids/whole_step_2d")->Args({64, 1})->Args({256, 1})->Args({256, 2})->UseRealTime();
BENCHMARK(whole_step<3>)->Name("fluids/whole_step_3d")->Args({64, 1})->Args({64, 2})->UseRealTime();
BENCHMARK(liquid_step)->Name("fluids/liquid_step_2d")->Arg(96)->Arg(256)->Iterations(100);
