#include "strain_measures.h"

#include <cmath>
#include <numbers>

namespace pliant::strain_measures {
namespace {

constexpr Index samples = 72;  // directions around the circle, 5° apart

}  // namespace

StrainMeasuresLesson::StrainMeasuresLesson()
    : controls(*this, MapControls::Offer::homogeneous, MapKind::free, Vec<3>::Zero()), operations_(count_operations()) {
    controls.add_entries(*this);
    declare_fields(), declare_stages(), declare_probes(), declare_components(), explain_probes(), declare_lines(),
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

// Nothing is deformed yet.
void StrainMeasuresLesson::reset() {
    map_ = controls.map();
    for (Nine* tensor : {&deformation_, &C_}) *tensor = Mat<3>::Identity().reshaped();
    for (Nine* tensor : {&slope_, &green_, &cauchy_, &stress_green_, &stress_cauchy_}) tensor->setZero();
    v_ = deformed_v_ = direction();
    stretch_ = cauchy_stretch_ = VecX::Ones(samples);
    done_.setZero();
    stretched_ = false;
}

// Of another direction v; before the stretches are measured v is as it will be.
void StrainMeasuresLesson::looked() {
    v_ = direction();
    deformed_v_ = stretched_ ? Vec<3>(of(deformation_) * v_) : v_;
}

// ------------------------------------------------------------------------------------------------------------ stages

void StrainMeasuresLesson::declare_stages() {
    const auto write = [](Nine& tensor, const Mat<3>& m) { Eigen::Map<RowMajor>(tensor.data()) = m; };
    formula_symbols = {{"R"}, {"u", "m"}, {"D", "Pa"}};
    stages = {
        stage_of("deformation", "F = R(θ) F of the map,  ∇u = F − I", "lecture: material deformation gradient tensor",
                 [this] { deform(); })
            .done_in("core/pliant/continuum/deformation_map.cpp: deformation_gradient")
            .maps({}, {"deformation_gradient", "displacement_gradient"})
            .because([this](const Question& q) { return why_deformation(q); }),
        stage_of("right_cauchy_green", "C = FᵀF", "second deck: Cauchy–Green strain tensor [Bonet2008 §4.5]",
                 [this, write] { write(C_, pliant::right_cauchy_green<3>(of(deformation_))); })
            .done_in("core/pliant/continuum/strain.h: right_cauchy_green")
            .maps({"deformation_gradient"}, {"right_cauchy_green"})
            .because([this](const Question& q) { return why_deformation(q); }),
        stage_of("green_strain", "E = ½ (∇u + ∇uᵀ + ∇uᵀ∇u) = ½ (C − I)", "lecture: Green's strain (Green–Lagrange)",
                 [this, write] { write(green_, pliant::green_strain<3>(of(slope_))); })
            .done_in("core/pliant/continuum/strain.h: green_strain")
            .maps({"displacement_gradient"}, {"green_strain"})
            .because([this](const Question& q) { return why_deformation(q); }),
        stage_of("cauchy_strain", "ε = ½ (∇u + ∇uᵀ)", "lecture: Cauchy's small strain",
                 [this, write] { write(cauchy_, pliant::cauchy_strain<3>(of(slope_))); })
            .done_in("core/pliant/continuum/strain.h: cauchy_strain")
            .maps({"displacement_gradient"}, {"cauchy_strain"})
            .because([this](const Question& q) { return why_deformation(q); }),
        stage_of("stretch_of_a_direction", "v′ = F v,  |v′|² = vᵀC v;  Cauchy: 1 + vᵀε v",
                 "second deck: the stretch in a unit direction", [this] { measure_stretches(); })
            .done_in("lessons/elasticity/strain_measures/strain_measures.cpp: measure_stretches")
            .maps({"deformation_gradient", "cauchy_strain"}, {"direction", "deformed_direction", "stretch", "cauchy_stretch"})
            .because([this](const Question& q) { return why_stretch(q); }),
        stage_of("hookes_law", "σ = D ε, with D (6 × 6) of Y and ν",
                 "lecture: Hooke's linear material law, σ = E ε [TimoshenkoGoodier1970 §6]", [this] { apply_hooke(); })
            .done_in("core/pliant/continuum/moduli.cpp: voigt_matrix")
            .maps({"green_strain", "cauchy_strain"}, {"stress_green", "stress_cauchy"})
            .because([this](const Question& q) { return why_stress(q); })};
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
    stretched_ = true;
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
