// Formulas as they are set, from any text.
#include <pliant/formula/notation.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace pliant;

namespace {

using Kind = Notation::Kind;

// The letters that are left when all structure is taken away, without blanks.
std::string letters_of(const Notation& n) {
    if (n.kind == Kind::fraction && !n.text.empty()) return n.text;
    std::string all = n.kind == Kind::fence || n.kind == Kind::accent ? "" : n.text;
    for (const Notation& part : n.of) all += letters_of(part);
    return all;
}

int count(const Notation& n, Kind kind) {
    int sum = n.kind == kind ? 1 : 0;
    for (const Notation& part : n.of) sum += count(part, kind);
    return sum;
}

}  // namespace

TEST_CASE("notation: fractions take the factors of their term, or what stands close to the slash") {
    CHECK(latex("Δs = L / N") == "\\Delta s = \\frac{L}{N}");
    CHECK(latex("a + b c / d") == "a + \\frac{b c}{d}");
    CHECK(latex("½ EA/Δs") == "\\tfrac{1}{2} \\frac{EA}{\\Delta s}");
    CHECK(latex("t = (k/m) σ n") == "t = \\left(\\frac{k}{m}\\right) \\sigma n");
    CHECK(latex("(a − b) / 2h") == "\\frac{a - b}{2h}");
    CHECK(latex("r·z / (p·Kp)") == "\\frac{r\\cdot z}{p\\cdot Kp}");
    CHECK(latex("q xᵢⱼ/|xᵢⱼ| / (1/mᵢ + 1/mⱼ)") ==
          "\\frac{q \\frac{x_{ij}}{\\left|x_{ij}\\right|}}{\\frac{1}{m_{i}} + \\frac{1}{m_{j}}}");
    CHECK(latex("y = −a / b") == "y = -\\frac{a}{b}");
    CHECK(latex("∂x/∂s") == "\\frac{\\partial x}{\\partial s}");
    CHECK(latex("y = sin²(κ/2)") == "y = \\sin^{2}\\left(\\frac{\\kappa}{2}\\right)");
}

TEST_CASE("notation: indices, exponents, primes and accents") {
    CHECK(latex("f_i = k (u_left − 2 u_i)") == "f_{i} = k \\left(u_{\\mathrm{left}} - 2 u_{i}\\right)");
    CHECK(latex("w = ½ EA ε²") == "w = \\tfrac{1}{2} EA \\varepsilon^{2}");
    CHECK(latex("v′ = √(a + b)") == "v^{\\prime} = \\sqrt{a + b}");
    CHECK(latex("x_ij") == "x_{ij}");
    CHECK(latex("xᵢ₊₁") == "x_{i+1}");
    CHECK(latex("fᵈ") == "f^{d}");
    CHECK(latex("F⁻ᵀ") == "F^{-T}");
    CHECK(latex("ũ") == "\\tilde{u}");
    CHECK(latex("d\u0303") == "\\tilde{d}");
    CHECK(latex("x̂ᵢⱼ") == "\\hat{x}_{ij}");
    CHECK(latex("E₁₁") == "E_{11}");
    CHECK(latex("x_i_old") == "x_{i,\\mathrm{old}}");
    CHECK(latex("(1 + ΔL/L)^(−ν)") == "\\left(1 + \\frac{\\Delta L}{L}\\right)^{-\\nu}");
    CHECK(latex("10^-3") == "10^{-3}");
}

TEST_CASE("notation: parentheses, bars, norms and matrices") {
    CHECK(latex("y = a − (b − c)") == "y = a - \\left(b - c\\right)");
    CHECK(latex("|x_ij|") == "\\left|x_{ij}\\right|");
    CHECK(latex("½ k (|x_ij| − l)²") == "\\tfrac{1}{2} k \\left(\\left|x_{ij}\\right| - l\\right)^{2}");
    CHECK(latex("|Δv_t| ≤ μ |Δv_n|") == "\\left|\\Delta v_{t}\\right| \\le \\mu \\left|\\Delta v_{n}\\right|");
    CHECK(latex("‖r‖") == "\\left\\|r\\right\\|");
    CHECK(latex("F = [1 γ; 0 1]") == "F = \\begin{bmatrix} 1 & \\gamma \\\\ 0 & 1 \\end{bmatrix}");
    CHECK(latex("M = [a + b c; d e]") == "M = \\begin{bmatrix} a + b & c \\\\ d & e \\end{bmatrix}");
    CHECK(latex("F = [1.04   −0.2;   0   1]") == "F = \\begin{bmatrix} 1.04 & -0.2 \\\\ 0 & 1 \\end{bmatrix}");
    CHECK(latex("A = [c −s; s c]") == "A = \\begin{bmatrix} c & -s \\\\ s & c \\end{bmatrix}");
}

TEST_CASE("notation: words stand upright, letters side by side do not") {
    CHECK(latex("modulus = slope of stress over strain") == "\\text{modulus} = \\text{slope of stress over strain}");
    CHECK(latex("u ← a mean") == "u \\leftarrow a \\ \\text{mean}");
    CHECK(latex("f: a mean") == "f: \\text{a mean}");
    CHECK(latex("tr(ε) I") == "\\operatorname{tr}\\left(\\varepsilon\\right) I");
    CHECK(latex("springs are a rod of EA") == "\\text{springs are a rod of} \\ EA");
    CHECK(latex("Verlet – a ∠R ⟨u⟩ ~ Ẽ") ==
          "\\text{Verlet} \\ \\text{–} a \\angle R \\left\\langle u\\right\\rangle{} \\sim \\tilde{E}");
    CHECK(latex("x −= p") == "x -= p");
    CHECK(latex("dx ≈ F dX") == "dx \\approx F dX");
    CHECK(latex("ε:ε") == "\\varepsilon:\\varepsilon");
    CHECK(latex("explicit: x′ = x") == "\\text{explicit}: x^{\\prime} = x");
    CHECK(count(notation("at a node + k"), Kind::prefix) == 0);
    CHECK(count(notation("Σ − 2u"), Kind::prefix) == 0);
    CHECK(count(notation("by −k"), Kind::prefix) == 1);
    CHECK(latex("−0.5 + 1e-05") == "-0.5 + 1e-05");
}

TEST_CASE("notation: whatever the text, no letter of it is lost") {
    const std::string text =
        GENERATE("", ")", "((", "|", "a |", "/", "a /", "a / ", "_", "x_", "x^", "√", "√(", "Σ", "a_b_c_d", "]x[", "‖a", "a|b|c|",
                 "x ∈ ℝ", "½½⅓", "\xff\xfe", "a ^ b", "1.2.3", "{a; b}", "[a; b c]", "(a]", "≤≥", "𝜓", "f(", "−−−", "a , ; b");
    const Notation n = notation(text);
    std::string expected;
    for (const char c : text)
        if (std::string("()[]{}|_^/ ").find(c) == std::string::npos) expected += c;
    std::string found = letters_of(n);
    // Norms and roots are drawn, and a hyphen is set as a minus.
    CHECK(latex(n).size() >= (expected.empty() ? 0u : 1u));
    for (const std::string drawn : {"√", "‖", ";", ",", "_", "^"})
        for (std::size_t at; (at = expected.find(drawn)) != expected.npos;) expected.erase(at, drawn.size());
    for (const std::string drawn : {"√", "‖", ";", ",", "|", "_", "^", "/", ")", "]", "}"})
        for (std::size_t at; (at = found.find(drawn)) != found.npos;) found.erase(at, drawn.size());
    INFO(text);
    CHECK(found == expected);
}

TEST_CASE("notation: sums are large, remarks stand apart") {
    CHECK(count(notation("f_a − Σ_b K_ab u_b"), Kind::large) == 1);
    CHECK(latex("Σ_b K_ab") == "\\sum_{b} K_{ab}");
    CHECK(count(notation("x = φ(X),  dX = Q − P"), Kind::gap) == 1);
}

TEST_CASE("notation: a text with quantities may begin with an article") {
    CHECK(is_prose(notation("a step multiplies by 2", Numbers::with_units)));
    CHECK_FALSE(is_prose(notation("a in m/s²", Numbers::with_units)));
    CHECK_FALSE(is_prose(notation("a step")));
    CHECK(is_prose(notation("St. Venant–Kirchhoff", Numbers::with_units)));
    CHECK_FALSE(is_prose(notation("Re", Numbers::with_units)));
}

TEST_CASE("notation: units behind numbers stand upright where a text has quantities") {
    const auto upright = [](std::string_view text) { return count(notation(text, Numbers::with_units), Kind::name); };
    CHECK(upright("k = 200 N/m") == 1);
    CHECK(upright("125 nodes of 8 g, 3 springs") == 1);
    CHECK(upright("8 g_c") == 0);
    CHECK(upright("L = 200 mm, 3 kg m") == 2);
    CHECK(upright("10³ mm/s") == 1);
    CHECK(upright("16.7 ms") == 1);
    CHECK(upright("20 N / 100 mm = 3 m²") == 3);
    CHECK(latex(notation("A = 3 m²/s", Numbers::with_units)) == "A = 3 \\mathrm{m}^{2}\\mathrm{/s}");
    CHECK(latex(notation("M = 3.7 N m", Numbers::with_units)) == "M = 3.7 \\mathrm{N m}");
    CHECK(upright("Stress σ [kPa]") == 1);
    CHECK(latex(notation("ψ [10⁶ J/m³]", Numbers::with_units)) == "\\psi \\left[10^{6} \\mathrm{J/m}^{3}\\right]");
    CHECK(latex(notation("J [kg m²/s]", Numbers::with_units)) == "J \\left[\\mathrm{kg m}^{2}\\mathrm{/s}\\right]");
    CHECK(latex(in_line(notation("|a / b| + √(c / d)"))) == "\\left|a/b\\right| + \\sqrt{c/d}");
    CHECK(upright("k m x") == 0);
    CHECK(count(notation("2 m g"), Kind::name) == 0);
}

TEST_CASE("notation: in the line, and what is prose") {
    CHECK(latex(in_line(notation("a b / (c d) + (e + f)/2"))) == "a b/(c d) + (e + f)/2");
    CHECK(is_prose(notation("12 × 12 cells, 3.5 mm/s", Numbers::with_units)));
    CHECK(latex(in_line(notation("20 N / 100 mm", Numbers::with_units))) == "20 \\mathrm{N}/100 \\mathrm{mm}");
    CHECK(is_prose(notation("StVK")));
    CHECK_FALSE(is_prose(notation("N = 10")));
    CHECK_FALSE(is_prose(notation("derived k")));
}
