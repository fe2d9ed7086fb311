// When the body lies still, and why it never does.
#include "mass_spring.h"

#include <pliant/time/stability.h>

#include <cmath>

namespace pliant::mass_spring {
namespace {

constexpr Real part = 1e-4;  // of what counts as fast

}  // namespace

// Slow against a fall through one cell; where nothing falls, against the motion that the start can come to.
Real MassSpringLesson::rest_speed() const {
    if (const Real g = weight_acceleration(); g > 0) return part * std::sqrt(g * edge());
    return part * std::sqrt(2 * start_motion_ / total_mass) + strain_rounding * rates().omega * edge();
}

// Force that a node at rest may be left with, N.
Real MassSpringLesson::rest_force(Index node) const {
    const Real m = block_->mass()[node], g = weight_acceleration();
    return g > 0 ? 1e-2 * m * g : 0.1 * m * rates().omega * rest_speed();
}

bool MassSpringLesson::at_rest() const {
    if (tested()) return test_done_ && tests_.knows(static_key());
    if (velocity_.cwiseAbs().maxCoeff() > rest_speed()) return false;
    Points<3> force = Points<3>::Zero(3, position_.cols());
    add_spring_forces<3>(block_->springs(), position_, force);
    add_external_forces<3>({{0, -weight_acceleration(), 0}, load_.pull}, block_->mass(), position_, force);
    for (Index n = 0; n < force.cols(); ++n) {
        if (block_->inertia().fixed(3 * n)) continue;
        Vec<3> balance = force.col(n);
        if (grounded() && position_(1, n) <= 0 && balance[1] < 0) {
            const Real grip = -friction * balance[1], along = std::hypot(balance[0], balance[2]);
            balance *= along > 0 ? std::max(Real(0), 1 - grip / along) : 0;
            balance[1] = 0;
        }
        if (balance.norm() > rest_force(n)) return false;
    }
    return true;
}

// Springs without stiffness have no dampers.
bool MassSpringLesson::has_dampers() const { return damped() && damping > 0 && block_->springs().size() > 0; }

std::string MassSpringLesson::unrest() const {
    if (tested() || at_rest()) return "";
    if (setting == Setting::drop && !ground && gravity > 0) return "nothing stops its fall (ground = off)";
    if (dissipates(integrator)) return "";
    if (setting == Setting::spin && spin_rate != 0 && !(has_dampers() && damping_mode == SpringDamping::naive))
        return "nothing stops its rotation: of the dampers only naive ones do (damping_mode)";
    if (has_dampers()) return "";
    const bool loose = block_->springs().size() == 0;
    if (loose && grounded() && restitution < 1) return "";
    if (loose) return "it bounces without end (restitution = 1)";
    return "nothing takes the energy of its springs out (damping_mode, damping)";
}

}  // namespace pliant::mass_spring
