// Incompressible flow on a staggered grid, one time step in the four stages of the lecture.
#pragma once
#include "fluids/flow/advection_why.h"
#include "fluids/flow/flow_fields.h"
#include "fluids/flow/grid_why.h"
#include "scenes.h"

#include <pliant/fluids/advection.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/forces.h>
#include <pliant/fluids/projection.h>
#include <pliant/lesson/registry.h>
#include <pliant/time/rhythm.h>

#include <cmath>
#include <memory>
#include <optional>

namespace pliant::navier_stokes {

enum class Scheme { implicit_euler, explicit_euler };
enum class Advection { semi_lagrangian, monotone_cubic, mac_cormack };
enum class Order { lecture, projection_first, advection_last, forces_last };

// A box that is stirred, a cavity with a lid, vortices, two channels, a disc in a stream, smoke: see scenes.h. Lengths are in
// units of L, the parameter `size`.
class NavierStokes final : public Lesson {
public:
    NavierStokes();

    int dimension() const override { return 2; }
    void check() const override;
    std::vector<std::string_view> stage_order() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return with_forces ? std::optional(On::cell) : std::nullopt; }
    void pull(const std::optional<Pull>& pull) override { pull_ = pull; }
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return "kinetic_energy"; }
    ColourBy first_colours() const override { return {std::string(scene().colours), scene().component}; }
    std::vector<std::string_view> first_plots() const override { return shown(scene().plots); }
    std::vector<std::string_view> key_numbers() const override { return shown(scene().key_numbers); }

private:
    Choice<std::size_t> scenario;  // index into scenes()
    Whole resolution;
    Number viscosity, reynolds, dt, aspect, size, lid_speed, inflow, stirring, body_force, buoyancy;
    Choice<Order> order;
    Switch with_forces, with_advection, with_viscosity, with_projection;
    Choice<Advection> advection;
    Choice<BackTrace> back_trace;
    Choice<Scheme> scheme;
    Number tolerance;
    Whole max_iterations;

    const FlowScene& scene() const { return scenes()[scenario]; }
    SceneSettings settings() const { return {resolution, size, aspect, lid_speed, inflow}; }
    Real dx() const { return size / static_cast<Real>(Index(resolution)); }
    Real height() const;           // of the domain, m
    Real width() const;            // m
    Real reference_speed() const;  // U of the scene: of the lid or the inflow, m/s; 0 for none
    Real nu() const;               // m²/s, given or set by the Reynolds number
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

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_wake_probes();
    void declare_lines();
    void declare_checks();

    // --- the stages (navier_stokes_stages.cpp) ---
    void end_stage(std::string_view name);
    void end_step();
    void compare_velocity();
    void external_forces();
    void advect();
    AdvectionSettings advection_settings() const;
    void prepare_advection();
    void diffuse();
    void begin_projection();
    void projection_pass();
    void end_projection();
    void carry_smoke();
    void fill_source();

    bool stirred() const { return scene().drives.stirrer && stirring != 0; }
    bool forced() const;
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

    // --- how the numbers came about (navier_stokes_why.cpp) ---
    flow::GridWhy why_on_grid() const;
    flow::AdvectionWhy why_advected() const { return {*grid_, *advection_, dt, Input::of(dt)}; }
    Explanation why_force(int axis, Index face) const;
    Input why_jet(const std::string& symbol, const Jet& jet, Input strength, Real direction, int axis, Index face) const;
    Input why_buoyancy(Index face) const;
    Explanation why_diffused(int axis, Index face) const;
    std::optional<Explanation> why_projection(const Question& q) const;
    Explanation why_smoke(Index cell) const;
    Explanation why_strouhal() const;
    Explanation why_effective_viscosity() const;
    Explanation why_max_speed() const;
    Explanation why_reynolds() const;
    Input on_centre_line(int axis, Real along) const;
    Explanation why_table_difference() const;
    Explanation why_profile_difference() const;

    std::optional<Fix> shorter_step(Real cells) const;  // that the fastest fluid may cross
    std::optional<Fix> thicker_fluid(Real wanted) const;

    // --- what is measured ---
    std::optional<Real> reynolds_number() const;
    std::optional<Real> effective_viscosity() const;
    std::optional<Real> strouhal() const;
    Real wake_velocity() const;
    Real interpolation_viscosity() const;
    Real specific_energy() const;  // J/kg
    // Where a line differs most from what it is compared with.
    struct Difference {
        int axis;
        Real along, measured, expected;  // m, m/s, m/s
        Real size() const { return std::abs(measured - expected); }
    };
    static std::optional<Real> size_of_difference(const std::optional<Difference>& difference);
    Real largest_divergence() const;  // of the velocity as it stands, 1/s
    std::optional<Difference> largest_from_table() const;
    std::optional<Difference> largest_from_closed_form() const;
    // Component across `axis`, m/s, on the line through the middle along the other axis, at a distance from the wall in m.
    Real velocity_on_centre_line(int axis, Real along) const;
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
    void draw_openings(Scene& scene) const;
    void draw_obstacle(Scene& scene) const;
    void draw_drives(Scene& scene) const;
    void write_notes(Scene& scene) const;
    Real arrow_speed() const;

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
    flow::FlowFields fields_of_flow_;
    std::optional<Pull> pull_;
};

}  // namespace pliant::navier_stokes
