// Displacements that are prescribed: clamps, rollers, moved boundaries.
#pragma once
#include <pliant/mesh/simplex_mesh.h>

#include <vector>

namespace pliant {

template <int Dim>
class DisplacementConstraints {
public:
    explicit DisplacementConstraints(Index node_count);

    // Prescribes one component (a roller when the value is 0), or all components, of nodes [m]. Throws Refused, naming the node,
    // when it does not exist, the value is not finite, or the component already has another value.
    void prescribe(Index node, int component, Real value);
    void prescribe(const std::vector<Index>& nodes, int component, Real value);
    void prescribe(const std::vector<Index>& nodes, const Vec<Dim>& value);

    bool prescribed(Index node, int component) const { return flags_[static_cast<std::size_t>(Dim * node + component)] != 0; }
    // One flag per unknown (component k of node a is unknown Dim a + k).
    const std::vector<char>& flags() const { return flags_; }
    // The prescribed values, and 0 elsewhere.
    const Points<Dim>& values() const { return values_; }
    // How far displacements (Dim × nodes) are from what is prescribed, at most [m].
    Real distance_from(const Points<Dim>& displacement) const;

private:
    std::vector<char> flags_;
    Points<Dim> values_;
};

// Basis of the rigid motions of points, linearised at rest (Dim × nodes as a column): translations in m, then rotations by one
// radian about the axes through the centre (xy; or yz, zx, xy).
template <int Dim>
MatX rigid_modes(const Points<Dim>& points);

// How many independent rigid motions the constraints leave free, summed over the disconnected parts of a body: those of a mesh,
// or lists of nodes.
template <int Dim>
Index unconstrained_rigid_modes(const SimplexMesh<Dim>& mesh, const DisplacementConstraints<Dim>& constraints);
template <int Dim>
Index unconstrained_rigid_modes(const Points<Dim>& points, const std::vector<std::vector<Index>>& parts,
                                const DisplacementConstraints<Dim>& constraints);

// Throws Refused "singular: k rigid modes unconstrained" when there are any.
template <int Dim>
void require_support(const SimplexMesh<Dim>& mesh, const DisplacementConstraints<Dim>& constraints);
template <int Dim>
void require_support(const Points<Dim>& points, const std::vector<std::vector<Index>>& parts,
                     const DisplacementConstraints<Dim>& constraints);

}  // namespace pliant
