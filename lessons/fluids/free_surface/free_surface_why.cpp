// How each number of a step came about.
#include "free_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::free_surface {
namespace {

using From = Input::From;
using grid2d::face_field;

constexpr std::array<const char*, 4> ways{"left", "right", "below", "above"};

// The mean of the neighbours that were known in an earlier layer.
Explanation mean_of_neighbours(std::string_view symbol, std::string_view field, const Lattice<2>& lattice,
                               const std::vector<int>& layers, Index sample) {
    std::vector<Input> known;
    std::string sum;
    for (int k = 0; k < 4; ++k) {
        const Index n = lattice.neighbour(lattice.coordinates(sample), k / 2, k % 2 ? 1 : -1);
        if (n < 0 || layers[n] < 0 || layers[n] >= layers[sample]) continue;
        const std::string name = fmt::format("{}_{}", symbol, ways[static_cast<std::size_t>(k)]);
        sum += (sum.empty() ? "" : " + ") + name;
        known.push_back(Input::now(name, field, n));
    }
    return {fmt::format("{} = ({}) / {}   (the neighbours nearer to the liquid)", symbol, sum, known.size()), std::move(known)};
}

}  // namespace

Explanation FreeSurface::kept(int axis, Index face) const {
    if (liquid_->grid().prescribed(axis, face)) return grid2d::kept_by_wall(axis, face);
    return {"u′ = u   (no liquid beside the face)", {Input::before("u", face_field(axis), face)}};
}

Explanation FreeSurface::why_solid(int axis, Index face) const {
    const StaggeredGrid<2>& grid = liquid_->grid();
    const bool on_paddle = [&] {
        for (int side = 0; side < 2; ++side)
            if (const Index c = grid.cell_beside(axis, face, side); c >= 0 && grid.type(c) == CellType::solid) return true;
        return false;
    }();
    if (grid.prescribed(axis, face) && on_paddle)
        return {axis == 0 ? "u′ = U   (the face belongs to the paddle)" : "v′ = U   (above and below the paddle)",
                {Input::constant("U", axis == 0 ? paddle_speed(time()) : 0, "m/s", "velocity of the paddle across the face")}};
    return kept(axis, face);
}

Explanation FreeSurface::why_force(int axis, Index face) const {
    if (liquid_->grid().prescribed(axis, face)) return grid2d::kept_by_wall(axis, face);
    const Input before = Input::before("u", face_field(axis), face);
    if (axis == 0) return {"u′ = u   (gravity does not act sideways)", {before}};
    return {"u′ = u − Δt g", {before, dt, gravity}};
}

std::optional<Explanation> FreeSurface::why_projection(const Question& q) const {
    const bool on_faces = q.field == "u_on_faces" || q.field == "v_on_faces", converged = liquid_->projection().converged();
    const int axis = grid2d::axis_of(q.field);
    if (on_faces && converged && why_on_grid().closed(axis, q.index)) return kept(axis, q.index);
    return why_on_grid().projection(q, converged);
}

Explanation FreeSurface::why_continued(int axis, Index face) const {
    const StaggeredGrid<2>& grid = liquid_->grid();
    const std::vector<int>& layers = liquid_->extrapolation().layers(axis);
    if (layers[face] > 0) return mean_of_neighbours(axis == 0 ? "u" : "v", face_field(axis), grid.faces(axis), layers, face);
    if (layers[face] < 0 && !grid.prescribed(axis, face)) return fixed_value("u = 0   (there is no liquid to continue)");
    return {"u′ = u   (beside the liquid, or held by a wall)", {Input::before("u", face_field(axis), face)}};
}

// The largest of the three differences over the cell, per length.
Explanation FreeSurface::why_slope(Index cell, int axis, std::string symbol) const {
    const Counts<2> at = liquid_->grid().cells().coordinates(cell);
    return {fmt::format("{} = max(|φ_high − φ_low| / 2, |φ_high − φ|, |φ − φ_low|) / Δx", symbol),
            {Input::before("φ_high", "distance", liquid_->surface().beside(at, axis, 1)),
             Input::before("φ_low", "distance", liquid_->surface().beside(at, axis, -1)), Input::before("φ", "distance", cell),
             why_on_grid().dx()}};
}

Explanation FreeSurface::why_redistanced(Index cell) const {
    const LevelSet<2>& surface = liquid_->surface();
    const Lattice<2>& cells = liquid_->grid().cells();
    const Input before = Input::before("φ", "distance", cell);
    if (surface.solid(cell) && surface.layer(cell) > 0) {
        std::vector<int> layers(static_cast<std::size_t>(cells.size()));
        for (Index c = 0; c < cells.size(); ++c) layers[static_cast<std::size_t>(c)] = surface.layer(c);
        return mean_of_neighbours("φ", "distance", cells, layers, cell);
    }
    if (surface.distance().minCoeff() >= 0 || surface.distance().maxCoeff() < 0)
        return {"φ′ = φ   (there is no surface)", {before}};
    if (surface.beside_surface(cell))
        return Explanation{
            "φ′ = φ / slope(s_x, s_y), √(s_x² + s_y²) where that is not within 0.7 … 1.5, else 1   (beside the surface)",
            {before, Input::part("s_x", "", why_slope(cell, 0, "s_x")), Input::part("s_y", "", why_slope(cell, 1, "s_y"))}}
            .by("slope", "", [](Values x) {
                const Real slope = std::sqrt(x[0] * x[0] + x[1] * x[1]);
                const bool sound = slope >= LevelSet<2>::flattest && slope <= LevelSet<2>::steepest;
                return sound ? 1 : std::max(slope, Real(1e-6));
            });
    // The nearer neighbour along each axis.
    const Counts<2> at = cells.coordinates(cell);
    std::array<Index, 2> nearest;
    for (int a = 0; a < 2; ++a) {
        const Index low = surface.beside(at, a, -1), high = surface.beside(at, a, 1);
        nearest[static_cast<std::size_t>(a)] =
            std::abs(surface.distance()[low]) <= std::abs(surface.distance()[high]) ? low : high;
    }
    const Real sign = surface.distance()[cell] < 0 ? -1 : 1;
    return Explanation{"φ′ = far(φ_x, φ_y, Δx), d with (d − |φ_x|)² + (d − |φ_y|)² = Δx², or the smaller + Δx; φ keeps its sign",
                       {Input::now("φ_x", "distance", nearest[0]), Input::now("φ_y", "distance", nearest[1]), why_on_grid().dx()}}
        .by("far", "m", [sign](Values x) {
            const Real a = std::abs(x[0]), b = std::abs(x[1]), near = std::min(a, b), far = std::max(a, b);
            if (near + x[2] <= far) return sign * (near + x[2]);
            return sign * (a + b + std::sqrt(std::max(Real(0), 2 * x[2] * x[2] - (a - b) * (a - b)))) / 2;
        });
}

// -------------------------------------------------------------------------------------------------------------- probes

// Where the surface crosses the way between two cell centres. along: of the fluid cell's row or column.
Explanation FreeSurface::at_crossing(const std::string& symbol, const std::string& meaning, const Crossing& at,
                                     Index along) const {
    return {fmt::format("{} = x_c + Δx φ_f / (φ_f − φ_a)", symbol),
            {Input::constant("x_c", (static_cast<Real>(along) + 0.5) * dx(), "m", meaning), why_on_grid().dx(),
             Input::now("φ_f", "distance", at.fluid), Input::now("φ_a", "distance", at.air)}};
}

Explanation FreeSurface::why_front() const {
    const Crossing at = front();
    if (at.fluid < 0) return fixed_value("x_f = 0   (there is no liquid)");
    if (at.air < 0) return {"x_f = W   (the liquid reaches the right wall)", {tank_width}};
    return at_crossing("x_f", "centre of the last cell of liquid", at, at.fluid % resolution);
}

Explanation FreeSurface::why_height_at_wall() const {
    const Crossing at = height_in(0);
    if (at.fluid < 0) return fixed_value("h_w = 0   (the floor is dry at the wall)");
    if (at.air < 0)
        return {"h_w = H   (the liquid reaches the lid)", {Input::constant("H", tank_top(), "m", "height of the lid")}};
    return at_crossing("h_w", "centre of the highest cell of liquid", at, at.fluid / resolution);
}

}  // namespace pliant::free_surface
