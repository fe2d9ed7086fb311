#include "energy_density.h"

#include <pliant/continuum/deformation.h>
#include <pliant/continuum/uniaxial.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::energies {
EnergyDensityLesson::EnergyDensityLesson() {
    entries.join(*this, {-1.5, 1.5}, {-10, 10}, "entry of the deformation gradient; column j is where the edge along axis j goes",
                 [this] { return is(Path::free); });
    declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks();
}

// Where the energy is infinite, or no width is left, there is nothing to show.
void EnergyDensityLesson::check() const {
    if (way().at(density(), amount())) return;
    const std::string given_path = is(Path::free) ? fmt::format("det F = {}", format_quantity(entries.matrix().determinant(), ""))
                                                  : fmt::format("stretch = {}", format_quantity(amount(), ""));
    if (is(Energy::corotated))
        throw Refused(
            fmt::format("{} leaves the corotated energy without a width in equilibrium: take a stretch nearer to 1, or "
                        "energy=stvk or linear",
                        given_path));
    if (is(Path::uniaxial) && stretch > 0)
        throw Refused(
            fmt::format("stretch = {} with poisson_ratio = {}: the neo-Hookean energy has no width in equilibrium there; "
                        "take a stretch nearer to 1 or a poisson_ratio from 0 on",
                        format_quantity(stretch, ""), format_quantity(poisson_ratio, "")));
    throw Refused(
        fmt::format("{}: the neo-Hookean energy is infinite where a body is flat or turned inside out, so det F must be "
                    "above 0. The energies linear, stvk and corotated go on",
                    given_path));
}

void EnergyDensityLesson::reset() {
    F_.setIdentity(), rotation_.setIdentity();
    strain_.setZero(), P_.setZero(), difference_.setZero();
    J_[0] = 1, I1_[0] = 3, ln_J_[0] = psi_[0] = 0;
    done_.setZero();
    block_ = has_block() ? std::make_unique<StretchedBlock>(energy, material(), ends, stretch) : nullptr;
    for (Points<3>* nodal : {&displacement_, &direction_, &unbalanced_})
        nodal->setZero(3, corners + (block_ ? block_->mesh().node_count() : 0));
}

// ------------------------------------------------------------------------------------------------------------ stages

void EnergyDensityLesson::declare_stages() {
    formula_symbols = {{"x", "m"}, {"X", "m"}, {"h"}, {"e"}, {"ε"}, {"E"}, {"S"}, {"μ", "Pa"}, {"λ", "Pa"}, {"K", "N/m"}, {"α"}};
    const auto stage = [this](std::string_view name, std::string_view formula, std::string_view source, auto run,
                              std::vector<std::string_view> reads, std::vector<std::string_view> writes, auto explain,
                              std::optional<Energy> only = {}) {
        Stage s = stage_of(name, formula, source, [this, run] { (this->*run)(); })
                      .maps(std::move(reads), std::move(writes))
                      .because(explain);
        if (only) s.active = [this, wanted = *only] { return is(wanted); };
        stages.push_back(std::move(s));
    };
    using L = EnergyDensityLesson;
    const auto row = [](const Question& q) { return q.component / 3; };
    const auto column = [](const Question& q) { return q.component % 3; };
    const auto strain = [this](const Question& q) -> std::optional<Explanation> { return why_strain(q); };
    const auto psi = [this](const Question&) -> std::optional<Explanation> { return why_psi(); };
    const auto stress = [=, this](const Question& q) -> std::optional<Explanation> { return why_stress(row(q), column(q)); };

    stage("deform", "F = ∂x/∂X:  diag(s, a, a),  s I,  I + γ e₁e₂ᵀ",
          "lecture: elastic deformation; a makes the sides free of stress", &L::deform, {},
          {"deformation_gradient", "displacement", "volume_ratio", "newton_step", "unbalanced_force"},
          [this](const Question& q) { return why_deformed(q); });

    stage("small_strain", "ε = ½ (F + Fᵀ) − I", "lecture: Cauchy's strain", &L::measure_strain, {"deformation_gradient"},
          {"strain"}, strain, Energy::linear);
    stage("green_strain", "E = ½ (FᵀF − I)", "lecture: Green's strain", &L::measure_strain, {"deformation_gradient"}, {"strain"},
          strain, Energy::stvk);
    stage("polar", "F = R S,  RᵀR = I,  S = Sᵀ", "polar decomposition [Bonet2008 §4.6]", &L::measure_strain,
          {"deformation_gradient"}, {"rotation", "strain"}, strain, Energy::corotated);
    stage("invariants", "I₁ = tr FᵀF,  ln J = ln det F", "invariants of F [Bonet2008 §6.4]", &L::measure_strain,
          {"deformation_gradient", "volume_ratio"}, {"first_invariant", "log_volume"}, strain, Energy::neo_hookean);

    stage("energy_linear", "ψ = μ ε:ε + ½ λ tr(ε)²", "lecture: strain energy density, with the ½ [Sifakis2012 §3.2]",
          &L::evaluate_energy, {"strain"}, {"energy_density"}, psi, Energy::linear);
    stage("energy_stvk", "ψ = μ E:E + ½ λ tr(E)²", "lecture: strain energy density [Sifakis2012 §3.3]", &L::evaluate_energy,
          {"strain"}, {"energy_density"}, psi, Energy::stvk);
    stage("energy_corotated", "ψ = μ |S − I|² + ½ λ tr(S − I)²", "lecture: strain energy density [Sifakis2012 §3.4]",
          &L::evaluate_energy, {"strain"}, {"energy_density"}, psi, Energy::corotated);
    stage("energy_neo_hookean", "ψ = ½ μ (I₁ − 3) − μ ln J + ½ λ (ln J)²", "lecture: strain energy density [Bonet2008 §6.4.3]",
          &L::evaluate_energy, {"first_invariant", "log_volume"}, {"energy_density"}, psi, Energy::neo_hookean);

    stage("stress_linear", "P = ∂ψ/∂F = 2 μ ε + λ tr(ε) I", "[Sifakis2012 §3.2]", &L::evaluate_stress, {"strain"}, {"stress"},
          stress, Energy::linear);
    stage("stress_stvk", "P = ∂ψ/∂F = F (2 μ E + λ tr(E) I)", "[Sifakis2012 §3.3]", &L::evaluate_stress,
          {"deformation_gradient", "strain"}, {"stress"}, stress, Energy::stvk);
    stage("stress_corotated", "P = ∂ψ/∂F = R (2 μ (S − I) + λ tr(S − I) I)", "[Sifakis2012 §3.4]", &L::evaluate_stress,
          {"rotation", "strain"}, {"stress"}, stress, Energy::corotated);
    stage("stress_neo_hookean", "P = ∂ψ/∂F = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ", "[Sifakis2012 §3.6]", &L::evaluate_stress,
          {"deformation_gradient", "log_volume"}, {"stress"}, stress, Energy::neo_hookean);

    stage("derivative_check", "P_ij ≈ (ψ(F + h e_i e_jᵀ) − ψ(F − h e_i e_jᵀ)) / 2h", "central difference", &L::check_derivative,
          {"deformation_gradient"}, {"difference_stress"},
          [=, this](const Question& q) -> std::optional<Explanation> { return why_difference(row(q), column(q)); });

    stage("block", "K d = r,  u ← u + α d", "Newton's method with a line search on a block of tetrahedra [Nocedal2006 §3]",
          &L::block_pass, {"displacement", "unbalanced_force"}, {"newton_step", "displacement", "unbalanced_force"},
          [this](const Question& q) { return why_block(q); });
    stages.back() = stages.back()
                        .when([this] { return has_block(); })
                        .repeats([this] { return block_->running(); }, [this] { begin_block(); });
    // In the order of the stages.
    const std::string_view strain_code = "core/pliant/continuum/strain.h: cauchy_strain",
                           psi_code = "core/pliant/continuum/energy_density.cpp: psi",
                           P_code = "core/pliant/continuum/energy_density.cpp: P";
    std::size_t next = 0;
    for (const std::string_view code :
         {std::string_view("core/pliant/continuum/deformation_path.cpp: DeformationPath::at"), strain_code,
          std::string_view("core/pliant/continuum/strain.h: green_strain"),
          std::string_view("core/pliant/continuum/deformation.cpp: polar_decomposition"),
          std::string_view("lessons/elasticity/energy_density/energy_density.cpp: measure_strain"), psi_code, psi_code, psi_code,
          psi_code, P_code, P_code, P_code, P_code,
          std::string_view("lessons/elasticity/energy_density/energy_density.cpp: check_derivative"),
          std::string_view("core/pliant/solids/newton_equilibrium.cpp: iterate")})
        stages[next++].code = code;
}

void EnergyDensityLesson::begin_block() {
    block_->begin();
    done_[1] = done_[2] = done_[3] = 0;
}

void EnergyDensityLesson::block_pass() {
    block_->iterate();
    const Index nodes = block_->mesh().node_count();
    displacement_.rightCols(nodes) = block_->displacement();
    direction_.rightCols(nodes) = block_->direction();
    unbalanced_.rightCols(nodes) = block_->unbalanced();
    done_[2] = static_cast<Real>(block_->newton().iterations());
    done_[3] = block_->residual();
    if (!block_->running()) done_[1] = 1;
}

void EnergyDensityLesson::deform() {
    F_ = *way().at(density(), amount());
    // The block starts from rest.
    for (Points<3>* nodal : {&displacement_, &direction_, &unbalanced_}) nodal->setZero();
    for (Index n = 0; n < corners; ++n) displacement_.col(n) = F_ * cube_corner(n) - cube_corner(n);
    J_[0] = Mat<3>(F_).determinant();
}

void EnergyDensityLesson::measure_strain() {
    const Mat<3> F = F_, H = F - Mat<3>::Identity();
    switch (Energy(energy)) {
        case Energy::linear:
            strain_ = cauchy_strain<3>(H);
            break;
        case Energy::stvk:
            strain_ = green_strain<3>(H);
            break;
        case Energy::corotated: {
            const auto [R, S] = polar_decomposition<3>(F);
            rotation_ = R;
            strain_ = S - Mat<3>::Identity();
            break;
        }
        case Energy::neo_hookean:
            I1_[0] = F.squaredNorm();
            ln_J_[0] = std::log(J_[0]);
            break;
    }
}

void EnergyDensityLesson::evaluate_energy() { psi_[0] = density().psi(F_); }

void EnergyDensityLesson::evaluate_stress() { P_ = density().P(F_); }

// Small against what F can change by: before a flat body the neo-Hookean energy bends sharply.
Real EnergyDensityLesson::difference_step() const {
    const Real step = 1e-6;
    if (!is(Energy::neo_hookean)) return step;
    return step * std::min<Real>(1, std::abs(principal_stretches<3>(F_).stretches[2]));
}

void EnergyDensityLesson::check_derivative() {
    const EnergyDensity<3> psi = density();
    const Real h = difference_step();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            Mat<3> up = F_, down = F_;
            up(i, j) += h, down(i, j) -= h;
            difference_(i, j) = (psi.psi(up) - psi.psi(down)) / (2 * h);
        }
    done_[0] = 1;
}

// Relative to the largest entry of P, or where there is hardly a stress, to that of a strain of 1/1000.
std::optional<Real> EnergyDensityLesson::derivative_error() const {
    if (done_[0] == 0) return std::nullopt;
    const Real scale = std::max(P_.cwiseAbs().maxCoeff(), 1e-3 * material().mu);
    return (P_ - difference_).cwiseAbs().maxCoeff() / scale;
}

std::vector<std::pair<std::string, Real>> EnergyDensityLesson::dragged(const Pull& pull) const {
    if (pull.index < 0 || pull.index >= corners) return {};
    const Vec<3> X = cube_corner(pull.index);
    if (is(Path::shear))
        return X[1] == 0 ? std::vector<std::pair<std::string, Real>>{}
                         : std::vector{std::pair{std::string("shear"), pull.to[0] - X[0]}};
    if (is(Path::volumetric) && X.sum() > 0) return {{"stretch", pull.to.dot(X) / X.squaredNorm()}};
    if (is(Path::free) && X.sum() == 1) {
        const int column = X[0] == 1 ? 1 : X[1] == 1 ? 2 : 3;
        return {{fmt::format("F1{}", column), pull.to[0]},
                {fmt::format("F2{}", column), pull.to[1]},
                {fmt::format("F3{}", column), pull.to[2]}};
    }
    if ((is(Path::uniaxial) || is(Path::held)) && X[0] == 1) return {{"stretch", pull.to[0]}};
    return {};
}

const Registration<EnergyDensityLesson> registration{
    {.id = "elasticity/energy_density",
     .title = "Energy densities",
     .summary = "Four energies ψ(F) of one cube, the stress that each one means, and where they fail.",
     .demo_steps = 1}};

}  // namespace pliant::energies
