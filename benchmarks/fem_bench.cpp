// Cost of linear finite elements: assembly, internal force, one iteration of conjugate gradients, factorisation.
#include <pliant/math/sparse_cholesky.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/linear_fem_static.h>

#include <benchmark/benchmark.h>

namespace {

using namespace pliant;

Lame steel() { return IsotropicModuli::from_young_poisson(200e9, 0.3).lame(); }

template <int Dim>
SimplexMesh<Dim> cube(int cells) {
    BlockShape<Dim> block;
    block.cells.fill(cells);
    return block_mesh<Dim>(block);
}

// Reports the time per item, with `count` items per iteration.
void per_item(benchmark::State& state, const char* name, Index count) {
    state.counters[name] = benchmark::Counter(static_cast<double>(count),
                                              benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <int Dim>
DisplacementConstraints<Dim> clamped(const SimplexMesh<Dim>& mesh) {
    DisplacementConstraints<Dim> constraints(mesh.node_count());
    constraints.prescribe(mesh.nodes("x_min"), Vec<Dim>::Zero());
    return constraints;
}

template <int Dim>
void mesh_block(benchmark::State& state) {
    const int cells = static_cast<int>(state.range(0));
    Index elements = 0;
    for (auto _ : state) elements = cube<Dim>(cells).simplex_count();
    per_item(state, "time_per_element", elements);
}

template <int Dim>
void assemble(benchmark::State& state) {
    const auto mesh = cube<Dim>(static_cast<int>(state.range(0)));
    const std::vector<Lame> materials(static_cast<std::size_t>(mesh.simplex_count()), steel());
    for (auto _ : state) {
        const LinearFem<Dim> body(mesh, materials);
        benchmark::DoNotOptimize(body.stiffness().valuePtr());
    }
    per_item(state, "time_per_element", mesh.simplex_count());
}

template <int Dim>
void internal_force(benchmark::State& state) {
    const auto mesh = cube<Dim>(static_cast<int>(state.range(0)));
    const LinearFem<Dim> body(mesh, steel());
    Points<Dim> force;
    for (auto _ : state) {
        body.internal_force(mesh.points(), force);
        benchmark::DoNotOptimize(force.data());
    }
    per_item(state, "time_per_element", mesh.simplex_count());
}

enum class Preconditioner { none, jacobi, incomplete_cholesky };

template <int Dim, Preconditioner kind>
void cg_iteration(benchmark::State& state) {
    const auto mesh = cube<Dim>(static_cast<int>(state.range(0)));
    const LinearFem<Dim> body(mesh, steel());
    const StaticProblem<Dim> problem(body, clamped(mesh));
    const SparseMatrix& K = problem.system().matrix();
    ConjugateGradients cg(K.rows(), product_with(K),
                          kind == Preconditioner::none     ? no_preconditioner()
                          : kind == Preconditioner::jacobi ? jacobi_preconditioner(K)
                                                           : incomplete_cholesky_preconditioner(K),
                          {1e-12});
    const VecX b = VecX::LinSpaced(K.rows(), 0, 1), zero = VecX::Zero(K.rows());
    cg.begin(b, zero);
    for (auto _ : state) {
        if (!cg.running()) {
            state.PauseTiming();
            state.counters["iterations_to_1e-12"] = static_cast<double>(cg.iterations());
            cg.begin(b, zero);
            state.ResumeTiming();
        }
        cg.iterate();
    }
    per_item(state, "time_per_nonzero", K.nonZeros());
}

template <int Dim>
void factorize(benchmark::State& state) {
    const auto mesh = cube<Dim>(static_cast<int>(state.range(0)));
    const LinearFem<Dim> body(mesh, steel());
    const StaticProblem<Dim> problem(body, clamped(mesh));
    SparseCholesky cholesky;
    cholesky.analyze(problem.system().matrix());
    for (auto _ : state) cholesky.factorize(problem.system().matrix());
    per_item(state, "time_per_nonzero_of_factor", cholesky.factor_entries());
}

BENCHMARK(mesh_block<2>)->Arg(64);
BENCHMARK(mesh_block<3>)->Arg(16);
BENCHMARK(assemble<2>)->Arg(64);
BENCHMARK(assemble<3>)->Arg(16);
BENCHMARK(internal_force<2>)->Arg(64);
BENCHMARK(internal_force<3>)->Arg(16);
BENCHMARK((cg_iteration<3, Preconditioner::none>))->Arg(12);
BENCHMARK((cg_iteration<3, Preconditioner::jacobi>))->Arg(12);
BENCHMARK((cg_iteration<3, Preconditioner::incomplete_cholesky>))->Arg(12);
BENCHMARK((cg_iteration<2, Preconditioner::jacobi>))->Arg(64);
BENCHMARK(factorize<3>)->Arg(8);

}  // namespace
