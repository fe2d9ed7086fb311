// The time integrators as options of a choice, and the parameters of a step.
#pragma once
#include <pliant/lesson/parameter.h>
#include <pliant/time/scheme.h>

#include <array>
#include <vector>

namespace pliant {

// The first `count` schemes, in the order of the enumeration; 3 are those of the lecture.
inline std::vector<Option> scheme_options(std::size_t count = schemes().size()) {
    std::vector<Option> options;
    for (const SchemeInfo& info : schemes())
        if (options.size() < count) options.push_back({info.key, info.name});
    return options;
}

// Those that solve no equations, as the options of a choice.
inline constexpr std::array explicit_schemes{Scheme::explicit_euler, Scheme::semi_implicit_euler, Scheme::velocity_verlet,
                                             Scheme::runge_kutta_4};
enum class ExplicitScheme { explicit_euler, semi_implicit_euler, velocity_verlet, runge_kutta_4 };
inline Scheme scheme_of(ExplicitScheme chosen) { return explicit_schemes[static_cast<std::size_t>(chosen)]; }
inline std::vector<Option> explicit_scheme_options() {
    std::vector<Option> options;
    for (const Scheme scheme : explicit_schemes) options.push_back({info_of(scheme).key, info_of(scheme).name});
    return options;
}

inline ParameterInfo fixed_time_step(Real initial, Interval useful, Real longest = 10) {
    return log_quantity("time_step", "Δt", "s", initial, useful, {0, longest, true}, "fixed").in(Group::method);
}

inline ParameterInfo newton_tolerance_from(Real initial, std::string_view help) {
    return log_quantity("newton_tolerance", "τ", "", initial, {1e-12, 1e-2}, {1e-14, 1, false, true}, help).in(Group::solver);
}

inline ParameterInfo newton_iterations() {
    return quantity("newton_iterations", "", "", 100, {1, 100}, {1, 10000},
                    "most iterations of a time step; a step that needs more is reported, not accepted")
        .in(Group::solver);
}

}  // namespace pliant
