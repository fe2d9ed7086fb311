// What the energies show: fields, probes, curves, where each energy holds, and what mends it where it does not.
#include "energy_density.h"

#include "kits/tensors/tensor_why.h"

#include <pliant/continuum/uniaxial.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::energies {
namespace {

// Beyond these a number has no physical meaning any more.
constexpr Real largest_deformation = 1e6, largest_stress_over_modulus = 1e15;
// Of displacement gradients, up to which the linear energy is worth something.
constexpr Real small_gradient = 0.05;
// Relative error of a central difference in double precision.
constexpr Real derivative_tolerance = 1e-6;
// Of the forces in the block.
constexpr Real balanced = 1e-6;

}  // namespace

void EnergyDensityLesson::declare_fields() {
    state = {state_array("done", "", done_)};  // each solve begins anew from the parameters
    const auto small = [] { return largest_deformation; };
    const auto squared = [] { return 3 * largest_deformation * largest_deformation; };
    const auto stress_bound = [this] {
        const Lame m = material();
        return largest_stress_over_modulus * (m.mu + std::abs(m.lambda));
    };
    const auto block = [this] { return has_block(); };
    const auto neo_hookean = [this] { return is(Energy::neo_hookean); };
    fields = {
        tensor_field("deformation_gradient", "F", "", On::element, F_, "∂x/∂X; its columns are the edges of the deformed cube")
            .stops_at(small),
        vector_field("displacement", "u", "m", On::node, displacement_,
                     "of the eight corners of the cube, (F − I) X, and of the nodes of the block")
            .stops_at(small),
        vector_field("newton_step", "d", "m", On::node, direction_,
                     "Newton's direction at each node of the block, before the line search shortens it")
            .stops_at(small)
            .when(block),
        vector_field("unbalanced_force", "r", "N", On::node, unbalanced_,
                     "force that no other balances yet, at the free nodes of the block")
            .stops_at(stress_bound)
            .when(block),
        scalar_field("volume_ratio", "J", "", On::element, J_, "det F: volume now over volume at rest; below 0 inside out")
            .stops_at(small),
        tensor_field("strain", "ε, E, S − I", "", On::element, strain_, "the strain that this energy is made of")
            .stops_at(small)
            .when([this] { return !is(Energy::neo_hookean); }),
        tensor_field("rotation", "R", "", On::element, rotation_, "the rotation nearest to F").stops_at(small).when([this] {
            return is(Energy::corotated);
        }),
        scalar_field("first_invariant", "I₁", "", On::element, I1_, "tr FᵀF, the sum of the squared stretches")
            .stops_at(squared)
            .when(neo_hookean),
        scalar_field("log_volume", "ln J", "", On::element, ln_J_, "tends to −∞ where the cube becomes flat")
            .of_both_signs()
            .stops_at(small)
            .when(neo_hookean),
        scalar_field("energy_density", "ψ", "J/m³", On::element, psi_, "energy stored per volume at rest").stops_at(stress_bound),
        tensor_field("stress", "P", "Pa", On::element, P_,
                     "∂ψ/∂F, first Piola–Kirchhoff: column j is the force on the face across axis j")
            .stops_at(stress_bound),
        tensor_field("difference_stress", "P_h", "Pa", On::element, difference_, "central difference of ψ")
            .stops_at(stress_bound)};
}

void EnergyDensityLesson::declare_probes() {
    probes = {probe_of("psi", "ψ", "J/m³", "energy per volume at rest")
                  .formula(*this, "energy per volume = ψ", {Input::now("ψ", "energy_density", 0)})
                  .exactly([this](Real) { return way().exact_psi(density(), amount()); }),
              probe_of("det_F", "det F", "", "volume now over volume at rest")
                  .formula(*this, "det F = J", {Input::now("J", "volume_ratio", 0)}),
              probe_of("lateral_stretch", "a", "", "width now over width at rest")
                  .formula(*this, "a = F_22", {why::entry_now("F", "deformation_gradient", 0, 1, 1)})
                  .when([this] { return way().stretches(); }),
              probe_of("stiffness", "dP/ds", "Pa",
                       "change of the stress with the stretch s or the shear γ; below 0 the material softens",
                       [this] { return stiffness(); })
                  .when([this] { return !is(Path::free); }),
              probe_of("derivative_check", "|P − P_h|/|P|", "",
                       "largest difference between P and the central difference of ψ: is P the derivative of ψ?",
                       [this] { return derivative_error(); })};
    constexpr std::array<std::string_view, 9> names{"P11", "P12", "P13", "P21", "P22", "P23", "P31", "P32", "P33"},
        symbols{"P₁₁", "P₁₂", "P₁₃", "P₂₁", "P₂₂", "P₂₃", "P₃₁", "P₃₂", "P₃₃"};
    for (int k = 0; k < 9; ++k) {
        probes.push_back(probe_of(names[static_cast<std::size_t>(k)], symbols[static_cast<std::size_t>(k)], "Pa",
                                  "force along axis i on the face across axis j, per area at rest")
                             .formula(*this, fmt::format("force per area at rest = {}", why::entry("P", k / 3, k % 3)),
                                      {why::entry_now("P", "stress", 0, k / 3, k % 3)}));
        if (k < 2)
            probes.back().exact = [this, in_shear = k == 1](Real) {
                return is(Path::shear) == in_shear ? way().exact_stress(density(), amount()) : std::nullopt;
            };
    }
    declare_block_probes();
}

// What the cube says is exact for a block whose ends slide, unless the material softens: then the block need not stay uniform.
void EnergyDensityLesson::declare_block_probes() {
    const auto known = [this] { return has_block() && Ends(ends) == Ends::sliding && stiffness() > 0 && J_[0] > 0; };
    const auto ended = [this] { return has_block() && done_[1] != 0; };
    // A block that gave up has not come to where it shall be: its pull says nothing.
    const auto whole = [=, this] { return ended() && !block_->failed(); };
    const auto nodes = [this] { return Points<3>(displacement_.rightCols(block_->mesh().node_count())); };
    probes.push_back(probe_of(
                         "block_stress", "F/A", "Pa", "pull on the end of the block over its area at rest",
                         [=, this] { return block_->stress(nodes()); }, [this] { return why_block_stress(); })
                         .when(whole)
                         .exactly([=, this](Real) { return known() ? std::optional<Real>(P_(0, 0)) : std::nullopt; }));
    probes.push_back(probe_of(
                         "block_width", "w/w₀", "", "of the middle section of the block, over its width at rest",
                         [=, this] { return block_->width(nodes()); }, [this] { return why_block_width(); })
                         .when(whole)
                         .exactly([=, this](Real) { return known() ? std::optional<Real>(F_(1, 1)) : std::nullopt; }));
    probes.push_back(
        probe_of("block_iterations", "", "", "of Newton's method, from rest", [this] { return done_[2]; }).when(ended));
    probes.push_back(probe_of("block_residual", "|r|/|f|", "",
                              "largest unbalanced force over the largest force in the block; 1 while its ends are not in place",
                              [this] { return done_[3]; })
                         .when(ended));
}

void EnergyDensityLesson::declare_checks() {
    assumptions = {
        assumption_of(
            "does not soften", "Pa", [this] { return -stiffness(); }, [] { return Real{0}; }, "−dP/ds ≤ 0",
            "the more it is deformed the less it resists, so it collapses: St. Venant–Kirchhoff does so below the stretch "
            "1/√3 = 0.577, where P = −Y/(3√3) = −0.192 Y at most")
            .otherwise("softens")
            .when([this] { return !is(Path::free); })
            .mended_by([this]() -> std::optional<Fix> { return another_energy(Energy::neo_hookean); }),
        assumption_of(
            "not inside out", "", [this] { return -J_[0]; }, [] { return -1e-12; }, "det F > 0",
            "the cube is flat or turned inside out, which no body can be; this energy stays finite and does not prevent it")
            .otherwise("inside out")
            .mended_by([this]() -> std::optional<Fix> { return towards_rest(); }),
        assumption_of(
            "small displacement gradient", "", [this] { return (F_ - Rows::Identity()).cwiseAbs().maxCoeff(); },
            [] { return small_gradient; }, "|F − I| ≤ 0.05",
            "the linear energy takes a rotation for a strain, and leaves out ½ ∇uᵀ∇u")
            .otherwise("large displacement gradient")
            .when([this] { return is(Energy::linear); })
            .mended_by([this]() -> std::optional<Fix> { return another_energy(Energy::corotated); }),
        assumption_of(
            "block in equilibrium", "", [this] { return done_[3]; }, [] { return balanced; }, "|r| ≤ 10⁻⁶ |f|",
            "Newton's method gave up: a softening or inverted material has several equilibria, or none that can be reached")
            .otherwise("block out of equilibrium")
            .when([this] { return has_block(); })
            .mended_by([this]() -> std::optional<Fix> { return another_energy(Energy::neo_hookean); })};
    conserved = {{.probe = "derivative_check", .law = Law::zero, .tolerance = [] { return derivative_tolerance; }}};
}

// The curves of energy and stress over the amount of deformation, of all four energies.

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
    Line line = line_of(psi ? "energy_curve" : "stress_curve", psi ? "J/m³" : "Pa", "stretch s, shear γ or share of F", "",
                        psi ? "ψ of the chosen energy as the cube is deformed, beside the other three"
                            : "P₁₁ over the stretch, P₁₂ over the shear, or dψ/dt on the way to F; the slope is the stiffness",
                        [this, what](Curve& c) { sample(what, energy, c); })
                    .measures(psi ? "energy density ψ" : "stress P");
    for (const Energy other : all_energies)
        line.others.push_back({names[static_cast<std::size_t>(other)], [this, what, other](Curve& c) {
                                   if (!is(other)) sample(what, other, c);
                               }});
    line.others.push_back({"the cube now", [this, what](Curve& c) { mark_now(what, c); }, true});
    if (!psi) line.others.push_back({"StVK softens below 1/√3", [this](Curve& c) { mark_softest(c); }, true});
    return line;
}

void EnergyDensityLesson::declare_lines() { lines = {curve_of(Shown::stress), curve_of(Shown::psi)}; }

// What would mend a deformation that an energy does not bear.

// Half of the way back to rest, or a stretch that every energy bears.
Fix EnergyDensityLesson::towards_rest() const {
    if (way().stretches()) return {"s = 0.8", {{"stretch", "0.8"}}};
    if (is(Path::shear)) return {"γ = 0.5", {{"shear", "0.5"}}};
    return entries.none();
}

// Neo-Hookean does not go to s <= 0: the stretch is then mended with it.
Fix EnergyDensityLesson::another_energy(Energy better) const {
    Fix fix = better == Energy::neo_hookean ? Fix{"neo-Hookean", {{"energy", "neo_hookean"}}}
                                            : Fix{"corotated", {{"energy", "corotated"}}};
    if (way().at(density(better), amount())) return fix;
    const Fix back = towards_rest();
    fix.label += fmt::format(", {}", back.label);
    fix.assign.insert(fix.assign.end(), back.assign.begin(), back.assign.end());
    return fix;
}

std::string EnergyDensityLesson::blow_up_hint() const {
    return fmt::format(
        "det F = {}: the neo-Hookean energy grows without bound as the cube becomes flat. Take a stretch nearer to 1",
        format_quantity(J_[0], ""));
}

}  // namespace pliant::energies
