// Probes, conserved quantities, assumptions, hints and fixes.
#include "cloth.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pliant::cloth {
void ClothLesson::declare_probes() {
    const auto joules = [](std::string_view name, std::string_view symbol, std::string_view help, std::function<Real()> value) {
        return Probe{.name = name, .symbol = symbol, .unit = "J", .help = help, .value = std::move(value)};
    };
    const auto of_solver = [this](std::string_view name, std::string_view unit, std::string_view help, auto value) {
        return Probe{.name = name, .unit = unit, .help = help, .value = [this, value]() -> std::optional<Real> {
                         if (!solver()) return std::nullopt;
                         return Real(value());
                     }};
    };
    const auto elastic = [this] {
        return sheet_->energy(structural, position_) + sheet_->energy(shear, position_) + sheet_->energy(bending, position_);
    };
    probes = {
        joules("energy", "E", "kinetic, elastic and gravitational, and of the hand's spring", [this] { return total_energy(); }),
        joules("kinetic_energy", "K", "½ Σ m v²", [this] { return kinetic_energy<3>(sheet_->mass(), velocity_); }),
        joules("elastic_energy", "U", "of all springs: ½ Σ k (|xᵢⱼ| − l)²", elastic),
        joules("stretch_energy", "Uₛ", "of the structural springs", [this] { return sheet_->energy(structural, position_); }),
        joules("shear_energy", "U_d", "of the shear springs", [this] { return sheet_->energy(shear, position_); }),
        joules("bending_energy", "U_b", "of the bending springs", [this] { return sheet_->energy(bending, position_); }),
        joules("gravitational_energy", "V", "Σ m g y",
               [this] {
                   return gravitational_energy<3>(sheet_->mass(), {0, -gravity, 0}, position_);
               }),
        {.name = "bending_share",
         .symbol = "U_b/U",
         .help = "of the elastic energy: how much of it is in the folds",
         .value = [this, elastic]() -> std::optional<Real> {
             const Real all = elastic();
             if (!(all > rounding_energy())) return std::nullopt;
             return sheet_->energy(bending, position_) / all;
         }},
        {.name = "largest_stretch",
         .symbol = "ε",
         .help = "largest strain of a structural spring",
         .value = [this] { return largest_stretch(sheet_->springs(), sheet_->last(structural), position_); }},
        {.name = "stretch_before_limiting",
         .symbol = "ε₀",
         .help = "largest strain of a structural or shear spring before strain limiting, in the latest step",
         .value = [this]() -> std::optional<Real> {
             if (!strain_limiting) return std::nullopt;
             return stretch_before_limiting_;
         }},
        {.name = "limiting_passes",
         .help = "passes of strain limiting in the latest step",
         .value = [this]() -> std::optional<Real> {
             if (!strain_limiting || !limiter_) return std::nullopt;
             return Real(limiter_->passes());
         }},
        {.name = "lowest",
         .symbol = "y",
         .unit = "m",
         .help = "height of the lowest node; 0 is the start of a level sheet",
         .value = [this] { return position_.row(1).minCoeff(); }},
        {.name = "drape_coefficient",
         .symbol = "D",
         .help = "area of the sheet seen from above over its flat area; in the drape test both less the disc, as for fabrics",
         .value = [this] { return drape_coefficient(); }},
        {.name = "touching_nodes",
         .help = "nodes on the sphere",
         .value = [this]() -> std::optional<Real> {
             if (!has_sphere()) return std::nullopt;
             return Real(touching_);
         }},
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
         .tolerance = [this] { return energy_tolerance(); },
         .expected = left_alone,
         .cancels = [this] { return energy_terms(); }},
    };
    const auto missing = [](const Number& k) { return [&k] { return k > 0 ? 0.0 : 1.0; }; };
    const auto half = [] { return 0.5; };
    assumptions = {
        {.name = "stability",
         .unit = "s",
         .value = [this] { return Real(dt); },
         .limit = [this] { return stable_time_step(); },
         .formula =
             "semi-implicit: Δt ≤ (2/ω)(√(1 + ζ²) − ζ);  explicit: Δt ≤ 2ζ/ω up to ζ = 1, so none without damping, beyond it "
             "(2/ω)(ζ − √(ζ² − 1));  ω of the fastest mode",
         .broken = "the fastest mode grows in every step until the sheet tears itself apart",
         .used = [this] { return !implicit(); },
         .fix =
             [] {
                 return std::optional(Fix{"implicit Euler", {{"scheme", "implicit_euler"}}});
             }},
        {.name = "inextensible",
         .value = [this] { return largest_stretch(sheet_->springs(), sheet_->last(structural), position_); },
         .limit = [] { return 0.1; },
         .formula = "ε ≤ 10 % along every thread",
         .broken = "woven cloth hardly stretches: a sheet that does looks like rubber",
         .fix =
             [] {
                 return std::optional(Fix{"limit the strain", {{"strain_limiting", "on"}}});
             }},
        {.name = "solved",
         .unit = "N",
         .value = [this] { return solver() && imbalance_.size() ? imbalance_.cwiseAbs().maxCoeff() : Real{0}; },
         .limit = [this] { return 0.2 * total_mass * std::max(Real{gravity}, Real{1}); },
         .formula = "|r| ≤ a fifth of the weight at every node",
         .broken = "one Newton iteration is not enough for this motion: forces are left unbalanced, and it is slowed down",
         .used = [this] { return implicit(); },
         .fix =
             [] {
                 return std::optional(Fix{"solve each step fully", {{"newton", "full"}}});
             }},
        {.name = "shear_springs",
         .value = missing(k_shear),
         .limit = half,
         .formula = "k_d > 0",
         .broken = "threads alone do not resist shear: the squares fold up into needles",
         .fix =
             [] {
                 return std::optional(Fix{"k_d = 100 N/m", {{"k_shear", "100"}}});
             }},
        {.name = "bending_springs",
         .value = missing(k_bending),
         .limit = half,
         .formula = "k_b > 0",
         .broken = "nothing resists bending: folds are as sharp as the cells are small",
         .fix =
             [] {
                 return std::optional(Fix{"k_b = 1 N/m", {{"k_bending", "1"}}});
             }},
    };
}

Real ClothLesson::total_energy() const {
    return kinetic_energy<3>(sheet_->mass(), velocity_) + spring_energy<3>(sheet_->springs(), position_) +
           external_energy<3>({{0, -gravity, 0}, load_.pull}, sheet_->mass(), position_);
}

// Of springs between places that are known to their rounding, after many steps.
Real ClothLesson::rounding_energy() const {
    const Real place = 1e4 * std::numeric_limits<Real>::epsilon() * (position_.cwiseAbs().maxCoeff() + size);
    return 0.5 * sheet_->springs().stiffness().sum() * place * place;
}

Real ClothLesson::energy_terms() const {
    return kinetic_energy<3>(sheet_->mass(), velocity_) + spring_energy<3>(sheet_->springs(), position_) +
           std::abs(external_energy<3>({{0, -gravity, 0}, load_.pull}, sheet_->mass(), position_));
}

// By how much the energy of a sound run may exceed that of the start, of what motion and a fall by the size of the sheet come to;
// beyond the limit of stability nothing is allowed. Nodes that slid over the round of a sphere are set right.
Real ClothLesson::energy_tolerance() const {
    const Real fall = total_mass * gravity * size;
    const Real motion = kinetic_energy<3>(sheet_->mass(), velocity_) + spring_energy<3>(sheet_->springs(), position_) + fall;
    const Real set_right = has_sphere() ? 1e-3 * fall : 0;
    const bool sound = implicit() || dt <= stable_time_step();
    return rounding_energy() + set_right +
           motion * (1e-6 + (sound ? energy_excess(scheme, rates().omega * dt, false, damped() || in_air()) : 0));
}

// Slow, and hardly slower or faster from step to step, against a fall by the size of the sheet; where nothing falls, against the
// largest speed that there was. A node that friction holds creeps.
bool ClothLesson::at_rest() const {
    constexpr Real part = 2e-3;
    if (gust_time_[0] == 0) return false;
    const Real rounding = strain_rounding * rates().omega * size;
    const Real fast = gravity > 0 ? std::sqrt(gravity * size) : pace_[0];
    const Real quick = gravity > 0 ? Real{gravity} : fast * fast / size;
    return velocity_.colwise().norm().maxCoeff() <= part * fast + rounding && pace_[1] <= 10 * part * quick + rounding / dt;
}

std::string ClothLesson::unrest() const {
    if (in_air() && wind != 0 && (setting == Setting::flag || gust != 0)) return "the wind never leaves it in peace (wind, gust)";
    if (setting == Setting::drape && !has_sphere() && gravity > 0)
        return "there is no sphere that it could fall on (sphere_radius = 0)";
    if (implicit() || in_air() || (damped() && damping > 0)) return "";
    return "nothing takes the energy of its springs out (damping_mode, damping, air_drag)";
}

std::optional<Real> ClothLesson::drape_coefficient() const {
    if (!drapes()) return std::nullopt;
    const Real disc = setting == Setting::pedestal ? std::numbers::pi * sphere_radius * sphere_radius : Real{0};
    const Real flat_area = size * size - disc;
    if (!(flat_area > 0)) return std::nullopt;
    return (sheet_->shadow(position_) - disc) / flat_area;
}

const SpringRates& ClothLesson::rates() const {
    const RatesKey key{{k_structural, k_shear, k_bending}, damping, total_mass, damping_mode};
    if (rates_key_ != key) {
        Points<3> rest = sheet_->rest();
        rates_ = spring_rate_estimates<3>(sheet_->springs(), sheet_->inertia(), damping_mode, rest);
        rates_key_ = key;
    }
    return rates_;
}

Real ClothLesson::stable_time_step() const {
    SpringRates rates_now = rates();
    // The hand's spring acts on one node; what it adds to ω² is at most its own.
    if (pulled()) rates_now.omega = std::hypot(rates_now.omega, std::sqrt(pull_stiffness / sheet_->mass()[0]));
    return stability_limit(scheme, rates_now);
}

std::string ClothLesson::too_large_a_step() const {
    const Real limit = stable_time_step();
    if (implicit() || !(dt > limit)) return "";
    if (limit == 0)
        return "Explicit Euler without damping is stable at no Δt: switch damping_mode on, or choose implicit_euler as the "
               "scheme";
    return fmt::format("Δt = {} is above the stability limit of {} ({}): choose implicit_euler as the scheme, or lower time_step",
                       format_quantity(dt, "s", 3), format_quantity(limit, "s", 3), limit_in_words(scheme));
}

std::string ClothLesson::blow_up_hint() const {
    if (const std::string hint = too_large_a_step(); !hint.empty()) return hint;
    if (implicit()) return "Lower time_step, or set newton to capped, which takes what a few iterations give";
    return fmt::format(
        "Δt = {} is below the limit {} of small motions: the sheet is far from its shape at rest, or the wind too "
        "strong. Choose implicit_euler as the scheme",
        format_quantity(dt, "s"), format_quantity(stable_time_step(), "s", 3));
}

std::optional<Fix> ClothLesson::fix(const Failure&) const {
    if (!implicit()) return Fix{"implicit Euler", {{"scheme", "implicit_euler"}}};
    if (!capped()) return Fix{"take the last iterate", {{"newton", "capped"}}};
    const Real shorter = rounded_down(dt / 4, 2);
    return Fix{fmt::format("Δt = {}", format_quantity(shorter, "s")), {{"time_step", format_exact(shorter)}}};
}

// Solved to rounding, in whole parts of the present step.
std::vector<std::pair<std::string, std::string>> ClothLesson::finer() const {
    return {{"scheme", "implicit_euler"},
            {"newton_cap", "20"},
            {"linear_iterations", "1000"},
            {"linear_tolerance", "1e-6"},
            {"linear_solver", "conjugate_gradients"},
            {"time_step", format_exact(dt / 8)}};
}

}  // namespace pliant::cloth
