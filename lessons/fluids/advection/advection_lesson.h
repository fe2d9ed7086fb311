// Advection: a blob carried by a steady flow, and what each scheme makes of it.
#pragma once
#include "kits/grid2d/advection_why.h"
#include "kits/grid2d/flow_readings.h"

#include <pliant/fluids/advection.h>
#include <pliant/fluids/carried_blob.h>
#include <pliant/fluids/interpolation_stencil.h>
#include <pliant/lesson/registry.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <optional>

namespace pliant::carrying {

using Scheme = grid2d::Carrying;
inline constexpr std::array<Scheme, 3> schemes{Scheme::linear, Scheme::monotone_cubic, Scheme::mac_cormack};
inline constexpr std::array<std::string_view, 3> scheme_fields{"linear", "cubic", "mac_cormack"};

// left = Σ w q_k over the samples that count at a place, in a field that held `values` when it was read.
Explanation weighted_samples(const std::string& left, const PaddedField<2>& values, const GridPlace<2>& place, Input::From from,
                             std::string_view name);

struct AdvectionLesson final : Lesson {
    AdvectionLesson() { declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return 2; }
    void reset() override;
    Real time_step() const override { return dt(); }
    std::string unrest() const override { return "the flow carries the blob around without end"; }
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return On::handle; }
    // The mark of the cell goes where the hand goes.
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override {
        if (pull.index != 0) return {};
        const auto cell = [&](Real x) { return std::clamp(std::floor(x / dx()), Real(0), static_cast<Real>(resolution - 1)); };
        return {{"cell_x", cell(pull.to[0])}, {"cell_y", cell(pull.to[1])}};
    }
    std::string blow_up_hint() const override {
        return fmt::format("every new value lies between old ones, at any step: this cannot happen with CFL = {}; reset",
                           format_quantity(cfl, "", 3));
    }
    std::optional<Fix> fix(const Failure&) const override { return Fix{"CFL = 1", {{"cfl", "1"}}}; }
    std::vector<std::pair<std::string, std::string>> finer() const override {
        return {{"resolution", std::to_string(std::min<Index>(2 * resolution, 320))}};
    }
    std::string_view error_probe() const override { return "difference"; }
    ColourBy first_colours() const override { return {"quantity"}; }
    std::vector<Group> first_groups() const override { return {Group::scene, Group::method, Group::start}; }
    std::vector<std::string_view> first_plots() const override {
        if (field == FlowKind::translation) return {"profile", "viscosity_of_cfl", "variance_left"};
        return {"profile", "variance_left", "difference"};
    }
    std::vector<std::string_view> key_numbers() const override { return {"turns", "peak", "variance_left"}; }

    Choice<FlowKind> field{
        *this,
        setting_of(
            "field",
            "uniform translation through a periodic box, solid rotation about the middle, or a vortex that draws the blob out", 1)
            .in(Group::scene)
            .rebuilds(),
        {{"translation", "translation, periodic box"}, {"rotation", "solid rotation"}, {"vortex", "vortex in a box"}}};
    Number direction{*this,
                     quantity("direction", "α", "°", 0, {0, 90}, {-360, 360}, "of the translation, from the x axis")
                         .in(Group::scene)
                         .rebuilds(),
                     [this] { return field == FlowKind::translation; }};
    Choice<BlobKind> blob{
        *this,
        setting_of("blob",
                   "a smooth blob exp(−2r²/R²), a cosine hill with an edge, or Zalesak's disc with a slot and sharp edges")
            .in(Group::start)
            .rebuilds(),
        {{"smooth", "smooth blob"}, {"hill", "cosine hill"}, {"slotted_disc", "slotted disc"}}};
    Number radius{*this, quantity("radius", "R", "m", 0.15, {0.05, 0.22}, {0.01, 0.25}, "of the blob; the box is 1 m wide")
                             .in(Group::start)
                             .rebuilds()};
    Whole resolution{*this,
                     quantity("resolution", "n", "", 64, {16, 160}, {8, 320}, "cells along each side of the box; Δx = 1 m / n")
                         .in(Group::shape)
                         .rebuilds()};
    Number cfl{
        *this,
        log_quantity("cfl", "C", "", 6, {0.1, 100}, {0.01, 200},
                     "Courant number U Δt/Δx: cells that the fastest fluid crosses in a step. It sets the time step, Δt = C Δx/U "
                     "with U = 1 m/s")
            .in(Group::method)};
    Choice<Scheme> scheme{
        *this,
        setting_of("advection_scheme", "what is read at the departure place, and whether the result is corrected")
            .once("scheme")
            .in(Group::method),
        {{"semi_lagrangian_linear", "linear"}, {"monotone_cubic", "monotone cubic"}, {"mac_cormack", "MacCormack, limited"}}};
    Choice<BackTrace> back_trace{
        *this,
        setting_of("back_trace",
                   "the path back: straight with the velocity here (Euler), or with the velocity half way (midpoint rule)", 1)
            .in(Group::method),
        {{"euler", "Euler"}, {"midpoint", "midpoint rule"}}};
    Switch compare{*this,
                   setting_of("compare", "all three schemes at once, beside the exact solution: the same flow, steps and paths")
                       .in(Group::view)
                       .rebuilds()};
    Whole cell_x{*this,
                 quantity("cell_x", "i", "", 22, {0, 159}, {0, 319},
                          "column of the cell whose way is drawn, counted from the left; drag its mark in the picture. Beyond "
                          "the last it is the last")
                     .in(Group::view)
                     .looks()};
    Whole cell_y{*this,
                 quantity("cell_y", "j", "", 47, {0, 159}, {0, 319}, "row of that cell, from below").in(Group::view).looks()};

    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();

    // --- the stages ---
    void trace_back();
    void correct();
    void compare_with_exact();

    Real dx() const { return Real(1) / resolution.value(); }
    Real dt() const { return cfl * dx() / SteadyFlow::top_speed; }
    Real time() const { return elapsed_[0]; }
    SteadyFlow flow() const;
    Blob shape() const;
    // The place that the fluid at a cell's centre was at when all began, m, by the shortest way around a periodic box.
    Vec<2> origin_of(Index cell) const {
        return shape().centre + shortest_way(origin_.col(cell), shape().centre, flow().periodic());
    }
    Vec<2> centre_of(Index cell) const {
        const GridPlace<2> at = grid_->cells().place(grid_->cells().coordinates(cell));
        return dx() * Vec<2>(at[0], at[1]);
    }
    void renew_advection();
    Departure<2> departure_of(Index cell) const {
        return advection_->departure(grid_->cells().place(grid_->cells().coordinates(cell)), dt());
    }
    Index selected() const {
        const Index last = resolution - 1;
        return grid_->cells().index({std::min<Index>(cell_x, last), std::min<Index>(cell_y, last)});
    }
    bool corrected() const { return scheme == Scheme::mac_cormack; }

    // --- how the numbers came about (advection_why.cpp) ---
    Input step() const;
    Explanation why_on_face(int axis, Index face) const;
    Explanation why_velocity(Index cell, int component) const {
        return grid2d::GridWhy(*grid_, step()).cell_velocity(cell, component);
    }
    Explanation why_middle(Index cell, int component) const;
    Explanation why_departure(Index cell, int component) const;
    Explanation why_way(Index cell) const {
        return {"d = √(u_m² + v_m²) Δt / Δx",
                {carrying_speed(cell, 0, "u_m"), carrying_speed(cell, 1, "v_m"), step(),
                 Input::constant("Δx", dx(), "m", "edge of a cell")}};
    }
    Input carrying_speed(Index cell, int component, std::string symbol) const;
    Explanation moved_into_box(Explanation why, Real free, Real place) const;
    Input why_fraction(Index cell, int axis, Index sample) const;
    Explanation why_interpolated(Index cell) const;
    Explanation why_corrected(Index cell) const;
    Explanation why_exact(Index cell) const;
    Explanation why_theory() const;

    // --- what is measured (advection_readings.cpp) ---
    Real variance(const VecX& q) const { return q.squaredNorm() * dx() * dx(); }  // ∫q² dA, m²
    Real second_moment(const VecX& q) const;  // mean square distance from the exact middle, m²
    // In m²/s. A viscosity ν makes the mean square distance grow by 4 ν t in a plane, by 2 ν t along each axis.
    std::optional<Real> measured_viscosity() const {
        if (time() == 0 || field == FlowKind::vortex || quantity_.sum() == 0) return std::nullopt;
        return (second_moment(quantity_) - first_moment_) / (4 * time());
    }
    Vec<2> exact_centre() const { return flow().before(shape().centre, -time()); }
    void profile(const VecX& q, Curve& curve) const;
    Real viscosity_at(Real courant, Real edge) const;  // edge: of a cell, m
    void viscosity_curve(Real edge, Curve& curve) const;
    // rad: how far the flow turns in a step, in its middle
    Real turn_of_step() const { return (field == FlowKind::vortex ? 2 * std::numbers::pi : 2) * SteadyFlow::top_speed * dt(); }

    // --- the picture (advection_picture.cpp) ---
    void draw_map(Scene& scene, const VecX& values, const Vec<2>& corner, std::string_view title, bool chosen) const;
    void draw_all_schemes(Scene& scene) const;
    void draw_path(Scene& scene) const;
    void draw_magnifier(Scene& scene) const;
    void write_notes(Scene& scene) const;

    std::unique_ptr<StaggeredGrid<2>> grid_;
    FaceField<2> velocity_;
    std::unique_ptr<SemiLagrangian<2>> advection_;
    std::array<std::unique_ptr<SemiLagrangian<2>>, 3> rivals_;

    // What defines now: the quantity, those of the other schemes where they are compared, where the fluid of each cell was at the
    // start [m], and the time [s].
    VecX quantity_;
    std::array<VecX, 3> rival_;
    Points<2> origin_;
    Eigen::Array<Real, 1, 1> elapsed_ = Eigen::Array<Real, 1, 1>::Zero();
    // What the stages make of it.
    VecX previous_, returned_, exact_, error_, way_;
    Points<2> centre_velocity_, middle_, departure_;
    Real first_variance_ = 1, first_moment_ = 0;
};

}  // namespace pliant::carrying
