// Which parameters would mend a run, and which make a finer one.
#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

// Part of a limit that small steps keep to, and of the limit of small motions where large ones have torn a block apart.
constexpr Real margin = 0.8, wide_margin = 0.4;
// Steps that are shorter than this part of the present ones would take too long.
constexpr Real slowest = 0.01;

Fix with_time_step(Real dt) {
    const Real rounded = rounded_down(dt, 2);
    return {fmt::format("Δt = {}", format_quantity(rounded, "s")), {{"time_step", format_exact(rounded)}}};
}

}  // namespace

// A shorter step, or where it would have to be very short another scheme.
std::optional<Fix> MassSpringLesson::stable_fix() const {
    const Real limit = stable_time_step(), other = stability_limit(Scheme::semi_implicit_euler, rates());
    if (limit > slowest * dt) return with_time_step(margin * limit);
    if (!semi_implicit() && other > slowest * dt) {
        Fix fix = with_time_step(std::min(margin * other, Real(dt)));
        fix.label = "semi-implicit Euler, " + fix.label;
        fix.assign.insert(fix.assign.begin(), {"integrator", "semi_implicit_euler"});
        return fix;
    }
    if (block_->rest().cols() <= most_implicit_nodes) return Fix{"implicit Euler", {{"integrator", "implicit_euler"}}};
    return limit > 0 ? std::optional(with_time_step(margin * limit)) : std::nullopt;
}

std::optional<Fix> MassSpringLesson::slower_travel() const {
    const Real speed = std::sqrt(velocity_.colwise().squaredNorm().maxCoeff()), cell = edge();
    return with_time_step(margin * cell / speed);
}

std::optional<Fix> MassSpringLesson::shear_springs() const {
    const Real k = k_structural > 0 ? rounded_down(0.5 * k_structural, 2) : k_shear.info.initial;
    return Fix{fmt::format("k_d = {}", format_quantity(k, "N/m")), {{"k_shear", format_exact(k)}}};
}

// The solid beside the net gets the ratio that the net has.
std::optional<Fix> MassSpringLesson::own_poisson() const {
    const Real own = lattice_constants(lattice(), stiffnesses(), edge()).poisson_ratio();
    if (!target_poisson.accepted().contains(own)) return std::nullopt;
    return Fix{fmt::format("ν* = {}", format_quantity(own, "", 3)), {{"target_poisson", format_exact(own)}}};
}

std::optional<Fix> MassSpringLesson::fix(const Failure&) const {
    if (tested()) return has_diagonals() ? shear_springs() : std::nullopt;
    if (!implicit() && dt > stable_time_step()) {
        const Real limit = stable_time_step();
        if (limit <= slowest * dt) return stable_fix();
        return with_time_step(wide_margin * limit);
    }
    // The small motions are stable: the block is far from its shape at rest.
    return with_time_step(dt / 4);
}

// The integrator of second-order energy error, well inside its limit, in whole parts of the present step.
std::vector<std::pair<std::string, std::string>> MassSpringLesson::finer() const {
    const Real limit = stability_limit(Scheme::semi_implicit_euler, rates());
    const Real parts = std::ceil(std::max(Real{8}, 10 * dt / limit));
    return {{"integrator", "semi_implicit_euler"}, {"time_step", format_exact(dt / parts)}};
}

}  // namespace pliant::mass_spring
