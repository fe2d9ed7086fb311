// The time integrators that there are, by name, and the tables of the explicit ones.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <span>
#include <string_view>

namespace pliant {

enum class Scheme {
    explicit_euler,
    semi_implicit_euler,
    implicit_euler,
    velocity_verlet,
    runge_kutta_4,
    implicit_midpoint,
    newmark,
    bdf2
};

struct SchemeInfo {
    Scheme scheme;
    std::string_view key;      // in scene files: "semi_implicit_euler"
    std::string_view name;     // "semi-implicit Euler"
    int order;                 // p where the error of the state at a fixed time falls as dt^p
    bool implicit;             // solves for the end of the step by Newton's method
    int force_evaluations;     // per step, of an explicit scheme; 0 for implicit ones, whose number depends on Newton's method
    std::string_view formula;  // of a step, with a = f/m, and y = (x, v) with y′ = F(y) where both are treated alike
};

// In the order of the enumeration: the lecture's three, then the others.
const std::array<SchemeInfo, 8>& schemes();
const SchemeInfo& info_of(Scheme scheme);
inline bool is_implicit(Scheme scheme) { return info_of(scheme).implicit; }

// An explicit scheme as a Runge–Kutta–Nyström table [Hairer1993 §II.14]. With the accelerations a_j = M^-1 f(X_j, V_j) of its
// stages,
//   X_i = x + c_i dt v + dt^2 sum_{j<i} position_ij a_j,   V_i = v + dt sum_{j<i} velocity_ij a_j,
// and the end of the step is one more such row, with c = 1.
struct NystromRow {
    Real c = 0;                      // of dt v
    std::array<Real, 4> position{};  // of dt^2 a_j
    std::array<Real, 4> velocity{};  // of dt a_j
};

// One row for each force evaluation and a last one for the end of the step. Empty for an implicit scheme.
std::span<const NystromRow> nystrom_table(Scheme scheme);

}  // namespace pliant
