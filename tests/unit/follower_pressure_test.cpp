// A pressure that follows the surface: closed surfaces, turned bodies, and a tube against its closed form.
#include <pliant/mesh/element_mass.h>
#include <pliant/solids/elastic_system.h>
#include <pliant/solids/follower_pressure.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/time/time_integrator.h>
#include "fem_body.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;

namespace {

template <int Dim>
SimplexMesh<Dim> pressed_cube() {
    BlockShape<Dim> shape;
    shape.cells.fill(2);
    shape.split = CellSplit::diagonal;
    return irregular_block<Dim>(shape);
}

template <int Dim>
FacetSet all_facets(const SimplexMesh<Dim>& mesh) {
    FacetSet every;
    for (Index f = 0; f < mesh.facet_count(); ++f) every.push_back(f);
    return every;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a pressure all round pushes with minus p times the derivative of the volume", "[follower_pressure]",
                       ((int Dim, int Order), Dim, Order), (2, 1), (2, 2), (3, 1), (3, 2)) {
    const SimplexMesh<Dim> mesh = pressed_cube<Dim>();
    const SimplexElements<Dim, Order> elements(mesh);
    const FollowerPressure<Dim> pressure(elements, all_facets(mesh), 3);
    // At rest it is the dead load.
    Points<Dim> x = elements.positions(), force = Points<Dim>::Zero(Dim, x.cols()), dead = force;
    pressure.add_forces(x, force);
    add_pressure<Dim, Order>(elements, all_facets(mesh), 3, dead);
    CHECK((force - dead).norm() < 1e-13);

    // V = 1/Dim the integral of x . n dA, so that p V = -1/Dim the sum of x . f, also of curved facets.
    for (Index k = 0; k < x.size(); ++k) x.data()[k] += 0.05 * std::sin(3.0 * Real(k));
    const auto work = [&](const Points<Dim>& at) {
        Points<Dim> f = Points<Dim>::Zero(Dim, at.cols());
        pressure.add_forces(at, f);
        return -f.cwiseProduct(at).sum() / Dim;
    };
    const Points<Dim> d =
        Points<Dim>::NullaryExpr(Dim, x.cols(), [](Index i, Index j) { return std::cos(5.0 * Real(i + 3 * j)); });
    const Real h = 1e-5;
    force.setZero();
    pressure.add_forces(x, force);
    CHECK(std::abs((work(x + h * d) - work(x - h * d)) / (2 * h) + force.cwiseProduct(d).sum()) < 1e-8);
    CHECK(force.rowwise().sum().norm() < 1e-13);
    // It turns with the body.
    Mat<Dim> R = Mat<Dim>::Identity();
    R.template topLeftCorner<2, 2>() << 0.6, -0.8, 0.8, 0.6;
    Points<Dim> turned = Points<Dim>::Zero(Dim, x.cols());
    pressure.add_forces(R * x, turned);
    CHECK((turned - R * force).norm() < 1e-13);
}

TEMPLATE_TEST_CASE_SIG("a cube under pressure all round shrinks as the energy of a uniform stretch says", "[follower_pressure]",
                       ((int Order), Order), 1, 2) {
    const SimplexMesh<3> mesh = pressed_cube<3>();
    const Lame material = IsotropicModuli::from_young_poisson(1e5, 0.3).lame();
    const HyperelasticFem<3, Order> body(mesh, Energy::neo_hookean, material);
    const auto& X = body.elements().positions();
    DisplacementConstraints<3> held(X.cols());
    for (Index n = 0; n < X.cols(); ++n)
        for (int k = 0; k < 3; ++k)
            if (X(k, n) < 1e-9) held.prescribe({n}, k, 0);
    const FollowerPressure<3> pressure(body.elements(), all_facets(mesh), 3e4);
    NewtonEquilibrium<3> newton(body, held, {});
    const Points<3> zero = Points<3>::Zero(3, X.cols());
    solve_under_pressure<3>(newton, pressure, X, zero, zero, held);
    // Cauchy's stress (mu (s^2 - 1) + 3 lambda ln s)/s^3 = -p: a dead load would have left out the smaller area.
    Real low = 0.5, high = 1;
    for (int k = 0; k < 60; ++k) {
        const Real s = (low + high) / 2, stress = (material.mu * (s * s - 1) + 3 * material.lambda * std::log(s)) / (s * s * s);
        (stress < -3e4 ? low : high) = s;
    }
    CHECK(low < 0.95);
    CHECK((newton.displacement() - (low - 1) * X).cwiseAbs().maxCoeff() < 1e-7);

    // In motion, damped, it ends there too.
    const DiagonalMass mass = DiagonalMass::with_held(lumped_mass(body.elements(), 1000), 3, held.flags());
    ElasticSystem<3> system(body, X, mass);
    system.pressure = pressure;
    system.mass_damping = 20;
    Points<3> x = X, v = zero;
    TimeIntegrator integrator(system, mass, Scheme::implicit_euler);
    for (int k = 0; k < 60; ++k) integrator.step(0.05, flat(x), flat(v));
    CHECK((x - low * X).cwiseAbs().maxCoeff() < 1e-4);
}
