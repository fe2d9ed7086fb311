// Why F, the strain and the energy density are what they are.
#include "energy_density.h"

#include <pliant/continuum/deformation.h>
#include <pliant/continuum/uniaxial.h>

#include "tensor_texts.h"

#include "elasticity/material/material_parameters.h"
#include "elasticity/tensors/tensor_why.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::energies {

// --------------------------------------------------------------------------------------------------------- deformation

// At which nothing pulls across.
Input EnergyDensityLesson::width() const {
    Explanation e{.formula = "", .inputs = {Input::of(poisson_ratio), Input::of(stretch)}, .evaluate = {}};
    if (is(Energy::neo_hookean)) {
        e.formula = "a = root of μ (a² − 1) + λ ln(s a²)";
        e.inputs = {lame_mu(youngs_modulus, poisson_ratio), lame_lambda(youngs_modulus, poisson_ratio), Input::of(stretch)};
        e.evaluate = [](std::span<const Real> x) {
            return lateral_stretch({Energy::neo_hookean, Lame{.lambda = x[1], .mu = x[0]}}, x[2]).value_or(0);
        };
    } else if (is(Energy::stvk)) {
        if (F_(1, 1) == 0) return Input::part("a", "", fixed_value("a = 0: ν (s² − 1) ≥ 1, the cube has become a line", 0));
        e.formula = "a = √(1 − ν (s² − 1))";
        e.evaluate = [](std::span<const Real> x) { return std::sqrt(1 - x[0] * (x[1] * x[1] - 1)); };
    } else {
        e.formula = "a = 1 − ν (s − 1)";
        e.evaluate = [](std::span<const Real> x) { return 1 - x[0] * (x[1] - 1); };
    }
    return Input::part("a", "", std::move(e));
}

Explanation EnergyDensityLesson::why_F(int row, int column) const {
    const std::string name = why::entry("F", row, column);
    const auto same = [&](Input input) {
        const std::string symbol = input.symbol;
        return Explanation{.formula = fmt::format("{} = {}", name, symbol),
                           .inputs = {std::move(input)},
                           .evaluate = [](std::span<const Real> x) { return x[0]; }};
    };
    const bool diagonal = row == column;
    const Number* entries[3][3] = {{&F11, &F12, &F13}, {&F21, &F22, &F23}, {&F31, &F32, &F33}};
    if (is(Path::free)) return same(Input::of(*entries[row][column], "given"));
    if (is(Path::shear) && row == 0 && column == 1) return same(Input::of(shear));
    if (diagonal && (is(Path::volumetric) || (row == 0 && !is(Path::shear)))) return same(Input::of(stretch));
    if (diagonal && is(Path::uniaxial)) return same(width());
    return diagonal ? fixed_value(fmt::format("{} = 1: not stretched along this axis", name), 1)
                    : fixed_value(fmt::format("{} = 0: no shear here", name), 0);
}

std::optional<Explanation> EnergyDensityLesson::why_deformed(const Question& q) const {
    if (q.field == "deformation_gradient") return why_F(q.component / 3, q.component % 3);
    if (q.field == "volume_ratio")
        return Explanation{.formula = "J = F₁₁ (F₂₂ F₃₃ − F₂₃ F₃₂) − F₁₂ (F₂₁ F₃₃ − F₂₃ F₃₁) + F₁₃ (F₂₁ F₃₂ − F₂₂ F₃₁)",
                           .inputs = why::all_entries("F", "deformation_gradient", 0),
                           .evaluate = [](std::span<const Real> x) { return why::matrix(x).determinant(); }};
    if (q.field != "displacement" || q.index >= corners)
        return fixed_value("0: the block is at rest before the first iteration", 0);
    // A corner moves by the edges that lead to it.
    const Vec<3> X = cube_corner(q.index);
    std::vector<std::pair<Input, Input>> terms;
    for (int j = 0; j < 3; ++j)
        if (X[j] != 0)
            terms.emplace_back(why::entry_now("F", "deformation_gradient", 0, q.component, j),
                               Input::constant("X_j", X[j], "m", "place at rest"));
    terms.emplace_back(Input::constant("−1", -1, "", "less the place at rest"),
                       Input::constant("X_i", X[q.component], "m", "place at rest"));
    return weighted_sum("u = Σ F_ij X_j − X_i", terms);
}

// -------------------------------------------------------------------------------------------------------------- strain

Explanation EnergyDensityLesson::why_strain(const Question& q) const {
    const int i = q.component / 3, j = q.component % 3;
    const std::string_view F = "deformation_gradient";
    if (q.field == "log_volume") return {.formula = "ln J = ln(J)", .inputs = {Input::now("J", "volume_ratio", 0)}};
    if (q.field == "first_invariant")
        return {.formula = "I₁ = Σ F_ij²",
                .inputs = why::all_entries("F", F, 0),
                .evaluate = [](std::span<const Real> x) { return why::matrix(x).squaredNorm(); },
                .substitute = [](std::span<const Real> x) { return squares_text(x); }};
    if (q.field == "rotation")
        return {.formula = fmt::format("{} = of the rotation nearest to F", why::entry("R", i, j)),
                .inputs = why::all_entries("F", F, 0),
                .evaluate = [i, j](std::span<const Real> x) { return nearest_rotation<3>(why::matrix(x))(i, j); },
                .substitute = [](std::span<const Real> x) { return "nearest rotation to " + matrix_text(x); }};
    if (is(Energy::linear)) {
        if (i == j)
            return {.formula = fmt::format("{} = {} − 1", why::entry("ε", i, i), why::entry("F", i, i)),
                    .inputs = {why::entry_now("F", F, 0, i, i)},
                    .evaluate = [](std::span<const Real> x) { return x[0] - 1; }};
        return {.formula = fmt::format("{} = ½ ({} + {})", why::entry("ε", i, j), why::entry("F", i, j), why::entry("F", j, i)),
                .inputs = {why::entry_now("F", F, 0, i, j), why::entry_now("F", F, 0, j, i)},
                .evaluate = [](std::span<const Real> x) { return 0.5 * (x[0] + x[1]); }};
    }
    // Products of two columns: of F and F, or of R and F.
    const bool green = is(Energy::stvk);
    std::vector<std::pair<Input, Input>> terms;
    for (int k = 0; k < 3; ++k)
        terms.emplace_back(green ? why::entry_now("F", F, 0, k, i) : why::entry_now("R", "rotation", 0, k, i),
                           why::entry_now("F", F, 0, k, j));
    const Real delta = i == j ? 1 : 0, half = green ? 0.5 : 1;
    const std::string formula = green ? fmt::format("{} = ½ (Σ F_k{} F_k{} − {})", why::entry("E", i, j), i + 1, j + 1, delta)
                                      : fmt::format("(S − I)_{}{} = Σ R_k{} F_k{} − {}", i + 1, j + 1, i + 1, j + 1, delta);
    Explanation e = weighted_sum(formula, terms);
    e.evaluate = [delta, half, making = e.making](std::span<const Real> x) { return half * (sum_of_terms(making, x) - delta); };
    e.substitute = [delta, green](std::span<const Real> x) {
        return green ? fmt::format("½ ({} − {})", products_text(x), delta) : fmt::format("{} − {}", products_text(x), delta);
    };
    return e;
}

// -------------------------------------------------------------------------------------------------------------- energy

Explanation EnergyDensityLesson::why_psi() const {
    if (is(Energy::neo_hookean))
        return {.formula = "ψ = ½ μ (I₁ − 3) − μ lnJ + ½ λ lnJ²",
                .inputs = {lame_mu(youngs_modulus, poisson_ratio), lame_lambda(youngs_modulus, poisson_ratio),
                           Input::now("I₁", "first_invariant", 0), Input::now("lnJ", "log_volume", 0)}};
    const std::string strain = is(Energy::linear) ? "ε" : is(Energy::stvk) ? "E" : "e";
    Explanation e{.formula = fmt::format("ψ = μ {0}:{0} + ½ λ tr({0})²{1}", strain, is(Energy::corotated) ? ",  e = S − I" : ""),
                  .inputs = {lame_mu(youngs_modulus, poisson_ratio), lame_lambda(youngs_modulus, poisson_ratio)},
                  .evaluate = {}};
    for (Input& input : why::all_entries(strain, "strain", 0)) e.inputs.push_back(std::move(input));
    e.evaluate = [](std::span<const Real> x) {
        return hooke_energy_density<3>({.lambda = x[1], .mu = x[0]}, why::matrix(x.subspan(2)));
    };
    e.substitute = [](std::span<const Real> x) {
        const Mat<3> strain_now = why::matrix(x.subspan(2));
        return fmt::format("{} · {} + ½ · {} · {}²", as_factor(x[0]), as_factor(strain_now.squaredNorm()), as_factor(x[1]),
                           as_factor(strain_now.trace(), true));
    };
    return e;
}

}  // namespace pliant::energies
