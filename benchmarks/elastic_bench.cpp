// What a step and a static iteration of elastic bodies cost. Beside times there are ratios to the memory of this machine: kB of
// triad, a[i] = b[i] + s c[i] with 24 bytes an entry, that pass in the time of one tetrahedron. Two threads where a name says so.
#include <pliant/math/parallel.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/mesh/element_mass.h>
#include <pliant/solids/bem/space_boundary_elements.h>
#include <pliant/solids/elastic_system.h>
#include <pliant/solids/newton_equilibrium.h>
#include <pliant/solids/warped_stiffness.h>
#include <pliant/time/time_integrator.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>

namespace {
using namespace pliant;

// Bytes per second of the triad over 240 MB in one thread, the best of several: measured once.
Real triad_rate() {
    static const Real rate = [] {
        constexpr Index size = 10'000'000;
        VecX a = VecX::Zero(size), b = VecX::Ones(size), c = b;
        Real best = 0;
        for (int k = 0; k < 10; ++k) {
            const auto start = std::chrono::steady_clock::now();
            a.noalias() = b + 3.0 * c;
            benchmark::DoNotOptimize(a.data());
            benchmark::ClobberMemory();
            const std::chrono::duration<Real> taken = std::chrono::steady_clock::now() - start;
            best = std::max(best, 24 * Real(size) / taken.count());
        }
        return best;
    }();
    return rate;
}

// Time per tetrahedron as ns and as kB of triad.
struct PerTetrahedron {
    PerTetrahedron(benchmark::State& measured, Index elements) : state(measured), count(elements) { triad_rate(); }
    ~PerTetrahedron() {
        const std::chrono::duration<Real> taken = std::chrono::steady_clock::now() - start;
        const Real seconds = taken.count() / static_cast<Real>(state.iterations()) / static_cast<Real>(count);
        state.counters["ns_per_tet"] = 1e9 * seconds;
        state.counters["triad_kB_per_tet"] = seconds * triad_rate() / 1000;
    }
    benchmark::State& state;
    Index count;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

SimplexMesh<3> slab(std::array<int, 3> cells) {
    BlockShape<3> shape;
    shape.cells = cells;
    shape.size = Vec<3>(cells[0], cells[1], cells[2]) / 20;
    shape.split = CellSplit::diagonal;
    return block_mesh(shape);
}

Lame soft() { return IsotropicModuli::from_young_poisson(1e5, 0.3).lame(); }

enum class Law { linear, corotational, neo_hookean };

std::unique_ptr<ElasticBody<3>> body_of(Law law, const SimplexMesh<3>& mesh) {
    if (law == Law::corotational) return std::make_unique<WarpedStiffness<3>>(mesh, soft());
    return std::make_unique<HyperelasticFem<3>>(mesh, law == Law::linear ? Energy::linear : Energy::neo_hookean, soft());
}

// A slab of 1 m × 1 m × ½ m that hangs at one side and swings: implicit Euler with Δt = 0.01 s and one Newton iteration.
void elastic_step(benchmark::State& state, Law law, int threads, LinearSolve solve) {
    set_threads(threads);
    const SimplexMesh<3> mesh = slab(solve == LinearSolve::direct ? std::array{10, 10, 5} : std::array{20, 20, 10});
    const auto body = body_of(law, mesh);
    const DiagonalMass mass(lumped_mass<3, 1>(SimplexElements<3, 1>(mesh), 1000), 3, mesh.nodes("x_min"));
    ElasticSystem<3> system(*body, mesh.points(), mass);
    system.load.gravity = Vec<3>(0, -9.81, 0);
    TimeIntegrator integrator(
        system, mass, Scheme::implicit_euler,
        {.max_iterations = 1, .at_cap = AtCap::accept, .linear_solve = solve, .linear_tolerance = 1e-6, .warm_start = true});
    Points<3> x = mesh.points(), v = Points<3>::Zero(3, x.cols());
    for (int k = 0; k < 10; ++k) integrator.step(0.01, flat(x), flat(v));
    Real iterations = 0;
    {
        const PerTetrahedron clock(state, mesh.simplex_count());
        for (auto _ : state) {
            integrator.step(0.01, flat(x), flat(v));
            iterations += integrator.solver().linear_iterations();
        }
    }
    state.counters["linear_iterations"] = iterations / static_cast<Real>(state.iterations());
    set_threads(1);
}

void elastic_part(benchmark::State& state, Law law, int part) {
    const SimplexMesh<3> mesh = slab({20, 20, 10});
    const auto body = body_of(law, mesh);
    Points<3> u = 0.1 * mesh.points().colwise().reverse(), force;
    SparseMatrix K = body->pattern();
    const NodeBlocks<3> blocks(K);
    VecX d = VecX::Ones(K.rows()), product = d;
    body->stiffness(u, true, K);
    const PerTetrahedron clock(state, mesh.simplex_count());
    for (auto _ : state) {
        if (part == 0) benchmark::DoNotOptimize(body->energy(u));
        if (part == 1) body->internal_force(u, force);
        if (part == 2) body->stiffness(u, true, K);
        if (part == 3) blocks.multiply(K, d, product);
        benchmark::ClobberMemory();
    }
}

// One iteration of Newton's method for the slab under its weight, from where it has come to.
void static_iteration(benchmark::State& state, LinearSolver solver) {
    const SimplexMesh<3> mesh = slab({20, 20, 10});
    const auto body = body_of(Law::neo_hookean, mesh);
    DisplacementConstraints<3> held(mesh.node_count());
    held.prescribe(mesh.nodes("x_min"), Vec<3>::Zero());
    NewtonEquilibrium<3> newton(*body, held, {.solver = solver});
    const Points<3> rest = Points<3>::Zero(3, mesh.node_count());
    Points<3> weight = rest;
    weight.row(1) = -1.0 * lumped_mass<3, 1>(SimplexElements<3, 1>(mesh), 1000).transpose();
    newton.begin(rest, weight, held);
    const PerTetrahedron clock(state, mesh.simplex_count());
    for (auto _ : state) {
        if (!newton.running()) newton.begin(rest, weight, held);
        newton.iterate();
    }
}

// Both matrices of a sphere of triangles: time per pair of a node and a triangle.
void boundary_assembly(benchmark::State& state) {
    const SimplexMesh<3> mesh = slab({8, 8, 8});
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1);
    Points<3> nodes(3, mesh.node_count());
    SpaceBoundaryElements::Triangles triangles = mesh.facets();
    int count = 0;
    for (int& n : triangles.reshaped()) {
        int& known = number[static_cast<std::size_t>(n)];
        if (known < 0) nodes.col(known = count++) = mesh.points().col(n);
        n = known;
    }
    SpaceBoundaryElements surface(nodes.leftCols(count), triangles, soft(), false);
    for (auto _ : state) surface.assemble();
    state.counters["ns_per_pair"] = benchmark::Counter(
        1e-9 * Real(count) * Real(triangles.cols()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

[[maybe_unused]] const bool registered = [] {
    const auto step = [](const char* name, Law law, int threads, LinearSolve solve) {
        benchmark::RegisterBenchmark((std::string("elastic/step/") + name).c_str(),
                                     [=](benchmark::State& s) { elastic_step(s, law, threads, solve); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    step("corotational", Law::corotational, 1, LinearSolve::conjugate_gradients);
    step("corotational/two_threads", Law::corotational, 2, LinearSolve::conjugate_gradients);
    step("neo_hookean", Law::neo_hookean, 1, LinearSolve::conjugate_gradients);
    step("neo_hookean/two_threads", Law::neo_hookean, 2, LinearSolve::conjugate_gradients);
    step("linear", Law::linear, 1, LinearSolve::conjugate_gradients);
    step("linear/3000_factorised", Law::linear, 1, LinearSolve::direct);
    for (const bool direct : {true, false})
        benchmark::RegisterBenchmark(
            direct ? "elastic/static_iteration/direct" : "elastic/static_iteration/conjugate_gradients",
            [=](benchmark::State& s) { static_iteration(s, direct ? LinearSolver::direct : LinearSolver::conjugate_gradients); })
            ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("elastic/boundary_assembly", boundary_assembly)->Unit(benchmark::kMillisecond);
    const std::array parts{"energy", "force", "stiffness", "product"};
    for (const auto& [name, law] : {std::pair{"corotational", Law::corotational}, std::pair{"neo_hookean", Law::neo_hookean}})
        for (int part = 0; part < 4; ++part)
            benchmark::RegisterBenchmark((std::string("elastic/") + parts[static_cast<std::size_t>(part)] + "/" + name).c_str(),
                                         [=, l = law](benchmark::State& s) { elastic_part(s, l, part); })
                ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
