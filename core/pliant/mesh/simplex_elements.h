// Finite elements of first or second order on a mesh of simplices: which nodes each has, its shape functions, and their gradients
// at the points where it is integrated [Hughes2000 §3]. Edges are straight at rest.
#pragma once
#include <pliant/mesh/simplex_mesh.h>

#include <array>
#include <utility>

namespace pliant {

// Edges of a simplex by its corners, in the order in which Gmsh numbers their middles. Of a triangle the first three.
inline constexpr std::array<std::pair<int, int>, 6> simplex_edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};

// Nodes of a simplex: its corners, and for the second order the middles of its edges behind them.
constexpr int simplex_nodes(int dimension, int order) {
    return order == 1 ? dimension + 1 : (dimension + 1) * (dimension + 2) / 2;
}

// Shape functions at barycentric coordinates; they sum to 1. Corner a: λ_a, and for the second order λ_a (2 λ_a - 1); the middle
// of an edge: 4 λ_a λ_b. Of elements, and with Dim - 1 of their facets.
template <int Dim, int Order>
Vec<simplex_nodes(Dim, Order)> simplex_shape(const Vec<Dim + 1>& barycentric) {
    if constexpr (Order == 1) {
        return barycentric;
    } else {
        Vec<simplex_nodes(Dim, Order)> values;
        for (int a = 0; a <= Dim; ++a) values[a] = barycentric[a] * (2 * barycentric[a] - 1);
        for (int k = 0; k < simplex_nodes(Dim, Order) - (Dim + 1); ++k) {
            const auto [a, b] = simplex_edges[static_cast<std::size_t>(k)];
            values[Dim + 1 + k] = 4 * barycentric[a] * barycentric[b];
        }
        return values;
    }
}

template <int Dim, int Order>
class SimplexElements {
    static_assert(Order == 1 || Order == 2);

public:
    static constexpr int corners = Dim + 1, nodes = simplex_nodes(Dim, Order), facet_nodes = simplex_nodes(Dim - 1, Order);
    // Points of integration, of equal weight: enough for the stiffness of the linear model.
    static constexpr int points = Order == 1 ? 1 : Dim + 1;
    using Nodes = Eigen::Matrix<int, nodes, Eigen::Dynamic>;             // node numbers, one column per element
    using FacetNodes = Eigen::Matrix<int, facet_nodes, Eigen::Dynamic>;  // node numbers, one column per boundary facet
    using Gradients = Eigen::Matrix<Real, Dim, nodes>;                   // one column per node, 1/m
    using Values = Eigen::Matrix<Real, nodes, 1>;

    // The mesh outlives this. Its nodes come first and keep their numbers.
    explicit SimplexElements(const SimplexMesh<Dim>& mesh);

    const SimplexMesh<Dim>& mesh() const { return *mesh_; }
    Index element_count() const { return mesh_->simplex_count(); }
    Index node_count() const { return positions_.cols(); }
    const Points<Dim>& positions() const { return positions_; }  // m, at rest
    const Nodes& elements() const { return elements_; }
    const FacetNodes& facets() const { return facets_; }  // corners, then middles of edges
    // All nodes of the boundary facets of that name, ascending. Throws Refused as SimplexMesh::facets does.
    std::vector<Index> nodes_of_facets(std::string_view name) const;

    // What a point of integration stands for, m^Dim.
    Real weight(Index element) const { return mesh_->volumes()[element] / points; }
    Gradients gradients(Index element, int point) const;
    // Of a field with these values (Dim × nodes): H(i, j) = d(values_i)/dX_j.
    Mat<Dim> field_gradient(Index element, int point, const Points<Dim>& values) const;

    static Values shape(const Vec<Dim + 1>& barycentric) { return simplex_shape<Dim, Order>(barycentric); }
    // Gradients of the shape functions there, from those of the corners' linear ones.
    static Gradients gradients_at(const typename SimplexMesh<Dim>::Gradients& of_corners, const Vec<Dim + 1>& barycentric);
    // Integral of the products of two shape functions over the volume: the mass of an element of mass 1.
    static const Mat<nodes>& unit_mass();
    // Share of each node in the mass of an element: the diagonal of unit_mass() scaled to sum to 1, since the sums of its rows
    // are not positive for every element [Hinton1976].
    static Values lumped_shares();

private:
    void number_edges();

    const SimplexMesh<Dim>* mesh_;
    Points<Dim> positions_;
    Nodes elements_;
    FacetNodes facets_;
};

}  // namespace pliant
