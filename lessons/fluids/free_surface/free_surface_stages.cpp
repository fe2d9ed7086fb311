// The stages of a step.
#include "free_surface.h"

#include <pliant/fluids/diagnostics.h>

namespace pliant::free_surface {

void FreeSurface::declare_stages() {
    using flow::axis_of;
    stages = {{.name = "moving_solids",
               .formula = "u·n = u_paddle·n on the paddle; along it the liquid is free",
               .source = "Utrecht slides, boundary: u·n = u_body·n; Bridson2007 §4.2",
               .run = [this] { move_solids(); },
               .writes = {"u_on_faces", "v_on_faces"},
               .active = [this] { return has_paddle(); },
               .explain = [this](const Question& q) { return why_solid(axis_of(q.field), q.index); }},
              {.name = "external_forces",
               .formula = "ũ ← u + Δt g",
               .source = "Utrecht slides, Navier–Stokes equations; Stam1999 §2.2",
               .run = [this] { external_forces(); },
               .reads = {"velocity"},
               .writes = {"u_on_faces", "v_on_faces"},
               .explain = [this](const Question& q) { return why_force(axis_of(q.field), q.index); }},
              {.name = "advection",
               .formula = "ũ(x) ← ũ(x − Δt ũ(x − ½Δt ũ(x)))",
               .source = "semi-Lagrangian: Stam1999 §2.2; Bridson2007 §3",
               .run = [this] { advect(); },
               .reads = {"velocity"},
               .writes = {"u_on_faces", "v_on_faces"},
               .explain = [this](const Question& q) { return why_advected(axis_of(q.field), q.index); }},
              {.name = "projection",
               .formula = "Δt ∇²p = ∇·ũ,   p = 0 on the surface,   u ← ũ − Δt ∇p",
               .source = "Utrecht slides, pressure on boundary nodes; Chorin1968; Gibou2002 §2; Bridson2007 §4.3",
               .run = [this] { projection_pass(); },
               .reads = {"velocity", "pressure", "distance"},
               .writes = {"divergence_before", "pressure", "divergence_after", "u_on_faces", "v_on_faces"},
               .again = [this] { return !liquid_->projection().converged(); },
               .begin = [this] { begin_projection(); },
               .end = [this] { end_projection(); },
               .explain = [this](const Question& q) { return why_projection(q); }},
              {.name = "continuation",
               .formula = "in the air u is the mean of its neighbours nearer to the liquid",
               .source = "Bridson2007",
               .run = [this] { continue_velocity(); },
               .reads = {"velocity"},
               .writes = {"u_on_faces", "v_on_faces"},
               .explain = [this](const Question& q) { return why_continued(axis_of(q.field), q.index); }},
              {.name = "surface",
               .formula = "φ(x) ← φ(x − Δt u(x − ½Δt u(x)))",
               .source = "level set: OsherSethian1988; Bridson2007 §6",
               .run = [this] { move_surface(); },
               .reads = {"velocity", "distance"},
               .writes = {"distance"},
               .explain = [this](const Question& q) { return why_carried(q.index); }},
              {.name = "redistancing",
               .formula = "|∇φ| = 1, with the surface φ = 0 where it is",
               .source = "Zhao2005; beside the surface: RussoSmereka2000 §3",
               .run = [this] { redistance(); },
               .reads = {"distance"},
               .writes = {"distance"},
               .explain = [this](const Question& q) { return why_redistanced(q.index); }},
              {.name = "volume",
               .formula = "φ ← φ − s, with s such that V(φ) is the volume at the start",
               .source = "bisection; the volume of cells: ScardovelliZaleski2000 §2",
               .run = [this] { finish(); },
               .reads = {"distance"},
               .writes = {"distance"},
               .explain =
                   [this](const Question& q) {
                       return Explanation{"φ′ = φ − s",
                                          {Input::before("φ", "distance", q.index),
                                           Input::constant("s", shift_, "m", "way by which all of the surface was shifted")}};
                   }}};
}

// The state may have been put back to another time: what is liquid follows from it. The paddle is where it is now.
void FreeSurface::follow_state() { liquid_->set_solids(solids()); }

void FreeSurface::move_solids() {
    follow_state();
    fields_of_flow_.renew();
}

void FreeSurface::external_forces() {
    if (!has_paddle()) follow_state();
    liquid_->add_force({0, -gravity}, dt);
    fields_of_flow_.renew();
}

void FreeSurface::advect() {
    liquid_->advect(dt);
    fields_of_flow_.renew();
}

void FreeSurface::begin_projection() {
    divergence(liquid_->grid(), liquid_->velocity(), divergence_before_);
    PressureProjection<2>& projection = liquid_->projection();
    ProjectionSettings settings = projection.settings();
    settings.tolerance = tolerance;
    projection.set(settings);
    projection.pressure() = pressure_;
    liquid_->begin_projection(dt);
}

void FreeSurface::projection_pass() {
    PressureProjection<2>& projection = liquid_->projection();
    projection.iterate();
    pressure_ = projection.pressure();
    // The residual of the solver is the divergence that this pressure leaves.
    divergence_after_ = -dt / (dx() * dx()) * projection.residual();
}

void FreeSurface::end_projection() {
    liquid_->end_projection();
    divergence(liquid_->grid(), liquid_->velocity(), divergence_after_);
    fields_of_flow_.renew();
}

void FreeSurface::continue_velocity() {
    liquid_->continue_velocity();
    fields_of_flow_.renew();
}

void FreeSurface::move_surface() { liquid_->advect_surface(dt); }

void FreeSurface::redistance() { liquid_->redistance(); }

void FreeSurface::finish() {
    liquid_->kept_volume() = first_volume_;
    shift_ = keep_volume ? liquid_->restore_volume() : 0;
    elapsed_ += Real(dt);
}

}  // namespace pliant::free_surface
