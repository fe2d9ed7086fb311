// What stands in a mesh file: points, elements of each dimension and the groups that they have a name by. Nothing of it is a body
// yet: simplex_mesh_of makes one.
#pragma once
#include <pliant/mesh/simplex_mesh.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// The number that an element or a node has in its file: what errors name.
using FileNumber = std::size_t;

// A group of elements of one dimension: "fixed".
struct MeshGroup {
    std::string name;
    int dimension = 0;            // 0 points, 1 edges, 2 triangles, 3 tetrahedra
    std::vector<Index> elements;  // of MeshFile::elements[dimension], ascending
};

// The elements of one dimension, in the order of the file.
struct MeshFileElements {
    Eigen::MatrixXi nodes;            // a column each: corners first, then the middles of the edges; columns of points
    std::vector<FileNumber> numbers;  // of each, in the file
    Index count() const { return nodes.cols(); }
};

// Points by a name: "fixed".
struct MeshPointSet {
    std::string name;
    std::vector<Index> points;  // ascending
};

struct MeshFile {
    Points<3> points;                       // m
    std::vector<FileNumber> point_numbers;  // of each, in the file
    std::array<MeshFileElements, 4> elements{};
    std::vector<MeshGroup> groups;
    std::vector<MeshPointSet> point_sets{};
    // Of the elements with the highest dimension: 2 with triangles alone, 3 with tetrahedra; 0 and 1 make no body.
    int dimension() const;
};

inline constexpr std::array<std::string_view, 5> mesh_file_endings{".msh", ".vtu", ".vtk", ".obj", ".stl"};

// By the ending of the path, in any case of letters. Throws Refused naming the path, the line (or byte) and what is accepted.
// read: of a path, or the name of a body that comes with Pliant; the bytes are those of stored_file.h.
MeshFile read_mesh_file(const std::string& path);
MeshFile parse_mesh_file(std::string_view bytes, std::string_view path);

// The body of a file, of dimension Dim: nodes and elements in the order of the file. Quadratic elements give their corners. Every
// group is a set of nodes by its name, those of one name together; one of boundary facets is a set of those, too, and so are the
// boundary facets whose corners all belong to a set of points.
// Throws Refused, with the numbers of the file, when it has another dimension, or for a coordinate that is not finite, an element
// that is given twice, names a node twice, is inverted or has no volume, and a node that belongs to no element.
template <int Dim>
SimplexMesh<Dim> simplex_mesh_of(const MeshFile& file, std::string_view path);

// Triangles in space, each with its corners anticlockwise as seen from outside where the file has them so.
struct TriangleSurface {
    Points<3> points;  // m
    Eigen::Matrix<int, 3, Eigen::Dynamic> triangles;
    std::map<std::string, std::vector<Index>, std::less<>> sets{};  // of triangles, by their names
};
// The triangles of a file without tetrahedra, or the boundary of its tetrahedra. Quadratic triangles give their corners; points
// that belong to no triangle are left out. Throws Refused, with the numbers of the file, where there is none, for a triangle that
// names a point twice, and as simplex_mesh_of.
TriangleSurface surface_of(const MeshFile& file, std::string_view path);

// Throws Refused, with the groups that there are, unless each of these is a group of facets that all lie on the boundary.
template <int Dim>
void require_facet_groups(const SimplexMesh<Dim>& mesh, std::initializer_list<std::string_view> names, std::string_view path);

}  // namespace pliant
