// Why nodes, supports, elements and instruments have the numbers that they have.
#include "kits/material/material_parameters.h"
#include "moduli.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::moduli {
// --------------------------------------------------------------------------------------------------------------- load

Input ModuliLesson::applied_stress() const {
    return part("t = σ k / m", {load, Input::constant("k", level_[0], "", "number of this load"), load_levels});
}

Explanation ModuliLesson::why_load(Index node, int component) const {
    const Real share = specimen_->unit_load()(component, node);
    if (share == 0) return fixed_value("f = 0: no load pulls here");
    return {"f = t A",
            {applied_stress(), Input::constant("A", share, "m²", "the node's share of the loaded faces, and their side")}};
}

// -------------------------------------------------------------------------------------------------------------- solve

std::optional<Explanation> ModuliLesson::why_solved(const Question& q) const {
    // A test that is over changes nothing; the supports are looked at when the solver has ended.
    const bool of_reaction = q.field == "reaction";
    if (!advancing_ || (of_reaction && solver_->running())) return std::nullopt;
    if (of_reaction) return linear_body::why_reaction(specimen_->problem(), hooke(), q.index, q.component);
    return q.field == "residual" ? linear_body::why_residual(specimen_->problem(), q.index, q.component)
                                 : linear_body::why_displacement(specimen_->problem(), q.index, q.component, true);
}

// ------------------------------------------------------------------------------------------------- strain and stress

linear_body::Hooke ModuliLesson::hooke() const {
    return {&specimen_->mesh(), lame_lambda(youngs_modulus, poisson_ratio), lame_mu(youngs_modulus, poisson_ratio)};
}

Explanation ModuliLesson::why_strain_or_stress(const Question& q) const {
    const int row = q.component / 3, column = q.component % 3;
    return q.field == "strain" ? linear_body::why_strain(specimen_->mesh(), q.index, row, column)
                               : hooke().why_stress(q.index, row, column);
}

// Why the instruments read what they read.

namespace {

Eigen::Map<const Points<3>> points(std::span<const Real> x) { return {x.data(), 3, static_cast<Index>(x.size() / 3)}; }

}  // namespace

void ModuliLesson::explain_probes() {
    explain_probe("force", [this] { return why_force(); });
    explain_probe("area", [this] { return why_area(); });
    explain_probe("strain", [this] { return why_specimen_strain(); });
    explain_probe("measured_modulus", [this] { return why_modulus(); });
    explain_probe("volume_change", [this] { return why_volume_change("ΔV/V"); });
    explain_probe("transverse_strain", [this] { return why_lengthening("Δw/w", "z", 2, width); });
    explain_probe("strain_energy", [this] { return why_strain_energy(); });
}

Explanation ModuliLesson::why_force() const {
    std::vector<Input> reactions;
    for (const Index n : specimen_->mesh().nodes(specimen_->support_face()))
        reactions.push_back(Input::now(fmt::format("r_{}", n), "reaction", n, 0));
    const bool pushed = test == Test::pressure;
    return sum_of(pushed ? "F = Σ_n r_n" : "F = − Σ_n r_n", "r_n", std::move(reactions));
}

Explanation ModuliLesson::why_area() const {
    const SimplexMesh<3>& mesh = specimen_->mesh();
    std::vector<Input> areas;
    for (const Index f : mesh.facets(specimen_->support_face()))
        areas.push_back(Input::constant(fmt::format("A_{}", f), mesh.facet_areas().col(f).norm(), "m²", "area of a facet"));
    return sum_of("A = Σ_f A_f", "A_f", std::move(areas));
}

// How far two opposite faces have moved apart, over what lies between them: a face moves by the mean of its nodes.
Explanation ModuliLesson::why_lengthening(std::string_view symbol, std::string_view across, int component,
                                          const Parameter& over) const {
    const auto mean = [&](const char* end) {
        std::vector<std::pair<Input, Input>> terms;
        for (const auto& [node, weight] : specimen_->mean_weights(fmt::format("{}_{}", across, end).c_str()))
            terms.emplace_back(Input::constant(fmt::format("w_{}", node), weight, "", "share of the face's area"),
                               Input::now(fmt::format("u_{}", node), "displacement", node, component));
        return Input::part(fmt::format("ū_{}", end), "m",
                           weighted_sum(fmt::format("ū_{} = Σ_n w_n u_n", end), "w_n", "u_n", terms));
    };
    return {fmt::format("{} = (ū_max − ū_min) / {}", symbol, over.info.symbol), {mean("max"), mean("min"), over}};
}

Explanation ModuliLesson::why_specimen_strain() const {
    if (test == Test::tension) return why_lengthening("ε", "x", 0, length);
    if (test == Test::shear) return why_lengthening("ε", "y", 0, width);
    return why_volume_change("ε");
}

// The volume that the surface sweeps; nodes inside add nothing.
Explanation ModuliLesson::why_volume_change(std::string_view symbol) const {
    const SimplexMesh<3>& mesh = specimen_->mesh();
    Points<3> weight = Points<3>::Zero(3, mesh.node_count());
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        for (int a = 0; a < 4; ++a)
            weight.col(mesh.simplices()(a, e)) += mesh.volumes()[e] / mesh.volume() * mesh.gradients(e).col(a);
    const Real rounding = 1e-13 * weight.cwiseAbs().maxCoeff();
    std::vector<std::pair<Input, Input>> terms;
    for (Index n = 0; n < mesh.node_count(); ++n)
        for (int c = 0; c < 3; ++c)
            if (std::abs(weight(c, n)) > rounding) {
                const char* letter = axis_name(c);
                terms.emplace_back(Input::constant(fmt::format("A{}_{}/V", letter, n), weight(c, n), "1/m",
                                                   "share of the surface, over the volume"),
                                   Input::now(fmt::format("u{}_{}", letter, n), "displacement", n, c));
            }
    return weighted_sum(fmt::format("{} = Σ_n a_n u_n, a_n = A_n/V", symbol), "a_n", "u_n", terms);
}

// Least squares through the points of all loads so far.
Explanation ModuliLesson::why_modulus() const {
    constexpr std::array<const char*, 3> symbols{"Y", "G", "B"};
    const char* symbol = symbols[static_cast<std::size_t>(test.value())];
    if (measured_level() == 0) return fixed_value(fmt::format("{} = 0: a line needs two loads", symbol));
    std::vector<Input> strains, points_of_line;
    for (Index k = 0; k <= measured_level(); ++k) {
        strains.push_back(Input::constant(fmt::format("ε_{}", k), strains_[k], "", "strain measured at this load").in("ε_k"));
        points_of_line.push_back(strains.back());
        points_of_line.push_back(
            Input::constant(fmt::format("σ_{}", k), stresses_[k], "Pa", "stress measured at this load").in("σ_k"));
    }
    return {fmt::format("{} = {}S / Q", symbol, test == Test::pressure ? "− " : ""),
            {part("S = Σ_k (ε_k − mean ε_k) (σ_k − mean σ_k)", std::move(points_of_line)),
             part("Q = Σ_k (ε_k − mean ε_k)²", std::move(strains))}};
}

Explanation ModuliLesson::why_strain_energy() const {
    const SimplexMesh<3>& mesh = specimen_->mesh();
    Explanation e{"E = ½ λ T(u_n) + μ D(u_n), T = Σ V tr(ε)², D = Σ V ε:ε of the displacements of all nodes",
                  {hooke().lambda, hooke().mu}};
    for (Index n = 0; n < mesh.node_count(); ++n)
        for (int c = 0; c < 3; ++c)
            e.inputs.push_back(Input::now(fmt::format("u{}_{}", axis_name(c), n), "displacement", n, c).in("u_n"));
    const auto summed = [&mesh](Real (*of_strain)(const Mat<3>&)) {
        return [&mesh, of_strain](Values u) {
            Real sum = 0;
            for (Index k = 0; k < mesh.simplex_count(); ++k)
                sum += mesh.volumes()[k] * of_strain(cauchy_strain<3>(mesh.field_gradient(k, points(u))));
            return sum;
        };
    };
    return std::move(e)
        .by("T(u)", "m³", summed([](const Mat<3>& strain) { return strain.trace() * strain.trace(); }))
        .by("D(u)", "m³", summed([](const Mat<3>& strain) { return strain.squaredNorm(); }));
}

}  // namespace pliant::moduli
