#include <pliant/math/element_assembly.h>
#include <pliant/math/error.h>

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace pliant {
namespace {

// Neighbours of each node, itself included, ascending; those of node b are at begin[b] to begin[b + 1].
struct Neighbours {
    std::vector<int> begin, node;
};

template <class Elements>
Neighbours find_neighbours(const Elements& elements, Index node_count) {
    // Elements of each node.
    std::vector<int> begin(static_cast<std::size_t>(node_count) + 1, 0), list(static_cast<std::size_t>(elements.size()));
    for (Index i = 0; i < elements.size(); ++i) ++begin[static_cast<std::size_t>(elements.data()[i]) + 1];
    for (std::size_t n = 1; n < begin.size(); ++n) begin[n] += begin[n - 1];
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (Index e = 0; e < elements.cols(); ++e)
        for (Index a = 0; a < elements.rows(); ++a)
            list[static_cast<std::size_t>(next[static_cast<std::size_t>(elements(a, e))]++)] = static_cast<int>(e);

    // Their nodes, each once.
    Neighbours found;
    std::vector<int> near;
    for (std::size_t n = 0; n + 1 < begin.size(); ++n) {
        near.clear();
        for (int i = begin[n]; i < begin[n + 1]; ++i)
            for (Index a = 0; a < elements.rows(); ++a) near.push_back(elements(a, list[static_cast<std::size_t>(i)]));
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        found.begin.push_back(static_cast<int>(found.node.size()));
        found.node.insert(found.node.end(), near.begin(), near.end());
    }
    found.begin.push_back(static_cast<int>(found.node.size()));
    return found;
}

}  // namespace

template <int Dim, int Nodes>
ElementAssembly<Dim, Nodes>::ElementAssembly(const Elements& elements, Index node_count) : elements_(elements) {
    const Neighbours near = find_neighbours(elements, node_count);
    const Real entries = static_cast<Real>(near.node.size()) * Dim * Dim;
    if (entries > std::numeric_limits<int>::max())
        throw Refused(
            fmt::format("a sparse matrix of {} entries is too large: at most {}", entries, std::numeric_limits<int>::max()));

    // Every column of a node holds Dim entries for each of its neighbours.
    pattern_.resize(Dim * node_count, Dim * node_count);
    pattern_.resizeNonZeros(static_cast<Index>(entries));
    int* column = pattern_.outerIndexPtr();
    int* row = pattern_.innerIndexPtr();
    for (Index b = 0; b < node_count; ++b) {
        const int begin = near.begin[static_cast<std::size_t>(b)], end = near.begin[static_cast<std::size_t>(b) + 1];
        first_.push_back(Dim * Dim * begin);
        for (int l = 0; l < Dim; ++l) {
            *column++ = Dim * Dim * begin + l * Dim * (end - begin);
            for (int i = begin; i < end; ++i)
                for (int k = 0; k < Dim; ++k) *row++ = Dim * near.node[static_cast<std::size_t>(i)] + k;
        }
    }
    *column = static_cast<int>(entries);
    std::fill_n(pattern_.valuePtr(), static_cast<std::size_t>(entries), 0.0);

    // Where the blocks of each element go.
    rank_.reserve(static_cast<std::size_t>(elements.cols()) * Nodes * Nodes);
    for (Index e = 0; e < elements.cols(); ++e)
        for (int b = 0; b < Nodes; ++b) {
            const auto column_node = static_cast<std::size_t>(elements(b, e));
            const auto begin = near.node.begin() + near.begin[column_node], end = near.node.begin() + near.begin[column_node + 1];
            for (int a = 0; a < Nodes; ++a)
                rank_.push_back(static_cast<int>(std::lower_bound(begin, end, elements(a, e)) - begin));
        }
}

template <int Dim, int Nodes>
void ElementAssembly<Dim, Nodes>::add(Index element, const Local& local, SparseMatrix& matrix, Index first, Index last) const {
    const int* rank = rank_.data() + element * Nodes * Nodes;
    const int* columns = matrix.outerIndexPtr();
    for (int b = 0; b < Nodes; ++b) {
        const int node = elements_(b, element);
        if (node < first || node >= last) continue;
        Real* values = matrix.valuePtr() + first_[static_cast<std::size_t>(node)];
        const int stride = columns[Dim * node + 1] - columns[Dim * node];
        for (int l = 0; l < Dim; ++l, values += stride)
            for (int a = 0; a < Nodes; ++a)
                for (int k = 0; k < Dim; ++k) values[Dim * rank[b * Nodes + a] + k] += local(Dim * a + k, Dim * b + l);
    }
}

template class ElementAssembly<1, 3>;
template class ElementAssembly<1, 4>;
template class ElementAssembly<2, 3>;
template class ElementAssembly<2, 6>;
template class ElementAssembly<3, 4>;
template class ElementAssembly<3, 10>;

}  // namespace pliant
