// The stages of a step: the velocity, the path back, the interpolation, the correction, and what is compared.
#include "advection_lesson.h"

#include <pliant/fluids/diagnostics.h>

#include <algorithm>
#include <cmath>

namespace pliant::carrying {

void AdvectionLesson::declare_stages() {
    stages = {{.name = "velocity",
               .formula = "on faces (ψ_above − ψ_below)/Δx;   at a centre u = ½ (u_left + u_right), v = ½ (v_below + v_above)",
               .source = "HarlowWelch1965; Bridson2007",
               .run = [this] { find_velocity(); },
               .writes = {"u_on_faces", "v_on_faces", "velocity"},
               .explain =
                   [this](const Question& q) {
                       if (q.field != "velocity") return why_on_face(flow::axis_of(q.field), q.index);
                       return why_velocity(q.index, q.component);
                   }},
              {.name = "back_trace",
               .formula = "midpoint: x_m = x − ½Δt u(x),  x_d = x − Δt u(x_m);   Euler: x_d = x − Δt u(x)",
               .formula_in_force = [this]() -> std::string_view {
                   return back_trace == BackTrace::midpoint ? "x_m = x − ½Δt u(x),  x_d = x − Δt u(x_m)" : "x_d = x − Δt u(x)";
               },
               .source = "Utrecht slides: semi-Lagrangian technique; Stam1999 §2.2; Bridson2007 §3.2",
               .run = [this] { trace_back(); },
               .reads = {"velocity", "u_on_faces", "v_on_faces"},
               .writes = {"middle", "departure", "way"},
               .explain =
                   [this](const Question& q) {
                       if (q.field == "way") return why_way(q.index);
                       return q.field == "middle" ? why_middle(q.index, q.component) : why_departure(q.index, q.component);
                   }},
              {.name = "interpolation",
               .formula = "q′(x) = q(x_d) = Σ w_k q_k",
               .source = "Stam1999 §2.2; monotone cubic: FritschCarlson1980 §3, Fedkiw2001 appendix B",
               .run = [this] { interpolate(); },
               .reads = {"departure", "quantity"},
               .writes = {"previous", "quantity"},
               .explain =
                   [this](const Question& q) {
                       if (q.field == "quantity") return why_interpolated(q.index);
                       return Explanation{"q_old = q", {Input::before("q", "quantity", q.index)}, [](auto v) { return v[0]; }};
                   }},
              {.name = "mac_cormack",
               .formula = "q ← q̂ + ½ (q_old − q̃),  q̃: q̂ carried back again;  within the samples around x_d",
               .source = "Selle2008 §3",
               .run = [this] { correct(); },
               .reads = {"previous", "quantity"},
               .writes = {"returned", "quantity"},
               .active = [this] { return corrected(); },
               .explain =
                   [this](const Question& q) {
                       if (q.field == "quantity") return why_corrected(q.index);
                       return why_returned(q.index);
                   }},
              {.name = "other_schemes",
               .formula = "the same step with linear, monotone cubic and MacCormack, each on its own field",
               .source = "FritschCarlson1980 §3; Selle2008 §3",
               .run = [this] { carry_rivals(); },
               .reads = {"velocity"},
               .writes = {"linear", "cubic", "mac_cormack"},
               .active = [this] { return bool(compare); },
               .explain =
                   [this](const Question& q) {
                       return why_rival(
                           static_cast<std::size_t>(std::ranges::find(scheme_fields, q.field) - scheme_fields.begin()), q.index);
                   }},
              {.name = "comparison",
               .formula = "q_exact(x, t) = q(X, 0),  X: where the fluid at x was at first;   e = q − q_exact",
               .source = "characteristics of ∂q/∂t + u·∇q = 0; Zalesak1979",
               .run = [this] { compare_with_exact(); },
               .reads = {"quantity"},
               .writes = {"exact", "error"},
               .explain =
                   [this](const Question& q) {
                       if (q.field == "exact") return why_exact(q.index);
                       return Explanation{"e = q − q_exact",
                                          {Input::now("q", "quantity", q.index), Input::now("q_exact", "exact", q.index)},
                                          [](auto v) { return v[0] - v[1]; }};
                   }}};
}

void AdvectionLesson::find_velocity() {
    renew_advection();
    velocity_ = face_velocity(*grid_, flow());
    cell_velocity(*grid_, velocity_, centre_velocity_);
}

void AdvectionLesson::trace_back() {
    const Lattice<2>& cells = grid_->cells();
    for (Index c = 0; c < cells.size(); ++c) {
        const Departure<2> d = advection_->departure(cells.place(cells.coordinates(c)), dt());
        for (int a = 0; a < 2; ++a) {
            middle_(a, c) = dx() * d.middle[a];
            departure_(a, c) = dx() * d.departure[a];
        }
        way_[c] = std::hypot(d.free_departure[0] - d.arrival[0], d.free_departure[1] - d.arrival[1]);
    }
}

void AdvectionLesson::interpolate() {
    previous_ = quantity_;
    advection_->carry(quantity_, velocity_, dt());
}

void AdvectionLesson::correct() {
    advection_->correct(quantity_, dt());
    const Lattice<2>& cells = grid_->cells();
    for (Index c = 0; c < cells.size(); ++c)
        returned_[c] =
            advection_->forward().interpolated(advection_->departure(cells.place(cells.coordinates(c)), -dt()).departure);
}

void AdvectionLesson::carry_rivals() {
    for (std::size_t k = 0; k < 3; ++k) rivals_[k]->advect(rival_[k], velocity_, dt());
}

void AdvectionLesson::compare_with_exact() {
    elapsed_[0] += dt();
    for (Index c = 0; c < quantity_.size(); ++c) {
        // A steady flow takes the origin of the fluid back by one more step.
        origin_.col(c) = field == Flow::vortex ? flow().before(origin_.col(c), dt()) : flow().before(centre_of(c), time());
        exact_[c] = shape().value(origin_of(c));
    }
    error_ = quantity_ - exact_;
}

Vec<2> AdvectionLesson::origin_of(Index cell) const {
    return shape().centre + shortest(origin_.col(cell), shape().centre, flow().periodic());
}

}  // namespace pliant::carrying
