// Incompressible flow on a staggered grid, one time step in the four stages of the lecture.
#pragma once
#include "kits/grid2d/advection_why.h"
#include "kits/grid2d/flow_readings.h"
#include "scenes.h"

#include <pliant/fluids/advection.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/forces.h>
#include <pliant/fluids/projection.h>
#include <pliant/lesson/registry.h>
#include <pliant/text/format.h>
#include <pliant/time/rhythm.h>

#include <cmath>
#include <memory>
#include <optional>

namespace pliant::navier_stokes {

enum class Scheme { implicit_euler, explicit_euler };
enum class Order { lecture, projection_first, advection_last, forces_last };

// A box that is stirred, a cavity with a lid, vortices, two channels, a disc in a stream, smoke: see scenes.h. Lengths are in
// units of L, the parameter `size`.
struct NavierStokes final : Lesson {
    NavierStokes() { declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return 2; }
    void check() const override;
    std::vector<std::string_view> stage_order() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return with_forces ? std::optional(On::cell) : std::nullopt; }
    void pull(const std::optional<Pull>& pull) override { pull_ = pull; }
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    // The errors of space and time shrink together.
    std::vector<std::pair<std::string, std::string>> finer() const override {
        return {{"resolution", std::to_string(std::min<Index>(2 * resolution, 512))}, {"time_step", format_exact(dt / 2)}};
    }
    std::string_view error_probe() const override { return "kinetic_energy"; }
    ColourBy first_colours() const override { return {std::string(scene().colours), scene().component}; }
    std::vector<Group> first_groups() const override { return {Group::scene, Group::method, Group::material, Group::forces}; }
    std::vector<std::string_view> first_plots() const override { return shown(scene().plots); }
    std::vector<std::string_view> key_numbers() const override { return shown(scene().key_numbers); }

    Choice<std::size_t> scenario{
        *this,
        setting_of("scene", "what the fluid is in and what drives it; the presets have one or two of each with fitting numbers")
            .in(Group::scene)
            .rebuilds(),
        scene_options()};
    Whole resolution{*this, quantity("resolution", "n", "", 96, {8, 256}, {1, 512}, "cells along the length L; Δx = L/n")
                                .in(Group::shape)
                                .rebuilds()};
    Number viscosity{*this,
                     log_quantity("viscosity", "ν", "m²/s", 1e-3, {1e-6, 1}, {0, 1e6},
                                  "kinematic viscosity μ/ρ; water 1e-6, oil 1e-4, honey 1e-2. 0 leaves the viscosity stage out")
                         .in(Group::material),
                     [this] { return with_viscosity && scene().reynolds_length == 0; }};
    Number reynolds{
        *this,
        log_quantity("reynolds", "Re", "", 100, {1, 1e4}, {1e-6, 1e9},
                     "U L/ν of the cavity, with its width; U D/ν of the vortex street, with the disc's diameter. It sets "
                     "the viscosity of these scenes")
            .in(Group::material),
        [this] { return with_viscosity && scene().reynolds_length > 0; }};
    Number dt{*this, log_quantity("time_step", "Δt", "s", 0.02, {1e-3, 0.5}, {0, 10, true},
                                  "fixed; semi-Lagrangian advection is stable at any, and accurate while CFL stays small")
                         .in(Group::method)};
    Number aspect{*this,
                  quantity("aspect", "H/W", "", 1, {0.25, 3}, {0.1, 10},
                           "height over width of the box or the cavity, rounded to whole cells")
                      .in(Group::shape)
                      .rebuilds(),
                  [this] { return scene().any_aspect; }};
    Number size{*this, log_quantity("size", "L", "m", 1, {0.01, 100}, {1e-6, 1e6},
                                    "width of the box, height of the channels; the vortex street has a channel of 2 L × 0.75 L")
                           .in(Group::shape)
                           .rebuilds()};
    Number lid_speed{*this,
                     quantity("lid_speed", "U", "m/s", 1, {-2, 2}, {-1e6, 1e6}, "of the upper wall, to the right")
                         .in(Group::forces)
                         .rebuilds(),
                     [this] { return scene().drives.lid; }};
    Number inflow{*this,
                  quantity("inflow", "U", "m/s", 1, {0.1, 2}, {0, 1e6},
                           "speed at which the fluid enters on the left, and leaves on the right: as much out as in")
                      .in(Group::forces)
                      .rebuilds(),
                  [this] { return scene().drives.inflow; }};
    Number stirring{*this,
                    quantity("stirring", "S", "m/s²", 6, {-20, 20}, {-1e6, 1e6},
                             "body force per unit mass in the middle of the stirrer; negative pushes backwards")
                        .in(Group::forces),
                    [this] { return with_forces && scene().drives.stirrer; }};
    Number body_force{*this,
                      quantity("body_force", "G", "m/s²", 0.1, {-1, 1}, {-1e6, 1e6},
                               "body force per unit mass along the channel: a slope's share of gravity, or a pressure drop per "
                               "length and density")
                          .in(Group::forces)
                          .rebuilds(),
                      [this] { return with_forces && scene().drives.body_force; }};
    Number buoyancy{*this,
                    quantity("buoyancy", "β", "m/s²", 2, {-5, 5}, {-1e6, 1e6},
                             "upward force per unit mass where the smoke is densest: g times its relative lightness")
                        .in(Group::forces),
                    [this] { return with_forces && scene().drives.smoke; }};
    Choice<Order> order{
        *this,
        setting_of("order",
                   "of the stages. The lecture has forces, advection, viscosity, projection; in another order the step ends with "
                   "divergence")
            .in(Group::method)
            .rebuilds(),
        {{"lecture", "the lecture's"},
         {"projection_first", "projection first"},
         {"advection_last", "advection last"},
         {"forces_last", "forces last"}}};
    Switch with_forces{*this, setting_of("with_forces", "f: without it nothing pushes the fluid but walls", 1).in(Group::method),
                       [this] { return scene().drives.by_force(); }};
    Switch with_advection{
        *this, setting_of("with_advection", "(u·∇)u: without it the fluid does not carry itself along, as in very thick flow", 1)
                   .in(Group::method)};
    Switch with_viscosity{*this, setting_of("with_viscosity", "ν ∇²u: without it walls drag nothing along", 1).in(Group::method)};
    Switch with_projection{
        *this, setting_of("with_projection", "−∇p: without it fluid piles up and thins out, and there is no pressure", 1)
                   .in(Group::method)
                   .rebuilds()};
    Choice<grid2d::Carrying> advection{
        *this,
        setting_of("advection_scheme",
                   "linear interpolation dissipates most; the monotone cubic less; MacCormack's correction makes the linear one "
                   "second order. None makes a new extremum")
            .once("advection")
            .in(Group::method),
        {{"semi_lagrangian", "semi-Lagrangian, linear"},
         {"monotone_cubic", "semi-Lagrangian, monotone cubic"},
         {"mac_cormack", "MacCormack"}},
        [this] { return with_advection || scene().drives.smoke; }};
    Choice<BackTrace> back_trace{
        *this,
        setting_of("back_trace",
                   "how a particle is followed back: straight with the velocity where it arrives (Euler), or with the velocity "
                   "half way",
                   1)
            .in(Group::method),
        {{"euler", "Euler"}, {"midpoint", "midpoint rule"}},
        [this] { return with_advection || scene().drives.smoke; }};
    Choice<Scheme> scheme{
        *this,
        setting_of("viscosity_scheme",
                   "implicit is stable at every Δt; explicit is the lecture's stencil, refused beyond Δt = Δx²/(4ν)")
            .in(Group::method),
        {{"implicit", "implicit Euler"}, {"explicit", "explicit Euler"}},
        [this] { return with_viscosity && nu() > 0; }};
    Number tolerance{*this,
                     log_quantity("tolerance", "τ", "", 1e-4, {1e-8, 0.5}, {1e-12, 1, false, true},
                                  "the pressure solver stops when max|∇·u| ≤ τ max|∇·ũ|")
                         .in(Group::solver),
                     [this] { return bool(with_projection); }};
    Whole max_iterations{*this,
                         quantity("max_iterations", "", "", 200, {1, 200}, {1, 1000},
                                  "of the pressure solver; when they are not enough the run stops and says what is left")
                             .in(Group::solver),
                         [this] { return bool(with_projection); }};

    const FlowScene& scene() const { return scenes()[scenario]; }
    SceneSettings settings() const { return {resolution, size, aspect, lid_speed, inflow}; }
    Real dx() const { return size / resolution.value(); }
    Real height() const { return static_cast<Real>(grid_->cell_counts()[1]) * dx(); }  // of the domain, m
    Real width() const { return static_cast<Real>(grid_->cell_counts()[0]) * dx(); }   // m
    // U of the scene: of the lid or the inflow, m/s; 0 for none
    Real reference_speed() const {
        return scene().drives.lid ? std::abs(lid_speed) : scene().drives.inflow ? Real(inflow) : Real{0};
    }
    // m²/s, given or set by the Reynolds number
    Real nu() const {
        const Real length = scene().reynolds_length;
        return length > 0 ? reference_speed() * length * size / reynolds : Real(viscosity);
    }
    const Parameter& speed_parameter() const { return scene().drives.lid ? static_cast<const Parameter&>(lid_speed) : inflow; }
    Input reynolds_length_input() const {
        return Input::constant("l", scene().reynolds_length, "", "length of the Reynolds number in units of L");
    }
    Input nu_input() const;
    // Up to now: the time, s; ∫ν dt, m²; ∫G dt, m/s; the largest divergence that the latest step left, 1/s; the largest velocity
    // since the start, m/s; when the velocity was last compared with what it was before, s, and what was found, m/s.
    Real time() const { return elapsed_[0]; }
    Real viscous_time() const { return elapsed_[1]; }
    Real pushed() const { return elapsed_[2]; }
    Real divergence_left() const { return elapsed_[3]; }
    Real top_speed() const { return elapsed_[4]; }

    // Names of readings, with the divergence that the step leaves in place of that which the projection leaves, where the two
    // are not the same.
    std::vector<std::string_view> shown(std::vector<std::string_view> names) const;

    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();

    // --- the stages (navier_stokes_stages.cpp) ---
    void end_stage(std::string_view name);
    void end_step();
    void compare_velocity();
    void external_forces();
    void advect();
    void prepare_advection();
    void diffuse();
    void begin_projection();
    void projection_pass();
    void end_projection();
    void carry_smoke();
    void fill_source();

    bool stirred() const { return scene().drives.stirrer && stirring != 0; }
    bool forced() const {
        return stirred() || pull_.has_value() || uniform_force() != Vec<2>::Zero() || (scene().drives.smoke && buoyancy != 0);
    }
    Vec<2> uniform_force() const { return {scene().drives.body_force ? Real(body_force) : Real{0}, 0}; }
    Vec<2> stirrer_place(Real time) const;    // m
    Vec<2> stirrer_heading(Real time) const;  // unit vector

    // A push of the fluid around a place.
    struct Jet {
        Vec<2> centre;        // m
        Real radius;          // m
        Vec<2> acceleration;  // m/s²
    };
    Jet stirrer_jet(Real time) const;
    Jet hand_jet() const;

    // Where a line differs most from what it is compared with.
    struct Difference {
        int axis;
        Real along, measured, expected;                                  // m, m/s, m/s
        operator Real() const { return std::abs(measured - expected); }  // its size
    };

    // --- how the numbers came about (navier_stokes_why.cpp) ---
    grid2d::GridWhy why_on_grid() const { return {*grid_, dt}; }
    grid2d::AdvectionWhy why_advected() const { return {*grid_, *advection_, dt, dt}; }
    Explanation why_force(int axis, Index face) const;
    Input why_jet(const std::string& symbol, const Jet& jet, Input strength, Real direction, int axis, Index face) const;
    Explanation why_max_speed() const;
    Explanation why_reynolds() const;
    Explanation why_difference(const Difference& d, const std::string& expected) const;

    Fix thicker_fluid(Real wanted) const;

    // --- what is measured ---
    Real wake_velocity() const { return velocity_[1][wake_face_]; }
    Real interpolation_viscosity() const;
    // Per mass, J/kg.
    Real specific_energy() const {
        return pliant::kinetic_energy(*grid_, velocity_) / (grid_->cell_volume() * static_cast<Real>(grid_->fluid_cells()));
    }
    Real largest_divergence() const;  // of the velocity as it stands, 1/s
    std::optional<Difference> largest_from_table() const;
    std::optional<Difference> largest_from_closed_form() const;
    // Component across `axis`, m/s, on the line through the middle along the other axis, at a distance from the wall in m.
    Real velocity_on_centre_line(int axis, Real along) const {
        return fields_of_flow_.flow().component(axis).at(place_on_centre_line(axis, along));
    }
    GridPlace<2> place_on_centre_line(int axis, Real along) const;  // in cells
    void profile(int axis, Curve& curve) const;
    void published_profile(int axis, Curve& curve) const;
    void steady_profile(Curve& curve) const;
    void present_profile(Curve& curve) const;
    // Of a channel at this time; none is known where forces or viscosity have changed on the way. y in m, result in m/s.
    bool has_closed_form() const;
    Real closed_form(Real y) const;

    // --- the picture (navier_stokes_picture.cpp) ---
    void draw_walls(Scene& scene) const;
    void draw_obstacle(Scene& scene) const;
    void draw_drives(Scene& scene) const;
    void write_notes(Scene& scene) const;
    // The speed whose arrow is as long as the arrows are apart. It does not follow the flow, so that arrows compare over time.
    Real arrow_speed() const { return scene().arrow_speed * (reference_speed() > 0 ? reference_speed() : 1); }

    std::unique_ptr<StaggeredGrid<2>> grid_;
    // Made when their stage first runs: a term that is off has no arrays.
    std::unique_ptr<SemiLagrangian<2>> advection_;
    std::unique_ptr<Viscosity<2>> diffusion_;
    std::unique_ptr<PressureProjection<2>> projection_;

    // What defines now: the velocity on the faces [m/s], the last pressure [m²/s²], from which the solver starts, the smoke, what
    // has passed, and the rhythm of the wake.
    FaceField<2> velocity_;
    VecX pressure_, smoke_;
    Eigen::Array<Real, 7, 1> elapsed_ = Eigen::Array<Real, 7, 1>::Zero();
    FaceField<2> compared_;  // the velocity when it was last compared
    Rhythm wake_;
    Real initial_energy_ = 0;  // J/kg
    std::vector<Index> source_cells_;
    Index wake_face_ = 0;  // where the wake is watched
    // What the stages make of it: ∇·u before and after the projection [1/s].
    VecX divergence_before_, divergence_after_;
    Real force_time_ = 0;  // s, at which the latest forces acted
    mutable VecX divergence_now_;
    FlowFields fields_of_flow_;
    std::optional<Pull> pull_;
};

}  // namespace pliant::navier_stokes
