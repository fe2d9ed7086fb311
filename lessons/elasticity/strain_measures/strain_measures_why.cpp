// Why every tensor, stretch and stress is what it is.
#include "kits/material/material_parameters.h"
#include "kits/tensors/tensor_why.h"
#include "strain_measures.h"

#include <pliant/continuum/deformation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::strain_measures {
namespace {

// v^T A v of the tensor, with the direction as the field has it now; before it stands what is added, "1 + ".
Explanation quadratic(std::string_view left, const char* name, std::string_view field, std::string_view before = "") {
    std::vector<Input> inputs = why::all_entries(name, field, 0);
    for (int i = 0; i < 3; ++i) inputs.push_back(Input::now(fmt::format("v_{}", axis_name(i)), "direction", 0, i));
    std::string sum;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sum += fmt::format("{}v_{} {} v_{}", i + j ? " + " : "", axis_name(i), why::entry(name, i, j), axis_name(j));
    return {fmt::format("{} = {}{}", left, before, sum), std::move(inputs)};
}

Explanation squared_length(std::string_view left, const char* symbol, std::string_view field) {
    Explanation e{fmt::format("{0} = {1}_x² + {1}_y² + {1}_z²", left, symbol), {}};
    for (int i = 0; i < 3; ++i) e.inputs.push_back(Input::now(fmt::format("{}_{}", symbol, axis_name(i)), field, 0, i));
    return e;
}

}  // namespace

// M: the gradient of the map alone.
Input StrainMeasuresLesson::map_entry(int i, int j) const {
    const std::string symbol = why::entry("M", i, j);
    const std::array<Input, 3> middle{Input::constant("X", 0, "m", "middle"), Input::constant("Y", 0, "m", "middle"),
                                      Input::constant("Z", 0, "m", "middle")};
    Explanation slope = controls.why_gradient(i, j, middle);
    const std::string name = slope.formula.substr(0, slope.formula.find(" ="));
    return Input::part(
        symbol, "",
        {fmt::format("{} = {}{}   (of the map)", symbol, i == j ? "1 + " : "", name), {Input::part(name, "", std::move(slope))}});
}

Explanation StrainMeasuresLesson::why_deformation(const Question& q) const {
    const int i = q.component / 3, j = q.component % 3;
    if (q.field == "right_cauchy_green")
        return why::transposed_product("C", "F", "deformation_gradient", "F", "deformation_gradient", 0, i, j);
    if (q.field == "green_strain") return why::green("displacement_gradient", 0, i, j);
    if (q.field == "displacement_gradient") {
        return {fmt::format("H_{0}{1} = F_{0}{1}{2}   (H = ∇u)", i + 1, j + 1, i == j ? " − 1" : ""),
                {why::entry_now("F", "deformation_gradient", 0, i, j)}};
    }
    if (q.field == "cauchy_strain") {
        const auto H = [](int r, int c) { return why::entry_now("H", "displacement_gradient", 0, r, c); };
        if (i == j) return {fmt::format("ε_{0}{0} = H_{0}{0}   (H = ∇u)", i + 1), {H(i, i)}};
        return {fmt::format("ε_{0}{1} = ½ (H_{0}{1} + H_{1}{0})   (H = ∇u)", i + 1, j + 1), {H(i, j), H(j, i)}};
    }
    const std::string F = why::entry("F", i, j);
    if (i == 2 || turn == 0) return {fmt::format("{} = {}", F, why::entry("M", i, j)), {map_entry(i, j)}};
    const std::vector<Input> inputs{why::in_radians("θ", turn), map_entry(0, j), map_entry(1, j)};
    if (i == 0) return {fmt::format("{} = cos(θ) {} − sin(θ) {}", F, why::entry("M", 0, j), why::entry("M", 1, j)), inputs};
    return {fmt::format("{} = sin(θ) {} + cos(θ) {}", F, why::entry("M", 0, j), why::entry("M", 1, j)), inputs};
}

// A direction of the circle.
std::vector<Input> StrainMeasuresLesson::sampled_inputs(Index k) const {
    const Vec<3> n = sampled(k);
    return {Input::constant("n_x", n[0], "", "of the direction on the circle"),
            Input::constant("n_y", n[1], "", "of the direction on the circle")};
}

Explanation StrainMeasuresLesson::why_stretch(const Question& q) const {
    const int i = q.component;
    if (q.field == "direction") {
        const Input azimuth = why::in_radians("ψ", v_angle), up = why::in_radians("η", v_elevation);
        if (i == 2) return {"v_z = sin(η)", {up}};
        return {i == 0 ? "v_x = cos(η) cos(ψ)" : "v_y = cos(η) sin(ψ)", {up, azimuth}};
    }
    if (q.field == "deformed_direction") {
        std::vector<Input> inputs;
        for (int j = 0; j < 3; ++j) {
            inputs.push_back(why::entry_now("F", "deformation_gradient", 0, i, j));
            inputs.push_back(Input::now(fmt::format("v_{}", axis_name(j)), "direction", 0, j));
        }
        return {fmt::format("v'_{0} = F_{1}1 v_x + F_{1}2 v_y + F_{1}3 v_z", axis_name(i), i + 1), std::move(inputs)};
    }
    std::vector<Input> inputs = sampled_inputs(q.index);
    if (q.field == "stretch") {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 2; ++c) inputs.push_back(why::entry_now("F", "deformation_gradient", 0, r, c));
        return {"|F n| = √((F_11 n_x + F_12 n_y)² + (F_21 n_x + F_22 n_y)² + (F_31 n_x + F_32 n_y)²)", std::move(inputs)};
    }
    for (const auto& [r, c] : {std::pair{0, 0}, {0, 1}, {1, 1}}) inputs.push_back(why::entry_now("ε", "cauchy_strain", 0, r, c));
    return {"1 + n·ε n = 1 + ε_11 n_x² + 2 ε_12 n_x n_y + ε_22 n_y²", std::move(inputs)};
}

// A row of the 6 × 6 matrix.
Explanation StrainMeasuresLesson::why_stress(const Question& q) const {
    const int i = q.component / 3, j = q.component % 3;
    const bool of_green = q.field == "stress_green";
    const char* const name = of_green ? "E" : "ε";
    const std::string_view field = of_green ? "green_strain" : "cauchy_strain";
    const Input mu = lame_mu(youngs_modulus, poisson_ratio);
    const std::string sigma = why::entry("σ", i, j);
    if (i != j) {
        const int row = std::min(i, j), column = std::max(i, j);
        return {fmt::format("{} = μ (2 {})   (2 {}: engineering shear)", sigma, why::entry(name, row, column),
                            why::entry(name, row, column)),
                {mu, why::entry_now(name, field, 0, row, column)}};
    }
    const Input lambda = lame_lambda(youngs_modulus, poisson_ratio);
    std::string right;
    for (int k = 0; k < 3; ++k)
        right += fmt::format("{}{} {}", k ? " + " : "", k == i ? "(λ + 2 μ)" : "λ", why::entry(name, k, k));
    return {fmt::format("{} = {}", sigma, right),
            {lambda, mu, why::entry_now(name, field, 0, 0, 0), why::entry_now(name, field, 0, 1, 1),
             why::entry_now(name, field, 0, 2, 2)}};
}

// -------------------------------------------------------------------------------------------------------------- probes

void StrainMeasuresLesson::explain_probes() {
    const auto squares = [](const char* symbol, std::string_view field) {
        return Input::part(fmt::format("|{}|²", symbol), "", squared_length(fmt::format("|{}|²", symbol), symbol, field));
    };
    const auto of_C = [] { return Input::part("vᵀCv", "", quadratic("vᵀCv", "C", "right_cauchy_green")); };
    explain_probe("stretch_of_v", [squares] {
        return Explanation{"|v′| = √(|v'|² / |v|²)", {squares("v'", "deformed_direction"), squares("v", "direction")}};
    });
    explain_probe("stretch_from_C", [of_C] { return Explanation{"√(vᵀC v) = √(vᵀCv)", {of_C()}}; });
    explain_probe("stretch_from_cauchy", [] { return quadratic("1 + vᵀε v", "ε", "cauchy_strain", "1 + "); });
    explain_probe("stretch_mismatch", [squares, of_C] {
        return Explanation{"|v′|² − vᵀC v = |v'|² − vᵀCv", {squares("v'", "deformed_direction"), of_C()}};
    });
    explain_probe("strain_difference", [] {
        std::vector<Input> inputs = family_of("ε_ij", why::all_entries("ε", "cauchy_strain", 0));
        for (Input& of_green : why::all_entries("E", "green_strain", 0)) inputs.push_back(of_green.in("E_ij"));
        return Explanation{"|ε − E| = √(Σ_ij (ε_ij − E_ij)²)", std::move(inputs)};
    });
}

}  // namespace pliant::strain_measures
