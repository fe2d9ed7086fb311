// What the measures of strain show: tensors, stretches around the circle, curves over turn and strain, and where Cauchy's strain
// will do.
#include <fmt/format.h>
#include <pliant/continuum/deformation.h>
#include <pliant/text/format.h>

#include "strain_measures.h"

#include <cmath>
#include <numbers>

namespace pliant::strain_measures {
namespace {

// No accepted parameters come near it.
constexpr Real largest_number = 1e12, largest_stress = 1e40;

}  // namespace

void StrainMeasuresLesson::declare_fields() {
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

void StrainMeasuresLesson::declare_state() {
    state = {state_array("done", "", done_)};  // each solve begins anew from the parameters
}

void StrainMeasuresLesson::declare_lines() {
    // Of a stretch 1 + e along one direction: Green's e + e²/2, Cauchy's e.
    const auto error = [](Real e) {
        const Mat<3> H = Vec<3>(e, 0, 0).asDiagonal();
        const Mat<3> green = pliant::green_strain<3>(H), small = pliant::cauchy_strain<3>(H);
        return (small - green).norm() / green.norm();
    };
    lines = {
        {.name = "strain_over_turn",
         .position_name = "turn θ that follows the map",
         .position_unit = "°",
         .help = "ε_xx of the deformation followed by a turn: cos θ − 1 without a map. Green's E_xx does not move; the dashed "
                 "upright is "
                 "the present turn",
         .sample =
             [this](Curve& curve) {
                 curve.position.clear(), curve.value.clear();
                 for (int angle = -180; angle <= 180; angle += 5) {
                     curve.position.push_back(angle);
                     curve.value.push_back(pliant::cauchy_strain<3>(slope_after(angle * one_degree))(0, 0));
                 }
             },
         .reference =
             [this](Curve& curve) {
                 const Real now = std::remainder(Real(turn), 360), green = pliant::green_strain<3>(slope_after(0))(0, 0);
                 const Real small = pliant::cauchy_strain<3>(slope_after(now * one_degree))(0, 0);
                 curve.position = {-180, now, now, now, 180};
                 curve.value = {green, green, small, green, green};
             },
         .reference_name = "Green's E_xx, and now",
         .value_name = "Cauchy's ε_xx"},
        {.name = "error_over_strain",
         .position_name = "strain ε of a stretch along one line",
         .help =
             "relative error |ε − E| / |E| of Cauchy's strain against Green's; it reaches 1 % at the corner of the dashed line",
         .sample =
             [error](Curve& curve) {
                 curve.position.clear(), curve.value.clear();
                 for (int k = -16; k <= 0; ++k) {
                     curve.position.push_back(std::pow(10.0, k / 4.0));
                     curve.value.push_back(error(curve.position.back()));
                 }
             },
         .reference =
             [](Curve& curve) {
                 // (e/2) / (1 + e/2) = tolerated
                 const Real reached = 2 * tolerated / (1 - tolerated);
                 curve.position = {1e-4, reached, reached};
                 curve.value = {tolerated, tolerated, 1e-5};
             },
         .reference_name = "1 %",
         .value_name = "relative error of ε",
         .log_log = true}};
}

void StrainMeasuresLesson::declare_checks() {
    assumptions = {
        {.name = "small strain and small rotation",
         .value = [this] { return (of(cauchy_) - of(green_)).norm(); },
         .limit = [this] { return tolerated * of(green_).norm() + 1e-12; },
         .formula = "|ε − E| ≤ 0.01 |E|",
         .broken = "Cauchy's strain is off by more than 1 %: it takes a rotation for a strain and leaves out ½ ∇uᵀ∇u",
         .fix = [this] { return smaller(); }},
        {.name = "not inside out",
         .value = [this] { return -pliant::volume_ratio<3>(of(deformation_)); },
         .limit = [] { return Real{0}; },
         .formula = "det F ≥ 0",
         .broken = "det F < 0 is a reflection: C and Green's strain cannot tell it from a deformation that is possible",
         .fix = [this] { return not_inverted(); }}};
    conserved = {{.probe = "stretch_mismatch", .law = Law::zero, .tolerance = [this] { return 1e-12 * (1 + of(C_).norm()); }}};
}

}  // namespace pliant::strain_measures
