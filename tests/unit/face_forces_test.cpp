// Forces on the faces of simplices, shared among their nodes, are those of finite elements to rounding.
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/face_forces.h>
#include <pliant/solids/hyperelastic_fem.h>

#include <catch2/catch_template_test_macros.hpp>

#include <random>

using namespace pliant;

TEMPLATE_TEST_CASE_SIG("face forces spread evenly are minus the derivative of the energy", "[fvm]", ((int Dim), Dim), 2, 3) {
    BlockShape<Dim> shape;
    shape.cells.fill(3);
    const SimplexMesh<Dim> mesh = block_mesh(shape);
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<Real> spread(-0.05, 0.05);
    const Points<Dim> u = Points<Dim>::NullaryExpr(Dim, mesh.node_count(), [&] { return spread(engine); });
    for (const Energy energy : {Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean}) {
        const HyperelasticFem<Dim> fem(mesh, energy, IsotropicModuli::from_young_poisson(1e5, 0.3).lame());
        Tensors<Dim> P;
        Points<Dim> by_elements, by_faces = Points<Dim>::Zero(Dim, mesh.node_count());
        fem.stress(u, P);
        fem.internal_force(u, by_elements);
        add_shared_face_forces(mesh, P, by_faces);
        CHECK((by_faces + by_elements).norm() < 1e-12 * by_elements.norm());
    }
    // The faces of an element close.
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (int a = 0; a <= Dim; ++a) sum += rest_face_area(mesh, e, a);
        CHECK(sum.norm() < 1e-14);
    }
}
