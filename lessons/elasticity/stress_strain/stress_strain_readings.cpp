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
        return vector_field(name, symbol, "Pa", On::element, values, help).when(of(Load::cut));
    };
    fields.push_back(on_cut("traction", "t", traction_, "force per area on a plane with the normal of the cut"));
    fields.push_back(on_cut("normal_part", "σ_n n", normal_part_, "its part along the normal"));
    fields.push_back(on_cut("shear_part", "τ", shear_part_, "its part along the plane"));
}

void StressStrainLesson::declare_probes() {
    const auto axial = [this] { return loading != Load::cut; };
    // Closed forms hold once the load is on.
    const auto once_loaded = [this](auto value) { return [this, value](Real) { return done_[0] != 0 ? value() : Real{0}; }; };
    const auto add_of_cut = [this](std::string_view name, std::string_view symbol, std::string_view help,
                                   std::function<Real(const Mat<3>&)> value) {
        probes.push_back(probe_of(name, symbol, "Pa", help, [this, value] {
                             return value(body_->mean(stress_));
                         }).exactly([this, value](Real) {
                               return value(done_[0] != 0 ? applied_stress() : Mat<3>::Zero());
                           }).when(of(Load::cut)));
    };
    // What the lecture calls stress of the disc is a pressure, positive downward.
    const auto sign = [this] { return loading == Load::disc ? -1 : 1; };
    const auto normal_stress = [this](const Mat<3>& s) { return parts(s, normal()).first; };
    const auto shear_stress = [this](const Mat<3>& s) { return parts(s, normal()).second; };
    const auto largest = [](const Mat<3>& s) { return principal_stresses(s)[0]; };
    const auto smallest = [](const Mat<3>& s) { return principal_stresses(s)[1]; };
    const auto axis = [this] { return body_->axis(); };

    probes = {probe_of("support_force", "F", "N", "that the support carries: the weight m g, or the pull on the rod",
                       [this, sign] { return sign() * body_->support_force(reaction_); })
                  .exactly(once_loaded([this, sign] { return sign() * applied_force(); }))
                  .when(axial),
              probe_of("area", "A", "m²", "that carries it: π r², or w²", [this] { return body_->support_area(); })
                  .exactly([this](Real) { return loaded_area(); })
                  .when(axial),
              probe_of("stress", "σ = F/A", "Pa", "force over area: m g / (π r²) for the disc, whose stress is counted downward")
                  .formula(*this, "σ = F / A", {Input::now("F", "support_force", 0), Input::now("A", "area", 0)})
                  .exactly(once_loaded([this, sign] { return sign() * axial_stress(); }))
                  .when(axial),
              probe_of("mean_stress", "σ̄", "Pa", "along the load, mean of all elements: negative where compressed",
                       [this, axis] { return body_->mean(stress_)(axis(), axis()); })
                  .exactly(once_loaded([this] { return axial_stress(); }))
                  .when(axial),
              probe_of("strain", "ε = ΔL/L", "", "negative in compression, zero at rest, positive in extension")
                  .formula(*this, "ε = ΔL / L", {Input::now("ΔL", "lengthening", 0), length})
                  .exactly(once_loaded([this] { return axial_stress() / youngs_modulus; }))
                  .when(axial),
              probe_of("lengthening", "ΔL", "m", "of the height of the disc or the length of the rod",
                       [this] { return body_->lengthening(displacement_); })
                  .exactly(once_loaded([this] { return axial_stress() / youngs_modulus * length; }))
                  .when(axial),
              probe_of("transverse_strain", "ε_zz", "", "across the load: −ν times the strain along it",
                       [this] { return body_->transverse_strain(displacement_); })
                  .exactly(once_loaded([this] { return -poisson_ratio * axial_stress() / youngs_modulus; }))
                  .when(axial)};
    add_of_cut("normal_stress", "σ_n = n·σ·n", "force per area across the cut: it pulls the halves apart where positive",
               normal_stress);
    add_of_cut("shear_stress", "τ", "force per area along the cut, positive anticlockwise from the normal", shear_stress);
    add_of_cut("traction", "|t|", "force per area on the cut in all: √(σ_n² + τ²)",
               [this](const Mat<3>& s) { return Vec<3>(s * normal()).norm(); });
    add_of_cut("largest_normal_stress", "σ₁",
               "over all cuts that stand upright on the picture: a principal stress, on a plane without shear; a cut along the "
               "picture has no stress at all",
               largest);
    add_of_cut("smallest_normal_stress", "σ₂", "over all cuts that stand upright on the picture: the other principal stress",
               smallest);
    probes.push_back(probe_of("force_imbalance", "|F + R|", "N", "resultant of all loads and support forces",
                              [this] { return (load_force_ + reaction_).rowwise().sum().norm(); }));
}

void StressStrainLesson::declare_lines() {
    // Measured points come when the load is on.
    const auto point = [this](Curve& curve, Real at, Real value) {
        if (done_[0] != 0) curve.position.push_back(at), curve.value.push_back(value);
    };
    lines = {
        line_of("stress_by_radius", "Pa", "radius r", "m",
                "the same weight on a smaller disc: half the radius, four times the stress",
                [this, point](Curve& curve) { point(curve, radius, -body_->support_force(reaction_) / body_->support_area()); })
            .against("m g / (π r²)",
                     [this](Curve& curve) {
                         for (int k = 0; k <= 60; ++k) {
                             const Real r = radius * (0.5 + 1.5 * k / 60);
                             curve.position.push_back(r);
                             curve.value.push_back(weight() / (std::numbers::pi * r * r));
                         }
                     })
            .measures("stress σ")
            .when(of(Load::disc)),
        line_of(
            "stress_by_strain", "Pa", "strain ε", "", "pulled: both positive; pressed: both negative",
            [this, point](Curve& curve) { point(curve, body_->lengthening(displacement_) / length, body_->mean(stress_)(0, 0)); })
            .against("Y ε",
                     [this](Curve& curve) {
                         const Real reach = 1.5 * std::abs(axial_stress()) + (force == 0 ? 0.01 * youngs_modulus : Real{0});
                         curve.position = {-reach / youngs_modulus, 0, reach / youngs_modulus};
                         curve.value = {-reach, 0, reach};
                     })
            .measures("stress σ")
            .when(of(Load::rod)),
        line_of("mohr_circle", "Pa", "normal stress σ_n", "Pa",
                "both parts of the force on the cut as it turns from 0° to θ: half a turn goes once around the circle",
                [this](Curve& curve) {
                    if (done_[0] == 0) return;
                    const Mat<3> stress = body_->mean(stress_);
                    for (int k = 0; k <= 90; ++k) {
                        const auto [normal_part, shear] = parts(stress, normal_at(angle * k / 90));
                        curve.position.push_back(normal_part), curve.value.push_back(shear);
                    }
                })
            .against("Mohr's circle",
                     [this](Curve& curve) {
                         for (int k = 0; k <= 90; ++k) {
                             const auto [normal_part, shear] = parts(applied_stress(), normal_at(2.0 * k));
                             curve.position.push_back(normal_part), curve.value.push_back(shear);
                         }
                     })
            .measures("shear stress τ")
            .when(of(Load::cut)),
        line_of("normal_stress_by_angle", "Pa", "angle θ of the normal", "°", "the cut that is pulled most has no shear on it",
                [this, point](Curve& curve) { point(curve, angle, parts(body_->mean(stress_), normal()).first); })
            .against("exact",
                     [this](Curve& curve) {
                         for (int k = -90; k <= 90; k += 2) {
                             curve.position.push_back(k);
                             curve.value.push_back(parts(applied_stress(), normal_at(k)).first);
                         }
                     })
            .measures("normal stress σ_n")
            .when(of(Load::cut))};
}

std::vector<std::string_view> StressStrainLesson::first_plots() const {
    if (loading == Load::cut) return {"mohr_circle", "normal_stress_by_angle"};
    return {loading == Load::disc ? "stress_by_radius" : "stress_by_strain"};
}

std::vector<std::string_view> StressStrainLesson::key_numbers() const {
    if (loading == Load::cut) return {"normal_stress", "shear_stress"};
    return {"support_force", "stress", "strain"};
}

void StressStrainLesson::declare_checks() {
    assumptions = {
        assumption_of(
            "small strain", "", [this] { return strain_.cwiseAbs().maxCoeff(); }, [] { return small_strain; }, "|ε| ≤ 0.05",
            "linear strain leaves out ½ ∇uᵀ∇u: lengths are wrong by more than about 2.5 %, and F/A with the area at rest "
            "is no longer the force per area that the material feels")
            .otherwise("large strain")
            .mended_by([this]() -> std::optional<Fix> {
                const Real stiffer = youngs_modulus * strain_.cwiseAbs().maxCoeff() / small_strain * 1.25;
                const Real rounded = std::pow(10, std::ceil(std::log10(stiffer)));
                return Fix{fmt::format("Y = {}", format_quantity(rounded, "Pa")), {{"youngs_modulus", format_exact(rounded)}}};
            })};
    conserved = {{.probe = "force_imbalance", .law = Law::zero, .tolerance = [this] {
                      return 1e-9 * (load_force_.norm() + body_->loaded_area().norm() * applied_stress().norm());
                  }}};
}

}  // namespace pliant::stress_strain
