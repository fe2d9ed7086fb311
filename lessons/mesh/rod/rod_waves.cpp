// What swings and runs along the rod: its closed forms, and what is measured of them.
#include "rod.h"

#include <pliant/solids/point_masses.h>
#include <pliant/time/exact_motion.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::rod {

using std::numbers::pi;

namespace {
constexpr Real most_turns = 1e6;  // beyond, the place of a pulse is rounding
}

// ----------------------------------------------------------------------------------------------------------- closed forms

// Of the continuum, along the rod.
std::optional<Real> RodLesson::exact_displacement(Real s, Real t) const {
    const UniformRod rod = continuum();
    if (hangs_still()) return rod.hanging_displacement(s, gravity);
    if (setting == Setting::wave) {
        const Real omega = rod.frequency(watched_mode(), end());
        return amplitude * std::sin(rod.wave_number(watched_mode(), end()) * s) * swing(omega, t);
    }
    if (end() == RodEnd::fixed && s == length) return 0;
    if (damped()) return std::nullopt;
    if (setting == Setting::released) return rod.released_displacement(s, t, gravity);
    return pulse(rod.wave_speed()).displacement(s, t);
}

std::optional<Real> RodLesson::exact_strain(Real s, Real t) const {
    const UniformRod rod = continuum();
    if (hangs_still()) return rod.hanging_strain(s, gravity);
    if (setting == Setting::wave) {
        const Real omega = rod.frequency(watched_mode(), end()), kappa = rod.wave_number(watched_mode(), end());
        return amplitude * kappa * std::cos(kappa * s) * swing(omega, t);
    }
    if (damped() || setting == Setting::released) return std::nullopt;
    return pulse(rod.wave_speed()).strain(s, t);
}

// ---------------------------------------------------------------------------------------------------------------- probes

// sin i θ_j of the watched mode, of every node.
VecX RodLesson::mode_shape() const {
    const Real phase = chain().phase(watched_mode(), end());
    return VecX::NullaryExpr(count() + 1, [phase](Index i) { return std::sin(phase * static_cast<Real>(i)); });
}

Real RodLesson::mode_amplitude() const {
    const VecX shape = mode_shape();
    return shape.dot(position_.transpose() * along() - VecX::LinSpaced(count() + 1, 0, length)) / shape.squaredNorm();
}

// Where its energy lies on average.
Real RodLesson::pulse_position() const {
    Points<2> slope(2, count());
    VecX strain(count());
    rod_slopes(segment(), position_, slope);
    rod_strains(slope, strain);
    Real energy = 0, moment = 0;
    for (Index i = 0; i < segments; ++i) {
        const Real elastic = 0.5 * chain_axial_stiffness() * segment() * strain[i] * strain[i];
        const Real moving = 0.5 * node_mass() * velocity_.col(i + 1).squaredNorm();
        energy += elastic + moving;
        moment += elastic * (rest_place(i) + 0.5 * segment()) + moving * rest_place(i + 1);
    }
    return energy > 0 ? moment / energy : Real{0};
}

// The way of a pulse of this speed from s = 0 on, as if it were never turned back; nothing while it is at an end.
std::optional<Real> RodLesson::way(Real speed, Real t) const {
    const Real gone = start_position_ + speed * t, clear = 1.8 * pulse_width;
    const Real turns = std::floor(gone / length), inside = gone - turns * length;
    if (!(turns < most_turns)) return std::nullopt;
    if (inside > length - clear || (turns > 0 && inside < clear)) return std::nullopt;
    return gone;
}

// How often the pulse has been turned back.
std::optional<Index> RodLesson::turns() const {
    const auto gone = way(chain_speed(), clock_[elapsed]);
    return gone ? std::optional(static_cast<Index>(std::floor(*gone / length))) : std::nullopt;
}

std::optional<Real> RodLesson::wave_speed() const {
    const Real t = clock_[elapsed];
    if (!runs_a_pulse() || t == 0 || damped() || !swings() || !turns()) return std::nullopt;
    const Real n = static_cast<Real>(*turns());
    const Real gone = *turns() % 2 == 0 ? n * length + pulse_position() : (n + 1) * length - pulse_position();
    return (gone - start_position_) / t;
}

void RodLesson::declare_wave_probes() {
    const auto of_mode = [this](auto value) {
        return [this, value] { return setting != Setting::wave ? std::nullopt : std::optional<Real>(value()); };
    };
    probes.insert(
        probes.end(),
        {probe_of("mode_amplitude", "q", "m",
                  "Σ φᵢuᵢ/Σ φᵢ² of the mode that swings, φᵢ = sin iθ; exact: of the chain, A cos ωt, damped by τ",
                  of_mode([this] { return mode_amplitude(); }))
             .exactly([this](Real t) -> std::optional<Real> {
                 if (setting != Setting::wave) return std::nullopt;
                 const Real omega = chain().frequency(watched_mode(), end());
                 return amplitude * swing(omega, t);
             }),
         probe_of("frequency", "ω", "rad/s",
                  "measured from one rise of q through 0 to the next; exact: 2√(k/m) sin((2j − 1)π/(2(2N + 1))), of the chain",
                  [this]() -> std::optional<Real> {
                      const auto period = rhythm_.period();
                      if (setting != Setting::wave || !period) return std::nullopt;
                      return 2 * pi / *period;
                  })
             .exactly([this](Real) {
                 return setting != Setting::wave || damped() ? std::nullopt
                                                             : std::optional<Real>(chain().frequency(watched_mode(), end()));
             }),
         probe_of("frequency_chain", "ω_j", "rad/s",
                  "number j of the frequencies of the chain, found as eigenvalues of its matrices; exact: "
                  "2√(k/m) sin((2j − 1)π/(2(2N + 1)))",
                  of_mode([this] { return frequencies()[watched_mode() - 1]; }))
             .exactly([this](Real) {
                 return setting != Setting::wave ? std::nullopt : std::optional<Real>(chain().frequency(watched_mode(), end()));
             }),
         probe_of("frequency_continuum", "ω_c", "rad/s", "(2j − 1)πc/(2L) of the rod, c = √(EA L/M)",
                  of_mode([this] { return continuum().frequency(watched_mode(), end()); })),
         probe_of("pulse_position", "s_p", "m", "where the energy of the pulse lies on average",
                  [this] { return !runs_a_pulse() || !swings() ? std::nullopt : std::optional<Real>(pulse_position()); })
             .exactly([this](Real t) -> std::optional<Real> {
                 const auto gone = runs_a_pulse() && !damped() ? way(continuum().wave_speed(), t) : std::nullopt;
                 if (!gone) return std::nullopt;
                 const Real there_and_back = std::fmod(*gone, 2 * length);
                 return std::min(there_and_back, 2 * length - there_and_back);
             }),
         probe_of("wave_speed", "c", "m/s",
                  "of the energy of the pulse since the start, but for when an end turns it back; exact: √(EA L/M)",
                  [this] { return wave_speed(); })
             .exactly([this](Real) { return runs_a_pulse() ? std::optional<Real>(continuum().wave_speed()) : std::nullopt; })});
}

// ----------------------------------------------------------------------------------------------------------------- lines

void RodLesson::declare_lines() {
    const auto against_segments = [this](Rule rule) {
        return [this, rule](Curve& curve) {
            for (Real n = 1; n <= 200; n = std::max(n + 1, std::floor(1.25 * n)))
                curve.add(n, static_tip(rule, static_cast<Index>(n)));
        };
    };
    lines = {line_of("tip_against_segments", "m", "segments N", "",
                     "displacement of the tip at rest, solved for rods of every N: derived springs come ever closer to the rod, "
                     "springs picked by hand go ever further",
                     [this](Curve& curve) {
                         curve = {{static_cast<Real>(count())}, {tip_displacement()}};
                     })
                 .against("continuum: MgL/(2EA)",
                          [this](Curve& curve) {
                              const Real tip = continuum().hanging_tip(weight_acceleration());
                              curve = {{1, 200}, {tip, tip}};
                          })
                 .beside({{"derived", against_segments(Rule::derived)}, {"picked by hand", against_segments(Rule::constant)}})
                 .measures("tip displacement")
                 .on_log_axes()
                 .when([this] { return hangs(); }),
             line_of("displacement_profile", "m", "s", "m", "along the rod, of the nodes, with the continuum's where it is known",
                     [this](Curve& curve) {
                         for (Index i = 0; i <= segments; ++i) curve.add(rest_place(i), displacement_of(i));
                     })
                 .against("continuum", [this](Curve& curve) { sample_exact(curve, &RodLesson::exact_displacement); })
                 .measures("u"),
             line_of("strain_profile", "", "s", "m", "in the middle of each segment, with the continuum's where it is known",
                     [this](Curve& curve) {
                         for (Index i = 0; i < segments; ++i) curve.add(rest_place(i) + 0.5 * segment(), strain_[i]);
                     })
                 .against("continuum", [this](Curve& curve) { sample_exact(curve, &RodLesson::exact_strain); })
                 .measures("ε")};
}

void RodLesson::sample_exact(Curve& curve, std::optional<Real> (RodLesson::*exact)(Real, Real) const) const {
    constexpr int points = 161;
    if (unsolved()) return;
    for (int k = 0; k < points; ++k) {
        const Real s = length * k / (points - 1);
        const auto value = (this->*exact)(s, clock_[elapsed]);
        if (!value) return;
        curve.add(s, *value);
    }
}

void RodLesson::declare_wave_lines() {
    const auto of_modes = [this](auto frequency) {
        return [this, frequency](Curve& curve) {
            for (Index j = 1; j <= chain().modes(end()); ++j) curve.add(static_cast<Real>(j), frequency(j));
        };
    };
    lines.push_back(line_of("frequencies", "rad/s", "mode j", "",
                            "of all modes along the chain, from its matrices, and of the rod: a chain swings too slowly, most of "
                            "all in its short waves",
                            of_modes([this](Index j) { return frequencies()[j - 1]; }))
                        .against("continuum", of_modes([this](Index j) { return continuum().frequency(j, end()); }))
                        .beside({{"2√(k/m) sin(θ/2)", of_modes([this](Index j) { return chain().frequency(j, end()); }), true}})
                        .measures("ω")
                        .when([this] { return !hangs_still(); }));
}

}  // namespace pliant::rod
