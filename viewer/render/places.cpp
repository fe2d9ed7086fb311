#include "render/places.h"

#include <initializer_list>

namespace pliant::viewer {
namespace {

Position mean(std::initializer_list<Position> corners) {
    Position m{};
    for (const Position& p : corners)
        for (std::size_t k = 0; k < 3; ++k) m[k] += p[k] / static_cast<float>(corners.size());
    return m;
}

Position middle_of_cell(const GridMarks& g, int i, int j) {
    const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(g.nx),
                y = (static_cast<float>(j) + 0.5f) / static_cast<float>(g.ny);
    return {g.lower[0] + x * (g.upper[0] - g.lower[0]), g.lower[1] + y * (g.upper[1] - g.lower[1]), g.lower[2]};
}

// Calls visit(index, place) for every mark on `on`.
template <class Visit>
void for_each_place(const Scene& scene, On on, const Visit& visit) {
    const auto suits = [on](const PickId& pick) { return pick.pickable && pick.on == on; };
    for (const PointMarks& m : scene.points)
        if (suits(m.pick))
            for (std::size_t i = 0; i < m.at.size(); ++i) visit(m.pick.id(i), m.at[i]);
    for (const LineMarks& m : scene.lines)
        if (suits(m.pick))
            for (std::size_t i = 0; i + 1 < m.ends.size(); i += 2) visit(m.pick.id(i / 2), mean({m.ends[i], m.ends[i + 1]}));
    for (const TriangleMarks& m : scene.triangles)
        if (suits(m.pick))
            for (std::size_t t = 0; t < m.triangles.size(); ++t) {
                const auto corner = [&](std::size_t k) { return m.corners[static_cast<std::size_t>(m.triangles[t][k])]; };
                visit(m.pick.id(t), mean({corner(0), corner(1), corner(2)}));
            }
    for (const GridMarks& g : scene.grids)
        if (suits(g.pick))
            for (int j = 0; j < g.ny; ++j)
                for (int i = 0; i < g.nx; ++i) visit(g.pick.id(static_cast<std::size_t>(i + j * g.nx)), middle_of_cell(g, i, j));
}

}  // namespace

std::map<Index, Position> places_of(const Scene& scene, On on) {
    std::map<Index, Position> places;
    for_each_place(scene, on, [&](Index index, const Position& place) { places.emplace(index, place); });
    return places;
}

std::optional<Position> place_of(const Scene& scene, On on, Index index) {
    std::optional<Position> found;
    for_each_place(scene, on, [&](Index i, const Position& place) {
        if (i == index && !found) found = place;
    });
    return found;
}

}  // namespace pliant::viewer
