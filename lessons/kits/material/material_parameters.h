// The two numbers of an isotropic elastic material as parameters of a lesson, and what explanations make of them.
#pragma once
#include <pliant/lesson/explanation.h>
#include <pliant/lesson/parameter.h>

namespace pliant {

// Young's modulus Y [Pa] and Poisson's ratio, as every solver accepts them. help: what they mean to the lesson; useful: what its
// sliders span.
inline ParameterInfo youngs_modulus_info(std::string_view help, Interval useful) {
    return log_quantity("youngs_modulus", "Y", "Pa", 1e6, useful, {1e-6, 1e18}, help).in(Group::material).rebuilds();
}
inline ParameterInfo poisson_ratio_info(std::string_view help, Interval useful) {
    return quantity("poisson_ratio", "ν", "", 0.3, useful, {-1, 0.5, true, true}, help).in(Group::material).rebuilds();
}

// Lamé's parameters [Pa] of such a pair, as parts of a formula: "λ" and "μ".
inline Input lame_lambda(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return part("λ = Y ν / ((1 + ν) (1 − 2 ν))", {youngs_modulus, poisson_ratio});
}
inline Input lame_mu(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return part("μ = Y / (2 (1 + ν))", {youngs_modulus, poisson_ratio});
}

}  // namespace pliant
