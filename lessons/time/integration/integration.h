// Eight time integrators on motions whose exact solution is known: a mass on a spring, a pendulum, a stiff pair.
#pragma once
#include "integration.h"
#include "kits/schemes/scheme_options.h"

#include <pliant/lesson/registry.h>
#include <pliant/time/rhythm.h>
#include <pliant/time/scheme_runs.h>
#include <pliant/time/stability_region.h>

#include <memory>
#include <optional>

namespace pliant::integration {

enum class Compare { none, lecture, all };

struct IntegrationLesson final : Lesson {
    IntegrationLesson() { declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return 2; }
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<Fix> other_fixes(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::vector<std::string_view> first_plots() const override {
        if (compare == Compare::all) return {"error_over_step", "error_over_cost", "energy_of_all"};
        return {"x", "energy_of_all", "error_over_step"};
    }
    std::vector<std::string_view> key_numbers() const override { return {"energy", "error", "growth_measured"}; }

    // How far a step has come.
    static constexpr Real between_steps = 0, force_known = 1, predicted = 2;

    // --- parameters ---
    Choice<SwingingKind> system{
        *this,
        setting_of("system", "what moves; every mass is 1 kg").in(Group::scene).rebuilds(),
        {{"oscillator", "mass on a spring"}, {"pendulum", "pendulum"}, {"stiff_pair", "soft and stiff spring"}}};
    Choice<Scheme> scheme{*this,
                          setting_of("integrator", "how a force becomes motion", 1).once("scheme").in(Group::method).rebuilds(),
                          scheme_options()};
    Number omega{*this, log_quantity("omega", "ω", "rad/s", 2, {0.1, 100}, {0, 1e9},
                                     "angular frequency: of the mass on the spring, of the soft spring of the pair, of small "
                                     "swings of the pendulum, whose length is g/ω²")
                            .in(Group::material)
                            .rebuilds()};
    Number zeta{*this, quantity("damping_ratio", "ζ", "", 0, {0, 1.5}, {0, 1e9},
                                "of the drag −2ζω m v: from 1 on nothing swings any more; in the pair the same of both modes")
                           .in(Group::material)
                           .rebuilds()};
    Number dt{*this, fixed_time_step(0.05, {1e-3, 10}, 1e6).rebuilds()};
    Number x0{*this, quantity("x0", "x₀", "m", 1, {-2, 2}, {-1e6, 1e6},
                              "place at the start; of the pendulum along its arc, of the pair of both masses")
                         .in(Group::start)
                         .rebuilds()};
    Number v0{*this, quantity("v0", "v₀", "m/s", 0, {-5, 5}, {-1e6, 1e6}, "velocity at the start").in(Group::start).rebuilds()};
    Number ratio{*this, log_quantity("stiffness_ratio", "κ", "", 400, {1, 1e4}, {0, 1e8, true},
                                     "stiffness of the spring between the two masses over that of the soft one")
                            .in(Group::material)
                            .rebuilds()
                            .when([this] { return is(SwingingKind::stiff_pair); })};
    Choice<Compare> compare{
        *this,
        setting_of("compare", "schemes that run beside the chosen one, from the same start", 1).in(Group::view),
        {{"none", "none"}, {"lecture", "the lecture's three"}, {"all", "all eight"}}};
    Number newton_tolerance{
        *this, newton_tolerance_from(1e-9, "Newton's method stops when its step is shorter than this part of the swing")
                   .rebuilds()
                   .when([this] { return solves(); })};
    Whole newton_cap{*this, newton_iterations().rebuilds().when([this] { return solves(); })};

    // --- declarations ---
    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();

    // --- the stages ---
    void force_stage();
    void predict();
    void pass();
    void advance();

    // --- what the parameters mean ---
    bool implicit() const { return is_implicit(scheme); }
    // Is there an equation to solve, in the run or beside it?
    bool solves() const { return implicit() || compare != Compare::none; }
    bool is(SwingingKind one) const { return system == one; }
    bool measures_map() const { return is(SwingingKind::oscillator) && omega > 0; }
    NewtonOptions newton() const { return {newton_tolerance, static_cast<int>(Index(newton_cap))}; }
    SchemeMethod method(Scheme one) const { return {one, newton()}; }
    std::vector<Scheme> companions() const;          // the running scheme is not among them
    Index watched() const { return x_.size() - 1; }  // the mass that is plotted: of the pair the outer one
    Real rate() const { return motion_->slow_rate() > 0 ? motion_->slow_rate() : 1; }  // of the axis v/ω, 1/s
    Real time() const { return counts_[0] * dt; }
    bool inside(Real at_least) const { return counts_[3] >= at_least; }

    // --- what is measured (integration_readings.cpp) ---
    Real energy() const { return motion_->energy(x_, v_); }
    Real kinetic_energy() const { return 0.5 * v_.squaredNorm(); }
    std::optional<Real> error() const;
    std::optional<Real> measured_growth() const;
    std::optional<Real> theoretical_frequency() const;
    std::optional<Real> shadow_energy() const;
    std::optional<Real> order() const;

    // --- curves, of all schemes (integration_lines.cpp) ---
    const SchemePath& path_of(Scheme one) const;
    const ErrorCurve& errors_of(Scheme one) const;
    bool compared(Scheme one) const;

    // --- what holds, and what would mend a run (integration_checks.cpp) ---
    Real stable_time_step() const { return stability_limit(scheme, motion_->fast_rate(), zeta); }
    Real growth_per_step() const { return amplification(scheme, motion_->fast_rate(), zeta, dt); }
    bool stable() const { return growth_per_step() <= 1 + 1e-9; }

    // --- why a number is what it is (integration_why.cpp, integration_why_probes.cpp) ---
    using Reading = Input (*)(std::string symbol, std::string_view field, Index index, int component);
    Explanation why_force(Index dof, std::string_view x_field, std::string_view v_field, Reading at, std::string_view mark) const;
    std::optional<Explanation> why_pass(const Question& q) const;
    std::optional<Explanation> why_predicted(const Question& q) const;
    Input unit_mass() const { return Input::constant("m", 1, "kg", "of each mass"); }
    Explanation why_advanced(const Question& q) const;
    Explanation why_energy() const;
    Explanation why_kinetic_energy() const;
    Explanation why_potential_energy() const;
    Explanation why_shadow_energy() const;
    Explanation why_exact(bool of_velocity) const;
    Explanation why_error() const;
    Explanation why_growth() const;
    Explanation why_frequency() const;

    // --- the picture (integration_picture.cpp, region_picture.cpp) ---
    void draw_motion(Scene& scene) const;
    void draw_region(Scene& scene) const;
    Real portrait_reach() const;  // m: half the width of the portrait
    bool turns() const;           // does a pendulum's portrait show the whole turn?
    Position in_portrait(const Motion& at) const;

    // State [m, m/s]; what the stages make of it [m, m/s, N]; what the measurement of growth needs.
    VecX x_, v_;
    VecX force_, trial_x_, trial_v_, pass_force_, residual_;
    VecX before_;  // x and v at the start of the latest whole step, and of the one before it
    // Steps; force evaluations of the latest step, and in all; what of the present step is done.
    Eigen::Array4d counts_ = Eigen::Array4d::Zero();
    Index evaluated_before_ = 0;  // by the integrator, before this step

    Rhythm rhythm_;

    std::unique_ptr<Swinging> motion_;
    std::unique_ptr<DiagonalMass> mass_;
    std::unique_ptr<TimeIntegrator> integrator_;

    mutable SchemePaths paths_;
    struct Errors {
        SwingingOptions options;
        NewtonOptions newton;
        std::optional<ErrorCurve> curve;
    };
    mutable std::array<Errors, 8> errors_;
    mutable std::array<std::optional<StabilityRegion>, 8> regions_;
};

// Where the parts of the picture stand: the portrait is the square from −1 to 1.

inline constexpr Real region_x = 2.35;  // the middle of the plane of λΔt
inline constexpr Index start_handle = 0, root_handle = 1;

struct InkOf {
    Ink ink;
    bool dashed;
};
InkOf ink_of(Scheme scheme);

}  // namespace pliant::integration
