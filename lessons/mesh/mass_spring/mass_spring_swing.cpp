// A chain that swings in one of its modes: its shape and frequency in closed form, and the frequency that is measured.
#include "mass_spring.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::mass_spring {

using std::numbers::pi;

Index MassSpringLesson::free_masses() const { return support == Support::both ? cells_y - 1 : cells_y; }

// Angle from one mass of mode j to the next [BornHuang1954 §5]: pi j/(N + 1) between two supports, pi (2j - 1)/(2N + 1) below
// one.
Real MassSpringLesson::mode_shape(Index node) const {
    const Real masses = Real(free_masses()), j = Real(Index(mode_number)), from_top = Real(cells_y - node);
    return std::sin(from_top * pi * (support == Support::both ? j / (masses + 1) : (2 * j - 1) / (2 * masses + 1)));
}

Real MassSpringLesson::mode_frequency() const {
    const Real masses = Real(free_masses()), j = Real(Index(mode_number));
    const Real angle = pi * (support == Support::both ? j / (masses + 1) : (2 * j - 1) / (2 * masses + 1));
    return 2 * std::sqrt(k_structural / block_->mass()[0]) * std::sin(angle / 2);
}

// Part of the mode in the displacement now, in lengths of its start.
Real MassSpringLesson::mode_displacement() const {
    Real product = 0, norm = 0;
    for (Index n = 0; n < position_.cols(); ++n) {
        product += mode_shape(n) * (position_(1, n) - block_->rest()(1, n));
        norm += mode_shape(n) * mode_shape(n);
    }
    return norm > 0 ? product / (norm * swing_amplitude * edge()) : 0;
}

void MassSpringLesson::note_swing() {
    if (setting == Setting::swing) rhythm_.note(clock_[0], mode_displacement(), 1e-3);
}

std::optional<Real> MassSpringLesson::measured_frequency() const {
    if (setting != Setting::swing) return std::nullopt;
    const std::optional<Real> period = rhythm_.period();
    return period ? std::optional(2 * pi / *period) : std::nullopt;
}

Explanation MassSpringLesson::why_frequency() const {
    const Real period = rhythm_.period().value_or(0);
    return {.formula = "ω = 2π / T",
            .inputs = {Input::constant("T", period, "s",
                                       "mean time from one passage upwards to the next, of the latest four at most")},
            .evaluate = [](std::span<const Real> x) { return 2 * pi / x[0]; }};
}

// What naive damping leaves of the angular momentum of a rigid body that turns about the vertical: exp(-lambda t), with
// lambda = k_d sum of the squared distances between the ends of the springs, seen from above, over the moment of inertia.
std::optional<Real> MassSpringLesson::rotation_after(Real t) const {
    const Points<3>& rest = block_->rest();
    const auto level = [](const Vec<3>& r) { return r[0] * r[0] + r[2] * r[2]; };
    Real spread = 0, inertia = 0;
    const Vec<3> centre = rest.rowwise().mean();
    for (Index s = 0; s < block_->springs().size(); ++s)
        spread += level(rest.col(block_->springs().j(s)) - rest.col(block_->springs().i(s)));
    for (Index n = 0; n < rest.cols(); ++n) inertia += block_->mass()[n] * level(rest.col(n) - centre);
    return start_angular_momentum_ * std::exp(inertia > 0 ? -damping * spread / inertia * t : 0);
}

void MassSpringLesson::declare_lines() {
    const auto to_now = [this](Curve& curve, const std::function<Real(Real)>& value) {
        const Real end = std::max(clock_[0], Real{1});
        for (int n = 0; n <= 60; ++n) {
            const Real t = end * n / 60;
            curve.position.push_back(t);
            curve.value.push_back(value(t));
        }
    };
    const auto spins = [this] { return setting == Setting::spin && start_angular_momentum_ > 0; };
    lines = {
        {.name = "rotation",
         .unit = "kg m²/s",
         .position_name = "t",
         .position_unit = "s",
         .help = "angular momentum of a rigid body that turns: what naive dampers leave, what projected ones do, and this run",
         .sample = [this, to_now](Curve& c) { to_now(c, [this](Real t) { return *rotation_after(t); }); },
         .reference = [this, to_now](Curve& c) { to_now(c, [this](Real) { return start_angular_momentum_; }); },
         .reference_name = "projected dampers",
         .value_name = "naive dampers",
         .used = spins,
         .others = {{.name = "now",
                     .sample =
                         [this](Curve& c) {
                             c.position.push_back(clock_[0]);
                             c.value.push_back(*probe("angular_momentum").value());
                         },
                     .points = true}}},
        {.name = "mode",
         .unit = "m",
         .position_name = "mass",
         .help = "displacement of each mass of a swinging chain, from the top, and where it began",
         .sample =
             [this](Curve& c) {
                 for (Index n = position_.cols() - 1; n >= 0; --n) {
                     c.position.push_back(Real(cells_y - n));
                     c.value.push_back(position_(1, n) - block_->rest()(1, n));
                 }
             },
         .reference =
             [this](Curve& c) {
                 for (Index n = position_.cols() - 1; n >= 0; --n) {
                     c.position.push_back(Real(cells_y - n));
                     c.value.push_back(swing_amplitude * edge() * mode_shape(n));
                 }
             },
         .reference_name = "start",
         .value_name = "displacement",
         .used = [this] { return setting == Setting::swing; }}};
}

}  // namespace pliant::mass_spring
