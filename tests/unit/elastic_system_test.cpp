// An elastic body in motion: its forces are derivatives of its energies, momentum and energy behave, and every scheme moves it.
#include <pliant/solids/contact.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/time/time_integrator.h>
#include "moving_body.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <memory>

using namespace pliant;
using namespace pliant::test;

namespace {

template <class Body>
void load_everything(Body& b) {
    b.system.mass_damping = 0.7;
    b.system.stiffness_damping = 0.003;
    b.system.load.gravity[1] = -9.81;
    b.system.load.pull.node = 2;
    b.system.load.pull.target.setConstant(0.5);
    b.system.load.pull.stiffness = 3000;
    b.system.terms.force.setConstant(b.x.rows(), b.x.cols(), 20);
    b.system.terms.planes.resize(1);
    b.system.terms.planes[0].node = 1;
    b.system.terms.planes[0].normal[1] = 1;
    b.system.terms.planes[0].stiffness = 500;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("forces and the matrix of a moving body are derivatives of its energies", "[elastic_system]",
                       ((int Dim, int Order), Dim, Order), (2, 1), (2, 2), (3, 1), (3, 2)) {
    for (const Energy energy : {Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean}) {
        Moving<Dim, Order> b(energy);
        load_everything(b);
        b.shake(0.03);
        b.system.begin_step(flat(b.x));
        const VecX x = flat(b.x), v = flat(b.v), f = b.force();
        const VecX d = VecX::NullaryExpr(x.size(), [](Index k) { return std::sin(7.0 * Real(k) + 2); });
        const Real h = 1e-5, rate = 40;
        VecX still = VecX::Zero(x.size()), forward(x.size()), back(x.size());
        b.system.force(x, still, forward);
        const Real slope = (b.system.potential(x + h * d) - b.system.potential(x - h * d)) / (2 * h);
        CHECK(std::abs(slope + forward.dot(d)) < 1e-6 * std::abs(slope) + 1e-6);
        // The damping force is the derivative of the dissipation.
        const Real drag = (b.system.dissipation(v + h * d) - b.system.dissipation(v - h * d)) / (2 * h);
        CHECK(std::abs(drag + (f - forward).dot(d)) < 1e-7 * std::abs(drag) + 1e-7);
        // K d + rate C d, with the damping's K where begin_step() froze it.
        const VecX Kd = b.system.stiffness(x, rate, SecondOrderSystem::Curvature::exact) * d;
        b.system.force(x + h * d, v + rate * h * d, forward);
        b.system.force(x - h * d, v - rate * h * d, back);
        CHECK((Kd - (back - forward) / (2 * h)).norm() < 1e-6 * Kd.norm());
        // The operator of conjugate gradients is the positive matrix with what is added.
        VecX product(x.size());
        const VecX wanted =
            b.system.stiffness(x, rate, SecondOrderSystem::Curvature::positive) * d + 123 * b.mass.mass().cwiseProduct(d);
        const LinearisedSystem* h_system = b.system.linearise(x, rate, 123, b.mass);
        h_system->multiply(d, product);
        CHECK((product - wanted).norm() < 1e-13 * wanted.norm());
    }
}

TEMPLATE_TEST_CASE_SIG("a free body keeps its momentum under every scheme, and falls as a point does", "[elastic_system]",
                       ((int Dim), Dim), 2, 3) {
    for (const SchemeInfo& info : schemes())
        for (const Energy energy : {Energy::linear, Energy::corotated, Energy::neo_hookean}) {
            INFO(info.name);
            Moving<Dim> b(energy);
            b.shake(0.02);
            b.v *= 0.1;
            const Vec<Dim> before = momentum<Dim>(b.system.node_mass(), b.v);
            const AngularVec<Dim> spin = angular_momentum<Dim>(b.system.node_mass(), b.x, b.v);
            TimeIntegrator integrator(b.system, b.mass, info.scheme);
            for (int k = 0; k < 5; ++k) integrator.step(1e-3, flat(b.x), flat(b.v));
            const Real size = moving_density * b.mesh.volume();
            CHECK((momentum<Dim>(b.system.node_mass(), b.v) - before).norm() < 1e-9 * size);
            if (energy != Energy::linear && info.scheme == Scheme::semi_implicit_euler)
                CHECK((angular_momentum<Dim>(b.system.node_mass(), b.x, b.v) - spin).norm() < 1e-10 * size);

            Moving<Dim> falling(energy);
            falling.system.load.gravity[1] = -9.81;
            TimeIntegrator faller(falling.system, falling.mass, info.scheme);
            for (int k = 0; k < 5; ++k) faller.step(1e-3, flat(falling.x), flat(falling.v));
            CHECK((falling.v.row(1).array() + 9.81 * 5e-3).abs().maxCoeff() < 1e-9);
        }
}

TEST_CASE("conjugate gradients take the same implicit step as the factorisation, without a fixed node too", "[elastic_system]") {
    for (const bool held : {false, true})
        for (const Energy energy : {Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean}) {
            const std::vector<Index> fixed = held ? small_beam<3>().nodes("x_min") : std::vector<Index>{};
            Moving<3> a(energy, fixed), b(energy, fixed);
            NewtonOptions options;
            options.linear_solve = LinearSolve::conjugate_gradients;
            options.linear_tolerance = 1e-10;
            a.system.load.gravity = b.system.load.gravity = Vec<3>(0, -9.81, 0);
            a.system.stiffness_damping = b.system.stiffness_damping = 0.01;
            TimeIntegrator direct(a.system, a.mass, Scheme::implicit_euler);
            TimeIntegrator iterative(b.system, b.mass, Scheme::implicit_euler, options);
            for (int k = 0; k < 5; ++k) {
                direct.step(0.02, flat(a.x), flat(a.v));
                iterative.step(0.02, flat(b.x), flat(b.v));
            }
            CHECK((a.x - b.x).norm() < 1e-8);
            if (held) CHECK(a.x.row(1).mean() < 0.5 - 1e-5);
        }
}

TEST_CASE("an implicit step loses energy, more with damping", "[elastic_system]") {
    std::array<Real, 2> left{};
    for (const bool damped : {false, true}) {
        Moving<3> b(Energy::corotated);
        b.system.mass_damping = damped ? 2 : 0;
        b.system.stiffness_damping = damped ? 0.01 : 0;
        b.shake(0.05);
        b.v *= 0.1;
        TimeIntegrator integrator(b.system, b.mass, Scheme::implicit_euler);
        Real energy = b.total_energy();
        for (int k = 0; k < 10; ++k) {
            integrator.step(0.005, flat(b.x), flat(b.v));
            CHECK(b.total_energy() <= energy * (1 + 1e-12));
            energy = b.total_energy();
        }
        left[damped] = energy;
    }
    CHECK(left[1] < left[0]);
}

TEST_CASE("a body dropped on the ground comes to rest on it with its weight as reaction", "[elastic_system]") {
    Moving<3> b(Energy::corotated);
    b.x.row(1).array() += 0.01;
    b.system.load.gravity[1] = -9.81;
    b.system.stiffness_damping = 0.05;
    TimeIntegrator integrator(b.system, b.mass, Scheme::implicit_euler);
    Ground ground;
    GroundContact<3> contact;
    Real reaction = 0;
    for (int k = 0; k < 500; ++k) {
        contact.begin(0.01, b.x, b.v);
        set_ground_bounds<3>(ground, b.x, integrator.lower_bound());
        integrator.step(0.01, flat(b.x), flat(b.v));
        contact.arrest(integrator, b.mass);
        contact.resolve(ground, b.mass, Scheme::implicit_euler, {}, b.x, b.v);
        reaction = 0;
        for (Index d = 0; d < b.mass.size(); ++d) reaction += integrator.solver().reaction(d);
    }
    CHECK(b.x.row(1).minCoeff() > -1e-12);
    CHECK(b.v.cwiseAbs().maxCoeff() < 1e-4);
    CHECK(std::abs(reaction / (9.81 * moving_density * b.mesh.volume()) - 1) < 1e-3);
}

TEMPLATE_TEST_CASE_SIG("loads on elements of second order do the work of the fields they stand for", "[elastic_system]",
                       ((int Dim, int Order), Dim, Order), (2, 1), (2, 2), (3, 1), (3, 2)) {
    const SimplexMesh<Dim> mesh = small_beam<Dim>();
    const SimplexElements<Dim, Order> elements(mesh);
    const auto& all = mesh.facets("x_max");
    const Vec<Dim> pull = Vec<Dim>::LinSpaced(1, 3);
    Points<Dim> constant = Points<Dim>::Zero(Dim, elements.node_count()), by_rule = constant, body = constant, swollen = constant,
                pressed = constant;
    add_traction<Dim, Order>(elements, all, pull, constant);
    add_traction<Dim, Order>(
        elements, all, [&](const Vec<Dim>&) { return pull; }, 0, by_rule);
    CHECK((constant - by_rule).norm() < 1e-13);
    CHECK((constant.rowwise().sum() - pull).norm() < 1e-13);
    // Work on a field of the elements' order: the integral of X_1^(Order) over the unit face is 1/(Order + 1).
    const auto field = elements.positions().row(1).array().pow(Order).matrix().eval();
    CHECK(std::abs(constant.row(0).dot(field) - pull[0] / (Order + 1)) < 1e-13);
    // A body force that grows along X_1, on the same field: 3 m times 1/(Order + 2).
    add_body_force<Dim, Order>(
        elements, [&](const Vec<Dim>& X) { return Vec<Dim>(X[1] * pull); }, 1, body);
    CHECK(std::abs(body.row(0).dot(field) - 3 * pull[0] / (Order + 2)) < 1e-12);
    // A uniform stress, and the pressure that it is.
    std::vector<Index> every;
    for (Index f = 0; f < mesh.facet_count(); ++f) every.push_back(f);
    add_pressure<Dim, Order>(elements, every, 2, pressed);
    add_boundary_stress<Dim, Order>(elements, every, -2 * Mat<Dim>::Identity(), swollen);
    CHECK((pressed - swollen).norm() < 1e-13);
    CHECK(std::abs(pressed.cwiseProduct(elements.positions()).sum() + 2 * Dim * mesh.volume()) < 1e-12);
}

TEST_CASE("rollers are components that a mass holds", "[elastic_system]") {
    const DiagonalMass mass = DiagonalMass::with_held(VecX::Constant(2, 3), 2, {0, 1, 0, 0});
    CHECK(!mass.fixed(0));
    CHECK(mass.fixed(1));
    CHECK(mass.mass()[1] == 3);
    CHECK_THROWS(DiagonalMass::with_held(VecX::Constant(2, 3), 2, {0, 1, 0}));
}
