// Why nodes, supports and elements have the numbers that they have.
#include "moduli.h"

#include "elasticity/material/material_parameters.h"

namespace pliant::moduli {

// --------------------------------------------------------------------------------------------------------------- load

Input ModuliLesson::applied_stress() const {
    return Input::part(
        "t", "Pa",
        {.formula = "t = σ k / m",
         .inputs = {Input::of(load), Input::constant("k", level_[0], "", "number of this load"), Input::of(load_levels)}});
}

Explanation ModuliLesson::why_load(Index node, int component) const {
    const Real share = specimen_->unit_load()(component, node);
    if (share == 0) return fixed_value("f = 0: no load pulls here", 0);
    return {
        .formula = "f = t A",
        .inputs = {applied_stress(), Input::constant("A", share, "m²", "the node's share of the loaded faces, and their side")}};
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

}  // namespace pliant::moduli
