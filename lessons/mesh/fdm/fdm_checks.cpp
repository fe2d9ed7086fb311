// Laws and assumptions, what a step may be, when the body is at rest, and what mends a run.
#include "fdm.h"

#include <pliant/continuum/deformation.h>
#include <pliant/math/small_eigen.h>
#include <pliant/text/format.h>
#include <pliant/time/stability.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::fdm {
namespace {

constexpr Real margin = 0.8;      // of a limit that a fix keeps to
constexpr Real slow_part = 2e-5;  // of what counts as fast, at rest

// By how much the energy of a sound run may exceed that of the start; beyond the limit of stability nothing is allowed but
// rounding.
Real energy_tolerance(const FdmLesson& l) {
    const bool sound = l.dt <= l.longest_step();
    const Real excess = sound ? energy_excess(l.scheme(), l.fastest() * l.dt, l.linear(), l.damped()) : 0;
    constexpr Real strain_rounding = 1e-12;
    const Real rounding = l.youngs_modulus * l.length * l.length * strain_rounding * strain_rounding;
    return (1e-9 + excess) * l.start_motion_ + rounding;
}

Fix other_form(const char* label, const char* form) { return {label, {{"form", form}}}; }

std::optional<Fix> shorter_step(const FdmLesson& l) {
    const Real limit = l.longest_step();
    if (limit > 0) return fix_by(l.dt, rounded_down(margin * limit, 2));
    Fix fix = fix_by(
        l.dt,
        rounded_down(std::min(margin * stability_limit(Scheme::velocity_verlet, l.fastest(), l.damping_ratio()), Real(l.dt)), 2));
    fix.label = "velocity Verlet, " + fix.label;
    fix.assign.insert(fix.assign.begin(), {"integrator", "velocity_verlet"});
    return fix;
}

std::string too_large_a_step(const FdmLesson& l) {
    const Real limit = l.longest_step();
    if (!l.moves() || !(l.dt > limit)) return "";
    const std::string growth = fmt::format(
        "the fastest motion of the grid, ω = {}, grows by a factor {} per step", format_quantity(l.fastest(), "rad/s", 3),
        format_quantity(amplification(l.scheme(), l.fastest(), l.damping_ratio(), l.dt), "", 4));
    const std::string_view name = info_of(l.scheme()).name;
    if (limit == 0)
        return fmt::format("{} without damping is stable at no Δt: {}. Choose velocity Verlet or semi-implicit Euler", name,
                           growth);
    return fmt::format("Δt = {} is above the stability limit of {} ({}, Δx = {}): {}. Lower the time step or the resolution",
                       format_quantity(l.dt, "s"), format_quantity(limit, "s", 3), name, format_quantity(l.spacing(), "m", 3),
                       growth);
}

std::optional<Fix> less_load(const FdmLesson& l, Real share) {
    if (l.is(GridShape::rod))
        return fix_by(l.start_strain, std::copysign(rounded_down(std::abs(share * l.start_strain), 1), l.start_strain));
    if (l.is(GridShape::manufactured)) return fix_by(l.amplitude, rounded_down(share * l.amplitude, 1));
    if (l.body_force.used() && l.body_force != 0)
        return fix_by(l.body_force, std::copysign(rounded_down(std::abs(share * l.body_force), 1), l.body_force));
    return std::nullopt;
}

}  // namespace

// ------------------------------------------------------------------------------------------------------------- stability

// Of the body at unit stiffness, mass and length, on a grid of at most so many cells: beyond them it is that of waves inside, or
// of its edges, whatever the resolution.
Real FdmLesson::fastest() const {
    constexpr Index enough = 16;
    const Index cells = std::min<Index>(resolution, enough);
    const Real nu = body().poisson_ratio;
    const Real over_inside = frequency_.of({setting, cells, nu}, [&] {
        const GridProblem unit({setting, Energy::linear, 1, nu, 1, 0, static_cast<int>(cells)});
        return unit.highest_frequency(1) * unit.grid().stable_time_step(1) / 2;
    });
    const Real inside = 2 / grid().stable_time_step(density);
    const Real omega = inside * (resolution > enough ? std::max(over_inside, Real{1}) : over_inside);
    if (!pulled()) return omega;
    return std::sqrt(omega * omega + pull_stiffness / (density * grid().volumes()[hand_.node]));
}

Real FdmLesson::damping_ratio() const { return damped() ? damping / (2 * fastest()) : Real{0}; }

Real FdmLesson::longest_step() const { return stability_limit(scheme(), fastest(), damping_ratio()); }

// Of a load on the stiffness, or of the strain at the start; large against both, and against the hand's reach.
Real FdmLesson::reach() const {
    const Real strain = is(GridShape::rod) ? std::abs(start_strain) : std::abs(body().body_force) * length / youngs_modulus;
    return length * (10 + 1000 * strain);
}

// What motion can come to: of the strain at the start, or of a fall to twice where the load balances.
Real FdmLesson::start_motion() const {
    const Real strain = std::abs(body().body_force) * length / pressure_wave_speed() / pressure_wave_speed() / density;
    return elastic_energy() + 2 * std::abs(body().body_force) * length * length * length * strain;
}

// -------------------------------------------------------------------------------------------------------------- at rest

Real FdmLesson::rest_speed() const {
    const Real c = pressure_wave_speed(),
               strain = is(GridShape::rod) ? std::abs(start_strain) : std::abs(body_force) * length / (density * c * c);
    return c * (slow_part * strain + 1e-14);
}

Real FdmLesson::rest_acceleration() const { return 5 * pressure_wave_speed() / length * rest_speed(); }

bool FdmLesson::at_rest() const {
    if (!moves()) return solved();
    if (velocity_.cwiseAbs().maxCoeff() > rest_speed()) return false;
    const VecX displaced = flat(displacement_), still = VecX::Zero(displaced.size());
    VecX force(displaced.size());
    system_->load.pull = hand_;
    system_->force(displaced, still, force);
    return inertia_.inverse().cwiseProduct(force).cwiseAbs().maxCoeff() <= rest_acceleration();
}

std::string FdmLesson::unrest() const {
    if (!moves() || at_rest() || damped()) return "";
    if (is(GridShape::rod)) return "nothing takes the energy out of the rod (scene = rod)";
    return "nothing takes the energy out of the block (damping = 0)";
}

// ---------------------------------------------------------------------------------------------------- laws and assumptions

Real FdmLesson::squeeze() const {
    Real least = 1;
    for (Index s = 0; s < metric_.cols(); ++s) {
        // Turned inside out, which G does not tell.
        if ((1 + gradient_(0, s)) * (1 + gradient_(3, s)) <= gradient_(1, s) * gradient_(2, s)) return 1;
        // The smaller eigenvalue of G is the square of the smallest stretch.
        const Real mean = 0.5 * (metric_(0, s) + metric_(3, s)), half = 0.5 * (metric_(0, s) - metric_(3, s));
        least = std::min(least, std::sqrt(std::max(mean - std::hypot(half, metric_(1, s)), Real{0})));
    }
    return 1 - least;
}

void FdmLesson::declare_checks() {
    const auto terms = [this] { return kinetic_energy() + elastic_energy() + std::abs(load_energy()); };
    conserved = {{.probe = "force_sum",
                  .law = Law::zero,
                  .tolerance = [this] { return force_rounding() * length * length; },
                  .cancels = [this] { return (force_.cwiseAbs() * grid().volumes()).sum(); }},
                 {.probe = "stencil_difference",
                  .law = Law::zero,
                  .tolerance = [this] { return force_rounding(); },
                  .expected = [this] { return linear(); }},
                 {.probe = "energy",
                  .law = Law::never_grows,
                  .tolerance = [this] { return energy_tolerance(*this); },
                  .expected = [this] { return moves() && !pulled(); },
                  .cancels = terms}};
    assumptions = {
        assumption_of(
            "stability", "s", [this] { return Real(dt); }, [this] { return longest_step(); },
            "Δt ≤ limit of the integrator for the fastest motion of the grid: Verlet and semi-implicit Euler Δx/√(c_p² + c_s²) "
            "for waves inside; edges of a body with ν above 0.3 are faster",
            "neighbouring nodes swing against each other, more in every step, until the run blows up")
            .otherwise("unstable")
            .when([this] { return moves() && std::isfinite(longest_step()); })
            .mended_by([this] { return shorter_step(*this); }),
        assumption_of(
            "small_strain", "", [this] { return largest_strain(); }, [] { return 0.1; }, "|ε| ≤ 10 %",
            "the equation of Navier and Lamé takes strains for small and turns for none: what is strained more is off by as much")
            .otherwise("large strain")
            .when([this] { return linear() && !is(GridShape::manufactured); })
            .mended_by([] { return other_form("metric tensors", "metric_tensor"); }),
        assumption_of(
            "squeezed", "", [this] { return squeeze(); }, [] { return 1 - 1 / std::sqrt(Real{3}); },
            "1 − stretch ≤ 1 − 1/√3 = 0.423",
            "squeezed to less than 1/√3 of its length, this form becomes softer the more it is pressed, and a cell collapses")
            .otherwise("squeezed too far")
            .when([this] { return !linear(); })
            .mended_by([this] { return less_load(*this, 0.5); }),
        assumption_of(
            "boundary_on_grid", "", [this] { return 1 / static_cast<Real>(Index(resolution)); }, [] { return 0.01; },
            "Δx/R ≤ 1 %",
            "the grid follows a curved boundary in stairs as high as a cell: the error falls only as Δx, not as Δx²")
            .otherwise("boundary in stairs")
            .when([this] { return is(GridShape::disc); })
            .mended_by(Fix{"n = 100", {{"resolution", "100"}}}),
    };
}

// ------------------------------------------------------------------------------------------------------------- what mends it

std::string FdmLesson::blow_up_hint() const {
    if (const std::string hint = too_large_a_step(*this); !hint.empty()) return hint;
    if (!moves())
        return linear() ? "The load carries the body beyond what numbers can hold: lower the force per volume"
                        : "Newton's method finds no equilibrium: cells are squeezed until they collapse. Lower the force per "
                          "volume, or "
                          "take the linear form";
    const std::string limit = std::isfinite(longest_step()) ? fmt::format(" is below the stability limit {} of small motions",
                                                                          format_quantity(longest_step(), "s", 3))
                                                            : "";
    return fmt::format("Δt = {}{}: the deformation is large. Lower the load or the time step", format_quantity(dt, "s"), limit);
}

std::optional<Fix> FdmLesson::fix(const Failure&) const {
    if (moves() && dt > longest_step()) return shorter_step(*this);
    if (const auto less = less_load(*this, 0.25)) return less;
    return linear() ? std::nullopt : std::optional(other_form("Navier–Lamé", "navier_lame"));
}

std::vector<std::pair<std::string, std::string>> FdmLesson::finer() const {
    constexpr Index finest = 128;
    if (resolution >= finest)
        return moves() ? std::vector{std::pair<std::string, std::string>("time_step", format_exact(dt / 2))}
                       : std::vector<std::pair<std::string, std::string>>{};
    std::vector<std::pair<std::string, std::string>> finer_run{
        {"resolution", std::to_string(std::min<Index>(2 * resolution, finest))}};
    if (moves()) finer_run.emplace_back("time_step", format_exact(dt / 2));
    return finer_run;
}

}  // namespace pliant::fdm
