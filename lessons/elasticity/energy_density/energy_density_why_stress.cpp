// Why the stress, its check and the probes read what they read.
#include "energy_density.h"

#include <pliant/text/format.h>

#include "tensor_texts.h"

#include "elasticity/material/material_parameters.h"
#include "elasticity/tensors/tensor_why.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::energies {
namespace {

constexpr std::string_view gradient_field = "deformation_gradient";

Explanation same(std::string formula, Input input) {
    return {
        .formula = std::move(formula), .inputs = {std::move(input)}, .evaluate = [](std::span<const Real> x) { return x[0]; }};
}

}  // namespace

// Hooke's law on the strain of the energy: the stress itself when linear, before F or R turns it otherwise.
Input EnergyDensityLesson::strain_stress(int row, int column) const {
    const bool linear = is(Energy::linear);
    const std::string stress = linear ? "P" : "S", strain = linear ? "ε" : is(Energy::stvk) ? "E" : "e";
    const std::string left = why::entry(stress, row, column), own = why::entry(strain, row, column);
    if (row != column)
        return Input::part(left, "Pa",
                           {.formula = fmt::format("{} = 2 μ {}", left, own),
                            .inputs = {lame_mu(youngs_modulus, poisson_ratio), why::entry_now(strain, "strain", 0, row, column)},
                            .evaluate = [](std::span<const Real> x) { return 2 * x[0] * x[1]; }});
    Explanation e{.formula = fmt::format("{0} = 2 μ {2} + λ ({1}₁₁ + {1}₂₂ + {1}₃₃)", left, strain, own),
                  .inputs = {lame_mu(youngs_modulus, poisson_ratio), lame_lambda(youngs_modulus, poisson_ratio)},
                  .evaluate = [row](std::span<const Real> x) {
                      return 2 * x[0] * x[2 + static_cast<std::size_t>(row)] + x[1] * (x[2] + x[3] + x[4]);
                  }};
    for (int k = 0; k < 3; ++k) e.inputs.push_back(why::entry_now(strain, "strain", 0, k, k));
    return Input::part(left, "Pa", std::move(e));
}

// Cofactor over det F: an entry of the inverse, transposed.
Input EnergyDensityLesson::inverse_transposed(int row, int column) const {
    const int i = (row + 1) % 3, k = (row + 2) % 3, j = (column + 1) % 3, l = (column + 2) % 3;
    const auto F = [](int r, int c) { return why::entry_now("F", gradient_field, 0, r, c); };
    return Input::part("G", "",
                       {.formula = fmt::format("G = ({} {} − {} {}) / J", why::entry("F", i, j), why::entry("F", k, l),
                                               why::entry("F", i, l), why::entry("F", k, j)),
                        .inputs = {F(i, j), F(k, l), F(i, l), F(k, j), Input::now("J", "volume_ratio", 0)},
                        .evaluate = [](std::span<const Real> x) { return (x[0] * x[1] - x[2] * x[3]) / x[4]; }});
}

Explanation EnergyDensityLesson::why_stress(int row, int column) const {
    const std::string name = why::entry("P", row, column);
    switch (Energy(energy)) {
        case Energy::linear:
            return *strain_stress(row, column).why;
        case Energy::neo_hookean: {
            const std::string own = why::entry("F", row, column);
            return {.formula = fmt::format("{} = μ ({} − G) + λ lnJ G", name, own),
                    .inputs = {lame_mu(youngs_modulus, poisson_ratio), lame_lambda(youngs_modulus, poisson_ratio),
                               why::entry_now("F", gradient_field, 0, row, column), inverse_transposed(row, column),
                               Input::now("lnJ", "log_volume", 0)},
                    .evaluate = [](std::span<const Real> x) { return x[0] * (x[2] - x[3]) + x[1] * x[4] * x[3]; }};
        }
        case Energy::stvk:
        case Energy::corotated:
            break;
    }
    const bool turns = is(Energy::corotated);
    const std::string_view left = turns ? "R" : "F", field = turns ? std::string_view("rotation") : gradient_field;
    std::vector<std::pair<Input, Input>> terms;
    for (int k = 0; k < 3; ++k) terms.emplace_back(why::entry_now(left, field, 0, row, k), strain_stress(k, column));
    return weighted_sum(fmt::format("{0} = Σ {1}_{2}k S_k{3}", name, left, row + 1, column + 1), terms);
}

// Of ψ a little above and a little below in this entry.
Explanation EnergyDensityLesson::why_difference(int row, int column) const {
    const std::string name = why::entry("F", row, column);
    const auto shifted = [&](std::string_view symbol, Real sign) {
        Explanation e{.formula = fmt::format("{0} = ψ(F), {1} {2} h", symbol, name, sign > 0 ? "+" : "−"),
                      .inputs = {lame_mu(youngs_modulus, poisson_ratio), lame_lambda(youngs_modulus, poisson_ratio),
                                 Input::constant("h", difference_step(), "", "step of the difference")},
                      .evaluate = {}};
        for (Input& input : why::all_entries("F", gradient_field, 0)) e.inputs.push_back(std::move(input));
        e.evaluate = [kind = Energy(energy), sign, row, column](std::span<const Real> x) {
            Mat<3> F = why::matrix(x.subspan(3));
            F(row, column) += sign * x[2];
            return EnergyDensity<3>(kind, {.lambda = x[1], .mu = x[0]}).psi(F);
        };
        e.substitute = [name, sign](std::span<const Real> x) {
            return fmt::format("ψ({}), {} {} {}", matrix_text(x.subspan(3)), name, sign > 0 ? "+" : "−", as_factor(x[2]));
        };
        return Input::part(std::string(symbol), "J/m³", std::move(e));
    };
    return {
        .formula = fmt::format("{} = (ψ₊ − ψ₋) / (2 h)", why::entry("P", row, column)),
        .inputs = {shifted("ψ₊", 1), shifted("ψ₋", -1), Input::constant("h", difference_step(), "", "step of the difference")},
        .evaluate = [](std::span<const Real> x) { return (x[0] - x[1]) / (2 * x[2]); }};
}

void EnergyDensityLesson::explain_probes() {
    const auto give = [this](std::string_view name, std::function<Explanation()> why) {
        std::ranges::find(probes, name, &Probe::name)->explain = std::move(why);
    };
    give("psi", [] { return same("energy per volume = ψ", Input::now("ψ", "energy_density", 0)); });
    give("det_F", [] { return same("det F = J", Input::now("J", "volume_ratio", 0)); });
    give("lateral_stretch", [] { return same("a = F_22", why::entry_now("F", gradient_field, 0, 1, 1)); });
    for (int k = 0; k < 9; ++k)
        give(fmt::format("P{}{}", k / 3 + 1, k % 3 + 1), [k] {
            return same(fmt::format("force per area at rest = {}", why::entry("P", k / 3, k % 3)),
                        why::entry_now("P", "stress", 0, k / 3, k % 3));
        });
    give("stiffness", [this] {
        Explanation e{.formula = "dP/ds = ∂P/∂F : dF/ds",
                      .inputs = {lame_mu(youngs_modulus, poisson_ratio), lame_lambda(youngs_modulus, poisson_ratio)},
                      .evaluate = {}};
        for (Input& input : why::all_entries("F", gradient_field, 0)) e.inputs.push_back(std::move(input));
        e.evaluate = [kind = Energy(energy), along = way()](std::span<const Real> x) {
            return along.stiffness({kind, Lame{.lambda = x[1], .mu = x[0]}}, why::matrix(x.subspan(2)));
        };
        e.substitute = [](std::span<const Real> x) { return fmt::format("∂P/∂F : dF/ds at F = {}", matrix_text(x.subspan(2))); };
        return e;
    });
    give("derivative_check", [this] {
        Explanation e{.formula = "error = max |P − P_h| / max(|P|, μ/1000)",
                      .inputs = {lame_mu(youngs_modulus, poisson_ratio)},
                      .evaluate = {}};
        for (Input& input : why::all_entries("P", "stress", 0)) e.inputs.push_back(std::move(input));
        for (Input& input : why::all_entries("H", "difference_stress", 0)) e.inputs.push_back(std::move(input));
        const auto parts = [](std::span<const Real> x) {
            const Mat<3> P = why::matrix(x.subspan(1)), difference = why::matrix(x.subspan(10));
            return std::array{(P - difference).cwiseAbs().maxCoeff(), std::max(P.cwiseAbs().maxCoeff(), 1e-3 * x[0])};
        };
        e.evaluate = [parts](std::span<const Real> x) { return parts(x)[0] / parts(x)[1]; };
        e.substitute = [parts](std::span<const Real> x) {
            return fmt::format("{} / {}", as_factor(parts(x)[0]), as_factor(parts(x)[1]));
        };
        return e;
    });
}

}  // namespace pliant::energies
