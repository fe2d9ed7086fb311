// Why the loaded bodies have the numbers that they have.
#include "kits/material/material_parameters.h"
#include "kits/tensors/tensor_why.h"
#include "stress_strain.h"

#include <fmt/format.h>

namespace pliant::stress_strain {
namespace {

std::string name(int row, int column) { return fmt::format("{}{}", axis_name(row), axis_name(column)); }

}  // namespace

linear_body::Hooke StressStrainLesson::hooke() const {
    return {&body_->mesh(), lame_lambda(youngs_modulus, poisson_ratio), lame_mu(youngs_modulus, poisson_ratio)};
}

// --------------------------------------------------------------------------------------------------------------- load

Input StressStrainLesson::applied_stress_input(int row, int column) const {
    if (loading == Load::cut) return Input::of(row != column ? sigma_xy : row == 0 ? sigma_xx : sigma_yy);
    if (loading == Load::rod) return part("σ_xx = F / (w w)", {force, width});
    return part("σ_yy = − m g / (π r²)", {mass, gravity, radius});
}

// The stress on the faces of the body times the node's share of them.
Explanation StressStrainLesson::why_load(const Question& q) const {
    const Mat<3> stress = applied_stress();
    std::vector<std::pair<Input, Input>> terms;
    for (int j = 0; j < 3; ++j) {
        const Real share = body_->loaded_area()(j, q.index);
        if (stress(q.component, j) == 0 || share == 0) continue;
        terms.emplace_back(
            applied_stress_input(q.component, j),
            Input::constant(fmt::format("A_{}", axis_name(j)), share, "m²", "the node's share of the loaded faces, outward"));
    }
    if (terms.empty()) return fixed_value("f = 0: no load acts here");
    return weighted_sum(fmt::format("f_{0} = Σ_j σ_{0}j A_j", axis_name(q.component)),
                        fmt::format("σ_{}j", axis_name(q.component)), "A_j", terms);
}

// ---------------------------------------------------------------------------------------------------------------- cut

Input StressStrainLesson::normal_input(int k) const {
    const std::string symbol = fmt::format("n_{}", axis_name(k));
    return Input::part(symbol, "", {fmt::format("{} = {}(θ)", symbol, k == 0 ? "cos" : "sin"), {why::in_radians("θ", angle)}});
}

Explanation StressStrainLesson::why_traction(const Question& q) const {
    const char* i = axis_name(q.component);
    const auto now = [&](std::string symbol, std::string_view field, int component) {
        return Input::now(std::move(symbol), field, q.index, component);
    };
    if (q.field == "traction")
        return {fmt::format("t_{0} = σ_{0}x n_x + σ_{0}y n_y", i),
                {now("σ_" + name(q.component, 0), "stress", 3 * q.component),
                 now("σ_" + name(q.component, 1), "stress", 3 * q.component + 1), normal_input(0), normal_input(1)}};
    if (q.field == "shear_part")
        return {fmt::format("τ_{0} = t_{0} − N_{0}", i),
                {now(fmt::format("t_{}", i), "traction", q.component), now(fmt::format("N_{}", i), "normal_part", q.component)}};
    if (q.component == 2) return fixed_value("N_z = 0: the normal lies in the plane of x and y");
    return {fmt::format("N_{0} = (t_x n_x + t_y n_y) n_{0}", i),
            {now("t_x", "traction", 0), now("t_y", "traction", 1), normal_input(0), normal_input(1)}};
}

// ------------------------------------------------------------------------------------------------------------- probes

void StressStrainLesson::explain_probes() {
    explain_probe("support_force", [this] {
        std::vector<Input> reactions;
        for (const Index n : body_->mesh().nodes(body_->held_face()))
            reactions.push_back(Input::now(fmt::format("r_{}", n), "reaction", n, body_->axis()));
        const bool upward = loading == Load::disc;
        return sum_of(upward ? "F = Σ_n r_n" : "F = − Σ_n r_n", "r_n", std::move(reactions));
    });
    explain_probe("area", [this] {
        std::vector<Input> areas;
        for (const Index f : body_->mesh().facets(body_->held_face()))
            areas.push_back(
                Input::constant(fmt::format("A_{}", f), body_->mesh().facet_areas().col(f).norm(), "m²", "area of a facet"));
        return sum_of("A = Σ_f A_f", "A_f", std::move(areas));
    });
    explain_probe("traction", [] {
        return Explanation{"|t| = √(σ_n² + τ²)", {Input::now("σ_n", "normal_stress", 0), Input::now("τ", "shear_stress", 0)}};
    });
}

}  // namespace pliant::stress_strain
