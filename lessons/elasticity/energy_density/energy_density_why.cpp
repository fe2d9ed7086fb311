// Why F, the strain, the energy density, the stress and its check, and the probes are what they are.
#include "energy_density.h"
#include "kits/tensors/tensor_why.h"

#include <pliant/continuum/deformation.h>
#include <pliant/continuum/uniaxial.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::energies {
namespace {

constexpr std::string_view F_field = "deformation_gradient";

}  // namespace

// --------------------------------------------------------------------------------------------------------- deformation

// At which nothing pulls across.
Input EnergyDensityLesson::width() const {
    if (is(Energy::neo_hookean))
        return Input::part(
            "a", "",
            Explanation{"a = root(μ, λ, s), where μ (a² − 1) + λ ln(s a²) = 0", {mu(), lambda(), stretch}}.by(
                "root(μ, λ, s)", "", [](Values x) {
                    return lateral_stretch({Energy::neo_hookean, Lame{.lambda = x[1], .mu = x[0]}}, x[2]).value_or(0);
                }));
    if (!is(Energy::stvk)) return part("a = 1 − ν (s − 1)", {poisson_ratio, stretch});
    if (F_(1, 1) == 0) return Input::part("a", "", fixed_value("a = 0: ν (s² − 1) ≥ 1, the cube has become a line"));
    return part("a = √(1 − ν (s² − 1))", {poisson_ratio, stretch});
}

Explanation EnergyDensityLesson::why_F(int row, int column) const {
    const std::string name = why::entry("F", row, column);
    const auto same = [&](Input input) {
        const std::string symbol = input.symbol;
        return Explanation{fmt::format("{} = {}", name, symbol), {std::move(input)}};
    };
    const bool diagonal = row == column;
    if (is(Path::free)) return same(Input::of(entries(row, column), "given"));
    if (is(Path::shear) && row == 0 && column == 1) return same(shear);
    if (diagonal && (is(Path::volumetric) || (row == 0 && !is(Path::shear)))) return same(stretch);
    if (diagonal && is(Path::uniaxial)) return same(width());
    return diagonal ? fixed_value(fmt::format("{} = 1: not stretched along this axis", name))
                    : fixed_value(fmt::format("{} = 0: no shear here", name));
}

std::optional<Explanation> EnergyDensityLesson::why_deformed(const Question& q) const {
    if (q.field == F_field) return why_F(q.component / 3, q.component % 3);
    if (q.field == "volume_ratio") return why::determinant(F_field, 0, "J");
    if (q.field != "displacement" || q.index >= corners) return fixed_value("0: the block is at rest before the first iteration");
    // A corner moves by the edges that lead to it.
    const Vec<3> X = cube_corner(q.index);
    Explanation e{"u = Σ_j F_ij X_j − X_i", {Input::constant("X_i", X[q.component], "m", "place at rest")}};
    for (int j = 0; j < 3; ++j) {
        e.inputs.push_back(why::entry_now("F", F_field, 0, q.component, j).in("F_ij"));
        e.inputs.push_back(Input::constant(fmt::format("X_{}", axis_name(j)), X[j], "m", "place at rest").in("X_j"));
    }
    return e;
}

// -------------------------------------------------------------------------------------------------------------- strain

Explanation EnergyDensityLesson::why_strain(const Question& q) const {
    const int i = q.component / 3, j = q.component % 3;
    if (q.field == "log_volume") return {"ln J = ln(J)", {Input::now("J", "volume_ratio", 0)}};
    if (q.field == "first_invariant") {
        return {"I₁ = Σ_ij F_ij²", family_of("F_ij", why::all_entries("F", F_field, 0))};
    }
    if (q.field == "rotation")
        return why::of_matrix(why::entry("R", i, j), why::entry("rot", i, j), "an entry of the rotation nearest to F", "F",
                              F_field, 0, [i, j](const Mat<3>& F) { return nearest_rotation<3>(F)(i, j); });
    if (is(Energy::linear)) {
        if (i == j)
            return {fmt::format("{} = {} − 1", why::entry("ε", i, i), why::entry("F", i, i)),
                    {why::entry_now("F", F_field, 0, i, i)}};
        return {fmt::format("{} = ½ ({} + {})", why::entry("ε", i, j), why::entry("F", i, j), why::entry("F", j, i)),
                {why::entry_now("F", F_field, 0, i, j), why::entry_now("F", F_field, 0, j, i)}};
    }
    // Products of two columns: of F and F, or of R and F.
    const char* one = i == j ? " − 1" : "";
    Explanation product = is(Energy::stvk) ? why::transposed_product("E", "F", F_field, "F", F_field, 0, i, j)
                                           : why::transposed_product("S", "R", "rotation", "F", F_field, 0, i, j);
    const std::string sum = product.formula.substr(product.formula.find(" = ") + 3);
    if (is(Energy::stvk)) return {fmt::format("{} = ½ ({}{})", why::entry("E", i, j), sum, one), std::move(product.inputs)};
    return {fmt::format("(S − I)_{}{} = {}{}", i + 1, j + 1, sum, one), std::move(product.inputs)};
}

// -------------------------------------------------------------------------------------------------------------- energy

Explanation EnergyDensityLesson::why_psi() const {
    if (is(Energy::neo_hookean))
        return {"ψ = ½ μ (I₁ − 3) − μ lnJ + ½ λ lnJ²",
                {mu(), lambda(), Input::now("I₁", "first_invariant", 0), Input::now("lnJ", "log_volume", 0)}};
    const std::string strain = is(Energy::linear) ? "ε" : is(Energy::stvk) ? "E" : "e";
    Explanation e{fmt::format("ψ = μ Σ_ij {0}_ij² + ½ λ tr²{1}", strain, is(Energy::corotated) ? ", e = S − I" : ""),
                  {mu(), lambda()}};
    for (Input& input : why::all_entries(strain, "strain", 0)) e.inputs.push_back(input.in(strain + "_ij"));
    e.inputs.push_back(part(fmt::format("tr = {0}_11 + {0}_22 + {0}_33", strain),
                            {why::entry_now(strain, "strain", 0, 0, 0), why::entry_now(strain, "strain", 0, 1, 1),
                             why::entry_now(strain, "strain", 0, 2, 2)}));
    return e;
}

// ------------------------------------------------------------------------------------------------- stress and probes

// Hooke's law on the strain of the energy: the stress itself when linear, before F or R turns it otherwise.
Input EnergyDensityLesson::strain_stress(int row, int column) const {
    const bool linear = is(Energy::linear);
    const std::string stress = linear ? "P" : "S", strain = linear ? "ε" : is(Energy::stvk) ? "E" : "e";
    const std::string left = why::entry(stress, row, column), own = why::entry(strain, row, column);
    if (row != column)
        return Input::part(left, "Pa",
                           {fmt::format("{} = 2 μ {}", left, own), {mu(), why::entry_now(strain, "strain", 0, row, column)}});
    Explanation e{fmt::format("{0} = 2 μ {2} + λ ({1}_11 + {1}_22 + {1}_33)", left, strain, own), {mu(), lambda()}};
    for (int k = 0; k < 3; ++k) e.inputs.push_back(why::entry_now(strain, "strain", 0, k, k));
    return Input::part(left, "Pa", std::move(e));
}

// Cofactor over det F: an entry of the inverse, transposed.
Input EnergyDensityLesson::inverse_transposed(int row, int column) const {
    const int i = (row + 1) % 3, k = (row + 2) % 3, j = (column + 1) % 3, l = (column + 2) % 3;
    const auto F = [](int r, int c) { return why::entry_now("F", F_field, 0, r, c); };
    return Input::part("G", "",
                       {fmt::format("G = ({} {} − {} {}) / J", why::entry("F", i, j), why::entry("F", k, l),
                                    why::entry("F", i, l), why::entry("F", k, j)),
                        {F(i, j), F(k, l), F(i, l), F(k, j), Input::now("J", "volume_ratio", 0)}});
}

Explanation EnergyDensityLesson::why_stress(int row, int column) const {
    const std::string name = why::entry("P", row, column);
    switch (Energy(energy)) {
        case Energy::linear:
            return *strain_stress(row, column).why;
        case Energy::neo_hookean: {
            const std::string own = why::entry("F", row, column);
            return {fmt::format("{} = μ ({} − G) + λ lnJ G", name, own),
                    {mu(), lambda(), why::entry_now("F", F_field, 0, row, column), inverse_transposed(row, column),
                     Input::now("lnJ", "log_volume", 0)}};
        }
        case Energy::stvk:
        case Energy::corotated:
            break;
    }
    const bool turns = is(Energy::corotated);
    const std::string_view left = turns ? "R" : "F", field = turns ? std::string_view("rotation") : F_field;
    std::vector<std::pair<Input, Input>> terms;
    for (int k = 0; k < 3; ++k) terms.emplace_back(why::entry_now(left, field, 0, row, k), strain_stress(k, column));
    const std::string along_row = fmt::format("{}_{}k", left, row + 1), along_column = fmt::format("S_k{}", column + 1);
    return weighted_sum(fmt::format("{} = Σ_k {} {}", name, along_row, along_column), along_row, along_column, terms);
}

// Of ψ a little above and a little below in this entry.
Explanation EnergyDensityLesson::why_difference(int row, int column) const {
    const std::string name = why::entry("F", row, column);
    const auto shifted = [&](std::string_view symbol, Real sign) {
        const char* minus = sign > 0 ? "" : "−";
        Explanation e{fmt::format("{0} = ψ(F, {1}h, μ, λ), with {2} moved by {1}h", symbol, minus, name),
                      {mu(), lambda(), Input::constant("h", difference_step(), "", "step of the difference")}};
        for (Input& input : why::whole("F", F_field, 0)) e.inputs.push_back(std::move(input));
        return Input::part(std::string(symbol), "J/m³",
                           std::move(e).by("ψ", "J/m³", [kind = Energy(energy), row, column](Values x) {
                               Mat<3> F = why::matrix(x);
                               F(row, column) += x[9];
                               return EnergyDensity<3>(kind, {.lambda = x[11], .mu = x[10]}).psi(F);
                           }));
    };
    return {fmt::format("{} = (ψ₊ − ψ₋) / (2 h)", why::entry("P", row, column)),
            {shifted("ψ₊", 1), shifted("ψ₋", -1), Input::constant("h", difference_step(), "", "step of the difference")}};
}

void EnergyDensityLesson::explain_probes() {
    explain_probe("stiffness", [this] {
        Explanation e{"dP/ds = slope(F, μ, λ), ∂P/∂F : dF/ds", {mu(), lambda()}};
        for (Input& input : why::whole("F", F_field, 0)) e.inputs.push_back(std::move(input));
        return std::move(e).by("slope", "Pa", [kind = Energy(energy), along = way()](Values x) {
            return along.stiffness({kind, Lame{.lambda = x[10], .mu = x[9]}}, why::matrix(x));
        });
    });
    explain_probe("derivative_check", [this] {
        Explanation e{"error = max_ij |P_ij − H_ij| / max(max_ij |P_ij|, μ / 1000)", {mu()}};
        for (Input& input : why::all_entries("P", "stress", 0)) e.inputs.push_back(input.in("P_ij"));
        for (Input& input : why::all_entries("H", "difference_stress", 0)) e.inputs.push_back(input.in("H_ij"));
        return e;
    });
}

}  // namespace pliant::energies
