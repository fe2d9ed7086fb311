#include "strain_measures.h"

#include "elasticity/material/material_parameters.h"

#include <cmath>
#include <numbers>

namespace pliant::strain_measures {
namespace {

constexpr Index samples = 72;  // directions around the circle, 5° apart

}  // namespace

StrainMeasuresLesson::StrainMeasuresLesson()
    : controls(*this, MapControls::Offer::homogeneous, MapKind::free, Vec<3>::Zero()),
      turn(*this, {.key = "turn",
                   .symbol = "θ",
                   .unit = "°",
                   .help = "rotation about z that follows the map; no strain should see it",
                   .initial = 0,
                   .useful = {-180, 180},
                   .accepted = Interval{-3600, 3600},
                   .effect = Effect::rebuild}),
      v_angle(*this, {.key = "v_angle",
                      .symbol = "ψ",
                      .unit = "°",
                      .help = "of the direction v in the plane of the picture, from x; drag the head of v",
                      .initial = 30,
                      .useful = {-180, 180},
                      .accepted = Interval{-3600, 3600},
                      .effect = Effect::rebuild}),
      v_elevation(*this, {.key = "v_elevation",
                          .symbol = "η",
                          .unit = "°",
                          .help = "of the direction v out of that plane, towards you",
                          .initial = 0,
                          .useful = {-90, 90},
                          .accepted = Interval{-90, 90},
                          .effect = Effect::rebuild}),
      youngs_modulus(*this, youngs_modulus_info("stress per strain in tension; rubber 1 MPa, steel 200 GPa", {1e3, 1e12})),
      poisson_ratio(*this, poisson_ratio_info("narrowing over lengthening", {-0.5, 0.49})),
      operations_(count_operations()) {
    controls.add_entries(*this);
    declare_fields();
    declare_state();
    declare_stages();
    declare_probes();
    declare_components();
    explain_probes();
    declare_lines();
    declare_checks();
}

Mat<3> StrainMeasuresLesson::slope_after(Real angle) const {
    const Mat<3> H = map_.displacement_gradient(Vec<3>::Zero());
    if (angle == 0) return H;
    const DeformationMap turning{.kind = MapKind::rotation, .angle = angle};
    return turning.displacement_gradient(Vec<3>::Zero()) * (Mat<3>::Identity() + H) + H;
}

Vec<3> StrainMeasuresLesson::direction() const {
    const Real a = v_angle * one_degree, e = v_elevation * one_degree;
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

Vec<3> StrainMeasuresLesson::sampled(Index k) const {
    const Real angle = 2 * std::numbers::pi * static_cast<Real>(k) / static_cast<Real>(samples);
    return {std::cos(angle), std::sin(angle), 0};
}

std::optional<Mat<3>> StrainMeasuresLesson::exact_C() const { return map_.right_cauchy_green(Vec<3>::Zero()); }

// Nothing is deformed yet.
void StrainMeasuresLesson::reset() {
    map_ = controls.map();
    for (Nine* tensor : {&deformation_, &C_}) *tensor = Mat<3>::Identity().reshaped();
    for (Nine* tensor : {&slope_, &green_, &cauchy_, &stress_green_, &stress_cauchy_}) tensor->setZero();
    v_ = deformed_v_ = direction();
    stretch_ = cauchy_stretch_ = VecX::Ones(samples);
    done_.setZero();
}

// ------------------------------------------------------------------------------------------------------------ stages

void StrainMeasuresLesson::declare_stages() {
    const auto write = [](Nine& tensor, const Mat<3>& m) { Eigen::Map<RowMajor>(tensor.data()) = m; };
    stages = {{.name = "deformation",
               .formula = "F = R(θ) F of the map,  ∇u = F − I",
               .source = "lecture: material deformation gradient tensor",
               .run = [this] { deform(); },
               .reads = {},
               .writes = {"deformation_gradient", "displacement_gradient"},
               .explain = [this](const Question& q) { return why_deformation(q); }},
              {.name = "right_cauchy_green",
               .formula = "C = FᵀF",
               .source = "second deck: Cauchy–Green strain tensor [Bonet2008 §4.5]",
               .run = [this, write] { write(C_, pliant::right_cauchy_green<3>(of(deformation_))); },
               .reads = {"deformation_gradient"},
               .writes = {"right_cauchy_green"},
               .explain = [this](const Question& q) { return why_deformation(q); }},
              {.name = "green_strain",
               .formula = "E = ½ (∇u + ∇uᵀ + ∇uᵀ∇u) = ½ (C − I)",
               .source = "lecture: Green's strain (Green–Lagrange)",
               .run = [this, write] { write(green_, pliant::green_strain<3>(of(slope_))); },
               .reads = {"displacement_gradient"},
               .writes = {"green_strain"},
               .explain = [this](const Question& q) { return why_deformation(q); }},
              {.name = "cauchy_strain",
               .formula = "ε = ½ (∇u + ∇uᵀ)",
               .source = "lecture: Cauchy's small strain",
               .run = [this, write] { write(cauchy_, pliant::cauchy_strain<3>(of(slope_))); },
               .reads = {"displacement_gradient"},
               .writes = {"cauchy_strain"},
               .explain = [this](const Question& q) { return why_deformation(q); }},
              {.name = "stretch_of_a_direction",
               .formula = "v′ = F v,  |v′|² = vᵀC v;  Cauchy: 1 + vᵀε v",
               .source = "second deck: the stretch in a unit direction",
               .run = [this] { measure_stretches(); },
               .reads = {"deformation_gradient", "cauchy_strain"},
               .writes = {"direction", "deformed_direction", "stretch", "cauchy_stretch"},
               .explain = [this](const Question& q) { return why_stretch(q); }},
              {.name = "hookes_law",
               .formula = "σ = D ε, with D (6 × 6) of Y and ν",
               .source = "lecture: Hooke's linear material law, σ = E ε [TimoshenkoGoodier1970 §6]",
               .run = [this] { apply_hooke(); },
               .reads = {"green_strain", "cauchy_strain"},
               .writes = {"stress_green", "stress_cauchy"},
               .explain = [this](const Question& q) { return why_stress(q); }}};
}

void StrainMeasuresLesson::deform() {
    const Mat<3> H = slope_after(turn * one_degree);
    Eigen::Map<RowMajor>(slope_.data()) = H;
    Eigen::Map<RowMajor>(deformation_.data()) =
        turn == 0 ? map_.deformation_gradient(Vec<3>::Zero()) : Mat<3>(Mat<3>::Identity() + H);
}

// Measured on the deformed vectors themselves; C is held against them by a law.
void StrainMeasuresLesson::measure_stretches() {
    const Mat<3> F = of(deformation_), strain = of(cauchy_);
    v_ = direction();
    deformed_v_ = F * v_;
    for (Index k = 0; k < samples; ++k) {
        const Vec<3> n = sampled(k);
        stretch_[k] = (F * n).norm();
        cauchy_stretch_[k] = 1 + n.dot(strain * n);
    }
}

void StrainMeasuresLesson::apply_hooke() {
    const Mat<6> D = elasticity_matrix(material());
    for (const auto& [strain, stress] : {std::pair{&green_, &stress_green_}, {&cauchy_, &stress_cauchy_}})
        Eigen::Map<RowMajor>(stress->data()) = tensor_from_voigt_stress<3>(D * voigt_strain<3>(of(*strain)));
    done_[0] = 1;
}

// The head of v, moved about the middle of the circle.
std::vector<std::pair<std::string, Real>> StrainMeasuresLesson::dragged(const Pull& pull) const {
    if (pull.index != 0 || pull.to.head<2>().norm() == 0) return {};
    return {{"v_angle", std::atan2(pull.to[1], pull.to[0]) / one_degree}};
}

const Registration<StrainMeasuresLesson> registration{
    {.id = "elasticity/strain_measures",
     .title = "Measures of strain",
     .summary = "One deformation, three measures: C = FᵀF, Green's and Cauchy's strain; which of them sees a rotation, and what "
                "it costs.",
     .demo_steps = 1}};

}  // namespace pliant::strain_measures
