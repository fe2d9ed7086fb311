// Warped stiffness: the lecture's force and tangent, rigid rotations, and elements that are flat, inverted or a point.
#include <pliant/continuum/deformation.h>
#include <pliant/math/dense_matrix.h>
#include <pliant/mesh/element_mass.h>
#include <pliant/solids/elastic_system.h>
#include <pliant/solids/linear_fem.h>
#include <pliant/solids/newton_equilibrium.h>
#include <pliant/solids/warped_stiffness.h>
#include <pliant/time/time_integrator.h>
#include "fem_body.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;

namespace {

constexpr Real warped_modulus = 1e4;

Lame warped_material() { return IsotropicModuli::from_young_poisson(warped_modulus, 0.3).lame(); }

template <int Dim>
SimplexMesh<Dim> warped_block(int cells) {
    BlockShape<Dim> shape;
    shape.cells.fill(cells);
    shape.split = CellSplit::diagonal;
    return irregular_block<Dim>(shape);
}

template <int Dim>
Points<Dim> shaken_nodes(const Points<Dim>& X, Real size) {
    Points<Dim> moved = X;
    for (Index k = 0; k < X.size(); ++k) moved.data()[k] = size * std::sin(3.0 * Real(k) + 3);
    return moved;
}

template <int Dim>
Mat<Dim> turn_about_z(Real angle) {
    Mat<Dim> R = Mat<Dim>::Identity();
    R.template topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return R;
}

// The lecture's sums, matrix by matrix: f = R K (R^T x - X), and R K R^T.
template <int Dim>
struct WarpedByHand {
    WarpedByHand(const WarpedStiffness<Dim>& body, const Points<Dim>& u)
        : force(Points<Dim>::Zero(Dim, body.node_count())), matrix(MatX::Zero(u.size(), u.size())) {
        const SimplexMesh<Dim>& mesh = body.mesh();
        for (Index e = 0; e < mesh.simplex_count(); ++e) {
            const Mat<Dim> R = body.rotation(e, u);
            Mat<Dim*(Dim + 1)> turns = Mat<Dim*(Dim + 1)>::Zero();
            Vec<Dim*(Dim + 1)> X, x;
            for (int a = 0; a <= Dim; ++a) {
                turns.template block<Dim, Dim>(Dim * a, Dim * a) = R;
                X.template segment<Dim>(Dim * a) = mesh.points().col(mesh.simplices()(a, e));
                x.template segment<Dim>(Dim * a) = X.template segment<Dim>(Dim * a) + u.col(mesh.simplices()(a, e));
            }
            const auto K = body.rest_stiffness(e);
            const Vec<Dim*(Dim + 1)> strained = turns.transpose() * x - X, f = turns * K * strained;
            const Mat<Dim*(Dim + 1)> warped = turns * K * turns.transpose();
            energy += 0.5 * strained.dot(K * strained);
            for (int a = 0; a <= Dim; ++a) {
                const Index n = mesh.simplices()(a, e);
                force.col(n) += f.template segment<Dim>(Dim * a);
                for (int b = 0; b <= Dim; ++b)
                    matrix.block<Dim, Dim>(Dim * n, Dim * mesh.simplices()(b, e)) +=
                        warped.template block<Dim, Dim>(Dim * a, Dim * b);
            }
        }
    }
    Points<Dim> force;
    MatX matrix;
    Real energy = 0;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("warped stiffness is the lecture's R K (R^T x - X), and its force that of the corotated energy",
                       "[warped]", ((int Dim), Dim), 2, 3) {
    const SimplexMesh<Dim> mesh = warped_block<Dim>(2);
    const WarpedStiffness<Dim> body(mesh, warped_material());
    const Points<Dim> u = turn_about_z<Dim>(1) * mesh.points() - mesh.points() + shaken_nodes<Dim>(mesh.points(), 0.1);
    const WarpedByHand<Dim> lecture(body, u);
    Points<Dim> force, corotated;
    body.internal_force(u, force);
    CHECK((force - lecture.force).norm() < 1e-12 * force.norm());
    CHECK(std::abs(body.energy(u) - lecture.energy) < 1e-12 * lecture.energy);
    HyperelasticFem<Dim>(mesh, Energy::corotated, warped_material()).internal_force(u, corotated);
    CHECK((force - corotated).norm() < 1e-12 * force.norm());

    SparseMatrix K = body.pattern(), exact = body.pattern();
    body.stiffness(u, false, K);
    CHECK((MatX(K) - lecture.matrix).norm() < 1e-12 * lecture.matrix.norm());
    CHECK(dense_eigen(MatX(K)).values[0] > -1e-12 * K.norm());
    // The exact tangent differs by the derivative of R, except at rest, where nothing is stressed.
    body.hyperelastic().stiffness(u, false, exact);
    CHECK((exact - K).norm() > 1e-2 * K.norm());
    const Points<Dim> rest = Points<Dim>::Zero(Dim, mesh.node_count());
    body.stiffness(rest, false, K);
    CHECK((MatX(K) - MatX(LinearFem<Dim>(mesh, warped_material()).stiffness())).norm() < 1e-12 * K.norm());
}

TEMPLATE_TEST_CASE_SIG("a body turned by half a turn is free of force and energy", "[warped]", ((int Dim), Dim), 2, 3) {
    const SimplexMesh<Dim> mesh = warped_block<Dim>(3);
    const WarpedStiffness<Dim> body(mesh, warped_material());
    for (const Real angle : {0.3, 1.0, 3.0, std::numbers::pi}) {
        const Points<Dim> u = turn_about_z<Dim>(angle) * mesh.points() - mesh.points();
        Points<Dim> force;
        body.internal_force(u, force);
        CHECK(body.energy(u) <= 1e-12 * warped_modulus * mesh.volume());
        CHECK(force.cwiseAbs().maxCoeff() < 1e-11 * warped_modulus);
    }
}

TEMPLATE_TEST_CASE_SIG("patch test of warped stiffness, for small and large gradients", "[warped]", ((int Dim), Dim), 2, 3) {
    for (const Real size : {1.0, 20.0}) {
        const SimplexMesh<Dim> mesh = warped_block<Dim>(3);
        const WarpedStiffness<Dim> body(mesh, warped_material());
        const Mat<Dim> A = size * some_gradient<Dim>();
        const auto held = affine_boundary<Dim>(mesh, A, Vec<Dim>::Constant(0.1));
        NewtonEquilibrium<Dim> newton(body, held, {.tolerance = 1e-12});
        const Points<Dim> zero = Points<Dim>::Zero(Dim, mesh.node_count());
        newton.begin(zero, zero, held);
        newton.solve();
        CHECK(newton.residual() < 1e-11);
        const Points<Dim> wanted = (A * mesh.points()).colwise() + Vec<Dim>::Constant(0.1);
        CHECK((newton.displacement() - wanted).cwiseAbs().maxCoeff() < 1e-10);
    }
}

TEMPLATE_TEST_CASE_SIG("flat, inverted and point elements have a proper rotation, and bodies of them open again", "[warped]",
                       ((int Dim), Dim), 2, 3) {
    const SimplexMesh<Dim> mesh = warped_block<Dim>(2);
    const WarpedStiffness<Dim> body(mesh, warped_material());
    const VecX node_mass = lumped_mass<Dim, 1>(SimplexElements<Dim, 1>(mesh), 1000);
    const DiagonalMass mass(node_mass, Dim);
    Mat<Dim> flat_map = Mat<Dim>::Identity(), mirror = flat_map;
    flat_map(Dim - 1, Dim - 1) = 0;
    mirror(0, 0) = -1;
    for (const Mat<Dim>& F : {Mat<Dim>(Mat<Dim>::Zero()), flat_map, mirror}) {
        Points<Dim> x = F * mesh.points(), v = Points<Dim>::Zero(Dim, x.cols()), force;
        const Points<Dim> u = x - mesh.points();
        body.internal_force(u, force);
        CHECK(force.allFinite());
        for (Index e = 0; e < mesh.simplex_count(); ++e) {
            CHECK(std::abs(body.rotation(e, u).determinant() - 1) < 1e-12);
            CHECK((body.rotation(e, u).transpose() * body.rotation(e, u) - Mat<Dim>::Identity()).norm() < 1e-12);
        }
        // Pushed by a hair, so that they are not in the balance of their symmetry.
        x += shaken_nodes<Dim>(mesh.points(), 1e-3);
        ElasticSystem<Dim> system(body, mesh.points(), mass);
        system.mass_damping = 5;
        const Real before = system.potential(flat(x));
        TimeIntegrator integrator(system, mass, Scheme::implicit_euler,
                                  {.relative_step = 1e-6, .max_iterations = 20, .at_cap = AtCap::accept});
        for (int k = 0; k < 400; ++k) integrator.step(0.02, flat(x), flat(v));
        CHECK(x.allFinite());
        CHECK(system.potential(flat(x)) < before);
        // From a point and from a sheet they come back whole; inside out they may stay.
        if (F(0, 0) >= 0) CHECK(system.potential(flat(x)) < 1e-6 * before);
    }
}

TEST_CASE("plane stress: no stress holds the stretch across the plane of the energies that take it", "[warped]") {
    const IsotropicModuli material = IsotropicModuli::from_young_poisson(warped_modulus, 0.3);
    Mat<2> F;
    F << 1.1, 0.2, -0.1, 0.95;
    Mat<3> F3 = Mat<3>::Identity();
    F3.topLeftCorner<2, 2>() = F;
    for (const Energy energy : {Energy::linear, Energy::corotated, Energy::stvk, Energy::neo_hookean}) {
        const EnergyDensity<3> solid(energy, material.lame());
        for (int k = 0; k < 100; ++k) F3(2, 2) -= solid.P(F3)(2, 2) / solid.tangent(F3)(8, 8);
        CHECK(std::abs(solid.P(F3)(2, 2)) < 1e-9 * warped_modulus);
        const Mat<2> plane = EnergyDensity<2>(energy, material.plane_stress_lame()).P(F),
                     wanted = solid.P(F3).topLeftCorner<2, 2>();
        const Real difference = (plane - wanted).norm() / wanted.norm();
        if (energy == Energy::neo_hookean)
            CHECK(difference > 1e-3);
        else
            CHECK(difference < 1e-12);
    }
}

TEST_CASE("a warped body keeps its spin, by conjugate gradients too", "[warped]") {
    const SimplexMesh<3> mesh = warped_block<3>(2);
    const WarpedStiffness<3> body(mesh, warped_material());
    const DiagonalMass mass(lumped_mass<3, 1>(SimplexElements<3, 1>(mesh), 1000), 3);
    ElasticSystem<3> system(body, mesh.points(), mass);
    const Vec<3> spin(0, 0, 2);
    for (const auto solve : {LinearSolve::direct, LinearSolve::conjugate_gradients}) {
        Points<3> x = mesh.points(), v(3, x.cols());
        const VecX& m = system.node_mass();
        const Vec<3> centre = x * m / m.sum();
        for (Index n = 0; n < x.cols(); ++n) v.col(n) = spin.cross(x.col(n) - centre);
        const auto moment = [&] {
            Vec<3> sum = Vec<3>::Zero();
            for (Index n = 0; n < x.cols(); ++n) sum += m[n] * (x.col(n) - centre).cross(v.col(n));
            return sum;
        };
        const Vec<3> before = moment();
        TimeIntegrator integrator(system, mass, Scheme::implicit_midpoint, {.linear_solve = solve, .linear_tolerance = 1e-3});
        for (int k = 0; k < 50; ++k) integrator.step(0.02, flat(x), flat(v));
        CHECK((moment() - before).norm() < 1e-6 * before.norm());
        CHECK((x * m / m.sum() - centre).norm() < 1e-9);
    }
}
