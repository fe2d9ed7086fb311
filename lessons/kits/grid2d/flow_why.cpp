// Divergence, pressure and projection; and the quantities that are defined by the velocity.
#include "grid_why.h"

#include <pliant/fluids/level_set.h>

#include <fmt/format.h>

#include <array>

namespace pliant::grid2d {
namespace {

using From = Input::From;

std::string sum_of_symbols(const std::vector<Input>& inputs) {
    std::string sum;
    for (const Input& in : inputs) sum += (sum.empty() ? "" : " + ") + in.symbol;
    return sum;
}

constexpr std::array<const char*, 4> ways{"left", "right", "below", "above"};

}  // namespace

Explanation GridWhy::divergence(Index cell, Input::From from) const {
    if (!grid_.is_fluid(cell)) return fixed_value("∇·u = 0   (no liquid in the cell)");
    const Counts<2> at = grid_.cells().coordinates(cell);
    Explanation why{"∇·u = (u_right − u_left + v_above − v_below) / Δx", {}, {}};
    const std::array<const char*, 4> names{"u_left", "u_right", "v_below", "v_above"};
    for (int k = 0; k < 4; ++k) {
        const int axis = k / 2;
        const Lattice<2>& faces = grid_.faces(axis);
        Counts<2> face = at;
        face[axis] = (face[axis] + k % 2) % faces.count[axis];
        why.inputs.push_back(sample(names[static_cast<std::size_t>(k)], from, face_field(axis), faces.index(face)));
    }
    why.inputs.push_back(dx());
    if (from == From::before) why.formula.replace(0, std::string("∇·u").size(), "∇·ũ");
    return why;
}

// θ: where the surface crosses the way from a cell of fluid to one of air.
Explanation GridWhy::part_of_way(Index fluid, Index air) const {
    if (!surface_.exact) return fixed_value("θ = 1   (p = 0 in the middle of the cell of air)");
    return {"θ = max(φ_f / (φ_f − φ_a), 0.01)", {Input::now("φ_f", "distance", fluid), Input::now("φ_a", "distance", air)}};
}

GridWhy::Row GridWhy::row_of(Index cell) const {
    Row row;
    for (int k = 0; k < 4; ++k) {
        const Index n = grid_.cells().neighbour(grid_.cells().coordinates(cell), k / 2, k % 2 ? 1 : -1);
        if (n < 0 || n == cell) continue;
        const char* way = ways[static_cast<std::size_t>(k)];
        if (grid_.is_fluid(n)) row.pressures.push_back(Input::now(fmt::format("p_{}", way), "pressure", n));
        if (grid_.type(n) == CellType::air)
            row.weights.push_back(part(fmt::format("w_{} = 1 / θ", way), {Input::part("θ", "", part_of_way(cell, n))}));
    }
    return row;
}

std::string GridWhy::Row::diagonal() const {
    if (weights.empty()) return std::to_string(pressures.size());
    return fmt::format("({} + {})", pressures.size(), sum_of_symbols(weights));
}

std::vector<Input> GridWhy::Row::inputs(std::vector<Input> others) const {
    others.insert(others.begin(), weights.begin(), weights.end());
    others.insert(others.begin(), pressures.begin(), pressures.end());
    return others;
}

std::string GridWhy::Row::sum() const { return pressures.empty() ? "0" : sum_of_symbols(pressures); }

Explanation GridWhy::pressure(Index cell) const {
    if (!grid_.is_fluid(cell)) return fixed_value("p = 0   (no liquid in the cell)");
    const Row row = row_of(cell);
    if (row.inputs().empty()) return fixed_value("p = 0   (the cell has no neighbour)");
    return {fmt::format("p = ({} − Δx² (d̃ − d) / Δt) / {}", row.sum(), row.diagonal()),
            row.inputs({dx(), Input::now("d̃", "divergence_before", cell), Input::now("d", "divergence_after", cell), dt_})};
}

Explanation GridWhy::remaining_divergence(Index cell) const {
    if (!grid_.is_fluid(cell)) return fixed_value("∇·u = 0   (no liquid in the cell)");
    const Row row = row_of(cell);
    const Input before = Input::now("d̃", "divergence_before", cell);
    if (row.inputs().empty()) return {"∇·u = d̃", {before}};
    return {fmt::format("∇·u = d̃ − Δt ({} − {} p) / Δx²", row.sum(), row.diagonal()),
            row.inputs({Input::now("p", "pressure", cell), dt_, dx(), before})};
}

std::optional<Explanation> GridWhy::projection(const Question& q, bool converged) const {
    if (q.field == "divergence_before") return divergence(q.index, From::before);
    if (q.field == "pressure") return pressure(q.index);
    if (q.field == "divergence_after") return converged ? divergence(q.index, From::now) : remaining_divergence(q.index);
    if (!converged) return std::nullopt;
    return projected(axis_of(q.field), q.index);
}

Explanation GridWhy::projected(int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    const Index high = grid_.cell_beside(axis, face, 1), low = grid_.cell_beside(axis, face, 0);
    const bool at_surface = !grid_.is_fluid(high) || !grid_.is_fluid(low);
    std::vector<Input> inputs{sample("ũ", Input::From::before, face_field(axis), face), dt_,
                              Input::now("p_high", "pressure", high), Input::now("p_low", "pressure", low), dx()};
    if (!at_surface) return {"u′ = ũ − Δt (p_high − p_low) / Δx", std::move(inputs)};
    const bool wet_above = grid_.is_fluid(high);
    inputs.push_back(Input::part("θ", "", part_of_way(wet_above ? high : low, wet_above ? low : high)));
    return {"u′ = ũ − Δt (p_high − p_low) / (θ Δx)", std::move(inputs)};
}

Explanation GridWhy::cell_velocity(Index cell, int component) const {
    const int axis = component;
    const Lattice<2>& faces = grid_.faces(axis);
    Counts<2> low = grid_.cells().coordinates(cell), high = low;
    high[axis] = (high[axis] + 1) % faces.count[axis];
    const std::string_view field = face_field(axis);
    return {axis == 0 ? "u_c = ½ (u_left + u_right)" : "v_c = ½ (v_below + v_above)",
            {Input::now(axis == 0 ? "u_left" : "v_below", field, faces.index(low)),
             Input::now(axis == 0 ? "u_right" : "v_above", field, faces.index(high))}};
}

Explanation GridWhy::speed(Index cell) const {
    return {"|u| = √(u_x² + u_y²)", {Input::now("u_x", "velocity", cell, 0), Input::now("u_y", "velocity", cell, 1)}};
}

Explanation GridWhy::vorticity(Index cell) const {
    const Counts<2> at = grid_.cells().coordinates(cell);
    Explanation why{"ω = ((v₁ − v₂ + v₃ − v₄) − (u₁ − u₂ + u₃ − u₄)) / (4 Δx)", {}, {}};
    constexpr std::array<const char*, 4> digits{"₁", "₂", "₃", "₄"};
    for (int axis = 1; axis >= 0; --axis)
        for (int k = 0; k < 4; ++k) {
            Counts<2> face = at;
            face[1 - axis] += k % 2 ? -1 : 1;
            face[axis] += k / 2;
            why.inputs.push_back(sample(fmt::format("{}{}", axis ? "v" : "u", digits[static_cast<std::size_t>(k)]), From::now,
                                        face_field(axis), sample_beyond(grid_.faces(axis), face)));
        }
    why.inputs.push_back(dx());
    return why;
}

Explanation GridWhy::courant(const FaceField<2>& velocity) const {
    int axis = 0;
    Index face = 0, at = 0;
    Real largest = -1;
    for (int a = 0; a < 2; ++a)
        if (const Real here = velocity[a].cwiseAbs().maxCoeff(&at); here > largest) largest = here, axis = a, face = at;
    return {"CFL = |u| Δt / Δx   (the fastest face)", {Input::now("u", face_field(axis), face), dt_, dx()}};
}

Explanation largest(std::string_view name, const VecX& values, std::string_view field) {
    Index at = 0;
    values.cwiseAbs().maxCoeff(&at);
    return {fmt::format("{} = |d|   (largest of all cells: in cell {})", name, at), {Input::now("d", field, at)}};
}

}  // namespace pliant::grid2d
