#include "material_parameters.h"

namespace pliant {

ParameterInfo youngs_modulus_info(std::string_view help, Interval useful) {
    return {.key = "youngs_modulus",
            .symbol = "Y",
            .unit = "Pa",
            .help = help,
            .initial = 1e6,
            .useful = useful,
            .accepted = Interval{1e-6, 1e18},
            .scale = Scale::log,
            .effect = Effect::rebuild};
}

ParameterInfo poisson_ratio_info(std::string_view help, Interval useful) {
    return {.key = "poisson_ratio",
            .symbol = "ν",
            .help = help,
            .initial = 0.3,
            .useful = useful,
            .accepted = Interval{-1, 0.5, true, true},
            .effect = Effect::rebuild};
}

Input lame_lambda(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return Input::part(
        "λ", "Pa", {.formula = "λ = Y ν / ((1 + ν) (1 − 2 ν))", .inputs = {Input::of(youngs_modulus), Input::of(poisson_ratio)}});
}

Input lame_mu(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return Input::part("μ", "Pa",
                       {.formula = "μ = Y / (2 (1 + ν))", .inputs = {Input::of(youngs_modulus), Input::of(poisson_ratio)}});
}

}  // namespace pliant
