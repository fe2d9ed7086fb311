// Formulas in sentences.
#include "typeset/phrases.h"
#include "typeset/sentence.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <string>
#include <vector>

using namespace pliant::viewer;

namespace {

std::vector<std::string> formulas_in(std::string_view sentence) {
    std::vector<std::string> all;
    for (const Phrase& p : phrases_of(sentence))
        if (p.formula) all.push_back(p.text);
    return all;
}

using Texts = std::vector<std::string>;

// As wide as half the type.
struct EvenWidths final : MathMetrics {
    LetterBounds bounds(char32_t, MathFace, float size) const override {
        return {0.5f * size, 0.05f * size, -0.7f * size, 0.45f * size, 0.1f * size};
    }
};

}  // namespace

TEST_CASE("phrases: symbols are formulas with all that signs tie to them") {
    CHECK(formulas_in("The cube of edge L grows by ΔL and narrows by ΔL′.") == Texts{"L", "ΔL", "ΔL′"});
    CHECK(formulas_in("At ν = 0.45, and to ΔL/L = 0.5: it holds.") == Texts{"ν = 0.45", "ΔL/L = 0.5"});
    CHECK(formulas_in("The error is about ½ (1 + ν) ΔL/L.") == Texts{"½ (1 + ν) ΔL/L"});
    CHECK(formulas_in("Forces f_i = k (x_j − x_i) act, with k = 200 N/m.") == Texts{"f_i = k (x_j − x_i)", "k = 200 N/m"});
    CHECK(formulas_in("It falls like exp(−ω t) and |x_ij| stays.") == Texts{"exp(−ω t)", "|x_ij|"});
    CHECK(formulas_in("the area (in m², A = 2 m²) of det F") == Texts{"A = 2 m²", "det F"});
    CHECK(formulas_in("a method (ν = ½) of order Δt²") == Texts{"ν = ½", "Δt²"});
    CHECK(formulas_in("from N = 10 to N = 20, with N springs of 2 N") == Texts{"N = 10", "N = 20", "N"});
    CHECK(formulas_in("½ EA ε² and v·Kx") == Texts{"½ EA ε²", "v·Kx"});
    CHECK(formulas_in("$M x″ = f$: a pulse, M x″ = f: a pulse") == Texts{"M x″ = f", "M x″ = f"});
    CHECK(formulas_in("dε_y = dx/x and so on") == Texts{"dε_y = dx/x"});
}

TEST_CASE("phrases: words, numbers, units and names are none") {
    for (const char* sentence :
         {"A curtain of 25 × 25 masses, 2 % of 20 ms each.", "run A and run B", "I take a step", "3D, and 0.1 m × 0.1 m",
          "Navier–Stokes by splitting: 0.3 · 0.5 = 0.15", "set divergence_after or k_structural", "at 10⁻³ m/s, e.g. 5 kPa",
          "and/or on-off", "", " ", "(a remark)", "1 N s/m², 3 MPa, 10 mN s, 5 kg m", "1.37 m. Each",
          "27 nodes of 37 g, 153 springs", "so many per m, forces in N"})
        CHECK(formulas_in(sentence) == Texts{});
}

TEST_CASE("phrases: what stands between two $ is a formula, and the rest is kept to the letter") {
    CHECK(formulas_in("by $F$ or $a b$") == Texts{"F", "a b"});
    CHECK(formulas_in("costs 5 $ a piece") == Texts{});
    const std::string text = GENERATE("The cube (edge L, ΔL′ = 2) “grows”.", "x", "ν = ", "= ν", "(((", "(x", "|x", "a + b) c",
                                      "½ ½", "\xff ν \xfe", "end: ν; (ν) [ν]!", "two  blanks ν  and", "sin", "2 m 3");
    std::string whole;
    for (const Phrase& p : phrases_of(text)) whole += p.text;
    CHECK(whole == text);
}

TEST_CASE("sentence: lines are as wide as their room, a line of type apart, and lower where a formula hangs down") {
    const EvenWidths even;
    const MathBox one = set_sentence("some words", even, 20);
    CHECK(one.width == 100);
    CHECK(one.above == 16);
    CHECK(one.height() == 20);
    const MathBox lines = set_sentence("some words\nand more of them", even, 20);
    CHECK(lines.height() == 40);
    const std::string text = "The cube of edge L grows by ΔL = 0.5 m and $a + b$ narrows by x_i.";
    const float room = GENERATE(400.f, 250.f, 160.f);
    const MathBox box = set_sentence(text, even, 20, room);
    CHECK(box.width <= room);
    CHECK(box.height() >= set_sentence(text, even, 20).height());
    // Where a formula has no room in a line it is broken before a relation.
    const MathBox broken = set_sentence("k = EA/Δs = 20 N/m = 200 N/m", even, 20, 150);
    CHECK(broken.width <= 150);
    CHECK(broken.height() <= 64);
}
