#include <pliant/math/error.h>
#include <pliant/mesh_file/gmsh.h>
#include <pliant/mesh_file/mesh_file.h>
#include <pliant/mesh_file/surface_files.h>
#include <pliant/mesh_file/vtk.h>
#include <pliant/text/stored_file.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

namespace pliant {
namespace {

// Numbers of the nodes of a body in its file, and of the points of the file in the body: -1 where a point is none of its nodes.
struct KeptNodes {
    std::vector<Index> points;
    std::vector<int> node_of_point;
};

// All points but the middles of edges: SimplexMesh is told of those that belong to nothing.
KeptNodes corners_of(const MeshFile& file, int corners) {
    const Eigen::MatrixXi& nodes = file.elements[static_cast<std::size_t>(corners - 1)].nodes;
    std::vector<char> middle(static_cast<std::size_t>(file.points.cols()), 0);
    for (Index e = 0; e < nodes.cols(); ++e)
        for (Index a = corners; a < nodes.rows(); ++a) middle[static_cast<std::size_t>(nodes(a, e))] = 1;
    for (Index e = 0; e < nodes.cols(); ++e)
        for (Index a = 0; a < corners; ++a) middle[static_cast<std::size_t>(nodes(a, e))] = 0;
    KeptNodes kept;
    kept.node_of_point.assign(middle.size(), -1);
    for (std::size_t p = 0; p < middle.size(); ++p) {
        if (middle[p]) continue;
        kept.node_of_point[p] = static_cast<int>(kept.points.size());
        kept.points.push_back(static_cast<Index>(p));
    }
    return kept;
}

void require_plane(const MeshFile& file, std::string_view path) {
    for (Index p = 1; p < file.points.cols(); ++p)
        if (file.points(2, p) != file.points(2, 0))
            throw Refused(
                fmt::format("{}: triangles alone make a plane body, but z of node {} is {} m and of node {} {} m; mesh the "
                            "volume, too, for a body in space",
                            path, file.point_numbers[0], file.points(2, 0), file.point_numbers[static_cast<std::size_t>(p)],
                            file.points(2, p)));
}

template <int Dim>
SimplexMesh<Dim> bare_mesh(const MeshFile& file, const KeptNodes& kept, std::string_view path) {
    const MeshFileElements& elements = file.elements[Dim];
    Points<Dim> points(Dim, static_cast<Index>(kept.points.size()));
    MeshNumbers numbers{.nodes = {}, .elements = elements.numbers};
    for (std::size_t n = 0; n < kept.points.size(); ++n) {
        points.col(static_cast<Index>(n)) = file.points.col(kept.points[n]).template head<Dim>();
        numbers.nodes.push_back(file.point_numbers[static_cast<std::size_t>(kept.points[n])]);
    }
    typename SimplexMesh<Dim>::Simplices simplices(Dim + 1, elements.count());
    for (Index e = 0; e < elements.count(); ++e)
        for (int a = 0; a <= Dim; ++a) simplices(a, e) = kept.node_of_point[static_cast<std::size_t>(elements.nodes(a, e))];
    try {
        return SimplexMesh<Dim>(std::move(points), std::move(simplices), numbers);
    } catch (const Refused& e) {
        throw Refused(fmt::format("{}: {}", path, e.what()));
    }
}

// The boundary facets of a mesh, found by their nodes.
template <int Dim>
class FacetFinder {
public:
    explicit FacetFinder(const SimplexMesh<Dim>& mesh) {
        for (Index f = 0; f < mesh.facet_count(); ++f) facets_[sorted(mesh.facets().col(f))] = f;
    }
    // -1 when these nodes make no facet of the boundary.
    Index find(const Eigen::Matrix<int, Dim, 1>& nodes) const {
        const auto found = facets_.find(sorted(nodes));
        return found == facets_.end() ? -1 : found->second;
    }

private:
    static std::array<int, Dim> sorted(const Eigen::Matrix<int, Dim, 1>& nodes) {
        std::array<int, Dim> list;
        std::copy_n(nodes.data(), Dim, list.begin());
        std::ranges::sort(list);
        return list;
    }
    std::map<std::array<int, Dim>, Index> facets_;
};

template <int Dim>
void name_groups(const MeshFile& file, const KeptNodes& kept, SimplexMesh<Dim>& mesh) {
    const FacetFinder<Dim> finder(mesh);
    std::map<std::string, typename SimplexMesh<Dim>::Set> nodes_of_name;
    for (const MeshGroup& g : file.groups) {
        const MeshFileElements& elements = file.elements[static_cast<std::size_t>(g.dimension)];
        auto& nodes = nodes_of_name[g.name];
        typename SimplexMesh<Dim>::Set facets;
        bool on_boundary = g.dimension == Dim - 1;
        for (const Index e : g.elements) {
            for (int a = 0; a <= g.dimension; ++a)
                if (const int n = kept.node_of_point[static_cast<std::size_t>(elements.nodes(a, e))]; n >= 0) nodes.push_back(n);
            if (!on_boundary) continue;
            Eigen::Matrix<int, Dim, 1> facet;
            for (int a = 0; a < Dim; ++a) facet[a] = kept.node_of_point[static_cast<std::size_t>(elements.nodes(a, e))];
            facets.push_back(finder.find(facet));
            on_boundary = facets.back() >= 0;
        }
        if (on_boundary) mesh.name_facets(g.name, std::move(facets));
    }
    for (auto& [name, nodes] : nodes_of_name) mesh.name_nodes(name, std::move(nodes));
}

// Boundary facets whose corners all belong to the set.
template <int Dim>
void name_point_sets(const MeshFile& file, const KeptNodes& kept, SimplexMesh<Dim>& mesh) {
    for (const MeshPointSet& set : file.point_sets) {
        if (mesh.facet_sets().contains(set.name)) continue;
        std::vector<char> in_set(static_cast<std::size_t>(mesh.node_count()), 0);
        typename SimplexMesh<Dim>::Set nodes, facets;
        for (const Index p : set.points)
            if (const int n = kept.node_of_point[static_cast<std::size_t>(p)]; n >= 0)
                nodes.push_back(n), in_set[static_cast<std::size_t>(n)] = 1;
        for (Index f = 0; f < mesh.facet_count(); ++f) {
            const auto corners = mesh.facets().col(f);
            if (std::all_of(corners.begin(), corners.end(), [&](int n) { return in_set[static_cast<std::size_t>(n)] == 1; }))
                facets.push_back(f);
        }
        mesh.name_nodes(set.name, std::move(nodes));
        if (!facets.empty()) mesh.name_facets(set.name, std::move(facets));
    }
}

}  // namespace

int MeshFile::dimension() const {
    for (int d = 3; d > 0; --d)
        if (elements[static_cast<std::size_t>(d)].count() > 0) return d;
    return 0;
}

MeshFile read_mesh_file(const std::string& path) {
    const StoredFile& file = stored_file(store_file(path, mesh_file_endings));
    if (file.name.empty())
        throw Refused(fmt::format("no mesh is named: give a file that ends in {}", accepted_files(mesh_file_endings)));
    return parse_mesh_file(file.bytes, file.name);
}

MeshFile parse_mesh_file(std::string_view bytes, std::string_view path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".msh") return parse_gmsh(bytes, path);
    if (ending == ".vtu") return parse_vtu(bytes, path);
    if (ending == ".vtk") return parse_vtk_legacy(bytes, path);
    if (ending == ".obj") return parse_obj(bytes, path);
    if (ending == ".stl") return parse_stl(bytes, path);
    throw Refused(fmt::format("{}: a mesh is read from a file that ends in {}, not in '{}'", path,
                              fmt::join(mesh_file_endings, ", "), ending));
}

template <int Dim>
SimplexMesh<Dim> simplex_mesh_of(const MeshFile& file, std::string_view path) {
    if (file.dimension() != Dim)
        throw Refused(fmt::format("{}: the mesh is of dimension {}, where one of {} is asked for ({})", path, file.dimension(),
                                  Dim, Dim == 2 ? "triangles without tetrahedra" : "tetrahedra"));
    if constexpr (Dim == 2) require_plane(file, path);
    const KeptNodes kept = corners_of(file, Dim + 1);
    SimplexMesh<Dim> mesh = bare_mesh<Dim>(file, kept, path);
    name_groups(file, kept, mesh);
    name_point_sets(file, kept, mesh);
    return mesh;
}

template <int Dim>
void require_facet_groups(const SimplexMesh<Dim>& mesh, std::initializer_list<std::string_view> names, std::string_view path) {
    const auto& sets = mesh.facet_sets();
    for (const std::string_view name : names) {
        if (const auto found = sets.find(name); found != sets.end() && !found->second.empty()) continue;
        const std::string_view facets = Dim == 2 ? "edges" : "triangles";
        std::vector<std::string_view> known, others;
        for (const auto& [key, set] : sets) known.push_back(key);
        for (const auto& [key, set] : mesh.node_sets())
            if (!sets.contains(key)) others.push_back(key);
        if (mesh.node_sets().contains(name))
            throw Refused(
                fmt::format("{}: the group '{}' is there, but it is not made of {} on the boundary: it has others, or some that "
                            "lie inside the body; give it the {} of the boundary alone",
                            path, name, facets, facets));
        std::string there = known.empty() ? "none on the boundary" : fmt::format("{}", fmt::join(known, ", "));
        if (!others.empty()) there += fmt::format("; of other elements {}", fmt::join(others, ", "));
        throw Refused(
            fmt::format("{}: the group '{}' of {} on the boundary is missing; the file has {}: make a physical group of "
                        "that name",
                        path, name, facets, there));
    }
}

template SimplexMesh<2> simplex_mesh_of<2>(const MeshFile&, std::string_view);
template SimplexMesh<3> simplex_mesh_of<3>(const MeshFile&, std::string_view);
template void require_facet_groups(const SimplexMesh<2>&, std::initializer_list<std::string_view>, std::string_view);
template void require_facet_groups(const SimplexMesh<3>&, std::initializer_list<std::string_view>, std::string_view);

}  // namespace pliant
