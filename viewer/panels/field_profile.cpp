#include "panels/field_profile.h"

#include "render/places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pliant::viewer {
namespace {

using Corner = std::array<Real, 3>;

}  // namespace

FieldProfile field_profile(const Lesson& lesson, const Scene& scene, On on, std::span<const Real> rows, int axis,
                           std::array<Real, 2> across) {
    std::map<Index, Corner> places;
    for (const auto& [row, p] : places_of(scene, on)) places.emplace(row, Corner{p[0], p[1], p[2]});
    FieldProfile profile;
    if (places.empty()) return profile;

    // The box of the things themselves, and a spacing typical of them.
    Corner low, high;
    low.fill(std::numeric_limits<Real>::max()), high.fill(std::numeric_limits<Real>::lowest());
    for (const auto& [row, p] : places)
        for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    const int dim = lesson.dimension();
    Real volume = 1;
    for (int k = 0; k < dim; ++k)
        volume *= std::max(high[static_cast<std::size_t>(k)] - low[static_cast<std::size_t>(k)], 1e-300);
    const Real spacing = std::pow(volume / static_cast<Real>(places.size()), 1.0 / dim);

    const auto distance = [&](const Corner& p) {
        Real sum = 0;
        std::size_t next = 0;
        for (int k = 0; k < dim; ++k) {
            if (k == axis) continue;
            const auto c = static_cast<std::size_t>(k);
            const Real d = p[c] - (low[c] + across[next++] * (high[c] - low[c]));
            sum += d * d;
        }
        return std::sqrt(sum);
    };
    Real nearest = std::numeric_limits<Real>::max();
    for (const auto& [row, p] : places) nearest = std::min(nearest, distance(p));

    std::vector<std::pair<Real, Real>> samples;
    for (const auto& [row, p] : places)
        if (row < static_cast<Index>(rows.size()) && distance(p) <= nearest + 0.3 * spacing)
            samples.emplace_back(p[static_cast<std::size_t>(axis)], rows[static_cast<std::size_t>(row)]);
    std::ranges::sort(samples);
    for (const auto& [position, value] : samples) profile.position.push_back(position), profile.value.push_back(value);
    return profile;
}

}  // namespace pliant::viewer
