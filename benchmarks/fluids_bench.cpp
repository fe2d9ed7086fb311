// Cost of the stages of a grid fluid, per cell.
#include <pliant/fluids/advection.h>
#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/forces.h>
#include <pliant/fluids/projection.h>

#include <benchmark/benchmark.h>
#include <cmath>

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

void per_cell(benchmark::State& state, Index cells) {
    state.counters["time_per_cell"] = benchmark::Counter(
        static_cast<double>(cells), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <int Dim>
void forces(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    FaceField<Dim> u = swirls(grid);
    for (auto _ : state) add_force(grid, u, 1e-9, buoyancy<Dim>);
    per_cell(state, grid.cells().size());
}

// Courant number 2.
template <int Dim>
void advection(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    SemiLagrangian<Dim> advection(grid);
    FaceField<Dim> u = swirls(grid);
    for (auto _ : state) advection.advect(u, 2 * grid.dx());
    per_cell(state, grid.cells().size());
}

// Diffusion number 1.
template <int Dim>
void implicit_viscosity(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    Viscosity<Dim> viscosity(grid);
    const FaceField<Dim> before = swirls(grid);
    FaceField<Dim> u = before;
    for (auto _ : state) {
        u = before;
        viscosity.diffuse_implicitly(u, grid.dx() * grid.dx(), 1);
    }
    per_cell(state, grid.cells().size());
}

// From p = 0, relative residual 1e-5.
template <int Dim, PressurePreconditioner preconditioner = PressurePreconditioner::multigrid>
void projection(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    PressureProjection<Dim> projection(grid, {1e-5, 10000, preconditioner});
    const FaceField<Dim> before = swirls(grid);
    FaceField<Dim> u = before;
    Index iterations = 0;
    for (auto _ : state) {
        u = before;
        projection.pressure().setZero();
        iterations += projection.project(u, 0.01);
    }
    per_cell(state, grid.cells().size());
    state.counters["iterations"] = benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
}

// Forces, advection and projection to 1e-5, one step after the other.
template <int Dim>
void whole_step(benchmark::State& state) {
    const StaggeredGrid<Dim> grid = unit_box<Dim>(state.range(0));
    SemiLagrangian<Dim> advection(grid);
    PressureProjection<Dim> projection(grid, {1e-5, 100});
    FaceField<Dim> u = swirls(grid);
    const Real dt = 2 * grid.dx();
    Index iterations = 0;
    for (auto _ : state) {
        add_force(grid, u, dt, buoyancy<Dim>);
        advection.advect(u, dt);
        iterations += projection.project(u, dt);
    }
    per_cell(state, grid.cells().size());
    state.counters["iterations"] = benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
}

}  // namespace

BENCHMARK(forces<2>)->Name("fluids/forces_2d")->Arg(256);
BENCHMARK(advection<2>)->Name("fluids/advection_2d")->Arg(64)->Arg(256)->Arg(1024);
BENCHMARK(advection<3>)->Name("fluids/advection_3d")->Arg(64);
BENCHMARK(implicit_viscosity<2>)->Name("fluids/implicit_viscosity_2d")->Arg(256);
BENCHMARK(projection<2>)->Name("fluids/projection_2d")->Arg(64)->Arg(255)->Arg(256)->Arg(1024);
BENCHMARK(projection<3>)->Name("fluids/projection_3d")->Arg(64);
BENCHMARK(projection<2, PressurePreconditioner::none>)->Name("fluids/projection_plain_2d")->Arg(64)->Arg(256);
BENCHMARK(projection<2, PressurePreconditioner::jacobi>)->Name("fluids/projection_jacobi_2d")->Arg(64)->Arg(256);
BENCHMARK(projection<2, PressurePreconditioner::incomplete_cholesky>)->Name("fluids/projection_cholesky_2d")->Arg(64)->Arg(256);
BENCHMARK(projection<3, PressurePreconditioner::none>)->Name("fluids/projection_plain_3d")->Arg(64);
BENCHMARK(projection<3, PressurePreconditioner::jacobi>)->Name("fluids/projection_jacobi_3d")->Arg(64);
BENCHMARK(projection<3, PressurePreconditioner::incomplete_cholesky>)->Name("fluids/projection_cholesky_3d")->Arg(64);
BENCHMARK(whole_step<2>)->Name("fluids/whole_step_2d")->Arg(64)->Arg(256);
BENCHMARK(whole_step<3>)->Name("fluids/whole_step_3d")->Arg(64);
