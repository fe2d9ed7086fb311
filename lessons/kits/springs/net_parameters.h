// Parameters that nets of springs share, with the words of the field.
#pragma once
#include <pliant/lesson/parameter.h>
#include <pliant/solids/springs.h>

namespace pliant::springs {

inline ParameterInfo gravity_downwards() {
    return quantity("gravity", "g", "m/s²", 9.81, {0, 20}, {0, 1e6}, "acceleration of gravity, downwards").in(Group::forces);
}

inline ParameterInfo stiffness_of(std::string_view key, std::string_view symbol, Real initial, Interval useful,
                                  std::string_view help) {
    return log_quantity(key, symbol, "N/m", initial, useful, {0, 1e15}, help).in(Group::material);
}

inline ParameterInfo damper(Real initial, Interval useful, std::string_view help) {
    return log_quantity("damping", "kᵈ", "N s/m", initial, useful, {0, 1e12}, help).in(Group::material);
}

inline ParameterInfo pull_stiffness_from(Real initial, Interval useful) {
    return log_quantity("pull_stiffness", "kₕ", "N/m", initial, useful, {0, 1e12},
                        "of the spring of length 0 from a node to the pointer that pulls it")
        .in(Group::view);
}

inline ParameterInfo damping_choice() {
    return setting_of("damping_mode", "which relative velocity of a spring's ends is damped", SpringDamping::projected)
        .in(Group::material);
}
inline std::vector<Option> damping_options() {
    return {{"none", "none"}, {"naive", "naive: kᵈ (vⱼ − vᵢ)"}, {"projected", "projected: along the spring"}};
}

}  // namespace pliant::springs
