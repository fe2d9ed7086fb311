#include <pliant/math/error.h>
#include <pliant/mesh_file/gmsh.h>
#include <pliant/mesh_file/mesh_file.h>
#include <pliant/text/file.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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
    for (const MeshGroup& g : file.groups) {
        const MeshFileElements& elements = file.elements[static_cast<std::size_t>(g.dimension)];
        typename SimplexMesh<Dim>::Set nodes, facets;
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
        mesh.name_nodes(g.name, std::move(nodes));
        if (on_boundary) mesh.name_facets(g.name, std::move(facets));
    }
}

}  // namespace

int MeshFile::dimension() const {
    for (int d = 3; d > 0; --d)
        if (elements[static_cast<std::size_t>(d)].count() > 0) return d;
    return 0;
}

MeshFile read_mesh_file(const std::string& path) { return parse_mesh_file(read_file(path), path); }

MeshFile parse_mesh_file(std::string_view bytes, std::string_view path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending == ".msh") return parse_gmsh(bytes, path);
    throw Refused(fmt::format("{}: a mesh is read from a file of Gmsh that ends in .msh, not in '{}'", path, ending));
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
    return mesh;
}

template <int Dim>
void require_facet_groups(const SimplexMesh<Dim>& mesh, std::initializer_list<std::string_view> names, std::string_view path) {
    const auto& sets = mesh.facet_sets();
    for (const std::string_view name : names) {
        if (const auto found = sets.find(name); found != sets.end() && !found->second.empty()) continue;
        std::vector<std::string_view> known;
        for (const auto& [key, set] : sets) known.push_back(key);
        throw Refused(fmt::format(
            "{}: the group '{}' of {} on the boundary is missing; there {}: make a physical group of that name", path, name,
            Dim == 2 ? "edges" : "triangles", known.empty() ? "is none" : fmt::format("are {}", fmt::join(known, ", "))));
    }
}

template SimplexMesh<2> simplex_mesh_of<2>(const MeshFile&, std::string_view);
template SimplexMesh<3> simplex_mesh_of<3>(const MeshFile&, std::string_view);
template void require_facet_groups(const SimplexMesh<2>&, std::initializer_list<std::string_view>, std::string_view);
template void require_facet_groups(const SimplexMesh<3>&, std::initializer_list<std::string_view>, std::string_view);

}  // namespace pliant
