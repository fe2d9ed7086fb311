#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pliant {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

// Whole keys whose letters do not say their name.
constexpr std::array names{Pair{"cfl", "Courant number"},
                           Pair{"cells_x", "cells along x"},
                           Pair{"cells_y", "cells along y"},
                           Pair{"cells_z", "cells along z"},
                           Pair{"k_structural", "structural stiffness"},
                           Pair{"k_shear", "shear stiffness"},
                           Pair{"k_bending", "bending stiffness"},
                           Pair{"difference_from_fem", "difference from finite elements"},
                           Pair{"omega", "angular frequency"},
                           Pair{"psi", "energy density"},
                           Pair{"poisson_ratio", "Poisson's ratio"},
                           Pair{"target_poisson", "target Poisson's ratio"},
                           Pair{"x0", "initial position"},
                           Pair{"v0", "initial velocity"},
                           Pair{"v_angle", "angle of v"},
                           Pair{"v_elevation", "elevation of v"},
                           Pair{"operations_c", "operations for C"},
                           Pair{"operations_green", "operations for Green's strain"},
                           Pair{"operations_cauchy", "operations for Cauchy's strain"},
                           Pair{"stretch_from_C", "stretch from C"},
                           Pair{"cauchy_stretch", "stretch by Cauchy's strain"},
                           Pair{"stretch_from_cauchy", "stretch from Cauchy's strain"},
                           Pair{"green_strain", "Green's strain"},
                           Pair{"cauchy_strain", "Cauchy's strain"},
                           Pair{"stress_green", "stress by Green's strain"},
                           Pair{"stress_cauchy", "stress by Cauchy's strain"},
                           Pair{"right_cauchy_green", "right Cauchy–Green tensor"},
                           Pair{"hookes_law", "Hooke's law"},
                           Pair{"hooke", "Hooke's law"},
                           Pair{"strouhal", "Strouhal number"},
                           Pair{"reynolds", "Reynolds number"},
                           Pair{"u_center", "horizontal velocity in the middle"},
                           Pair{"v_center", "vertical velocity in the middle"},
                           Pair{"p = 0 at the surface", "p = 0 at the surface"},
                           Pair{"Q near P", "Q near P"},
                           Pair{"max", "largest value"},
                           Pair{"min", "least value"}};

// Names of people within a key.
constexpr std::array people{Pair{"youngs", "Young's"},    Pair{"hookes", "Hooke's"},        Pair{"poisson", "Poisson"},
                            Pair{"cauchy", "Cauchy"},     Pair{"green", "Green"},           Pair{"newton", "Newton"},
                            Pair{"euler", "Euler"},       Pair{"reynolds", "Reynolds"},     Pair{"courant", "Courant"},
                            Pair{"strouhal", "Strouhal"}, Pair{"lagrangian", "Lagrangian"}, Pair{"jacobi", "Jacobi"},
                            Pair{"taylor", "Taylor"}};

}  // namespace

std::string spoken(std::string_view key) {
    if (const auto known = std::ranges::find(names, key, &Pair::first); known != names.end()) return std::string(known->second);
    std::string text;
    while (!key.empty()) {
        const std::size_t end = std::min(key.find_first_of("_ "), key.size());
        const std::string_view word = key.substr(0, end);
        const auto person = std::ranges::find(people, word, &Pair::first);
        text += person == people.end() ? word : person->second;
        key.remove_prefix(end);
        if (!key.empty()) text += ' ', key.remove_prefix(1);
    }
    return text;
}

// By the noun that the name is about, which stands in front of what says more of it: "operations for C", "iterations used".
std::string_view is_or_are(std::string_view name) {
    constexpr std::array further{" of ", " in ", " on ",   " per ", " along ",   " for ",   " by ",    " from ",
                                 " at ", " to ", " that ", " used", " against ", " after ", " before "};
    for (const std::string_view word : further) name = name.substr(0, name.find(word));
    const bool one = name.ends_with("ss") || name.ends_with("us") || name.ends_with("is");
    return name.ends_with('s') && !one ? "are" : "is";
}

std::string duration_words(double seconds) {
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    return seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

std::string counted(long long count, std::string_view one) {
    const bool hisses = one.ends_with('s') || one.ends_with("sh") || one.ends_with("ch") || one.ends_with('x');
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : hisses ? "es" : "s");
}

}  // namespace pliant
