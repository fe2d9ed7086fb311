// A sheet of point masses and springs that hangs, flies as a flag or drapes over a sphere: forces, air, contact, strain limiting.
#pragma once
#include "kits/schemes/scheme_options.h"
#include "kits/springs/net_parameters.h"
#include "kits/springs/spring_why.h"

#include <pliant/lesson/registry.h>
#include <pliant/math/remembered.h>
#include <pliant/solids/cloth_sheet.h>
#include <pliant/solids/sheet_wind.h>
#include <pliant/solids/sphere_contact.h>
#include <pliant/solids/springs_frequency.h>
#include <pliant/solids/springs_system.h>
#include <pliant/solids/strain_limiter.h>
#include <pliant/time/time_integrator.h>

#include <memory>
#include <optional>
#include <tuple>

namespace pliant::cloth {

// Newton's method: so many iterations, whatever they leave; or until it converges.
enum class Newton { capped, full };
enum class Setting { hanging_corners, hanging_edge, drape, flag, pedestal };

using springs::strain_rounding;

// Caps of a full Newton solve: of its own iterations, and of conjugate gradients in each.
inline constexpr int full_iterations = 500, full_linear_iterations = 2000;

// Factors of larger sheets do not fit into a lecture.
inline constexpr Index most_direct_nodes = 40 * 40;

struct ClothLesson final : Lesson {
    ClothLesson() { declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_checks(); }

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return On::node; }
    void pull(const std::optional<Pull>& hand) override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<Fix> other_fixes(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return "lowest"; }
    ColourBy first_colours() const override { return {"stretch", -1}; }
    std::vector<std::string_view> first_plots() const override { return {"energy", telling_probe(), "largest_strain"}; }
    std::vector<std::string_view> key_numbers() const override { return {"largest_strain", "bending_share", telling_probe()}; }

    // --- parameters ---
    Choice<Setting> setting{*this,
                            setting_of("scene", "what happens to the sheet").in(Group::scene).rebuilds(),
                            {{"hanging_corners", "held at two corners"},
                             {"hanging_edge", "held at one edge"},
                             {"drape", "falls on a sphere"},
                             {"flag", "a flag in the wind"},
                             {"pedestal", "drape test: its middle lies on a disc"}}};
    Whole nodes{
        *this,
        quantity("nodes", "n", "", 25, {2, 64}, {2, 96}, "nodes along each side of the sheet").in(Group::shape).rebuilds()};
    Number size{*this,
                log_quantity("size", "L", "m", 1, {0.1, 5}, {1e-6, 1e6}, "side of the square sheet").in(Group::shape).rebuilds()};
    Number total_mass{*this,
                      log_quantity("mass", "M", "kg", 0.2, {0.01, 10}, {1e-9, 1e9},
                                   "of the whole sheet, shared equally by its nodes; a square metre of cotton weighs 0.2 kg")
                          .in(Group::material)};
    Number k_structural{*this, springs::stiffness_of("k_structural", "kₛ", 1000, {0.01, 1e4},
                                                     "of the springs along the threads: they resist stretching")};
    Number k_shear{*this, springs::stiffness_of("k_shear", "k_d", 100, {0.01, 1e4},
                                                "of the springs along the diagonals: they resist shear")};
    Number k_bending{*this, springs::stiffness_of("k_bending", "k_b", 1, {0.01, 1e4},
                                                  "of the springs to the node after the next: they resist bending")};
    Choice<SpringDamping> damping_mode{*this, springs::damping_choice(), springs::damping_options()};
    Number damping{
        *this, springs::damper(0.01, {1e-4, 1}, "of every spring whose stiffness is not 0").when([this] { return damped(); })};
    Number gravity{*this, springs::gravity_downwards()};
    Number wind{*this,
                quantity("wind", "W", "m/s", 0, {0, 20}, {-1e6, 1e6}, "speed of the wind: along x for the flag, else towards you")
                    .in(Group::forces)
                    .when([this] { return in_air(); })};
    Number gust{*this, quantity("gust", "γ", "", 0.3, {0, 1}, {0, 10},
                                "how far the wind swings to its side, once in a second, as a part of its speed")
                           .in(Group::forces)
                           .when([this] { return in_air() && wind != 0; })};
    Number air_drag{*this, quantity("air_drag", "c", "", 1, {0, 2}, {0, 1e6},
                                    "drag coefficient of a small plate across the wind, also of still air; 0: no air")
                               .in(Group::forces)};
    Number sphere_radius{
        *this, quantity("sphere_radius", "R", "m", 0.25, {0, 1}, {0, 1e6}, "of the sphere, or of the disc of the drape test")
                   .in(Group::shape)
                   .rebuilds()
                   .when([this] { return drapes(); })};
    Number friction{*this, quantity("friction", "μ", "", 0.3, {0, 1.5}, {0, 1e6}, "Coulomb's coefficient of the sphere")
                               .in(Group::forces)
                               .when([this] { return has_sphere(); })};
    Choice<Scheme> scheme{*this, setting_of("integrator", "how forces become motion", 2).once("scheme").in(Group::method),
                          scheme_options(3)};
    Number dt{*this, fixed_time_step(1.0 / 60, {1e-5, 0.1})};
    Choice<Newton> newton{
        *this,
        setting_of("newton", "how far a step is solved").in(Group::solver).when([this] { return implicit(); }),
        {{"capped", "so many iterations, taken as they are"}, {"full", "until it converges, or stop and report"}}};
    Whole newton_cap{*this,
                     quantity("newton_iterations", "", "", 1, {1, 50}, {1, 10000},
                              "most Newton iterations of a time step; what they leave unbalanced is shown; 1: linearly implicit")
                         .once("newton_cap")
                         .in(Group::solver)
                         .when([this] { return implicit() && capped(); })};
    Number newton_tolerance{
        *this,
        newton_tolerance_from(1e-4, "Newton's method has converged when its step is shorter than this fraction of a spring")
            .when([this] { return implicit() && (!capped() || newton_cap > 1); })};
    Choice<LinearSolve> linear_solver{
        *this,
        setting_of("linear_solver", "how each Newton iteration solves its linear system", 1).in(Group::solver).when([this] {
            return implicit();
        }),
        {{"direct", "direct: sparse factors"}, {"conjugate_gradients", "conjugate gradients, coarser sheets help"}}};
    Whole linear_iterations{*this,
                            quantity("linear_iterations", "", "", 20, {1, 200}, {1, 100000},
                                     "most iterations of conjugate gradients in a Newton iteration: bounds the cost of a step")
                                .in(Group::solver)
                                .when([this] { return iterative() && capped(); })};
    Number linear_tolerance{*this,
                            log_quantity("linear_tolerance", "η", "", 1e-4, {1e-10, 0.1}, {1e-15, 1, false, true},
                                         "conjugate gradients stop when their residual is below this part of the right side")
                                .in(Group::solver)
                                .when([this] { return iterative(); })};
    Switch strain_limiting{*this,
                           setting_of("strain_limiting", "draw overlong springs together after each step?").in(Group::method)};
    Number strain_limit{*this, quantity("strain_limit", "ε_max", "", 0.05, {0, 0.3}, {0, 10},
                                        "largest strain that structural and shear springs keep")
                                   .in(Group::method)
                                   .when([this] { return bool(strain_limiting); })};
    Whole limit_passes{*this, quantity("limit_passes", "", "", 50, {1, 200}, {1, 10000},
                                       "most passes over all springs in a step; each pass undoes a part of its neighbours'")
                                  .in(Group::method)
                                  .when([this] { return bool(strain_limiting); })};
    Number pull_stiffness{*this, springs::pull_stiffness_from(20, {1, 1000})};

    // --- declarations ---
    void declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_checks();

    // --- what the parameters mean ---
    bool implicit() const { return scheme == Scheme::implicit_euler; }
    bool iterative() const { return implicit() && linear_solver == LinearSolve::conjugate_gradients; }
    bool capped() const { return newton == Newton::capped; }
    bool damped() const { return damping_mode != SpringDamping::none; }
    bool in_air() const { return air_drag > 0; }
    bool has_sphere() const { return setting == Setting::drape && sphere_radius > 0; }
    bool drapes() const { return setting == Setting::drape || setting == Setting::pedestal; }
    bool pulled() const { return load_.pull.active(); }
    bool loaded() const { return gravity > 0 || pulled(); }
    std::string_view telling_probe() const { return drapes() ? "drape_coefficient" : "lowest"; }
    Sphere sphere() const;
    Vec<3> wind_at(Real t) const;
    std::vector<Index> held_nodes() const;
    Points<3> start_positions() const;
    NewtonOptions newton_options() const;

    // --- the stages (cloth_stages.cpp) ---
    void follow_parameters();
    void spring_stage();
    void wind_stage();
    void begin_integration();
    void prepare_implicit_step();
    // Of the implicit scheme, once it has begun a step; else null.
    const ImplicitSolver* solver() const;
    void integrate();
    void end_integration();
    void note_pace();

    // --- what can be read off (cloth_readings.cpp) ---
    std::optional<Real> drape_coefficient() const;
    Real stable_time_step() const;

    // --- why a number is what it is (cloth_why.cpp) ---
    Input stiffness_of_spring(Index spring) const;
    Input node_mass() const { return springs::shared_mass(total_mass, position_.cols()); }
    Explanation why_force(const Question& q) const;
    Explanation why_integrated(const Question& q) const;
    // --- (cloth_why_contact.cpp) ---
    Explanation why_limited(const Question& q) const;
    std::optional<Explanation> why_contact(const Question& q) const;
    std::vector<Input> plane_forces_on(Index node, int component) const;

    std::unique_ptr<ClothSheet> sheet_;
    std::unique_ptr<SpringSystem<3>> system_;
    std::unique_ptr<TimeIntegrator> integrator_;
    std::unique_ptr<StrainLimiter> limiter_;
    ExternalLoad<3> load_;

    // State [m, m/s, N, s]: positions and velocities; the force with which the sphere holds each node; the time of the gusts.
    Points<3> position_, velocity_;
    VecX contact_force_;
    std::array<Real, 1> gust_time_{};
    // Largest speed since the start, m/s, and largest change of a velocity per second in the latest step, m/s².
    std::array<Real, 2> pace_{};
    Points<3> start_velocity_;  // of the step

    Points<3> spring_force_, damping_force_, external_force_, wind_force_;
    VecX total_force_;
    VecX strain_;             // of the springs
    VecX stretch_, bending_;  // of the nodes: strain of a structural spring farthest from 0, largest shortening of a bending one
    std::vector<Mat<3>> drag_;
    std::vector<Real> drag_numbers_;  // the same, as a field shows them
    Real gust_at_ = 0;                // time that this step's wind belongs to, s
    VecX held_, imbalance_;
    std::vector<SphereTouch> touches_;
    Index touching_ = 0;
    Real limiter_excess_ = 0, stretch_before_limiting_ = 0;

    // Of the net at rest, by what they depend on: stiffnesses, damping, mass.
    mutable Remembered<std::tuple<ClothSheet::Stiffnesses, Real, Real, SpringDamping>, SpringRates> rates_;
};

}  // namespace pliant::cloth
