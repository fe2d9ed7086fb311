// What the tests of linear elasticity share: irregular meshes, and supports that let a body strain freely.
#pragma once
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/displacement_constraints.h>

#include <cmath>
#include <string>

namespace pliant::test {

// The block with its inner nodes moved by up to `share` of a cell, the same way on every machine.
template <int Dim>
SimplexMesh<Dim> irregular_block(const BlockShape<Dim>& block, Real share = 0.2) {
    const SimplexMesh<Dim> regular = block_mesh<Dim>(block);
    Points<Dim> points = regular.points();
    for (Index n = 0; n < points.cols(); ++n) {
        const Vec<Dim> x = (points.col(n) - block.origin).cwiseQuotient(block.size);
        for (int k = 0; k < Dim; ++k) {
            const Real cell = block.size[k] / block.cells[static_cast<std::size_t>(k)];
            const bool inside = (x.array() > 1e-9).all() && (x.array() < 1 - 1e-9).all();
            if (inside) points(k, n) += share * cell * std::sin(12.9898 * static_cast<Real>(n) + 78.233 * k);
        }
    }
    return regular.with_points(points);
}

// Rollers on the lower faces of a block: no face moves along its normal, everything else is free.
template <int Dim>
DisplacementConstraints<Dim> rollers(const SimplexMesh<Dim>& mesh) {
    DisplacementConstraints<Dim> constraints(mesh.node_count());
    const std::string axes = "xyz";
    for (int k = 0; k < Dim; ++k) constraints.prescribe(mesh.nodes(axes.substr(static_cast<std::size_t>(k), 1) + "_min"), k, 0);
    return constraints;
}

// All nodes of the boundary follow u = A X + b.
template <int Dim>
DisplacementConstraints<Dim> affine_boundary(const SimplexMesh<Dim>& mesh, const Mat<Dim>& A, const Vec<Dim>& b) {
    DisplacementConstraints<Dim> constraints(mesh.node_count());
    for (Index f = 0; f < mesh.facet_count(); ++f)
        for (int a = 0; a < Dim; ++a) {
            const Index n = mesh.facets()(a, f);
            const Vec<Dim> u = A * mesh.points().col(n) + b;
            for (int k = 0; k < Dim; ++k) constraints.prescribe(n, k, u[k]);
        }
    return constraints;
}

// Displacement gradient of a general deformation.
template <int Dim>
Mat<Dim> some_gradient() {
    Mat<Dim> A;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) A(i, j) = 0.01 * std::sin(1.0 + 2 * i + 5 * j);
    return A;
}

}  // namespace pliant::test
