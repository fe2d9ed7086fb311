#include <pliant/continuum/deformation.h>
#include <pliant/math/error.h>
#include <pliant/math/small_eigen.h>
#include <pliant/mesh/lattice.h>
#include <pliant/solids/elastic_grid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pliant {
namespace {

// Corner k of the cell at `cell`: bit i of k is set on the far side along axis i.
template <int Dim>
std::array<Index, Dim> corner_of(const std::array<Index, Dim>& cell, int k) {
    std::array<Index, Dim> at = cell;
    for (int i = 0; i < Dim; ++i) at[static_cast<std::size_t>(i)] += (k >> i) & 1;
    return at;
}

// All cells of a box, fastest along x.
template <int Dim>
std::vector<std::array<Index, Dim>> cells_of(const std::array<int, Dim>& counts) {
    std::vector<std::array<Index, Dim>> all;
    std::array<Index, Dim> cell{};
    for (;;) {
        all.push_back(cell);
        std::size_t i = 0;
        while (i < Dim && ++cell[i] == counts[i]) cell[i++] = 0;
        if (i == Dim) return all;
    }
}

// Joins numbers into sets; find() gives the least of each.
class Joined {
public:
    explicit Joined(Index count) : first_(static_cast<std::size_t>(count)) { std::iota(first_.begin(), first_.end(), Index{0}); }
    Index find(Index n) {
        while (first_[static_cast<std::size_t>(n)] != n)
            n = first_[static_cast<std::size_t>(n)] = first_[static_cast<std::size_t>(first_[static_cast<std::size_t>(n)])];
        return n;
    }
    void join(Index a, Index b) {
        const Index low = std::min(find(a), find(b)), high = std::max(find(a), find(b));
        first_[static_cast<std::size_t>(high)] = low;
    }

private:
    std::vector<Index> first_;
};

}  // namespace

template <int Dim>
ElasticGrid<Dim>::ElasticGrid(const Cells& cells, Real dx, const Vec<Dim>& origin,
                              const std::function<bool(const Vec<Dim>&)>& inside, Energy energy, const Lame& material)
    : cells_(cells), dx_(dx), density_(energy, material) {
    if (!(dx > 0) || !std::isfinite(dx)) throw Refused("spacing of the grid", dx, "m", "(0, inf)");
    for (const int n : cells)
        if (n < 1) throw Refused("cells of the grid along an axis", n, "", "a whole number from 1 on");
    std::array<Index, Dim> counts;
    std::ranges::copy(cells, counts.begin());
    const NodeLattice<Dim> lattice(counts, Vec<Dim>::Constant(dx), origin);

    std::vector<std::array<Index, Dim>> kept = cells_of<Dim>(cells);
    std::erase_if(kept, [&](const auto& cell) {
        Vec<Dim> centre = origin;
        for (int i = 0; i < Dim; ++i) centre[i] += (static_cast<Real>(cell[static_cast<std::size_t>(i)]) + 0.5) * dx;
        return !inside(centre);
    });
    if (kept.empty()) throw Refused("no cell of the grid lies inside the body; make the grid finer");
    cell_count_ = static_cast<Index>(kept.size());

    // Nodes of these cells, in the order of the lattice.
    node_of_place_.assign(static_cast<std::size_t>(lattice.node_count()), -1);
    for (const auto& cell : kept)
        for (int k = 0; k < corners_of_cell; ++k)
            node_of_place_[static_cast<std::size_t>(lattice.node(corner_of<Dim>(cell, k)))] = 0;
    Index count = 0;
    for (Index& n : node_of_place_)
        if (n == 0) n = count++;
    const Points<Dim> places = lattice.points();
    positions_.resize(Dim, count);
    for (Index p = 0; p < lattice.node_count(); ++p)
        if (const Index n = node_of_place_[static_cast<std::size_t>(p)]; n >= 0) {
            positions_.col(n) = places.col(p);
            Index left = p;
            Cells& place = places_.emplace_back();
            for (std::size_t i = 0; i < Dim; ++i) {
                place[i] = static_cast<int>(left % (cells_[i] + 1));
                left /= cells_[i] + 1;
            }
        }

    // A sample at each corner of each cell.
    volumes_ = VecX::Zero(count);
    corners_.resize(Dim + 1, cell_count_ * corners_of_cell);
    Joined parts(count);
    Index sample = 0;
    for (const auto& cell : kept)
        for (int k = 0; k < corners_of_cell; ++k, ++sample) {
            const auto node = [&](int corner) {
                return node_of_place_[static_cast<std::size_t>(lattice.node(corner_of<Dim>(cell, corner)))];
            };
            corners_(0, sample) = static_cast<int>(node(k));
            for (int i = 0; i < Dim; ++i) corners_(i + 1, sample) = static_cast<int>(node(k ^ (1 << i)));
            volumes_[corners_(0, sample)] += weight();
            parts.join(node(0), node(k));
        }
    assembly_ = std::make_shared<const ElementAssembly<Dim, Dim + 1>>(corners_, count);
    std::vector<Index> part_of(static_cast<std::size_t>(count), -1);
    for (Index n = 0; n < count; ++n) {
        Index& part = part_of[static_cast<std::size_t>(parts.find(n))];
        if (part < 0) part = static_cast<Index>(parts_.size()), parts_.emplace_back();
        parts_[static_cast<std::size_t>(part)].push_back(n);
    }
}

template <int Dim>
Real ElasticGrid<Dim>::spacing_power() const {
    return Dim == 2 ? dx_ * dx_ : dx_ * dx_ * dx_;
}

template <int Dim>
Index ElasticGrid<Dim>::node_at(const Cells& place) const {
    Index number = 0, stride = 1;
    for (std::size_t i = 0; i < Dim; ++i) {
        if (place[i] < 0 || place[i] > cells_[i]) return -1;
        number += stride * place[i], stride *= cells_[i] + 1;
    }
    return node_of_place_[static_cast<std::size_t>(number)];
}

template <int Dim>
Vec<Dim> ElasticGrid<Dim>::signs(int k) {
    Vec<Dim> s;
    for (int i = 0; i < Dim; ++i) s[i] = (k >> i) & 1 ? -1 : 1;
    return s;
}

template <int Dim>
Mat<Dim> ElasticGrid<Dim>::gradient(Index corner, const Points<Dim>& values) const {
    const Vec<Dim> s = signs(static_cast<int>(corner % corners_of_cell)) / dx_;
    Mat<Dim> H;
    for (int i = 0; i < Dim; ++i) H.col(i) = s[i] * (values.col(corners_(i + 1, corner)) - values.col(corners_(0, corner)));
    return H;
}

template <int Dim>
Mat<Dim> ElasticGrid<Dim>::deformation_gradient(Index corner, const Points<Dim>& displacement) const {
    return Mat<Dim>::Identity() + gradient(corner, displacement);
}

template <int Dim>
void ElasticGrid<Dim>::check_support(const DisplacementConstraints<Dim>& constraints) const {
    require_support(positions_, parts_, constraints);
}

template <int Dim>
Real ElasticGrid<Dim>::energy(const Points<Dim>& displacement) const {
    Real sum = 0;
    for (Index c = 0; c < corners_.cols(); ++c) sum += weight() * density_.psi(deformation_gradient(c, displacement));
    return sum;
}

template <int Dim>
void ElasticGrid<Dim>::internal_force(const Points<Dim>& displacement, Points<Dim>& force) const {
    force.setZero(Dim, node_count());
    for (Index c = 0; c < corners_.cols(); ++c) {
        const Vec<Dim> s = signs(static_cast<int>(c % corners_of_cell)) / dx_;
        const Mat<Dim> P = weight() * density_.P(deformation_gradient(c, displacement));
        for (int i = 0; i < Dim; ++i) {
            force.col(corners_(i + 1, c)) += s[i] * P.col(i);
            force.col(corners_(0, c)) -= s[i] * P.col(i);
        }
    }
}

template <int Dim>
void ElasticGrid<Dim>::add_divergence(int axis, const Tensors& stress, Points<Dim>& force_density) const {
    for (Index c = 0; c < corners_.cols(); ++c) {
        const Index here = corners_(0, c), there = corners_(axis + 1, c);
        Vec<Dim> pull;
        for (int i = 0; i < Dim; ++i) pull[i] = weight() / step_of(c, axis) * stress(Dim * i + axis, c);
        force_density.col(here) += pull / volumes_[here];
        force_density.col(there) -= pull / volumes_[there];
    }
}

template <int Dim>
void ElasticGrid<Dim>::stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const {
    std::fill_n(matrix.valuePtr(), static_cast<std::size_t>(matrix.nonZeros()), Real{0});
    for (Index c = 0; c < corners_.cols(); ++c) {
        Mat<Dim* Dim> T = weight() * density_.tangent(deformation_gradient(c, displacement));
        if (definite) T = positive_part<Dim * Dim>(T);
        const Vec<Dim> s = signs(static_cast<int>(c % corners_of_cell)) / dx_;
        // Blocks of neighbours i and j; those of the corner make all rows and columns sum to 0.
        typename ElementAssembly<Dim, Dim + 1>::Local K;
        K.setZero();
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j) {
                const Mat<Dim> block = s[i] * s[j] * T.template block<Dim, Dim>(Dim * i, Dim * j);
                K.template block<Dim, Dim>(Dim * (i + 1), Dim * (j + 1)) = block;
                K.template block<Dim, Dim>(0, Dim * (j + 1)) -= block;
                K.template block<Dim, Dim>(Dim * (i + 1), 0) -= block;
                K.template block<Dim, Dim>(0, 0) += block;
            }
        assembly_->add(c, 0.5 * (K + K.transpose()).eval(), matrix);
    }
}

template <int Dim>
Real ElasticGrid<Dim>::admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const {
    constexpr Real margin = 0.9;
    if (density_.admits(Mat<Dim>::Zero())) return 1;
    Real share = 1;
    for (Index c = 0; c < corners_.cols(); ++c) {
        const Mat<Dim> F = deformation_gradient(c, displacement), dF = gradient(c, change);
        share = std::min(share, margin / ((cofactor<Dim>(F).transpose() * dF).norm() / volume_ratio<Dim>(F)));
    }
    return share;
}

template <int Dim>
Real ElasticGrid<Dim>::stable_time_step(Real density) const {
    const Lame& m = density_.material();
    return dx_ / std::sqrt((m.lambda + 2 * m.mu + (Dim - 1) * m.mu) / density);
}

template class ElasticGrid<2>;
template class ElasticGrid<3>;

}  // namespace pliant
