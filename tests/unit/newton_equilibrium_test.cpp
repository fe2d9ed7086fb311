// Bodies of any energy: forces against differences of the energy, the patch test, closed forms at finite strain, bad input.
#include "fem_body.h"

#include <pliant/math/error.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/newton_equilibrium.h>

#include <Eigen/Geometry>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Real Y = 1e6, nu = 0.3;

Lame rubber() { return IsotropicModuli::from_young_poisson(Y, nu).lame(); }

template <int Dim>
SimplexMesh<Dim> small_mesh() {
    BlockShape<Dim> block;
    for (int k = 0; k < Dim; ++k) block.cells[static_cast<std::size_t>(k)] = 3;
    return irregular_block<Dim>(block);
}

template <int Dim>
Points<Dim> rough(const SimplexMesh<Dim>& mesh, Real size) {
    Points<Dim> u(Dim, mesh.node_count());
    for (Index i = 0; i < u.size(); ++i) u.data()[i] = size * std::sin(1.7 * static_cast<Real>(i * i + 1));
    return u;
}

template <int Dim>
Points<Dim> none(const SimplexMesh<Dim>& mesh) {
    return Points<Dim>::Zero(Dim, mesh.node_count());
}

Energy any_energy() { return GENERATE(Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean); }

// A bar along x between rollers whose far face is drawn to `stretch` times its length.
struct Pulled {
    SimplexMesh<3> mesh = block_mesh<3>({.size = {2, 1, 1}, .cells = {4, 2, 2}});
    DisplacementConstraints<3> constraints = rollers<3>(mesh);

    explicit Pulled(Real stretch) { constraints.prescribe(mesh.nodes("x_max"), 0, 2 * (stretch - 1)); }
    Real nominal_stress(const Points<3>& reaction) const {
        Real force = 0;
        for (const Index n : mesh.nodes("x_max")) force += reaction(0, n);
        return force;  // over an area of 1 m^2
    }
};

// Displacements at rest under these forces, from none.
template <int Dim>
Points<Dim> equilibrium(const HyperelasticFem<Dim>& body, const DisplacementConstraints<Dim>& constraints,
                        const Points<Dim>& force, Real tolerance) {
    NewtonEquilibrium<Dim> newton(body, constraints, {.tolerance = tolerance});
    newton.begin(none(body.mesh()), force, constraints);
    newton.solve();
    newton.require_convergence();
    return newton.displacement();
}

struct PulledResult {
    Real stress, lateral;
    Index iterations;
};

PulledResult pull(Energy energy, Real stretch, LinearSolver solver = LinearSolver::direct) {
    const Pulled bar(stretch);
    const HyperelasticFem<3> body(bar.mesh, energy, rubber());
    NewtonEquilibrium<3> newton(body, bar.constraints, {.tolerance = 1e-12, .solver = solver});
    newton.begin(none(bar.mesh), none(bar.mesh), bar.constraints);
    newton.solve();
    newton.require_convergence();
    Points<3> reaction;
    newton.reaction(reaction);
    const Index corner = bar.mesh.node_count() - 1;
    return {bar.nominal_stress(reaction), 1 + newton.displacement()(1, corner), newton.iterations()};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Forces are the derivative of the energy, and the stiffness that of the forces", "[newton]",
                       ((int Dim), Dim), 2, 3) {
    const Energy energy = any_energy();
    const SimplexMesh<Dim> mesh = small_mesh<Dim>();
    const HyperelasticFem<Dim> body(mesh, energy, rubber());
    const Points<Dim> u = rough(mesh, 0.02), v = rough<Dim>(mesh, 1).array().cos().matrix();
    const Real h = 1e-5;
    Points<Dim> f, f_ahead, f_behind;
    body.internal_force(u, f);
    body.internal_force(u + h * v, f_ahead);
    body.internal_force(u - h * v, f_behind);
    const Real slope = (body.energy(u + h * v) - body.energy(u - h * v)) / (2 * h);
    CHECK_THAT(f.cwiseProduct(v).sum(), WithinRel(slope, 1e-6));
    SparseMatrix K = body.pattern();
    body.stiffness(u, false, K);
    const VecX change = ((f_ahead - f_behind) / (2 * h)).reshaped();
    CHECK((K * v.reshaped() - change).norm() < 1e-6 * change.norm());
    CHECK(SparseMatrix(SparseMatrix(K.transpose()) - K).norm() == 0);
}

TEMPLATE_TEST_CASE_SIG("Patch test at finite strain: a boundary that follows u = A X + b carries the inside with it", "[newton]",
                       ((int Dim), Dim), 2, 3) {
    const Energy energy = any_energy();
    const SimplexMesh<Dim> mesh = small_mesh<Dim>();
    const HyperelasticFem<Dim> body(mesh, energy, rubber());
    const Mat<Dim> A = 15 * some_gradient<Dim>();
    const Vec<Dim> b = Vec<Dim>::Constant(0.3);
    const auto constraints = affine_boundary<Dim>(mesh, A, b);
    const Points<Dim> u = equilibrium<Dim>(body, constraints, none(mesh), 1e-13);
    const Points<Dim> exact = (A * mesh.points()).colwise() + b;
    CHECK((u - exact).cwiseAbs().maxCoeff() < 1e-10);
    Tensors<Dim> P;
    body.stress(u, P);
    const Mat<Dim> uniform = EnergyDensity<Dim>(energy, rubber()).P(Mat<Dim>::Identity() + A);
    for (Index e = 0; e < mesh.simplex_count(); ++e) CHECK((tensor<Dim>(P, e) - uniform).norm() < 1e-9 * uniform.norm());
}

TEST_CASE("A pulled bar follows the closed forms of its energy", "[newton]") {
    struct Case {
        Energy energy;
        Real stretch, stress, lateral;
    };
    const auto c = GENERATE(values<Case>({{Energy::stvk, 1.3, 448500, 0.890505474},
                                          {Energy::stvk, 0.7, Y * 0.7 * (0.49 - 1) / 2, std::sqrt(1 - 0.3 * (0.49 - 1))},
                                          {Energy::neo_hookean, 0.5, -935352.06, 1.2107674},
                                          {Energy::neo_hookean, 0.7, -405230.42, 0},
                                          {Energy::neo_hookean, 1.5, 378280.18, 0},
                                          {Energy::neo_hookean, 2, 646744.66, 0},
                                          {Energy::linear, 1.2, 0.2 * Y, 1 - 0.3 * 0.2},
                                          {Energy::corotated, 1.2, 0.2 * Y, 1 - 0.3 * 0.2}}));
    const PulledResult found = pull(c.energy, c.stretch);
    CHECK_THAT(found.stress, WithinRel(c.stress, 2e-8));
    if (c.lateral > 0) CHECK_THAT(found.lateral, WithinRel(c.lateral, 5e-8));
    CHECK(found.iterations <= 10);
}

TEST_CASE("Conjugate gradients and factorisation end at the same equilibrium", "[newton]") {
    const PulledResult direct = pull(Energy::neo_hookean, 1.5),
                       iterated = pull(Energy::neo_hookean, 1.5, LinearSolver::conjugate_gradients);
    CHECK_THAT(iterated.stress, WithinRel(direct.stress, 1e-9));
    CHECK_THAT(iterated.lateral, WithinRel(direct.lateral, 1e-9));
}

TEST_CASE("A neo-Hookean bar can be pressed hard in one go", "[newton]") {
    const PulledResult pressed = pull(Energy::neo_hookean, 0.1);
    CHECK(pressed.stress < -5 * Y);
    CHECK(pressed.lateral > 1.2);
}

TEST_CASE("A load that turns a bar far is carried in full by its support", "[newton]") {
    const Energy energy = GENERATE(Energy::corotated, Energy::neo_hookean);
    const SimplexMesh<2> mesh = block_mesh<2>({.size = {4, 0.4}, .cells = {20, 2}});
    const HyperelasticFem<2> body(mesh, energy, rubber());
    DisplacementConstraints<2> clamp(mesh.node_count());
    clamp.prescribe(mesh.nodes("x_min"), Vec<2>::Zero());
    Points<2> force = none(mesh);
    add_traction<2>(mesh, mesh.facets("x_max"), Vec<2>(0, -8000), force);
    NewtonEquilibrium<2> newton(body, clamp, {.tolerance = 1e-10, .max_iterations = 100});
    newton.begin(none(mesh), force, clamp);
    Real before = newton.potential_energy();
    while (newton.running()) {
        newton.iterate();
        CHECK(newton.potential_energy() <= before + 1e-9 * std::abs(before));
        before = newton.potential_energy();
    }
    REQUIRE(newton.converged());
    Points<2> reaction;
    newton.reaction(reaction);
    CHECK((reaction.rowwise().sum() + force.rowwise().sum()).norm() < 1e-7 * force.rowwise().sum().norm());
    CHECK(newton.displacement()(1, mesh.node_count() - 1) < -1.5);
}

TEST_CASE("Rigidly turned bodies are free of force, save those of the linear energy", "[newton]") {
    const Energy energy = any_energy();
    const SimplexMesh<3> mesh = small_mesh<3>();
    const HyperelasticFem<3> body(mesh, energy, rubber());
    const Mat<3> R = Eigen::AngleAxis<Real>(1.2, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();
    Points<3> force;
    body.internal_force((R - Mat<3>::Identity()) * mesh.points(), force);
    if (energy == Energy::linear)
        CHECK(force.norm() > 0.1 * Y);
    else
        CHECK(force.norm() < 1e-9 * Y);
}

TEST_CASE("Two bars in series, one of them a hundred million times stiffer", "[newton]") {
    const SimplexMesh<3> mesh = block_mesh<3>({.size = {2, 1, 1}, .cells = {4, 2, 2}});
    std::vector<Lame> materials;
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        Real x = 0;
        for (int a = 0; a < 4; ++a) x += mesh.points()(0, mesh.simplices()(a, e)) / 4;
        materials.push_back(IsotropicModuli::from_young_poisson(x < 1 ? 1e4 : 1e12, 0).lame());
    }
    const HyperelasticFem<3> body(mesh, Energy::linear, materials);
    Points<3> force = none(mesh);
    add_traction<3>(mesh, mesh.facets("x_max"), Vec<3>(100, 0, 0), force);
    // The stiff bar's forces round at about 1e-7 of the load.
    const Points<3> u = equilibrium<3>(body, rollers<3>(mesh), force, 1e-6);
    CHECK_THAT(u(0, mesh.nodes("x_max").front()), WithinRel(100 / 1e4 + 100 / 1e12, 1e-6));
}

TEST_CASE("What cannot be solved is told, not tried", "[newton]") {
    const SimplexMesh<3> mesh = small_mesh<3>();
    const HyperelasticFem<3> body(mesh, Energy::neo_hookean, rubber());
    DisplacementConstraints<3> held(mesh.node_count());
    CHECK_THROWS_WITH(NewtonEquilibrium<3>(body, held, {}), ContainsSubstring("singular: 6 rigid modes unconstrained"));
    held.prescribe(0, 0, 0);
    CHECK_THROWS_WITH(NewtonEquilibrium<3>(body, held, {}), ContainsSubstring("singular: 5 rigid modes unconstrained"));
    CHECK_THROWS_AS(NewtonEquilibrium<3>(body, rollers<3>(mesh), {.tolerance = 0}), Refused);
    CHECK_THROWS_AS(HyperelasticFem<3>(mesh, Energy::stvk, Lame{.lambda = 1, .mu = -1}), Refused);

    // From a body that is inside out no neo-Hookean step leads anywhere.
    NewtonEquilibrium<3> newton(body, rollers<3>(mesh), {});
    const Points<3> inverted = -2 * mesh.points();
    CHECK_THROWS_WITH(newton.begin(inverted, none(mesh), rollers<3>(mesh)), ContainsSubstring("det F"));

    // Supports that would press the body flat are approached, and the failure says how far it came.
    const Pulled flat(0);
    const HyperelasticFem<3> pressed(flat.mesh, Energy::neo_hookean, rubber());
    CHECK_THROWS_AS(equilibrium<3>(pressed, flat.constraints, none(flat.mesh), 1e-10), Diverged);
}

TEST_CASE("All nodes held: nothing to solve, reactions at once", "[newton]") {
    const SimplexMesh<2> mesh = small_mesh<2>();
    const HyperelasticFem<2> body(mesh, Energy::neo_hookean, rubber());
    DisplacementConstraints<2> held(mesh.node_count());
    for (Index n = 0; n < mesh.node_count(); ++n) {
        held.prescribe(n, 0, 0.1 * mesh.points()(0, n));
        held.prescribe(n, 1, 0);
    }
    const Points<2> u = equilibrium<2>(body, held, none(mesh), 1e-10);
    CHECK((u - held.values()).norm() == 0);
}

TEST_CASE("No step carries a body through its mirror image", "[newton]") {
    const SimplexMesh<3> mesh = small_mesh<3>();
    const Points<3> rest = none(mesh);
    // Both directions across are turned over at once: a proper body at both ends, and none halfway.
    const Points<3> turn = Vec<3>(0, -2, -2).asDiagonal() * mesh.points();
    const HyperelasticFem<3> rubbery(mesh, Energy::neo_hookean, rubber()), linear(mesh, Energy::linear, rubber());
    CHECK(rubbery.admissible_share(rest, turn) < 0.5);
    CHECK(std::isfinite(rubbery.energy(rest + rubbery.admissible_share(rest, turn) * turn)));
    CHECK(rubbery.admissible_share(rest, 0.1 * turn) == 1);
    CHECK(linear.admissible_share(rest, turn) == 1);
    for (const Real stretch : {0.05, 4., 8.}) {
        const Pulled bar(stretch);
        const HyperelasticFem<3> body(bar.mesh, Energy::neo_hookean, IsotropicModuli::from_young_poisson(Y, 0.49).lame());
        const Points<3> u = equilibrium<3>(body, bar.constraints, none(bar.mesh), 1e-9);
        for (Index e = 0; e < bar.mesh.simplex_count(); ++e) CHECK(body.deformation_gradient(e, u)(1, 1) > 0);
    }
}
