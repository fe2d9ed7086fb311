#include "advection_lesson.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace pliant::carrying {
namespace {

using std::numbers::pi;

const Registration<AdvectionLesson> registration{
    {.id = "fluids/advection",
     .title = "Advection",
     .summary = "A blob carried by a steady flow: the path back, the samples and their weights, and what each scheme loses.",
     .demo_steps = 60}};

}  // namespace

AdvectionLesson::AdvectionLesson()
    : field(
          *this,
          {.key = "field",
           .help =
               "uniform translation through a periodic box, solid rotation about the middle, or a vortex that draws the blob out",
           .initial = 1,
           .effect = Effect::rebuild},
          {{"translation", "translation, periodic box"}, {"rotation", "solid rotation"}, {"vortex", "vortex in a box"}}),
      direction(*this, {.key = "direction",
                        .symbol = "α",
                        .unit = "°",
                        .help = "of the translation, from the x axis",
                        .initial = 0,
                        .useful = {0, 90},
                        .accepted = Interval{-360, 360},
                        .effect = Effect::rebuild,
                        .used = [this] { return field == Flow::translation; }}),
      blob(*this,
           {.key = "blob",
            .help = "a smooth blob exp(−2r²/R²), a cosine hill with an edge, or Zalesak's disc with a slot and sharp edges",
            .effect = Effect::rebuild},
           {{"smooth", "smooth blob"}, {"hill", "cosine hill"}, {"slotted_disc", "slotted disc"}}),
      radius(*this, {.key = "radius",
                     .symbol = "R",
                     .unit = "m",
                     .help = "of the blob; the box is 1 m wide",
                     .initial = 0.15,
                     .useful = {0.05, 0.22},
                     .accepted = Interval{0.01, 0.25},
                     .effect = Effect::rebuild}),
      resolution(*this, {.key = "resolution",
                         .symbol = "n",
                         .help = "cells along each side of the box; Δx = 1 m / n",
                         .initial = 64,
                         .useful = {16, 160},
                         .accepted = Interval{8, 320},
                         .effect = Effect::rebuild}),
      cfl(*this,
          {.key = "cfl",
           .symbol = "C",
           .help = "Courant number U Δt/Δx: cells that the fastest fluid crosses in a step. It sets the time step, Δt = C Δx/U "
                   "with U = 1 m/s",
           .initial = 6,
           .useful = {0.1, 100},
           .accepted = Interval{0.01, 200},
           .scale = Scale::log}),
      scheme(
          *this, {.key = "scheme", .help = "what is read at the departure place, and whether the result is corrected"},
          {{"semi_lagrangian_linear", "linear"}, {"monotone_cubic", "monotone cubic"}, {"mac_cormack", "MacCormack, limited"}}),
      back_trace(*this,
                 {.key = "back_trace",
                  .help = "the path back: straight with the velocity here (Euler), or with the velocity half way (midpoint rule)",
                  .initial = 1},
                 {{"euler", "Euler"}, {"midpoint", "midpoint rule"}}),
      compare(*this, {.key = "compare",
                      .help = "all three schemes at once, beside the exact solution: the same flow, steps and paths",
                      .effect = Effect::rebuild}),
      cell_x(*this, {.key = "cell_x",
                     .symbol = "i",
                     .help = "column of the cell whose way is drawn, counted from the left; drag its mark in the picture. Beyond "
                             "the last it is the last",
                     .initial = 22,
                     .useful = {0, 159},
                     .accepted = Interval{0, 319}}),
      cell_y(*this, {.key = "cell_y",
                     .symbol = "j",
                     .help = "row of that cell, from below",
                     .initial = 47,
                     .useful = {0, 159},
                     .accepted = Interval{0, 319}}) {
    declare_fields();
    declare_stages();
    declare_probes();
    declare_viscosity_probes();
    declare_lines();
    declare_checks();
}

SteadyFlow AdvectionLesson::flow() const { return {field, direction * pi / 180}; }

// The translation starts in the middle; the others above it, where the flow is fast.
Shape AdvectionLesson::shape() const {
    const Vec<2> start = field == Flow::translation ? Vec<2>(0.5, 0.5) : Vec<2>(0.5, 0.75);
    return {blob, start, radius};
}

Vec<2> AdvectionLesson::centre_of(Index cell) const {
    const GridPlace<2> at = grid_->cells().place(grid_->cells().coordinates(cell));
    return dx() * Vec<2>(at[0], at[1]);
}

AdvectionSettings AdvectionLesson::settings(Scheme of) const {
    return {back_trace, of == Scheme::monotone_cubic ? Interpolation::monotone_cubic : Interpolation::linear,
            of == Scheme::mac_cormack};
}

Index AdvectionLesson::selected() const {
    const Index last = resolution - 1;
    return grid_->cells().index({std::min<Index>(cell_x, last), std::min<Index>(cell_y, last)});
}

// The mark of the cell goes where the hand goes.
std::vector<std::pair<std::string, Real>> AdvectionLesson::dragged(const Pull& pull) const {
    if (pull.index != 0) return {};
    const auto cell = [&](Real x) { return std::clamp(std::floor(x / dx()), Real(0), static_cast<Real>(resolution - 1)); };
    return {{"cell_x", cell(pull.to[0])}, {"cell_y", cell(pull.to[1])}};
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
    renew(advection_, settings(scheme));
    if (compare)
        for (std::size_t k = 0; k < 3; ++k) renew(rivals_[k], settings(schemes[k]));
}

std::string AdvectionLesson::blow_up_hint() const {
    return fmt::format("every new value lies between old ones, at any step: this cannot happen with CFL = {}; reset",
                       format_quantity(cfl, "", 3));
}

std::vector<std::pair<std::string, std::string>> AdvectionLesson::finer() const {
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, 320))}};
}

}  // namespace pliant::carrying
