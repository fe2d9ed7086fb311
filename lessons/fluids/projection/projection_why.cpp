// How the numbers of a projection on the staggered grid came about, and those that both grids share.
#include "projection.h"

#include <pliant/fluids/diagnostics.h>

#include <fmt/format.h>

namespace pliant::projection {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

constexpr std::array<std::string_view, 2> cell_fields{"u_in_cells", "v_in_cells"};

int axis_of(std::string_view field) { return field == "v_on_faces" || field == cell_fields[1] ? 1 : 0; }

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- given

Explanation Projection::why_given(const Question& q) const {
    const int axis = axis_of(q.field);
    const std::string left = axis == 0 ? "ũ" : "ṽ";
    if (!staggered()) return field_.why(left, axis, grid_->cells(), dx(), q.index, central_[axis][q.index]);
    if (!grid_why().closed(axis, q.index))
        return field_.why(left, axis, grid_->faces(axis), dx(), q.index, tentative_[axis][q.index]);
    const Real wall = tentative_[axis][q.index];
    if (wall == 0) return fixed_value(left + " = 0   (the face lies on a wall or a solid at rest)", 0);
    const bool right = grid_->cell_beside(axis, q.index, 1) < 0;
    if (right)
        return {left + " = a U   (the face lies on the wall where the fluid leaves)",
                {Input::of(outflow), Input::of(speed)},
                [](Values x) { return x[0] * x[1]; }};
    return {
        left + " = U   (the face lies on the wall where the fluid enters)", {Input::of(speed)}, [](Values x) { return x[0]; }};
}

Explanation Projection::why_divergence(Index cell, From from) const {
    if (!staggered()) return why_central_divergence(cell, from);
    if (!grid_->is_fluid(cell)) return fixed_value("∇·u = 0   (a solid cell)", 0);
    return grid_why().divergence(cell, from);
}

// ------------------------------------------------------------------------------------------------------------- pressure

std::optional<Explanation> Projection::why_pressure_pass(const Question& q) const {
    const bool of_pressure = q.field == "pressure";
    if (!staggered()) return of_pressure ? why_central_pressure(q.index) : why_central_remaining(q.index);
    if (!grid_->is_fluid(q.index)) return fixed_value(of_pressure ? "p = 0   (a solid cell)" : "∇·u = 0   (a solid cell)", 0);
    return of_pressure ? grid_why().pressure(q.index) : grid_why().remaining_divergence(q.index);
}

Explanation Projection::why_disturbed(Index cell) const {
    if (!grid_->is_fluid(cell)) return fixed_value("p′ = 0   (a solid cell)", 0);
    return {"p′ = p + A q",
            {flow::sample("p", From::before, "pressure", cell), Input::of(disturbance),
             Input::constant("q", parity(cell), "", "+1 and −1 in turn, along x and along y")}};
}

Explanation Projection::why_projected(const Question& q) const {
    const int axis = axis_of(q.field);
    return staggered() ? grid_why().projected(axis, q.index) : why_central_projected(axis, q.index);
}

// ---------------------------------------------------------------------------------------------------------------- parts

// Of one face of a cell: Δt times the difference of the pressures beside it.
Explanation Projection::why_face_gradient(const std::string& left, int axis, Index cell, int side) const {
    Counts<2> face = grid_->cells().coordinates(cell);
    face[axis] = (face[axis] + side) % grid_->faces(axis).count[axis];
    const Index f = grid_->faces(axis).index(face);
    if (grid_why().closed(axis, f)) return fixed_value(left + " = 0   (a closed face)", 0);
    return {left + " = Δt (p_high − p_low) / Δx",
            {Input::of(dt), Input::now("p_high", "pressure", grid_->cell_beside(axis, f, 1)),
             Input::now("p_low", "pressure", grid_->cell_beside(axis, f, 0)), grid_why().dx()},
            [](Values x) { return x[0] * (x[1] - x[2]) / x[3]; }};
}

Explanation Projection::why_part(const Question& q) const {
    const int axis = q.component;
    if (q.field == "solenoidal_part")
        return {"s = u − m",
                {Input::now("u", "velocity", q.index, axis),
                 Input::constant("m", drift_[axis], "m/s", "mean of the velocity along a periodic axis; 0 between walls")}};
    if (!staggered()) return why_central_gradient(axis, q.index);
    return {"g = ½ (g_low + g_high)",
            {Input::part("g_low", "m/s", why_face_gradient("g_low", axis, q.index, 0)),
             Input::part("g_high", "m/s", why_face_gradient("g_high", axis, q.index, 1))}};
}

Explanation Projection::why_velocity(const Question& q) const {
    if (staggered()) return grid_why().cell_velocity(q.index, q.component);
    return {q.component == 0 ? "u_c = u" : "u_c = v",
            {Input::now(q.component == 0 ? "u" : "v", cell_fields[static_cast<std::size_t>(q.component)], q.index)},
            [](Values x) { return x[0]; }};
}

// Half the sum of the squares over the cells; a face belongs half to each of the two beside it.
Explanation Projection::why_energy() const {
    std::vector<Input> inputs;
    std::vector<Real> shares;
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
            shares.push_back(share);
            const std::string_view field = staggered() ? flow::face_field(a) : cell_fields[static_cast<std::size_t>(a)];
            inputs.push_back(Input::now("u", field, k));
        }
    }
    const Real cells = static_cast<Real>(std::max<Index>(1, grid_->fluid_cells()));
    return {"e = ½ (Σ w u²) / N,   N cells; w: ½ on a wall, 1 elsewhere", std::move(inputs),
            [shares, cells](Values x) {
                Real sum = 0;
                for (std::size_t k = 0; k < x.size(); ++k) sum += shares[k] * x[k] * x[k];
                return 0.5 * sum / cells;
            },
            [cells](Values x) { return fmt::format("½ ({} squares) / {:g}", x.size(), cells); }};
}

}  // namespace pliant::projection
