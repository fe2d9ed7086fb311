#include "comparison.h"

#include <pliant/math/dense_lu.h>
#include <pliant/math/sparse_cholesky.h>
#include <pliant/solids/linear_fem_static.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::bem {
namespace {

struct RingMesh {
    SimplexMesh<2> mesh;
    Index around;
};
// `across` layers of quadrangles, each cut in two; about as long as they are wide, and nodes on both axes.
RingMesh ring_mesh(const PressedRing& ring, int across) {
    const Real middle = (ring.inner + ring.outer) / 2, wall = ring.outer - ring.inner;
    const auto around = 4 * static_cast<int>(std::clamp<Real>(std::round(std::numbers::pi / 2 * middle / wall * across), 2, 128));
    Points<2> points(2, (across + 1) * around);
    SimplexMesh<2>::Simplices triangles(3, 2 * across * around);
    Index t = 0;
    for (int j = 0; j <= across; ++j)
        for (int i = 0; i < around; ++i) {
            const Real r = ring.inner + wall * j / across, angle = 2 * std::numbers::pi * i / around;
            points.col(j * around + i) = r * Vec<2>(std::cos(angle), std::sin(angle));
            if (j == across) continue;
            const int next = (i + 1) % around, a = j * around + i, b = (j + 1) * around + i, c = (j + 1) * around + next,
                      d = j * around + next;
            triangles.col(t++) << a, b, c;
            triangles.col(t++) << a, c, d;
        }
    return {SimplexMesh<2>(points, triangles), around};
}

Real error_of(const PressedRing& ring, const Vec<2>& X, const Vec<2>& u) {
    return (u - ring.displacement(X.norm()) * X.normalized()).norm() / std::abs(ring.displacement(ring.inner));
}

}  // namespace

Effort boundary_effort(const RingProblem& problem, int elements) {
    BodyPlan plan{.setting = Setting::ring,
                  .order = problem.order,
                  .elements = elements,
                  .hole = {1, 1},
                  .half_sizes = {1, 1},
                  .inner = problem.ring.inner,
                  .outer = problem.ring.outer,
                  .material = problem.ring.material,
                  .inside = false};
    const BoundaryCurve curve = boundary_curve(plan);
    PlaneBoundaryElements bem(curve, plan.material);
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    for (Index k = elements; k < 2 * elements; ++k)
        for (int a = 0; a < nodes_of(problem.order); ++a) {
            const BoundaryElement& e = curve.elements()[static_cast<std::size_t>(k)];
            conditions.value.segment<2>(2 * bem.system().slot_of(k, a)) =
                -problem.ring.pressure * e.normal(e.at[static_cast<std::size_t>(a)]);
        }
    const auto s = bem.system().solve(conditions);
    const auto n = static_cast<Real>(bem.system().unknowns());
    Effort effort{n, n * n, DenseLu::operations(bem.system().unknowns()), 0};
    for (Index k = 0; k < curve.node_count(); ++k)
        effort.error = std::max(effort.error, error_of(problem.ring, curve.nodes().col(k), s.displacement.col(k)));
    return effort;
}

Effort finite_effort(const PressedRing& ring, int across) {
    const auto [mesh, around] = ring_mesh(ring, across);
    const LinearFem<2> body(mesh, ring.material);
    DisplacementConstraints<2> held(mesh.node_count());
    // The axes of symmetry do not turn or move.
    for (int j = 0; j <= across; ++j)
        for (int quarter = 0; quarter < 4; ++quarter)
            held.prescribe(j * around + quarter * around / 4, quarter % 2 == 0 ? 1 : 0, 0);
    Points<2> force = Points<2>::Zero(2, mesh.node_count());
    for (Index f = 0; f < mesh.facet_count(); ++f)
        if (mesh.facets().col(f).maxCoeff() < around)
            for (int a = 0; a < 2; ++a) force.col(mesh.facets()(a, f)) -= ring.pressure * mesh.facet_areas().col(f) / 2;
    const StaticProblem<2> problem(body, held);
    SparseCholesky factor;
    factor.analyze(problem.system().matrix());
    factor.factorize(problem.system().matrix());
    VecX b, x;
    problem.right_side(force, b);
    factor.solve(b, x);
    Points<2> u;
    problem.displacement(x, u);
    Effort effort{static_cast<Real>(problem.system().matrix().rows()), static_cast<Real>(problem.system().matrix().nonZeros()),
                  factor.operations(), 0};
    for (Index n = 0; n < mesh.node_count(); ++n)
        if (n < around || n >= across * around)
            effort.error = std::max(effort.error, error_of(ring, mesh.points().col(n), u.col(n)));
    return effort;
}

Comparison compare_efforts(const RingProblem& problem, const Effort& own) {
    Comparison c{.boundary = {}, .finite = {}, .own = own, .equal = {}};
    for (const int elements : {8, 16, 32}) c.boundary.push_back(boundary_effort(problem, elements));
    for (const int across : {2, 4, 8}) c.finite.push_back(finite_effort(problem.ring, across));
    // By the powers that the two finest make; every one of them is a line on logarithmic axes.
    const Effort &coarse = c.finite[1], &fine = c.finite[2];
    const Real step = std::log(fine.unknowns / coarse.unknowns);
    c.order = std::log(coarse.error / fine.error) / step;
    const Real larger = std::pow(fine.error / own.error, 1 / c.order);
    const auto grown = [&](Real from, Real to) { return to * std::pow(larger, std::log(to / from) / step); };
    c.equal = {fine.unknowns * larger, grown(coarse.entries, fine.entries), grown(coarse.operations, fine.operations), own.error};
    c.beyond = larger > 1;
    return c;
}

}  // namespace pliant::bem
