// Incompressible flow on a staggered grid, one time step in the four stages of the lecture.
#pragma once
#include "fluids/flow/flow_fields.h"
#include "fluids/flow/grid_why.h"

#include <pliant/fluids/advection.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/forces.h>
#include <pliant/fluids/projection.h>
#include <pliant/lesson/registry.h>

#include <memory>
#include <optional>

namespace pliant::navier_stokes {

enum class Scenario { box, cavity, taylor_green };
enum class Scheme { implicit_euler, explicit_euler };

// The unit square, 1 m by 1 m: a closed box with walls to slide along, a cavity whose lid drives the fluid, or a periodic array
// of vortices.
class NavierStokes final : public Lesson {
public:
    NavierStokes();

    int dimension() const override { return 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::cell; }
    void pull(const std::optional<Pull>& pull) override { pull_ = pull; }
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return "kinetic_energy"; }
    ColourBy first_colours() const override { return {scenario == Scenario::cavity ? "speed" : "vorticity"}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;

private:
    Choice<Scenario> scenario;
    Whole resolution;
    Number viscosity, dt, stirring, lid_speed, tolerance;
    Choice<Scheme> scheme;

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_lines();
    void declare_checks();

    // --- the stages ---
    void external_forces();
    void advect();
    void diffuse();
    void begin_projection();
    void projection_pass();
    void end_projection();

    StaggeredGridInfo<2> domain() const;
    void start_taylor_green();
    bool stirred() const { return scenario == Scenario::box && stirring != 0; }
    bool forced() const { return stirred() || pull_.has_value(); }
    Real dx() const { return Real(1) / static_cast<Real>(Index(resolution)); }
    Real time() const { return elapsed_[0]; }
    Vec<2> stirrer_place() const;    // m
    Vec<2> stirrer_heading() const;  // unit vector

    // A push of the fluid around a place.
    struct Jet {
        Vec<2> centre;        // m
        Real radius;          // m
        Vec<2> acceleration;  // m/s²
    };
    Jet stirrer_jet() const;
    Jet hand_jet() const;

    // --- how the numbers came about (navier_stokes_why.cpp) ---
    flow::GridWhy why_on_grid() const;
    Explanation why_force(int axis, Index face) const;
    Explanation why_diffused(int axis, Index face) const;
    std::optional<Explanation> why_projection(const Question& q) const;

    std::optional<Fix> shorter_step(Real cells) const;  // that the fastest fluid may cross
    std::optional<Fix> thicker_fluid(Real wanted) const;

    // --- what is measured ---
    std::optional<Real> reynolds() const;
    std::optional<Real> effective_viscosity() const;
    Real interpolation_viscosity() const;
    Real specific_energy() const;  // J/kg
    std::optional<Real> table_difference() const;
    Real velocity_on_centre_line(int axis, Real along) const;  // component across `axis`, m/s, at a distance from the wall in m
    void profile(int axis, Curve& curve) const;
    void published_profile(int axis, Curve& curve) const;

    // --- the picture (navier_stokes_picture.cpp) ---
    void draw_walls(Scene& scene) const;
    void write_notes(Scene& scene) const;
    Real arrow_speed() const;

    std::unique_ptr<StaggeredGrid<2>> grid_;
    std::unique_ptr<SemiLagrangian<2>> advection_;
    std::unique_ptr<Viscosity<2>> diffusion_;
    std::unique_ptr<PressureProjection<2>> projection_;

    // What defines now: the velocity on the faces [m/s], the last pressure [m²/s²], from which the solver starts, and the time
    // [s] with ∫ν dt [m²] up to it.
    FaceField<2> velocity_;
    VecX pressure_;
    Eigen::Array2d elapsed_ = Eigen::Array2d::Zero();
    Real initial_energy_ = 0;  // J/kg
    // What the stages make of it: ∇·u before and after the projection [1/s].
    VecX divergence_before_, divergence_after_;
    flow::FlowFields fields_of_flow_;
    std::optional<Pull> pull_;
};

}  // namespace pliant::navier_stokes
