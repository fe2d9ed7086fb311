// Elements of first and second order: shape functions, masses, patch tests, and orders of convergence.
#include <pliant/continuum/moduli.h>
#include <pliant/math/conjugate_gradients.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/newton_equilibrium.h>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <random>

using namespace pliant;

namespace {

// A box whose inner nodes are moved about.
template <int Dim>
SimplexMesh<Dim> shaken_block(int cells) {
    BlockShape<Dim> shape;
    shape.cells.fill(cells);
    shape.split = CellSplit::diagonal;
    const SimplexMesh<Dim> regular = block_mesh(shape);
    Points<Dim> points = regular.points();
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<Real> spread(-0.12, 0.12);
    for (Index n = 0; n < points.cols(); ++n)
        if ((points.col(n).array() > 1e-9).all() && (points.col(n).array() < 1 - 1e-9).all())
            points.col(n) += Vec<Dim>::NullaryExpr([&] { return spread(engine) / cells; });
    return regular.with_points(points);
}

template <int Dim>
std::vector<Index> boundary_nodes(const auto& elements) {
    std::vector<char> on(static_cast<std::size_t>(elements.node_count()), 0);
    for (Index k = 0; k < elements.facets().size(); ++k) on[static_cast<std::size_t>(elements.facets().data()[k])] = 1;
    std::vector<Index> list;
    for (std::size_t n = 0; n < on.size(); ++n)
        if (on[n]) list.push_back(static_cast<Index>(n));
    return list;
}

// A displacement that is linear in space, and large.
template <int Dim>
Points<Dim> linear_field(const Points<Dim>& X) {
    Mat<Dim> A = 0.2 * Mat<Dim>::Identity();
    A(0, 1) = 0.3, A(1, 0) = -0.1;
    return ((A * X).colwise() + Vec<Dim>::Constant(0.4)).eval();
}

template <int Dim, int Order>
void patch_test(Energy energy) {
    const SimplexMesh<Dim> mesh = shaken_block<Dim>(3);
    const HyperelasticFem<Dim, Order> body(mesh, energy, IsotropicModuli::from_young_poisson(1e4, 0.3).lame());
    const Points<Dim> wanted = linear_field<Dim>(body.elements().positions());
    DisplacementConstraints<Dim> held(body.node_count());
    for (const Index n : boundary_nodes<Dim>(body.elements())) held.prescribe({n}, Vec<Dim>(wanted.col(n)));
    NewtonEquilibrium<Dim> newton(body, held, {.tolerance = 1e-12});
    newton.begin(Points<Dim>::Zero(Dim, body.node_count()), Points<Dim>::Zero(Dim, body.node_count()), held);
    newton.solve();
    INFO("dimension " << Dim << ", order " << Order << ", energy " << static_cast<int>(energy));
    CHECK(newton.converged());
    CHECK((newton.displacement() - wanted).cwiseAbs().maxCoeff() < 1e-10);
    Tensors<Dim> P;
    body.stress(newton.displacement(), P);
    CHECK((P.colwise() - P.col(0)).cwiseAbs().maxCoeff() < 1e-9 * P.cwiseAbs().maxCoeff());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("shape functions are 1 at their node and 0 at others, sum to 1, and so do masses", "[elements]",
                       ((int Dim, int Order), Dim, Order), (2, 1), (2, 2), (3, 1), (3, 2)) {
    using Elements = SimplexElements<Dim, Order>;
    for (int a = 0; a < Elements::nodes; ++a) {
        Vec<Dim + 1> at = Vec<Dim + 1>::Zero();
        if (a <= Dim) {
            at[a] = 1;
        } else {
            const auto [from, to] = simplex_edges[static_cast<std::size_t>(a - Dim - 1)];
            at[from] = at[to] = 0.5;
        }
        const auto N = Elements::shape(at);
        for (int b = 0; b < Elements::nodes; ++b) CHECK(std::abs(N[b] - (a == b)) < 1e-15);
    }
    CHECK(std::abs(Elements::unit_mass().sum() - 1) < 1e-14);
    CHECK((Elements::lumped_shares().array() > 0).all());
    CHECK(std::abs(Elements::lumped_shares().sum() - 1) < 1e-14);

    // Gradients of fields that the order holds exactly, at all points.
    const SimplexMesh<Dim> mesh = shaken_block<Dim>(2);
    const Elements elements(mesh);
    Points<Dim> values(Dim, elements.node_count());
    for (Index n = 0; n < elements.node_count(); ++n) {
        const Vec<Dim> X = elements.positions().col(n);
        values.col(n) = Order == 1 ? Vec<Dim>(2 * X) : Vec<Dim>(X[0] * X);
    }
    for (Index e = 0; e < elements.element_count(); ++e) {
        Mat<Dim> mean = Mat<Dim>::Zero();
        for (int q = 0; q < Elements::points; ++q) mean += elements.field_gradient(e, q, values) / Elements::points;
        Vec<Dim> centre = Vec<Dim>::Zero();
        for (int a = 0; a <= Dim; ++a) centre += mesh.points().col(mesh.simplices()(a, e)) / (Dim + 1);
        // d(x X)/dX = x I + X ⊗ e_x: its mean is its value at the centre.
        Mat<Dim> exact = 2 * Mat<Dim>::Identity();
        if (Order == 2) {
            exact = centre[0] * Mat<Dim>::Identity();
            exact.col(0) += centre;
        }
        CHECK((mean - exact).cwiseAbs().maxCoeff() < 1e-12);
    }
}

TEMPLATE_TEST_CASE_SIG("patch test: a linear field on the boundary is exact inside, of every model and order", "[elements][fem]",
                       ((int Dim, int Order), Dim, Order), (2, 1), (2, 2), (3, 1), (3, 2)) {
    for (const Energy energy : {Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean})
        patch_test<Dim, Order>(energy);
}

TEMPLATE_TEST_CASE_SIG("the stiffness is the derivative of the force, and the force of the energy", "[elements][fem]",
                       ((int Dim, int Order), Dim, Order), (2, 2), (3, 2)) {
    const SimplexMesh<Dim> mesh = shaken_block<Dim>(1);
    const HyperelasticFem<Dim, Order> body(mesh, Energy::neo_hookean, IsotropicModuli::from_young_poisson(1e4, 0.3).lame());
    Points<Dim> u = 0.5 * linear_field<Dim>(body.elements().positions());
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<Real> spread(-0.03, 0.03);
    u += Points<Dim>::NullaryExpr(Dim, u.cols(), [&] { return spread(engine); });
    const Points<Dim> d = Points<Dim>::NullaryExpr(Dim, u.cols(), [&] { return spread(engine); });
    const Real h = 1e-5;
    Points<Dim> force, more, less;
    body.internal_force(u, force), body.internal_force(u + h * d, more), body.internal_force(u - h * d, less);
    const Real slope = (body.energy(u + h * d) - body.energy(u - h * d)) / (2 * h);
    CHECK(std::abs(slope - force.cwiseProduct(d).sum()) < 1e-7 * std::abs(slope));
    SparseMatrix K = body.pattern();
    body.stiffness(u, false, K);
    const VecX product = K * Eigen::Map<const VecX>(d.data(), d.size());
    const Points<Dim> difference = (more - less) / (2 * h);
    CHECK((product - Eigen::Map<const VecX>(difference.data(), difference.size())).norm() < 1e-7 * product.norm());
    // Forces inside balance.
    CHECK(force.rowwise().sum().norm() < 1e-12 * force.norm());
}
