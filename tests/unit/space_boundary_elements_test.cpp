// Boundary elements in space: a cavity under pressure, a cube that is pulled, rigid motions.
#include <pliant/continuum/moduli.h>
#include <pliant/math/error.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/bem/space_boundary_elements.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>

using namespace pliant;

namespace {

const IsotropicModuli material = IsotropicModuli::from_young_poisson(1e4, 0.3);

struct CavityErrors {
    Real mean, worst;  // of u_r = p a/(4 G), relative
    Real hoop;         // of the stress p/2 along the wall, at worst
};
CavityErrors cavity_errors(int frequency, BoundaryOrder order, bool curved) {
    const SphereSurface sphere = sphere_surface(frequency, true);
    SpaceBoundaryElements bem(sphere.corners, sphere.triangles, material.lame(), true, order,
                              curved ? [](const Vec<3>& x) -> Vec<3> { return x.normalized(); }
                                     : std::function<Vec<3>(const Vec<3>&)>());
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    for (Index t = 0; t < bem.triangle_count(); ++t)
        for (int a = 0; a < bem.nodes_per_triangle(); ++a)
            conditions.value.segment<3>(3 * bem.system().slot_of(t, a)) = -bem.normal_at_node(t, a);
    const auto s = bem.system().solve(conditions);
    CavityErrors errors{0, 0, 0};
    for (Index n = 0; n < s.displacement.cols(); ++n) {
        const Real error = s.displacement.col(n).dot(bem.system().nodes().col(n).normalized()) * 4 * material.shear_modulus() - 1;
        errors.mean += error / static_cast<Real>(s.displacement.cols());
        errors.worst = std::max(errors.worst, std::abs(error));
    }
    if (order != BoundaryOrder::constant)
        for (Index t = 0; t < bem.triangle_count(); ++t) {
            const Mat<3> sigma = bem.boundary_stress(s, t);
            const Vec<3> n = bem.normal(t), along = n.unitOrthogonal();
            errors.hoop = std::max(errors.hoop, std::abs(along.dot(sigma * along) / 0.5 - 1));
        }
    return errors;
}

}  // namespace

TEST_CASE("a cavity under pressure widens by p a/(4 G), at second order", "[bem]") {
    // Flat triangles between corners on the sphere: the surface lies inside it, and so do the displacements.
    const CavityErrors coarse = cavity_errors(2, BoundaryOrder::linear, false),
                       fine = cavity_errors(4, BoundaryOrder::linear, false);
    INFO("flat: " << coarse.worst << " (80 triangles), " << fine.worst << " (320)");
    CHECK(fine.worst < 0.05);
    CHECK(std::log2(coarse.worst / fine.worst) > 1.8);
    // The same displacements over triangles that bend onto it.
    const CavityErrors bent = cavity_errors(4, BoundaryOrder::linear, true);
    INFO("bent: mean " << bent.mean << ", worst " << bent.worst << ", hoop " << bent.hoop);
    CHECK(bent.worst < 0.014);
    CHECK(bent.hoop < 0.03);
    CHECK(cavity_errors(4, BoundaryOrder::constant, true).worst < 0.036);
    const CavityErrors quadratic = cavity_errors(2, BoundaryOrder::quadratic, true);
    INFO("quadratic: worst " << quadratic.worst << ", hoop " << quadratic.hoop);
    CHECK(quadratic.worst < 0.003);
    CHECK(quadratic.hoop < 0.013);
}

TEST_CASE("a cavity of 980 bent triangles widens by p a/(4 G) to half a per cent, at every node", "[bem][slow]") {
    const CavityErrors e = cavity_errors(7, BoundaryOrder::linear, true);
    INFO("mean " << e.mean << ", worst " << e.worst);
    CHECK(e.worst < 0.005);
}

TEST_CASE("a cube that is held at one face and pulled at the other has a uniform strain and stress", "[bem]") {
    const SimplexMesh<3> mesh = block_mesh<3>({.size = Vec<3>::Ones(), .cells = {2, 2, 2}, .split = CellSplit::diagonal});
    // The surface with nodes of its own: one for each face that meets in an edge would be needed for tractions that jump, so the
    // whole boundary is held, and gives the tractions.
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1);
    Points<3> nodes(3, 0);
    SpaceBoundaryElements::Triangles triangles(3, mesh.facet_count());
    for (Index f = 0; f < mesh.facet_count(); ++f)
        for (int a = 0; a < 3; ++a) {
            int& n = number[static_cast<std::size_t>(mesh.facets()(a, f))];
            if (n < 0) {
                n = static_cast<int>(nodes.cols());
                nodes.conservativeResize(3, n + 1);
                nodes.col(n) = mesh.points().col(mesh.facets()(a, f));
            }
            triangles(a, f) = n;
        }
    SpaceBoundaryElements bem(nodes, triangles, IsotropicModuli::from_young_poisson(1e4, 0.3).lame(), false);
    bem.assemble();
    // H u = G t of a uniform state, whose tractions are known on every triangle.
    Mat<3> strain = Vec<3>(0.01, -0.003, 0.002).asDiagonal();
    strain(0, 1) = strain(1, 0) = 0.004;
    const Mat<3> stress = hooke_stress<3>(IsotropicModuli::from_young_poisson(1e4, 0.3).lame(), strain);
    BoundarySolution<3> s{strain * nodes, Points<3>(3, bem.system().slot_count())};
    for (Index t = 0; t < triangles.cols(); ++t)
        for (int a = 0; a < 3; ++a) s.traction.col(bem.system().slot_of(t, a)) = stress * bem.normal(t);
    const VecX left = bem.system().H() * flat(s.displacement), right = bem.system().G() * flat(s.traction);
    CHECK((left - right).norm() < 2e-5 * left.norm());
    CHECK((bem.displacement(s, {0.4, 0.5, 0.6}) - strain * Vec<3>(0.4, 0.5, 0.6)).norm() < 1e-7);
    CHECK((bem.stress(s, {0.4, 0.5, 0.6}) - stress).norm() < 1e-4 * stress.norm());
}

TEST_CASE("a surface that bounds no body is refused", "[bem]") {
    const SphereSurface s = sphere_surface(1, true);
    const Lame material{1, 1};
    CHECK_THROWS_WITH(SpaceBoundaryElements(s.corners, s.triangles.leftCols(19), material, true),
                      Catch::Matchers::ContainsSubstring("the surface is not closed"));
    auto turned = s.triangles;
    std::swap(turned(0, 3), turned(1, 3));
    CHECK_THROWS_WITH(SpaceBoundaryElements(s.corners, turned, material, true),
                      Catch::Matchers::ContainsSubstring("turn one of them over"));
}
