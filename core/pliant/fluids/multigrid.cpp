#include <pliant/fluids/multigrid.h>
#include <pliant/math/parallel.h>

#include <algorithm>

namespace pliant {
namespace {

constexpr int coarsest_sweeps = 8;  // up and down, on a grid of at most two cells along each axis

template <int Dim>
bool coarsest(const Lattice<Dim>& cells) {
    return *std::max_element(cells.count.begin(), cells.count.end()) <= 2;
}

// Can the next coarser grid do with one weight for all faces?
template <int Dim>
bool halves_evenly(const Lattice<Dim>& cells) {
    return std::all_of(cells.count.begin(), cells.count.end(), [](Index n) { return n == 1 || n % 2 == 0; });
}

template <int Dim>
Real uniform_weight(const Lattice<Dim>& finest, const Lattice<Dim>& cells) {
    // Area of a face over the distance of the centres: the coarsening factors of the axes, all equal where there is a face.
    Real weight = 1, longest = 1;
    for (int a = 0; a < Dim; ++a) {
        const Real factor = static_cast<Real>(finest.count[a]) / static_cast<Real>(cells.count[a]);
        weight *= factor;
        longest = std::max(longest, factor);
    }
    return weight / (longest * longest);
}

template <int Dim>
LowFaceWeights<Dim> uniform_weights(const Lattice<Dim>& cells, Real weight) {
    LowFaceWeights<Dim> weights;
    for (int a = 0; a < Dim; ++a) {
        weights[a] = VecX::Constant(cells.size(), weight);
        for (Index c = 0; c < cells.size(); ++c)
            if (cells.neighbour(cells.coordinates(c), a, -1) < 0) weights[a][c] = 0;
    }
    return weights;
}

template <int Dim>
LowFaceWeights<Dim> coarsened_weights(const Lattice<Dim>& fine, const LowFaceWeights<Dim>& weights) {
    const Lattice<Dim> coarse = coarsened(fine);
    LowFaceWeights<Dim> sums;
    for (int a = 0; a < Dim; ++a) {
        const Index factor = fine.count[a] > 1 ? 2 : 1;
        sums[a] = VecX::Zero(coarse.size());
        for (Index c = 0; c < fine.size(); ++c) {
            Counts<Dim> at = fine.coordinates(c);
            if (at[a] % factor != 0) continue;  // inside a coarse cell
            for (int b = 0; b < Dim; ++b) at[b] /= fine.count[b] > 1 ? 2 : 1;
            sums[a][coarse.index(at)] += weights[a][c] / static_cast<Real>(factor);
        }
    }
    return sums;
}

// The surface is farther from the centre of a coarse cell than from that of a fine one, by half a fine cell. half: that way over
// the area of a fine face, in units of the finest level.
template <int Dim>
VecX coarsened_surface(const Lattice<Dim>& fine, const VecX& weights, Real half) {
    if (weights.size() == 0) return {};
    const Lattice<Dim> coarse = coarsened(fine);
    VecX sums = VecX::Zero(coarse.size());
    for (Index c = 0; c < fine.size(); ++c) {
        Counts<Dim> at = fine.coordinates(c);
        for (int b = 0; b < Dim; ++b) at[b] /= fine.count[b] > 1 ? 2 : 1;
        sums[coarse.index(at)] += weights[c] / (1 + half * weights[c]);
    }
    return sums;
}

}  // namespace

template <int Dim>
Multigrid<Dim>::Multigrid(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions) {
    const Lattice<Dim> finest = grid.cells();
    Lattice<Dim> cells = finest;

    // Levels with one weight for all faces: down to where an odd number of cells leaves a coarse cell half filled.
    bool uniform = !grid.has_gaps(), done = false;
    while (uniform && !done) {
        add_level(cells, std::make_unique<UniformPoisson<Dim>>(cells, uniform_weight(finest, cells)));
        uniform = halves_evenly(cells);
        done = coarsest(cells);
        if (uniform) cells = coarsened(cells);
    }
    if (done) return;

    // The levels below, or all of them if there are solid cells.
    LowFaceWeights<Dim> weights = open_faces(grid);
    if (!grid.has_gaps()) {
        weights = coarsened_weights(cells, uniform_weights(cells, uniform_weight(finest, cells)));
        cells = coarsened(cells);
    }
    VecX surface = surface_weights(grid, fractions);
    Real half = 0.5;
    const VecX* fine_diagonal = nullptr;
    for (;; cells = coarsened(cells)) {
        LowFaceWeights<Dim> coarse_weights = coarsened_weights(cells, weights);
        VecX coarse_surface = coarsened_surface(cells, surface, half);
        if (Dim == 3) half /= 2;
        auto op = std::make_unique<WeightedPoisson<Dim>>(cells, std::move(weights), std::move(surface));
        const VecX& diagonal = op->diagonal();
        if (fine_diagonal) share_among_active(levels_.back(), *fine_diagonal, diagonal);
        fine_diagonal = &diagonal;
        add_level(cells, std::move(op));
        if (coarsest(cells)) return;
        weights = std::move(coarse_weights);
        surface = std::move(coarse_surface);
    }
}

template <int Dim>
void Multigrid<Dim>::add_level(const Lattice<Dim>& cells, std::unique_ptr<PoissonOperator<Dim>> op) {
    Level level;
    level.cells = cells;
    level.op = std::move(op);
    if (!coarsest(cells)) level.transfer = std::make_unique<GridTransfer<Dim>>(cells);
    level.r = VecX::Zero(cells.size());
    level.b = level.x = VecX::Zero(levels_.empty() ? 0 : cells.size());
    levels_.push_back(std::move(level));
}

// Inactive coarse cells hold 0: a fine cell's share makes up for their part in the interpolation.
template <int Dim>
void Multigrid<Dim>::share_among_active(Level& fine, const VecX& fine_diagonal, const VecX& coarse_diagonal) {
    if ((fine_diagonal.array() > 0).all() && (coarse_diagonal.array() > 0).all()) return;
    const VecX active = (coarse_diagonal.array() > 0).template cast<Real>().matrix();
    fine.share = VecX::Zero(fine.cells.size());
    fine.transfer->add_interpolated(active, fine.share);
    for (Index c = 0; c < fine.share.size(); ++c)
        fine.share[c] = fine_diagonal[c] > 0 && fine.share[c] > 0 ? 1 / fine.share[c] : 0;
}

template <int Dim>
void Multigrid<Dim>::precondition(const VecX& r, VecX& z) {
    z.resize(r.size());
    cycle(0, r, z);
}

template <int Dim>
void Multigrid<Dim>::cycle(std::size_t l, const VecX& b, VecX& x) {
    Level& level = levels_[l];
    parallel_parts(x.size(), 1, [&](Index first, Index last, int) { x.segment(first, last - first).setZero(); });
    if (!level.transfer) {
        for (int k = 0; k < coarsest_sweeps; ++k) level.op->relax(b, x, SweepOrder::forward);
        for (int k = 0; k < coarsest_sweeps; ++k) level.op->relax(b, x, SweepOrder::backward);
        return;
    }
    level.op->relax(b, x, SweepOrder::forward);
    level.op->residual(b, x, level.r);
    Level& coarse = levels_[l + 1];
    const bool shared = level.share.size() > 0;
    if (shared) level.r.array() *= level.share.array();
    level.transfer->restrict_to(level.r, coarse.b);
    cycle(l + 1, coarse.b, coarse.x);
    if (shared) {
        level.r.setZero();
        level.transfer->add_interpolated(coarse.x, level.r);
        x.array() += level.share.array() * level.r.array();
    } else {
        level.transfer->add_interpolated(coarse.x, x);
    }
    level.op->relax(b, x, SweepOrder::backward);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace pliant
