// A sheet of point masses and springs that hangs, flies as a flag or drapes over a sphere: forces, air, contact, strain limiting.
#pragma once
#include "cloth_sheet.h"

#include <pliant/lesson/registry.h>
#include <pliant/solids/sheet_wind.h>
#include <pliant/solids/sphere_contact.h>
#include <pliant/solids/springs_frequency.h>
#include <pliant/solids/springs_system.h>
#include <pliant/solids/strain_limiter.h>
#include <pliant/time/time_integrator.h>

#include <memory>
#include <optional>

namespace pliant::cloth {

// Newton's method: so many iterations, whatever they leave; or until it converges.
enum class Newton { capped, full };
enum class Setting { hanging_corners, hanging_edge, drape, flag, pedestal };

// Strains below this are rounding.
inline constexpr Real strain_rounding = 1e-12;

// Caps of a full Newton solve: of its own iterations, and of conjugate gradients in each.
inline constexpr int full_iterations = 500, full_linear_iterations = 2000;

// Factors of larger sheets do not fit into a lecture.
inline constexpr Index most_direct_nodes = 40 * 40;

class ClothLesson final : public Lesson {
public:
    ClothLesson();

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::optional<On> can_pull() const override { return On::node; }
    void pull(const std::optional<Pull>& hand) override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return "lowest"; }
    ColourBy first_colours() const override { return {"stretch", -1}; }
    std::vector<std::string_view> first_plots() const override { return {"energy", telling_probe(), "largest_stretch"}; }
    std::vector<std::string_view> key_numbers() const override { return {"largest_stretch", "bending_share", telling_probe()}; }

private:
    // --- parameters ---
    Choice<Setting> setting;
    Whole nodes;
    Number size, total_mass;
    Number k_structural, k_shear, k_bending;
    Choice<SpringDamping> damping_mode;
    Number damping;
    Number gravity;
    Number wind, gust, air_drag;
    Number sphere_radius, friction;
    Choice<Scheme> scheme;
    Number dt;
    Choice<Newton> newton;
    Whole newton_cap;
    Number newton_tolerance;
    Choice<LinearSolve> linear_solver;
    Whole linear_iterations;
    Number linear_tolerance;
    Switch strain_limiting;
    Number strain_limit;
    Whole limit_passes;
    Number pull_stiffness;

    // --- declarations ---
    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_checks();

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
    void damping_stage();
    void external_stage();
    void wind_stage();
    void begin_integration();
    void prepare_implicit_step();
    // Of the implicit scheme, once it has begun a step; else null.
    const ImplicitSolver* solver() const;
    void integrate();
    void end_integration();
    void begin_limiting();
    void contact_stage();
    void note_pace();

    // --- what can be read off (cloth_readings.cpp) ---
    Real total_energy() const;
    Real rounding_energy() const;
    Real energy_terms() const;
    Real energy_tolerance() const;
    std::optional<Real> drape_coefficient() const;
    const SpringRates& rates() const;
    Real stable_time_step() const;
    std::string too_large_a_step() const;

    // --- why a number is what it is (cloth_why.cpp) ---
    using Reading = Input (*)(std::string symbol, std::string_view field, Index index, int component);  // Input::now, ...
    Input stiffness_of_spring(Index spring) const;
    Input damping_of_spring(Index spring) const;
    Input node_mass() const;
    Explanation why_spring_stage(const Question& q) const;
    Explanation why_spring_force(Index node, int component) const;
    Explanation why_spring_on_node(Index spring, Index node, int component) const;
    Explanation why_strain(Index spring) const;
    Explanation why_largest_of_node(Index node, bool bent) const;
    Explanation why_damping_force(Index node, int component, Reading direction_at) const;
    Explanation why_damper_on_node(Index spring, Index node, int component, Reading direction_at) const;
    Explanation why_external_force(Index node, int component) const;
    // --- (cloth_why_air.cpp) ---
    Explanation why_wind_stage(const Question& q) const;
    Explanation why_drag(Index node, int row, int column) const;
    Explanation why_wind_force(Index node, int component) const;
    Input wind_component(int component) const;
    // --- (cloth_why_motion.cpp) ---
    Explanation why_integrated(const Question& q) const;
    Explanation why_explicit_velocity(Index node, int component) const;
    Explanation why_balanced_velocity(Index node, int component) const;
    Explanation why_newton_position(Index node, int component) const;
    Input newton_start(Index node, int component) const;
    Input newton_direction(Index dof) const;
    // --- (cloth_why_contact.cpp) ---
    const NodePlane<3>* plane_of(Index node) const;
    Explanation why_plane_force(const NodePlane<3>& plane, int component) const;
    Explanation why_friction(const NodePlane<3>& plane, int component) const;
    Explanation why_limited(const Question& q) const;
    std::optional<Explanation> why_contact(const Question& q) const;
    Explanation why_pressed(Index node) const;
    // --- (cloth_why_probes.cpp) ---
    void explain_probes();
    Explanation why_kinetic_energy() const;
    Explanation why_family_energy(Family family) const;
    Explanation why_gravitational_energy() const;
    Explanation why_hand_energy() const;
    Explanation why_energy() const;
    Explanation why_largest_stretch() const;
    Explanation why_lowest() const;
    Explanation why_drape() const;

    // --- the picture (cloth_picture.cpp) ---
    void draw_sheet(Scene& picture) const;
    void draw_springs(Scene& picture) const;
    void draw_nodes(Scene& picture) const;
    void draw_sphere(Scene& picture) const;
    void draw_arrows(Scene& picture) const;
    void write_notes(Scene& picture) const;
    void set_frame(Scene& picture) const;

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

    // Rates of the net at rest, with the parameters that they belong to.
    struct RatesKey {
        ClothSheet::Stiffnesses stiffness{};
        Real damping = 0, mass = 0;
        SpringDamping mode = SpringDamping::none;
        bool operator==(const RatesKey&) const = default;
    };
    mutable std::optional<RatesKey> rates_key_;
    mutable SpringRates rates_;
};

}  // namespace pliant::cloth
