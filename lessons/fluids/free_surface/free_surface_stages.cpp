// The stages of a step.
#include "free_surface.h"

#include <pliant/fluids/diagnostics.h>

namespace pliant::free_surface {

void FreeSurface::declare_stages() {
    using grid2d::axis_of;
    formula_symbols = grid2d::symbols_and({{"s", "m"}});
    stages = {stage_of("moving_solids", "u·n = u_paddle·n on the paddle; along it the liquid is free",
                       "Utrecht slides, boundary: u·n = u_body·n; Bridson2007 §4.2",
                       [this] {
                           follow_state();
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/liquid.cpp: set_solids, classify")
                  .maps({}, {"u_on_faces", "v_on_faces"})
                  .when([this] { return has_paddle(); })
                  .because([this](const Question& q) { return why_solid(axis_of(q.field), q.index); }),
              stage_of("external_forces", "ũ ← u + Δt g", "Utrecht slides, Navier–Stokes equations; Stam1999 §2.2",
                       [this] {
                           if (!has_paddle()) follow_state();
                           liquid_->add_force({0, -gravity}, dt);
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/liquid.cpp: add_force")
                  .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
                  .because([this](const Question& q) { return why_force(axis_of(q.field), q.index); }),
              stage_of("advection", "ũ(x) ← ũ(x − Δt ũ(x − ½Δt ũ(x)))", "semi-Lagrangian: Stam1999 §2.2; Bridson2007 §3",
                       [this] {
                           liquid_->advect(dt);
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/advection.cpp: trace_row, interpolate_row")
                  .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
                  .because([this](const Question& q) { return why_advected(axis_of(q.field), q.index); }),
              stage_of("projection", "Δt ∇²p = ∇·ũ,   p = 0 on the surface,   u ← ũ − Δt ∇p",
                       "Utrecht slides, pressure on boundary nodes; Chorin1968; Gibou2002 §2; Bridson2007 §4.3",
                       [this] { projection_pass(); })
                  .done_in("core/pliant/fluids/pressure_solve.cpp: iterate; "
                           "core/pliant/fluids/pressure_gradient.cpp: subtract_gradient")
                  .maps({"velocity", "pressure", "distance"},
                        {"divergence_before", "pressure", "divergence_after", "u_on_faces", "v_on_faces"})
                  .repeats([this] { return !liquid_->projection().converged(); }, [this] { begin_projection(); },
                           [this] { end_projection(); })
                  .because([this](const Question& q) { return why_projection(q); }),
              stage_of("continuation", "in the air u is the mean of its neighbours nearer to the liquid", "Bridson2007",
                       [this] {
                           liquid_->continue_velocity();
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/extrapolation.cpp: fill")
                  .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
                  .because([this](const Question& q) { return why_continued(axis_of(q.field), q.index); }),
              stage_of("surface", "φ(x) ← φ(x − Δt u(x − ½Δt u(x)))", "level set: OsherSethian1988; Bridson2007 §6",
                       [this] { liquid_->advect_surface(dt); })
                  .done_in("core/pliant/fluids/advection.cpp: carry")
                  .maps({"velocity", "distance"}, {"distance"})
                  .because([this](const Question& q) {
                      const LevelSet<2>& surface = liquid_->surface();
                      return grid2d::AdvectionWhy(surface.box(), surface.advection(), dt, dt).quantity("distance", q.index);
                  }),
              stage_of("redistancing", "|∇φ| = 1, with the surface φ = 0 where it is",
                       "Zhao2005; beside the surface: RussoSmereka2000 §3", [this] { liquid_->redistance(); })
                  .done_in("core/pliant/fluids/level_set.cpp: redistance, distance_from")
                  .maps({"distance"}, {"distance"})
                  .because([this](const Question& q) { return why_redistanced(q.index); }),
              stage_of("volume", "φ ← φ − s, with s such that V(φ) is the volume at the start",
                       "bisection; the volume of cells: ScardovelliZaleski2000 §2",
                       [this] {
                           liquid_->kept_volume() = first_volume_;
                           shift_ = keep_volume ? liquid_->restore_volume() : 0;
                           elapsed_ += Real(dt);
                       })
                  .done_in("core/pliant/fluids/level_set.cpp: shift_to_volume")
                  .maps({"distance"}, {"distance"})
                  .because([this](const Question& q) {
                      return Explanation{"φ′ = φ − s",
                                         {Input::before("φ", "distance", q.index),
                                          Input::constant("s", shift_, "m", "way by which all of the surface was shifted")}};
                  })};
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

}  // namespace pliant::free_surface
