#include <pliant/time/stability_region.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr int region_columns = 120, region_rows = 60;  // of the upper half: the lower one is its mirror image
constexpr Real just_stable = 1 + 1e-9;

Real crossing_part(Real from, Real to) { return (just_stable - from) / (to - from); }

}  // namespace

Real growth_at(Scheme scheme, std::complex<Real> z) {
    const Real w = std::abs(z);
    return w == 0 ? 1 : amplification(scheme, w, std::clamp(-z.real() / w, Real{-1}, Real{1}), 1);
}

// Cell by cell: the corners that are stable, and the places on the edges where that changes (marching squares).
StabilityRegion stability_region(Scheme scheme) {
    using Point = StabilityRegion::Point;
    const auto at = [](int i, int j) {
        return Point{region_left + (region_right - region_left) * i / region_columns, region_high * j / region_rows};
    };
    std::vector<Real> growth;
    for (int j = 0; j <= region_rows; ++j)
        for (int i = 0; i <= region_columns; ++i) growth.push_back(growth_at(scheme, {at(i, j)[0], at(i, j)[1]}));
    StabilityRegion region;
    for (int j = 0; j < region_rows; ++j)
        for (int i = 0; i < region_columns; ++i) {
            constexpr std::array<std::array<int, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
            std::vector<Point> inside, crossing;
            for (std::size_t c = 0; c < 4; ++c) {
                const auto [di, dj] = corner[c];
                const auto [ei, ej] = corner[(c + 1) % 4];
                const Point a = at(i + di, j + dj), b = at(i + ei, j + ej);
                const Real here = growth[static_cast<std::size_t>((j + dj) * (region_columns + 1) + i + di)];
                const Real next = growth[static_cast<std::size_t>((j + ej) * (region_columns + 1) + i + ei)];
                if (here <= just_stable) inside.push_back(a);
                if ((here <= just_stable) == (next <= just_stable)) continue;
                const Real s = crossing_part(here, next);
                crossing.push_back({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])});
                inside.push_back(crossing.back());
            }
            for (const Real side : {1, -1}) {
                const auto mirrored = [side](Point p) { return Point{p[0], side * p[1]}; };
                for (std::size_t k = 1; k + 1 < inside.size(); k += 2) {
                    const Point last = inside[std::min(k + 2, inside.size() - 1)];
                    region.pieces.push_back({mirrored(inside[0]), mirrored(inside[k]), mirrored(inside[k + 1]), mirrored(last)});
                }
                for (std::size_t k = 0; k + 1 < crossing.size(); k += 2)
                    region.border.push_back({mirrored(crossing[k]), mirrored(crossing[k + 1])});
            }
        }
    return region;
}

}  // namespace pliant
