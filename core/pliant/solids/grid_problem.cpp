#include <pliant/math/lanczos.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/mesh/disc_mesh.h>
#include <pliant/solids/elastic_solutions.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/grid_problem.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/newton_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

// Of a load that is no polynomial.
constexpr int load_degree = 6;
constexpr int elements_of_second_order = 16;

ElasticGrid<2> grid_of(const GridBody& body) {
    const int n = body.resolution;
    const bool disc = body.shape == GridShape::disc;
    const Real L = body.length;
    return {{disc ? 2 * n : n, disc                           ? 2 * n
                               : body.shape == GridShape::rod ? 1
                                                              : n},
            body.spacing(),
            disc ? Vec<2>(-L, -L) : Vec<2>::Zero(),
            [disc, L](const Vec<2>& X) { return !disc || X.norm() < L; },
            body.energy,
            body.material()};
}

template <class Body>
Points<2> in_equilibrium(const Body& body, const DisplacementConstraints<2>& supports, const Points<2>& force) {
    NewtonEquilibrium<2> newton(body, supports, {.tolerance = 1e-10});
    newton.begin(Points<2>::Zero(2, body.node_count()), force, supports);
    newton.solve();
    newton.require_convergence();
    return newton.displacement();
}

Real largest_error(const GridBody& body, const Points<2>& positions, const Points<2>& displacement) {
    Real worst = 0;
    for (Index k = 0; k < positions.cols(); ++k)
        worst = std::max(worst, (displacement.col(k) - body.exact(positions.col(k))).cwiseAbs().maxCoeff());
    return worst;
}

}  // namespace

Lame GridBody::material() const {
    if (shape == GridShape::rod) return {.lambda = youngs_modulus, .mu = 0};
    return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio).lame();
}

Vec<2> GridBody::force_density(const Vec<2>& X) const {
    switch (shape) {
        case GridShape::rod:
            break;
        case GridShape::manufactured:
            return SinesInSquare{length, amplitude}.force_density(X, density());
        case GridShape::block:
            return {0, -body_force};
        case GridShape::disc:
            return SpinningDisc{length, body_force, material()}.force_density(X);
    }
    return Vec<2>::Zero();
}

bool GridBody::has_exact() const {
    return shape == GridShape::manufactured || (shape == GridShape::disc && energy == Energy::linear);
}

Vec<2> GridBody::exact(const Vec<2>& X) const {
    return shape == GridShape::manufactured ? SinesInSquare{length, amplitude}.displacement(X)
                                            : SpinningDisc{length, body_force, material()}.displacement(X);
}

// ------------------------------------------------------------------------------------------------------------- differences

GridProblem::GridProblem(const GridBody& body) : body_(body), grid_(grid_of(body)), supports_(grid_.node_count()) {
    const int n = body.resolution;
    force_density_.resize(2, grid_.node_count());
    for (Index k = 0; k < grid_.node_count(); ++k) {
        force_density_.col(k) = body.force_density(grid_.positions().col(k));
        const auto [i, j] = grid_.place_of(k);
        const bool everything = (body.shape == GridShape::rod && i == 0) || (body.shape == GridShape::block && j == 0) ||
                                (body.shape == GridShape::manufactured && (i == 0 || j == 0 || i == n || j == n));
        // A disc keeps to its axes, by symmetry.
        const bool centred = body.shape == GridShape::disc;
        if (everything || (centred && i == n)) supports_.prescribe(k, 0, 0);
        if (everything || (centred && j == n) || body.shape == GridShape::rod) supports_.prescribe(k, 1, 0);
    }
}

Points<2> GridProblem::nodal_force() const { return force_density_ * grid_.volumes().asDiagonal(); }

bool GridProblem::has_stencil(Index node) const {
    if (body_.shape != GridShape::rod) return grid_.inside(node);
    const int i = grid_.place_of(node)[0];
    return i > 0 && i < body_.resolution;
}

Real GridProblem::error(const Points<2>& displacement) const { return largest_error(body_, grid_.positions(), displacement); }

Points<2> GridProblem::equilibrium() const { return in_equilibrium(grid_, supports_, nodal_force()); }

// The square root of the largest eigenvalue of M^-1/2 K M^-1/2, of the unknowns that are free.
Real GridProblem::highest_frequency(Real density) const {
    constexpr Index products = 120;
    const GridBody small{body_.shape, Energy::linear,  body_.youngs_modulus, body_.poisson_ratio, body_.length,
                         0,           body_.resolution};
    const GridProblem linear(small);
    const VecX root = (density * grid_.volumes()).cwiseSqrt().cwiseInverse();
    Points<2> u, f;
    const auto apply = [&](const VecX& x, VecX& y) {
        u = Eigen::Map<const Points<2>>(x.data(), 2, grid_.node_count()) * root.asDiagonal();
        for (Index d = 0; d < u.size(); ++d)
            if (supports_.flags()[static_cast<std::size_t>(d)]) u.data()[d] = 0;
        linear.grid().internal_force(u, f);
        f = f * root.asDiagonal();
        for (Index d = 0; d < f.size(); ++d)
            if (supports_.flags()[static_cast<std::size_t>(d)]) f.data()[d] = 0;
        y = flat(f);
    };
    return std::sqrt(std::max(largest_eigenvalue(2 * grid_.node_count(), apply, products), Real{0}));
}

// ---------------------------------------------------------------------------------------------------- finite elements beside

FemBeside finite_elements_beside(const GridBody& body) {
    FemBeside beside;
    const auto finish = [&](const auto& fem, const Points<2>& positions, const DisplacementConstraints<2>& supports,
                            const Points<2>& force) {
        beside.positions = positions;
        beside.nodes = positions.cols();
        beside.displacement = in_equilibrium(fem, supports, force);
        if (body.has_exact()) beside.error = largest_error(body, positions, beside.displacement);
        return beside;
    };
    const auto load = [&body](const Vec<2>& X) { return body.force_density(X); };
    const Real L = body.length;
    if (body.shape == GridShape::disc) {
        const SimplexMesh<2> mesh = disc_mesh(L, body.resolution);
        const HyperelasticFem<2> fem(mesh, body.energy, body.material());
        DisplacementConstraints<2> supports(mesh.node_count());
        supports.prescribe({0}, Vec<2>::Zero());
        supports.prescribe(Index{1}, 1, 0);  // on the axis of x: no turn
        Points<2> force = Points<2>::Zero(2, mesh.node_count());
        add_body_force<2>(mesh, load, 1, force);
        return finish(fem, mesh.points(), supports, force);
    }
    const bool second_order = body.shape == GridShape::block;
    const int n = second_order ? elements_of_second_order : body.resolution;
    const SimplexMesh<2> mesh = block_mesh<2>(
        {.size = Vec<2>(L, L), .cells = {n, n}, .split = second_order ? CellSplit::alternating : CellSplit::diagonal});
    if (second_order) {
        const HyperelasticFem<2, 2> fem(mesh, body.energy, body.material());
        const Points<2>& at = fem.elements().positions();
        DisplacementConstraints<2> supports(fem.node_count());
        for (Index k = 0; k < at.cols(); ++k)
            if (at(1, k) == 0) supports.prescribe({k}, Vec<2>::Zero());
        // Of a uniform load the middles of the edges take all.
        Points<2> force = Points<2>::Zero(2, fem.node_count());
        for (Index e = 0; e < mesh.simplex_count(); ++e)
            for (int a = 3; a < 6; ++a) force.col(fem.elements().elements()(a, e)) += load(at.col(0)) * mesh.volumes()[e] / 3;
        return finish(fem, at, supports, force);
    }
    const HyperelasticFem<2> fem(mesh, body.energy, body.material());
    DisplacementConstraints<2> supports(mesh.node_count());
    for (const char* side : {"x_min", "x_max", "y_min", "y_max"}) supports.prescribe(mesh.nodes(side), Vec<2>::Zero());
    Points<2> force = Points<2>::Zero(2, mesh.node_count());
    add_body_force<2>(mesh, load, load_degree, force);
    return finish(fem, mesh.points(), supports, force);
}

// -------------------------------------------------------------------------------------------------------- the difference formula

namespace {

Index node_beside(const ElasticGrid<2>& grid, Index node, int right, int up) {
    const auto [i, j] = grid.place_of(node);
    return grid.node_at({i + right, j + up});
}

}  // namespace

Vec<2> second_difference(const ElasticGrid<2>& grid, const Points<2>& u, Index node, int axis) {
    const int right = axis == 0 ? 1 : 0, up = 1 - right;
    const Real dx = grid.spacing();
    return (u.col(node_beside(grid, node, right, up)) - 2 * u.col(node) + u.col(node_beside(grid, node, -right, -up))) /
           (dx * dx);
}

Vec<2> cross_difference(const ElasticGrid<2>& grid, const Points<2>& u, Index node) {
    const auto at = [&](int right, int up) { return u.col(node_beside(grid, node, right, up)); };
    const Real dx = grid.spacing();
    return (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * dx * dx);
}

}  // namespace pliant
