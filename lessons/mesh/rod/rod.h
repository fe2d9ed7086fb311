// An elastic rod that hangs, swings or carries waves: positions, strain, energy, and the springs that its energy turns out to be;
// beside it a rod of springs picked by hand, and the continuum.
#pragma once
#include "kits/schemes/scheme_options.h"
#include "kits/springs/net_parameters.h"
#include "kits/springs/spring_why.h"

#include <pliant/lesson/registry.h>
#include <pliant/math/remembered.h>
#include <pliant/solids/point_masses.h>
#include <pliant/solids/rod.h>
#include <pliant/solids/rod_theory.h>
#include <pliant/solids/springs_system.h>
#include <pliant/time/exact_motion.h>
#include <pliant/time/rhythm.h>
#include <pliant/time/stability.h>
#include <pliant/time/time_integrator.h>

#include <memory>
#include <optional>
#include <tuple>

namespace pliant::rod {

// Nodes that can be told apart in the picture.
inline constexpr Index most_ticks = 60;

enum class Setting { hanging, released, wave, free_end, fixed_end };
enum class Rule { derived, constant };

struct RodLesson final : Lesson {
    RodLesson() {
        declare_fields(), declare_stages(), declare_probes(), declare_wave_probes(), explain_probes(), declare_lines(),
            declare_wave_lines(), declare_checks();
    }

    int dimension() const override { return 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return hangs_still() ? Real{0} : Real{dt}; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return setting == Setting::wave ? "mode_amplitude" : "tip_displacement"; }
    ColourBy first_colours() const override { return {"strain", -1}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;
    std::vector<std::string_view> map_knobs() const override { return {"time_step", "axial_stiffness"}; }

    // --- parameters ---
    Choice<Setting> setting{*this,
                            setting_of("scene", "what happens to the rod").in(Group::scene).rebuilds(),
                            {{"hanging", "hangs at rest: solved at once"},
                             {"released", "let go: it swings up and down"},
                             {"wave", "one mode of a free end"},
                             {"free_end", "a pulse runs to a free end"},
                             {"fixed_end", "a pulse runs to a fixed end"}}};
    Whole segments{*this, log_quantity("segments", "N", "", 10, {2, 200}, {1, 200},
                                       "into which the rod is divided: as many springs, and as many masses below the support")
                              .in(Group::shape)
                              .rebuilds()};
    Choice<Rule> spring_rule{
        *this,
        setting_of("spring_rule", "derived: k = EA/Δs, from the energy of the rod. constant: one k picked by hand, whatever N is")
            .in(Group::material)
            .rebuilds(),
        {{"derived", "derived from the energy"}, {"constant", "picked by hand"}}};
    Number axial_stiffness{
        *this, log_quantity("axial_stiffness", "EA", "N", 20, {1, 1e5}, {0, 1e12, true},
                            "of the rod: Young's modulus times cross-section, the force per strain. The lecture calls it k")
                   .in(Group::material)
                   .rebuilds()};
    Number picked_stiffness{*this, log_quantity("picked_stiffness", "k₀", "N/m", 200, {1, 1e5}, {0, 1e12, true},
                                                "of each spring of the rod that is picked by hand")
                                       .in(Group::material)
                                       .rebuilds()
                                       .when([this] { return hangs() || by_hand(); })};
    Number total_mass{*this, log_quantity("mass", "M", "kg", 1, {0.01, 100}, {0, 1e9, true},
                                          "of the whole rod; each of the N points below the support carries M/N")
                                 .in(Group::material)
                                 .rebuilds()};
    Number length{
        *this,
        log_quantity("length", "L", "m", 1, {0.1, 10}, {1e-6, 1e6}, "of the rod at rest; Δs = L/N").in(Group::shape).rebuilds()};
    Number gravity{*this, springs::gravity_downwards().rebuilds().when([this] { return hangs(); })};
    Whole mode{*this,
               quantity("mode", "j", "", 1, {1, 10}, {1, 200},
                        "which mode swings; a chain of N masses has N of them, and the highest stands for what lies beyond")
                   .in(Group::start)
                   .rebuilds()
                   .when([this] { return setting == Setting::wave; })};
    Number amplitude{*this, log_quantity("amplitude", "A", "m", 0.03, {1e-3, 0.1}, {0, 1e3},
                                         "largest displacement at the start, along the rod")
                                .in(Group::start)
                                .rebuilds()
                                .when([this] { return !hangs(); })};
    Number pulse_width{*this, log_quantity("pulse_width", "w", "m", 0.12, {0.02, 0.2}, {1e-6, 1e6},
                                           "of the pulse A exp(−((s − s₀)/w)²), which starts at s₀ = 0.35 L")
                                  .in(Group::start)
                                  .rebuilds()
                                  .when([this] { return runs_a_pulse(); })};
    Choice<Scheme> scheme{*this,
                          setting_of("integrator", "how forces become motion", Real(static_cast<int>(Scheme::velocity_verlet)))
                              .once("scheme")
                              .in(Group::method)
                              .when([this] { return !hangs_still(); }),
                          scheme_options()};
    Number dt{*this, fixed_time_step(2e-3, {1e-4, 0.1}).when([this] { return !hangs_still(); })};
    Number damping{*this,
                   quantity("damping_time", "τ", "s", 0, {0, 0.1}, {0, 1e6},
                            "each spring's damper is τ k, along the spring: a property of the material, whatever N is. 0: none")
                       .once("damping")
                       .in(Group::material)
                       .rebuilds()
                       .when([this] { return !hangs_still(); })};

    // --- declarations ---
    void declare_fields(), declare_stages(), declare_probes(), declare_wave_probes(), explain_probes(), declare_lines(),
        declare_wave_lines(), declare_checks();

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
    MassChain chain_of(Rule rule, Index n) const { return {n, stiffness_of(rule, n), total_mass / static_cast<Real>(n)}; }
    MassChain chain() const { return chain_of(spring_rule, segments); }
    RunningPulse pulse(Real speed) const { return {amplitude, pulse_width, 0.35 * length, length, speed, end()}; }
    Real chain_speed() const { return UniformRod{length, chain_axial_stiffness(), total_mass}.wave_speed(); }  // m/s
    VecX start_displacements() const;  // m, of the nodes along the rod
    Index watched_mode() const { return std::min<Index>(mode, chain().modes(end())); }
    Real damping_ratio(Real omega) const { return damped() ? damping * omega / 2 : Real{0}; }

    // --- the stages ---
    void slope_stage() { rod_slopes(segment(), position_, slope_); }
    void begin_integration();
    void integrate();
    void end_integration();
    void note_history(Real before);
    Real history_span() const { return 3 * length / continuum().wave_speed(); }  // s
    void equilibrium_stage();
    void follow_positions();

    // --- what can be read off (rod_readings.cpp, rod_waves.cpp) ---
    Real displacement_of(Index node) const { return along().dot(position_.col(node)) - rest_place(node); }
    Real tip_displacement() const { return displacement_of(segments); }
    Real elastic_energy() const;
    Real kinetic_energy_now() const { return kinetic_energy<2>(node_masses_, velocity_); }
    Real gravitational_energy_now() const;
    Real total_energy() const { return kinetic_energy_now() + elastic_energy() + gravitational_energy_now(); }
    Real force_difference() const { return (gradient_force_ - spring_force_).cwiseAbs().maxCoeff(); }
    Real force_rounding() const;
    Real imbalance() const;
    Real strain_rounding() const;
    Real least_swing() const;
    bool swings() const { return least_swing() > 0; }
    Real motion_energy() const;
    Real imbalance_rounding() const;
    // Of a mode, over its start: let go at rest.
    Real swing(Real omega, Real t) const { return damped_oscillator(omega, damping_ratio(omega), {1, 0}, t).x; }
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

    // --- how the numbers came about (rod_why.cpp, rod_why_probes.cpp) ---
    Input why_segment() const { return part("Δs = L / N", {length, segments}); }
    Input why_node_mass() const { return part("m = M / N", {total_mass, segments}); }
    Input why_stiffness() const;
    Input why_axial_stiffness() const;
    Explanation why_field(const Question& q) const;
    std::optional<Explanation> why_integrated(const Question& q) const;

    // --- the picture (rod_picture.cpp, rod_wave_picture.cpp) ---
    void draw_waves(Scene& picture) const;

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

    // Frequencies of the chain, rad/s, by what they depend on: segments, stiffness, mass, its end.
    mutable Remembered<std::tuple<Index, Real, Real, RodEnd>, VecX> frequencies_;
};

}  // namespace pliant::rod
