// Forces on the faces of simplices, shared among their nodes, are those of finite elements to rounding.
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/face_forces.h>
#include <pliant/solids/hyperelastic_fem.h>

#include <Eigen/LU>

#include <catch2/catch_template_test_macros.hpp>

#include <cmath>
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
        Points<Dim> of_body;
        FaceForceBody<Dim>(fem).internal_force(u, of_body);
        CHECK((of_body + by_faces).norm() == 0);
    }
    // The faces of an element close.
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (int a = 0; a <= Dim; ++a) sum += rest_face_area(mesh, e, a);
        CHECK(sum.norm() < 1e-14);
    }
}

TEMPLATE_TEST_CASE_SIG("Cauchy's stress carries the same force through the deformed face", "[fvm]", ((int Dim), Dim), 2, 3) {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<Real> spread(-1, 1);
    const auto random = [&] { return spread(engine); };
    for (int k = 0; k < 20; ++k) {
        const Mat<Dim> F = Mat<Dim>::NullaryExpr(random), P = Mat<Dim>::NullaryExpr(random);
        const Vec<Dim> N = Vec<Dim>::NullaryExpr(random);
        const Real J = F.determinant();
        const Vec<Dim> area = deformed_face_area<Dim>(F, N);
        CHECK((F.transpose() * area - J * N).norm() < 1e-14);
        CHECK((P * F.transpose() * area / J - P * N).norm() < 1e-12 / std::abs(J));
    }
    // An element that is flat keeps the area of its faces.
    const Vec<Dim> N = Vec<Dim>::Unit(0);
    Mat<Dim> flat_one = Mat<Dim>::Identity();
    flat_one(0, 0) = 0;
    CHECK(deformed_face_area<Dim>(flat_one, N) == N);
}
