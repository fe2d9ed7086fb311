// A soft block of point masses and springs that falls, hangs, spins, swings or is put to a static test: lattices, forces,
// damping, integrators, contact.
#pragma once
#include "kits/schemes/scheme_options.h"
#include "kits/springs/net_parameters.h"
#include "kits/springs/spring_why.h"

#include <pliant/lesson/registry.h>
#include <pliant/math/remembered.h>
#include <pliant/solids/contact.h>
#include <pliant/solids/spring_block.h>
#include <pliant/solids/springs_frequency.h>
#include <pliant/solids/springs_system.h>
#include <pliant/solids/static_tests.h>
#include <pliant/time/rhythm.h>
#include <pliant/time/time_integrator.h>

#include <memory>
#include <optional>
#include <tuple>

namespace pliant::mass_spring {

inline ParameterInfo cells_along(std::string_view key, std::string_view symbol) {
    return quantity(key, symbol, "", 4, {1, 10}, {1, 40}, "cells of the lattice along this axis").in(Group::shape).rebuilds();
}

enum class Setting { drop, hang, spin, swing, stretch_test };
enum class Support { top, side, both };

inline constexpr int up = 1;  // the component against gravity

using springs::strain_rounding;

// Factors of larger bodies do not fit into a lecture, nor much larger ones into memory.
inline constexpr Index most_implicit_nodes = 3000;

// Of a chain that swings, in edges.
inline constexpr Real swing_amplitude = 0.2;

struct MassSpringLesson final : Lesson {
    MassSpringLesson() {
        declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_checks(), declare_assumptions(),
            declare_lines();
    }

    int dimension() const override { return dimension_of(lattice()) == 3 || setting == Setting::spin ? 3 : 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return tested() ? Real{0} : Real{dt}; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return tested() ? std::nullopt : std::optional(On::node); }
    void pull(const std::optional<Pull>& hand) override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<Fix> other_fixes(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return telling_probe(); }
    ColourBy first_colours() const override { return {"tension", -1}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;

    // --- parameters ---
    Choice<Setting> setting{*this,
                            setting_of("scene", "what happens to the block").in(Group::scene).rebuilds(),
                            {{"drop", "dropped on the ground"},
                             {"hang", "held at one face"},
                             {"spin", "spinning freely, no gravity"},
                             {"swing", "a chain that swings in one of its modes"},
                             {"stretch_test", "static test between two plates"}}};
    Choice<LatticeKind> kind{*this,
                             setting_of("lattice", "which nodes the springs join").in(Group::shape).rebuilds().when([this] {
                                 return setting != Setting::swing;
                             }),
                             {{"cubic_face", "cubes with face diagonals"},
                              {"cubic_body", "cubes with body diagonals"},
                              {"square", "sheet of squares with diagonals"},
                              {"triangular", "sheet of triangles"},
                              {"chain", "chain"}}};
    Choice<Support> support{
        *this,
        setting_of("support", "the face that is held").in(Group::scene).rebuilds().when([this] { return held(); }),
        {{"top", "top: it hangs"}, {"side", "side: it is a beam"}, {"both", "top and bottom"}}};
    Choice<BlockTest> test{
        *this,
        setting_of("test", "what the plates at the top and the bottom do").in(Group::scene).rebuilds().when([this] {
            return tested() && lattice() != LatticeKind::chain;
        }),
        {{"stretch", "pulled apart"}, {"shear", "moved sideways, glued on"}, {"bend", "turned towards each other"}}};
    Whole cells_x{*this, cells_along("cells_x", "nₓ").when([this] { return lattice() != LatticeKind::chain; })};
    Whole cells_y{*this, cells_along("cells_y", "n_y")};
    Whole cells_z{*this, cells_along("cells_z", "n_z").when([this] { return dimension_of(lattice()) == 3; })};
    Number size{*this, log_quantity("size", "L", "m", 0.5, {0.05, 5}, {1e-6, 1e6},
                                    "length along x, so that edges are L / nₓ long; of a chain, L / n_y")
                           .in(Group::shape)
                           .rebuilds()};
    Number total_mass{
        *this, log_quantity("mass", "M", "kg", 1, {0.01, 100}, {1e-9, 1e9}, "of the whole block, shared equally by its nodes")
                   .in(Group::material)
                   .when([this] { return !tested(); })};
    Number k_structural{*this, springs::stiffness_of("k_structural", "kₛ", 200, {1, 1e5},
                                                     "of the springs along the edges of the cells; 0 leaves them out")};
    Number k_shear{*this,
                   springs::stiffness_of("k_shear", "k_d", 100, {1, 1e5}, "of the springs along the diagonals; 0 leaves them out")
                       .when([this] { return has_diagonals(); })};
    Number k_bending{*this, springs::stiffness_of("k_bending", "k_b", 20, {1, 1e5},
                                                  "of the springs to the node after the next; 0 leaves them out")};
    Number rest_length_scale{
        *this, quantity("rest_length_scale", "s", "", 1, {0, 2}, "rest lengths of the springs over the distances of the lattice")
                   .in(Group::material)
                   .rebuilds()
                   .when([this] { return !tested(); })};
    Switch shared_edges{
        *this, setting_of("shared_edges", "do springs on the surface count only for the cells inside, as in an endless lattice?")
                   .in(Group::shape)
                   .rebuilds()
                   .when([this] { return tested(); })};
    Number target_poisson{*this, quantity("target_poisson", "ν*", "", 0.25, {0, 0.49}, {-1, 0.5, true, true},
                                          "Poisson's ratio that is wished for: the solid beside the net has it")
                                     .in(Group::material)
                                     .rebuilds()
                                     .when([this] { return tested() && lattice() != LatticeKind::chain; })};
    Number test_strain{*this, quantity("test_strain", "ε", "", 0.2, {0.01, 0.5}, {1e-3, 1},
                                       "by which part of their distance the plates move; small motions, drawn larger")
                                  .in(Group::scene)
                                  .rebuilds()
                                  .when([this] { return tested(); })};
    Whole mode_number{*this,
                      quantity("mode", "j", "", 1, {1, 10}, {1, 40}, "which mode of the chain is released, from the slowest on")
                          .once("mode_number")
                          .in(Group::scene)
                          .rebuilds()
                          .when([this] { return setting == Setting::swing; })};
    Choice<SpringDamping> damping_mode{*this, springs::damping_choice().when([this] { return !tested(); }),
                                       springs::damping_options()};
    Number damping{*this, springs::damper(0.05, {1e-3, 10}, "of every spring").when([this] { return damped(); })};
    Number gravity{*this, springs::gravity_downwards().when([this] { return falls(); })};
    Choice<Scheme> integrator{
        *this, setting_of("integrator", "how forces become motion", 1).in(Group::method).when([this] { return !tested(); }),
        scheme_options()};
    Number dt{*this, fixed_time_step(1e-3, {1e-5, 0.1}).when([this] { return !tested(); })};
    Number drop_height{*this, quantity("drop_height", "h₀", "m", 0.5, {0, 2}, {0, 1e6},
                                       "of the block's lowest point above the ground at the start")
                                  .in(Group::start)
                                  .rebuilds()
                                  .when([this] { return falls(); })};
    Number tilt{*this, quantity("tilt", "φ", "°", 25, {-45, 45}, {-360, 360}, "of the block about the z axis at the start")
                           .in(Group::start)
                           .rebuilds()
                           .when([this] { return setting == Setting::drop; })};
    Number spin_rate{
        *this, quantity("spin", "Ω", "rad/s", 10, {0, 30}, {-1e6, 1e6}, "angular velocity at the start, about the vertical axis")
                   .in(Group::start)
                   .rebuilds()
                   .when([this] { return setting == Setting::spin; })};
    Switch ground{*this,
                  setting_of("ground", "is there a floor at y = 0?", 1).in(Group::forces).when([this] { return falls(); })};
    Number restitution{*this, quantity("restitution", "e", "", 0, {0, 1}, "rebound speed of a node over its impact speed")
                                  .in(Group::forces)
                                  .when([this] { return grounded(); })};
    Number friction{*this, quantity("friction", "μ", "", 0.5, {0, 1.5}, {0, 1e6}, "Coulomb's coefficient of the ground")
                               .in(Group::forces)
                               .when([this] { return grounded(); })};
    Number pull_stiffness{*this, springs::pull_stiffness_from(50, {1, 1e4}).when([this] { return !tested(); })};
    Number newton_tolerance{
        *this,
        newton_tolerance_from(1e-9, "Newton's method stops when its step is shorter than this fraction of a spring").when([this] {
            return implicit() && !tested();
        })};
    Whole newton_cap{*this, newton_iterations().when([this] { return implicit() && !tested(); })};

    // --- declarations ---
    void declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_checks(), declare_assumptions(),
        declare_lines();
    std::vector<Probe> static_probes();

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
    bool bends() const { return block_test() == BlockTest::bend; }
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

    // --- what comes to rest ---
    // Springs without stiffness have no dampers.
    bool has_dampers() const { return damped() && damping > 0 && block_->springs().size() > 0; }
    Real rest_speed() const;
    Real rest_force(Index node) const;

    // --- the stages ---
    void follow_parameters();
    void spring_stage();
    void begin_integration();
    void integrate();
    void end_integration();
    void store_memory();
    void recall_memory();
    void contact_stage();
    void static_stage();
    StaticTests::Key static_key() const;
    Real test_amount() const;
    bool test_known() const { return tested() && test_done_ && tests_.knows(static_key()); }
    LatticeConstants endless_lattice() const { return lattice_constants(lattice(), stiffnesses(), edge()); }

    // --- a chain that swings in one of its modes ---
    Index free_masses() const { return support == Support::both ? cells_y - 1 : cells_y; }
    Real mode_shape(Index node) const;
    Real mode_displacement() const;
    Real mode_frequency() const;
    void note_swing();
    std::optional<Real> measured_frequency() const;

    // --- what can be read off (mass_spring_readings.cpp) ---
    Real elastic_energy() const { return spring_energy<3>(block_->springs(), position_); }
    Real total_energy() const;
    std::optional<Real> shadow_energy() const;
    Real motion_energy() const;
    Real rounding_energy() const { return spring_energy_rounding<3>(block_->springs(), position_, size); }
    Real energy_terms() const;
    Real momentum_terms() const { return block_->mass().dot(velocity_.colwise().norm()); }
    Real energy_tolerance() const;
    Real shadow_tolerance() const;
    // A million roundings of positions that move by a velocity per step.
    Real momentum_tolerance() const { return 1e-10 * total_mass * block_->lengths().norm() / dt; }
    Real stretch() const;
    std::optional<Real> sag() const;
    std::optional<Real> falling_height(Real t) const;
    const SpringRates& rates() const;
    Real stable_time_step() const;
    std::string too_large_a_step() const;

    // --- why a number is what it is (mass_spring_why.cpp, mass_spring_why_probes.cpp) ---
    Input stiffness_of_spring(Index spring) const;
    Input node_mass() const { return springs::shared_mass(total_mass, block_->mass().size()); }
    Explanation why_force(const Question& q) const;
    Explanation why_integrated(const Question& q) const;
    std::optional<Explanation> why_contact(const Question& q) const;
    Explanation why_static(const Question& q) const;

    // --- the picture (mass_spring_picture.cpp) ---
    void write_static_notes(Scene& picture) const;
    void draw_test(Scene& picture) const;
    void set_test_frame(Scene& picture) const;
    void draw_mode(Scene& picture) const;

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

    // Of the net at rest, by what they depend on: stiffnesses, damping, mass, rest lengths.
    mutable Remembered<std::tuple<FamilyStiffness, Real, Real, Real, SpringDamping>, SpringRates> rates_;
};

}  // namespace pliant::mass_spring
