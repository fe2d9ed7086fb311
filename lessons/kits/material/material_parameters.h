// The two numbers of an isotropic elastic material as parameters of a lesson, and what explanations make of them.
#pragma once
#include <pliant/lesson/explanation.h>
#include <pliant/lesson/parameter.h>

namespace pliant {

// Young's modulus Y [Pa] and Poisson's ratio, as every solver accepts them. help: what they mean to the lesson; useful: what its
// sliders span.
ParameterInfo youngs_modulus_info(std::string_view help, Interval useful);
ParameterInfo poisson_ratio_info(std::string_view help, Interval useful);

// Lamé's parameters [Pa] of such a pair, as parts of a formula: "λ" and "μ".
Input lame_lambda(const Parameter& youngs_modulus, const Parameter& poisson_ratio);
Input lame_mu(const Parameter& youngs_modulus, const Parameter& poisson_ratio);

}  // namespace pliant
