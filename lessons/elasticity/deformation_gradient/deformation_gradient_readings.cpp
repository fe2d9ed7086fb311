// What is shown of a local deformation: fields, probes, the error over the distance, where the model holds and what mends a run.
#include "deformation_gradient.h"
#include "kits/tensors/tensor_why.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::deformation {
namespace {

// The length of one of the vectors from P to Q, over that of another.
std::vector<Input> components(const char* symbol, std::string_view field) {
    std::vector<Input> inputs;
    for (int i = 0; i < 3; ++i) inputs.push_back(Input::now(fmt::format("{}_{}", symbol, axis_name(i)), field, 0, i));
    return inputs;
}
Explanation norm(std::string_view left, const char* symbol, std::string_view field) {
    return {fmt::format("{0} = √({1}_x² + {1}_y² + {1}_z²)", left, symbol), components(symbol, field)};
}
Explanation ratio(std::string_view left, const char* symbol, std::string_view field) {
    const auto part = [](const char* s, std::string_view of) {
        return Input::part(fmt::format("|{}|", s), "m", norm(fmt::format("|{}|", s), s, of));
    };
    return {fmt::format("{} = |{}| / |dX|", left, symbol), {part(symbol, field), part("dX", "rest_vector")}};
}

constexpr Real degrees = 180 / std::numbers::pi;
// No accepted parameters come near it.
constexpr Real largest = 1e8;

Real bound() { return largest; }

}  // namespace

void DeformationGradientLesson::declare_fields() {
    state = {state_array("done", "", done_)};  // each solve begins anew from the parameters
    const auto vector = [](std::string_view name, std::string_view symbol, On on, const Vectors& v, std::string_view help) {
        return vector_field(name, symbol, "m", on, v, help);
    };
    const auto tensor = [](std::string_view name, std::string_view symbol, On on, const Nine& t, std::string_view help) {
        return tensor_field(name, symbol, "", on, t, help);
    };
    fields = {vector("position", "x", On::node, position_, "of the body's points now"),
              vector("displacement", "u", On::node, displacement_, "from the place at rest"),
              tensor("displacement_gradient", "∇u", On::node, slope_, "slopes of the displacement along X, Y, Z"),
              tensor("deformation_gradient", "F", On::node, deformation_, "takes small vectors at rest to vectors now"),
              scalar_field("volume_ratio", "det F", "", On::node, volume_ratio_,
                           "volume now over volume at rest; below 0 where the body is turned inside out"),
              tensor("green_strain", "E", On::node, strain_, "Green's strain: 0 wherever the motion is rigid"),
              vector("point_position", "x", On::particle, point_position_, "of P and Q now: p and q"),
              vector("point_displacement", "u", On::particle, point_displacement_, "of P and Q"),
              tensor("point_gradient", "∇u", On::particle, point_slope_, "at P and Q"),
              tensor("point_deformation", "F", On::particle, point_deformation_, "at P and Q"),
              tensor("point_rotation", "R", On::particle, point_rotation_, "the rotation in F = R S, at P and Q"),
              tensor("point_stretch", "S", On::particle, point_stretch_, "the symmetric stretch in F = R S, at P and Q"),
              vector("rest_vector", "dX", On::edge, rest_vector_, "from P to Q"),
              vector("relative_displacement", "du", On::edge, relative_displacement_, "of Q with respect to P"),
              vector("deformed_vector", "dx", On::edge, deformed_vector_, "from p to q"),
              vector("mapped_vector", "F dX", On::edge, mapped_vector_, "what F makes of dX"),
              vector("taylor_gap", "dx − F dX", On::edge, gap_, "what F leaves out")};
    for (Field& field : fields) field.bound = bound;
}

void DeformationGradientLesson::declare_probes() {
    const auto stretch = [this](int k) {
        return [this, k] { return principal_stretches<3>(at_P(point_deformation_)).stretches[k]; };
    };
    const auto exact_stretch = [this](int k) {
        return [this, k](Real) -> std::optional<Real> {
            const auto s = map_.principal_stretches(material(0));
            return s ? std::optional((*s)[k]) : std::nullopt;
        };
    };
    probes = {
        probe_of("det_F", "det F", "",
                 "at P: volume now over volume at rest; exact: 1 for rigid motions, shear and twist, s₁ s₂ s₃, 1 − κ Y")
            .formula(*this, why::determinant("point_deformation", 0))
            .exactly([this](Real) { return map_.volume_ratio(material(0)); }),
        probe_of("taylor_error", "|dx − F dX|", "m",
                 "what F leaves out between P and Q; falls as |dX|², and is 0 where F is the same everywhere")
            .formula(*this, norm("|gap|", "gap", "taylor_gap")),
        probe_of("distance", "|dX|", "m", "from P to Q at rest").formula(*this, norm("|dX|", "dX", "rest_vector")),
        probe_of("length_ratio", "|dx|/|dX|", "", "length of PQ now over its length at rest; undefined while Q lies on P")
            .formula(*this, ratio("|dx|/|dX|", "dx", "deformed_vector"))
            .exactly([this](Real) -> std::optional<Real> {
                const Vec<3> dX = rest_vector();
                const auto C = map_.right_cauchy_green(material(0));
                if (!C || !map_.homogeneous() || dX.norm() == 0) return std::nullopt;
                return std::sqrt(dX.dot(*C * dX)) / dX.norm();
            }),
        probe_of("mapped_length_ratio", "|F dX|/|dX|", "", "the same as F predicts it")
            .formula(*this, ratio("|F dX|/|dX|", "FdX", "mapped_vector"))
            .exactly([this](Real) -> std::optional<Real> {
                const Vec<3> dX = rest_vector();
                const auto C = map_.right_cauchy_green(material(0));
                if (!C || dX.norm() == 0) return std::nullopt;
                return std::sqrt(dX.dot(*C * dX)) / dX.norm();
            }),
        probe_of("rotation_angle", "∠R", "°", "by which R turns the neighbourhood of P",
                 [this] { return degrees * rotation_angle(); })
            .exactly([this](Real) -> std::optional<Real> {
                const auto angle = map_.rotation_angle(material(0));
                return angle ? std::optional(degrees * *angle) : std::nullopt;
            }),
        probe_of("stretch_1", "λ₁", "", "largest principal stretch at P: what a small sphere's longest radius grows by",
                 stretch(0))
            .exactly(exact_stretch(0)),
        probe_of("stretch_2", "λ₂", "", "middle principal stretch at P", stretch(1)).exactly(exact_stretch(1)),
        probe_of("stretch_3", "λ₃", "", "least principal stretch at P; negative where the body is turned inside out", stretch(2))
            .exactly(exact_stretch(2)),
        probe_of("polar_residual", "|F − R S|", "", "what the polar decomposition leaves",
                 [this] { return (at_P(point_deformation_) - at_P(point_rotation_) * at_P(point_stretch_)).norm(); }),
        probe_of("rotation_defect", "|RᵀR − I|", "", "how far R is from a rotation", [this] {
            const Mat<3> R = at_P(point_rotation_);
            return (R.transpose() * R - Mat<3>::Identity()).norm();
        })};
}

void DeformationGradientLesson::declare_lines() {
    const auto lengths = [] {
        std::vector<Real> all;
        for (int k = -24; k <= 0; ++k) all.push_back(std::pow(10.0, k / 6.0));
        return all;
    };
    lines = {line_of("taylor_error_over_distance", "m", "distance |dX|", "m",
                     "error of dx ≈ F dX as Q moves along its line towards P: a tenth of the distance, a hundredth of the error",
                     [this, lengths](Curve& curve) {
                         for (const Real length : lengths())
                             // No error at all has no place on a logarithmic axis.
                             if (const Real error = taylor_error(length); error > 0)
                                 curve.position.push_back(length), curve.value.push_back(error);
                     })
                 .against("slope 2",
                          [this, lengths](Curve& curve) {
                              const Real from = 1e-2, error = taylor_error(from);
                              if (map_.homogeneous() || !(error > 0)) return;
                              for (const Real length : lengths())
                                  curve.position.push_back(length), curve.value.push_back(error * std::pow(length / from, 2));
                          })
                 .measures("error |dx − F dX|")
                 .on_log_axes()};
}

void DeformationGradientLesson::declare_checks() {
    assumptions = {
        assumption_of(
            "Q near P", "", [this] { return rest_vector_.norm() > 0 ? gap_.norm() / rest_vector_.norm() : Real{0}; },
            [] { return near_enough; }, "|dx − F dX| ≤ 0.05 |dX|",
            "F describes the neighbourhood of P: Q is so far away that the bending of the map between them counts")
            .otherwise("Q far from P")
            .mended_by([this] { return nearer(); }),
        assumption_of(
            "not inside out", "", [this] { return -volume_ratio_.minCoeff(); }, [] { return Real{0}; }, "det F ≥ 0 everywhere",
            "somewhere det F < 0: the map turns the body inside out there, which no real body does")
            .otherwise("inside out")
            .mended_by([this] { return not_inverted(); })};
    conserved = {{.probe = "polar_residual",
                  .law = Law::zero,
                  .tolerance = [this] { return 1e-12 * (1 + at_P(point_deformation_).norm()); }},
                 {.probe = "rotation_defect", .law = Law::zero, .tolerance = [] { return Real{1e-12}; }}};
}

// Which parameters would mend what the lights show.

// The relative error is proportional to the distance.
std::optional<Fix> DeformationGradientLesson::nearer() const {
    const Real share = rounded_down(0.8 * near_enough * rest_vector_.norm() / gap_.norm(), 2);
    if (!(share > 0)) return std::nullopt;
    const Vec<3> there = material(0) + share * rest_vector();
    Fix fix{fmt::format("|dX| × {}", format_quantity(share, "")), {}};
    for (std::size_t k = 0; k < 3; ++k) fix.assign.emplace_back(Q[k].info.key, format_exact(there[static_cast<Index>(k)]));
    return fix;
}

std::optional<Fix> DeformationGradientLesson::not_inverted() const {
    switch (controls.kind()) {
        case MapKind::bend: {
            const Real most = rounded_down(0.9 / body_.half()[1], 2);
            const Real gentler = std::copysign(most, map_.curvature);
            return Fix{fmt::format("κ = {}", format_quantity(gentler, "1/m")), {{"bend_curvature", format_exact(gentler)}}};
        }
        case MapKind::stretch: {
            Fix fix{"stretches > 0", {}};
            constexpr std::array<const char*, 3> keys{"stretch_x", "stretch_y", "stretch_z"};
            for (Index k = 0; k < 3; ++k)
                fix.assign.emplace_back(keys[static_cast<std::size_t>(k)], format_exact(std::abs(map_.stretches[k])));
            return fix;
        }
        case MapKind::free: {
            return controls.entries().none();
        }
        default:
            return std::nullopt;
    }
}

std::string DeformationGradientLesson::blow_up_hint() const {
    return "The map is evaluated in closed form, so that only its parameters can make it large: take ones nearer to their "
           "defaults";
}

}  // namespace pliant::deformation
