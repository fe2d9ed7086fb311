#include <pliant/mesh_file/vtk_cells.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pliant {
namespace {

struct VtkType {
    Index code;
    std::string_view name;
    int dimension;  // -1: not read
    int nodes;
};
constexpr std::array<VtkType, 21> vtk_types{{{1, "vertex", 0, 1},
                                             {3, "line", 1, 2},
                                             {21, "line of second order", 1, 3},
                                             {5, "triangle", 2, 3},
                                             {22, "triangle of second order", 2, 6},
                                             {10, "tetrahedron", 3, 4},
                                             {24, "tetrahedron of second order", 3, 10},
                                             {2, "cell of many vertices", -1, 0},
                                             {4, "line of several pieces", -1, 0},
                                             {6, "strip of triangles", -1, 0},
                                             {7, "polygon", -1, 0},
                                             {8, "pixel", -1, 4},
                                             {9, "quadrangle", -1, 4},
                                             {11, "voxel", -1, 8},
                                             {12, "hexahedron", -1, 8},
                                             {13, "prism", -1, 6},
                                             {14, "pyramid", -1, 5},
                                             {23, "quadrangle of second order", -1, 8},
                                             {25, "hexahedron of second order", -1, 20},
                                             {26, "prism of second order", -1, 15},
                                             {42, "polyhedron", -1, 0}}};

// The middles of the last two edges of a tetrahedron stand the other way round in files of Gmsh, as MeshFile has them.
constexpr int vtk_tetrahedron_nodes = 10;

}  // namespace

VtkCells::VtkCells(Points<3> points, Refuse refuse) : refuse_(std::move(refuse)) {
    file_.points = std::move(points);
    file_.point_numbers.resize(static_cast<std::size_t>(file_.points.cols()));
    std::iota(file_.point_numbers.begin(), file_.point_numbers.end(), FileNumber{0});
}

void VtkCells::add(Index type, std::span<const std::int64_t> nodes) {
    const Index cell = count();
    const auto known = std::ranges::find(vtk_types, type, &VtkType::code);
    if (known == vtk_types.end() || known->dimension < 0) {
        refuse_(fmt::format("cell {} is a {}, which is not read: mesh the body with triangles or tetrahedra", cell,
                            known == vtk_types.end() ? fmt::format("cell of type {}", type) : std::string(known->name)));
        return;
    }
    if (static_cast<int>(nodes.size()) != known->nodes)
        refuse_(fmt::format("cell {} is a {} and has {} points, not {}", cell, known->name, nodes.size(), known->nodes));
    const auto d = static_cast<std::size_t>(known->dimension);
    if (nodes_each_[d] != 0 && nodes_each_[d] != known->nodes)
        refuse_(fmt::format("cell {} is of another order than those before it: cells of one order are read", cell));
    nodes_each_[d] = known->nodes;
    for (const std::int64_t n : nodes) {
        if (n < 0 || n >= file_.points.cols()) refuse_(fmt::format("cell {} names point {}, which is not there", cell, n));
        nodes_[d].push_back(static_cast<int>(n));
    }
    if (known->nodes == vtk_tetrahedron_nodes) std::swap(nodes_[d].end()[-1], nodes_[d].end()[-2]);
    auto& numbers = file_.elements[d].numbers;
    places_.push_back({known->dimension, static_cast<Index>(numbers.size())});
    numbers.push_back(static_cast<FileNumber>(cell));
}

bool VtkCells::names_a_set(const VtkArray& array, Index count, std::string_view what) const {
    const auto rows = static_cast<Index>(array.values.size()) / std::max<Index>(array.components, 1);
    if (rows != count || array.values.size() % static_cast<std::size_t>(std::max<Index>(array.components, 1)) != 0)
        refuse_(fmt::format("the array '{}' has {} rows for {} {}", array.name, rows, count, what));
    return array.components == 1 && std::ranges::all_of(array.values, [](Real x) { return x == 0 || x == 1; }) &&
           std::ranges::find(array.values, Real{1}) != array.values.end();
}

void VtkCells::name_points(const VtkArray& array) {
    if (!names_a_set(array, file_.points.cols(), "points")) return;
    MeshPointSet set{.name = array.name, .points = {}};
    for (std::size_t p = 0; p < array.values.size(); ++p)
        if (array.values[p] == 1) set.points.push_back(static_cast<Index>(p));
    file_.point_sets.push_back(std::move(set));
}

void VtkCells::name_cells(const VtkArray& array) {
    if (!names_a_set(array, count(), "cells")) return;
    std::array<MeshGroup, 4> groups;
    for (std::size_t c = 0; c < places_.size(); ++c)
        if (array.values[c] == 1) groups[static_cast<std::size_t>(places_[c].dimension)].elements.push_back(places_[c].element);
    for (int d = 0; d < 4; ++d) {
        MeshGroup& g = groups[static_cast<std::size_t>(d)];
        if (!g.elements.empty()) file_.groups.push_back({array.name, d, std::move(g.elements)});
    }
}

MeshFile VtkCells::finish() {
    for (std::size_t d = 0; d < nodes_.size(); ++d) {
        const Index each = std::max(nodes_each_[d], 1), elements = static_cast<Index>(nodes_[d].size()) / each;
        file_.elements[d].nodes = Eigen::Map<const Eigen::MatrixXi>(nodes_[d].data(), each, elements);
    }
    return std::move(file_);
}

}  // namespace pliant
