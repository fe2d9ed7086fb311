// The stages of a step, in the lecture's order or another.
#include "navier_stokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::navier_stokes {
namespace {

using std::numbers::pi;

// The stirrer pushes the fluid within about this distance ahead of it, on its way around a figure of eight.
constexpr Real stirrer_radius = 0.06, stirrer_width = 0.3, stirrer_height = 0.25;  // L, L, height of the box
constexpr Real stirrer_period = 8;                                                 // s
// A pull is a jet at its start, of this acceleration per metre that it is drawn out.
constexpr Real pull_radius = 0.06, pull_stiffness = 40;  // L, 1/s²

}  // namespace

void NavierStokes::declare_stages() {
    formula_symbols = grid2d::symbols_and({{"f", "m/s²"}});
    stages = {
        stage_of("external_forces", "ũ ← u + Δt f,   f: force per unit mass",
                 "Utrecht slides, Navier–Stokes equations; Stam1999 §2.2", [this] { external_forces(); })
            .done_in("core/pliant/fluids/forces.cpp: add_uniform_force, add_jet")
            .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
            .when([this] { return with_forces && forced(); })
            .because([this](const Question& q) { return why_force(grid2d::axis_of(q.field), q.index); }),
        stage_of("advection", "ũ(x) ← ũ(x_d),   x_d = x − Δt ũ(x − ½Δt ũ(x)): where it was a step ago",
                 "semi-Lagrangian: Stam1999 §2.2, Bridson2007 §3; monotone cubic: FritschCarlson1980; MacCormack: Selle2008",
                 [this] { advect(); })
            .done_in("core/pliant/fluids/advection.cpp: trace_row, interpolate_row")
            .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
            .when([this] { return bool(with_advection); })
            .because([this](const Question& q) { return why_advected().velocity(grid2d::axis_of(q.field), q.index); }),
        stage_of("viscosity", "implicit: ũ − (νΔt/Δx²)(Σũₙ − 4ũ) = ũ old;   explicit: ũ ← ũ + (νΔt/Δx²)(Σũₙ − 4ũ)",
                 "Utrecht slides, 4-neighbour stencil, with the 1/Δx² and the old value that they leave out; Stam1999 §2.2",
                 [this] { diffuse(); })
            .done_in("core/pliant/fluids/diffusion.cpp: diffuse_explicitly, diffuse_implicitly")
            .shows([this]() -> std::string_view {
                return scheme == Scheme::implicit_euler ? "ũ − (νΔt/Δx²)(Σũₙ − 4ũ) = ũ_old" : "ũ ← ũ + (νΔt/Δx²)(Σũₙ − 4ũ)";
            })
            .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
            .when([this] { return with_viscosity && nu() > 0; })
            .because([this](const Question& q) {
                const VecX* residual =
                    scheme == Scheme::implicit_euler ? &diffusion_->residual(grid2d::axis_of(q.field)) : nullptr;
                return why_on_grid().diffused(nu_input(), residual, grid2d::axis_of(q.field), q.index);
            }),
        stage_of("projection", "Δt ∇²p = ∇·ũ,   u ← ũ − Δt ∇p",
                 "Utrecht slides, pressure projection (p is p/ρ); Chorin1968; Bridson2007 §4.3", [this] { projection_pass(); })
            .done_in("core/pliant/fluids/pressure_solve.cpp: iterate; "
                     "core/pliant/fluids/pressure_gradient.cpp: subtract_gradient")
            .maps({"velocity", "pressure"}, {"divergence_before", "pressure", "divergence_after", "u_on_faces", "v_on_faces"})
            .repeats([this] { return !projection_->converged(); }, [this] { begin_projection(); }, [this] { end_projection(); })
            .when([this] { return bool(with_projection); })
            .because([this](const Question& q) { return why_on_grid().projection(q, projection_->converged()); }),
        stage_of("smoke", "s(x) ← s(x − Δt u(x − ½Δt u(x))),   s = 1 in the source",
                 "Stam1999 §2.4: a substance is carried by the flow", [this] { carry_smoke(); })
            .done_in("core/pliant/fluids/advection.cpp: carry")
            .maps({"velocity", "smoke"}, {"smoke"})
            .when([this] { return scene().drives.smoke; })
            .because([this](const Question& q) {
                if (std::ranges::binary_search(source_cells_, q.index)) return fixed_value("s = 1   (a cell of the source)");
                return why_advected().quantity("smoke", q.index);
            })};
    for (Stage& s : stages)
        s.end = [this, name = s.name, end = s.end] {
            if (end) end();
            end_stage(name);
        };
}

std::vector<std::string_view> NavierStokes::stage_order() const {
    switch (order) {
        case Order::lecture:
            break;
        case Order::projection_first:
            return {"projection", "external_forces", "advection", "viscosity"};
        case Order::advection_last:
            return {"external_forces", "viscosity", "projection", "advection"};
        case Order::forces_last:
            return {"advection", "viscosity", "projection", "external_forces"};
    }
    return {};
}

// Every stage that changes the velocity, and the step itself, which ends with the last stage in use.
void NavierStokes::end_stage(std::string_view name) {
    fields_of_flow_.renew();
    if (stages_in_use().back()->name == name) end_step();
}

void NavierStokes::end_step() {
    elapsed_[0] += dt;
    if (with_viscosity) elapsed_[1] += nu() * dt;
    if (with_forces) elapsed_[2] += uniform_force()[0] * dt;
    elapsed_[3] = largest_divergence();
    compare_velocity();
    if (scene().readings.wake) wake_.note(time(), wake_velocity(), 0.05 * reference_speed());
}

// Once in the time in which the fastest fluid goes the length L: what the solver leaves open in a single step evens out.
void NavierStokes::compare_velocity() {
    elapsed_[4] = std::max(top_speed(), max_speed(velocity_));
    const Real since = time() - elapsed_[5], crossing = top_speed() > 0 ? size / top_speed() : Real{0};
    if (since < crossing) return;
    elapsed_[6] = 0;
    for (int axis = 0; axis < 2; ++axis)
        elapsed_[6] = std::max(elapsed_[6], (velocity_[axis] - compared_[axis]).lpNorm<Eigen::Infinity>());
    elapsed_[5] = time();
    compared_ = velocity_;
}

// ------------------------------------------------------------------------------------------------------------------ forces

// The middle of the stirrer: a figure of eight around the middle of the box.
Vec<2> NavierStokes::stirrer_place(Real time) const {
    const Real angle = 2 * pi * time / stirrer_period;
    return {width() * (0.5 + stirrer_width * std::sin(angle)), height() * (0.5 + stirrer_height * std::sin(2 * angle))};
}

Vec<2> NavierStokes::stirrer_heading(Real time) const {
    const Real angle = 2 * pi * time / stirrer_period;
    return Vec<2>(width() * stirrer_width * std::cos(angle), 2 * height() * stirrer_height * std::cos(2 * angle)).normalized();
}

NavierStokes::Jet NavierStokes::stirrer_jet(Real time) const {
    return {stirrer_place(time), stirrer_radius * size, stirring * stirrer_heading(time)};
}

NavierStokes::Jet NavierStokes::hand_jet() const {
    return {pull_->from.head<2>(), pull_radius * size, pull_stiffness * (pull_->to - pull_->from).head<2>()};
}

void NavierStokes::external_forces() {
    const auto push = [this](const Jet& jet) { add_jet<2>(*grid_, velocity_, dt, jet.centre, jet.radius, jet.acceleration); };
    force_time_ = time();
    if (stirred()) push(stirrer_jet(force_time_));
    add_uniform_force<2>(*grid_, velocity_, dt, uniform_force());
    if (scene().drives.smoke) add_buoyancy<2>(*grid_, velocity_, dt, 1, buoyancy, smoke_);
    if (pull_) push(hand_jet());
}

// --------------------------------------------------------------------------------------------------- the fluid's own terms

// The scheme may be changed on the way.
void NavierStokes::prepare_advection() {
    const AdvectionSettings wanted = grid2d::settings_of(advection, back_trace);
    if (!advection_ || advection_->settings() != wanted) advection_ = std::make_unique<SemiLagrangian<2>>(*grid_, wanted);
}

void NavierStokes::advect() {
    prepare_advection();
    advection_->advect(velocity_, dt);
}

void NavierStokes::diffuse() {
    if (!diffusion_) diffusion_ = std::make_unique<Viscosity<2>>(*grid_);
    if (scheme == Scheme::explicit_euler)
        diffusion_->diffuse_explicitly(velocity_, nu(), dt);
    else
        diffusion_->diffuse_implicitly(velocity_, nu(), dt);
}

void NavierStokes::begin_projection() {
    if (!projection_) projection_ = std::make_unique<PressureProjection<2>>(*grid_);
    divergence(*grid_, velocity_, divergence_before_);
    projection_->set({tolerance, max_iterations});
    projection_->pressure() = pressure_;
    projection_->begin(velocity_, dt);
}

void NavierStokes::projection_pass() {
    projection_->iterate();
    pressure_ = projection_->pressure();
    // The residual of the solver is the divergence that this pressure leaves.
    divergence_after_ = -dt / (dx() * dx()) * projection_->residual();
}

void NavierStokes::end_projection() {
    projection_->apply(velocity_);
    divergence(*grid_, velocity_, divergence_after_);
}

// ------------------------------------------------------------------------------------------------------------------- smoke

void NavierStokes::carry_smoke() {
    prepare_advection();
    advection_->advect(smoke_, velocity_, dt);
    for (const Index cell : source_cells_) smoke_[cell] = 1;
}

void NavierStokes::fill_source() {
    source_cells_.clear();
    if (!scene().drives.smoke) return;
    const SmokeSource source = smoke_source();
    const Lattice<2>& cells = grid_->cells();
    for (Index c = 0; c < cells.size(); ++c) {
        const GridPlace<2> at = cells.place(cells.coordinates(c));
        const Vec<2> place = Vec<2>(at[0], at[1]) / resolution.value();
        if ((place - source.centre).norm() < source.radius) source_cells_.push_back(c);
    }
    for (const Index cell : source_cells_) smoke_[cell] = 1;
}

}  // namespace pliant::navier_stokes
