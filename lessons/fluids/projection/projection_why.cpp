// How the numbers of a projection on the staggered grid came about, and those that both grids share.
#include "projection.h"

#include <pliant/fluids/diagnostics.h>

#include <fmt/format.h>

#include <map>

namespace pliant::projection {
namespace {

using From = Input::From;

constexpr std::array<std::string_view, 2> cell_fields{"u_in_cells", "v_in_cells"};
constexpr std::array<const char*, 4> way{"left", "right", "below", "above"};

int axis_of(std::string_view field) { return field == "v_on_faces" || field == cell_fields[1] ? 1 : 0; }

// On the collocated grid: central differences over two cells.
struct CollocatedWhy {
    const Lattice<2>& cells;
    Input dx, dt;

    // The cell one step along an axis; beyond a wall the cell itself, and `inside` says so.
    struct CellBeside {
        Index cell;
        bool inside;
    };
    CellBeside beside(Index cell, int axis, int side) const {
        const Index n = cells.neighbour(cells.coordinates(cell), axis, side == 0 ? -1 : 1);
        return n >= 0 ? CellBeside{n, true} : CellBeside{cell, false};
    }

    Explanation divergence(Index cell, From from) const {
        Explanation why{from == From::before ? "∇·ũ = (u_right − u_left + v_above − v_below) / (2 Δx)"
                                             : "∇·u = (u_right − u_left + v_above − v_below) / (2 Δx)"};
        for (int k = 0; k < 4; ++k) {
            const int axis = k / 2;
            const CellBeside b = beside(cell, axis, k % 2);
            const std::string symbol = fmt::format("{}_{}", axis == 0 ? "u" : "v", way[static_cast<std::size_t>(k)]);
            Input there = grid2d::sample(b.inside ? symbol : "q", from, cell_fields[static_cast<std::size_t>(axis)], b.cell);
            why.inputs.push_back(
                b.inside
                    ? there
                    : Input::part(symbol, "m/s", {symbol + " = −q   (mirrored, so that nothing crosses the wall)", {there}}));
        }
        why.inputs.push_back(dx);
        return why;
    }

    // The cells that 4Δx² ∇·∇p takes its values from, with their weights: those two steps away, and the cell itself.
    std::map<Index, Real> wide_row(Index cell) const {
        std::map<Index, Real> row;
        for (int k = 0; k < 4; ++k) {
            const int axis = k / 2, side = k % 2;
            const CellBeside b = beside(cell, axis, side);
            // The divergence adds the cell on the high side and subtracts the low one; beyond a wall the gradient is mirrored.
            const Real sign = (side == 1 ? 1 : -1) * (b.inside ? 1 : -1);
            row[beside(b.cell, axis, 1).cell] += sign;
            row[beside(b.cell, axis, 0).cell] -= sign;
        }
        std::erase_if(row, [](const auto& entry) { return entry.second == 0; });
        return row;
    }

    // "2 p1 − 4 p2", whose pressures join the inputs; "0" without any.
    static std::string sum_over(const std::map<Index, Real>& row, std::vector<Input>& inputs) {
        std::string sum;
        int k = 0;
        for (const auto& [other, weight] : row) {
            const std::string symbol = fmt::format("p{}", ++k);
            sum += fmt::format("{}{:g} {}",
                               sum.empty()  ? (weight < 0 ? "−" : "")
                               : weight < 0 ? " − "
                                            : " + ",
                               std::abs(weight), symbol);
            inputs.push_back(Input::now(symbol, "pressure", other));
        }
        return sum.empty() ? "0" : sum;
    }

    Explanation pressure(Index cell) const {
        std::map<Index, Real> row = wide_row(cell);
        const Real own = row.contains(cell) ? row[cell] : 0;
        if (own == 0) return fixed_value("p = 0   (the grid sees no pressure here)");
        row.erase(cell);
        std::vector<Input> inputs{Input::now("d̃", "divergence_before", cell), Input::now("d", "divergence_after", cell), dx, dt};
        const std::string sum = sum_over(row, inputs);
        return {fmt::format("p = ({} − 4 Δx² (d̃ − d) / Δt) / {:g}", sum, -own), std::move(inputs)};
    }

    Explanation remaining(Index cell) const {
        std::vector<Input> inputs{Input::now("d̃", "divergence_before", cell), dx, dt};
        const std::string sum = sum_over(wide_row(cell), inputs);
        return {fmt::format("∇·u = d̃ − Δt ({}) / (4 Δx²)", sum), std::move(inputs)};
    }

    Explanation gradient(int axis, Index cell) const {
        return {"g = Δt (p_next − p_before) / (2 Δx)",
                {dt, Input::now("p_next", "pressure", beside(cell, axis, 1).cell),
                 Input::now("p_before", "pressure", beside(cell, axis, 0).cell), dx}};
    }

    Explanation projected(int axis, Index cell) const {
        Explanation why = gradient(axis, cell);
        why.formula = "u′ = ũ − Δt (p_next − p_before) / (2 Δx)";
        why.inputs.insert(why.inputs.begin(), Input::before("ũ", cell_fields[static_cast<std::size_t>(axis)], cell));
        return why;
    }
};

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- given

Explanation Projection::why_given(const Question& q) const {
    const int axis = axis_of(q.field);
    const std::string left = axis == 0 ? "ũ" : "ṽ";
    if (!staggered()) return field_.why(left, axis, grid_->cells(), dx(), q.index, central_[axis][q.index]);
    if (!grid_why().closed(axis, q.index))
        return field_.why(left, axis, grid_->faces(axis), dx(), q.index, tentative_[axis][q.index]);
    const Real wall = tentative_[axis][q.index];
    if (wall == 0) return fixed_value(left + " = 0   (the face lies on a wall or a solid at rest)");
    const bool right = grid_->cell_beside(axis, q.index, 1) < 0;
    if (right) return {left + " = a U   (the face lies on the wall where the fluid leaves)", {outflow, speed}};
    return {left + " = U   (the face lies on the wall where the fluid enters)", {speed}};
}

Explanation Projection::why_divergence(Index cell, From from) const {
    if (!staggered()) return CollocatedWhy{grid_->cells(), grid_why().dx(), dt}.divergence(cell, from);
    if (!grid_->is_fluid(cell)) return fixed_value("∇·u = 0   (a solid cell)");
    return grid_why().divergence(cell, from);
}

Explanation Projection::why_passes() const {
    const Real count = tally_[passes];
    if (count == 0) return fixed_value("n = 0   (the velocity had no divergence to begin with)");
    return {"n = n_before + 1   (each pass counts)",
            {Input::constant("n_before", count - 1, "", "passes of the solver before the last one")}};
}

// Of the solver's passes, and of the projection that follows them.
std::optional<Explanation> Projection::why_pressure_pass(const Question& q) const {
    const bool of_pressure = q.field == "pressure", of_divergence = q.field == "divergence_after";
    if (q.field == "solver_iterations") return why_passes();
    if (of_divergence && tally_[projected] != 0) return why_divergence(q.index, From::now);
    const CollocatedWhy central{grid_->cells(), grid_why().dx(), dt};
    if (!of_pressure && !of_divergence)
        return staggered() ? grid_why().projected(axis_of(q.field), q.index) : central.projected(axis_of(q.field), q.index);
    if (!staggered()) return of_pressure ? central.pressure(q.index) : central.remaining(q.index);
    if (!grid_->is_fluid(q.index)) return fixed_value(of_pressure ? "p = 0   (a solid cell)" : "∇·u = 0   (a solid cell)");
    return of_pressure ? grid_why().pressure(q.index) : grid_why().remaining_divergence(q.index);
}

// ---------------------------------------------------------------------------------------------------------------- parts

Explanation Projection::why_part(const Question& q) const {
    const int axis = q.component;
    if (q.field == "solenoidal_part")
        return {"s = u − m",
                {Input::now("u", "velocity", q.index, axis),
                 Input::constant("m", drift_[axis], "m/s", "mean of the velocity along a periodic axis; 0 between walls")}};
    if (!staggered()) return CollocatedWhy{grid_->cells(), grid_why().dx(), dt}.gradient(axis, q.index);
    // Of one face of the cell: Δt times the difference of the pressures beside it.
    const auto face_gradient = [&](const std::string& left, int side) -> Explanation {
        Counts<2> face = grid_->cells().coordinates(q.index);
        face[axis] = (face[axis] + side) % grid_->faces(axis).count[axis];
        const Index f = grid_->faces(axis).index(face);
        if (grid_why().closed(axis, f)) return fixed_value(left + " = 0   (a closed face)");
        return {left + " = Δt (p_high − p_low) / Δx",
                {dt, Input::now("p_high", "pressure", grid_->cell_beside(axis, f, 1)),
                 Input::now("p_low", "pressure", grid_->cell_beside(axis, f, 0)), grid_why().dx()}};
    };
    return {"g = ½ (g_low + g_high)",
            {Input::part("g_low", "m/s", face_gradient("g_low", 0)), Input::part("g_high", "m/s", face_gradient("g_high", 1))}};
}

Explanation Projection::why_velocity(const Question& q) const {
    if (staggered()) return grid_why().cell_velocity(q.index, q.component);
    return {q.component == 0 ? "u_c = u" : "u_c = v",
            {Input::now(q.component == 0 ? "u" : "v", cell_fields[static_cast<std::size_t>(q.component)], q.index)}};
}

// Half the sum of the squares over the cells; a face belongs half to each of the two beside it.
Explanation Projection::why_energy() const {
    Explanation e{"e = ½ Σ_f w_f u_f² / N, w: ½ on a wall, 1 elsewhere",
                  {Input::constant("N", static_cast<Real>(std::max<Index>(1, grid_->fluid_cells())), "", "cells of fluid")}};
    for (int a = 0; a < 2; ++a) {
        const VecX& u = staggered() ? velocity_[a] : central_[a];
        const auto& closed = grid_->closed_faces(a);
        auto next_closed = closed.begin();
        for (Index k = 0; k < u.size(); ++k) {
            Real share = 1;
            if (staggered() && next_closed != closed.end() && *next_closed == k) {
                share = 0.5 * grid_->fluid_beside_closed(a)[static_cast<std::size_t>(next_closed - closed.begin())];
                ++next_closed;
            }
            if (share == 0 || u[k] == 0) continue;
            const std::string_view field = staggered() ? grid2d::face_field(a) : cell_fields[static_cast<std::size_t>(a)];
            e.inputs.push_back(Input::constant(fmt::format("w_{}", k), share, "", "how much of the face is a cell's").in("w_f"));
            e.inputs.push_back(Input::now("u", field, k).in("u_f"));
        }
    }
    if (e.inputs.size() == 1) return fixed_value("e = 0: the fluid is at rest");
    return e;
}

}  // namespace pliant::projection
