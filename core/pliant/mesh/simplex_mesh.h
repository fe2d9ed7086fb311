// Meshes of simplices: triangles in the plane, tetrahedra in space, with what linear finite elements need of the rest shape.
#pragma once
#include <pliant/math/types.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// What nodes and elements are called in messages: the numbers of a file, say. Counted from 0 where empty.
struct MeshNumbers {
    std::vector<std::size_t> nodes{}, elements{};
};

template <int Dim>
class SimplexMesh {
public:
    using Simplices = Eigen::Matrix<int, Dim + 1, Eigen::Dynamic>;  // node numbers, one column per simplex
    using Facets = Eigen::Matrix<int, Dim, Eigen::Dynamic>;         // node numbers, one column per boundary facet
    using Gradients = Eigen::Matrix<Real, Dim, Dim + 1>;            // one column per corner, 1/m
    using Set = std::vector<Index>;                                 // numbers of nodes or of boundary facets, ascending

    // Corners are numbered so that the signed volume is positive: anticlockwise in 2D; in 3D corners 1, 2, 3 anticlockwise when
    // seen from outside the face opposite corner 0. Throws Refused, naming the node or the simplex, when a coordinate is not
    // finite, a node number is out of range or occurs twice in a simplex, a node belongs to no simplex, a simplex is
    // given twice, has no volume or a negative one, or a facet belongs to more than two simplices.
    SimplexMesh(Points<Dim> points, Simplices simplices, const MeshNumbers& numbers = {});

    Index node_count() const { return points_.cols(); }
    Index simplex_count() const { return simplices_.cols(); }
    const Points<Dim>& points() const { return points_; }  // m
    const Simplices& simplices() const { return simplices_; }

    // Length, area or volume of each simplex and of the whole, m^Dim.
    const VecX& volumes() const { return volumes_; }
    Real volume() const { return volumes_.sum(); }
    // Gradients of the linear shape functions of a simplex; they sum to 0.
    auto gradients(Index simplex) const { return gradients_.template middleCols<Dim + 1>(simplex * (Dim + 1)); }
    // Gradient of the linear field with the given values (Dim × nodes) at the nodes: H(i, j) = d(values_i)/dX_j.
    Mat<Dim> field_gradient(Index simplex, const Points<Dim>& values) const;

    // The boundary: facets that belong to one simplex alone, sorted by that simplex; anticlockwise when seen from outside (in 2D:
    // with the inside to their left). Area vectors point outward, m^(Dim-1).
    Index facet_count() const { return facets_.cols(); }
    const Facets& facets() const { return facets_; }
    const Points<Dim>& facet_areas() const { return facet_areas_; }
    Index facet_simplex(Index facet) const { return facet_simplices_[static_cast<std::size_t>(facet)]; }

    // Named sets. Looking up an unknown one throws Refused with the names there are.
    void name_nodes(const std::string& name, Set nodes);
    void name_facets(const std::string& name, Set facets);
    const Set& nodes(std::string_view name) const;
    const Set& facets(std::string_view name) const;
    const std::map<std::string, Set, std::less<>>& node_sets() const { return node_sets_; }
    const std::map<std::string, Set, std::less<>>& facet_sets() const { return facet_sets_; }

    // The same simplices and named sets on other points. Throws Refused as the constructor does.
    SimplexMesh with_points(Points<Dim> points) const;

    // Part of the mesh each simplex belongs to, counted from 0; two simplices with a common node belong to the same part.
    std::vector<int> connected_parts() const;

private:
    void check_nodes(const MeshNumbers& numbers) const;
    void measure(const MeshNumbers& numbers);
    void collect_boundary(const MeshNumbers& numbers);

    Points<Dim> points_;
    Simplices simplices_;
    VecX volumes_;
    Points<Dim> gradients_;
    Facets facets_;
    Points<Dim> facet_areas_;
    std::vector<Index> facet_simplices_;
    std::map<std::string, Set, std::less<>> node_sets_, facet_sets_;
};

}  // namespace pliant
