// The surface of what a file holds.
#include <pliant/math/error.h>
#include <pliant/mesh_file/mesh_file.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {
namespace {

// Without points that belong to no triangle.
TriangleSurface with_own_points(const Points<3>& points, Eigen::Matrix<int, 3, Eigen::Dynamic> triangles) {
    std::vector<int> number(static_cast<std::size_t>(points.cols()), -1);
    for (const int n : triangles.reshaped()) number[static_cast<std::size_t>(n)] = 0;
    TriangleSurface surface;
    surface.points.resize(3, std::ranges::count(number, 0));
    int next = 0;
    for (Index p = 0; p < points.cols(); ++p)
        if (int& n = number[static_cast<std::size_t>(p)]; n == 0) surface.points.col(n = next++) = points.col(p);
    for (int& n : triangles.reshaped()) n = number[static_cast<std::size_t>(n)];
    surface.triangles = std::move(triangles);
    return surface;
}

TriangleSurface boundary_surface(const MeshFile& file, std::string_view path) {
    const SimplexMesh<3> mesh = simplex_mesh_of<3>(file, path);
    TriangleSurface surface = with_own_points(mesh.points(), mesh.facets());
    for (const auto& [name, facets] : mesh.facet_sets()) surface.sets[name] = facets;
    return surface;
}

}  // namespace

TriangleSurface surface_of(const MeshFile& file, std::string_view path) {
    if (file.dimension() == 3) return boundary_surface(file, path);
    if (file.dimension() != 2) throw Refused(fmt::format("{}: there are no triangles: a surface is made of them", path));
    const MeshFileElements& all = file.elements[2];
    const Eigen::Matrix<int, 3, Eigen::Dynamic> triangles = all.nodes.topRows<3>();
    for (Index t = 0; t < triangles.cols(); ++t) {
        const auto c = triangles.col(t);
        const FileNumber number = all.numbers[static_cast<std::size_t>(t)];
        if (c[0] == c[1] || c[1] == c[2] || c[0] == c[2])
            throw Refused(fmt::format("{}: triangle {} has two corners at the same point", path, number));
        for (const int n : c)
            if (!file.points.col(n).allFinite())
                throw Refused(fmt::format("{}: a corner of triangle {} is at ({}, {}, {}) m", path, number, file.points(0, n),
                                          file.points(1, n), file.points(2, n)));
    }
    TriangleSurface surface = with_own_points(file.points, triangles);
    for (const MeshGroup& g : file.groups)
        if (g.dimension == 2) surface.sets[g.name] = g.elements;
    for (const MeshPointSet& set : file.point_sets) {
        if (surface.sets.contains(set.name)) continue;
        std::vector<Index> inside;
        for (Index t = 0; t < triangles.cols(); ++t)
            if (std::ranges::all_of(triangles.col(t), [&](int n) { return std::ranges::binary_search(set.points, Index{n}); }))
                inside.push_back(t);
        if (!inside.empty()) surface.sets[set.name] = std::move(inside);
    }
    return surface;
}

}  // namespace pliant
