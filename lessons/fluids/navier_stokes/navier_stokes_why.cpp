// How each number of a step came about: the formulas of the stages with references to what they take.
#include "face_samples.h"
#include "navier_stokes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

constexpr std::array<std::string_view, 2> face_fields{"u_on_faces", "v_on_faces"};

Input sample(std::string symbol, From from, std::string_view field, Index index) {
    return {.from = from, .symbol = std::move(symbol), .name = std::string(field), .index = index};
}

// A sample, or what a wall makes of it one step beyond.
Input sample(std::string symbol, From from, std::string_view field, const SampleBeyond& s) {
    if (s.factor == 1 && s.offset == 0) return sample(std::move(symbol), from, field, s.index);
    Explanation mirrored{fmt::format("{} = 2 U_wall − q", symbol),
                         {Input::constant("U_wall", s.offset / 2, "m/s", "velocity of the wall that lies half a cell away"),
                          sample("q", from, field, s.index)},
                         [](Values x) { return 2 * x[0] - x[1]; }};
    if (s.factor == 1)
        mirrored = {fmt::format("{} = 2 U_walls + q", symbol),
                    {Input::constant("U_walls", s.offset / 2, "m/s", "difference of the velocities of two walls that meet"),
                     sample("q", from, field, s.index)},
                    [](Values x) { return 2 * x[0] + x[1]; }};
    return Input::part(std::move(symbol), "m/s", std::move(mirrored));
}

Explanation kept_by_wall(int axis, Index face) {
    return {"u′ = u   (the face lies on a wall and keeps the wall's velocity)",
            {sample("u", From::before, face_fields[static_cast<std::size_t>(axis)], face)},
            [](Values x) { return x[0]; },
            [](Values x) { return fmt::format("{:.6g}", x[0]); }};
}

// The cell of samples around a place, and where in it the place lies.
struct Interpolation {
    Counts<2> corner;  // the lower left sample; may lie one step beyond the lattice
    std::array<Real, 2> fraction;
};
Interpolation interpolation(const Lattice<2>& lattice, const GridPlace<2>& place) {
    Interpolation in;
    for (int a = 0; a < 2; ++a) {
        const Real t = place[a] + (1 - lattice.offset[a]);
        const auto layer = static_cast<Index>(t);
        in.corner[a] = layer - 1;
        in.fraction[a] = t - static_cast<Real>(layer);
    }
    return in;
}

// q = Σ w q_k over the four samples around a place in the field before the stage.
Explanation interpolated(const std::string& left, const Lattice<2>& lattice, std::string_view field, const GridPlace<2>& place) {
    const Interpolation in = interpolation(lattice, place);
    std::vector<std::pair<Input, Input>> terms;
    for (Index j = 0; j < 2; ++j)
        for (Index i = 0; i < 2; ++i) {
            const Real w = (i ? in.fraction[0] : 1 - in.fraction[0]) * (j ? in.fraction[1] : 1 - in.fraction[1]);
            const std::string k = std::to_string(2 * j + i + 1);
            terms.emplace_back(
                Input::constant("w" + k, w, "", "bilinear weight of this sample"),
                sample("q" + k, From::before, field, sample_beyond(lattice, {in.corner[0] + i, in.corner[1] + j})));
        }
    return weighted_sum(left + " = Σ w q, over the four samples around the place", terms);
}

}  // namespace

bool NavierStokes::closed(int axis, Index face) const {
    const auto& closed = grid_->closed_faces(axis);
    return std::ranges::binary_search(closed, face);
}

// ----------------------------------------------------------------------------------------------------- external forces

Explanation NavierStokes::why_force(int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    const Lattice<2>& faces = grid_->faces(axis);
    const GridPlace<2> place = faces.place(faces.coordinates(face));
    Explanation why{"u′ = u + Δt f", {}, {}};
    why.inputs = {sample("u", From::before, face_fields[static_cast<std::size_t>(axis)], face), Input::of(dt)};
    const auto add = [&](const std::string& symbol, const Jet& jet, Input strength, Real direction) {
        Real square = 0;
        for (int b = 0; b < 2; ++b) {
            const Real d = place[b] * dx() - jet.centre[b];
            square += d * d;
        }
        const bool reached = square <= 16 * jet.radius * jet.radius;
        why.inputs.push_back(Input::part(
            symbol, "m/s²",
            {symbol + (reached ? " = a d exp(−½ (r/ρ)²)" : " = 0 a d (r/ρ)   (nothing beyond 4 ρ)"),
             {Input::constant("r", std::sqrt(square), "m", "distance of the face from the middle of the jet"),
              Input::constant("ρ", jet.radius, "m", "radius of the jet"), std::move(strength),
              Input::constant("d", direction, "", axis == 0 ? "x of the jet's direction" : "y of the jet's direction")},
             [reached](Values x) { return reached ? x[2] * x[3] * std::exp(-0.5 * (x[0] / x[1]) * (x[0] / x[1])) : Real{0}; }}));
    };
    if (stirred()) add("f_stirrer", stirrer_jet(), Input::of(stirring, "a"), stirrer_heading()[axis]);
    if (pull_) {
        const Jet jet = hand_jet();
        const Real size = jet.acceleration.norm();
        add("f_hand", jet, Input::constant("a", size, "m/s²", "40 1/s² times the length of the pull"),
            size > 0 ? jet.acceleration[axis] / size : 0);
    }
    why.formula = stirred() && pull_ ? "u′ = u + Δt (f_stirrer + f_hand)"
                  : stirred()        ? "u′ = u + Δt f_stirrer"
                                     : "u′ = u + Δt f_hand";
    why.evaluate = [](Values x) {
        Real f = 0;
        for (std::size_t k = 2; k < x.size(); ++k) f += x[k];
        return x[0] + x[1] * f;
    };
    return why;
}

// ----------------------------------------------------------------------------------------------------------- advection

// Where the particle that arrives at a face was one step ago, along one axis, in cells: x − Δt/Δx u(x − ½ Δt/Δx u(x)).
Explanation NavierStokes::why_departure(int axis, const GridPlace<2>& arrival, const GridPlace<2>& middle, bool inside,
                                        Real departure) const {
    const std::string x = axis == 0 ? "x" : "y";
    if (!inside)
        return {
            fmt::format("{}_d = edge   (the path leaves the domain: its nearest point, or the other side of a periodic one)", x),
            {Input::constant("edge", departure, "cells", "place in the domain")},
            [](Values v) { return v[0]; }};
    return {
        fmt::format("{0}_d = {0} − Δt u_m / Δx", x),
        {Input::constant(x, arrival[axis], "cells", "place of the face, from the corner of the domain"), Input::of(dt),
         Input::part("u_m", "m/s", interpolated("u_m", grid_->faces(axis), face_fields[static_cast<std::size_t>(axis)], middle)),
         Input::constant("Δx", dx(), "m", "edge of a cell")},
        [](Values v) { return v[0] - v[1] * v[2] / v[3]; }};
}

Explanation NavierStokes::why_advected(int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    const VelocitySampler<2>& flow = advection_->flow();
    const Lattice<2>& faces = grid_->faces(axis);
    const Counts<2> at = faces.coordinates(face);
    const GridPlace<2> x = faces.place(at);
    const Real cells_per_speed = dt / dx();

    // The same path as the stage's: the velocity at the face, half a step back, the velocity there, a whole step back.
    const auto back = [&](const GridPlace<2>& speed, Real step) {
        return GridPlace<2>{x[0] - step * speed[0], x[1] - step * speed[1]};
    };
    const GridPlace<2> middle = flow.confined(back(flow.at(x), 0.5 * cells_per_speed));
    const GridPlace<2> free_end = back(flow.at(middle), cells_per_speed);
    const GridPlace<2> departure = flow.confined(free_end);

    const Interpolation in = interpolation(faces, departure);
    Explanation why{"u′ = (1 − s) (1 − t) u₁ + s (1 − t) u₂ + (1 − s) t u₃ + s t u₄", {}, {}};
    for (int a = 0; a < 2; ++a) {
        const std::string symbol = a == 0 ? "s" : "t", place = a == 0 ? "x_d" : "y_d";
        const bool inside = departure[a] == free_end[a];
        why.inputs.push_back(Input::part(
            symbol, "",
            {fmt::format("{} = {} − x₁", symbol, place),
             {Input::part(place, "cells", why_departure(a, x, middle, inside, departure[a])),
              Input::constant("x₁", departure[a] - in.fraction[a], "cells", "place of the sample below or to the left")},
             [](Values v) { return v[0] - v[1]; }}));
    }
    for (Index k = 0; k < 4; ++k)
        why.inputs.push_back(sample(fmt::format("u{}", std::array{"₁", "₂", "₃", "₄"}[static_cast<std::size_t>(k)]), From::before,
                                    face_fields[static_cast<std::size_t>(axis)],
                                    sample_beyond(faces, {in.corner[0] + k % 2, in.corner[1] + k / 2})));
    why.evaluate = [](Values v) {
        const Real s = v[0], t = v[1];
        return (1 - s) * (1 - t) * v[2] + s * (1 - t) * v[3] + (1 - s) * t * v[4] + s * t * v[5];
    };
    return why;
}

// ----------------------------------------------------------------------------------------------------------- viscosity

Input NavierStokes::diffusion_number() const {
    return Input::part("r", "",
                       {"r = ν Δt / Δx²",
                        {Input::of(viscosity), Input::of(dt), Input::constant("Δx", dx(), "m", "edge of a cell")},
                        [](Values x) { return x[0] * x[1] / (x[2] * x[2]); }});
}

Explanation NavierStokes::why_diffused(int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    const bool implicit = scheme == Scheme::implicit_euler;
    const std::string_view field = face_fields[static_cast<std::size_t>(axis)];
    const Lattice<2>& faces = grid_->faces(axis);
    const Counts<2> at = faces.coordinates(face);
    Explanation why{implicit ? "u′ = (u + r (u′_left + u′_right + u′_below + u′_above) − ρ) / (1 + 4 r)"
                             : "u′ = u + r (u_left + u_right + u_below + u_above − 4 u)",
                    {},
                    {}};
    why.inputs = {sample("u", From::before, field, face), diffusion_number()};
    const std::array<const char*, 4> names{"left", "right", "below", "above"};
    for (int k = 0; k < 4; ++k) {
        Counts<2> beside = at;
        beside[k / 2] += k % 2 ? 1 : -1;
        why.inputs.push_back(sample(fmt::format("u{}_{}", implicit ? "′" : "", names[static_cast<std::size_t>(k)]),
                                    implicit ? From::now : From::before, field, sample_beyond(faces, beside)));
    }
    if (!implicit) {
        why.evaluate = [](Values x) { return x[0] + x[1] * ((x[2] + x[3] + x[4] + x[5]) - 4 * x[0]); };
        return why;
    }
    why.inputs.push_back(
        Input::constant("ρ", diffusion_->residual(axis)[face], "m/s", "what the iterative solver has left of the equation"));
    why.evaluate = [](Values x) { return (x[0] + x[1] * (x[2] + x[3] + x[4] + x[5]) - x[6]) / (1 + 4 * x[1]); };
    return why;
}

// ---------------------------------------------------------------------------------------------------------- projection

Explanation NavierStokes::why_divergence(Index cell, Input::From from) const {
    const Counts<2> at = grid_->cells().coordinates(cell);
    Explanation why{"∇·u = (u_right − u_left + v_above − v_below) / Δx", {}, {}};
    const std::array<const char*, 4> names{"u_left", "u_right", "v_below", "v_above"};
    for (int k = 0; k < 4; ++k) {
        const int axis = k / 2;
        const Lattice<2>& faces = grid_->faces(axis);
        Counts<2> face = at;
        face[axis] = (face[axis] + k % 2) % faces.count[axis];
        why.inputs.push_back(
            sample(names[static_cast<std::size_t>(k)], from, face_fields[static_cast<std::size_t>(axis)], faces.index(face)));
    }
    why.inputs.push_back(Input::constant("Δx", dx(), "m", "edge of a cell"));
    why.evaluate = [](Values x) { return (x[1] - x[0] + x[3] - x[2]) / x[4]; };
    if (from == From::before) why.formula.replace(0, std::string("∇·u").size(), "∇·ũ");
    return why;
}

namespace {
// The pressures of the neighbours of a cell, by the way to them.
std::vector<Input> pressures_beside(const Lattice<2>& cells, Index cell) {
    std::vector<Input> beside;
    const std::array<const char*, 4> names{"p_left", "p_right", "p_below", "p_above"};
    for (int k = 0; k < 4; ++k) {
        const Index n = cells.neighbour(cells.coordinates(cell), k / 2, k % 2 ? 1 : -1);
        if (n >= 0 && n != cell) beside.push_back(Input::now(names[static_cast<std::size_t>(k)], "pressure", n));
    }
    return beside;
}

std::string sum_of_symbols(const std::vector<Input>& inputs) {
    std::string sum;
    for (const Input& in : inputs) sum += (sum.empty() ? "" : " + ") + in.symbol;
    return sum;
}
}  // namespace

// The row of the pressure equation that belongs to this cell, solved for its own pressure. What the solver has not removed yet
// is the divergence that is left.
Explanation NavierStokes::why_pressure(Index cell) const {
    std::vector<Input> inputs = pressures_beside(grid_->cells(), cell);
    const std::size_t n = inputs.size();
    if (n == 0)
        return {
            "p = 0   (the cell has no neighbour)", {}, [](Values) { return Real{0}; }, [](Values) { return std::string("0"); }};
    std::string formula = fmt::format("p = ({} − Δx² (d̃ − d) / Δt) / {}", sum_of_symbols(inputs), n);
    for (Input& in :
         std::vector<Input>{Input::constant("Δx", dx(), "m", "edge of a cell"), Input::now("d̃", "divergence_before", cell),
                            Input::now("d", "divergence_after", cell), Input::of(dt)})
        inputs.push_back(in);
    return {std::move(formula), std::move(inputs), [n](Values x) {
                Real sum = 0;
                for (std::size_t k = 0; k < n; ++k) sum += x[k];
                return (sum - x[n] * x[n] * (x[n + 1] - x[n + 2]) / x[n + 3]) / static_cast<Real>(n);
            }};
}

// During the solver's passes: what the pressure so far would leave.
Explanation NavierStokes::why_remaining_divergence(Index cell) const {
    std::vector<Input> inputs = pressures_beside(grid_->cells(), cell);
    const std::size_t n = inputs.size();
    std::string formula = n ? fmt::format("∇·u = d̃ − Δt ({} − {} p) / Δx²", sum_of_symbols(inputs), n) : "∇·u = d̃";
    if (n) {
        inputs.push_back(Input::now("p", "pressure", cell));
        inputs.push_back(Input::of(dt));
        inputs.push_back(Input::constant("Δx", dx(), "m", "edge of a cell"));
    }
    inputs.push_back(Input::now("d̃", "divergence_before", cell));
    return {std::move(formula), std::move(inputs), [n](Values x) {
                if (n == 0) return x[0];
                Real sum = 0;
                for (std::size_t k = 0; k < n; ++k) sum += x[k];
                return x[n + 3] - x[n + 1] * (sum - static_cast<Real>(n) * x[n]) / (x[n + 2] * x[n + 2]);
            }};
}

Explanation NavierStokes::why_projected(int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    return {"u′ = ũ − Δt (p_high − p_low) / Δx",
            {sample("ũ", From::before, face_fields[static_cast<std::size_t>(axis)], face), Input::of(dt),
             Input::now("p_high", "pressure", cell_beside(axis, face, 1)),
             Input::now("p_low", "pressure", cell_beside(axis, face, 0)), Input::constant("Δx", dx(), "m", "edge of a cell")},
            [](Values x) { return x[0] - x[1] * (x[2] - x[3]) / x[4]; }};
}

Index NavierStokes::cell_beside(int axis, Index face, int side) const { return grid_->cell_beside(axis, face, side); }

std::optional<Explanation> NavierStokes::why_projection(const Question& q) const {
    if (q.field == "divergence_before") return why_divergence(q.index, From::before);
    if (q.field == "pressure") return why_pressure(q.index);
    const bool applied = projection_->converged();
    if (q.field == "divergence_after") return applied ? why_divergence(q.index, From::now) : why_remaining_divergence(q.index);
    if (!applied) return std::nullopt;
    return why_projected(axis_of(q), q.index);
}

// ----------------------------------------------------------------------------------------------- quantities by definition

Explanation NavierStokes::why_velocity(const Question& q) const {
    const int axis = q.component;
    const Lattice<2>& faces = grid_->faces(axis);
    Counts<2> low = grid_->cells().coordinates(q.index), high = low;
    high[axis] = (high[axis] + 1) % faces.count[axis];
    const std::string_view field = face_fields[static_cast<std::size_t>(axis)];
    return {axis == 0 ? "u_c = ½ (u_left + u_right)" : "v_c = ½ (v_below + v_above)",
            {Input::now(axis == 0 ? "u_left" : "v_below", field, faces.index(low)),
             Input::now(axis == 0 ? "u_right" : "v_above", field, faces.index(high))},
            [](Values x) { return 0.5 * (x[0] + x[1]); }};
}

Explanation NavierStokes::why_speed(Index cell) const {
    return {"|u| = √(u_x² + u_y²)",
            {Input::now("u_x", "velocity", cell, 0), Input::now("u_y", "velocity", cell, 1)},
            [](Values x) { return std::hypot(x[0], x[1]); }};
}

Explanation NavierStokes::why_vorticity(Index cell) const {
    const Counts<2> at = grid_->cells().coordinates(cell);
    Explanation why{"ω = ((v₁ − v₂ + v₃ − v₄) − (u₁ − u₂ + u₃ − u₄)) / (4 Δx)", {}, {}};
    constexpr std::array<const char*, 4> digits{"₁", "₂", "₃", "₄"};
    for (int axis = 1; axis >= 0; --axis)
        for (int k = 0; k < 4; ++k) {
            Counts<2> face = at;
            face[1 - axis] += k % 2 ? -1 : 1;
            face[axis] += k / 2;
            why.inputs.push_back(sample(fmt::format("{}{}", axis ? "v" : "u", digits[static_cast<std::size_t>(k)]), From::now,
                                        face_fields[static_cast<std::size_t>(axis)], sample_beyond(grid_->faces(axis), face)));
        }
    why.inputs.push_back(Input::constant("Δx", dx(), "m", "edge of a cell"));
    why.evaluate = [](Values x) { return ((x[0] - x[1] + x[2] - x[3]) - (x[4] - x[5] + x[6] - x[7])) / (4 * x[8]); };
    return why;
}

// The largest number of a field, with the place where it is reached.
Explanation NavierStokes::why_largest(std::string_view name, const VecX& values, std::string_view field) const {
    Index at = 0;
    values.cwiseAbs().maxCoeff(&at);
    return {fmt::format("{} = |d|   (largest of all cells: in cell {})", name, at), {Input::now("d", field, at)}, [](Values x) {
                return std::abs(x[0]);
            }};
}

Explanation NavierStokes::why_courant() const {
    int axis = 0;
    Index face = 0, at = 0;
    Real largest = -1;
    for (int a = 0; a < 2; ++a)
        if (const Real here = velocity_[a].cwiseAbs().maxCoeff(&at); here > largest) largest = here, axis = a, face = at;
    return {"CFL = |u| Δt / Δx   (the fastest face)",
            {Input::now("u", face_fields[static_cast<std::size_t>(axis)], face), Input::of(dt),
             Input::constant("Δx", dx(), "m", "edge of a cell")},
            [](Values x) { return std::abs(x[0]) * x[1] / x[2]; }};
}

int NavierStokes::axis_of(const Question& q) { return q.field == face_fields[0] ? 0 : 1; }

}  // namespace pliant::navier_stokes
