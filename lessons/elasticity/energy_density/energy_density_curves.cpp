// The curves of energy and stress over the amount of deformation, of all four energies.
#include "energy_density.h"

#include <pliant/continuum/uniaxial.h>

#include <algorithm>
#include <cmath>

namespace pliant::energies {
namespace {

constexpr int samples = 81;
constexpr std::array all_energies{Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean};
constexpr std::array<std::string_view, 4> names{"linear", "StVK", "corotated", "neo-Hookean"};

}  // namespace

// From turned inside out to twice the length, a shear to both sides, or from rest beyond the given F.
std::array<Real, 2> EnergyDensityLesson::plotted_amounts() const {
    const Real now = amount();
    if (is(Path::free)) return {0, 1.25};
    if (is(Path::shear)) return {std::min<Real>(-1.5, now), std::max<Real>(1.5, now)};
    return {std::min<Real>(-0.3, now), std::max<Real>(2, now)};
}

Real EnergyDensityLesson::shown_value(Shown what, const EnergyDensity<3>& of, const Mat<3>& F) const {
    return what == Shown::psi ? of.psi(F) : way().stress(of.P(F));
}

// Neo-Hookean grows without bound: it is shown as far as half as much again as the linear energy, or as the cube now.
Real EnergyDensityLesson::largest_shown(Shown what) const {
    const auto [from, to] = plotted_amounts();
    Real largest = 0;
    for (const Real end : {from, to})
        if (const auto F = way().at(density(Energy::linear), end))
            largest = std::max(largest, std::abs(shown_value(what, density(Energy::linear), *F)));
    const auto now = way().at(density(), amount());
    return 1.5 * std::max(largest, now ? std::abs(shown_value(what, density(), *now)) : Real{0});
}

void EnergyDensityLesson::sample(Shown what, Energy of, Curve& curve) const {
    curve.position.clear(), curve.value.clear();
    const auto [from, to] = plotted_amounts();
    const Real limit = largest_shown(what);
    const EnergyDensity<3> energy_of = density(of);
    for (int k = 0; k < samples; ++k) {
        const Real at = from + (to - from) * k / (samples - 1);
        const auto F = way().at(energy_of, at);
        if (!F) continue;
        const Real value = shown_value(what, energy_of, *F);
        if (!(std::abs(value) <= limit)) continue;
        curve.position.push_back(at);
        curve.value.push_back(value);
    }
}

void EnergyDensityLesson::mark_now(Shown what, Curve& curve) const {
    const auto F = way().at(density(), amount());
    if (!F) return;
    curve.position = {amount()};
    curve.value = {shown_value(what, density(), *F)};
}

// Where the stress of St. Venant-Kirchhoff is least: s (s^2 - 1) / 2 has its minimum at 1/sqrt(3).
void EnergyDensityLesson::mark_softest(Curve& curve) const {
    if (!way().stretches()) return;
    curve.position = {1 / std::sqrt(Real{3})};
    curve.value = {-way().modulus(material()) / (3 * std::sqrt(Real{3}))};
}

Line EnergyDensityLesson::curve_of(Shown what) const {
    const bool psi = what == Shown::psi;
    Line line{.name = psi ? "energy_curve" : "stress_curve",
              .unit = psi ? "J/m³" : "Pa",
              .position_name = "stretch s, shear γ or share of F",
              .help = psi ? "ψ of the chosen energy as the cube is deformed, beside the other three"
                          : "P₁₁ over the stretch, P₁₂ over the shear, or dψ/dt on the way to F; the slope is the stiffness",
              .sample = [this, what](Curve& c) { sample(what, energy, c); },
              .value_name = psi ? "energy density ψ" : "stress P"};
    for (const Energy other : all_energies)
        line.others.push_back({.name = names[static_cast<std::size_t>(other)], .sample = [this, what, other](Curve& c) {
                                   if (!is(other)) sample(what, other, c);
                               }});
    line.others.push_back({.name = "the cube now", .sample = [this, what](Curve& c) { mark_now(what, c); }, .points = true});
    if (!psi)
        line.others.push_back(
            {.name = "StVK softens below 1/√3", .sample = [this](Curve& c) { mark_softest(c); }, .points = true});
    return line;
}

void EnergyDensityLesson::declare_lines() { lines = {curve_of(Shown::stress), curve_of(Shown::psi)}; }

}  // namespace pliant::energies
