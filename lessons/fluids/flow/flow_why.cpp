// Divergence, pressure and projection; and the quantities that are defined by the velocity.
#include "grid_why.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace pliant::flow {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

std::string sum_of_symbols(const std::vector<Input>& inputs) {
    std::string sum;
    for (const Input& in : inputs) sum += (sum.empty() ? "" : " + ") + in.symbol;
    return sum;
}

}  // namespace

Explanation GridWhy::divergence(Index cell, Input::From from) const {
    if (!grid_.is_fluid(cell)) return fixed_value("∇·u = 0   (a solid cell)", 0);
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
    why.evaluate = [](Values x) { return (x[1] - x[0] + x[3] - x[2]) / x[4]; };
    if (from == From::before) why.formula.replace(0, std::string("∇·u").size(), "∇·ũ");
    return why;
}

// The pressures of the fluid beside a cell, by the way to them.
std::vector<Input> GridWhy::pressures_beside(Index cell) const {
    std::vector<Input> beside;
    const std::array<const char*, 4> names{"p_left", "p_right", "p_below", "p_above"};
    for (int k = 0; k < 4; ++k) {
        const Index n = grid_.cells().neighbour(grid_.cells().coordinates(cell), k / 2, k % 2 ? 1 : -1);
        if (n >= 0 && n != cell && grid_.is_fluid(n))
            beside.push_back(Input::now(names[static_cast<std::size_t>(k)], "pressure", n));
    }
    return beside;
}

Explanation GridWhy::pressure(Index cell) const {
    if (!grid_.is_fluid(cell)) return fixed_value("p = 0   (a solid cell)", 0);
    std::vector<Input> inputs = pressures_beside(cell);
    const std::size_t n = inputs.size();
    if (n == 0)
        return {
            "p = 0   (the cell has no neighbour)", {}, [](Values) { return Real{0}; }, [](Values) { return std::string("0"); }};
    std::string formula = fmt::format("p = ({} − Δx² (d̃ − d) / Δt) / {}", sum_of_symbols(inputs), n);
    for (Input& in :
         std::vector<Input>{dx(), Input::now("d̃", "divergence_before", cell), Input::now("d", "divergence_after", cell), dt_})
        inputs.push_back(in);
    return {std::move(formula), std::move(inputs), [n](Values x) {
                Real sum = 0;
                for (std::size_t k = 0; k < n; ++k) sum += x[k];
                return (sum - x[n] * x[n] * (x[n + 1] - x[n + 2]) / x[n + 3]) / static_cast<Real>(n);
            }};
}

Explanation GridWhy::remaining_divergence(Index cell) const {
    if (!grid_.is_fluid(cell)) return fixed_value("∇·u = 0   (a solid cell)", 0);
    std::vector<Input> inputs = pressures_beside(cell);
    const std::size_t n = inputs.size();
    std::string formula = n ? fmt::format("∇·u = d̃ − Δt ({} − {} p) / Δx²", sum_of_symbols(inputs), n) : "∇·u = d̃";
    if (n) {
        inputs.push_back(Input::now("p", "pressure", cell));
        inputs.push_back(dt_);
        inputs.push_back(dx());
    }
    inputs.push_back(Input::now("d̃", "divergence_before", cell));
    return {std::move(formula), std::move(inputs), [n](Values x) {
                if (n == 0) return x[0];
                Real sum = 0;
                for (std::size_t k = 0; k < n; ++k) sum += x[k];
                return x[n + 3] - x[n + 1] * (sum - static_cast<Real>(n) * x[n]) / (x[n + 2] * x[n + 2]);
            }};
}

Explanation GridWhy::projected(int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    return {"u′ = ũ − Δt (p_high − p_low) / Δx",
            {sample("ũ", From::before, face_field(axis), face), dt_,
             Input::now("p_high", "pressure", grid_.cell_beside(axis, face, 1)),
             Input::now("p_low", "pressure", grid_.cell_beside(axis, face, 0)), dx()},
            [](Values x) { return x[0] - x[1] * (x[2] - x[3]) / x[4]; }};
}

Explanation GridWhy::cell_velocity(Index cell, int component) const {
    const int axis = component;
    const Lattice<2>& faces = grid_.faces(axis);
    Counts<2> low = grid_.cells().coordinates(cell), high = low;
    high[axis] = (high[axis] + 1) % faces.count[axis];
    const std::string_view field = face_field(axis);
    return {axis == 0 ? "u_c = ½ (u_left + u_right)" : "v_c = ½ (v_below + v_above)",
            {Input::now(axis == 0 ? "u_left" : "v_below", field, faces.index(low)),
             Input::now(axis == 0 ? "u_right" : "v_above", field, faces.index(high))},
            [](Values x) { return 0.5 * (x[0] + x[1]); }};
}

Explanation GridWhy::speed(Index cell) const {
    return {"|u| = √(u_x² + u_y²)",
            {Input::now("u_x", "velocity", cell, 0), Input::now("u_y", "velocity", cell, 1)},
            [](Values x) { return std::hypot(x[0], x[1]); }};
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
    why.evaluate = [](Values x) { return ((x[0] - x[1] + x[2] - x[3]) - (x[4] - x[5] + x[6] - x[7])) / (4 * x[8]); };
    return why;
}

Explanation GridWhy::courant(const FaceField<2>& velocity) const {
    int axis = 0;
    Index face = 0, at = 0;
    Real largest = -1;
    for (int a = 0; a < 2; ++a)
        if (const Real here = velocity[a].cwiseAbs().maxCoeff(&at); here > largest) largest = here, axis = a, face = at;
    return {"CFL = |u| Δt / Δx   (the fastest face)", {Input::now("u", face_field(axis), face), dt_, dx()}, [](Values x) {
                return std::abs(x[0]) * x[1] / x[2];
            }};
}

Explanation largest(std::string_view name, const VecX& values, std::string_view field) {
    Index at = 0;
    values.cwiseAbs().maxCoeff(&at);
    return {fmt::format("{} = |d|   (largest of all cells: in cell {})", name, at), {Input::now("d", field, at)}, [](Values x) {
                return std::abs(x[0]);
            }};
}

}  // namespace pliant::flow
