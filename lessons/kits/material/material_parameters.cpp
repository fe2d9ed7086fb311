#include "material_parameters.h"

namespace pliant {

ParameterInfo youngs_modulus_info(std::string_view help, Interval useful) {
    return log_quantity("youngs_modulus", "Y", "Pa", 1e6, useful, {1e-6, 1e18}, help).rebuilds();
}

ParameterInfo poisson_ratio_info(std::string_view help, Interval useful) {
    return quantity("poisson_ratio", "ν", "", 0.3, useful, {-1, 0.5, true, true}, help).rebuilds();
}

Input lame_lambda(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return part("λ = Y ν / ((1 + ν) (1 − 2 ν))", {youngs_modulus, poisson_ratio});
}

Input lame_mu(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return part("μ = Y / (2 (1 + ν))", {youngs_modulus, poisson_ratio});
}

}  // namespace pliant
