#include "panels/field_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pliant::viewer {
namespace {

using Place = std::array<Real, 3>;

void add(std::map<Index, Place>& places, Index row, const Position& p) { places.emplace(row, Place{p[0], p[1], p[2]}); }

Position mean(std::initializer_list<Position> corners) {
    Position m{};
    for (const Position& p : corners)
        for (std::size_t k = 0; k < 3; ++k) m[k] += p[k] / static_cast<float>(corners.size());
    return m;
}

// Where each row of a field on `on` is.
std::map<Index, Place> places_of(const Scene& scene, On on) {
    std::map<Index, Place> places;
    for (const PointMarks& m : scene.points)
        if (m.pick.pickable && m.pick.on == on)
            for (std::size_t i = 0; i < m.at.size(); ++i) add(places, m.pick.id(i), m.at[i]);
    for (const LineMarks& m : scene.lines)
        if (m.pick.pickable && m.pick.on == on)
            for (std::size_t i = 0; i + 1 < m.ends.size(); i += 2)
                add(places, m.pick.id(i / 2), mean({m.ends[i], m.ends[i + 1]}));
    for (const TriangleMarks& m : scene.triangles)
        if (m.pick.pickable && m.pick.on == on)
            for (std::size_t t = 0; t < m.triangles.size(); ++t) {
                const auto corner = [&](std::size_t k) { return m.corners[static_cast<std::size_t>(m.triangles[t][k])]; };
                add(places, m.pick.id(t), mean({corner(0), corner(1), corner(2)}));
            }
    for (const GridMarks& g : scene.grids)
        if (g.pick.pickable && g.pick.on == on)
            for (int j = 0; j < g.ny; ++j)
                for (int i = 0; i < g.nx; ++i) {
                    const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(g.nx),
                                y = (static_cast<float>(j) + 0.5f) / static_cast<float>(g.ny);
                    add(places, g.pick.id(static_cast<std::size_t>(i + j * g.nx)),
                        {g.lower[0] + x * (g.upper[0] - g.lower[0]), g.lower[1] + y * (g.upper[1] - g.lower[1]), g.lower[2]});
                }
    return places;
}

}  // namespace

FieldProfile field_profile(const Lesson& lesson, const Scene& scene, const Field& field, int component, int axis,
                           std::array<Real, 2> across) {
    const auto places = places_of(scene, field.on);
    FieldProfile profile;
    if (places.empty()) return profile;

    // The box of the things themselves, and a spacing typical of them.
    Place low, high;
    low.fill(std::numeric_limits<Real>::max()), high.fill(std::numeric_limits<Real>::lowest());
    for (const auto& [row, p] : places)
        for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    const int dim = lesson.dimension();
    Real volume = 1;
    for (int k = 0; k < dim; ++k)
        volume *= std::max(high[static_cast<std::size_t>(k)] - low[static_cast<std::size_t>(k)], 1e-300);
    const Real spacing = std::pow(volume / static_cast<Real>(places.size()), 1.0 / dim);

    const auto distance = [&](const Place& p) {
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
        if (row < field.size() && distance(p) <= nearest + 0.3 * spacing)
            samples.emplace_back(p[static_cast<std::size_t>(axis)], row_value(field, row, component));
    std::ranges::sort(samples);
    for (const auto& [position, value] : samples) profile.position.push_back(position), profile.value.push_back(value);
    return profile;
}

}  // namespace pliant::viewer
