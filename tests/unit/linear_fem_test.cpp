// Linear elastic bodies: the matrix, the patch test, and the elementary tests that measure moduli.
#include "fem_body.h"

#include <pliant/math/dense_matrix.h>
#include <pliant/math/error.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/linear_fem_static.h>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

template <int Dim>
BlockShape<Dim> small_block(Real unit = 1) {
    BlockShape<Dim> block;
    for (int k = 0; k < Dim; ++k) {
        block.size[k] = unit * (1 + 0.3 * k);
        block.cells[static_cast<std::size_t>(k)] = Dim == 2 ? 4 + k : 2 + k % 2;
    }
    return block;
}

template <int Dim>
Points<Dim> no_force(const SimplexMesh<Dim>& mesh) {
    return Points<Dim>::Zero(Dim, mesh.node_count());
}

// Displacements that only the numbering of nodes decides.
template <int Dim>
Points<Dim> rough_displacement(const SimplexMesh<Dim>& mesh, Real size) {
    Points<Dim> u(Dim, mesh.node_count());
    for (Index i = 0; i < u.size(); ++i) u.data()[i] = size * std::sin(1.7 * static_cast<Real>(i * i + 1));
    return u;
}

struct Specimen {
    Real youngs_modulus, nu, length, width;
    int cells;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("The stiffness matrix is symmetric, and rigid motions are all that costs nothing", "[fem]",
                       ((int Dim), Dim), 2, 3) {
    const auto material = IsotropicModuli::from_young_poisson(1e5, 0.3);
    const SimplexMesh<Dim> mesh = irregular_block<Dim>(small_block<Dim>());
    const LinearFem<Dim> body(mesh, material.lame());
    const SparseMatrix& K = body.stiffness();
    CHECK(SparseMatrix(SparseMatrix(K.transpose()) - K).norm() == 0);

    const MatX modes = rigid_modes<Dim>(mesh.points());
    CHECK((K * modes).norm() < 1e-12 * K.norm() * modes.norm());
    const VecX values = dense_eigen(MatX(K)).values;
    constexpr Index rigid = Dim == 2 ? 3 : 6;
    CHECK(values.head(rigid).cwiseAbs().maxCoeff() < 1e-12 * values.tail(1)[0]);
    CHECK(values[rigid] > 1e-4 * values.tail(1)[0]);
}

TEMPLATE_TEST_CASE_SIG("Forces element by element, the matrix and the energy tell the same", "[fem]", ((int Dim), Dim), 2, 3) {
    const auto material = IsotropicModuli::from_young_poisson(1e5, 0.3);
    const SimplexMesh<Dim> mesh = irregular_block<Dim>(small_block<Dim>());
    const LinearFem<Dim> body(mesh, material.lame());
    const Points<Dim> u = rough_displacement<Dim>(mesh, 0.01);

    Points<Dim> force;
    body.internal_force(u, force);
    const VecX product = body.stiffness() * u.reshaped();
    CHECK((force.reshaped() - product).norm() < 1e-13 * product.norm());
    CHECK_THAT(body.strain_energy(u), WithinRel(0.5 * u.reshaped().dot(product), 1e-12));
    // Internal forces balance: no resultant and no torque.
    CHECK((rigid_modes<Dim>(mesh.points()).transpose() * product).norm() < 1e-12 * product.norm());

    // An element's stress is the derivative of its energy density, and its strain is dimensionless.
    Tensors<Dim> strain, stress;
    body.strain(u, strain);
    body.stress(u, stress);
    Real energy = 0;
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        energy += 0.5 * mesh.volumes()[e] * tensor<Dim>(strain, e).cwiseProduct(tensor<Dim>(stress, e)).sum();
    CHECK_THAT(body.strain_energy(u), WithinRel(energy, 1e-12));
}

TEMPLATE_TEST_CASE_SIG("Patch test: a linear displacement of the boundary is continued exactly", "[fem]", ((int Dim), Dim), 2,
                       3) {
    const Real nu = GENERATE(-0.9, 0.0, 0.3, 0.4999);
    const Real unit = GENERATE(1e-6, 1.0, 1e6);
    const auto material = IsotropicModuli::from_young_poisson(2e5, nu);
    const SimplexMesh<Dim> mesh = irregular_block<Dim>(small_block<Dim>(unit));
    const LinearFem<Dim> body(mesh, material.lame());
    const Mat<Dim> A = some_gradient<Dim>();
    const Vec<Dim> b = unit * Vec<Dim>::Constant(0.02);
    const Points<Dim> exact = (A * mesh.points()).colwise() + b;
    const Mat<Dim> stress = hooke_stress<Dim>(material.lame(), cauchy_strain<Dim>(A));

    const auto constraints = affine_boundary<Dim>(mesh, A, b);
    for (const bool direct : {true, false}) {
        const auto solution = direct ? solve_static<Dim>(body, constraints, no_force(mesh))
                                     : solve_static<Dim>(body, constraints, no_force(mesh), {1e-13});
        CHECK((solution.displacement - exact).cwiseAbs().maxCoeff() < 1e-10 * exact.cwiseAbs().maxCoeff());
        for (Index e = 0; e < mesh.simplex_count(); ++e)
            CHECK((body.element_stress(e, solution.displacement) - stress).norm() < 1e-9 * stress.norm());
    }
}

TEST_CASE("A steel bar of 2 m and 1e-4 m^2 under 1000 N grows by 0.1 mm", "[fem]") {
    const auto [youngs_modulus, nu, length, width, cells] =
        GENERATE(Specimen{200e9, 0.3, 2, 0.01, 1}, Specimen{200e9, 0.3, 2, 0.01, 2}, Specimen{200e9, 0.0, 2, 0.01, 1},
                 Specimen{200e9, -0.9, 2, 0.01, 2}, Specimen{200e9, 0.4999, 2, 0.01, 1});
    const auto material = IsotropicModuli::from_young_poisson(youngs_modulus, nu);
    const auto mesh = irregular_block<3>({{length, width, width}, {10 * cells, cells, cells}});
    const LinearFem<3> body(mesh, material.lame());
    Points<3> force = no_force(mesh);
    const Real load = 1000, area = width * width;
    add_traction<3>(mesh, mesh.facets("x_max"), Vec<3>(load / area, 0, 0), force);
    CHECK_THAT(force.row(0).sum(), WithinRel(load, 1e-13));

    const auto solution = solve_static<3>(body, rollers(mesh), force);
    const Real extension = load * length / (youngs_modulus * area);
    CHECK_THAT(extension, WithinRel(1e-4, 1e-14));
    for (const Index n : mesh.nodes("x_max")) CHECK_THAT(solution.displacement(0, n), WithinRel(extension, 1e-9));
    for (const Index n : mesh.nodes("y_max"))
        CHECK_THAT(solution.displacement(1, n), WithinAbs(-nu * width * extension / length, 1e-9 * width * extension / length));
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        const Mat<3> stress = body.element_stress(e, solution.displacement);
        const Mat<3> exact = Vec<3>(load / area, 0, 0).asDiagonal();
        CHECK((stress - exact).norm() < 1e-7 * load / area);
    }
    // The support pulls back as hard, and the work of the load is stored.
    CHECK_THAT(solution.reaction.row(0).sum(), WithinRel(-load, 1e-9));
    CHECK(solution.reaction.bottomRows(2).rowwise().sum().norm() < 1e-7 * load);
    CHECK_THAT(body.strain_energy(solution.displacement), WithinRel(0.5 * load * extension, 1e-9));
}

TEST_CASE("A virtual shear test measures Y / (2 (1 + nu))", "[fem]") {
    const Real nu = GENERATE(-0.5, 0.0, 0.3, 0.49);
    const auto material = IsotropicModuli::from_young_poisson(1e6, nu);
    const auto mesh = irregular_block<3>({{0.4, 0.3, 0.2}, {3, 3, 2}});
    const LinearFem<3> body(mesh, material.lame());
    const Real tau = 1e3;
    Mat<3> stress = Mat<3>::Zero();
    stress(0, 1) = stress(1, 0) = tau;
    Points<3> force = no_force(mesh);
    for (const auto& [name, facets] : mesh.facet_sets()) add_boundary_stress<3>(mesh, facets, stress, force);
    DisplacementConstraints<3> constraints(mesh.node_count());
    constraints.prescribe(mesh.nodes("y_min"), Vec<3>::Zero());

    const auto solution = solve_static<3>(body, constraints, force);
    const Real gamma = tau / material.shear_modulus();
    for (Index n = 0; n < mesh.node_count(); ++n)
        CHECK((solution.displacement.col(n) - Vec<3>(gamma * mesh.points()(1, n), 0, 0)).norm() < 1e-10 * gamma);
    CHECK_THAT(tau / (solution.displacement.row(0).maxCoeff() / 0.3), WithinRel(1e6 / (2 * (1 + nu)), 1e-9));
}

TEST_CASE("A virtual pressure test measures Y / (3 (1 - 2 nu))", "[fem]") {
    const Real nu = GENERATE(-0.9, 0.0, 0.3, 0.4999);
    const auto material = IsotropicModuli::from_young_poisson(1e6, nu);
    const auto mesh = irregular_block<3>({{0.4, 0.3, 0.2}, {3, 3, 2}});
    const LinearFem<3> body(mesh, material.lame());
    const Real pressure = 1e3;
    Points<3> force = no_force(mesh);
    for (const char* face : {"x_max", "y_max", "z_max"}) add_pressure<3>(mesh, mesh.facets(face), pressure, force);

    const auto solution = solve_static<3>(body, rollers(mesh), force);
    Tensors<3> strain;
    body.strain(solution.displacement, strain);
    Real volume_change = 0;
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        volume_change += tensor<3>(strain, e).trace() * mesh.volumes()[e] / mesh.volume();
    CHECK(volume_change < 0);
    CHECK_THAT(-pressure / volume_change, WithinRel(1e6 / (3 * (1 - 2 * nu)), 1e-8));
}

TEST_CASE("Two bars in series with stiffnesses 1e8 apart add their extensions", "[fem]") {
    const Real load = 10, area = 1e-2, soft = 1e3, stiff = soft * 1e8;
    const auto mesh = irregular_block<3>({{1, 0.1, 0.1}, {8, 1, 1}});
    std::vector<Lame> materials;
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        Real x = 0;
        for (int a = 0; a < 4; ++a) x += mesh.points()(0, mesh.simplices()(a, e)) / 4;
        materials.push_back(IsotropicModuli::from_young_poisson(x < 0.5 ? stiff : soft, 0).lame());
    }
    const LinearFem<3> body(mesh, materials);
    Points<3> force = no_force(mesh);
    add_traction<3>(mesh, mesh.facets("x_max"), Vec<3>(load / area, 0, 0), force);
    const Real in_stiff = load * 0.5 / (stiff * area), in_soft = load * 0.5 / (soft * area);

    const auto direct = solve_static<3>(body, rollers(mesh), force);
    const auto iterated = solve_static<3>(body, rollers(mesh), force, {1e-12});
    for (Index n = 0; n < mesh.node_count(); ++n) {
        if (std::abs(mesh.points()(0, n) - 0.5) < 1e-12) CHECK_THAT(direct.displacement(0, n), WithinRel(in_stiff, 1e-6));
        if (std::abs(mesh.points()(0, n) - 1.0) < 1e-12) {
            CHECK_THAT(direct.displacement(0, n), WithinRel(in_stiff + in_soft, 1e-9));
            CHECK_THAT(iterated.displacement(0, n), WithinRel(in_stiff + in_soft, 1e-6));
        }
    }
    CHECK(iterated.residual <= 1.01e-12);
    CHECK(iterated.iterations > 0);
}

TEST_CASE("Both solvers find the same bent beam", "[fem]") {
    const auto mesh = irregular_block<3>({{1, 0.2, 0.2}, {10, 2, 2}});
    const LinearFem<3> body(mesh, IsotropicModuli::from_young_poisson(1e6, 0.3).lame());
    Points<3> force = no_force(mesh);
    add_traction<3>(mesh, mesh.facets("x_max"), Vec<3>(0, -10, 3), force);
    DisplacementConstraints<3> clamp(mesh.node_count());
    clamp.prescribe(mesh.nodes("x_min"), Vec<3>::Zero());
    const auto direct = solve_static<3>(body, clamp, force), iterated = solve_static<3>(body, clamp, force, {1e-12});
    CHECK((direct.displacement - iterated.displacement).norm() < 1e-8 * direct.displacement.norm());
    // The clamp holds force and torque of the load.
    const Points<3> all = direct.reaction + force;
    CHECK((rigid_modes<3>(mesh.points()).transpose() * all.reshaped()).norm() < 1e-9 * force.norm());
}

TEST_CASE("Bodies that can still move rigidly are refused with the count", "[fem]") {
    const auto material = IsotropicModuli::from_young_poisson(1e6, 0.3);
    const auto solid = block_mesh<3>({{1e-3, 1e-3, 1e-3}, {2, 2, 2}});
    const LinearFem<3> body(solid, material.lame());
    DisplacementConstraints<3> none(solid.node_count());
    CHECK_THROWS_WITH(solve_static<3>(body, none, no_force(solid)), ContainsSubstring("singular: 6 rigid modes unconstrained"));

    DisplacementConstraints<3> pinned = none;
    pinned.prescribe({0}, Vec<3>::Zero());
    CHECK(unconstrained_rigid_modes<3>(solid, pinned) == 3);
    pinned.prescribe({2}, Vec<3>::Zero());  // an axis to turn about
    CHECK_THROWS_WITH(solve_static<3>(body, pinned, no_force(solid)), ContainsSubstring("singular: 1 rigid mode unconstrained"));
    pinned.prescribe(8, 2, 0);
    CHECK(unconstrained_rigid_modes<3>(solid, pinned) == 0);

    const auto plane = block_mesh<2>({{1, 1}, {2, 2}});
    CHECK(unconstrained_rigid_modes<2>(plane, DisplacementConstraints<2>(9)) == 3);
    DisplacementConstraints<2> slide(9);
    slide.prescribe(plane.nodes("y_min"), 1, 0);
    CHECK(unconstrained_rigid_modes<2>(plane, slide) == 1);
}

TEST_CASE("Every free part of a mesh counts its own rigid motions", "[fem]") {
    Points<2> points(2, 6);
    points << 0, 1, 0, 5, 6, 5, 0, 0, 1, 0, 0, 1;
    SimplexMesh<2>::Simplices simplices(3, 2);
    simplices << 0, 3, 1, 4, 2, 5;
    const SimplexMesh<2> mesh(points, simplices);
    DisplacementConstraints<2> constraints(6);
    CHECK(unconstrained_rigid_modes<2>(mesh, constraints) == 6);
    constraints.prescribe({0, 1}, Vec<2>::Zero());
    CHECK(unconstrained_rigid_modes<2>(mesh, constraints) == 3);
}

TEST_CASE("With every node held there is nothing to solve", "[fem]") {
    const auto mesh = block_mesh<2>({{1, 1}, {2, 2}});
    const LinearFem<2> body(mesh, IsotropicModuli::from_young_poisson(1e6, 0.3).lame());
    DisplacementConstraints<2> all(mesh.node_count());
    for (Index n = 0; n < mesh.node_count(); ++n) all.prescribe({n}, Vec<2>(0.1 * mesh.points().col(n)));
    for (const auto& solution :
         {solve_static<2>(body, all, no_force(mesh)), solve_static<2>(body, all, no_force(mesh), {1e-10})}) {
        CHECK(solution.displacement == all.values());
        CHECK(solution.residual == 0);
    }
}

TEST_CASE("Impossible supports and materials are refused by number", "[fem]") {
    const auto mesh = block_mesh<2>({{1, 1}, {1, 1}});
    DisplacementConstraints<2> constraints(mesh.node_count());
    constraints.prescribe(1, 0, 0.5);
    CHECK_NOTHROW(constraints.prescribe(1, 0, 0.5));
    CHECK_THROWS_WITH(constraints.prescribe(1, 0, 0.6), ContainsSubstring("node 1") && ContainsSubstring("twice"));
    CHECK_THROWS_WITH(constraints.prescribe(7, 0, 0), ContainsSubstring("node 7"));
    CHECK_THROWS_WITH(constraints.prescribe(2, 1, std::numeric_limits<Real>::quiet_NaN()), ContainsSubstring("node 2"));
    CHECK_THROWS_WITH(LinearFem<2>(mesh, {{1, 1}, {1, -1}}), ContainsSubstring("element 1"));
    CHECK_THROWS_WITH(LinearFem<2>(mesh, {{1, 1}}), ContainsSubstring("1 materials"));
}

TEST_CASE("Loads that vary are spread as their work demands", "[fem]") {
    // A linear traction over the right edge and a linear body force: force and torque by integration.
    const auto mesh = irregular_block<2>({{2, 1}, {5, 4}});
    Points<2> force = no_force(mesh);
    add_traction<2>(
        mesh, mesh.facets("x_max"), [](const Vec<2>& X) { return Vec<2>(X[1] * X[1], 3 - X[1]); }, 2, force);
    CHECK_THAT(force.row(0).sum(), WithinRel(1.0 / 3, 1e-13));
    CHECK_THAT(force.row(1).sum(), WithinRel(2.5, 1e-13));
    CHECK_THAT(force.row(0).dot(mesh.points().row(1)), WithinRel(0.25, 1e-13));

    force.setZero();
    add_body_force<2>(
        mesh, [](const Vec<2>& X) { return Vec<2>(0, X[0] * X[1]); }, 2, force);
    CHECK_THAT(force.row(1).sum(), WithinRel(1.0, 1e-13));
    CHECK_THAT(force.row(1).dot(mesh.points().row(0)), WithinRel(8.0 / 6, 1e-13));
    CHECK(force.row(0).isZero(0));
}
