// An elastic rod that hangs, swings or carries waves: positions, strain, energy, and the springs that its energy turns out to be;
// beside it a rod of springs picked by hand, and the continuum.
#pragma once
#include <pliant/lesson/registry.h>
#include <pliant/solids/rod.h>
#include <pliant/solids/rod_theory.h>
#include <pliant/solids/springs_system.h>
#include <pliant/time/rhythm.h>
#include <pliant/time/stability.h>
#include <pliant/time/time_integrator.h>

#include <memory>
#include <optional>

namespace pliant::rod {

// Nodes that can be told apart in the picture.
inline constexpr Index most_ticks = 60;

enum class Setting { hanging, released, wave, free_end, fixed_end };
enum class Rule { derived, constant };

class RodLesson final : public Lesson {
public:
    RodLesson();

    int dimension() const override { return 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return hangs_still() ? Real{0} : Real{dt}; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return setting == Setting::wave ? "mode_amplitude" : "tip_displacement"; }
    ColourBy first_colours() const override { return {"strain", -1}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;
    std::vector<std::string_view> map_knobs() const override { return {"time_step", "axial_stiffness"}; }

private:
    // --- parameters ---
    Choice<Setting> setting;
    Whole segments;
    Choice<Rule> spring_rule;
    Number axial_stiffness, picked_stiffness;
    Number total_mass, length, gravity;
    Whole mode;
    Number amplitude, pulse_width;
    Choice<Scheme> scheme;
    Number dt, damping;

    // --- declarations ---
    void declare_fields();
    void declare_bounds();
    void declare_stages();
    void declare_probes();
    void declare_wave_probes();
    void declare_lines();
    void declare_wave_lines();
    void declare_checks();

    // --- what the parameters mean ---
    bool hangs() const { return setting == Setting::hanging || setting == Setting::released; }
    bool hangs_still() const { return setting == Setting::hanging; }
    bool runs_a_pulse() const { return setting == Setting::free_end || setting == Setting::fixed_end; }
    bool unsolved() const { return hangs_still() && clock_[balanced] != 1; }  // nothing has been let down yet
    bool damped() const { return !hangs_still() && damping > 0; }
    bool loaded() const { return hangs() && gravity > 0; }
    bool by_hand() const { return spring_rule == Rule::constant; }
    Real weight_acceleration() const { return hangs() ? Real{gravity} : Real{0}; }
    RodEnd end() const { return setting == Setting::fixed_end ? RodEnd::fixed : RodEnd::free; }
    Vec<2> along() const { return hangs() ? Vec<2>(0, -1) : Vec<2>(1, 0); }
    Index count() const { return segments; }
    Real rest_place(Index node) const { return segment() * static_cast<Real>(node); }  // s of a node, m

    // --- the rod and its chains ---
    Real segment() const { return length / static_cast<Real>(count()); }        // Δs, m
    Real node_mass() const { return total_mass / static_cast<Real>(count()); }  // m, kg
    Real stiffness_of(Rule rule, Index n) const;                                // k of a rod of n segments, N/m
    Real stiffness() const { return stiffness_of(spring_rule, segments); }      // N/m
    Real chain_axial_stiffness() const { return by_hand() ? stiffness() * segment() : Real{axial_stiffness}; }  // EA, N
    UniformRod continuum() const { return {length, axial_stiffness, total_mass}; }
    MassChain chain_of(Rule rule, Index n) const;
    MassChain chain() const { return chain_of(spring_rule, segments); }
    RunningPulse pulse(Real speed) const;
    Real chain_speed() const { return UniformRod{length, chain_axial_stiffness(), total_mass}.wave_speed(); }  // m/s
    VecX start_displacements() const;  // m, of the nodes along the rod
    Index watched_mode() const { return std::min<Index>(mode, chain().modes(end())); }
    Real damping_ratio(Real omega) const { return damped() ? damping * omega / 2 : Real{0}; }

    // --- the stages ---
    void slope_stage();
    void force_stage();
    void external_stage();
    void begin_integration();
    void integrate();
    void end_integration();
    void note_history(Real before);
    Real history_span() const { return 3 * length / continuum().wave_speed(); }  // s
    void equilibrium_stage();
    void follow_positions();

    // --- what can be read off (rod_readings.cpp, rod_waves.cpp, rod_fixes.cpp) ---
    Real displacement_of(Index node) const { return along().dot(position_.col(node)) - rest_place(node); }
    Real tip_displacement() const { return displacement_of(segments); }
    Real elastic_energy() const;
    Real kinetic_energy_now() const;
    Real gravitational_energy_now() const;
    Real total_energy() const { return kinetic_energy_now() + elastic_energy() + gravitational_energy_now(); }
    Real force_difference() const;
    Real force_rounding() const;
    Real imbalance() const;
    Real strain_rounding() const;
    Real least_swing() const;
    bool swings() const { return least_swing() > 0; }
    Real motion_energy() const;
    Real rounding_energy() const;
    Real energy_tolerance() const;
    Real imbalance_rounding() const;
    Real swing(Real omega, Real t) const;
    std::optional<Real> exact_displacement(Real s, Real t) const;
    std::optional<Real> exact_strain(Real s, Real t) const;
    void sample_exact(Curve& curve, std::optional<Real> (RodLesson::*exact)(Real, Real) const) const;
    Real static_tip(Rule rule, Index n) const;
    VecX mode_shape() const;
    Real mode_amplitude() const;
    Real pulse_position() const;
    std::optional<Real> way(Real speed, Real t) const;  // m
    std::optional<Index> turns() const;
    std::optional<Real> wave_speed() const;
    const VecX& frequencies() const;
    Real largest_strain() const;
    Real stable_time_step() const;
    Real fastest() const;  // rad/s
    std::string too_large_a_step() const;
    std::optional<Fix> stable_fix() const;

    // --- how the numbers came about (rod_why.cpp, rod_why_motion.cpp, rod_why_probes.cpp) ---
    Input why_segment() const;
    Input why_node_mass() const;
    Input why_stiffness() const;
    Input why_axial_stiffness() const;
    Explanation why_slope(Index segment, int component) const;
    Explanation why_strain(Index segment) const;
    Explanation why_energy_density(Index segment) const;
    Explanation why_segment_energy(Index segment) const;
    Explanation why_spring(const Question& q) const;
    Explanation sum_over_neighbours(Index node, std::string formula, std::string_view symbol,
                                    const std::function<Explanation(Index other)>& term) const;
    Explanation why_force(const Question& q) const;
    Explanation why_damping_force(Index node, int component) const;
    Explanation why_external_force(Index node, int component) const;
    Explanation why_balanced(Index node, int component) const;
    Explanation why_displacement(Index node) const;
    std::optional<Explanation> why_integrated(const Question& q) const;
    Input why_acceleration(Index pass, Index node, int component) const;
    Explanation why_row(Index node, int component, bool of_velocity) const;
    Explanation why_solution(Index node, int component) const;
    Explanation why_solved_position(Index node, int component) const;
    Explanation why_solved_velocity(Index node, int component) const;
    void explain_probes();
    Input why_continuum_tip() const;
    Explanation why_elastic_energy() const;
    Explanation why_kinetic_energy() const;
    Explanation why_gravitational_energy() const;
    Explanation why_force_difference() const;
    Explanation why_imbalance() const;
    Explanation why_mode_amplitude() const;
    Explanation why_pulse_position() const;

    // --- the picture (rod_picture.cpp, rod_wave_picture.cpp) ---
    void draw_hanging(Scene& picture) const;
    void draw_hanging_rod(Scene& picture, Rule rule, Real x) const;
    void draw_continuum(Scene& picture, Real x) const;
    void draw_descent(Scene& picture, Real x, Real tip) const;
    Real deepest() const;  // m, that a tip can come down to
    VecX hanging_displacements(Rule rule) const;
    void draw_waves(Scene& picture) const;
    void draw_straight_rod(Scene& picture) const;
    void draw_wave(Scene& picture) const;
    void draw_pulse_place(Scene& picture) const;
    void draw_history(Scene& picture) const;
    void write_notes(Scene& picture) const;

    // What a run is made of.
    Springs springs_;
    VecX node_masses_;
    DiagonalMass inertia_;
    std::unique_ptr<SpringSystem<2>> system_;
    std::unique_ptr<TimeIntegrator> integrator_;
    Real start_energy_ = 0, start_motion_ = 0;  // J: in all, and what motion can come to
    Real start_position_ = 0;                   // m, of the pulse

    // State [m, m/s], and what the stages make of it.
    Points<2> position_, velocity_;
    enum Clock : Index { elapsed, balanced, clock_count };
    VecX clock_ = VecX::Zero(clock_count);  // s, and whether the forces of a rod that hangs still balance
    Rhythm rhythm_;
    static constexpr Index history_rows = 60;
    MatX history_;  // strain of every segment at so many moments of a span, segments × moments; 0 where none was noted
    Points<2> slope_, gradient_force_, spring_force_, damping_force_, external_force_, total_force_;
    VecX strain_, energy_density_, segment_energy_, stiffness_, tension_, displacement_;
    VecX added_tension_, move_;  // of the latest balance, N and m

    // Frequencies of the chain, rad/s, with what they belong to.
    struct ChainKey {
        Index segments = 0;
        Real stiffness = 0, mass = 0;
        RodEnd end = RodEnd::free;
        bool operator==(const ChainKey&) const = default;
    };
    mutable std::optional<ChainKey> frequencies_key_;
    mutable VecX frequencies_;
};

}  // namespace pliant::rod
