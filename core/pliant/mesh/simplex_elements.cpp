#include <pliant/mesh/simplex_elements.h>
#include <pliant/mesh/simplex_quadrature.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pliant {
namespace {

constexpr int edge_count(int corners) { return corners * (corners - 1) / 2; }

// Barycentric coordinates of point q of the rule of degree 2 with a point near each corner [Zienkiewicz2013 §6.3].
template <int Dim>
Vec<Dim + 1> near_corner(int q) {
    const Real far = Dim == 2 ? Real{1} / 6 : (5 - std::sqrt(Real{5})) / 20;
    Vec<Dim + 1> barycentric = Vec<Dim + 1>::Constant(far);
    barycentric[q] = 1 - Dim * far;
    return barycentric;
}

template <int Dim>
std::array<Vec<Dim + 1>, Dim + 1> all_near_corners() {
    std::array<Vec<Dim + 1>, Dim + 1> all;
    for (int q = 0; q <= Dim; ++q) all[static_cast<std::size_t>(q)] = near_corner<Dim>(q);
    return all;
}

// Numbers of the middles of edges, in the order in which they are asked for.
class EdgeNumbers {
public:
    explicit EdgeNumbers(Index corner_nodes) : next_(static_cast<int>(corner_nodes)) {}
    int number(int a, int b) {
        const auto key = static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
        const auto [place, is_new] = numbers_.try_emplace(key, next_);
        if (is_new) ends_.emplace_back(a, b), ++next_;
        return place->second;
    }
    const std::vector<std::pair<int, int>>& ends() const { return ends_; }

private:
    int next_;
    std::unordered_map<std::uint64_t, int> numbers_;
    std::vector<std::pair<int, int>> ends_;
};

}  // namespace

template <int Dim, int Order>
SimplexElements<Dim, Order>::SimplexElements(const SimplexMesh<Dim>& mesh) : mesh_(&mesh), positions_(mesh.points()) {
    elements_.resize(nodes, mesh.simplex_count());
    elements_.template topRows<corners>() = mesh.simplices();
    facets_.resize(facet_nodes, mesh.facet_count());
    facets_.template topRows<Dim>() = mesh.facets();
    if constexpr (Order == 2) number_edges();
}

template <int Dim, int Order>
void SimplexElements<Dim, Order>::number_edges() {
    EdgeNumbers edges(mesh_->node_count());
    const auto number_columns = [&](auto& table, int corner_rows) {
        for (Index c = 0; c < table.cols(); ++c)
            for (int k = 0; k < edge_count(corner_rows); ++k) {
                const auto [a, b] = simplex_edges[static_cast<std::size_t>(k)];
                table(corner_rows + k, c) = edges.number(table(a, c), table(b, c));
            }
    };
    number_columns(elements_, corners);
    number_columns(facets_, Dim);
    positions_.conservativeResize(Eigen::NoChange, mesh_->node_count() + static_cast<Index>(edges.ends().size()));
    Index node = mesh_->node_count();
    for (const auto& [a, b] : edges.ends()) positions_.col(node++) = (positions_.col(a) + positions_.col(b)) / 2;
}

template <int Dim, int Order>
std::vector<Index> SimplexElements<Dim, Order>::nodes_of_facets(std::string_view name) const {
    std::vector<Index> found;
    for (const Index f : mesh_->facets(name))
        for (int a = 0; a < facet_nodes; ++a) found.push_back(facets_(a, f));
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

template <int Dim, int Order>
typename SimplexElements<Dim, Order>::Gradients SimplexElements<Dim, Order>::gradients(Index element, int point) const {
    if constexpr (Order == 1) {
        return mesh_->gradients(element);
    } else {
        static const auto at = all_near_corners<Dim>();
        return gradients_at(mesh_->gradients(element), at[static_cast<std::size_t>(point)]);
    }
}

// Corner a: λ_a (2 λ_a - 1), the middle of an edge: 4 λ_a λ_b.
template <int Dim, int Order>
typename SimplexElements<Dim, Order>::Gradients SimplexElements<Dim, Order>::gradients_at(
    const typename SimplexMesh<Dim>::Gradients& g, const Vec<Dim + 1>& l) {
    if constexpr (Order == 1) {
        return g;
    } else {
        Gradients all;
        for (int a = 0; a < corners; ++a) all.col(a) = (4 * l[a] - 1) * g.col(a);
        for (int k = 0; k < nodes - corners; ++k) {
            const auto [a, b] = simplex_edges[static_cast<std::size_t>(k)];
            all.col(corners + k) = 4 * (l[a] * g.col(b) + l[b] * g.col(a));
        }
        return all;
    }
}

template <int Dim, int Order>
Mat<Dim> SimplexElements<Dim, Order>::field_gradient(Index element, int point, const Points<Dim>& values) const {
    const Gradients g = gradients(element, point);
    Mat<Dim> gradient = values.col(elements_(0, element)) * g.col(0).transpose();
    for (int a = 1; a < nodes; ++a) gradient.noalias() += values.col(elements_(a, element)) * g.col(a).transpose();
    return gradient;
}

template <int Dim, int Order>
const Mat<SimplexElements<Dim, Order>::nodes>& SimplexElements<Dim, Order>::unit_mass() {
    static const Mat<nodes> mass = [] {
        const SimplexRule<Dim> rule = simplex_rule<Dim>(2 * Order);
        Mat<nodes> sum = Mat<nodes>::Zero();
        for (Index q = 0; q < rule.weights.size(); ++q) {
            const Values N = shape(rule.barycentric.col(q));
            sum += rule.weights[q] * N * N.transpose();
        }
        return sum;
    }();
    return mass;
}

template <int Dim, int Order>
typename SimplexElements<Dim, Order>::Values SimplexElements<Dim, Order>::lumped_shares() {
    const Values diagonal = unit_mass().diagonal();
    return diagonal / diagonal.sum();
}

template class SimplexElements<2, 1>;
template class SimplexElements<2, 2>;
template class SimplexElements<3, 1>;
template class SimplexElements<3, 2>;

}  // namespace pliant
