// A soft block of point masses and springs that falls, hangs, spins, swings or is put to a static test: lattices, forces,
// damping, integrators, contact.
#pragma once
#include "spring_block.h"
#include "static_tests.h"

#include <pliant/lesson/registry.h>
#include <pliant/solids/contact.h>
#include <pliant/solids/springs_frequency.h>
#include <pliant/solids/springs_system.h>
#include <pliant/time/rhythm.h>
#include <pliant/time/time_integrator.h>

#include <memory>
#include <optional>

namespace pliant::mass_spring {

enum class Setting { drop, hang, spin, swing, stretch_test };
enum class Support { top, side, both };

inline constexpr int up = 1;  // the component against gravity

// Strains below this are rounding.
inline constexpr Real strain_rounding = 1e-12;

// Factors of larger bodies do not fit into a lecture, nor much larger ones into memory.
inline constexpr Index most_implicit_nodes = 3000;

// Of a chain that swings, in edges.
inline constexpr Real swing_amplitude = 0.2;

class MassSpringLesson final : public Lesson {
public:
    MassSpringLesson();

    int dimension() const override { return dimension_of(lattice()) == 3 || setting == Setting::spin ? 3 : 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return tested() ? Real{0} : Real{dt}; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::optional<On> can_pull() const override { return tested() ? std::nullopt : std::optional(On::node); }
    void pull(const std::optional<Pull>& hand) override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return telling_probe(); }
    ColourBy first_colours() const override { return {"tension", -1}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;

private:
    // --- parameters ---
    Choice<Setting> setting;
    Choice<LatticeKind> kind;
    Choice<Support> support;
    Choice<BlockTest> test;
    Whole cells_x, cells_y, cells_z;
    Number size, total_mass;
    Number k_structural, k_shear, k_bending;
    Number rest_length_scale;
    Switch shared_edges;
    Number target_poisson, test_strain;
    Whole mode_number;
    Choice<SpringDamping> damping_mode;
    Number damping;
    Number gravity;
    Choice<Scheme> integrator;
    Number dt;
    Number drop_height, tilt, spin_rate;
    Switch ground;
    Number restitution, friction;
    Number pull_stiffness;
    Number newton_tolerance;
    Whole newton_cap;

    // --- declarations ---
    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_checks();
    std::vector<Probe> static_probes();
    void declare_assumptions();
    void declare_lines();

    // --- what the parameters mean ---
    bool implicit() const { return is_implicit(integrator); }
    bool implicit_euler() const { return integrator == Scheme::implicit_euler; }
    bool semi_implicit() const { return integrator == Scheme::semi_implicit_euler; }
    bool falls() const { return setting == Setting::drop || setting == Setting::hang; }
    bool tested() const { return setting == Setting::stretch_test; }
    bool grounded() const { return ground && falls(); }
    Ground ground_plane() const { return {0, restitution, friction}; }
    // Only a chain swings, and it can only be stretched.
    LatticeKind lattice() const { return setting == Setting::swing ? LatticeKind::chain : LatticeKind{kind}; }
    BlockTest block_test() const { return lattice() == LatticeKind::chain ? BlockTest::stretch : BlockTest{test}; }
    bool has_diagonals() const { return lattice() != LatticeKind::triangular && lattice() != LatticeKind::chain; }
    bool damped() const { return !tested() && damping_mode != SpringDamping::none; }
    std::string_view telling_probe() const;
    bool held() const { return setting == Setting::hang || setting == Setting::swing; }
    bool pulled() const { return load_.pull.node >= 0 && pull_stiffness > 0; }
    Real weight_acceleration() const { return falls() ? Real{gravity} : Real{0}; }
    bool loaded() const { return weight_acceleration() > 0 || pulled(); }
    std::vector<Index> held_nodes() const;
    FamilyStiffness stiffnesses() const { return {k_structural, has_diagonals() ? Real{k_shear} : Real{0}, k_bending}; }
    Real edge() const { return size / Real(lattice() == LatticeKind::chain ? Index(cells_y) : Index(cells_x)); }  // m
    Points<3> start_positions() const;
    Points<3> start_velocities() const;

    // --- what comes to rest (mass_spring_rest.cpp) ---
    bool has_dampers() const;
    Real rest_speed() const;
    Real rest_force(Index node) const;

    // --- the stages ---
    void follow_parameters();
    void spring_stage();
    void damping_stage();
    void external_stage();
    void begin_integration();
    void integrate();
    void end_integration();
    void store_memory();
    void recall_memory();
    void contact_stage();
    void static_stage();
    StaticTests::Key static_key() const;
    Real test_amount() const;

    // --- a chain that swings in one of its modes (mass_spring_swing.cpp) ---
    Index free_masses() const;
    Real mode_shape(Index node) const;
    Real mode_displacement() const;
    Real mode_frequency() const;
    void note_swing();
    std::optional<Real> measured_frequency() const;
    Explanation why_frequency() const;

    // --- what can be read off (mass_spring_readings.cpp) ---
    Real elastic_energy() const { return spring_energy<3>(block_->springs(), position_); }
    Real total_energy() const;
    std::optional<Real> shadow_energy() const;
    Real motion_energy() const;
    Real rounding_energy() const;
    Real energy_terms() const;
    Real momentum_terms() const;
    Real energy_tolerance() const;
    Real shadow_tolerance() const;
    Real momentum_tolerance() const;
    Real stretch() const;
    std::optional<Real> sag() const;
    std::optional<Real> falling_height(Real t) const;
    const SpringRates& rates() const;
    Real stable_time_step() const;
    Real growth_per_step() const;
    std::string too_large_a_step() const;

    // --- why a number is what it is (mass_spring_why.cpp) ---
    using Reading = Input (*)(std::string symbol, std::string_view field, Index index, int component);  // Input::now, ...
    Explanation why_static(const Question& q) const;
    Explanation why_test_stiffness() const;
    Explanation why_youngs_modulus() const;
    Explanation why_poisson_ratio() const;
    Explanation why_stiffness_ratio() const;
    Explanation why_coupling(SpringFamily family) const;
    Real elongation_squares(std::span<const Real> strains, SpringFamily family) const;
    std::optional<Real> rotation_after(Real t) const;
    Input stiffness_of_spring(Index spring) const;
    Input node_mass() const;
    Explanation why_spring_stage(const Question& q) const;
    Explanation why_spring_force(Index node, int component) const;
    Explanation why_spring_on_node(Index spring, Index node, int component) const;
    Explanation why_tension(Index spring) const;
    Explanation why_strain(Index spring) const;
    Explanation why_damping_force(Index node, int component, Reading direction_at) const;
    Explanation why_damper_on_node(Index spring, Index node, int component, Reading direction_at) const;
    Explanation why_external_force(Index node, int component) const;
    // --- (mass_spring_why_motion.cpp) ---
    Explanation why_integrated(const Question& q) const;
    Explanation why_explicit_velocity(Index node, int component) const;
    Explanation why_balanced_velocity(Index node, int component) const;
    Explanation why_table_row(const Question& q) const;
    Explanation why_second_order(const Question& q) const;
    Explanation why_iterate_velocity(Index node, int component) const;
    Explanation why_acceleration(Index node, int component) const;
    Explanation why_newton_position(Index node, int component) const;
    Input newton_start(Index node, int component) const;
    Input newton_direction(Index dof) const;
    std::optional<Explanation> why_contact(const Question& q) const;
    Explanation why_rebound(Index node) const;
    Explanation why_rubbed_velocity(Index node, int component) const;
    Input impact_speed(Index node) const;
    Input free_speed(Index node) const;
    Input acceleration_on_ground(Index node) const;
    // --- (mass_spring_why_probes.cpp) ---
    void explain_probes();
    Explanation why_energy() const;
    Explanation why_kinetic_energy() const;
    Explanation why_elastic_energy() const;
    Explanation why_gravitational_energy() const;
    Explanation why_momentum() const;
    Explanation why_angular_momentum() const;
    Explanation why_height() const;
    Explanation why_stretch() const;
    Explanation why_sag() const;

    // --- what would mend a run (mass_spring_fixes.cpp) ---
    std::optional<Fix> shear_springs() const;
    std::optional<Fix> own_poisson() const;
    std::optional<Fix> stable_fix() const;
    std::optional<Fix> slower_travel() const;

    // --- the picture (mass_spring_picture.cpp) ---
    void draw_surface(Scene& picture, float opacity) const;
    void draw_cell_edges(Scene& picture) const;
    void draw_springs(Scene& picture) const;
    void draw_nodes(Scene& picture) const;
    void draw_ground(Scene& picture) const;
    void draw_arrows(Scene& picture) const;
    void write_notes(Scene& picture) const;
    void write_static_notes(Scene& picture) const;
    void draw_continuum(Scene& picture) const;
    void draw_test(Scene& picture) const;
    void draw_plates(Scene& picture) const;
    void set_test_frame(Scene& picture) const;
    void draw_mode(Scene& picture) const;
    Real continuum_offset() const;
    void set_frame(Scene& picture) const;
    Real frame_side() const;

    std::unique_ptr<SpringBlock> block_;
    std::unique_ptr<SpringSystem<3>> system_;
    std::unique_ptr<TimeIntegrator> integrator_;
    StaticTests tests_;
    bool test_done_ = false;
    ExternalLoad<3> load_;

    // What the closed forms start from; they end when a hand or a slider has interfered.
    Real start_height_ = 0, start_angular_momentum_ = 0, start_gravity_ = 0, start_mass_ = 0, start_motion_ = 0;
    bool interfered_ = false;

    // State [m, m/s], forces on the nodes [N], tension [N] and strain of the springs.
    Points<3> position_, velocity_;
    Points<3> spring_force_, damping_force_, external_force_;
    VecX total_force_;                     // at the start of the step
    VecX memory_, clock_ = VecX::Zero(1);  // of the integrator; s
    Rhythm rhythm_;
    VecX tension_, strain_;
    GroundContact<3> contact_;
    Index touching_ = 0;

    // Rates of the net at rest, with the parameters that they belong to.
    struct RatesKey {
        FamilyStiffness stiffness{};
        Real damping = 0, mass = 0, rest_scale = 1;
        SpringDamping mode = SpringDamping::none;
        bool operator==(const RatesKey&) const = default;
    };
    mutable std::optional<RatesKey> rates_key_;
    mutable SpringRates rates_;
};

}  // namespace pliant::mass_spring
