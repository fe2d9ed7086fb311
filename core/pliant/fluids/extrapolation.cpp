#include <pliant/fluids/extrapolation.h>

namespace pliant {
namespace {

// Calls body(neighbour) for the neighbours of a sample.
template <int Dim, class Body>
void for_each_neighbour(const Lattice<Dim>& lattice, Index sample, Body&& body) {
    const Counts<Dim> at = lattice.coordinates(sample);
    for (int k = 0; k < 2 * Dim; ++k) {
        const Index n = lattice.neighbour(at, k / 2, k % 2 == 0 ? -1 : 1);
        if (n >= 0) body(n);
    }
}

}  // namespace

template <int Dim>
void Extrapolation<Dim>::fill(const Lattice<Dim>& lattice, std::vector<Known>& known, VecX& values) {
    layers_.resize(known.size());
    for (std::size_t s = 0; s < known.size(); ++s) layers_[s] = known[s] == Known::yes ? 0 : -1;
    layer_.clear();
    int number = 1;
    const auto queue_around = [&](Index sample, std::vector<Index>& layer) {
        for_each_neighbour(lattice, sample, [&](Index n) {
            if (known[n] != Known::no || layers_[n] >= 0) return;
            layers_[n] = number;
            layer.push_back(n);
        });
    };
    for (Index s = 0; s < lattice.size(); ++s)
        if (known[s] == Known::yes) queue_around(s, layer_);

    for (; !layer_.empty(); layer_.swap(next_)) {
        means_.clear();
        for (const Index s : layer_) {
            Real sum = 0;
            int count = 0;
            for_each_neighbour(lattice, s, [&](Index n) {
                if (known[n] == Known::yes) sum += values[n], ++count;
            });
            means_.push_back(sum / count);
        }
        for (std::size_t k = 0; k < layer_.size(); ++k) {
            values[layer_[k]] = means_[k];
            known[layer_[k]] = Known::yes;
        }
        ++number;
        next_.clear();
        for (const Index s : layer_) queue_around(s, next_);
    }
}

template <int Dim>
void VelocityExtrapolation<Dim>::extrapolate(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity) {
    for (int a = 0; a < Dim; ++a) {
        known_.assign(static_cast<std::size_t>(grid.faces(a).size()), Known::yes);
        const std::vector<Index>& closed = grid.closed_faces(a);
        for (std::size_t k = 0; k < closed.size(); ++k) {
            if (grid.fluid_beside_closed(a)[k] > 0) continue;
            known_[closed[k]] = grid.prescribed(a, closed[k]) ? Known::aside : Known::no;
        }
        components_[a].fill(grid.faces(a), known_, velocity[a]);
        for (std::size_t f = 0; f < known_.size(); ++f)
            if (known_[f] == Known::no) velocity[a][static_cast<Index>(f)] = 0;
    }
}

template class Extrapolation<2>;
template class Extrapolation<3>;
template class VelocityExtrapolation<2>;
template class VelocityExtrapolation<3>;

}  // namespace pliant
