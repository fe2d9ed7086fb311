// A chain that swings in one of its modes: its shape and frequency in closed form, and the frequency that is measured.
#include "mass_spring.h"

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

}  // namespace pliant::mass_spring
