// What an implicit step of a hanging sheet costs, and its parts. Time in ms; counters: iterations of conjugate gradients in a
// step.
#include <pliant/mesh/lattice.h>
#include <pliant/solids/springs_system.h>

#include <benchmark/benchmark.h>

#include <memory>

namespace {
using namespace pliant;

// A square sheet of n x n nodes, 1 m and 0.2 kg, held at two corners: the lesson's cloth.
struct Sheet {
    explicit Sheet(Index n) : lattice({n - 1, n - 1, 0}, Vec<3>::Constant(1.0 / Real(n - 1))), x(lattice.points()) {
        x.row(2).swap(x.row(1));
        std::vector<Spring> list;
        append_springs<3>(x, lattice.structural(), 500, 0.002, list);
        append_springs<3>(x, lattice.face_diagonals(), 100, 0.002, list);
        append_springs<3>(x, lattice.bending(), 1, 0.002, list);
        springs = Springs(lattice.node_count(), list);
        v = Points<3>::Zero(3, x.cols());
        mass = VecX::Constant(x.cols(), 0.2 / Real(x.cols()));
        inertia = DiagonalMass(mass, 3, {0, n - 1});
        system = std::make_unique<SpringSystem<3>>(springs, mass);
        system->set_sheet(n, n);
        system->load.gravity = {0, -9.81, 0};
        system->damping = SpringDamping::projected;
    }
    void step(ImplicitSolver& solver) {
        implicit_euler(1.0 / 60, flat(x), flat(v), solver.form());
        solver.begin(flat(x));
        while (solver.again()) solver.iterate();
        solver.finish(flat(x), flat(v));
    }
    NodeLattice<3> lattice;
    Points<3> x, v;
    Springs springs;
    VecX mass;
    DiagonalMass inertia;
    std::unique_ptr<SpringSystem<3>> system;
};

NewtonOptions real_time() {
    return {.max_iterations = 1,
            .at_cap = AtCap::accept,
            .linear_solve = LinearSolve::conjugate_gradients,
            .linear_tolerance = 1e-4,
            .linear_iterations = 20};
}

void cloth_step(benchmark::State& state) {
    Sheet sheet(state.range(0));
    ImplicitSolver solver(*sheet.system, sheet.inertia, real_time());
    for (int k = 0; k < 30; ++k) sheet.step(solver);
    Real iterations = 0;
    for (auto _ : state) sheet.step(solver), iterations += solver.linear_iterations();
    state.counters["linear_iterations"] = iterations / static_cast<Real>(state.iterations());
}
BENCHMARK(cloth_step)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond);

void cloth_linearise(benchmark::State& state) {
    Sheet sheet(state.range(0));
    sheet.system->begin_step(flat(sheet.x));
    for (auto _ : state) benchmark::DoNotOptimize(sheet.system->linearise(flat(sheet.x), 60, 3600, sheet.inertia));
}
BENCHMARK(cloth_linearise)->Arg(64)->Unit(benchmark::kMillisecond);

void cloth_product(benchmark::State& state) {
    Sheet sheet(state.range(0));
    sheet.system->begin_step(flat(sheet.x));
    const LinearisedSystem* h = sheet.system->linearise(flat(sheet.x), 60, 3600, sheet.inertia);
    VecX d = VecX::Ones(sheet.x.size()), product = d;
    for (auto _ : state) h->multiply(d, product), benchmark::ClobberMemory();
}
BENCHMARK(cloth_product)->Arg(64)->Unit(benchmark::kMillisecond);

void cloth_potential(benchmark::State& state) {
    Sheet sheet(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(sheet.system->potential(flat(sheet.x)));
}
BENCHMARK(cloth_potential)->Arg(64)->Unit(benchmark::kMillisecond);

}  // namespace
