#include "grid_why.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::grid2d {
namespace {

using From = Input::From;

}  // namespace

Input sample(std::string symbol, Input::From from, std::string_view field, Index index) {
    Input in = Input::now(std::move(symbol), field, index);
    in.from = from;
    return in;
}

Input sample(std::string symbol, Input::From from, std::string_view field, const SampleBeyond& s) {
    if (s.factor == 1 && s.offset == 0) return sample(std::move(symbol), from, field, s.index);
    Explanation mirrored{fmt::format("{} = 2 U_wall − q", symbol),
                         {Input::constant("U_wall", s.offset / 2, "m/s", "velocity of the wall that lies half a cell away"),
                          sample("q", from, field, s.index)}};
    if (s.factor == 1)
        mirrored = {fmt::format("{} = 2 U_walls + q", symbol),
                    {Input::constant("U_walls", s.offset / 2, "m/s", "difference of the velocities of two walls that meet"),
                     sample("q", from, field, s.index)}};
    return Input::part(std::move(symbol), "m/s", std::move(mirrored));
}

Explanation kept_by_wall(int axis, Index face) {
    return {"u′ = u   (the face lies on a wall and keeps the wall's velocity)",
            {sample("u", From::before, face_field(axis), face)}};
}

Surrounding surrounding(const Lattice<2>& lattice, const GridPlace<2>& place) {
    Surrounding in;
    for (int a = 0; a < 2; ++a) {
        const Real t = place[a] + (1 - lattice.offset[a]);
        const auto layer = static_cast<Index>(t);
        in.corner[a] = layer - 1;
        in.fraction[a] = t - static_cast<Real>(layer);
    }
    return in;
}

Explanation interpolated(const std::string& left, const Lattice<2>& lattice, std::string_view field, const GridPlace<2>& place,
                         Input::From from, std::string_view where) {
    const Surrounding in = surrounding(lattice, place);
    std::vector<std::pair<Input, Input>> terms;
    for (Index j = 0; j < 2; ++j)
        for (Index i = 0; i < 2; ++i) {
            const Real w = (i ? in.fraction[0] : 1 - in.fraction[0]) * (j ? in.fraction[1] : 1 - in.fraction[1]);
            const std::string k = std::to_string(2 * j + i + 1);
            terms.emplace_back(Input::constant("w" + k, w, "", "bilinear weight of this sample"),
                               sample("q" + k, from, field, sample_beyond(lattice, {in.corner[0] + i, in.corner[1] + j})));
        }
    return weighted_sum(fmt::format("{} = Σ_k w_k q_k, over {}", left, where), "w_k", "q_k", terms);
}

bool GridWhy::closed(int axis, Index face) const {
    const auto& closed = grid_.closed_faces(axis);
    return std::ranges::binary_search(closed, face);
}

Input GridWhy::dx() const { return Input::constant("Δx", grid_.dx(), "m", "edge of a cell"); }

Input GridWhy::diffusion_number(Input viscosity) const {
    return Input::part("r", "", {"r = ν Δt / Δx²", {std::move(viscosity), dt_, dx()}});
}

Explanation GridWhy::diffused(Input viscosity, const VecX* residual, int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    const bool implicit = residual != nullptr;
    const std::string_view field = face_field(axis);
    const Lattice<2>& faces = grid_.faces(axis);
    const Counts<2> at = faces.coordinates(face);
    Explanation why{implicit ? "u′ = (u + r (u′_left + u′_right + u′_below + u′_above) − ρ) / (1 + 4 r)"
                             : "u′ = u + r (u_left + u_right + u_below + u_above − 4 u)",
                    {},
                    {}};
    why.inputs = {sample("u", From::before, field, face), diffusion_number(std::move(viscosity))};
    const std::array<const char*, 4> names{"left", "right", "below", "above"};
    for (int k = 0; k < 4; ++k) {
        Counts<2> beside = at;
        beside[k / 2] += k % 2 ? 1 : -1;
        why.inputs.push_back(sample(fmt::format("u{}_{}", implicit ? "′" : "", names[static_cast<std::size_t>(k)]),
                                    implicit ? From::now : From::before, field, sample_beyond(faces, beside)));
    }
    if (implicit)
        why.inputs.push_back(
            Input::constant("ρ", (*residual)[face], "m/s", "what the iterative solver has left of the equation"));
    return why;
}

}  // namespace pliant::grid2d
