#include "moduli.h"

#include <pliant/math/line_fit.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::moduli {
namespace {

// The block may be a thin plate or a long bar, but its cells must not become needles.
constexpr Real largest_aspect = 1000;

}  // namespace

void ModuliLesson::check() const {
    material();
    const Real aspect = length / width;
    if (aspect > largest_aspect || aspect < 1 / largest_aspect)
        throw Refused(fmt::format("length = {} m and width = {} m do not go together: give a length / width in [{}, {}]",
                                  Real(length), Real(width), 1 / largest_aspect, largest_aspect));
}

void ModuliLesson::reset() {
    specimen_ = std::make_unique<Specimen>(test, material(), SpecimenSize{length, width, static_cast<int>(Index(resolution))});
    const SparseMatrix& K = specimen_->problem().system().matrix();
    solver_ = std::make_unique<ConjugateGradients>(K.rows(), product_with(K), incomplete_cholesky_preconditioner(K),
                                                   ConjugateGradients::Settings{tolerance, max_iterations});
    right_side_ = first_guess_ = residual_vector_ = VecX::Zero(K.rows());

    for (Points<3>* nodal : {&displacement_, &reaction_, &load_force_, &residual_force_})
        nodal->setZero(3, specimen_->mesh().node_count());
    for (Tensors<3>* tensors : {&strain_, &stress_}) tensors->setZero(9, specimen_->mesh().simplex_count());
    strains_ = stresses_ = VecX::Zero(load_levels + 1);
    level_.setZero();
    iterations_.setZero();
    residual_.setZero();
}

// ------------------------------------------------------------------------------------------------------------ stages

void ModuliLesson::declare_stages() {
    formula_symbols = linear_body::symbols_and(
        {{"t", "Pa"}, {"k"}, {"α"}, {"p", "m"}, {"z", "m"}, {"G", "Pa"}, {"B", "Pa"}, {"P", "Pa"}, {"V", "m³"}});
    stages = {
        stage_of("apply_load", "f_a = ∫ N_a t dA,  t = (k/m) σ n",
                 "traction spread over the nodes by their shape functions [Hughes2000 §2.9]", [this] { apply_load(); })
            .done_in("core/pliant/solids/fem_loads.cpp: add_boundary_stress")
            .maps({}, {"load"})
            .because([this](const Question& q) { return why_load(q.index, q.component); }),
        stage_of("solve", "K u = f:  u ← u + α p,  α = r·z / (p·Kp)",
                 "conjugate gradients, preconditioned with incomplete Cholesky [Shewchuk1994 §B3]", [this] { solve_pass(); })
            .done_in("core/pliant/math/conjugate_gradients.cpp: ConjugateGradients::iterate")
            .maps({"load", "displacement"}, {"displacement", "residual", "reaction"})
            .repeats([this] { return advancing_ && solver_->running(); }, [this] { begin_solve(); }, [this] { end_solve(); })
            .because([this](const Question& q) { return why_solved(q); }),
        stage_of("strain_and_stress", "ε = ½ (∇u + ∇uᵀ),  σ = λ tr(ε) I + 2 μ ε", "lecture: strain and stress, Hooke's law",
                 [this] { strain_and_stress(); })
            .done_in("core/pliant/solids/linear_fem.cpp: element_strain, element_stress")
            .maps({"displacement"}, {"strain", "stress"})
            .because([this](const Question& q) { return why_strain_or_stress(q); }),
        stage_of("fit_modulus", "modulus = slope of stress over strain:  Y = (F/A)/(ΔL/L),  G = (F/A)/(ΔL/L),  B = −ΔP/(ΔV/V)",
                 "lecture: Young's, shear and bulk modulus (which prints B without the sign)", [this] { fit_modulus(); })
            .done_in("core/pliant/math/line_fit.cpp: fit_line")
            .maps({"displacement", "reaction"}, {"measured_modulus"})
            .loops_from("apply_load", [this] { return level() < load_levels; })};
}

// The next load; after the full one nothing is left to do.
void ModuliLesson::apply_load() {
    advancing_ = !at_rest();
    level_[0] = static_cast<Real>(std::min<Index>(level() + 1, load_levels));
    load_force_ = applied() * specimen_->unit_load();
}

// Starts from the displacement under the load before.
void ModuliLesson::begin_solve() {
    if (!advancing_) return;
    const StaticProblem<3>& problem = specimen_->problem();
    problem.right_side(load_force_, right_side_);
    problem.system().reduce(displacement_.reshaped(), first_guess_);
    solver_->begin(right_side_, first_guess_);
}

void ModuliLesson::solve_pass() {
    if (!advancing_) return;
    const Index before = solver_->iterations();
    solver_->iterate();
    iterations_[0] += static_cast<Real>(solver_->iterations() - before);
    residual_[0] = solver_->residual();
    specimen_->problem().displacement(solver_->x(), displacement_);
    // Anew, since the solver's own is only updated from pass to pass.
    residual_vector_ = right_side_;
    residual_vector_.noalias() -= specimen_->problem().system().matrix() * solver_->x();
    specimen_->problem().spread(residual_vector_, residual_force_);
}

// A residual that the cap on iterations or rounding leaves above the tolerance is told by an assumption.
void ModuliLesson::end_solve() { specimen_->problem().reaction(displacement_, load_force_, reaction_); }

void ModuliLesson::strain_and_stress() {
    specimen_->body().strain(displacement_, strain_);
    specimen_->body().stress(displacement_, stress_);
}

void ModuliLesson::fit_modulus() {
    strains_[level()] = specimen_->strain(displacement_);
    stresses_[level()] = specimen_->support_force(reaction_) / specimen_->area();
}

Index ModuliLesson::measured_level() const {
    const bool measured = level() == 0 || strains_[level()] != 0 || stresses_[level()] != 0;
    return measured ? level() : level() - 1;
}

std::optional<Real> ModuliLesson::measured_modulus() const {
    const auto points = static_cast<std::size_t>(measured_level() + 1);
    const auto fit = fit_line({strains_.data(), points}, {stresses_.data(), points});
    if (!fit) return std::nullopt;
    return test == Test::pressure ? -fit->slope : fit->slope;
}

std::string ModuliLesson::blow_up_hint() const {
    return fmt::format(
        "The body is linear and cannot blow up; the solver met Rayleigh quotients {} apart: lower the resolution or Poisson's "
        "ratio, "
        "or raise tolerance",
        format_quantity(solver_ ? solver_->condition_seen() : 1, ""));
}

const Registration<ModuliLesson> registration{
    {.id = "elasticity/moduli",
     .title = "Young's, shear and bulk modulus",
     .summary = "Pull, shear and squeeze a block of tetrahedra, and read its three moduli off the slope.",
     .demo_steps = 1}};

}  // namespace pliant::moduli
