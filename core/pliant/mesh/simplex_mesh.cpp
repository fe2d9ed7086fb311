#include <pliant/math/error.h>
#include <pliant/mesh/simplex_mesh.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pliant {
namespace {

// Below this share of (longest edge)^Dim a volume is rounding, not a volume.
constexpr Real smallest_relative_volume = 1e-14;

constexpr int factorial(int n) { return n <= 1 ? 1 : n * factorial(n - 1); }

std::size_t number_of(const std::vector<std::size_t>& numbers, Index i) {
    return numbers.empty() ? static_cast<std::size_t>(i) : numbers[static_cast<std::size_t>(i)];
}

template <class Nodes>
std::string node_list(const MeshNumbers& numbers, const Nodes& nodes) {
    std::vector<std::size_t> named;
    for (const int n : nodes) named.push_back(number_of(numbers.nodes, n));
    return fmt::format("{}", fmt::join(named, ", "));
}

template <int Dim>
Real longest_edge(const Points<Dim>& points, const Eigen::Matrix<int, Dim + 1, 1>& corners) {
    Real longest = 0;
    for (int a = 0; a <= Dim; ++a)
        for (int b = 0; b < a; ++b) longest = std::max(longest, (points.col(corners[a]) - points.col(corners[b])).norm());
    return longest;
}

// Columns: edges from corner 0 to the others.
template <int Dim>
Mat<Dim> edge_matrix(const Points<Dim>& points, const Eigen::Matrix<int, Dim + 1, 1>& corners) {
    Mat<Dim> edges;
    for (int a = 0; a < Dim; ++a) edges.col(a) = points.col(corners[a + 1]) - points.col(corners[0]);
    return edges;
}

// A facet of a simplex: its nodes as numbered (outward), and sorted, to find the neighbour that shares it.
template <int Dim>
struct FacetOfSimplex {
    std::array<int, Dim> sorted, outward;
    int simplex, opposite;
    bool operator<(const FacetOfSimplex& other) const {
        return sorted != other.sorted ? sorted < other.sorted : simplex < other.simplex;
    }
};

template <int Dim>
FacetOfSimplex<Dim> facet_opposite(const Eigen::Matrix<int, Dim + 1, 1>& corners, int opposite, int simplex) {
    FacetOfSimplex<Dim> facet{};
    facet.simplex = simplex;
    facet.opposite = opposite;
    int count = 0;
    for (int a = 0; a <= Dim; ++a)
        if (a != opposite) facet.outward[static_cast<std::size_t>(count++)] = corners[a];
    facet.sorted = facet.outward;
    std::sort(facet.sorted.begin(), facet.sorted.end());
    return facet;
}

template <class Sets>
const std::vector<Index>& find_set(const Sets& sets, std::string_view kind, std::string_view name) {
    const auto found = sets.find(name);
    if (found != sets.end()) return found->second;
    std::vector<std::string_view> known;
    for (const auto& [key, set] : sets) known.push_back(key);
    throw Refused(fmt::format("the mesh has no {} set '{}'; it has: {}", kind, name,
                              known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

std::vector<Index> checked_set(std::string_view kind, const std::string& name, std::vector<Index> members, Index count) {
    for (const Index i : members)
        if (i < 0 || i >= count)
            throw Refused(
                fmt::format("{} set '{}' names {} {}, but the mesh has {} of them, counted from 0", kind, name, kind, i, count));
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
}

}  // namespace

template <int Dim>
SimplexMesh<Dim>::SimplexMesh(Points<Dim> points, Simplices simplices, const MeshNumbers& numbers)
    : points_(std::move(points)), simplices_(std::move(simplices)) {
    check_nodes(numbers);
    measure(numbers);
    collect_boundary(numbers);
}

template <int Dim>
void SimplexMesh<Dim>::check_nodes(const MeshNumbers& numbers) const {
    for (Index n = 0; n < node_count(); ++n)
        if (!points_.col(n).allFinite())
            throw Refused(
                fmt::format("node {} of the mesh has a coordinate that is not a finite number", number_of(numbers.nodes, n)));

    std::vector<char> used(static_cast<std::size_t>(node_count()), 0);
    for (Index e = 0; e < simplex_count(); ++e) {
        const Eigen::Matrix<int, Dim + 1, 1> corners = simplices_.col(e);
        for (int a = 0; a <= Dim; ++a) {
            if (corners[a] < 0 || corners[a] >= node_count())
                throw Refused(fmt::format("element {} names node {}, but the mesh has {} nodes, counted from 0",
                                          number_of(numbers.elements, e), corners[a], node_count()));
            if ((corners.array() == corners[a]).count() > 1)
                throw Refused(fmt::format("element {} names node {} twice", number_of(numbers.elements, e),
                                          number_of(numbers.nodes, corners[a])));
            used[static_cast<std::size_t>(corners[a])] = 1;
        }
    }
    for (Index n = 0; n < node_count(); ++n)
        if (!used[static_cast<std::size_t>(n)])
            throw Refused(fmt::format("node {} of the mesh belongs to no element", number_of(numbers.nodes, n)));
}

template <int Dim>
void SimplexMesh<Dim>::measure(const MeshNumbers& numbers) {
    volumes_.resize(simplex_count());
    gradients_.resize(Dim, simplex_count() * (Dim + 1));
    for (Index e = 0; e < simplex_count(); ++e) {
        const Eigen::Matrix<int, Dim + 1, 1> corners = simplices_.col(e);
        const Mat<Dim> edges = edge_matrix<Dim>(points_, corners);
        const Real volume = edges.determinant() / factorial(Dim);
        const Real scale = std::pow(longest_edge<Dim>(points_, corners), Dim);
        if (!std::isfinite(scale) || !(std::abs(volume) > smallest_relative_volume * scale))
            throw Refused(fmt::format("element {} (nodes {}) is degenerate: its {} is {} m^{}", number_of(numbers.elements, e),
                                      node_list(numbers, corners), Dim == 2 ? "area" : "volume", volume, Dim));
        if (volume < 0)
            throw Refused(fmt::format("element {} (nodes {}) is inverted: its signed {} is {} m^{}; exchange two of its nodes",
                                      number_of(numbers.elements, e), node_list(numbers, corners), Dim == 2 ? "area" : "volume",
                                      volume, Dim));

        // Rows of the inverse are the gradients of corners 1 to Dim; that of corner 0 makes the sum vanish.
        volumes_[e] = volume;
        auto gradients = gradients_.template middleCols<Dim + 1>(e * (Dim + 1));
        gradients.template rightCols<Dim>() = edges.inverse().transpose();
        gradients.col(0) = -gradients.template rightCols<Dim>().rowwise().sum();
    }
}

template <int Dim>
void SimplexMesh<Dim>::collect_boundary(const MeshNumbers& numbers) {
    std::vector<FacetOfSimplex<Dim>> all;
    all.reserve(static_cast<std::size_t>(simplex_count() * (Dim + 1)));
    for (Index e = 0; e < simplex_count(); ++e)
        for (int a = 0; a <= Dim; ++a) all.push_back(facet_opposite<Dim>(simplices_.col(e), a, static_cast<int>(e)));
    std::sort(all.begin(), all.end());
    const auto other_corner = [&](const FacetOfSimplex<Dim>& f) { return simplices_(f.opposite, f.simplex); };

    // Keep the facets that occur once.
    std::vector<FacetOfSimplex<Dim>> boundary;
    for (std::size_t i = 0; i < all.size();) {
        std::size_t next = i + 1;
        while (next < all.size() && all[next].sorted == all[i].sorted) ++next;
        if (next - i > 2)
            throw Refused(fmt::format("elements {}, {} and {} share one facet (nodes {}); at most two may",
                                      number_of(numbers.elements, all[i].simplex),
                                      number_of(numbers.elements, all[i + 1].simplex),
                                      number_of(numbers.elements, all[i + 2].simplex), node_list(numbers, all[i].sorted)));
        if (next - i == 2 && other_corner(all[i]) == other_corner(all[i + 1]))
            throw Refused(fmt::format("elements {} and {} are the same (nodes {})", number_of(numbers.elements, all[i].simplex),
                                      number_of(numbers.elements, all[i + 1].simplex),
                                      node_list(numbers, simplices_.col(all[i].simplex))));
        if (next - i == 1) boundary.push_back(all[i]);
        i = next;
    }
    std::sort(boundary.begin(), boundary.end(), [](const auto& a, const auto& b) {
        return a.simplex != b.simplex ? a.simplex < b.simplex : a.opposite < b.opposite;
    });

    // The gradient of the corner opposite a facet points inward with length 1 / height, and area = Dim volume / height.
    facets_.resize(Dim, static_cast<Index>(boundary.size()));
    facet_areas_.resize(Dim, static_cast<Index>(boundary.size()));
    facet_simplices_.clear();
    for (std::size_t f = 0; f < boundary.size(); ++f) {
        const auto& facet = boundary[f];
        const auto column = static_cast<Index>(f);
        for (int a = 0; a < Dim; ++a) facets_(a, column) = facet.outward[static_cast<std::size_t>(a)];
        // Leaving out an odd corner turns the others round: they would be seen from inside.
        if (facet.opposite % 2 == 1) std::swap(facets_(0, column), facets_(1, column));
        facet_areas_.col(column) = -Dim * volumes_[facet.simplex] * gradients(facet.simplex).col(facet.opposite);
        facet_simplices_.push_back(facet.simplex);
    }
}

template <int Dim>
Mat<Dim> SimplexMesh<Dim>::field_gradient(Index simplex, const Points<Dim>& values) const {
    const auto g = gradients(simplex);
    Mat<Dim> gradient = values.col(simplices_(0, simplex)) * g.col(0).transpose();
    for (int a = 1; a <= Dim; ++a) gradient.noalias() += values.col(simplices_(a, simplex)) * g.col(a).transpose();
    return gradient;
}

template <int Dim>
void SimplexMesh<Dim>::name_nodes(const std::string& name, Set nodes) {
    node_sets_[name] = checked_set("node", name, std::move(nodes), node_count());
}

template <int Dim>
void SimplexMesh<Dim>::name_facets(const std::string& name, Set facets) {
    facet_sets_[name] = checked_set("facet", name, std::move(facets), facet_count());
}

template <int Dim>
const typename SimplexMesh<Dim>::Set& SimplexMesh<Dim>::nodes(std::string_view name) const {
    return find_set(node_sets_, "node", name);
}

template <int Dim>
const typename SimplexMesh<Dim>::Set& SimplexMesh<Dim>::facets(std::string_view name) const {
    return find_set(facet_sets_, "facet", name);
}

template <int Dim>
SimplexMesh<Dim> SimplexMesh<Dim>::with_points(Points<Dim> points) const {
    SimplexMesh other(std::move(points), simplices_);
    other.node_sets_ = node_sets_;
    other.facet_sets_ = facet_sets_;
    return other;
}

template <int Dim>
std::vector<int> SimplexMesh<Dim>::connected_parts() const {
    // Union of sets: every node points towards the smallest node of its part.
    std::vector<int> parent(static_cast<std::size_t>(node_count()));
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int node) {
        while (parent[static_cast<std::size_t>(node)] != node) {
            auto& up = parent[static_cast<std::size_t>(node)];
            up = parent[static_cast<std::size_t>(up)];
            node = up;
        }
        return node;
    };
    for (Index e = 0; e < simplex_count(); ++e)
        for (int a = 1; a <= Dim; ++a) {
            const auto [low, high] = std::minmax({root(simplices_(0, e)), root(simplices_(a, e))});
            parent[static_cast<std::size_t>(high)] = low;
        }

    // Number the parts in the order of their first simplex.
    std::vector<int> number(static_cast<std::size_t>(node_count()), -1), parts;
    int count = 0;
    for (Index e = 0; e < simplex_count(); ++e) {
        int& part = number[static_cast<std::size_t>(root(simplices_(0, e)))];
        if (part < 0) part = count++;
        parts.push_back(part);
    }
    return parts;
}

template class SimplexMesh<2>;
template class SimplexMesh<3>;

}  // namespace pliant
