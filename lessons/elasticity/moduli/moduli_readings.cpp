// What the virtual tests show: fields, probes, the stress-strain line, and where the model holds.
#include "moduli.h"

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
             state_array("iterations", "", iterations_),
             state_array("residual", "", residual_)};
    fields = {vector_field("displacement", "u", "m", On::node, displacement_, "from the rest position"),
              vector_field("load", "f", "N", On::node, load_force_, "the traction's share of each node"),
              vector_field("reaction", "r", "N", On::node, reaction_, "K u − f where a support holds the node"),
              vector_field("residual", "f − K u", "N", On::node, residual_force_, "force that the solver has not balanced yet"),
              tensor_field("strain", "ε", "", On::element, strain_, "Cauchy's small strain; negative where compressed"),
              tensor_field("stress", "σ", "Pa", On::element, stress_, "Hooke's law")};
}

void ModuliLesson::declare_probes() {
    probes = {{.name = "force",
               .symbol = "F",
               .unit = "N",
               .help = "that the support holds, summed from the reactions of its nodes",
               .value = [this] { return specimen_->support_force(reaction_); },
               .exact = [this](Real) { return applied() * specimen_->exact_area(); }},
              {.name = "area",
               .symbol = "A",
               .unit = "m²",
               .help = "of the face that the force acts on",
               .value = [this] { return specimen_->area(); },
               .exact = [this](Real) { return specimen_->exact_area(); }},
              {.name = "stress",
               .symbol = "F/A",
               .unit = "Pa",
               .help = "measured force over measured area",
               .value = [this] { return specimen_->support_force(reaction_) / specimen_->area(); },
               .exact = [this](Real) { return applied(); }},
              {.name = "strain",
               .symbol = "ε",
               .unit = "",
               .help = "tension: ΔL/L; shear: sideways shift ΔL over height L; pressure: ΔV/V",
               .value = [this] { return specimen_->strain(displacement_); },
               .exact = [this](Real) { return specimen_->exact_strain(applied()); }},
              {.name = "measured_modulus",
               .symbol = "Y, G, B",
               .unit = "Pa",
               .help = "slope of the best line through the measured points; exact: Y, G = Y/(2(1+ν)), B = Y/(3(1−2ν))",
               .value = [this] { return measured_modulus(); },
               .exact = [this](Real) { return specimen_->exact_modulus(); }},
              {.name = "volume_change",
               .symbol = "ΔV/V",
               .unit = "",
               .help = "mean trace of the strain; tends to 0 as ν tends to ½",
               .value = [this] { return specimen_->volume_change(displacement_); },
               .exact = [this](Real) { return specimen_->exact_volume_change(applied()); }},
              {.name = "transverse_strain",
               .symbol = "Δw/w",
               .unit = "",
               .help = "across the pull: −ν ΔL/L in tension",
               .value = [this] { return specimen_->transverse_strain(displacement_); },
               .exact = [this](Real) { return specimen_->exact_transverse_strain(applied()); }},
              {.name = "strain_energy",
               .symbol = "E",
               .unit = "J",
               .help = "½ ∫ ε : σ dV (the lecture prints it without the ½)",
               .value = [this] { return specimen_->body().strain_energy(displacement_); },
               .exact = [this](Real) { return specimen_->exact_energy(applied()); }},
              {.name = "force_imbalance",
               .symbol = "|F + R|",
               .unit = "N",
               .help = "resultant of all loads and support forces",
               .value = [this] { return force_imbalance(); }},
              {.name = "iterations",
               .symbol = "",
               .unit = "",
               .help = "of conjugate gradients, over all loads",
               .value = [this] { return iterations_[0]; }},
              {.name = "solver_residual",
               .symbol = "|f − K u|/|f|",
               .unit = "",
               .help = "what the solver left at the last load",
               .value = [this] { return residual_[0]; }}};
}

void ModuliLesson::declare_lines() {
    lines = {{.name = "measured_stress",
              .unit = "Pa",
              .position_name = "strain",
              .position_unit = "",
              .help = "one point per load; the slope is the modulus",
              .sample =
                  [this](Curve& curve) {
                      curve.position.assign(strains_.data(), strains_.data() + level() + 1);
                      curve.value.assign(stresses_.data(), stresses_.data() + level() + 1);
                  },
              .reference =
                  [this](Curve& curve) {
                      curve.position.clear(), curve.value.clear();
                      for (Index k = 0; k <= load_levels; ++k) {
                          curve.value.push_back(load * static_cast<Real>(k) / static_cast<Real>(load_levels));
                          curve.position.push_back(specimen_->exact_strain(curve.value.back()));
                      }
                  },
              .reference_name = "Hooke's law",
              .others = {{.name = "neo-Hookean", .sample = [this](Curve& c) { finite_strain_curve(Energy::neo_hookean, c); }},
                         {.name = "St. Venant–Kirchhoff", .sample = [this](Curve& c) { finite_strain_curve(Energy::stvk, c); }}}},
             {.name = "displacement",
              .unit = "m",
              .position_name = "distance from the support",
              .position_unit = "m",
              .help = "u_x along an edge of the block: along the pull or pressure, and up the height in shear",
              .sample =
                  [this](Curve& curve) {
                      curve.position.clear(), curve.value.clear();
                      const int axis = test == Test::shear ? 1 : 0;
                      for (const Index n : specimen_->mesh().nodes("z_max")) {
                          const Vec<3> X = specimen_->mesh().points().col(n);
                          if (X[1 - axis] != 0) continue;
                          curve.position.push_back(X[axis]);
                          curve.value.push_back(displacement_(0, n));
                      }
                  },
              .reference =
                  [this](Curve& curve) {
                      const Real end = test == Test::shear ? width : length;
                      curve.position = {0, end};
                      curve.value = {0, specimen_->exact_displacement(applied(), Vec<3>::Constant(end))[0]};
                  }}};
}

void ModuliLesson::declare_checks() {
    assumptions = {
        {.name = "small strain",
         .unit = "",
         .value = [this] { return strain_.cwiseAbs().maxCoeff(); },
         .limit = [] { return small_strain; },
         .formula = "|ε| ≤ 0.05",
         .broken = "linear strain leaves out ½ ∇uᵀ∇u: lengths and volumes are wrong by more than about 2.5 %, and no real "
                   "material stays linear",
         .fix = [this] { return smaller_load(); }},
        {.name = "compressible enough",
         .unit = "",
         .value = [this] { return Real(poisson_ratio); },
         .limit = [] { return locking_ratio; },
         .formula = "ν ≤ 0.49",
         .broken = "linear tetrahedra lock near ν = ½: these uniform tests stay exact, but bending would be far too stiff, and B "
                   "grows without bound",
         .fix = [this] { return compressible(); }},
        {.name = "solver converged",
         .unit = "",
         .value = [this] { return residual_[0]; },
         .limit = [this] { return std::max<Real>(tolerance, enough_digits); },
         .formula = "|f − K u| ≤ max(τ, 10⁻⁹) |f|",
         .broken = "stopped by max_iterations or by rounding: the measured modulus has about as many digits as the residual",
         .fix = [this] { return more_iterations(); }}};
    conserved = {{.probe = "force_imbalance", .law = Law::zero, .tolerance = [this] {
                      return 1e-6 * std::abs(applied()) * specimen_->unit_load().norm();
                  }}};
}

}  // namespace pliant::moduli
