// The numbers to read off: stretches, operations, and every component of every tensor.
#include <fmt/format.h>
#include <pliant/continuum/deformation.h>

#include "strain_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::strain_measures {
namespace {}  // namespace

void StrainMeasuresLesson::declare_probes() {
    const auto count = [this](std::string_view name, std::string_view help, Index OperationCounts::*of) {
        return Probe{.name = name, .help = help, .value = [this, of] { return static_cast<Real>(operations_.*of); }};
    };
    probes = {
        {.name = "stretch_of_v",
         .symbol = "|v′|",
         .help = "measured on the deformed vector: length of v now over its length at rest",
         .value = [this] { return deformed_v_.norm() / v_.norm(); },
         .exact = [this](Real) -> std::optional<Real> {
             const auto C = exact_C();
             return C ? std::optional(std::sqrt(direction().dot(*C * direction()))) : std::nullopt;
         }},
        {.name = "stretch_from_C",
         .symbol = "√(vᵀC v)",
         .help = "the same from the right Cauchy–Green tensor",
         .value = [this] { return std::sqrt(std::max(Real{0}, v_.dot(of(C_) * v_))); }},
        {.name = "stretch_from_cauchy",
         .symbol = "1 + vᵀε v",
         .help = "the same from Cauchy's strain: right only for small displacements",
         .value = [this] { return 1 + v_.dot(of(cauchy_) * v_); }},
        {.name = "stretch_mismatch",
         .symbol = "|v′|² − vᵀC v",
         .help = "0 whatever the deformation",
         .value = [this] { return deformed_v_.squaredNorm() - v_.dot(of(C_) * v_); }},
        {.name = "volume_ratio",
         .symbol = "det F",
         .help = "volume now over volume at rest",
         .value = [this] { return pliant::volume_ratio<3>(of(deformation_)); },
         .exact = [this](Real) { return map_.volume_ratio(Vec<3>::Zero()); }},
        {.name = "strain_difference",
         .symbol = "|ε − E|",
         .help = "what Cauchy's strain leaves out or makes up (Frobenius norm)",
         .value = [this] { return (of(cauchy_) - of(green_)).norm(); }},
        count("operations_c", "additions and multiplications to evaluate C = FᵀF, counted", &OperationCounts::right_cauchy_green),
        count("operations_green", "the same for Green's strain", &OperationCounts::green),
        count("operations_cauchy", "the same for Cauchy's strain", &OperationCounts::cauchy)};
}

// One probe for each component: green_11, ..., cauchy_33, c_33, and of the stresses the six that differ.
void StrainMeasuresLesson::declare_components() {
    struct Names {
        std::array<std::string_view, 9> name, symbol;
    };
    static constexpr Names green{
        {"green_11", "green_12", "green_13", "green_21", "green_22", "green_23", "green_31", "green_32", "green_33"},
        {"E₁₁", "E₁₂", "E₁₃", "E₂₁", "E₂₂", "E₂₃", "E₃₁", "E₃₂", "E₃₃"}};
    static constexpr Names cauchy{
        {"cauchy_11", "cauchy_12", "cauchy_13", "cauchy_21", "cauchy_22", "cauchy_23", "cauchy_31", "cauchy_32", "cauchy_33"},
        {"ε₁₁", "ε₁₂", "ε₁₃", "ε₂₁", "ε₂₂", "ε₂₃", "ε₃₁", "ε₃₂", "ε₃₃"}};
    static constexpr Names C{{"c_11", "c_12", "c_13", "c_21", "c_22", "c_23", "c_31", "c_32", "c_33"},
                             {"C₁₁", "C₁₂", "C₁₃", "C₂₁", "C₂₂", "C₂₃", "C₃₁", "C₃₂", "C₃₃"}};
    static constexpr Names stress_green{{"stress_green_11", "stress_green_12", "stress_green_13", "", "stress_green_22",
                                         "stress_green_23", "", "", "stress_green_33"},
                                        {"σ₁₁", "σ₁₂", "σ₁₃", "", "σ₂₂", "σ₂₃", "", "", "σ₃₃"}};
    static constexpr Names stress_cauchy{{"stress_cauchy_11", "stress_cauchy_12", "stress_cauchy_13", "", "stress_cauchy_22",
                                          "stress_cauchy_23", "", "", "stress_cauchy_33"},
                                         stress_green.symbol};

    using Exact = std::function<std::optional<Mat<3>>()>;
    const auto add = [this](const Names& names, const Nine& tensor, std::string_view unit, std::string_view help,
                            std::string_view field, const Exact& exact) {
        for (std::size_t k = 0; k < 9; ++k) {
            if (names.name[k].empty()) continue;
            const auto at = static_cast<Index>(k);
            Probe probe{.name = names.name[k], .symbol = names.symbol[k], .unit = unit, .help = help, .value = [&tensor, at] {
                            return tensor[at];
                        }};
            if (exact)
                probe.exact = [exact, at](Real) -> std::optional<Real> {
                    const auto known = exact();
                    return known ? std::optional((*known)(at / 3, at % 3)) : std::nullopt;
                };
            probe.explain = [field, at, symbol = std::string(names.symbol[k])] {
                return Explanation{.formula = fmt::format("{0} = {0}'", symbol),
                                   .inputs = {Input::now(symbol + "'", field, 0, static_cast<int>(at))},
                                   .evaluate = [](std::span<const Real> x) { return x[0]; }};
            };
            probes.push_back(std::move(probe));
        }
    };
    add(green, green_, "", "of Green's strain E", "green_strain", [this]() -> std::optional<Mat<3>> {
        const auto known = exact_C();
        return known ? std::optional<Mat<3>>(0.5 * (*known - Mat<3>::Identity())) : std::nullopt;
    });
    // Known where the whole motion is a turn about z.
    add(cauchy, cauchy_, "", "of Cauchy's strain ε; of a rotation by θ about z: cos θ − 1", "cauchy_strain",
        [this]() -> std::optional<Mat<3>> {
            const bool turned = map_.kind == MapKind::rotation && map_.axis == 2;
            if (!turned && map_.kind != MapKind::translation) return std::nullopt;
            const Real half = (turn * one_degree + (turned ? map_.angle : 0)) / 2,
                       spurious = -2 * std::sin(half) * std::sin(half);
            return Mat<3>(Vec<3>(spurious, spurious, 0).asDiagonal());
        });
    add(C, C_, "", "of the right Cauchy–Green tensor C = FᵀF", "right_cauchy_green", [this] { return exact_C(); });
    add(stress_green, stress_green_, "Pa", "Hooke's law of Green's strain", "stress_green", {});
    add(stress_cauchy, stress_cauchy_, "Pa", "Hooke's law of Cauchy's strain", "stress_cauchy", {});
}

}  // namespace pliant::strain_measures
