// What the energies show: fields, probes, and where each energy holds.
#include "energy_density.h"

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
    const auto bounded = [](Field field, std::function<Real()> bound) {
        field.bound = std::move(bound);
        return field;
    };
    const auto tensor = [&](std::string_view name, std::string_view symbol, std::string_view unit, const Rows& rows,
                            std::string_view help, std::function<Real()> bound) {
        return bounded(tensor_field(name, symbol, unit, On::element, rows, help), std::move(bound));
    };
    const auto scalar = [&](std::string_view name, std::string_view symbol, std::string_view unit, const One& one,
                            std::string_view help, std::function<Real()> bound) {
        return bounded(scalar_field(name, symbol, unit, On::element, one, help), std::move(bound));
    };
    const auto nodal = [&](std::string_view name, std::string_view symbol, std::string_view unit, const Points<3>& rows,
                           std::string_view help, std::function<Real()> bound) {
        return bounded(vector_field(name, symbol, unit, On::node, rows, help), std::move(bound));
    };
    fields = {tensor("deformation_gradient", "F", "", F_, "∂x/∂X; its columns are the edges of the deformed cube", small),
              nodal("displacement", "u", "m", displacement_,
                    "of the eight corners of the cube, (F − I) X, and of the nodes of the block", small),
              nodal("newton_step", "d", "m", direction_,
                    "Newton's direction at each node of the block, before the line search shortens it", small),
              nodal("unbalanced_force", "r", "N", unbalanced_, "force that no other balances yet, at the free nodes of the block",
                    stress_bound),
              scalar("volume_ratio", "J", "", J_, "det F: volume now over volume at rest; below 0 inside out", small),
              tensor("strain", "ε, E, S − I", "", strain_, "the strain that this energy is made of", small),
              tensor("rotation", "R", "", rotation_, "the rotation nearest to F", small),
              scalar("first_invariant", "I₁", "", I1_, "tr FᵀF, the sum of the squared stretches", squared),
              scalar("log_volume", "ln J", "", ln_J_, "tends to −∞ where the cube becomes flat", small),
              scalar("energy_density", "ψ", "J/m³", psi_, "energy stored per volume at rest", stress_bound),
              tensor("stress", "P", "Pa", P_, "∂ψ/∂F, first Piola–Kirchhoff: column j is the force on the face across axis j",
                     stress_bound),
              tensor("difference_stress", "P_h", "Pa", difference_, "central difference of ψ", stress_bound)};
    const auto use = [this](std::string_view name, auto used) { std::ranges::find(fields, name, &Field::name)->used = used; };
    use("newton_step", [this] { return has_block(); });
    use("unbalanced_force", [this] { return has_block(); });
    use("strain", [this] { return !is(Energy::neo_hookean); });
    use("rotation", [this] { return is(Energy::corotated); });
    use("first_invariant", [this] { return is(Energy::neo_hookean); });
    use("log_volume", [this] { return is(Energy::neo_hookean); });
}

void EnergyDensityLesson::declare_probes() {
    probes = {{.name = "psi",
               .symbol = "ψ",
               .unit = "J/m³",
               .help = "energy per volume at rest",
               .value = [this] { return psi_[0]; },
               .exact = [this](Real) { return way().exact_psi(density(), amount()); }},
              {.name = "det_F", .symbol = "det F", .help = "volume now over volume at rest", .value = [this] { return J_[0]; }},
              {.name = "lateral_stretch",
               .symbol = "a",
               .help = "width now over width at rest",
               .value = [this]() -> std::optional<Real> {
                   if (!way().stretches()) return std::nullopt;
                   return F_(1, 1);
               }},
              {.name = "stiffness",
               .symbol = "dP/ds",
               .unit = "Pa",
               .help = "change of the stress with the stretch s or the shear γ; below 0 the material softens",
               .value = [this]() -> std::optional<Real> {
                   if (is(Path::free)) return std::nullopt;
                   return stiffness();
               }},
              {.name = "derivative_check",
               .symbol = "|P − P_h|/|P|",
               .help = "largest difference between P and the central difference of ψ: is P the derivative of ψ?",
               .value = [this] { return derivative_error(); }}};
    constexpr std::array<std::string_view, 9> names{"P11", "P12", "P13", "P21", "P22", "P23", "P31", "P32", "P33"},
        symbols{"P₁₁", "P₁₂", "P₁₃", "P₂₁", "P₂₂", "P₂₃", "P₃₁", "P₃₂", "P₃₃"};
    for (int k = 0; k < 9; ++k)
        probes.push_back({.name = names[static_cast<std::size_t>(k)],
                          .symbol = symbols[static_cast<std::size_t>(k)],
                          .unit = "Pa",
                          .help = "force along axis i on the face across axis j, per area at rest",
                          .value = [this, k] { return P_(k / 3, k % 3); }});
    declare_block_probes();
    const auto exact = [this](std::string_view name, bool in_shear) {
        std::ranges::find(probes, name, &Probe::name)->exact = [this, in_shear](Real) -> std::optional<Real> {
            if (is(Path::shear) != in_shear) return std::nullopt;
            return way().exact_stress(density(), amount());
        };
    };
    exact("P11", false), exact("P12", true);
}

// What the cube says is exact for a block whose ends slide, unless the material softens: then the block need not stay uniform.
void EnergyDensityLesson::declare_block_probes() {
    const auto known = [this] { return has_block() && Ends(ends) == Ends::sliding && stiffness() > 0 && J_[0] > 0; };
    const auto of_block = [this](auto reading) {
        return [this, reading]() -> std::optional<Real> {
            if (!has_block() || done_[1] == 0) return std::nullopt;
            return reading();
        };
    };
    // A block that gave up has not come to where it shall be: its pull says nothing.
    const auto of_whole_block = [=, this](auto reading) {
        return of_block([this, reading]() -> std::optional<Real> {
            return block_->failed() ? std::nullopt : std::optional<Real>(reading());
        });
    };
    const auto nodes = [this] { return Points<3>(displacement_.rightCols(block_->mesh().node_count())); };
    probes.push_back({.name = "block_stress",
                      .symbol = "F/A",
                      .unit = "Pa",
                      .help = "pull on the end of the block over its area at rest",
                      .value = of_whole_block([=, this] { return block_->stress(nodes()); }),
                      .exact = [=, this](Real) { return known() ? std::optional<Real>(P_(0, 0)) : std::nullopt; },
                      .explain = [this] { return why_block_stress(); }});
    probes.push_back({.name = "block_width",
                      .symbol = "w/w₀",
                      .help = "of the middle section of the block, over its width at rest",
                      .value = of_whole_block([=, this] { return block_->width(nodes()); }),
                      .exact = [=, this](Real) { return known() ? std::optional<Real>(F_(1, 1)) : std::nullopt; },
                      .explain = [this] { return why_block_width(); }});
    probes.push_back(
        {.name = "block_iterations", .symbol = "", .help = "of Newton's method, from rest", .value = of_block([this] {
                                                                                                return done_[2];
                                                                                            })});
    probes.push_back({.name = "block_residual",
                      .symbol = "|r|/|f|",
                      .help = "largest unbalanced force over the largest force in the block; 1 while its ends are not in place",
                      .value = of_block([this] { return done_[3]; })});
}

void EnergyDensityLesson::declare_checks() {
    assumptions = {
        {.name = "does not soften",
         .unit = "Pa",
         .value = [this] { return -stiffness(); },
         .limit = [] { return Real{0}; },
         .formula = "−dP/ds ≤ 0",
         .broken = "the more it is deformed the less it resists, so it collapses: St. Venant–Kirchhoff does so below the stretch "
                   "1/√3 = 0.577, where P = −Y/(3√3) = −0.192 Y at most",
         .used = [this] { return !is(Path::free); },
         .fix = [this]() -> std::optional<Fix> { return another_energy(Energy::neo_hookean); }},
        {.name = "not inside out",
         .unit = "",
         .value = [this] { return -J_[0]; },
         .limit = [] { return -1e-12; },
         .formula = "det F > 0",
         .broken =
             "the cube is flat or turned inside out, which no body can be; this energy stays finite and does not prevent it",
         .fix = [this]() -> std::optional<Fix> { return towards_rest(); }},
        {.name = "small displacement gradient",
         .unit = "",
         .value = [this] { return (F_ - Rows::Identity()).cwiseAbs().maxCoeff(); },
         .limit = [] { return small_gradient; },
         .formula = "|F − I| ≤ 0.05",
         .broken = "the linear energy takes a rotation for a strain, and leaves out ½ ∇uᵀ∇u",
         .used = [this] { return is(Energy::linear); },
         .fix = [this]() -> std::optional<Fix> { return another_energy(Energy::corotated); }},
        {.name = "block in equilibrium",
         .unit = "",
         .value = [this] { return done_[3]; },
         .limit = [] { return balanced; },
         .formula = "|r| ≤ 10⁻⁶ |f|",
         .broken =
             "Newton's method gave up: a softening or inverted material has several equilibria, or none that can be reached",
         .used = [this] { return has_block(); },
         .fix = [this]() -> std::optional<Fix> { return another_energy(Energy::neo_hookean); }}};
    conserved = {{.probe = "derivative_check", .law = Law::zero, .tolerance = [] { return derivative_tolerance; }}};
}

}  // namespace pliant::energies
