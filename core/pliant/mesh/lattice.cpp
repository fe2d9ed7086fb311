#include <pliant/math/error.h>
#include <pliant/mesh/lattice.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace pliant {
namespace {

// Node numbers are stored in 32 bits by the spring arrays.
constexpr Index max_nodes = std::numeric_limits<std::int32_t>::max();

void require_axis(int axis, Index cells, Real spacing, Real origin) {
    if (cells < 0 || cells >= max_nodes) throw Refused(fmt::format("cells[{}]", axis), Real(cells), "", "a whole number >= 0");
    if (!(spacing > 0) || !std::isfinite(spacing)) throw Refused(fmt::format("spacing[{}]", axis), spacing, "m", "a length > 0");
    if (!std::isfinite(origin)) throw Refused(fmt::format("origin[{}]", axis), origin, "m", "a finite position");
}

// Of the directions d and -d only one is a spring: the one whose last component that is not 0 is positive.
template <int Dim>
bool leads_to_larger_number(const std::array<Index, Dim>& direction) {
    for (int axis = Dim - 1; axis >= 0; --axis)
        if (direction[axis] != 0) return direction[axis] > 0;
    return false;
}

// All directions with components -1, 0 and 1 that change `axes` coordinates.
template <int Dim>
std::vector<std::array<Index, Dim>> directions(int axes) {
    std::vector<std::array<Index, Dim>> found;
    std::array<Index, Dim> direction;
    direction.fill(-1);
    while (true) {
        int changed = 0;
        for (const Index component : direction) changed += component != 0;
        if (changed == axes && leads_to_larger_number<Dim>(direction)) found.push_back(direction);
        int axis = 0;
        while (axis < Dim && direction[axis] == 1) direction[axis++] = -1;
        if (axis == Dim) return found;
        ++direction[axis];
    }
}

}  // namespace

template <int Dim>
NodeLattice<Dim>::NodeLattice(const Cells& cells, const Vec<Dim>& spacing, const Vec<Dim>& origin)
    : cells_(cells), spacing_(spacing), origin_(origin) {
    stride_[0] = 1;
    for (int axis = 0; axis < Dim; ++axis) {
        require_axis(axis, cells[axis], spacing[axis], origin[axis]);
        if (cells[axis] + 1 > max_nodes / stride_[axis])
            throw Refused(fmt::format("cells[{}] = {}: the lattice would have more than {} nodes", axis, cells[axis], max_nodes));
        stride_[axis + 1] = stride_[axis] * (cells[axis] + 1);
    }
}

template <int Dim>
Index NodeLattice<Dim>::node(const Cells& position) const {
    Index number = 0;
    for (int axis = 0; axis < Dim; ++axis) number += position[axis] * stride_[axis];
    return number;
}

template <int Dim>
typename NodeLattice<Dim>::Cells NodeLattice<Dim>::position(Index node) const {
    Cells position;
    for (int axis = 0; axis < Dim; ++axis) position[axis] = node / stride_[axis] % (cells_[axis] + 1);
    return position;
}

template <int Dim>
Points<Dim> NodeLattice<Dim>::points() const {
    Points<Dim> points(Dim, node_count());
    for (Index n = 0; n < node_count(); ++n) {
        const Cells at = position(n);
        for (int axis = 0; axis < Dim; ++axis) points(axis, n) = origin_[axis] + Real(at[axis]) * spacing_[axis];
    }
    return points;
}

template <int Dim>
std::vector<NodePair> NodeLattice<Dim>::pairs(const std::vector<Cells>& offsets) const {
    std::vector<NodePair> found;
    found.reserve(static_cast<std::size_t>(node_count()) * offsets.size());
    for (Index n = 0; n < node_count(); ++n) {
        const Cells at = position(n);
        for (const Cells& offset : offsets) {
            Cells other;
            bool inside = true;
            for (int axis = 0; axis < Dim; ++axis) {
                other[axis] = at[axis] + offset[axis];
                inside = inside && other[axis] >= 0 && other[axis] <= cells_[axis];
            }
            if (inside) found.push_back({n, node(other)});
        }
    }
    found.shrink_to_fit();
    return found;
}

template <int Dim>
std::vector<NodePair> NodeLattice<Dim>::structural() const {
    return pairs(directions<Dim>(1));
}

template <int Dim>
std::vector<NodePair> NodeLattice<Dim>::face_diagonals() const {
    return pairs(directions<Dim>(2));
}

template <int Dim>
std::vector<NodePair> NodeLattice<Dim>::body_diagonals() const {
    return pairs(directions<Dim>(3));
}

template <int Dim>
std::vector<NodePair> NodeLattice<Dim>::bending() const {
    std::vector<Cells> offsets = directions<Dim>(1);
    for (Cells& offset : offsets)
        for (Index& component : offset) component *= 2;
    return pairs(offsets);
}

std::vector<NodeTriple> surface_triangles(const NodeLattice<3>& lattice) {
    const auto& cells = lattice.cells();
    for (int axis = 0; axis < 3; ++axis)
        if (cells[axis] < 1)
            throw Refused(fmt::format("cells[{}]", axis), Real(cells[axis]), "",
                          "at least 1 cell, for a body that has a surface");

    std::vector<NodeTriple> triangles;
    for (int normal = 0; normal < 3; ++normal) {
        const int u = (normal + 1) % 3, w = (normal + 2) % 3;
        for (const Index layer : {Index(0), cells[normal]})
            for (Index j = 0; j < cells[w]; ++j)
                for (Index i = 0; i < cells[u]; ++i) {
                    const auto corner = [&](Index du, Index dw) {
                        NodeLattice<3>::Cells at;
                        at[normal] = layer, at[u] = i + du, at[w] = j + dw;
                        return lattice.node(at);
                    };
                    // u x w is the positive normal, so the far side winds along u, w and the near side the other way.
                    const Index a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    if (layer == 0)
                        triangles.insert(triangles.end(), {NodeTriple{a, c, b}, NodeTriple{a, d, c}});
                    else
                        triangles.insert(triangles.end(), {NodeTriple{a, b, c}, NodeTriple{a, c, d}});
                }
    }
    return triangles;
}

template class NodeLattice<2>;
template class NodeLattice<3>;

}  // namespace pliant
