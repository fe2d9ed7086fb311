// The start, and the stages of a step: the velocity, the path back, the interpolation, the correction, and what is compared.
#include "advection_lesson.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::carrying {
namespace {

using std::numbers::pi;

const Registration<AdvectionLesson> registration{
    {.id = "fluids/advection",
     .title = "Advection",
     .summary = "A blob carried by a steady flow: the path back, the samples and their weights, and what each scheme loses.",
     .demo_steps = 60}};

}  // namespace

SteadyFlow AdvectionLesson::flow() const { return {field, direction * pi / 180}; }

// The translation starts in the middle; the others above it, where the flow is fast.
Blob AdvectionLesson::shape() const {
    const Vec<2> start = field == FlowKind::translation ? Vec<2>(0.5, 0.5) : Vec<2>(0.5, 0.75);
    return {blob, start, radius};
}

// ------------------------------------------------------------------------------------------------------ the initial state

void AdvectionLesson::reset() {
    StaggeredGridInfo<2> info;
    info.cells = {resolution, resolution};
    info.dx = dx();
    info.periodic.fill(flow().periodic());
    grid_ = std::make_unique<StaggeredGrid<2>>(info);
    velocity_ = face_velocity(*grid_, flow());
    advection_.reset();
    for (auto& rival : rivals_) rival.reset();
    const Index n = grid_->cells().size();
    origin_.resize(2, n);
    quantity_.resize(n);
    elapsed_.setZero();
    for (Index c = 0; c < n; ++c) {
        origin_.col(c) = centre_of(c);
        quantity_[c] = shape().value(centre_of(c));
    }
    for (VecX& q : rival_) q = compare ? quantity_ : VecX();
    previous_ = returned_ = exact_ = quantity_;
    error_ = way_ = VecX::Zero(n);
    middle_ = departure_ = origin_;
    cell_velocity(*grid_, velocity_, centre_velocity_);
    first_variance_ = variance(quantity_);
    first_moment_ = second_moment(quantity_);
    renew_advection();
}

// What carries follows from the parameters; a change of scheme begins with the next step.
void AdvectionLesson::renew_advection() {
    const auto renew = [this](std::unique_ptr<SemiLagrangian<2>>& advection, const AdvectionSettings& wanted) {
        if (advection && advection->settings() == wanted) return;
        advection = std::make_unique<SemiLagrangian<2>>(*grid_, wanted);
        VecX still = quantity_;
        advection->carry(still, velocity_, 0);
    };
    renew(advection_, grid2d::settings_of(scheme, back_trace));
    if (compare)
        for (std::size_t k = 0; k < 3; ++k) renew(rivals_[k], grid2d::settings_of(schemes[k], back_trace));
}

void AdvectionLesson::declare_stages() {
    formula_symbols = grid2d::symbols_and({{"ψ", "m²/s"}, {"q̂"}, {"w"}});
    stages = {
        stage_of("velocity", "on faces (ψ_above − ψ_below)/Δx;   at a centre u = ½ (u_left + u_right), v = ½ (v_below + v_above)",
                 "HarlowWelch1965; Bridson2007",
                 [this] {
                     renew_advection();
                     velocity_ = face_velocity(*grid_, flow());
                     cell_velocity(*grid_, velocity_, centre_velocity_);
                 })
            .done_in("core/pliant/fluids/carried_blob.cpp: face_velocity")
            .maps({}, {"u_on_faces", "v_on_faces", "velocity"})
            .because([this](const Question& q) {
                if (q.field != "velocity") return why_on_face(grid2d::axis_of(q.field), q.index);
                return why_velocity(q.index, q.component);
            }),
        stage_of("back_trace", "midpoint: x_m = x − ½Δt u(x),  x_d = x − Δt u(x_m);   Euler: x_d = x − Δt u(x)",
                 "Utrecht slides: semi-Lagrangian technique; Stam1999 §2.2; Bridson2007 §3.2", [this] { trace_back(); })
            .done_in("core/pliant/fluids/advection.cpp: departure")
            .shows([this]() -> std::string_view {
                return back_trace == BackTrace::midpoint ? "x_m = x − ½Δt u(x),  x_d = x − Δt u(x_m)" : "x_d = x − Δt u(x)";
            })
            .maps({"velocity", "u_on_faces", "v_on_faces"}, {"middle", "departure", "way"})
            .because([this](const Question& q) {
                if (q.field == "way") return why_way(q.index);
                return q.field == "middle" ? why_middle(q.index, q.component) : why_departure(q.index, q.component);
            }),
        stage_of("interpolation", "q′(x) = q(x_d) = Σ w_k q_k",
                 "Stam1999 §2.2; monotone cubic: FritschCarlson1980 §3, Fedkiw2001 appendix B",
                 [this] {
                     previous_ = quantity_;
                     advection_->carry(quantity_, velocity_, dt());
                 })
            .done_in("core/pliant/fluids/advection.cpp: interpolate_row")
            .maps({"departure", "quantity"}, {"previous", "quantity"})
            .because([this](const Question& q) {
                if (q.field == "quantity") return why_interpolated(q.index);
                return Explanation{"q_old = q", {Input::before("q", "quantity", q.index)}};
            }),
        stage_of("mac_cormack", "q ← q̂ + ½ (q_old − q̃),  q̃: q̂ carried back again;  within the samples around x_d", "Selle2008 §3",
                 [this] { correct(); })
            .done_in("core/pliant/fluids/advection.cpp: correct")
            .maps({"previous", "quantity"}, {"returned", "quantity"})
            .when([this] { return corrected(); })
            .because([this](const Question& q) {
                if (q.field == "quantity") return why_corrected(q.index);
                const Departure<2> ahead =
                    advection_->departure(grid_->cells().place(grid_->cells().coordinates(q.index)), -dt());
                return weighted_samples("q̃", advection_->forward(), ahead.departure, Input::From::before, "quantity");
            }),
        stage_of("other_schemes", "the same step with linear, monotone cubic and MacCormack, each on its own field",
                 "FritschCarlson1980 §3; Selle2008 §3",
                 [this] {
                     for (std::size_t k = 0; k < 3; ++k) rivals_[k]->advect(rival_[k], velocity_, dt());
                 })
            .done_in("core/pliant/fluids/advection.cpp: carry")
            .maps({"velocity"}, {"linear", "cubic", "mac_cormack"})
            .when([this] { return bool(compare); })
            .because([this](const Question& q) {
                const auto k = static_cast<std::size_t>(std::ranges::find(scheme_fields, q.field) - scheme_fields.begin());
                return grid2d::AdvectionWhy(*grid_, *rivals_[k], dt(), step()).quantity(q.field, q.index);
            }),
        stage_of("comparison", "q_exact(x, t) = q(X, 0),  X: where the fluid at x was at first;   e = q − q_exact",
                 "characteristics of ∂q/∂t + u·∇q = 0; Zalesak1979", [this] { compare_with_exact(); })
            .done_in("lessons/fluids/advection/advection_lesson.cpp: compare_with_exact")
            .maps({"quantity"}, {"exact", "error"})
            .because([this](const Question& q) {
                if (q.field == "exact") return why_exact(q.index);
                return Explanation{"e = q − q_exact",
                                   {Input::now("q", "quantity", q.index), Input::now("q_exact", "exact", q.index)}};
            })};
}

void AdvectionLesson::trace_back() {
    const Lattice<2>& cells = grid_->cells();
    for (Index c = 0; c < cells.size(); ++c) {
        const Departure<2> d = departure_of(c);
        for (int a = 0; a < 2; ++a) {
            middle_(a, c) = dx() * d.middle[a];
            departure_(a, c) = dx() * d.departure[a];
        }
        way_[c] = std::hypot(d.free_departure[0] - d.arrival[0], d.free_departure[1] - d.arrival[1]);
    }
}

void AdvectionLesson::correct() {
    advection_->correct(quantity_, dt());
    const Lattice<2>& cells = grid_->cells();
    for (Index c = 0; c < cells.size(); ++c)
        returned_[c] =
            advection_->forward().interpolated(advection_->departure(cells.place(cells.coordinates(c)), -dt()).departure);
}

void AdvectionLesson::compare_with_exact() {
    elapsed_[0] += dt();
    for (Index c = 0; c < quantity_.size(); ++c) {
        // A steady flow takes the origin of the fluid back by one more step.
        origin_.col(c) = field == FlowKind::vortex ? flow().before(origin_.col(c), dt()) : flow().before(centre_of(c), time());
        exact_[c] = shape().value(origin_of(c));
    }
    error_ = quantity_ - exact_;
}

}  // namespace pliant::carrying
