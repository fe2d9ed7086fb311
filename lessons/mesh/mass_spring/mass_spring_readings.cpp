// Probes, conserved quantities, assumptions and hints.
#include "mass_spring.h"

#include <pliant/lesson/format.h>
#include <pliant/solids/point_masses.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {

void MassSpringLesson::declare_probes() {
    const auto joules = [](std::string_view name, std::string_view symbol, std::string_view help, std::function<Real()> value) {
        return Probe{.name = name, .symbol = symbol, .unit = "J", .help = help, .value = std::move(value)};
    };
    probes = {
        joules("energy", "E", "kinetic, elastic and gravitational, and of the hand's spring", [this] { return total_energy(); }),
        joules("kinetic_energy", "K", "½ Σ m v²", [this] { return kinetic_energy<3>(block_->mass(), velocity_); }),
        joules("elastic_energy", "U", "½ Σ k (|xᵢⱼ| − l)²", [this] { return elastic_energy(); }),
        joules("gravitational_energy", "V", "Σ m g y",
               [this] {
                   return gravitational_energy<3>(block_->mass(), {0, -weight_acceleration(), 0}, position_);
               }),
        {.name = "shadow_energy",
         .symbol = "Ẽ",
         .unit = "J",
         .help = "E + Δt/2 v·f, which semi-implicit Euler conserves in place of the energy",
         .value = [this] { return shadow_energy(); }},
        {.name = "damping_power",
         .symbol = "P",
         .unit = "W",
         .help = "that the dampers take out of the motion; 0 for a rigid rotation if they are projected",
         .value = [this]() -> std::optional<Real> {
             if (!damped()) return std::nullopt;
             return damping_power<3>(block_->springs(), damping_mode, position_, velocity_);
         }},
        {.name = "momentum",
         .symbol = "p",
         .unit = "kg m/s",
         .help = "magnitude of Σ m v",
         .value = [this] { return momentum<3>(block_->mass(), velocity_).norm(); }},
        {.name = "angular_momentum",
         .symbol = "J",
         .unit = "kg m²/s",
         .help = "magnitude, about the centre of mass",
         .value = [this] { return angular_momentum<3>(block_->mass(), position_, velocity_).norm(); },
         .exact = [this](Real) -> std::optional<Real> {
             if (setting != Setting::spin || interfered_) return std::nullopt;
             return start_angular_momentum_;
         }},
        {.name = "height",
         .symbol = "h",
         .unit = "m",
         .help = "of the centre of mass",
         .value = [this] { return centre_of_mass<3>(block_->mass(), position_)[1]; },
         .exact = [this](Real t) { return falling_height(t); }},
        {.name = "stretch", .symbol = "ε", .help = "largest |strain| of a spring", .value = [this] { return stretch(); }},
        {.name = "sag",
         .symbol = "s",
         .unit = "m",
         .help = "by how much the face opposite to the held one hangs lower than at rest",
         .value = [this] { return sag(); }},
        {.name = "touching_nodes",
         .help = "nodes on the ground",
         .value = [this]() -> std::optional<Real> {
             if (!grounded()) return std::nullopt;
             return Real(touching_);
         }},
        {.name = "newton_iterations_used",
         .help = "of the latest time step",
         .value = [this]() -> std::optional<Real> {
             if (!implicit() || !solver_) return std::nullopt;
             return Real(solver_->iterations());
         }},
    };
}

void MassSpringLesson::declare_checks() {
    conserved = {
        // A body that nothing outside acts on.
        {.probe = "momentum",
         .tolerance = [this] { return momentum_tolerance(); },
         .expected = [this] { return setting == Setting::spin && !pulled(); }},
        // Semi-implicit Euler keeps it exactly, for forces along the springs; the other two gain or lose Δt² Σ v × f per step.
        {.probe = "angular_momentum",
         .tolerance = [this] { return momentum_tolerance() * block_->lengths().norm(); },
         .expected =
             [this] { return setting == Setting::spin && !pulled() && semi_implicit() && damping_mode != SpringDamping::naive; }},
        {.probe = "energy",
         .law = Law::never_grows,
         .tolerance = [this] { return energy_tolerance(); },
         .expected = [this] { return !pulled() && integrator != Scheme::explicit_euler && dt <= stable_time_step(); }},
        {.probe = "shadow_energy",
         .tolerance = [this] { return shadow_tolerance(); },
         .expected = [this] { return semi_implicit() && !damped() && !pulled() && touching_ == 0 && dt <= stable_time_step(); }},
    };
    assumptions = {
        {.name = "stability",
         .unit = "s",
         .value = [this] { return Real(dt); },
         .limit = [this] { return stable_time_step(); },
         .formula =
             "semi-implicit: Δt ≤ (2/ω)(√(1 + ζ²) − ζ);  explicit: Δt ≤ 2ζ/ω, so none without damping;  ω of the fastest mode",
         .broken = "the fastest mode grows in every step until the block tears itself apart",
         .used = [this] { return !implicit(); }},
        {.name = "cell_inversion",
         .value = [this] { return 1 - block_->smallest_cell(position_); },
         .limit = [] { return 0.9; },
         .formula = "1 − V/V₀ ≤ 0.9 in every cell",
         .broken = "a cell is nearly flat, or turned inside out; springs know lengths, not volumes, and may rest there"},
        {.name = "travel",
         .unit = "m",
         .value = [this] { return dt * std::sqrt(velocity_.colwise().squaredNorm().maxCoeff()); },
         .limit = [this] { return size / Real(Index(cells_x)); },
         .formula = "|v| Δt ≤ l",
         .broken = "a node passes a whole cell in one step: impacts are met too late"},
        {.name = "shear_mechanism",
         .value = [this] { return k_shear > 0 ? 0.0 : 1.0; },
         .limit = [] { return 0.5; },
         .formula = "k_d > 0",
         .broken = "edges alone do not resist shear: the block folds like a cardboard box without a lid"},
    };
}

Real MassSpringLesson::total_energy() const {
    return kinetic_energy<3>(block_->mass(), velocity_) + elastic_energy() +
           external_energy<3>({{0, -weight_acceleration(), 0}, load_.pull}, block_->mass(), position_);
}

// What semi-implicit Euler conserves: exactly for linear forces, else up to the order of Δt² [Hairer2006 §IX.3].
std::optional<Real> MassSpringLesson::shadow_energy() const {
    if (!semi_implicit()) return std::nullopt;
    Points<3> force = Points<3>::Zero(3, position_.cols());
    add_spring_forces<3>(block_->springs(), position_, force);
    add_external_forces<3>({{0, -weight_acceleration(), 0}, load_.pull}, block_->mass(), position_, force);
    return total_energy() + 0.5 * dt * flat(force).dot(flat(velocity_));
}

// The energy is that conserved one less Δt/2 v·f, at its largest so far, now and when the law began to hold.
Real MassSpringLesson::energy_tolerance() const {
    const Real scale = kinetic_energy<3>(block_->mass(), velocity_) + elastic_energy() + std::abs(total_energy());
    if (implicit()) return 1e-6 * scale;
    const Real wobble_now = std::abs(shadow_energy().value_or(total_energy()) - total_energy());
    return 2 * std::max(energy_wobble_, wobble_now) + shadow_tolerance();
}

// The next order is smaller by ω Δt; the rest is the rounding of many steps.
Real MassSpringLesson::shadow_tolerance() const {
    const Real scale = kinetic_energy<3>(block_->mass(), velocity_) + elastic_energy() + std::abs(total_energy());
    return rates().omega * dt * energy_wobble_ + 1e-9 * scale;
}

// A million roundings of positions that move by a velocity per step.
Real MassSpringLesson::momentum_tolerance() const { return 1e-10 * total_mass * block_->lengths().norm() / dt; }

Real MassSpringLesson::stretch() const {
    Real largest = 0;
    const Springs& springs = block_->springs();
    for (Index s = 0; s < springs.size(); ++s) {
        const Real rest = springs.rest_length()[s];
        const Real strain = (position_.col(springs.j(s)) - position_.col(springs.i(s))).norm() / rest - 1;
        largest = std::max(largest, std::abs(strain));
    }
    return largest < strain_rounding ? 0 : largest;
}

std::optional<Real> MassSpringLesson::sag() const {
    if (!held()) return std::nullopt;
    const std::vector<Index> face = support == Support::top ? block_->layer(1, false) : block_->layer(0, true);
    Real sum = 0;
    for (const Index n : face) sum += block_->rest()(1, n) + drop_height - position_(1, n);
    return sum / Real(face.size());
}

// Free fall, until the lowest point meets the ground.
std::optional<Real> MassSpringLesson::falling_height(Real t) const {
    if (setting != Setting::drop || interfered_) return std::nullopt;
    const Real fallen = 0.5 * gravity * t * t;
    if (ground && fallen > drop_height) return std::nullopt;
    return start_height_ - fallen;
}

const SpringRates& MassSpringLesson::rates() const {
    const RatesKey key{{k_structural, k_shear, k_bending}, damping, total_mass, damping_mode};
    if (rates_key_ != key) {
        rates_ = spring_rate_estimates<3>(block_->springs(), block_->inertia(), damping_mode, block_->rest());
        rates_key_ = key;
    }
    return rates_;
}

Real MassSpringLesson::stable_time_step() const {
    SpringRates rates_now = rates();
    // The hand's spring acts on one node; what it adds to ω² is at most its own.
    if (pulled()) rates_now.omega = std::hypot(rates_now.omega, std::sqrt(pull_stiffness / block_->mass()[load_.pull.node]));
    return stability_limit(integrator, rates_now);
}

Real MassSpringLesson::growth_per_step() const {
    const Real omega = rates().omega;
    return omega > 0 ? amplification(integrator, omega, rates().damping / (2 * omega), dt) : 1;
}

std::string MassSpringLesson::too_large_a_step() const {
    const Real limit = stable_time_step();
    if (implicit() || !(dt > limit)) return "";
    const std::string growth = fmt::format("its fastest mode, ω = {}, grows by a factor {} per step",
                                           format_quantity(rates().omega, "rad/s", 3), format_quantity(growth_per_step(), "", 4));
    if (limit == 0)
        return fmt::format(
            "Explicit Euler without damping is stable at no Δt: {}. Switch damping_mode on, or choose another integrator",
            growth);
    return fmt::format(
        "Δt = {} is above the stability limit of {} ({}): {}. Lower time_step or the stiffness, or choose implicit_euler",
        format_quantity(dt, "s"), format_quantity(limit, "s", 3),
        integrator == Scheme::explicit_euler ? "explicit Euler, 2ζ/ω" : "semi-implicit Euler, (2/ω)(√(1 + ζ²) − ζ)", growth);
}

std::string MassSpringLesson::blow_up_hint() const {
    if (const std::string hint = too_large_a_step(); !hint.empty()) return hint;
    if (implicit()) return "Lower time_step, or allow more newton_iterations";
    return fmt::format(
        "Δt = {} is below the limit {} of small motions: the deformation is large. Lower time_step, or choose implicit_euler",
        format_quantity(dt, "s"), format_quantity(stable_time_step(), "s", 3));
}

// The integrator of second-order energy error, well inside its limit, in whole parts of the present step.
std::vector<std::pair<std::string, std::string>> MassSpringLesson::finer() const {
    const Real limit = stability_limit(Scheme::semi_implicit_euler, rates());
    const Real parts = std::ceil(std::max(Real{8}, 10 * dt / limit));
    return {{"integrator", "semi_implicit_euler"}, {"time_step", format_exact(dt / parts)}};
}

bool MassSpringLesson::at_rest() const {
    // Slow against a fall through one cell, with every force balanced by the ground or the support.
    const Real g = weight_acceleration(), cell = size / Real(Index(cells_x));
    if (velocity_.cwiseAbs().maxCoeff() > 1e-4 * std::sqrt(g * cell)) return false;
    Points<3> force = Points<3>::Zero(3, position_.cols());
    add_spring_forces<3>(block_->springs(), position_, force);
    add_external_forces<3>({{0, -g, 0}, load_.pull}, block_->mass(), position_, force);
    for (Index n = 0; n < force.cols(); ++n) {
        if (block_->inertia().fixed(3 * n)) continue;
        Vec<3> balance = force.col(n);
        if (grounded() && position_(1, n) <= 0 && balance[1] < 0) {
            const Real grip = -friction * balance[1], along = std::hypot(balance[0], balance[2]);
            balance *= along > 0 ? std::max(Real(0), 1 - grip / along) : 0;
            balance[1] = 0;
        }
        if (balance.norm() > 1e-2 * block_->mass()[n] * g) return false;
    }
    return true;
}

}  // namespace pliant::mass_spring
