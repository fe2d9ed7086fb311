// E6 and E7: what the lectures say of Poisson's ratio, measured on bodies of finite elements.
#include "poisson.h"

#include <pliant/math/line_fit.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>

namespace pliant::poisson {
namespace {

// ΔV/V over ΔL/L of a block that is pulled.
Real volume_per_strain(const char* poisson_ratio) {
    Runner runner(find_lesson("elasticity/moduli"), {{"test", "tension"}, {"poisson_ratio", poisson_ratio}, {"resolution", "2"}});
    runner.step();
    return runner.value("volume_change") / runner.value("strain");
}

// How far Cook's membrane of linear triangles bends in plane strain, Y = 1 Pa and a force of 1 N.
Real deflection(Real poisson_ratio) {
    const CooksMembrane membrane(32);
    const Lame material = IsotropicModuli::from_young_poisson(1, poisson_ratio).lame();
    return membrane.displacement(material, 1)(1, membrane.tip());
}

Finding incompressible_and_locked() {
    const Real soft = volume_per_strain("0.4"), nearly = volume_per_strain("0.49"), almost = volume_per_strain("0.4999");
    const bool vanishes = soft > nearly && nearly > almost && std::abs(almost / (1 - 2 * 0.4999) - 1) < 1e-6;
    const Real locked = converged_membrane.back().deflection / deflection(converged_membrane.back().nu),
               free = converged_membrane.front().deflection / deflection(converged_membrane.front().nu);
    return {.figure = locked,
            .verdict = vanishes && locked > 3 ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format("ΔV/V over ΔL/L is {}, {}, {} at ν = 0.4, 0.49, 0.4999. Cook's membrane of 32 × 32 × 2 linear "
                                "triangles is {} times too stiff at ν = 0.4999, and {} times at ν = 0.3.",
                                format_quantity(soft, "", 3), format_quantity(nearly, "", 3), format_quantity(almost, "", 3),
                                format_quantity(locked, "", 3), format_quantity(free, "", 3))};
}

const ClaimRegistration e6{"E6", incompressible_and_locked};

Real contraction(int increments) {
    Runner runner(find_lesson("elasticity/poisson"), {{"method", "incremental"},
                                                      {"poisson_ratio", "0.3"},
                                                      {"axial_strain", "0.5"},
                                                      {"increments", std::to_string(increments)}});
    runner.step();
    return runner.value("narrowing");
}

// Tetrahedra that follow dε_y = -ν dε_x in ever smaller increments, each on the shape reached so far.
Finding logarithmic_contraction() {
    const Real exact = exact_contraction(0.3, 0.5);
    std::vector<Real> log_steps, log_errors;
    for (const int n : {10, 20, 40}) {
        log_steps.push_back(-std::log(static_cast<Real>(n)));
        log_errors.push_back(std::log(std::abs(contraction(n) - exact)));
    }
    const Real order = fit_line(log_steps, log_errors)->slope;
    // Richardson's extrapolation of a first order error.
    const Real limit = 2 * contraction(40) - contraction(20), left = std::abs(limit / exact - 1);
    const Real one = *strain_of_overestimate(0.3, 0.01), five = *strain_of_overestimate(0.3, 0.05);
    const bool holds = std::abs(order - 1) < 0.2 && left < 1e-3;
    return {
        .figure = order,
        .verdict = holds ? Verdict::qualified : Verdict::refuted,
        .text =
            fmt::format("ν = 0.3, ΔL/L = 0.5: the law gives ΔL'/L = {}, the estimate ν ΔL/L = 0.15, tetrahedra in 40 "
                        "increments {}, extrapolated {}.",
                        format_quantity(exact, "", 5), format_quantity(contraction(40), "", 5), format_quantity(limit, "", 5)),
        .condition = fmt::format("the law is exact where ν holds in each small increment; ν ≈ ΔL'/ΔL is off by 1 % at ΔL/L = {}, "
                                 "and by 5 % at {} (ν = 0.3)",
                                 format_quantity(one, "", 3), format_quantity(five, "", 3))};
}

const ClaimRegistration e7{"E7", logarithmic_contraction};

}  // namespace
}  // namespace pliant::poisson
