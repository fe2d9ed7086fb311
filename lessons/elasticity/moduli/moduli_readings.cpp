// What the machine shows: fields, probes, curves, where its tests hold, and what mends them where they do not.
#include "moduli.h"

#include <pliant/continuum/uniaxial.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::moduli {
namespace {

// Relative residual at which a modulus has more digits than any instrument gives.
constexpr Real enough_digits = 1e-9;
// Linear tetrahedra lock above it wherever the strain is not uniform.
constexpr Real locking_ratio = 0.49;

}  // namespace

void ModuliLesson::declare_fields() {
    state = {state_array("displacement", "m", displacement_),
             state_array("reaction", "N", reaction_),
             state_array("measured_strain", "", strains_),
             state_array("measured_stress", "Pa", stresses_),
             state_array("level", "", level_),
             state_array("solver_iterations", "", iterations_),
             state_array("residual", "", residual_)};
    fields = {vector_field("displacement", "u", "m", On::node, displacement_, "from the rest position"),
              vector_field("load", "f", "N", On::node, load_force_, "the traction's share of each node"),
              vector_field("reaction", "r", "N", On::node, reaction_, "K u − f where a support holds the node"),
              vector_field("residual", "f − K u", "N", On::node, residual_force_, "force that the solver has not balanced yet"),
              tensor_field("strain", "ε", "", On::element, strain_, "Cauchy's small strain; negative where compressed"),
              tensor_field("stress", "σ", "Pa", On::element, stress_, "Hooke's law")};
}

void ModuliLesson::declare_probes() {
    probes = {probe_of("force", "F", "N", "that the support holds, summed from the reactions of its nodes",
                       [this] { return specimen_->support_force(reaction_); })
                  .exactly([this](Real) { return applied() * specimen_->exact_area(); }),
              probe_of("area", "A", "m²", "of the face that the force acts on", [this] { return specimen_->area(); })
                  .exactly([this](Real) { return specimen_->exact_area(); }),
              probe_of("stress", "F/A", "Pa", "measured force over measured area")
                  .formula(*this, "F/A = F / A", {Input::now("F", "force", 0), Input::now("A", "area", 0)})
                  .exactly([this](Real) { return applied(); }),
              probe_of("strain", "ε", "", "tension: ΔL/L; shear: sideways shift ΔL over height L; pressure: ΔV/V",
                       [this] { return specimen_->strain(displacement_); })
                  .exactly([this](Real) { return specimen_->exact_strain(applied()); }),
              probe_of("measured_modulus", "Y, G, B", "Pa",
                       "slope of the best line through the measured points; exact: Y, G = Y/(2(1+ν)), B = Y/(3(1−2ν))",
                       [this] { return measured_modulus(); })
                  .exactly([this](Real) { return specimen_->exact_modulus(); }),
              probe_of("volume_change", "ΔV/V", "", "mean trace of the strain; tends to 0 as ν tends to ½",
                       [this] { return specimen_->volume_change(displacement_); })
                  .exactly([this](Real) { return specimen_->exact_volume_change(applied()); }),
              probe_of("transverse_strain", "Δw/w", "", "across the pull: −ν ΔL/L in tension",
                       [this] { return specimen_->transverse_strain(displacement_); })
                  .exactly([this](Real) { return specimen_->exact_transverse_strain(applied()); }),
              probe_of("strain_energy", "E", "J", "½ ∫ ε : σ dV (the lecture prints it without the ½)",
                       [this] { return specimen_->body().strain_energy(displacement_); })
                  .exactly([this](Real) { return specimen_->exact_energy(applied()); }),
              probe_of("force_imbalance", "|F + R|", "N", "resultant of all loads and support forces",
                       [this] { return force_imbalance(); }),
              probe_of("solver_iterations", "", "", "of conjugate gradients, over all loads", [this] { return iterations_[0]; })
                  .once("iterations"),
              probe_of("solver_residual", "|f − K u|/|f|", "", "what the solver left at the last load",
                       [this] { return residual_[0]; })};
}

void ModuliLesson::declare_lines() {
    lines = {line_of("measured_stress", "Pa", "strain", "", "one point per load; the slope is the modulus",
                     [this](Curve& curve) {
                         curve.position.assign(strains_.data(), strains_.data() + measured_level() + 1);
                         curve.value.assign(stresses_.data(), stresses_.data() + measured_level() + 1);
                     })
                 .against("Hooke's law",
                          [this](Curve& curve) {
                              for (Index k = 0; k <= load_levels; ++k) {
                                  curve.value.push_back(load * static_cast<Real>(k) / static_cast<Real>(load_levels));
                                  curve.position.push_back(specimen_->exact_strain(curve.value.back()));
                              }
                          })
                 .beside({{"neo-Hookean", [this](Curve& c) { finite_strain_curve(Energy::neo_hookean, c); }},
                          {"St. Venant–Kirchhoff", [this](Curve& c) { finite_strain_curve(Energy::stvk, c); }}}),
             line_of("displacement", "m", "distance from the support", "m",
                     "u_x along an edge of the block: along the pull or pressure, and up the height in shear",
                     [this](Curve& curve) {
                         const int axis = test == Test::shear ? 1 : 0;
                         for (const Index n : specimen_->mesh().nodes("z_max")) {
                             const Vec<3> X = specimen_->mesh().points().col(n);
                             if (X[1 - axis] != 0) continue;
                             curve.position.push_back(X[axis]);
                             curve.value.push_back(displacement_(0, n));
                         }
                     })
                 .against("exact", [this](Curve& curve) {
                     const Real end = test == Test::shear ? width : length;
                     curve.position = {0, end};
                     curve.value = {0, specimen_->exact_displacement(applied(), Vec<3>::Constant(end))[0]};
                 })};
}

void ModuliLesson::declare_checks() {
    assumptions = {
        assumption_of(
            "small strain", "", [this] { return strain_.cwiseAbs().maxCoeff(); }, [] { return small_strain; }, "|ε| ≤ 0.05",
            "linear strain leaves out ½ ∇uᵀ∇u: lengths and volumes are wrong by more than about 2.5 %, and no real "
            "material stays linear")
            .otherwise("large strain")
            .mended_by([this] { return smaller_load(); }),
        assumption_of(
            "compressible enough", "", [this] { return Real(poisson_ratio); }, [] { return locking_ratio; }, "ν ≤ 0.49",
            "linear tetrahedra lock near ν = ½: these uniform tests stay exact, but bending would be far too stiff, and B "
            "grows without bound")
            .otherwise("locks near ν = ½")
            .mended_by([this] { return compressible(); }),
        assumption_of(
            "solver converged", "", [this] { return residual_[0]; }, [this] { return std::max<Real>(tolerance, enough_digits); },
            "|f − K u| ≤ max(τ, 10⁻⁹) |f|",
            "stopped by the most iterations allowed or by rounding: the measured modulus has about as many digits as the "
            "residual")
            .otherwise("solver not converged")
            .mended_by([this] { return more_iterations(); })};
    conserved = {{.probe = "force_imbalance", .law = Law::zero, .tolerance = [this] {
                      return 1e-6 * std::abs(applied()) * specimen_->unit_load().norm();
                  }}};
}

// What the same tests measure of a material that knows finite strain, to lay beside the straight line of the linear one.

namespace {

// Of the drawn range of strains, as a multiple of that of the linear test; and the least range, where a curve shows as one.
constexpr Real beyond = 2, least_range = 0.06;
constexpr int samples = 40;

// Force over area at rest [Pa] that holds the block at this strain; empty where the material cannot be held there.
std::optional<Real> stress_at(Test test, const EnergyDensity<3>& energy, Real strain) {
    switch (test) {
        case Test::tension:
            return uniaxial_stress(energy, 1 + strain);
        case Test::shear: {
            Mat<3> F = Mat<3>::Identity();
            F(0, 1) = strain;
            return energy.P(F)(0, 1);
        }
        case Test::pressure: {
            // The strain is the change of volume.
            if (strain <= -1) return std::nullopt;
            return -energy.P(std::cbrt(1 + strain) * Mat<3>::Identity())(0, 0);
        }
    }
    return std::nullopt;
}

}  // namespace

void ModuliLesson::finite_strain_curve(Energy energy, Curve& curve) const {
    const EnergyDensity<3> density(energy, material().lame());
    const Real full = specimen_->exact_strain(load);
    if (full == 0) return;
    const Real end = std::copysign(std::clamp(beyond * std::abs(full), least_range, Real{0.9}), full);
    for (int k = 0; k <= samples; ++k) {
        const Real strain = end * k / samples;
        const auto stress = stress_at(test, density, strain);
        if (!stress || !std::isfinite(*stress)) return;
        curve.position.push_back(strain), curve.value.push_back(*stress);
    }
}

// Which parameters would mend a test, and which make a finer one.

// The strain is proportional to the load.
std::optional<Fix> ModuliLesson::smaller_load() const {
    const Real scale = 0.8 * small_strain / strain_.cwiseAbs().maxCoeff();
    const Real smaller = std::copysign(rounded_down(scale * std::abs(applied()), 2), load);
    return Fix{fmt::format("σ = {}", format_quantity(smaller, "Pa")), {{"load", format_exact(smaller)}}};
}

std::optional<Fix> ModuliLesson::compressible() const { return Fix{"ν = 0.45", {{"poisson_ratio", "0.45"}}}; }

std::optional<Fix> ModuliLesson::more_iterations() const {
    if (solver_->status() != ConjugateGradients::Status::capped) return poisson_ratio > 0.45 ? compressible() : std::nullopt;
    const Real more = std::min(std::max(max_iterations.info.initial, 10 * max_iterations.value()), max_iterations.accepted().max);
    return Fix{fmt::format("{:.0f} iterations", more), {{"max_iterations", format_exact(more)}}};
}

std::optional<Fix> ModuliLesson::fix(const Failure&) const {
    if (poisson_ratio > 0.45) return compressible();
    if (resolution == 1) return std::nullopt;
    const Index coarser = resolution / 2;
    return Fix{fmt::format("n = {}", coarser), {{"resolution", std::to_string(coarser)}}};
}

// A mesh of half the cell size, solved to the last digits.
std::vector<std::pair<std::string, std::string>> ModuliLesson::finer() const {
    const Index most = static_cast<Index>(resolution.accepted().max);
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, most))},
            {"tolerance", format_exact(std::min<Real>(tolerance, 1e-13))},
            {"max_iterations", format_exact(std::max(max_iterations.value(), max_iterations.info.initial))}};
}

}  // namespace pliant::moduli
