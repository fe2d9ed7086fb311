// What the lecture says of springs as cloth, measured.
#include <pliant/lesson/runner.h>
#include <pliant/study/claims.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace pliant::cloth {
namespace {

// Drape coefficients of fabrics lie within these [Chu1950, Cusick1968].
constexpr Real limp = 0.3, stiff = 0.9;
// Stretch of a hanging cloth that nobody sees, and of rubber.
constexpr Real cloth_stretch = 0.03, rubber_stretch = 0.1;

struct Drape {
    Real coefficient, stretch;
};

// The drape test of a metre of cotton's weight, two seconds after it was let go, with well damped springs.
Drape drape_of(Real k_structural, Real k_bending) {
    Runner runner(find_lesson("mesh/cloth"), {{"scene", "pedestal"},
                                              {"nodes", "11"},
                                              {"damping", "0.03"},
                                              {"linear_iterations", "30"},
                                              {"k_structural", fmt::format("{}", k_structural)},
                                              {"k_shear", fmt::format("{}", k_structural / 10)},
                                              {"k_bending", fmt::format("{}", k_bending)}});
    for (int k = 0; k < 120; ++k) runner.step();
    const auto value = [&](std::string_view probe) { return runner.value(runner.lesson().probe(probe)).value(); };
    const auto two_digits = [](Real x) { return std::round(100 * x) / 100; };
    return {two_digits(value("drape_coefficient")), two_digits(value("largest_stretch"))};
}

std::string sentence(const char* name, Real k_structural, Real k_bending, const Drape& drape) {
    return fmt::format("{} ({} and {} N/m): {:.0f} % of its overhang is seen from above, stretch {:.0f} %", name, k_structural,
                       k_bending, 100 * drape.coefficient, 100 * drape.stretch);
}

Finding strong_and_weak() {
    const Drape cloth = drape_of(1000, 1), softer = drape_of(1000, 10), cardboard = drape_of(1000, 1000),
                rubber = drape_of(10, 10);
    const bool drapes = cloth.coefficient >= limp && softer.coefficient <= stiff && cloth.stretch <= cloth_stretch &&
                        softer.stretch <= cloth_stretch && cloth.coefficient <= softer.coefficient;
    const bool others_do_not =
        cardboard.coefficient > softer.coefficient + 0.1 && rubber.stretch > rubber_stretch && rubber.coefficient < limp;
    return {.figure = cloth.coefficient,
            .verdict = drapes && others_do_not ? Verdict::reproduced : Verdict::refuted,
            .text = sentence("Strong threads, weak bending", 1000, 1, cloth) + "; " +
                    sentence("ten times the bending", 1000, 10, softer) + ". Equally strong springs make " +
                    sentence("cardboard", 1000, 1000, cardboard) + "; equally weak ones " + sentence("rubber", 10, 10, rubber) +
                    "."};
}

const ClaimRegistration m11{
    {.id = "M11",
     .lesson = "mesh/cloth",
     .statement = "Strong stretching with weak bending resistance makes springs good for cloth.",
     .source = "U, T: mass–spring systems, structural and bending springs",
     .experiment =
         "The drape test of fabrics on a square of 11 × 11 nodes, 1 m and 0.2 kg, whose middle lies on a disc: how much of the "
         "overhang is seen from above, and how far threads stretch, for four pairs of stiffnesses.",
     .figure = "drape coefficient with threads 1000 times as stiff as bending",
     .criterion = "0.3 to 0.9 as for fabrics, with stretch ≤ 3 %; equal stiffness misses one of both",
     .question = "Of a sheet of springs, structural and bending ones are given the same stiffness. What does it behave like?",
     .answers = {"cloth", "cardboard if strong, rubber if weak", "cloth if weak", "paper whatever it is"},
     .right_answer = 1,
     .scene = {{"scene", "pedestal"}, {"damping", "0.03"}},
     .measure = strong_and_weak}};

}  // namespace
}  // namespace pliant::cloth
