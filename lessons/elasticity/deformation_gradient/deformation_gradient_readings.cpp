// What is shown of a local deformation: fields, probes, the error over the distance, and where the model holds.
#include <fmt/format.h>
#include <pliant/text/format.h>

#include "deformation_gradient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::deformation {
namespace {

constexpr Real degrees = 180 / std::numbers::pi;
// No accepted parameters come near it.
constexpr Real largest = 1e8;

Real bound() { return largest; }

}  // namespace

void DeformationGradientLesson::declare_fields() {
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

void DeformationGradientLesson::declare_state() {
    state = {state_array("done", "", done_)};  // each solve begins anew from the parameters
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
    probes = {{.name = "det_F",
               .symbol = "det F",
               .help = "at P: volume now over volume at rest; exact: 1 for rigid motions, shear and twist, s₁ s₂ s₃, 1 − κ Y",
               .value = [this] { return pliant::volume_ratio<3>(at_P(point_deformation_)); },
               .exact = [this](Real) { return map_.volume_ratio(material(0)); }},
              {.name = "taylor_error",
               .symbol = "|dx − F dX|",
               .unit = "m",
               .help = "what F leaves out between P and Q; falls as |dX|², and is 0 where F is the same everywhere",
               .value = [this] { return gap_.norm(); }},
              {.name = "distance",
               .symbol = "|dX|",
               .unit = "m",
               .help = "from P to Q at rest",
               .value = [this] { return rest_vector_.norm(); }},
              {.name = "length_ratio",
               .symbol = "|dx|/|dX|",
               .help = "length of PQ now over its length at rest; undefined while Q lies on P",
               .value = [this]() -> std::optional<Real> {
                   const Real at_rest = rest_vector_.norm();
                   return at_rest > 0 ? std::optional(deformed_vector_.norm() / at_rest) : std::nullopt;
               },
               .exact = [this](Real) -> std::optional<Real> {
                   const Vec<3> dX = rest_vector();
                   const auto C = map_.right_cauchy_green(material(0));
                   if (!C || !map_.homogeneous() || dX.norm() == 0) return std::nullopt;
                   return std::sqrt(dX.dot(*C * dX)) / dX.norm();
               }},
              {.name = "mapped_length_ratio",
               .symbol = "|F dX|/|dX|",
               .help = "the same as F predicts it",
               .value = [this]() -> std::optional<Real> {
                   const Real at_rest = rest_vector_.norm();
                   return at_rest > 0 ? std::optional(mapped_vector_.norm() / at_rest) : std::nullopt;
               },
               .exact = [this](Real) -> std::optional<Real> {
                   const Vec<3> dX = rest_vector();
                   const auto C = map_.right_cauchy_green(material(0));
                   if (!C || dX.norm() == 0) return std::nullopt;
                   return std::sqrt(dX.dot(*C * dX)) / dX.norm();
               }},
              {.name = "rotation_angle",
               .symbol = "∠R",
               .unit = "°",
               .help = "by which R turns the neighbourhood of P",
               .value = [this] { return degrees * rotation_angle(); },
               .exact = [this](Real) -> std::optional<Real> {
                   const auto angle = map_.rotation_angle(material(0));
                   return angle ? std::optional(degrees * *angle) : std::nullopt;
               }},
              {.name = "stretch_1",
               .symbol = "λ₁",
               .help = "largest principal stretch at P: what a small sphere's longest radius grows by",
               .value = stretch(0),
               .exact = exact_stretch(0)},
              {.name = "stretch_2",
               .symbol = "λ₂",
               .help = "middle principal stretch at P",
               .value = stretch(1),
               .exact = exact_stretch(1)},
              {.name = "stretch_3",
               .symbol = "λ₃",
               .help = "least principal stretch at P; negative where the body is turned inside out",
               .value = stretch(2),
               .exact = exact_stretch(2)},
              {.name = "polar_residual",
               .symbol = "|F − R S|",
               .help = "what the polar decomposition leaves",
               .value = [this] { return (at_P(point_deformation_) - at_P(point_rotation_) * at_P(point_stretch_)).norm(); }},
              {.name = "rotation_defect", .symbol = "|RᵀR − I|", .help = "how far R is from a rotation", .value = [this] {
                   const Mat<3> R = at_P(point_rotation_);
                   return (R.transpose() * R - Mat<3>::Identity()).norm();
               }}};
}

void DeformationGradientLesson::declare_lines() {
    const auto lengths = [] {
        std::vector<Real> all;
        for (int k = -24; k <= 0; ++k) all.push_back(std::pow(10.0, k / 6.0));
        return all;
    };
    lines = {{.name = "taylor_error_over_distance",
              .unit = "m",
              .position_name = "distance |dX|",
              .position_unit = "m",
              .help = "error of dx ≈ F dX as Q moves along its line towards P: a tenth of the distance, a hundredth of the error",
              .sample =
                  [this, lengths](Curve& curve) {
                      curve.position.clear(), curve.value.clear();
                      for (const Real length : lengths())
                          // No error at all has no place on a logarithmic axis.
                          if (const Real error = taylor_error(length); error > 0)
                              curve.position.push_back(length), curve.value.push_back(error);
                  },
              .reference =
                  [this, lengths](Curve& curve) {
                      curve.position.clear(), curve.value.clear();
                      const Real from = 1e-2, error = taylor_error(from);
                      if (map_.homogeneous() || !(error > 0)) return;
                      for (const Real length : lengths())
                          curve.position.push_back(length), curve.value.push_back(error * std::pow(length / from, 2));
                  },
              .reference_name = "slope 2",
              .value_name = "error |dx − F dX|",
              .log_log = true}};
}

void DeformationGradientLesson::declare_checks() {
    assumptions = {
        {.name = "Q near P",
         .value = [this] { return rest_vector_.norm() > 0 ? gap_.norm() / rest_vector_.norm() : Real{0}; },
         .limit = [] { return near_enough; },
         .formula = "|dx − F dX| ≤ 0.05 |dX|",
         .broken = "F describes the neighbourhood of P: Q is so far away that the bending of the map between them counts",
         .fix = [this] { return nearer(); }},
        {.name = "not inside out",
         .value = [this] { return -volume_ratio_.minCoeff(); },
         .limit = [] { return Real{0}; },
         .formula = "det F ≥ 0 everywhere",
         .broken = "somewhere det F < 0: the map turns the body inside out there, which no real body does",
         .fix = [this] { return not_inverted(); }}};
    conserved = {{.probe = "polar_residual",
                  .law = Law::zero,
                  .tolerance = [this] { return 1e-12 * (1 + at_P(point_deformation_).norm()); }},
                 {.probe = "rotation_defect", .law = Law::zero, .tolerance = [] { return Real{1e-12}; }}};
}

}  // namespace pliant::deformation
