// Finite volumes on simplices [Teran2003]: the stress of each element pulls at its faces, and each face shares its force evenly
// among its nodes.
#pragma once
#include <pliant/continuum/strain.h>
#include <pliant/mesh/simplex_mesh.h>

namespace pliant {

// Outward area vector at rest of the face of an element opposite its corner [m^(Dim-1)]. The faces of an element close: these sum
// to 0.
template <int Dim>
Vec<Dim> rest_face_area(const SimplexMesh<Dim>& mesh, Index element, int opposite);

// f_A = P N [N], which the rest of the body exerts on the element through that face: P the first Piola-Kirchhoff stress [Pa], N
// the area vector at rest.
template <int Dim>
Vec<Dim> face_force(const SimplexMesh<Dim>& mesh, Index element, int opposite, const Mat<Dim>& P) {
    return P * rest_face_area(mesh, element, opposite);
}

// Adds to each node the force [N] that its elements exert on it: 1/Dim of that of every face it belongs to, turned round, since
// what pulls at the element pulls back at the nodes; the sum is - V P grad(shape function).
template <int Dim>
void add_shared_face_forces(const SimplexMesh<Dim>& mesh, const Tensors<Dim>& P, Points<Dim>& force);

}  // namespace pliant
