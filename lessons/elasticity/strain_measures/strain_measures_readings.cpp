// What is shown of the measures: fields, every number to read off, curves, where each measure holds and what mends a run.
#include "strain_measures.h"

#include "kits/tensors/tensor_why.h"

#include <pliant/continuum/deformation.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::strain_measures {
namespace {

// No accepted parameters come near it.
constexpr Real largest_number = 1e12, largest_stress = 1e40;

}  // namespace

void StrainMeasuresLesson::declare_fields() {
    state = {state_array("done", "", done_)};  // each solve begins anew from the parameters
    const auto tensor = [](std::string_view name, std::string_view symbol, const Nine& t, std::string_view help,
                           std::string_view unit = "") { return tensor_field(name, symbol, unit, On::particle, t, help); };
    const auto vector = [](std::string_view name, std::string_view symbol, const Vec<3>& v, std::string_view help) {
        return vector_field(name, symbol, "", On::particle, v, help);
    };
    const auto around = [](std::string_view name, std::string_view symbol, const VecX& s, std::string_view help) {
        return scalar_field(name, symbol, "", On::edge, s, help);
    };
    fields = {
        around("stretch", "|F n|", stretch_, "length now over length at rest of each direction n of the circle"),
        around("cauchy_stretch", "1 + n·ε n", cauchy_stretch_, "what Cauchy's strain takes for it"),
        tensor("deformation_gradient", "F", deformation_, "of the map, followed by the turn"),
        tensor("displacement_gradient", "∇u", slope_, "F − I"),
        tensor("right_cauchy_green", "C", C_, "squared stretches: vᵀC v = |F v|²"),
        tensor("green_strain", "E", green_, "Green's strain: 0 exactly for rigid motions"),
        tensor("cauchy_strain", "ε", cauchy_, "Cauchy's small strain: linear in u"),
        vector("direction", "v", v_, "a unit vector at rest"),
        vector("deformed_direction", "v′", deformed_v_, "what F makes of it"),
        tensor("stress_green", "σ", stress_green_, "Hooke's law of Green's strain: the second Piola–Kirchhoff stress", "Pa"),
        tensor("stress_cauchy", "σ", stress_cauchy_, "Hooke's law of Cauchy's strain", "Pa")};
    for (Field& field : fields) field.bound = [stress = !field.unit.empty()] { return stress ? largest_stress : largest_number; };
}

void StrainMeasuresLesson::declare_lines() {
    // Of a stretch 1 + e along one direction: Green's e + e²/2, Cauchy's e.
    const auto error = [](Real e) {
        const Mat<3> H = Vec<3>(e, 0, 0).asDiagonal();
        const Mat<3> green = pliant::green_strain<3>(H), small = pliant::cauchy_strain<3>(H);
        return (small - green).norm() / green.norm();
    };
    lines = {
        line_of("strain_over_turn", "", "turn θ that follows the map", "°",
                "ε_xx of the deformation followed by a turn: cos θ − 1 without a map. Green's E_xx does not move; the dashed "
                "upright is "
                "the present turn",
                [this](Curve& curve) {
                    for (int angle = -180; angle <= 180; angle += 5) {
                        curve.position.push_back(angle);
                        curve.value.push_back(pliant::cauchy_strain<3>(slope_after(angle * one_degree))(0, 0));
                    }
                })
            .against("Green's E_xx, and now",
                     [this](Curve& curve) {
                         const Real now = std::remainder(Real(turn), 360), green = pliant::green_strain<3>(slope_after(0))(0, 0);
                         const Real small = pliant::cauchy_strain<3>(slope_after(now * one_degree))(0, 0);
                         curve.position = {-180, now, now, now, 180};
                         curve.value = {green, green, small, green, green};
                     })
            .measures("Cauchy's ε_xx"),
        line_of(
            "error_over_strain", "", "strain ε of a stretch along one line", "",
            "relative error |ε − E| / |E| of Cauchy's strain against Green's; it reaches 1 % at the corner of the dashed line",
            [error](Curve& curve) {
                for (int k = -16; k <= 0; ++k) {
                    curve.position.push_back(std::pow(10.0, k / 4.0));
                    curve.value.push_back(error(curve.position.back()));
                }
            })
            .against("1 %",
                     [](Curve& curve) {
                         // (e/2) / (1 + e/2) = tolerated
                         const Real reached = 2 * tolerated / (1 - tolerated);
                         curve.position = {1e-4, reached, reached};
                         curve.value = {tolerated, tolerated, 1e-5};
                     })
            .measures("relative error of ε")
            .on_log_axes()};
}

void StrainMeasuresLesson::declare_checks() {
    assumptions = {
        assumption_of(
            "small strain and small rotation", "", [this] { return (of(cauchy_) - of(green_)).norm(); },
            [this] { return tolerated * of(green_).norm() + 1e-12; }, "|ε − E| ≤ 0.01 |E|",
            "Cauchy's strain is off by more than 1 %: it takes a rotation for a strain and leaves out ½ ∇uᵀ∇u")
            .otherwise("large strain or rotation")
            .mended_by([this] { return smaller(); }),
        assumption_of(
            "not inside out", "", [this] { return -pliant::volume_ratio<3>(of(deformation_)); }, [] { return Real{0}; },
            "det F ≥ 0", "det F < 0 is a reflection: C and Green's strain cannot tell it from a deformation that is possible")
            .otherwise("inside out")
            .mended_by([this] { return not_inverted(); })};
    conserved = {{.probe = "stretch_mismatch", .law = Law::zero, .tolerance = [this] { return 1e-12 * (1 + of(C_).norm()); }}};
}

// The numbers to read off: stretches, operations, and every component of every tensor.

void StrainMeasuresLesson::declare_probes() {
    const auto count = [this](std::string_view name, std::string_view help, Index OperationCounts::*of) {
        return probe_of(name, "", "", help, [this, of] { return static_cast<Real>(operations_.*of); });
    };
    probes = {
        probe_of("stretch_of_v", "|v′|", "", "measured on the deformed vector: length of v now over its length at rest",
                 [this] { return deformed_v_.norm() / v_.norm(); })
            .exactly([this](Real) -> std::optional<Real> {
                const auto C = exact_C();
                return C ? std::optional(std::sqrt(direction().dot(*C * direction()))) : std::nullopt;
            }),
        probe_of("stretch_from_C", "√(vᵀC v)", "", "the same from the right Cauchy–Green tensor",
                 [this] { return std::sqrt(std::max(Real{0}, v_.dot(of(C_) * v_))); }),
        probe_of("stretch_from_cauchy", "1 + vᵀε v", "", "the same from Cauchy's strain: right only for small displacements",
                 [this] { return 1 + v_.dot(of(cauchy_) * v_); }),
        probe_of("stretch_mismatch", "|v′|² − vᵀC v", "", "0 whatever the deformation",
                 [this] { return deformed_v_.squaredNorm() - v_.dot(of(C_) * v_); }),
        probe_of("volume_ratio", "det F", "", "volume now over volume at rest")
            .formula(*this, why::determinant("deformation_gradient", 0))
            .exactly([this](Real) { return map_.volume_ratio(Vec<3>::Zero()); }),
        probe_of("strain_difference", "|ε − E|", "", "what Cauchy's strain leaves out or makes up (Frobenius norm)",
                 [this] { return (of(cauchy_) - of(green_)).norm(); }),
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
    const auto add = [this](const Names& names, std::string_view unit, std::string_view help, std::string_view field,
                            const Exact& exact) {
        for (std::size_t k = 0; k < 9; ++k) {
            if (names.name[k].empty()) continue;
            const auto at = static_cast<Index>(k);
            const std::string symbol(names.symbol[k]);
            Probe probe = probe_of(names.name[k], names.symbol[k], unit, help)
                              .formula(*this, fmt::format("{0} = {0}'", symbol),
                                       {Input::now(symbol + "'", field, 0, static_cast<int>(at))});
            if (exact)
                probe.exact = [exact, at](Real) -> std::optional<Real> {
                    const auto known = exact();
                    return known ? std::optional((*known)(at / 3, at % 3)) : std::nullopt;
                };
            probes.push_back(std::move(probe));
        }
    };
    add(green, "", "of Green's strain E", "green_strain", [this]() -> std::optional<Mat<3>> {
        const auto known = exact_C();
        return known ? std::optional<Mat<3>>(0.5 * (*known - Mat<3>::Identity())) : std::nullopt;
    });
    // Known where the whole motion is a turn about z.
    add(cauchy, "", "of Cauchy's strain ε; of a rotation by θ about z: cos θ − 1", "cauchy_strain",
        [this]() -> std::optional<Mat<3>> {
            const bool turned = map_.kind == MapKind::rotation && map_.axis == 2;
            if (!turned && map_.kind != MapKind::translation) return std::nullopt;
            const Real half = (turn * one_degree + (turned ? map_.angle : 0)) / 2,
                       spurious = -2 * std::sin(half) * std::sin(half);
            return Mat<3>(Vec<3>(spurious, spurious, 0).asDiagonal());
        });
    add(C, "", "of the right Cauchy–Green tensor C = FᵀF", "right_cauchy_green", [this] { return exact_C(); });
    add(stress_green, "Pa", "Hooke's law of Green's strain", "stress_green", {});
    add(stress_cauchy, "Pa", "Hooke's law of Cauchy's strain", "stress_cauchy", {});
}

// Which parameters would mend what the lights show.

// First without the turn; then so much less of the map that the error, which is proportional to it, falls below the limit.
std::optional<Fix> StrainMeasuresLesson::smaller() const {
    if (turn != 0) return Fix{"θ = 0", {{"turn", "0"}}};
    const Real off = (of(cauchy_) - of(green_)).norm();
    const Real share = rounded_down(0.8 * tolerated * of(green_).norm() / off, 2);
    const auto less = [share](Real rest, Real value) { return format_exact(rest + share * (value - rest)); };
    switch (map_.kind) {
        case MapKind::rotation:
            return Fix{"α = 0", {{"angle", "0"}}};
        case MapKind::shear:
            return Fix{fmt::format("γ = {}", less(0, map_.shear)), {{"shear", less(0, map_.shear)}}};
        case MapKind::stretch:
            return Fix{fmt::format("strain × {}", format_quantity(share, "")),
                       {{"stretch_x", less(1, map_.stretches[0])},
                        {"stretch_y", less(1, map_.stretches[1])},
                        {"stretch_z", less(1, map_.stretches[2])}}};
        case MapKind::free: {
            // What is left of a large rotation is not small: only the symmetric part of F is kept.
            Fix fix{fmt::format("∇u × {}", format_quantity(share, "")), {}};
            const Mat<3> kept = 0.5 * (map_.gradient + map_.gradient.transpose());
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) fix.assign.emplace_back(controls.entries()(i, j).info.key, less(i == j, kept(i, j)));
            return fix;
        }
        default:
            return std::nullopt;
    }
}

std::optional<Fix> StrainMeasuresLesson::not_inverted() const {
    if (map_.kind == MapKind::stretch) {
        const Vec<3> s = map_.stretches.cwiseAbs();
        return Fix{"stretches > 0",
                   {{"stretch_x", format_exact(s[0])}, {"stretch_y", format_exact(s[1])}, {"stretch_z", format_exact(s[2])}}};
    }
    if (map_.kind != MapKind::free) return std::nullopt;
    // The mirror image.
    Fix fix{"first row of F × −1", {}};
    for (int j = 0; j < 3; ++j) fix.assign.emplace_back(controls.entries()(0, j).info.key, format_exact(-map_.gradient(0, j)));
    return fix;
}

std::string StrainMeasuresLesson::blow_up_hint() const {
    return "Every measure is a formula in F and cannot blow up by itself: take parameters nearer to their defaults";
}

}  // namespace pliant::strain_measures
