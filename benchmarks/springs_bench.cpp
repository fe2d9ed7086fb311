// Cost of one pass over the springs of a block, per spring.
#include <pliant/mesh/lattice.h>
#include <pliant/solids/springs_frequency.h>
#include <pliant/solids/springs_system.h>

#include <benchmark/benchmark.h>

namespace {
using namespace pliant;

// A block of n^3 cells: 60 000 springs at n = 17.
struct Block {
    explicit Block(Index n) : lattice({n, n, n}, Vec<3>::Constant(0.1)), rest(lattice.points()) {
        std::vector<Spring> list;
        append_springs<3>(rest, lattice.structural(), 1000, 1, list);
        append_springs<3>(rest, lattice.face_diagonals(), 500, 1, list);
        append_springs<3>(rest, lattice.bending(), 200, 1, list);
        springs = Springs(lattice.node_count(), list);
        x = 1.02 * rest;
        v = 0.1 * rest;
        f = Points<3>::Zero(3, rest.cols());
        mass = VecX::Constant(rest.cols(), 0.01);
    }
    NodeLattice<3> lattice;
    Points<3> rest, x, v, f;
    Springs springs;
    VecX mass;
};

// The time in ns that one spring takes.
void report(benchmark::State& state, const Block& block) {
    state.counters["springs"] = static_cast<double>(block.springs.size());
    state.counters["ns_per_spring"] =
        benchmark::Counter(static_cast<double>(block.springs.size()) * 1e-9,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void spring_forces(benchmark::State& state) {
    Block block(state.range(0));
    for (auto _ : state) {
        add_spring_forces<3>(block.springs, block.x, block.f);
        benchmark::ClobberMemory();
    }
    report(state, block);
}
BENCHMARK(spring_forces)->Arg(6)->Arg(17)->Arg(40);

void projected_damping(benchmark::State& state) {
    Block block(state.range(0));
    for (auto _ : state) {
        add_damping_forces<3>(block.springs, SpringDamping::projected, block.x, block.v, block.f);
        benchmark::ClobberMemory();
    }
    report(state, block);
}
BENCHMARK(projected_damping)->Arg(17);

void energy(benchmark::State& state) {
    Block block(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(spring_energy<3>(block.springs, block.x));
    report(state, block);
}
BENCHMARK(energy)->Arg(17);

void stiffness_matrix(benchmark::State& state) {
    Block block(state.range(0));
    SpringMatrix<3> matrix(block.springs);
    for (auto _ : state) {
        matrix.set_zero();
        matrix.add_stiffness(block.springs, block.x, SpringCurvature::positive);
        benchmark::ClobberMemory();
    }
    report(state, block);
}
BENCHMARK(stiffness_matrix)->Arg(17);

void frequency_estimate(benchmark::State& state) {
    Block block(state.range(0));
    const DiagonalMass inertia(block.mass, 3);
    for (auto _ : state)
        benchmark::DoNotOptimize(spring_rate_estimates<3>(block.springs, inertia, SpringDamping::projected, block.x));
    report(state, block);
}
BENCHMARK(frequency_estimate)->Arg(17);

void implicit_step(benchmark::State& state) {
    Block block(state.range(0));
    const DiagonalMass inertia(block.mass, 3);
    SpringSystem<3> system(block.springs, block.mass);
    ImplicitSolver solver(system, inertia);
    for (auto _ : state) {
        implicit_euler(0.01, flat(block.x), flat(block.v), solver.form());
        solver.begin(flat(block.x));
        while (solver.again()) solver.iterate();
        solver.finish(flat(block.x), flat(block.v));
    }
    report(state, block);
}
BENCHMARK(implicit_step)->Arg(3)->Arg(5)->Unit(benchmark::kMillisecond);

}  // namespace
