// How a step of an elastic body is made fast, without another result: closed forms, warm starts, factors that are kept, threads.
#include <pliant/math/parallel.h>
#include <pliant/math/small_eigen.h>
#include <pliant/time/time_integrator.h>
#include "moving_body.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>

using namespace pliant;
using namespace pliant::test;

TEMPLATE_TEST_CASE_SIG("the closed form of the neo-Hookean stiffness is the tangent, without its negative curvature where asked",
                       "[elastic_step]", ((int Dim, int Order), Dim, Order), (2, 1), (2, 2), (3, 1), (3, 2)) {
    const SimplexMesh<Dim> mesh = small_beam<Dim>();
    const Lame material = IsotropicModuli::from_young_poisson(1e5, 0.4).lame();
    const HyperelasticFem<Dim, Order> body(mesh, Energy::neo_hookean, material);
    const auto& X = body.elements().positions();
    int lifted = 0;
    // Pressed, as it is, pulled, blown up so far that other curvature is negative too.
    for (const Real stretch : {0.5, 0.9, 1.0, 1.3, 2.5}) {
        Points<Dim> u = (stretch - 1) * X;
        for (Index k = 0; k < u.size(); ++k) u.data()[k] += 0.03 * std::sin(3.0 * Real(k));
        for (const bool definite : {false, true})
            for (Index e = 0; e < mesh.simplex_count(); ++e) {
                auto wanted = body.element_stiffness(e, u, definite);
                wanted.setZero();
                for (int q = 0; q < HyperelasticFem<Dim, Order>::Elements::points; ++q) {
                    const auto T = body.density(e).tangent(body.deformation_gradient(e, u, q));
                    const Mat<Dim* Dim> used = definite ? positive_part<Dim * Dim>(T) : T;
                    lifted += definite && (used - T).norm() > 1e-6 * T.norm();
                    const auto slopes = body.elements().gradients(e, q);
                    Eigen::Matrix<Real, Dim * Dim, Eigen::Dynamic> B(Dim * Dim, Dim * slopes.cols());
                    B.setZero();
                    for (Index b = 0; b < slopes.cols(); ++b)
                        for (int l = 0; l < Dim; ++l)
                            for (int k = 0; k < Dim; ++k) B(k + Dim * l, Dim * b + k) = slopes(l, b);
                    wanted += body.elements().weight(e) * B.transpose() * used * B;
                }
                const auto K = body.element_stiffness(e, u, definite);
                CHECK((K - wanted).norm() < 1e-7 * wanted.norm());
                CHECK(K == K.transpose());
            }
    }
    CHECK(lifted > 0);
}

TEST_CASE("a warm start saves iterations of conjugate gradients and lives on what it shows", "[elastic_step]") {
    std::array<int, 2> iterations{};
    for (const bool warm : {false, true}) {
        Moving<3> b(Energy::corotated, small_beam<3>().nodes("x_min"));
        b.system.load.gravity[1] = -9.81;
        TimeIntegrator integrator(b.system, b.mass, Scheme::implicit_euler,
                                  {.max_iterations = 1,
                                   .at_cap = AtCap::accept,
                                   .linear_solve = LinearSolve::conjugate_gradients,
                                   .linear_tolerance = 1e-4,
                                   .warm_start = warm});
        for (int k = 0; k < 20; ++k) {
            integrator.step(0.005, flat(b.x), flat(b.v));
            iterations[warm] += integrator.solver().linear_iterations();
        }
        CHECK((integrator.solver().warm_direction().size() > 0) == warm);
        if (!warm) continue;
        // Going back: with the direction of before, the same bits.
        const Points<3> x = b.x, v = b.v;
        const VecX direction = integrator.solver().warm_direction();
        integrator.step(0.005, flat(b.x), flat(b.v));
        const Points<3> first = b.x;
        b.x = x, b.v = v;
        integrator.solver().warm_direction() = direction;
        integrator.step(0.005, flat(b.x), flat(b.v));
        CHECK(b.x == first);
    }
    CHECK(iterations[1] < iterations[0]);
}

TEST_CASE("a step of a linear body factorises once, and again for another time step", "[elastic_step]") {
    Moving<3> b(Energy::linear, small_beam<3>().nodes("x_min"));
    b.system.load.gravity[1] = -9.81;
    b.system.stiffness_damping = 0.01;
    TimeIntegrator integrator(b.system, b.mass, Scheme::implicit_euler);
    for (int k = 0; k < 5; ++k) integrator.step(0.01, flat(b.x), flat(b.v));
    CHECK(integrator.solver().factorisations() == 1);
    integrator.step(0.02, flat(b.x), flat(b.v));
    CHECK(integrator.solver().factorisations() == 2);
}

TEST_CASE("two threads take the same steps to the bit", "[elastic_step]") {
    std::array<Points<3>, 2> ends;
    for (const int count : {1, 2}) {
        set_threads(count);
        BlockShape<3> shape;
        shape.cells.fill(9);
        shape.split = CellSplit::diagonal;
        const SimplexMesh<3> mesh = block_mesh(shape);
        const HyperelasticFem<3> body(mesh, Energy::neo_hookean, IsotropicModuli::from_young_poisson(1e5, 0.3).lame());
        const DiagonalMass mass(lumped_mass(body.elements(), moving_density), 3, mesh.nodes("x_min"));
        ElasticSystem<3> system(body, mesh.points(), mass);
        system.load.gravity[1] = -9.81;
        TimeIntegrator integrator(
            system, mass, Scheme::implicit_euler,
            {.max_iterations = 1, .at_cap = AtCap::accept, .linear_solve = LinearSolve::conjugate_gradients});
        Points<3> x = mesh.points(), v = Points<3>::Zero(3, x.cols());
        for (int k = 0; k < 3; ++k) integrator.step(0.01, flat(x), flat(v));
        ends[static_cast<std::size_t>(count - 1)] = x;
        set_threads(1);
    }
    CHECK(ends[0] == ends[1]);
}
