#include <pliant/math/error.h>
#include <pliant/mesh/block_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace pliant {
namespace {

constexpr const char* axis_name[] = {"x", "y", "z"};

template <int Dim>
using Corner = std::array<int, Dim>;  // position in the lattice of nodes, or 0/1 along each axis of a cell

template <int Dim>
using CellCut = std::vector<std::array<Corner<Dim>, Dim + 1>>;  // simplices of one cell, by its 0/1 corners

// Determinant of the edges from the first corner: its sign tells the orientation.
template <int Dim>
int orientation(const std::array<Corner<Dim>, Dim + 1>& s) {
    std::array<Corner<Dim>, Dim> e{};
    for (std::size_t a = 0; a < Dim; ++a)
        for (std::size_t k = 0; k < Dim; ++k) e[a][k] = s[a + 1][k] - s[0][k];
    if constexpr (Dim == 2)
        return e[0][0] * e[1][1] - e[0][1] * e[1][0];
    else
        return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
               e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

template <int Dim>
void orient(CellCut<Dim>& cut) {
    for (auto& simplex : cut)
        if (orientation<Dim>(simplex) < 0) std::swap(simplex[Dim - 1], simplex[Dim]);
}

// One simplex for each order in which a walk from the lowest to the highest corner may take the axes.
template <int Dim>
CellCut<Dim> diagonal_cut() {
    CellCut<Dim> cut;
    std::array<std::size_t, Dim> order{};
    std::iota(order.begin(), order.end(), 0u);
    do {
        std::array<Corner<Dim>, Dim + 1> simplex{};
        for (std::size_t a = 0; a < Dim; ++a) {
            simplex[a + 1] = simplex[a];
            simplex[a + 1][order[a]] = 1;
        }
        cut.push_back(simplex);
    } while (std::next_permutation(order.begin(), order.end()));
    orient<Dim>(cut);
    return cut;
}

// The corners with an even sum of coordinates span a diagonal (2D) or a regular tetrahedron (3D); each other corner is cut off
// with its neighbours. `mirrored` exchanges the roles of even and odd.
template <int Dim>
CellCut<Dim> alternating_cut(bool mirrored) {
    CellCut<Dim> cut;
    std::vector<Corner<Dim>> kept;
    for (int bits = 0; bits < (1 << Dim); ++bits) {
        Corner<Dim> corner{};
        for (std::size_t k = 0; k < Dim; ++k) corner[k] = (bits >> k) & 1;
        const bool odd = std::accumulate(corner.begin(), corner.end(), 0) % 2 == 1;
        if (odd == mirrored) {
            kept.push_back(corner);
            continue;
        }
        std::array<Corner<Dim>, Dim + 1> simplex{};
        simplex.fill(corner);
        for (std::size_t k = 0; k < Dim; ++k) simplex[k + 1][k] = 1 - corner[k];
        cut.push_back(simplex);
    }
    if constexpr (Dim == 3) cut.push_back({kept[0], kept[1], kept[2], kept[3]});
    orient<Dim>(cut);
    return cut;
}

template <int Dim>
void check(const BlockShape<Dim>& block) {
    Real nodes = 1, simplices = Dim == 2 ? 2 : 6;
    for (int k = 0; k < Dim; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        if (!(block.size[k] > 0) || !std::isfinite(block.size[k]))
            throw Refused(fmt::format("size of the block along {}", axis_name[k]), block.size[k], "m", "a finite length > 0 m");
        if (!std::isfinite(block.origin[k]))
            throw Refused(fmt::format("origin of the block along {}", axis_name[k]), block.origin[k], "m", "a finite number");
        if (block.cells[axis] < 1)
            throw Refused(fmt::format("cells of the block along {}", axis_name[k]), block.cells[axis], "", "a whole number >= 1");
        nodes *= block.cells[axis] + 1.0;
        simplices *= block.cells[axis];
    }
    if (std::max(nodes, simplices) > std::numeric_limits<int>::max() / 4)
        throw Refused(
            fmt::format("a block of {} elements is too large: at most {}", simplices, std::numeric_limits<int>::max() / 4));
}

// Number of the node at a position in the lattice.
template <int Dim>
int node_at(const BlockShape<Dim>& block, const Corner<Dim>& position) {
    int node = 0;
    for (std::size_t k = Dim; k-- > 0;) node = node * (block.cells[k] + 1) + position[k];
    return node;
}

// Calls visit(position) for every position below `counts`, fastest along the first axis.
template <int Dim, class Visit>
void for_each_position(const std::array<int, Dim>& counts, Visit visit) {
    Corner<Dim> position{};
    while (position[Dim - 1] < counts[Dim - 1]) {
        visit(position);
        ++position[0];
        for (std::size_t k = 0; k + 1 < Dim && position[k] == counts[k]; ++k) {
            position[k] = 0;
            ++position[k + 1];
        }
    }
}

template <int Dim>
Points<Dim> lattice_points(const BlockShape<Dim>& block) {
    std::array<int, Dim> counts = block.cells;
    for (int& count : counts) ++count;
    Points<Dim> points(Dim, node_at<Dim>(block, block.cells) + 1);
    Index node = 0;
    for_each_position<Dim>(counts, [&](const Corner<Dim>& position) {
        for (int k = 0; k < Dim; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            points(k, node) = block.origin[k] + block.size[k] * position[axis] / block.cells[axis];
        }
        ++node;
    });
    return points;
}

template <int Dim>
typename SimplexMesh<Dim>::Simplices cut_cells(const BlockShape<Dim>& block) {
    const bool alternate = block.split == CellSplit::alternating;
    const std::array<CellCut<Dim>, 2> cuts = {alternate ? alternating_cut<Dim>(false) : diagonal_cut<Dim>(),
                                              alternate ? alternating_cut<Dim>(true) : diagonal_cut<Dim>()};
    Index cells = 1;
    for (const int count : block.cells) cells *= count;
    typename SimplexMesh<Dim>::Simplices simplices(Dim + 1, cells * static_cast<Index>(cuts[0].size()));
    Index e = 0;
    for_each_position<Dim>(block.cells, [&](const Corner<Dim>& cell) {
        const int parity = std::accumulate(cell.begin(), cell.end(), 0) % 2;
        for (const auto& simplex : cuts[static_cast<std::size_t>(parity)]) {
            for (int a = 0; a <= Dim; ++a) {
                Corner<Dim> position = cell;
                for (std::size_t k = 0; k < Dim; ++k) position[k] += simplex[static_cast<std::size_t>(a)][k];
                simplices(a, e) = node_at<Dim>(block, position);
            }
            ++e;
        }
    });
    return simplices;
}

// A node lies on a face of the box by its position in the lattice, not by comparing rounded coordinates.
template <int Dim>
void name_faces(const BlockShape<Dim>& block, SimplexMesh<Dim>& mesh) {
    std::array<int, Dim> counts = block.cells;
    for (int& count : counts) ++count;
    for (std::size_t axis = 0; axis < Dim; ++axis)
        for (const bool upper : {false, true}) {
            std::vector<char> on_face;
            std::vector<Index> nodes, facets;
            for_each_position<Dim>(counts, [&](const Corner<Dim>& position) {
                on_face.push_back(position[axis] == (upper ? block.cells[axis] : 0));
                if (on_face.back()) nodes.push_back(static_cast<Index>(on_face.size()) - 1);
            });
            for (Index f = 0; f < mesh.facet_count(); ++f) {
                bool inside = true;
                for (int a = 0; a < Dim; ++a) inside = inside && on_face[static_cast<std::size_t>(mesh.facets()(a, f))];
                if (inside) facets.push_back(f);
            }
            const std::string name = std::string(axis_name[axis]) + (upper ? "_max" : "_min");
            mesh.name_nodes(name, std::move(nodes));
            mesh.name_facets(name, std::move(facets));
        }
}

}  // namespace

template <int Dim>
SimplexMesh<Dim> block_mesh(const BlockShape<Dim>& block) {
    check<Dim>(block);
    SimplexMesh<Dim> mesh(lattice_points<Dim>(block), cut_cells<Dim>(block));
    name_faces<Dim>(block, mesh);
    return mesh;
}

template SimplexMesh<2> block_mesh(const BlockShape<2>&);
template SimplexMesh<3> block_mesh(const BlockShape<3>&);

}  // namespace pliant
