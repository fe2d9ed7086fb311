// What the lecture says of springs as cloth, measured.
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace pliant::cloth {
namespace {

// Drape coefficients of fabrics lie within these [Chu1950, Cusick1968].
constexpr Real limp = 0.3, stiff = 0.9;
// Stretch of a hanging cloth that nobody sees, and of rubber.
constexpr Real cloth_stretch = 0.03, rubber_stretch = 0.1;

struct Drape {
    Real coefficient, stretch;
};

// The drape test of a metre of cotton's weight, with well damped springs, four seconds after it was let go: what is seen from
// above changes by less than 0.02 afterwards.
Drape drape_of(Index nodes, Real k_structural, Real k_bending) {
    Runner runner(find_lesson("mesh/cloth"), {{"scene", "pedestal"},
                                              {"nodes", std::to_string(nodes)},
                                              {"damping", "0.03"},
                                              {"linear_iterations", "30"},
                                              {"k_structural", fmt::format("{}", k_structural)},
                                              {"k_shear", fmt::format("{}", k_structural / 10)},
                                              {"k_bending", fmt::format("{}", k_bending)}});
    for (int k = 0; k < 240; ++k) runner.step();
    const auto two_digits = [](Real x) { return std::round(100 * x) / 100; };
    return {two_digits(runner.value("drape_coefficient")), two_digits(runner.value("largest_strain"))};
}

std::string sentence(const char* name, Real k_structural, Real k_bending, const Drape& drape) {
    return fmt::format("{} ({} and {} N/m): {:.0f} % of its overhang is seen from above, stretch {:.0f} %", name, k_structural,
                       k_bending, 100 * drape.coefficient, 100 * drape.stretch);
}

Finding strong_and_weak() {
    constexpr Index coarse = 11, fine = 31;
    // The bending springs of a smooth fold push back as k l⁴ per area, l the edge: those of a net three times as fine need 3⁴ k.
    const Real kept = std::pow(Real(fine - 1) / Real(coarse - 1), 4);
    const Drape cloth = drape_of(coarse, 1000, 1), softer = drape_of(coarse, 1000, 10), cardboard = drape_of(coarse, 1000, 1000),
                rubber = drape_of(coarse, 10, 10);
    const Drape limper = drape_of(fine, 1000, 1), stiffened = drape_of(fine, 1000, kept), folded = drape_of(fine, 1000, 1000);
    const auto fabric = [](const Drape& d) {
        return d.coefficient >= limp && d.coefficient <= stiff && d.stretch <= cloth_stretch;
    };
    const bool drapes = fabric(cloth) && fabric(softer) && cloth.coefficient <= softer.coefficient;
    const bool others_do_not =
        cardboard.coefficient > softer.coefficient + 0.1 && rubber.stretch > rubber_stretch && rubber.coefficient < limp;
    const bool on_any_net = fabric(limper) && folded.coefficient > cardboard.coefficient - 0.1;
    return {.figure = cloth.coefficient,
            .verdict = !drapes || !others_do_not || !fabric(stiffened) ? Verdict::refuted
                       : on_any_net                                    ? Verdict::reproduced
                                                                       : Verdict::qualified,
            .text = sentence("Strong threads, weak bending", 1000, 1, cloth) + "; " +
                    sentence("ten times the bending", 1000, 10, softer) + ". Equally strong springs make " +
                    sentence("cardboard", 1000, 1000, cardboard) + "; equally weak ones " + sentence("rubber", 10, 10, rubber) +
                    ".",
            .condition =
                fmt::format("on this net of {0} × {0} nodes. What a spring does against bending falls with the fourth power of "
                            "the edge: on {1} × {1} nodes the same springs are limper than any fabric, {2:.0f} %, and even equal "
                            "ones drape, {3:.0f} %; with bending springs {4:.0f} times as stiff it is cloth again, {5:.0f} %",
                            coarse, fine, 100 * limper.coefficient, 100 * folded.coefficient, kept, 100 * stiffened.coefficient)};
}

const ClaimRegistration m11{"M11", strong_and_weak};

}  // namespace
}  // namespace pliant::cloth
