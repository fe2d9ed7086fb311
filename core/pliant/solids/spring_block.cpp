#include <pliant/solids/spring_block.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <utility>

namespace pliant {

namespace {

std::vector<NodeTriple> sheet_triangles(const SpringLattice& lattice) {
    const auto& nodes = lattice.nodes();
    const auto& cells = nodes.cells();
    std::vector<NodeTriple> triangles;
    for (Index j = 0; j < cells[1]; ++j)
        for (Index i = 0; i < cells[0]; ++i) {
            const Index a = nodes.node({i, j, 0}), b = nodes.node({i + 1, j, 0}), c = nodes.node({i + 1, j + 1, 0}),
                        d = nodes.node({i, j + 1, 0});
            // The short diagonal of a sheared cell.
            if (lattice.kind() == LatticeKind::triangular && j % 2 == 1)
                triangles.insert(triangles.end(), {NodeTriple{a, b, c}, NodeTriple{a, c, d}});
            else
                triangles.insert(triangles.end(), {NodeTriple{a, b, d}, NodeTriple{b, c, d}});
        }
    return triangles;
}

Real doubled_area(const Points<3>& x, const NodeTriple& t) {
    return (x.col(t[1]) - x.col(t[0])).head<3>().cross((x.col(t[2]) - x.col(t[0])).head<3>()).norm();
}

bool outside(const SpringLattice& lattice, const NodePair& pair) {
    const auto a = lattice.nodes().position(pair[0]), b = lattice.nodes().position(pair[1]);
    for (int axis = 0; axis < 3; ++axis)
        if (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == lattice.nodes().cells()[axis])) return true;
    return false;
}

}  // namespace

SpringBlock::SpringBlock(SpringLattice lattice) : lattice_(std::move(lattice)), rest_(lattice_.points()) {
    if (dimension() == 3) surface_ = surface_triangles(lattice_.nodes());
    if (dimension() == 2) surface_ = sheet_triangles(lattice_);
    for (const NodePair& pair : lattice_.pairs(structural))
        if (dimension() < 3 || outside(lattice_, pair)) surface_edges_.push_back(pair);
}

bool SpringBlock::set_springs(const FamilyStiffness& stiffness, Real damping, Real rest_scale) {
    bool rebuild = !built_ || rest_scale != rest_scale_;
    for (int family = 0; family < spring_families; ++family)
        rebuild = rebuild || (stiffness[family] > 0) != (stiffness_[family] > 0);
    stiffness_ = stiffness;
    rest_scale_ = rest_scale;
    if (rebuild) {
        std::vector<Spring> list;
        for (const SpringFamily family : {structural, shear, bending}) {
            first_[family] = static_cast<Index>(list.size());
            if (stiffness[family] > 0) append_springs<3>(rest_, lattice_.pairs(family), stiffness[family], damping, list);
        }
        first_[spring_families] = static_cast<Index>(list.size());
        for (Spring& spring : list) spring.rest_length *= rest_scale;
        springs_ = Springs(rest_.cols(), list);
        built_ = true;
        return true;
    }
    for (int family = 0; family < spring_families; ++family)
        springs_.set_stiffness(first_[family], first_[family + 1] - first_[family], stiffness[family]);
    springs_.set_damping(0, springs_.size(), damping);
    return false;
}

void SpringBlock::set_mass(Real total, const std::vector<Index>& fixed) {
    mass_ = VecX::Constant(rest_.cols(), total / Real(rest_.cols()));
    inertia_ = DiagonalMass(mass_, 3, fixed);
}

Real SpringBlock::smallest_cell(const Points<3>& x) const {
    if (dimension() == 3) return smallest_block_cell(x);
    Real smallest = std::numeric_limits<Real>::infinity();
    for (const NodeTriple& t : surface_) smallest = std::min(smallest, doubled_area(x, t) / doubled_area(rest_, t));
    if (dimension() == 1)
        for (const auto& [i, j] : surface_edges_) smallest = std::min(smallest, (x.col(j) - x.col(i)).norm() / lattice_.edge());
    return smallest;
}

Real SpringBlock::smallest_block_cell(const Points<3>& x) const {
    const auto& cells = lattice_.nodes().cells();
    Real smallest = std::numeric_limits<Real>::infinity();
    for (Index k = 0; k < cells[2]; ++k)
        for (Index j = 0; j < cells[1]; ++j)
            for (Index i = 0; i < cells[0]; ++i) {
                Mat<3> edges = Mat<3>::Zero();
                for (int corner = 0; corner < 8; ++corner) {
                    const std::array<Index, 3> bit{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
                    const Vec<3> at = x.col(lattice_.nodes().node({i + bit[0], j + bit[1], k + bit[2]}));
                    for (int axis = 0; axis < 3; ++axis) edges.col(axis) += (bit[axis] ? 0.25 : -0.25) * at;
                }
                smallest = std::min(smallest, (edges / lattice_.edge()).determinant());
            }
    return smallest;
}

}  // namespace pliant
