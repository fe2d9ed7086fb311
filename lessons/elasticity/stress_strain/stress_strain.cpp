#include "stress_strain.h"

#include "elasticity/material/material_parameters.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::stress_strain {
namespace {

// A body may be flat or long, but its cells must not become needles.
constexpr Real largest_aspect = 1000;

ParameterInfo metres(std::string_view key, std::string_view symbol, std::string_view help, Real initial, Interval useful) {
    return {.key = key,
            .symbol = symbol,
            .unit = "m",
            .help = help,
            .initial = initial,
            .useful = useful,
            .accepted = Interval{1e-9, 1e9},
            .scale = Scale::log,
            .effect = Effect::rebuild};
}

ParameterInfo stress_of(std::string_view key, std::string_view symbol, std::string_view help, Real initial) {
    return {.key = key,
            .symbol = symbol,
            .unit = "Pa",
            .help = help,
            .initial = initial,
            .useful = {-4e4, 4e4},
            .accepted = Interval{-1e15, 1e15},
            .effect = Effect::rebuild};
}

}  // namespace

StressStrainLesson::StressStrainLesson()
    : loading(*this, {.key = "scene", .help = "what is loaded", .effect = Effect::rebuild},
              {{"disc", "a weight on a disc"}, {"rod", "a rod, pulled or pressed"}, {"cut", "a cut through a block"}}),
      mass(*this, {.key = "mass",
                   .symbol = "m",
                   .unit = "kg",
                   .help = "of the body that rests on the disc",
                   .initial = 50,
                   .useful = {1, 100},
                   .accepted = Interval{0, 1e15, true},
                   .effect = Effect::rebuild,
                   .used = [this] { return loading == Load::disc; }}),
      gravity(*this, {.key = "gravity",
                      .symbol = "g",
                      .unit = "m/s²",
                      .help = "weight of a mass of 1 kg; 1.62 on the Moon",
                      .initial = 9.81,
                      .useful = {0, 25},
                      .accepted = Interval{0, 1e6},
                      .effect = Effect::rebuild,
                      .used = [this] { return loading == Load::disc; }}),
      radius(*this,
             [this] {
                 ParameterInfo info = metres("radius", "r", "of the disc", 0.1, {0.05, 0.2});
                 info.used = [this] { return loading == Load::disc; };
                 return info;
             }()),
      force(*this, {.key = "force",
                    .symbol = "F",
                    .unit = "N",
                    .help = "on the end of the rod: it pulls where positive and presses where negative",
                    .initial = 300,
                    .useful = {-500, 500},
                    .accepted = Interval{-1e15, 1e15},
                    .effect = Effect::rebuild,
                    .used = [this] { return loading == Load::rod; }}),
      sigma_xx(*this,
               [this] {
                   ParameterInfo info = stress_of("sigma_xx", "σ_xx", "pull along x on the faces across x", 3e4);
                   info.used = [this] { return loading == Load::cut; };
                   return info;
               }()),
      sigma_yy(*this,
               [this] {
                   ParameterInfo info = stress_of("sigma_yy", "σ_yy", "pull along y on the faces across y", -1e4);
                   info.used = [this] { return loading == Load::cut; };
                   return info;
               }()),
      sigma_xy(*this,
               [this] {
                   ParameterInfo info = stress_of("sigma_xy", "σ_xy", "shear on all four of these faces", 1e4);
                   info.used = [this] { return loading == Load::cut; };
                   return info;
               }()),
      angle(*this, {.key = "angle",
                    .symbol = "θ",
                    .unit = "°",
                    .help = "from the x axis to the normal of the cut",
                    .initial = 30,
                    .useful = {-90, 90},
                    .accepted = Interval{-360, 360},
                    .effect = Effect::rebuild,
                    .used = [this] { return loading == Load::cut; }}),
      length(*this, metres("length", "L", "height of the disc, or length of the rod or block", 0.2, {0.05, 0.5})),
      width(*this,
            [this] {
                ParameterInfo info = metres("width", "w", "thickness of the rod or block", 0.1, {0.05, 0.2});
                info.used = [this] { return loading != Load::disc; };
                return info;
            }()),
      youngs_modulus(*this, youngs_modulus_info("stress per strain; rubber 1 MPa, steel 200 GPa", {1e5, 1e12})),
      poisson_ratio(*this, poisson_ratio_info("narrowing over lengthening", {-0.5, 0.49})),
      resolution(*this, {.key = "resolution",
                         .symbol = "n",
                         .help = "cells across, of 5 tetrahedra each; the stress is uniform and does not depend on it",
                         .initial = 4,
                         .useful = {2, 8},
                         .accepted = Interval{1, 12},
                         .effect = Effect::rebuild}) {
    declare_fields();
    declare_stages();
    declare_probes();
    explain_probes();
    declare_lines();
    declare_checks();
}

void StressStrainLesson::check() const {
    material();
    const Real across = loading == Load::disc ? 2 * radius : Real{width};
    const char* name = loading == Load::disc ? "radius" : "width";
    const Real aspect = length / across;
    if (aspect > largest_aspect || aspect < 1 / largest_aspect)
        throw Refused(fmt::format("length = {} m and {} = {} m do not go together: give a length over thickness in [{}, {}]",
                                  Real(length), name, loading == Load::disc ? Real{radius} : Real{width}, 1 / largest_aspect,
                                  largest_aspect));
}

void StressStrainLesson::reset() {
    body_ =
        std::make_unique<LoadedBody>(loading, material(), BodySize{radius, length, width, static_cast<int>(Index(resolution))});
    factor_ = SparseCholesky();
    for (Points<3>* nodal : {&displacement_, &reaction_, &load_force_}) nodal->setZero(3, body_->mesh().node_count());
    const Index elements = body_->mesh().simplex_count(), cut_elements = loading == Load::cut ? elements : 0;
    for (Points<3>* parts : {&traction_, &normal_part_, &shear_part_}) parts->setZero(3, cut_elements);
    for (Tensors<3>* tensors : {&strain_, &stress_}) tensors->setZero(9, elements);
    done_.setZero();
}

// -------------------------------------------------------------------------------------------------------- closed forms

Real StressStrainLesson::loaded_area() const {
    return loading == Load::disc ? std::numbers::pi * radius * radius : width * width;
}

Mat<3> StressStrainLesson::applied_stress() const {
    Mat<3> stress = Mat<3>::Zero();
    if (loading == Load::cut) {
        stress(0, 0) = sigma_xx, stress(1, 1) = sigma_yy;
        stress(0, 1) = stress(1, 0) = sigma_xy;
    } else {
        stress(body_->axis(), body_->axis()) = axial_stress();
    }
    return stress;
}

Mat<3> StressStrainLesson::exact_strain() const {
    const Mat<3> stress = applied_stress();
    return ((1 + poisson_ratio) * stress - poisson_ratio * stress.trace() * Mat<3>::Identity()) / youngs_modulus;
}

Vec<3> StressStrainLesson::normal_at(Real degrees) const {
    const Real a = degrees * std::numbers::pi / 180;
    return {std::cos(a), std::sin(a), 0};
}

Vec<3> StressStrainLesson::normal() const { return normal_at(angle); }

// -------------------------------------------------------------------------------------------------------------- stages

void StressStrainLesson::declare_stages() {
    stages = {{.name = "apply_load",
               .formula = "f_a = ∫ N_a σ·n dA",
               .source = "force per area, spread over the nodes by their shape functions [Hughes2000 §2.9]",
               .run = [this] { apply_load(); },
               .reads = {},
               .writes = {"load"},
               .explain = [this](const Question& q) { return why_load(q); }},
              {.name = "solve",
               .formula = "K u = f",
               .source = "equilibrium of linear tetrahedra [Hughes2000 §2.7], by factorisation [Davis2006 §4]",
               .run = [this] { solve(); },
               .reads = {"load"},
               .writes = {"displacement", "reaction"},
               .explain =
                   [this](const Question& q) {
                       return q.field == "reaction"
                                  ? linear_body::why_reaction(body_->problem(), hooke(), q.index, q.component)
                                  : linear_body::why_displacement(body_->problem(), q.index, q.component, false);
                   }},
              {.name = "strain",
               .formula = "ε = ½ (∇u + ∇uᵀ)   (ΔL/L along the load)",
               .source = "lecture: strain is the fractional deformation",
               .run = [this] { body_->body().strain(displacement_, strain_); },
               .reads = {"displacement"},
               .writes = {"strain"},
               .explain =
                   [this](const Question& q) {
                       return linear_body::why_strain(body_->mesh(), q.index, q.component / 3, q.component % 3);
                   }},
              {.name = "stress",
               .formula = "σ = λ tr(ε) I + 2 μ ε   (F/A along the load)",
               .source = "lecture: stress is force over area; Hooke's law",
               .run =
                   [this] {
                       body_->body().stress(displacement_, stress_);
                       done_[0] = loading == Load::cut ? 0 : 1;
                   },
               .reads = {"strain"},
               .writes = {"stress"},
               .explain = [this](const Question& q) { return hooke().why_stress(q.index, q.component / 3, q.component % 3); }},
              {.name = "cut",
               .formula = "t = σ·n,  σ_n = n·t,  τ = |t − σ_n n|",
               .source = "lecture: force per area of a plane of normal n, f = σ·n [TimoshenkoGoodier1970 §10]",
               .run = [this] { cut(); },
               .reads = {"stress"},
               .writes = {"traction", "normal_part", "shear_part"},
               .active = [this] { return loading == Load::cut; },
               .explain = [this](const Question& q) { return why_traction(q); }}};
}

void StressStrainLesson::apply_load() { load_force_ = applied_stress() * body_->loaded_area(); }

void StressStrainLesson::solve() {
    const StaticProblem<3>& problem = body_->problem();
    problem.right_side(load_force_, right_side_);
    factor_.factorize(problem.system().matrix());
    factor_.solve(right_side_, solution_);
    problem.displacement(solution_, displacement_);
    problem.reaction(displacement_, load_force_, reaction_);
}

void StressStrainLesson::cut() {
    const Vec<3> n = normal();
    for (Index e = 0; e < traction_.cols(); ++e) {
        traction_.col(e) = tensor<3>(stress_, e) * n;
        normal_part_.col(e) = traction_.col(e).dot(n) * n;
        shear_part_.col(e) = traction_.col(e) - normal_part_.col(e);
    }
    done_[0] = 1;
}

std::string StressStrainLesson::blow_up_hint() const {
    return "The body is linear and cannot blow up; a load of more than 10¹⁵ in a material this soft leaves the range of numbers";
}

std::optional<Fix> StressStrainLesson::fix(const Failure&) const { return Fix{"Y = 1 MPa", {{"youngs_modulus", "1e6"}}}; }

std::vector<std::pair<std::string, std::string>> StressStrainLesson::finer() const {
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, static_cast<Index>(resolution.accepted().max)))}};
}

const Registration<StressStrainLesson> registration{
    {.id = "elasticity/stress_strain",
     .title = "Stress and strain",
     .summary = "Put a weight on a disc, pull a rod, cut a block in thought: force over area, change over length.",
     .demo_steps = 1}};

}  // namespace pliant::stress_strain
