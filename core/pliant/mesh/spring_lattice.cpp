#include <pliant/mesh/spring_lattice.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

constexpr Real row_height = std::numbers::sqrt3_v<Real> / 2;

Vec<3> spacing_of(LatticeKind kind) { return {1, kind == LatticeKind::triangular ? row_height : 1, 1}; }

NodeLattice<3>::Cells used_cells(LatticeKind kind, NodeLattice<3>::Cells cells) {
    if (dimension_of(kind) < 3) cells[2] = 0;
    if (dimension_of(kind) < 2) cells[0] = 0;
    return cells;
}

// Each direction once: the one that leads to a larger node number.
bool leads_on(const Vec<3>& d) {
    for (int axis = 2; axis >= 0; --axis)
        if (d[axis] != 0) return d[axis] > 0;
    return false;
}

// Directions to the neighbours of a cubic lattice of that dimension that differ in `axes` coordinates.
std::vector<Vec<3>> directions(int dimension, int axes) {
    std::vector<Vec<3>> found;
    for (int z = dimension > 2 ? -1 : 0; z <= (dimension > 2 ? 1 : 0); ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = dimension > 1 ? -1 : 0; x <= (dimension > 1 ? 1 : 0); ++x) {
                const Vec<3> d(x, y, z);
                if (static_cast<int>(d.cwiseAbs().sum()) == axes && leads_on(d)) found.push_back(d);
            }
    return found;
}

}  // namespace

int dimension_of(LatticeKind kind) {
    switch (kind) {
        case LatticeKind::chain:
            return 1;
        case LatticeKind::square:
        case LatticeKind::triangular:
            return 2;
        default:
            return 3;
    }
}

std::vector<LatticeBond> lattice_bonds(LatticeKind kind) {
    const int dimension = dimension_of(kind);
    std::vector<Vec<3>> edges = directions(dimension, 1), diagonals;
    if (kind == LatticeKind::triangular) edges = {{1, 0, 0}, {-0.5, row_height, 0}, {0.5, row_height, 0}};
    if (kind == LatticeKind::square || kind == LatticeKind::cubic_face) diagonals = directions(dimension, 2);
    if (kind == LatticeKind::cubic_body) diagonals = directions(dimension, 3);
    std::vector<LatticeBond> bonds;
    for (const Vec<3>& d : edges) bonds.push_back({d, structural});
    for (const Vec<3>& d : diagonals) bonds.push_back({d, shear});
    for (const Vec<3>& d : edges) bonds.push_back({2 * d, bending});
    return bonds;
}

Real cell_measure(LatticeKind kind) { return spacing_of(kind)[1]; }

SpringLattice::SpringLattice(LatticeKind kind, const NodeLattice<3>::Cells& cells, Real edge)
    : kind_(kind), edge_(edge), nodes_(used_cells(kind, cells), edge * spacing_of(kind)) {}

Vec<3> SpringLattice::lengths() const {
    const auto& cells = nodes_.cells();
    return edge_ * spacing_of(kind_).cwiseProduct(Vec<3>(Real(cells[0]), Real(cells[1]), Real(cells[2])));
}

Points<3> SpringLattice::points() const {
    Points<3> points = nodes_.points();
    const Vec<3> half = 0.5 * lengths();
    for (Index n = 0; n < points.cols(); ++n) points(0, n) += shift(nodes_.position(n)[1]) * edge_;
    points.colwise() -= Vec<3>(half[0] + 0.5 * shift(1) * edge_, 0, half[2]);
    return points;
}

std::vector<NodePair> SpringLattice::pairs(SpringFamily family) const {
    std::vector<Vec<3>> offsets;
    for (const LatticeBond& bond : lattice_bonds(kind_))
        if (bond.family == family) offsets.push_back(bond.offset);
    const Vec<3> spacing = spacing_of(kind_);
    std::vector<NodePair> found;
    for (Index n = 0; n < nodes_.node_count(); ++n) {
        const auto at = nodes_.position(n);
        for (const Vec<3>& offset : offsets) {
            auto other = at;
            other[1] += std::lround(offset[1] / spacing[1]);
            other[0] += std::lround(offset[0] + shift(at[1]) - shift(std::abs(other[1])));
            other[2] += std::lround(offset[2]);
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis) inside = inside && other[axis] >= 0 && other[axis] <= nodes_.cells()[axis];
            if (inside) found.push_back({n, nodes_.node(other)});
        }
    }
    return found;
}

Real SpringLattice::share(const NodePair& pair, SpringFamily family) const {
    if (family == bending) return 1;
    const auto &cells = nodes_.cells(), a = nodes_.position(pair[0]), b = nodes_.position(pair[1]);
    Real share = 1;
    for (int axis = 0; axis < 3; ++axis)
        if (cells[axis] > 0 && a[axis] == b[axis] && (a[axis] == 0 || a[axis] == cells[axis])) share /= 2;
    return share;
}

std::vector<Index> SpringLattice::layer(int axis, bool last) const {
    std::vector<Index> found;
    const Index wanted = last ? nodes_.cells()[axis] : 0;
    for (Index n = 0; n < nodes_.node_count(); ++n)
        if (nodes_.position(n)[axis] == wanted) found.push_back(n);
    return found;
}

}  // namespace pliant
