#include <pliant/solids/sheet_levels.h>

#include <algorithm>
#include <cmath>

namespace pliant {

bool invert(const SymmetricBlock& m, SymmetricBlock& inverse) {
    const Real d0 = m.xx, l10 = m.xy / d0, l20 = m.xz / d0;
    const Real d1 = m.yy - l10 * m.xy, e = m.yz - l10 * m.xz, l21 = e / d1;
    const Real d2 = m.zz - l20 * m.xz - l21 * e;
    if (!(d0 > 0 && d1 > 0 && d2 > 0) || !std::isfinite(d0 + d1 + d2)) return false;
    const Real a = l10 * l21 - l20;  // last row of L^-1: (a, -l21, 1)
    inverse = {
        1 / d0 + l10 * l10 / d1 + a * a / d2, -l10 / d1 - a * l21 / d2, a / d2, 1 / d1 + l21 * l21 / d2, -l21 / d2, 1 / d2};
    return true;
}

SheetLevels::Axis SheetLevels::halved(Index fine) {
    Axis axis{.fine = fine, .coarse = fine / 2 + 1, .left = {}, .weight = {}};
    for (Index i = 0; i < fine; ++i) {
        const Real at = Real(i) * Real(axis.coarse - 1) / Real(fine - 1);
        axis.left.push_back(std::min(static_cast<Index>(at), axis.coarse - 2));
        axis.weight.push_back(at - Real(axis.left.back()));
    }
    return axis;
}

SheetLevels::SheetLevels(Index nodes_x, Index nodes_y) {
    while (nodes_x >= 4 && nodes_y >= 4) {
        Level level{.x = halved(nodes_x),
                    .y = halved(nodes_y),
                    .springs = {},
                    .own = {},
                    .inverse = {},
                    .half = {},
                    .residual = {},
                    .correction = {}};
        nodes_x = level.x.coarse, nodes_y = level.y.coarse;
        const auto nodes = static_cast<std::size_t>(nodes_x * nodes_y);
        for (auto* blocks : {&level.springs, &level.own, &level.inverse}) blocks->resize(nodes);
        for (auto* values : {&level.residual, &level.correction}) values->resize(3 * nodes);
        level.half.resize(3 * static_cast<std::size_t>(nodes_x * level.y.fine));
        half_blocks_.resize(std::max(half_blocks_.size(), 2 * level.half.size()));
        levels_.push_back(std::move(level));
    }
}

// coarse = P^T fine, Count numbers for each node.
template <int Count>
void SheetLevels::restrict_to(const Level& level, const Real* fine, std::vector<Real>& half, Real* coarse) {
    const Index row = Count * level.x.coarse;
    std::fill(half.begin(), half.begin() + row * level.y.fine, Real{0});
    for (Index j = 0; j < level.y.fine; ++j) {
        for (Index i = 0; i < level.x.fine; ++i) {
            const auto at = static_cast<std::size_t>(i);
            Real* to = half.data() + row * j + Count * level.x.left[at];
            const Real *from = fine + Count * (i + level.x.fine * j), w = level.x.weight[at];
            for (int c = 0; c < Count; ++c) to[c] += (1 - w) * from[c], to[c + Count] += w * from[c];
        }
    }
    std::fill(coarse, coarse + row * level.y.coarse, Real{0});
    for (Index j = 0; j < level.y.fine; ++j) {
        const Real w = level.y.weight[static_cast<std::size_t>(j)], *from = half.data() + row * j;
        Real *near = coarse + row * level.y.left[static_cast<std::size_t>(j)], *far = near + row;
        for (Index i = 0; i < row; ++i) near[i] += (1 - w) * from[i], far[i] += w * from[i];
    }
}

// fine += P coarse
void SheetLevels::prolong(const Level& level, const Real* coarse, Real* fine) {
    const Index row = 3 * level.x.coarse;
    for (Index j = 0; j < level.y.fine; ++j) {
        const Real w = level.y.weight[static_cast<std::size_t>(j)];
        const Real *near = coarse + row * level.y.left[static_cast<std::size_t>(j)], *far = near + row;
        Real* half = level.half.data();
        for (Index i = 0; i < row; ++i) half[i] = (1 - w) * near[i] + w * far[i];
        for (Index i = 0; i < level.x.fine; ++i) {
            const Real v = level.x.weight[static_cast<std::size_t>(i)];
            const Real* from = half + 3 * level.x.left[static_cast<std::size_t>(i)];
            Real* to = fine + 3 * (i + level.x.fine * j);
            for (int c = 0; c < 3; ++c) to[c] += (1 - v) * from[c] + v * from[c + 3];
        }
    }
}

void SheetLevels::prepare(const std::vector<SymmetricBlock>& springs, const std::vector<SymmetricBlock>& own) {
    const auto *fine_springs = &springs, *fine_own = &own;
    Real ratio = 1;  // coarse over finest cell
    for (Level& level : levels_) {
        restrict_to<6>(level, &fine_springs->front().xx, half_blocks_, &level.springs.front().xx);
        restrict_to<6>(level, &fine_own->front().xx, half_blocks_, &level.own.front().xx);
        fine_springs = &level.springs, fine_own = &level.own;
        ratio *= Real(level.x.fine - 1) / Real(level.x.coarse - 1);
        // Of the bilinear hat function w on a lattice of many nodes: sum (difference of w over a cell)^2 / sum w, and sum w^2 /
        // sum w.
        const Real a = 4 / (3 * ratio * ratio), b = Real(4) / 9;
        for (std::size_t n = 0; n < level.inverse.size(); ++n) {
            const SymmetricBlock &s = level.springs[n], &o = level.own[n];
            const SymmetricBlock d{a * s.xx + b * o.xx, a * s.xy + b * o.xy, a * s.xz + b * o.xz,
                                   a * s.yy + b * o.yy, a * s.yz + b * o.yz, a * s.zz + b * o.zz};
            if (!invert(d, level.inverse[n])) level.inverse[n] = {};
        }
    }
}

void SheetLevels::add_corrections(const VecX& r, VecX& z) const {
    const Real* fine = r.data();
    for (const Level& level : levels_) {
        restrict_to<3>(level, fine, level.half, level.residual.data());
        fine = level.residual.data();
    }
    for (std::size_t l = levels_.size(); l-- > 0;) {
        const Level& level = levels_[l];
        // The correction from the levels beyond is there already.
        if (l + 1 == levels_.size()) std::ranges::fill(level.correction, Real{0});
        for (std::size_t n = 0; n < level.inverse.size(); ++n)
            add_product(level.inverse[n], level.residual.data() + 3 * n, level.correction.data() + 3 * n);
        Real* to = z.data();
        if (l > 0) {
            std::ranges::fill(levels_[l - 1].correction, Real{0});
            to = levels_[l - 1].correction.data();
        }
        prolong(level, level.correction.data(), to);
    }
}

}  // namespace pliant
