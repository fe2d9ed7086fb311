#include "spring_block.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace pliant::mass_spring {

SpringBlock::SpringBlock(const NodeLattice<3>::Cells& cells, Real cell_size)
    : lattice_(cells, Vec<3>::Constant(cell_size),
               Vec<3>(-0.5 * cell_size * Real(cells[0]), 0, -0.5 * cell_size * Real(cells[2]))),
      cell_size_(cell_size),
      rest_(lattice_.points()),
      surface_(surface_triangles(lattice_)) {
    for (const NodePair& pair : lattice_.structural()) {
        const auto a = lattice_.position(pair[0]), b = lattice_.position(pair[1]);
        bool outside = false;
        for (int axis = 0; axis < 3; ++axis)
            outside = outside || (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == cells[axis]));
        if (outside) surface_edges_.push_back(pair);
    }
}

Vec<3> SpringBlock::lengths() const {
    const auto& cells = lattice_.cells();
    return cell_size_ * Vec<3>(Real(cells[0]), Real(cells[1]), Real(cells[2]));
}

std::vector<Index> SpringBlock::layer(int axis, bool last) const {
    std::vector<Index> nodes;
    const Index wanted = last ? lattice_.cells()[axis] : 0;
    for (Index n = 0; n < lattice_.node_count(); ++n)
        if (lattice_.position(n)[axis] == wanted) nodes.push_back(n);
    return nodes;
}

std::vector<NodePair> SpringBlock::pairs(Family family) const {
    switch (family) {
        case structural:
            return lattice_.structural();
        case shear:
            return lattice_.face_diagonals();
        default:
            return lattice_.bending();
    }
}

bool SpringBlock::set_springs(const Stiffnesses& stiffness, Real damping) {
    bool rebuild = !built_;
    for (int family = 0; family < family_count; ++family)
        rebuild = rebuild || (stiffness[family] > 0) != (stiffness_[family] > 0);
    stiffness_ = stiffness;
    if (rebuild) {
        std::vector<Spring> list;
        for (int family = 0; family < family_count; ++family) {
            first_[family] = static_cast<Index>(list.size());
            if (stiffness[family] > 0)
                append_springs<3>(rest_, pairs(static_cast<Family>(family)), stiffness[family], damping, list);
        }
        first_[family_count] = static_cast<Index>(list.size());
        springs_ = Springs(lattice_.node_count(), list);
        built_ = true;
        return true;
    }
    for (int family = 0; family < family_count; ++family)
        springs_.set_stiffness(first_[family], first_[family + 1] - first_[family], stiffness[family]);
    springs_.set_damping(0, springs_.size(), damping);
    return false;
}

void SpringBlock::set_mass(Real total, const std::vector<Index>& fixed) {
    mass_ = VecX::Constant(lattice_.node_count(), total / Real(lattice_.node_count()));
    inertia_ = DiagonalMass(mass_, 3, fixed);
}

Real SpringBlock::smallest_cell(const Points<3>& x) const {
    const auto& cells = lattice_.cells();
    Real smallest = std::numeric_limits<Real>::infinity();
    for (Index k = 0; k < cells[2]; ++k)
        for (Index j = 0; j < cells[1]; ++j)
            for (Index i = 0; i < cells[0]; ++i) {
                Mat<3> edges = Mat<3>::Zero();
                for (int corner = 0; corner < 8; ++corner) {
                    const std::array<Index, 3> bit{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
                    const Vec<3> at = x.col(lattice_.node({i + bit[0], j + bit[1], k + bit[2]}));
                    for (int axis = 0; axis < 3; ++axis) edges.col(axis) += (bit[axis] ? 0.25 : -0.25) * at;
                }
                smallest = std::min(smallest, (edges / cell_size_).determinant());
            }
    return smallest;
}

}  // namespace pliant::mass_spring
