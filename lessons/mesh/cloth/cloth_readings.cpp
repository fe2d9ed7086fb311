// Probes, conserved quantities, assumptions, hints and fixes.
#include "cloth.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::cloth {
namespace {

Real total_energy(const ClothLesson& l) {
    return kinetic_energy<3>(l.sheet_->mass(), l.velocity_) + spring_energy<3>(l.sheet_->springs(), l.position_) +
           external_energy<3>({{0, -l.gravity, 0}, l.load_.pull}, l.sheet_->mass(), l.position_);
}

Real energy_terms(const ClothLesson& l) {
    return kinetic_energy<3>(l.sheet_->mass(), l.velocity_) + spring_energy<3>(l.sheet_->springs(), l.position_) +
           std::abs(external_energy<3>({{0, -l.gravity, 0}, l.load_.pull}, l.sheet_->mass(), l.position_));
}

const SpringRates& rates(const ClothLesson& l) {
    return l.rates_.of({{l.k_structural, l.k_shear, l.k_bending}, l.damping, l.total_mass, l.damping_mode}, [&l] {
        return spring_rate_estimates<3>(l.sheet_->springs(), l.sheet_->inertia(), l.damping_mode, l.sheet_->rest());
    });
}

// By how much the energy of a sound run may exceed that of the start, of what motion and a fall by the size of the sheet come to;
// beyond the limit of stability nothing is allowed. Nodes that slid over the round of a sphere are set right.
Real energy_tolerance(const ClothLesson& l) {
    const Real fall = l.total_mass * l.gravity * l.size;
    const Real motion =
        kinetic_energy<3>(l.sheet_->mass(), l.velocity_) + spring_energy<3>(l.sheet_->springs(), l.position_) + fall;
    const Real set_right = l.has_sphere() ? 1e-3 * fall : 0;
    const bool sound = l.implicit() || l.dt <= l.stable_time_step();
    return spring_energy_rounding<3>(l.sheet_->springs(), l.position_, l.size) + set_right +
           motion * (1e-6 + (sound ? energy_excess(l.scheme, rates(l).omega * l.dt, false, l.damped() || l.in_air()) : 0));
}

std::string too_large_a_step(const ClothLesson& l) {
    const Real limit = l.stable_time_step();
    if (l.implicit() || !(l.dt > limit)) return "";
    if (limit == 0)
        return "Explicit Euler without damping is stable at no Δt: switch damping on, or choose implicit Euler as the "
               "integrator";
    return fmt::format(
        "Δt = {} is above the stability limit of {} ({}): choose implicit Euler as the integrator, or lower the time step",
        format_quantity(l.dt, "s", 3), format_quantity(limit, "s", 3), limit_in_words(l.scheme));
}

}  // namespace
void ClothLesson::declare_probes() {
    const auto joules = [](std::string_view name, std::string_view symbol, std::string_view help, std::function<Real()> value) {
        return probe_of(name, symbol, "J", help, std::move(value));
    };
    const auto of_solver = [this](std::string_view name, std::string_view unit, std::string_view help, auto value) {
        return probe_of(name, "", unit, help, [this, value] { return solver() ? std::optional<Real>(value()) : std::nullopt; });
    };
    const auto elastic = [this] {
        return sheet_->energy(structural, position_) + sheet_->energy(shear, position_) + sheet_->energy(bending, position_);
    };
    probes = {
        joules("energy", "E", "kinetic, elastic and gravitational, and of the hand's spring",
               [this] { return total_energy(*this); }),
        joules("kinetic_energy", "K", "½ Σ m v²", [this] { return kinetic_energy<3>(sheet_->mass(), velocity_); }),
        probe_of("elastic_energy", "U", "J", "of all springs: ½ Σ k (|xᵢⱼ| − l)²")
            .formula(*this, "U = Uₛ + U_d + U_b",
                     {Input::now("Uₛ", "stretch_energy", 0), Input::now("U_d", "shear_energy", 0),
                      Input::now("U_b", "bending_energy", 0)}),
        joules("stretch_energy", "Uₛ", "of the structural springs", [this] { return sheet_->energy(structural, position_); }),
        joules("shear_energy", "U_d", "of the shear springs", [this] { return sheet_->energy(shear, position_); }),
        joules("bending_energy", "U_b", "of the bending springs", [this] { return sheet_->energy(bending, position_); }),
        joules("gravitational_energy", "V", "Σ m g y",
               [this] {
                   return gravitational_energy<3>(sheet_->mass(), {0, -gravity, 0}, position_);
               }),
        probe_of("bending_share", "U_b/U", "", "of the elastic energy: how much of it is in the folds",
                 [this, elastic]() -> std::optional<Real> {
                     const Real all = elastic();
                     if (!(all > spring_energy_rounding<3>(sheet_->springs(), position_, size))) return std::nullopt;
                     return sheet_->energy(bending, position_) / all;
                 }),
        probe_of("largest_strain", "ε", "", "largest strain of a structural spring",
                 [this] { return largest_stretch(sheet_->springs(), sheet_->last(structural), position_); })
            .once("largest_stretch"),
        probe_of("strain_before_limiting", "ε₀", "",
                 "largest strain of a structural or shear spring before strain limiting, in the latest step",
                 [this] { return strain_limiting ? std::optional<Real>(stretch_before_limiting_) : std::nullopt; })
            .once("stretch_before_limiting"),
        probe_of("limiting_passes", "", "", "passes of strain limiting in the latest step",
                 [this] { return !strain_limiting || !limiter_ ? std::nullopt : std::optional<Real>(limiter_->passes()); }),
        probe_of("lowest", "y", "m", "height of the lowest node; 0 is the start of a level sheet",
                 [this] { return position_.row(1).minCoeff(); }),
        probe_of("drape_coefficient", "D", "",
                 "area of the sheet seen from above over its flat area; in the drape test both less the disc, as for fabrics",
                 [this] { return drape_coefficient(); }),
        probe_of("touching_nodes", "", "", "nodes on the sphere",
                 [this] { return has_sphere() ? std::optional<Real>(touching_) : std::nullopt; }),
        of_solver("newton_iterations_used", "", "of the latest time step", [this] { return solver()->iterations(); }),
        of_solver("linear_iterations_used", "", "of conjugate gradients in the latest time step",
                  [this] { return solver()->linear_iterations(); }),
        of_solver("imbalance", "N", "largest component of force that the latest step left unbalanced at a node",
                  [this] { return imbalance_.size() ? imbalance_.cwiseAbs().maxCoeff() : Real{0}; }),
    };
}

void ClothLesson::declare_checks() {
    const auto left_alone = [this] { return !pulled() && (wind == 0 || !in_air()) && !strain_limiting; };
    conserved = {
        {.probe = "energy",
         .law = Law::never_grows,
         .tolerance = [this] { return energy_tolerance(*this); },
         .expected = left_alone,
         .cancels = [this] { return energy_terms(*this); }},
    };
    const auto missing = [](const Number& k) { return [&k] { return k > 0 ? 0.0 : 1.0; }; };
    const auto half = [] { return 0.5; };
    assumptions = {
        assumption_of(
            "stability", "s", [this] { return Real(dt); }, [this] { return stable_time_step(); },
            "semi-implicit: Δt ≤ (2/ω)(√(1 + ζ²) − ζ);  explicit: Δt ≤ 2ζ/ω up to ζ = 1, so none without damping, beyond it "
            "(2/ω)(ζ − √(ζ² − 1));  ω of the fastest mode",
            "the fastest mode grows in every step until the sheet tears itself apart")
            .otherwise("unstable")
            .when([this] { return !implicit(); })
            .mended_by(Fix{"implicit Euler", {{"integrator", "implicit_euler"}}}),
        assumption_of(
            "inextensible", "", [this] { return largest_stretch(sheet_->springs(), sheet_->last(structural), position_); },
            [] { return 0.1; }, "ε ≤ 10 % along every thread",
            "woven cloth hardly stretches: a sheet that does looks like rubber")
            .otherwise("stretches")
            .mended_by(Fix{"limit the strain", {{"strain_limiting", "on"}}}),
        assumption_of(
            "solved", "N", [this] { return solver() && imbalance_.size() ? imbalance_.cwiseAbs().maxCoeff() : Real{0}; },
            [this] { return 0.2 * total_mass * std::max(Real{gravity}, Real{1}); }, "|r| ≤ a fifth of the weight at every node",
            "one Newton iteration is not enough for this motion: forces are left unbalanced, and it is slowed down")
            .otherwise("not solved")
            .when([this] { return implicit(); })
            .mended_by(Fix{"solve each step fully", {{"newton", "full"}}}),
        assumption_of("shear_springs", "", missing(k_shear), half, "k_d > 0",
                      "threads alone do not resist shear: the squares fold up into needles")
            .otherwise("no shear springs")
            .mended_by(Fix{"k_d = 100 N/m", {{"k_shear", "100"}}}),
        assumption_of("bending_springs", "", missing(k_bending), half, "k_b > 0",
                      "nothing resists bending: folds are as sharp as the cells are small")
            .otherwise("no bending springs")
            .mended_by(Fix{"k_b = 1 N/m", {{"k_bending", "1"}}}),
    };
}

// Slow, and hardly slower or faster from step to step, against a fall by the size of the sheet; where nothing falls, against the
// largest speed that there was. A node that friction holds creeps.
bool ClothLesson::at_rest() const {
    constexpr Real part = 2e-3;
    if (gust_time_[0] == 0) return false;
    const Real rounding = strain_rounding * rates(*this).omega * size;
    const Real fast = gravity > 0 ? std::sqrt(gravity * size) : pace_[0];
    const Real quick = gravity > 0 ? Real{gravity} : fast * fast / size;
    return velocity_.colwise().norm().maxCoeff() <= part * fast + rounding && pace_[1] <= 10 * part * quick + rounding / dt;
}

std::string ClothLesson::unrest() const {
    if (in_air() && wind != 0 && (setting == Setting::flag || gust != 0)) return "the wind never leaves it in peace (wind, gust)";
    if (setting == Setting::drape && !has_sphere() && gravity > 0)
        return "there is no sphere that it could fall on (sphere_radius = 0)";
    if (implicit() || in_air() || (damped() && damping > 0)) return "";
    return "nothing takes the energy of its springs out (damping mode, damping, air drag)";
}

std::optional<Real> ClothLesson::drape_coefficient() const {
    if (!drapes()) return std::nullopt;
    const Real disc = setting == Setting::pedestal ? std::numbers::pi * sphere_radius * sphere_radius : Real{0};
    const Real flat_area = size * size - disc;
    if (!(flat_area > 0)) return std::nullopt;
    return (sheet_->shadow(position_) - disc) / flat_area;
}

Real ClothLesson::stable_time_step() const {
    return stability_limit(scheme, pulled() ? with_spring_to(rates(*this), pull_stiffness, sheet_->mass()[0]) : rates(*this));
}

std::string ClothLesson::blow_up_hint() const {
    if (const std::string hint = too_large_a_step(*this); !hint.empty()) return hint;
    if (implicit()) return "Lower the time step, or let Newton's method be capped, which takes what a few iterations give";
    return fmt::format(
        "Δt = {} is below the limit {} of small motions: the sheet is far from its shape at rest, or the wind too "
        "strong. Choose implicit Euler as the integrator",
        format_quantity(dt, "s"), format_quantity(stable_time_step(), "s", 3));
}

std::optional<Fix> ClothLesson::fix(const Failure&) const {
    if (!implicit()) return Fix{"implicit Euler", {{"integrator", "implicit_euler"}}};
    if (!capped()) return Fix{"take the last iterate", {{"newton", "capped"}}};
    return fix_by(dt, rounded_down(dt / 4, 2));
}

std::vector<Fix> ClothLesson::other_fixes(const Failure&) const {
    if (implicit()) return capped() ? std::vector<Fix>{} : std::vector{fix_by(dt, rounded_down(dt / 4, 2))};
    return {fix_by(dt, rounded_down(std::min(Real(dt), stable_time_step()) / 4, 2))};
}

// Solved to rounding, in whole parts of the present step.
std::vector<std::pair<std::string, std::string>> ClothLesson::finer() const {
    return {{"integrator", "implicit_euler"},
            {"newton_iterations", "20"},
            {"linear_iterations", "1000"},
            {"linear_tolerance", "1e-6"},
            {"linear_solver", "conjugate_gradients"},
            {"time_step", format_exact(dt / 8)}};
}

}  // namespace pliant::cloth
