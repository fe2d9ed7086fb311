#include "stress_strain.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::stress_strain {
namespace {

// A body may be flat or long, but its cells must not become needles.
constexpr Real largest_aspect = 1000;

}  // namespace

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
    body_ = std::make_unique<LoadedBody>(loading, material(),
                                         LoadedBodySize{radius, length, width, static_cast<int>(Index(resolution))});
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

// -------------------------------------------------------------------------------------------------------------- stages

void StressStrainLesson::declare_stages() {
    formula_symbols = linear_body::symbols_and({});
    stages = {
        stage_of("apply_load", "f_a = ∫ N_a σ·n dA",
                 "force per area, spread over the nodes by their shape functions [Hughes2000 §2.9]", [this] { apply_load(); })
            .done_in("core/pliant/solids/fem_loads.cpp: add_boundary_stress")
            .maps({}, {"load"})
            .because([this](const Question& q) { return why_load(q); }),
        stage_of("solve", "K u = f", "equilibrium of linear tetrahedra [Hughes2000 §2.7], by factorisation [Davis2006 §4]",
                 [this] { solve(); })
            .done_in("core/pliant/math/sparse_cholesky.cpp: solve")
            .maps({"load"}, {"displacement", "reaction"})
            .because([this](const Question& q) {
                return q.field == "reaction" ? linear_body::why_reaction(body_->problem(), hooke(), q.index, q.component)
                                             : linear_body::why_displacement(body_->problem(), q.index, q.component, false);
            }),
        stage_of("strain", "ε = ½ (∇u + ∇uᵀ)   (ΔL/L along the load)", "lecture: strain is the fractional deformation",
                 [this] { body_->body().strain(displacement_, strain_); })
            .done_in("core/pliant/solids/linear_fem.cpp: element_strain")
            .maps({"displacement"}, {"strain"})
            .because([this](const Question& q) {
                return linear_body::why_strain(body_->mesh(), q.index, q.component / 3, q.component % 3);
            }),
        stage_of("stress", "σ = λ tr(ε) I + 2 μ ε   (F/A along the load)", "lecture: stress is force over area; Hooke's law",
                 [this] {
                     body_->body().stress(displacement_, stress_);
                     done_[0] = loading == Load::cut ? 0 : 1;
                 })
            .done_in("core/pliant/solids/linear_fem.cpp: element_stress")
            .maps({"strain"}, {"stress"})
            .because([this](const Question& q) { return hooke().why_stress(q.index, q.component / 3, q.component % 3); }),
        stage_of("cut", "t = σ·n,  σ_n = n·t,  τ = |t − σ_n n|",
                 "lecture: force per area of a plane of normal n, f = σ·n [TimoshenkoGoodier1970 §10]", [this] { cut(); })
            .done_in("lessons/elasticity/stress_strain/stress_strain.cpp: cut")
            .maps({"stress"}, {"traction", "normal_part", "shear_part"})
            .when([this] { return loading == Load::cut; })
            .because([this](const Question& q) { return why_traction(q); })};
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

std::vector<std::pair<std::string, std::string>> StressStrainLesson::finer() const {
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, static_cast<Index>(resolution.accepted().max)))}};
}

const Registration<StressStrainLesson> registration{
    {.id = "elasticity/stress_strain",
     .title = "Stress and strain",
     .summary = "Put a weight on a disc, pull a rod, cut a block in thought: force over area, change over length.",
     .demo_steps = 1}};

}  // namespace pliant::stress_strain
