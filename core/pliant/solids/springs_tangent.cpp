#include <pliant/math/error.h>
#include <pliant/solids/springs_tangent.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

Real entry(const SymmetricBlock& b, Index r, Index c) {
    const std::array<Real, 9> whole{b.xx, b.xy, b.xz, b.xy, b.yy, b.yz, b.xz, b.yz, b.zz};
    return whole[static_cast<std::size_t>(3 * r + c)];
}

void add(const SymmetricBlock& b, Real factor, SymmetricBlock& to) {
    to.xx += factor * b.xx, to.xy += factor * b.xy, to.xz += factor * b.xz;
    to.yy += factor * b.yy, to.yz += factor * b.yz, to.zz += factor * b.zz;
}

// v v^T
SymmetricBlock square(const Vec<3>& v) { return {v[0] * v[0], v[0] * v[1], v[0] * v[2], v[1] * v[1], v[1] * v[2], v[2] * v[2]}; }

constexpr SymmetricBlock identity{1, 0, 0, 1, 0, 1};

}  // namespace

SpringTangent::SpringTangent(const Springs& springs) : springs_(springs), blocks_(static_cast<std::size_t>(springs.size())) {
    for (auto* blocks : {&own_, &whole_, &inverse_}) blocks->resize(static_cast<std::size_t>(springs.node_count()));
}

void SpringTangent::set_sheet(Index nodes_x, Index nodes_y) {
    if (nodes_x * nodes_y != springs_.node_count())
        throw Refused(fmt::format("a sheet of {} by {} nodes was given for springs between {} nodes", nodes_x, nodes_y,
                                  springs_.node_count()));
    levels_.emplace(nodes_x, nodes_y);
    beginning_.resize(own_.size());
    cells_squared_.resize(springs_.size());
    for (Index s = 0; s < springs_.size(); ++s) {
        const Index i = springs_.i(s), j = springs_.j(s);
        const Index dx = j % nodes_x - i % nodes_x, dy = j / nodes_x - i / nodes_x;
        cells_squared_[s] = Real(dx * dx + dy * dy);
    }
}

void SpringTangent::add_at_node(Index node, const Mat<3>& m) {
    add({m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)}, 1, own_[static_cast<std::size_t>(node)]);
}

void SpringTangent::fill(PointsIn<3> x, PointsIn<3> start, SpringDamping mode, Real velocity_rate) {
    std::ranges::fill(own_, SymmetricBlock{});
    for (Index s = 0; s < springs_.size(); ++s) {
        const Index i = springs_.i(s), j = springs_.j(s);
        const Vec<3> x_ij = x.col(j) - x.col(i);
        const Real length = x_ij.norm(), rest = springs_.rest_length()[s], k = springs_.stiffness()[s];
        const Real across = rest == 0 ? k : length > rest ? k * (1 - rest / length) : 0;
        SymmetricBlock b;
        if (across > 0) add(identity, across, b);
        if (length > 0) add(square(x_ij), (k - across) / (length * length), b);
        const Real damping = velocity_rate * springs_.damping()[s];
        if (mode == SpringDamping::naive) add(identity, damping, b);
        if (mode == SpringDamping::projected) {
            const Vec<3> direction = start.col(j) - start.col(i);
            const Real squared = direction.squaredNorm();
            if (squared > 0) add(square(direction), damping / squared, b);
        }
        blocks_[static_cast<std::size_t>(s)] = b;
    }
}

void SpringTangent::prepare() {
    whole_ = own_;
    std::ranges::fill(beginning_, SymmetricBlock{});
    for (Index s = 0; s < springs_.size(); ++s) {
        const SymmetricBlock& b = blocks_[static_cast<std::size_t>(s)];
        const auto i = static_cast<std::size_t>(springs_.i(s));
        add(b, 1, whole_[i]);
        add(b, 1, whole_[static_cast<std::size_t>(springs_.j(s))]);
        if (levels_) add(b, cells_squared_[s], beginning_[i]);
    }
    for (std::size_t n = 0; n < whole_.size(); ++n) {
        if (invert(whole_[n], inverse_[n])) continue;
        Failure failure;
        failure.index = static_cast<Index>(n);
        failure.what = fmt::format("the stiffness and inertia of node {} are not positive definite to rounding", n);
        throw Diverged(failure);
    }
    if (levels_) levels_->prepare(beginning_, own_);
}

void SpringTangent::multiply(const VecX& d, VecX& Hd) const {
    const Real* in = d.data();
    Real* out = Hd.data();
    Hd.setZero();
    for (std::size_t n = 0; n < own_.size(); ++n) add_product(own_[n], in + 3 * n, out + 3 * n);
    const auto* nodes = springs_.nodes();
    for (std::size_t s = 0; s < blocks_.size(); ++s) {
        const std::size_t i = 3 * static_cast<std::size_t>(nodes[s][0]), j = 3 * static_cast<std::size_t>(nodes[s][1]);
        const SymmetricBlock& b = blocks_[s];
        const Real x = in[j] - in[i], y = in[j + 1] - in[i + 1], z = in[j + 2] - in[i + 2];
        const Real fx = b.xx * x + b.xy * y + b.xz * z, fy = b.xy * x + b.yy * y + b.yz * z, fz = b.xz * x + b.yz * y + b.zz * z;
        out[i] -= fx, out[i + 1] -= fy, out[i + 2] -= fz;
        out[j] += fx, out[j + 1] += fy, out[j + 2] += fz;
    }
}

void SpringTangent::precondition(const VecX& r, VecX& z) const {
    z.setZero();
    for (std::size_t n = 0; n < inverse_.size(); ++n) add_product(inverse_[n], r.data() + 3 * n, z.data() + 3 * n);
    if (levels_) levels_->add_corrections(r, z);
}

Real SpringTangent::diagonal(Index dof) const { return entry(whole_[static_cast<std::size_t>(dof / 3)], dof % 3, dof % 3); }

std::vector<std::pair<Index, Real>> SpringTangent::row(Index dof) const {
    const Index node = dof / 3, r = dof % 3;
    std::vector<std::pair<Index, Real>> entries;
    for (Index c = 0; c < 3; ++c)
        if (c != r) entries.emplace_back(3 * node + c, entry(whole_[static_cast<std::size_t>(node)], r, c));
    for (Index s = 0; s < springs_.size(); ++s) {
        if (springs_.i(s) != node && springs_.j(s) != node) continue;
        const Index other = springs_.i(s) == node ? springs_.j(s) : springs_.i(s);
        for (Index c = 0; c < 3; ++c) entries.emplace_back(3 * other + c, -entry(blocks_[static_cast<std::size_t>(s)], r, c));
    }
    return entries;
}

}  // namespace pliant
