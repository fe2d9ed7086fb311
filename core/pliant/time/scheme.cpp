#include <pliant/time/scheme.h>

namespace pliant {
namespace {

// Forward Euler: x' = x + dt v, v' = v + dt a [Nealen2006 §2].
constexpr std::array<NystromRow, 2> explicit_euler_rows{{{0, {}, {}}, {1, {}, {1}}}};

// Semi-implicit (symplectic) Euler: v' = v + dt a, x' = x + dt v' [Hairer2006 §I.1.2].
constexpr std::array<NystromRow, 2> semi_implicit_euler_rows{{{0, {}, {}}, {1, {1}, {1}}}};

// Velocity Verlet: a drift with half of the kick, and a kick with the mean of both forces [Hairer2006 §I.1.4]. A force that
// depends on the velocity takes its prediction v + dt a at the end, which keeps the second order.
constexpr std::array<NystromRow, 3> velocity_verlet_rows{{{0, {}, {}}, {1, {0.5}, {1}}, {1, {0.5}, {0.5, 0.5}}}};

// The classical Runge–Kutta scheme, with the velocities of its stages put into its positions [Hairer1993 §II.1].
constexpr std::array<NystromRow, 5> runge_kutta_4_rows{{{0, {}, {}},
                                                        {0.5, {}, {0.5}},
                                                        {0.5, {0.25}, {0, 0.5}},
                                                        {1, {0, 0.5}, {0, 0, 1}},
                                                        {1, {1. / 6, 1. / 6, 1. / 6}, {1. / 6, 1. / 3, 1. / 3, 1. / 6}}}};

}  // namespace

const std::array<SchemeInfo, 8>& schemes() {
    static const std::array<SchemeInfo, 8> all{{
        {Scheme::explicit_euler, "explicit_euler", "explicit Euler", 1, false, 1, "x′ = x + Δt v,  v′ = v + Δt f/m"},
        {Scheme::semi_implicit_euler, "semi_implicit_euler", "semi-implicit Euler", 1, false, 1,
         "v′ = v + Δt f/m,  x′ = x + Δt v′"},
        {Scheme::implicit_euler, "implicit_euler", "implicit Euler", 1, true, 0, "m (v′ − v) = Δt f(x′, v′),  x′ = x + Δt v′"},
        {Scheme::velocity_verlet, "velocity_verlet", "velocity Verlet", 2, false, 2,
         "x′ = x + Δt v + ½ Δt² a,  v′ = v + ½ Δt (a + a′)"},
        {Scheme::runge_kutta_4, "runge_kutta_4", "Runge–Kutta 4", 4, false, 4, "y′ = y + Δt (k₁ + 2 k₂ + 2 k₃ + k₄) / 6"},
        {Scheme::implicit_midpoint, "implicit_midpoint", "implicit midpoint", 2, true, 0, "y′ = y + Δt F(½ (y + y′))"},
        {Scheme::newmark, "newmark", "Newmark (β = ¼, γ = ½)", 2, true, 0,
         "x′ = x + Δt v + ¼ Δt² (a + a′),  v′ = v + ½ Δt (a + a′)"},
        {Scheme::bdf2, "bdf2", "BDF2", 2, true, 0, "y′ = (4 y − y_old + 2 Δt F(y′)) / 3"},
    }};
    return all;
}

const SchemeInfo& info_of(Scheme scheme) { return schemes()[static_cast<std::size_t>(scheme)]; }

std::span<const NystromRow> nystrom_table(Scheme scheme) {
    switch (scheme) {
        case Scheme::explicit_euler:
            return explicit_euler_rows;
        case Scheme::semi_implicit_euler:
            return semi_implicit_euler_rows;
        case Scheme::velocity_verlet:
            return velocity_verlet_rows;
        case Scheme::runge_kutta_4:
            return runge_kutta_4_rows;
        default:
            return {};
    }
}

}  // namespace pliant
