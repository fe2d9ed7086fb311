// A cube of linear elastic tetrahedra that is stretched in small steps, each computed on the shape that was reached before: the
// finite-element form of d eps_y = -nu d eps_x.
#pragma once
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/linear_fem_static.h>

#include <memory>

namespace pliant {

class StretchedCube {
public:
    // cells: along each edge, of 5 tetrahedra each. length: of the edges [m].
    StretchedCube(Real nu, Real length, int cells);
    StretchedCube(const StretchedCube&) = delete;
    StretchedCube& operator=(const StretchedCube&) = delete;

    const SimplexMesh<3>& rest() const { return rest_; }

    // Starts a step from the displacements u [m] from rest that were reached. Young's modulus does not matter.
    void begin(const Points<3>& u);
    // The displacements [m] of the step that moves the far face by dx: three lower faces slide on rollers.
    Points<3> increment(Real dx) const;
    const LinearFem<3>& body() const { return *body_; }
    bool begun() const { return body_ != nullptr; }
    bool held(Index node, int component) const { return holds(node, component) || pulled(node, component); }
    bool pulled(Index node, int component) const { return component == 0 && rest_.points()(0, node) == length_; }

    // Read off the displacements from rest, as means over the faces: dL/L, dL'/L across z, and V/V0.
    Real axial_strain(const Points<3>&u) const, contraction(const Points<3>&u) const, volume_ratio(const Points<3>&u) const,
        element_volume_ratio(Index element, const Points<3>&u) const;

private:
    bool holds(Index node, int component) const { return rest_.points()(component, node) == 0; }
    Real mean(const char* face, int component, const Points<3>& u) const;

    Lame material_;
    Real length_;
    SimplexMesh<3> rest_;
    std::unique_ptr<SimplexMesh<3>> reached_;
    std::unique_ptr<LinearFem<3>> body_;
};

}  // namespace pliant
