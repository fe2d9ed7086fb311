// Finite differences of elastic bodies on a regular grid: a rod that swings, a field that is known, a block under its weight and
// a disc with a boundary in stairs; the equation of Navier and Lamé, and Terzopoulos' form from metric tensors.
#pragma once
#include "kits/material/material_parameters.h"
#include "kits/schemes/scheme_options.h"

#include <pliant/lesson/registry.h>
#include <pliant/math/remembered.h>
#include <pliant/solids/elastic_solutions.h>
#include <pliant/solids/elastic_system.h>
#include <pliant/solids/grid_problem.h>
#include <pliant/solids/newton_equilibrium.h>
#include <pliant/time/rhythm.h>
#include <pliant/time/time_integrator.h>

#include <memory>
#include <optional>
#include <tuple>

namespace pliant::fdm {

enum class Form { navier_lame, metric_tensor };

// The same parameter with another value to begin with.
inline ParameterInfo starting_at(Real initial, ParameterInfo declared) {
    declared.initial = initial;
    return declared;
}

struct FdmLesson final : Lesson {
    FdmLesson() {
        declare_fields(), declare_stages(), declare_probes(), declare_measured_probes(), declare_lines(), declare_checks();
    }

    int dimension() const override { return 2; }
    void reset() override;
    Real time_step() const override { return moves() ? Real{dt} : Real{0}; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::optional<On> can_pull() const override { return is(GridShape::block) ? std::optional(On::node) : std::nullopt; }
    void pull(const std::optional<Pull>& hand) override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override;
    ColourBy first_colours() const override;
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;
    std::vector<std::string_view> map_knobs() const override { return {"time_step", "youngs_modulus"}; }

    // --- parameters ---
    Choice<GridShape> setting{*this,
                              setting_of("scene", "which body, and what is done to it").in(Group::scene).rebuilds(),
                              {{"rod", "a rod, let go stretched"},
                               {"manufactured", "a square whose field is known"},
                               {"block", "a block under its weight"},
                               {"disc", "a spinning disc, in stairs"}}};
    Choice<Form> form{*this,
                      setting_of("form",
                                 "small strains, so that the equation is linear; or the difference of the metric tensors of "
                                 "the deformed and the undeformed shape")
                          .in(Group::method)
                          .rebuilds(),
                      {{"navier_lame", "Navier–Lamé: linear"}, {"metric_tensor", "metric tensors: Terzopoulos"}}};
    Whole resolution{*this, log_quantity("resolution", "n", "", 32, {4, 64}, {1, 400},
                                         "cells along the rod, the sides of the squares, the radius of the disc")
                                .in(Group::method)
                                .rebuilds()};
    Number youngs_modulus{*this, starting_at(1e4, youngs_modulus_info("pull over lengthening, each per unit", {1e3, 1e6}))};
    Number poisson_ratio{*this,
                         poisson_ratio_info("narrowing over lengthening; near ½ edges are stiffer than the inside", {-0.5, 0.49}),
                         [this] { return !is(GridShape::rod); }};
    Number density{
        *this,
        log_quantity("density", "ρ", "kg/m³", 100, {1, 1e4}, {1e-9, 1e12}, "mass per volume").in(Group::material).rebuilds()};
    Number body_force{
        *this,
        quantity("body_force", "b₀", "N/m³", 1000, {0, 4000}, {-1e12, 1e12},
                 "force per volume: the weight of the block, downwards; of the disc outwards at its rim, where it is "
                 "ρ ω² R")
            .in(Group::forces)
            .rebuilds(),
        [this] { return is(GridShape::block) || is(GridShape::disc); }};
    Number length{*this, log_quantity("length", "L", "m", 1, {0.1, 10}, {1e-6, 1e6},
                                      "of the rod, of the sides of the squares, the radius of the disc")
                             .in(Group::shape)
                             .rebuilds()};
    Number start_strain{*this,
                        quantity("start_strain", "ε₀", "", 0.01, {0, 0.1}, {-0.9, 1}, "of the whole rod when it is let go")
                            .in(Group::start)
                            .rebuilds(),
                        [this] { return is(GridShape::rod); }};
    Number amplitude{
        *this,
        quantity("amplitude", "A", "", 0.1, {0.01, 0.1}, {0, 1, true}, "of the known field over the side of the square")
            .in(Group::forces)
            .rebuilds(),
        [this] { return is(GridShape::manufactured); }};
    Choice<ExplicitScheme> integrator{
        *this,
        setting_of("integrator", "how accelerations become motion; the lecture's is semi-implicit Euler",
                   ExplicitScheme::velocity_verlet)
            .in(Group::method)
            .when([this] { return moves(); }),
        explicit_scheme_options()};
    Number dt{*this, fixed_time_step(1e-3, {1e-4, 0.01}).when([this] { return moves(); })};
    Number damping{
        *this,
        quantity("damping", "α", "1/s", 3, {0, 30}, {0, 1e6}, "drag on the block for its mass: −α v of its acceleration")
            .in(Group::material),
        [this] { return is(GridShape::block); }};
    Number pull_stiffness{*this,
                          log_quantity("pull_stiffness", "kₕ", "N/m²", 2000, {100, 1e5}, {0, 1e12},
                                       "of the spring from a node to the pointer that pulls it, for 1 m of depth")
                              .in(Group::view),
                          [this] { return is(GridShape::block); }};
    Number point_x{*this,
                   quantity("point_x", "i/n", "", 0.5, {0, 1}, "where across the body lies the node whose stencil is shown")
                       .in(Group::view)
                       .looks()};
    Number point_y{*this,
                   quantity("point_y", "j/n", "", 0.5, {0, 1}, "how high in the body lies the node whose stencil is shown")
                       .in(Group::view)
                       .looks(),
                   [this] { return !is(GridShape::rod); }};

    // --- declarations ---
    void declare_fields(), declare_stages(), declare_probes(), declare_measured_probes(), declare_lines(), declare_checks();

    // --- what the parameters mean ---
    bool is(GridShape wanted) const { return GridShape(setting) == wanted; }
    bool moves() const { return is(GridShape::rod) || is(GridShape::block); }
    bool linear() const { return form == Form::navier_lame; }
    bool damped() const { return is(GridShape::block) && damping > 0; }
    bool loaded() const { return !is(GridShape::rod); }
    bool pulled() const { return hand_.active(); }
    bool solved() const { return clock_[is_solved] == 1; }
    Scheme scheme() const { return scheme_of(integrator); }
    GridBody body() const { return body_at(resolution); }
    GridBody body_at(Index cells) const;
    const ElasticGrid<2>& grid() const { return problem_->grid(); }
    Lame material() const { return body().material(); }
    Real spacing() const { return length / static_cast<Real>(Index(resolution)); }  // Δx, m
    Real pressure_wave_speed() const;                                               // c_p, m/s; of a rod c
    // A rod is as tall as it is long: all of its rows move as the one that is computed.
    Real rows() const { return is(GridShape::rod) ? static_cast<Real>(Index(resolution)) : 1; }
    Index point() const;                              // the node whose stencil is shown
    Index nearest_node(Real across, Real up) const;   // of shares of the body's box
    std::vector<Index> samples_of(Index node) const;  // that it is the corner of

    // --- the stages (fdm_stages.cpp) ---
    void difference_stage(), metric_stage(), strain_stage(), stress_stage(), load_stage(), balance_stage(), support_stage(),
        acceleration_stage(), solve_stage();
    void divergence_pass(), stencil_pass();
    Index stencil_passes() const { return is(GridShape::rod) ? 1 : 3; }
    void begin_integration(), integrate(), end_integration();
    void follow_hand();

    // --- what can be read off (fdm_readings.cpp, fdm_lines.cpp) ---
    ReleasedRod released() const { return {length, pressure_wave_speed(), start_strain}; }
    bool has_exact() const { return is(GridShape::rod) ? linear() : body().has_exact(); }
    Vec<2> exact_at(Index node) const;                                             // m
    Real nodal_error() const;                                                      // m
    Real largest_exact() const;                                                    // m
    Real elastic_energy() const { return rows() * grid().energy(displacement_); }  // J/m
    Real kinetic_energy() const;
    Real load_energy() const;
    Real total_energy() const { return kinetic_energy() + elastic_energy() + load_energy(); }
    Real start_motion() const;  // J/m, what motion can come to
    Real momentum(int axis) const;
    Real largest_strain() const;
    Real stencil_difference() const, force_rounding() const;
    Vec<2> corner_displacement() const, top_displacement() const;
    Real tip() const;
    void note_swing();
    const FemBeside* beside() const;                  // null where finite elements find none
    std::optional<Real> error_at(Index cells) const;  // of another resolution, m
    std::optional<Real> observed_order() const;
    void sample_errors(Curve& curve, bool by_elements) const;

    // --- how far it can be trusted (fdm_checks.cpp) ---
    Real fastest() const;        // rad/s, with the spring of the hand
    Real damping_ratio() const;  // of the fastest motion
    Real longest_step() const;   // s, of the scheme on this body
    Real reach() const;          // m, beyond any displacement of a sound run
    Real rest_speed() const, rest_acceleration() const;
    Real squeeze() const;  // 1 less the smallest stretch of a sample

    // --- how the numbers came about (fdm_why.cpp) ---
    Input why_spacing() const { return part("Δx = L / n", {length, resolution}); }
    Input why_lambda() const { return lame_lambda(youngs_modulus, poisson_ratio); }
    Input why_mu() const { return lame_mu(youngs_modulus, poisson_ratio); }
    std::optional<Explanation> why(const Question& q) const;
    Explanation why_sample(const Question&q) const, why_stress(const Question&q) const;
    Explanation why_divergence(const Question&q) const, why_stencil(const Question&q) const, why_load(const Question&q) const;
    std::optional<Explanation> why_motion(const Question& q) const;
    std::optional<Explanation> why_solved(const Question& q) const;

    // --- the picture (fdm_picture.cpp, fdm_stencil_picture.cpp) ---
    Real magnification() const;
    Position node_place(Index node) const;  // in the picture
    void draw_stencil(Scene& picture) const;
    // Entries of the row of the force per volume at the point, f_component = Σ w u: of the node at (right, up) and its
    // displacement along `of`, Pa/m².
    Real stencil_weight(int component, int right, int up, int of) const;
    Mat<2> stiffness_block(Index a, Index b) const;  // N/m², for 1 m of depth

    // What a run is made of.
    std::unique_ptr<GridProblem> problem_;
    Points<2> rest_;  // 0: degrees of freedom are displacements
    DiagonalMass inertia_;
    std::unique_ptr<ElasticSystem<2>> system_;
    std::unique_ptr<TimeIntegrator> integrator_;
    std::unique_ptr<NewtonEquilibrium<2>> newton_;
    Points<2> before_newton_;                   // m, at the start of its latest iteration
    PullSpring<2> hand_;                        // its target as a displacement, m
    Real start_energy_ = 0, start_motion_ = 0;  // J/m
    Index divergence_passes_ = 0, stencil_passes_ = 0;

    // State [m, m/s, s], and what the stages make of it.
    Points<2> displacement_, velocity_;
    enum Clock : Index { elapsed, is_solved, iterations, clock_count };
    VecX clock_ = VecX::Zero(clock_count);
    Rhythm rhythm_;
    ElasticGrid<2>::Tensors gradient_, metric_, strain_, stress_;
    Points<2> load_, force_, stencil_force_, unbalanced_, reaction_, acceleration_, step_, error_;

    // Results that take a solve, by what they depend on.
    using Body = std::tuple<GridShape, Form, Index, Real, Real, Real, Real, Real>;
    Body body_key(Index cells) const;
    mutable Remembered<Body, std::optional<FemBeside>> beside_;
    mutable Remembered<Body, std::optional<Real>> coarse_error_;
    mutable Remembered<std::tuple<GridShape, Index, Real>, Real> frequency_;  // over that of waves inside
    mutable Remembered<std::tuple<GridShape, Form, Real, Real>, std::array<Curve, 2>> errors_;
    mutable Remembered<Index, SparseMatrix> tangent_;  // of the latest Newton iteration
};
}  // namespace pliant::fdm
