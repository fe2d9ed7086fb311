// What the loaded bodies show: fields, probes, lines, and where the model holds.
#include "stress_strain.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::stress_strain {
namespace {

// Normal and shear part of the force per area of a plane under a stress; the shear is positive anticlockwise.
std::pair<Real, Real> parts(const Mat<3>& stress, const Vec<3>& n) {
    const Vec<3> t = stress * n;
    return {t.dot(n), t.dot(Vec<3>(-n[1], n[0], 0))};
}

}  // namespace

void StressStrainLesson::declare_fields() {
    state = {state_array("done", "", done_)};  // each solve begins anew from the parameters
    fields = {vector_field("displacement", "u", "m", On::node, displacement_, "from the rest position"),
              vector_field("load", "f", "N", On::node, load_force_, "each node's share of the load"),
              vector_field("reaction", "r", "N", On::node, reaction_, "K u − f where a support holds the node"),
              tensor_field("strain", "ε", "", On::element, strain_, "Cauchy's small strain; negative where compressed"),
              tensor_field("stress", "σ", "Pa", On::element, stress_, "Hooke's law; negative where compressed")};
    const auto on_cut = [this](std::string_view name, std::string_view symbol, const Points<3>& values, std::string_view help) {
        Field f = vector_field(name, symbol, "Pa", On::element, values, help);
        f.used = [this] { return loading == Load::cut; };
        return f;
    };
    fields.push_back(on_cut("traction", "t", traction_, "force per area on a plane with the normal of the cut"));
    fields.push_back(on_cut("normal_part", "σ_n n", normal_part_, "its part along the normal"));
    fields.push_back(on_cut("shear_part", "τ", shear_part_, "its part along the plane"));
}

void StressStrainLesson::declare_probes() {
    const auto axial = [this](auto value) {
        return [this, value]() -> std::optional<Real> {
            if (loading == Load::cut) return std::nullopt;
            return value();
        };
    };
    const auto exact_axial = [this](auto value) {
        return [this, value](Real) -> std::optional<Real> {
            if (loading == Load::cut) return std::nullopt;
            return done_[0] != 0 ? value() : Real{0};
        };
    };
    const auto of_cut = [this](auto value) {
        return [this, value]() -> std::optional<Real> {
            if (loading != Load::cut) return std::nullopt;
            return value(body_->mean(stress_));
        };
    };
    const auto exact_of_cut = [this](auto value) {
        return [this, value](Real) -> std::optional<Real> {
            if (loading != Load::cut) return std::nullopt;
            return value(done_[0] != 0 ? applied_stress() : Mat<3>::Zero());
        };
    };
    // What the lecture calls stress of the disc is a pressure, positive downward.
    const auto sign = [this] { return loading == Load::disc ? -1 : 1; };
    const auto normal_stress = [this](const Mat<3>& s) { return parts(s, normal()).first; };
    const auto shear_stress = [this](const Mat<3>& s) { return parts(s, normal()).second; };
    const auto largest = [](const Mat<3>& s) { return principal_stresses(s)[0]; };
    const auto smallest = [](const Mat<3>& s) { return principal_stresses(s)[1]; };
    const auto axis = [this] { return body_->axis(); };

    probes = {
        {.name = "support_force",
         .symbol = "F",
         .unit = "N",
         .help = "that the support carries: the weight m g, or the pull on the rod",
         .value = axial([this, sign] { return sign() * body_->support_force(reaction_); }),
         .exact = exact_axial([this, sign] { return sign() * applied_force(); })},
        {.name = "area",
         .symbol = "A",
         .unit = "m²",
         .help = "that carries it: π r², or w²",
         .value = axial([this] { return body_->support_area(); }),
         .exact = [this](Real) -> std::optional<Real> {
             if (loading == Load::cut) return std::nullopt;
             return loaded_area();
         }},
        {.name = "stress",
         .symbol = "σ = F/A",
         .unit = "Pa",
         .help = "force over area: m g / (π r²) for the disc, whose stress is counted downward",
         .value = axial([this, sign] { return sign() * body_->support_force(reaction_) / body_->support_area(); }),
         .exact = exact_axial([this, sign] { return sign() * axial_stress(); })},
        {.name = "mean_stress",
         .symbol = "σ̄",
         .unit = "Pa",
         .help = "along the load, mean of all elements: negative where compressed",
         .value = axial([this, axis] { return body_->mean(stress_)(axis(), axis()); }),
         .exact = exact_axial([this] { return axial_stress(); })},
        {.name = "strain",
         .symbol = "ε = ΔL/L",
         .unit = "",
         .help = "negative in compression, zero at rest, positive in extension",
         .value = axial([this] { return body_->lengthening(displacement_) / length; }),
         .exact = exact_axial([this] { return axial_stress() / youngs_modulus; })},
        {.name = "lengthening",
         .symbol = "ΔL",
         .unit = "m",
         .help = "of the height of the disc or the length of the rod",
         .value = axial([this] { return body_->lengthening(displacement_); }),
         .exact = exact_axial([this] { return axial_stress() / youngs_modulus * length; })},
        {.name = "transverse_strain",
         .symbol = "ε_zz",
         .unit = "",
         .help = "across the load: −ν times the strain along it",
         .value = axial([this] { return body_->transverse_strain(displacement_); }),
         .exact = exact_axial([this] { return -poisson_ratio * axial_stress() / youngs_modulus; })},
        {.name = "normal_stress",
         .symbol = "σ_n = n·σ·n",
         .unit = "Pa",
         .help = "force per area across the cut: it pulls the halves apart where positive",
         .value = of_cut(normal_stress),
         .exact = exact_of_cut(normal_stress)},
        {.name = "shear_stress",
         .symbol = "τ",
         .unit = "Pa",
         .help = "force per area along the cut, positive anticlockwise from the normal",
         .value = of_cut(shear_stress),
         .exact = exact_of_cut(shear_stress)},
        {.name = "traction",
         .symbol = "|t|",
         .unit = "Pa",
         .help = "force per area on the cut in all: √(σ_n² + τ²)",
         .value = of_cut([this](const Mat<3>& s) { return Vec<3>(s * normal()).norm(); }),
         .exact = exact_of_cut([this](const Mat<3>& s) { return Vec<3>(s * normal()).norm(); })},
        {.name = "largest_normal_stress",
         .symbol = "σ₁",
         .unit = "Pa",
         .help = "over all cuts that stand upright on the picture: a principal stress, on a plane without shear; a cut along the "
                 "picture has no stress at all",
         .value = of_cut(largest),
         .exact = exact_of_cut(largest)},
        {.name = "smallest_normal_stress",
         .symbol = "σ₂",
         .unit = "Pa",
         .help = "over all cuts that stand upright on the picture: the other principal stress",
         .value = of_cut(smallest),
         .exact = exact_of_cut(smallest)},
        {.name = "force_imbalance",
         .symbol = "|F + R|",
         .unit = "N",
         .help = "resultant of all loads and support forces",
         .value = [this] { return (load_force_ + reaction_).rowwise().sum().norm(); }}};
}

void StressStrainLesson::declare_lines() {
    const auto when = [this](Load which) { return [this, which] { return loading == which; }; };
    // Measured points come when the load is on.
    const auto point = [this](Curve& curve, Real at, Real value) {
        curve.position.clear(), curve.value.clear();
        if (done_[0] != 0) curve.position.push_back(at), curve.value.push_back(value);
    };
    lines = {
        {.name = "stress_by_radius",
         .unit = "Pa",
         .position_name = "radius r",
         .position_unit = "m",
         .help = "the same weight on a smaller disc: half the radius, four times the stress",
         .sample = [this,
                    point](Curve& curve) { point(curve, radius, -body_->support_force(reaction_) / body_->support_area()); },
         .reference =
             [this](Curve& curve) {
                 curve.position.clear(), curve.value.clear();
                 for (int k = 0; k <= 60; ++k) {
                     const Real r = radius * (0.5 + 1.5 * k / 60);
                     curve.position.push_back(r);
                     curve.value.push_back(weight() / (std::numbers::pi * r * r));
                 }
             },
         .reference_name = "m g / (π r²)",
         .value_name = "stress σ",
         .used = when(Load::disc)},
        {.name = "stress_by_strain",
         .unit = "Pa",
         .position_name = "strain ε",
         .position_unit = "",
         .help = "pulled: both positive; pressed: both negative",
         .sample = [this, point](
                       Curve& curve) { point(curve, body_->lengthening(displacement_) / length, body_->mean(stress_)(0, 0)); },
         .reference =
             [this](Curve& curve) {
                 const Real reach = 1.5 * std::abs(axial_stress()) + (force == 0 ? 0.01 * youngs_modulus : Real{0});
                 curve.position = {-reach / youngs_modulus, 0, reach / youngs_modulus};
                 curve.value = {-reach, 0, reach};
             },
         .reference_name = "Y ε",
         .value_name = "stress σ",
         .used = when(Load::rod)},
        {.name = "mohr_circle",
         .unit = "Pa",
         .position_name = "normal stress σ_n",
         .position_unit = "Pa",
         .help = "both parts of the force on the cut as it turns from 0° to θ: half a turn goes once around the circle",
         .sample =
             [this](Curve& curve) {
                 curve.position.clear(), curve.value.clear();
                 if (done_[0] == 0) return;
                 const Mat<3> stress = body_->mean(stress_);
                 for (int k = 0; k <= 90; ++k) {
                     const auto [normal_part, shear] = parts(stress, normal_at(angle * k / 90));
                     curve.position.push_back(normal_part), curve.value.push_back(shear);
                 }
             },
         .reference =
             [this](Curve& curve) {
                 curve.position.clear(), curve.value.clear();
                 for (int k = 0; k <= 90; ++k) {
                     const auto [normal_part, shear] = parts(applied_stress(), normal_at(2.0 * k));
                     curve.position.push_back(normal_part), curve.value.push_back(shear);
                 }
             },
         .reference_name = "Mohr's circle",
         .value_name = "shear stress τ",
         .used = when(Load::cut)},
        {.name = "normal_stress_by_angle",
         .unit = "Pa",
         .position_name = "angle θ of the normal",
         .position_unit = "°",
         .help = "the cut that is pulled most has no shear on it",
         .sample = [this, point](Curve& curve) { point(curve, angle, parts(body_->mean(stress_), normal()).first); },
         .reference =
             [this](Curve& curve) {
                 curve.position.clear(), curve.value.clear();
                 for (int k = -90; k <= 90; k += 2) {
                     curve.position.push_back(k);
                     curve.value.push_back(parts(applied_stress(), normal_at(k)).first);
                 }
             },
         .value_name = "normal stress σ_n",
         .used = when(Load::cut)}};
}

std::vector<std::string_view> StressStrainLesson::first_plots() const {
    switch (Load(loading)) {
        case Load::disc:
            return {"stress_by_radius"};
        case Load::rod:
            return {"stress_by_strain"};
        case Load::cut:
            return {"mohr_circle", "normal_stress_by_angle"};
    }
    return {};
}

std::vector<std::string_view> StressStrainLesson::key_numbers() const {
    if (loading == Load::cut) return {"normal_stress", "shear_stress"};
    return {"support_force", "stress", "strain"};
}

void StressStrainLesson::declare_checks() {
    assumptions = {
        {.name = "small strain",
         .unit = "",
         .value = [this] { return strain_.cwiseAbs().maxCoeff(); },
         .limit = [] { return small_strain; },
         .formula = "|ε| ≤ 0.05",
         .broken = "linear strain leaves out ½ ∇uᵀ∇u: lengths are wrong by more than about 2.5 %, and F/A with the area at rest "
                   "is no longer the force per area that the material feels",
         .fix = [this]() -> std::optional<Fix> {
             const Real stiffer = youngs_modulus * strain_.cwiseAbs().maxCoeff() / small_strain * 1.25;
             const Real rounded = std::pow(10, std::ceil(std::log10(stiffer)));
             return Fix{fmt::format("Y = {}", format_quantity(rounded, "Pa")), {{"youngs_modulus", format_exact(rounded)}}};
         }}};
    conserved = {{.probe = "force_imbalance", .law = Law::zero, .tolerance = [this] {
                      return 1e-9 * (load_force_.norm() + body_->loaded_area().norm() * applied_stress().norm());
                  }}};
}

}  // namespace pliant::stress_strain
