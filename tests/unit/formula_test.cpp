// Formulas as data: read, evaluated, differentiated, checked for units, and written in LaTeX.
#include <pliant/formula/formula.h>

#include "../fuzz/targets.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct Given {
    std::string symbol;
    Real value = 0;
    std::string unit = "";
};

Formula formula(std::string text, const std::vector<Given>& given) {
    std::vector<FormulaSymbol> symbols;
    for (const Given& one : given) symbols.push_back({one.symbol, Unit(one.unit)});
    return Formula(std::move(text), std::move(symbols));
}

std::vector<Real> values_of(const std::vector<Given>& given) {
    std::vector<Real> values;
    for (const Given& one : given) values.push_back(one.value);
    return values;
}

Real value(std::string text, const std::vector<Given>& given = {}) {
    return formula(std::move(text), given).evaluate(values_of(given));
}

std::string why_not(std::string text, const std::vector<Given>& given = {}) {
    try {
        formula(std::move(text), given);
    } catch (const BadFormula& e) {
        return e.what();
    }
    return "";
}

std::string unit_of(std::string text, const std::vector<Given>& given) {
    const auto check = formula(std::move(text), given).check_units();
    return check.unit ? check.unit->text() : check.mismatch.empty() ? "any" : check.mismatch;
}

}  // namespace

TEST_CASE("formula: precedence, signs and products without a sign") {
    CHECK(value("y = 1 + 2 · 3") == 7);
    CHECK(value("y = (1 + 2) 3") == 9);
    CHECK(value("y = 8 − 2 − 1") == 5);
    CHECK(value("y = 8 / 2 / 2") == 2);
    CHECK(value("y = − 2²") == -4);
    CHECK(value("y = (−2)²") == 4);
    CHECK(value("y = 2 · 3 / 4") == 1.5);
    CHECK(value("y = ½ m v²", {{"m", 3}, {"v", 2}}) == 6);
    CHECK(value("y = 2ν/Δx²", {{"ν", 3}, {"Δx", 2}}) == 1.5);
    CHECK(value("f = k (|x_ij| − l)", {{"k", 2}, {"|x_ij|", 5}, {"l", 1}}) == 8);
    CHECK(value("f = |a − b| c", {{"a", 1}, {"b", 3}, {"c", 5}}) == 10);
    CHECK(value("f = |a| |b|", {{"a", -2}, {"b", -3}}) == 6);
    CHECK(value("y = 10⁻³ · 2") == 2e-3);
    CHECK(value("y = a^−b", {{"a", 2}, {"b", 3}}) == 0.125);
    CHECK(value("y = 4 sin²(κ/2)", {{"κ", 3}}) == 4 * std::sin(1.5) * std::sin(1.5));
    CHECK(value("y = cos θ", {{"θ", 0.5}}) == std::cos(0.5));
    CHECK(value("y = max(a, b, 0)", {{"a", -1}, {"b", 2}}) == 2);
    CHECK(value("y = √(a² + b²)", {{"a", 3}, {"b", 4}}) == 5);
    CHECK(value("y = π r²", {{"r", 2}}) == 4 * std::numbers::pi);
}

TEST_CASE("formula: the longest symbol at a place counts, and names of functions are no symbols") {
    CHECK(value("E = EA ε", {{"EA", 7}, {"E", 100}, {"A", 100}, {"ε", 2}}) == 14);
    CHECK(value("y = x′ − x", {{"x", 1}, {"x′", 5}}) == 4);
    CHECK(value("y = f(x) + f", {{"f(x)", 3}, {"f", 1}}) == 4);
    CHECK(value("y = max(a, m)", {{"a", 1}, {"m", 2}}) == 2);
    CHECK(value("y = u_left − 2 u_i", {{"u_left", 5}, {"u_i", 1}, {"u", 9}}) == 3);
}

TEST_CASE("formula: sides and remarks") {
    const Formula f = formula("y′ = y + v: as the step goes", {{"y", 1}, {"v", 1}});
    CHECK(f.left() == "y′");
    CHECK(f.right() == "y + v");
    CHECK(f.remark() == ": as the step goes");
    CHECK(formula("u = 2   (cell 3)", {}).remark() == "   (cell 3)");
    CHECK(formula("u = 2,  where it is so", {}).right() == "2");
    CHECK(formula("1 + 1", {}).left().empty());
}

TEST_CASE("formula: what cannot be read is refused at its place") {
    CHECK_THAT(why_not("y = a / b c", {{"a"}, {"b"}, {"c"}}), ContainsSubstring("letter 11") && ContainsSubstring("parentheses"));
    CHECK_THAT(why_not("y = a + b", {{"a"}}), ContainsSubstring("letter 9") && ContainsSubstring("no symbol"));
    CHECK_THAT(why_not("y = (1 + 2"), ContainsSubstring("not closed"));
    CHECK_THAT(why_not("y = |1 + 2"), ContainsSubstring("not closed"));
    CHECK_THAT(why_not("y = 1 +"), ContainsSubstring("ends"));
    CHECK_THAT(why_not("y ="), ContainsSubstring("right side"));
    CHECK_THAT(why_not("y = 1 ) 2"), ContainsSubstring("operator"));
    CHECK_THAT(why_not("ε = Δx", {{"Δt"}}), ContainsSubstring("letter 5"));
    CHECK(why_not("y = a / (b c)", {{"a"}, {"b"}, {"c"}}).empty());
    CHECK(why_not("y = a / b · c", {{"a"}, {"b"}, {"c"}}).empty());
}

TEST_CASE("formula: the gradient is that of finite differences") {
    const std::vector<std::pair<std::string, std::vector<Given>>> cases{
        {"y = a b − c / d", {{"a", 1.5}, {"b", -2}, {"c", 3}, {"d", 0.7}}},
        {"y = √(a² + b²) |c|", {{"a", 3}, {"b", 0.4}, {"c", -2}}},
        {"y = sin(a) cos²(b) + exp(−c) ln d", {{"a", 0.3}, {"b", 1.1}, {"c", 0.5}, {"d", 2}}},
        {"y = tan a + asin b + acos b + atan c + sinh a + cosh a + tanh c", {{"a", 0.3}, {"b", 0.2}, {"c", 0.5}}},
        {"y = max(a, b) min(a, b)", {{"a", 3}, {"b", 2}}},
        {"y = a^b + atan2(a, b)", {{"a", 3}, {"b", 2.5}}},
        {"y = log10 a", {{"a", 3}}}};
    for (const auto& [text, given] : cases) {
        CAPTURE(text);
        const Formula f = formula(text, given);
        const std::vector<Real> x = values_of(given), g = f.gradient(x);
        for (std::size_t k = 0; k < x.size(); ++k) {
            constexpr Real h = 1e-6;
            std::vector<Real> above = x, below = x;
            above[k] += h, below[k] -= h;
            CHECK_THAT(g[k], WithinRel((f.evaluate(above) - f.evaluate(below)) / (2 * h), 1e-7));
        }
    }
}

TEST_CASE("formula: units follow from those of the symbols") {
    CHECK(Unit("N") == Unit("kg m/s²"));
    CHECK(Unit("J/m³") == Unit("Pa"));
    CHECK(Unit("1/(m s)") == Unit() / (Unit("m") * Unit("s")));
    CHECK(Unit("cells").is_number());
    CHECK(Unit("N m/rad") == Unit("J"));
    CHECK(Unit("kg m²/s²").text() == "kg m²/s²");
    CHECK(Unit("1/(m s)").text() == "1/(m s)");
    CHECK_THROWS_AS(Unit("furlong"), Refused);
    CHECK_THROWS_AS(Unit("1/(m s"), Refused);
    CHECK(Unit("m²").power(1, 2) == Unit("m"));

    CHECK(unit_of("U = ½ k (x − l)²", {{"k", 1, "N/m"}, {"x", 1, "m"}, {"l", 1, "m"}}) == Unit("J").text());
    CHECK(unit_of("ω = √(k/m)", {{"k", 1, "N/m"}, {"m", 1, "kg"}}) == "1/s");
    CHECK(unit_of("x′ = x + Δt v", {{"x", 1, "m"}, {"Δt", 1, "s"}, {"v", 1, "m/s"}}) == "m");
    CHECK(unit_of("y = max(x, 0)", {{"x", 1, "m"}}) == "m");
    CHECK(unit_of("y = 0", {}) == "any");
    CHECK_THAT(unit_of("x′ = x + v", {{"x", 1, "m"}, {"v", 1, "m/s"}}),
               ContainsSubstring("m and m/s") && ContainsSubstring("x + v"));
    CHECK_THAT(unit_of("y = exp(x)", {{"x", 1, "m"}}), ContainsSubstring("exp of m"));
    CHECK_THAT(unit_of("y = x^x", {{"x", 1, "m"}}), ContainsSubstring("power of m"));
}

TEST_CASE("formula: sine takes degrees where the angle is given in degrees") {
    CHECK_THAT(value("y = sin(φ)", {{"φ", 30, "°"}}), WithinRel(0.5, 1e-15));
    CHECK(value("y = sin(φ)", {{"φ", 30, "rad"}}) == std::sin(30.0));
    CHECK_THAT(formula("y = sin φ", {{"φ", 60, "°"}}).gradient(std::vector<Real>{60})[0],
               WithinRel(0.5 * std::numbers::pi / 180, 1e-12));
    CHECK(value("y = φ π / 180°", {{"φ", 180, "°"}}) == std::numbers::pi);
    CHECK(unit_of("y = φ π / 180°", {{"φ", 30, "°/m"}}) == "1/m");
    CHECK_THAT(unit_of("y = φ + 1", {{"φ", 30, "°"}}), ContainsSubstring("° and a number"));
}

namespace {

// x_i and w_i are families of this size; a is one number.
struct Families {
    std::vector<Real> x, w;
    Real a = 1.5;
    std::vector<FormulaSymbol> symbols{{"x_i", Unit("m"), true}, {"w_i", Unit("kg"), true}, {"a", Unit("m")}};
    std::vector<FormulaNumbers> numbers() const { return {{x.data(), x.size()}, {w.data(), w.size()}, {&a}}; }
    Real value(const std::string& text) const { return Formula(text, symbols).evaluate(numbers()); }
};

}  // namespace

TEST_CASE("formula: sums and extrema over families") {
    const Families f{.x = {1, -4, 2.5}, .w = {2, 3, 5}};
    CHECK(f.value("y = Σ_i w_i x_i") == 2 - 12 + 12.5);
    CHECK(f.value("y = ½ Σ w_i x_i² + a") == (2 + 48 + 31.25) / 2 + 1.5);
    CHECK_THAT(f.value("y = a − Σ_i x_i w_i / a"), WithinRel(1.5 - 2.5 / 1.5, 1e-14));
    CHECK(f.value("y = max_i x_i") == 2.5);
    CHECK(f.value("y = max |x_i|") == 4);
    CHECK(f.value("y = min_i(x_i w_i)") == -12);
    CHECK(f.value("y = mean x_i") == -0.5 / 3);
    CHECK(f.value("y = max(max |x_i|, a)") == 4);
    CHECK(f.value("y = Σ_i (x_i − mean x_i) (w_i − mean w_i)") == f.value("y = Σ x_i w_i − mean x_i Σ w_i"));
    CHECK(Formula("y = Σ w_i x_i", f.symbols).check_units().unit == Unit("kg m"));
    CHECK_THAT(Formula("y = Σ w_i x_i + a", f.symbols).check_units().mismatch, ContainsSubstring("kg m and m"));
    CHECK(Formula("y = max_i x_i / mean_i x_i", f.symbols).check_units().unit == Unit());
    CHECK(Formula("E = Σ_i w_i x_i", f.symbols).latex() == "E = \\sum_{i} w_{i} x_{i}");
    CHECK(Formula("y = max_i x_i", f.symbols).latex() == "y = \\max_{i} x_{i}");
    CHECK(Families{}.value("y = Σ x_i") == 0);
    CHECK_THROWS_AS(Families{}.value("y = max x_i"), BadFormula);
    CHECK_THROWS_AS((Families{.x = {1}, .w = {1, 2}}.value("y = Σ x_i w_i")), BadFormula);
    CHECK_THROWS_AS(f.value("y = x_i"), BadFormula);
    CHECK_THROWS_AS(f.value("y = Σ a"), BadFormula);
}

TEST_CASE("formula: families and named functions are differentiated") {
    const Families f{.x = {1, -4, 2.5}, .w = {2, 3, 5}};
    const auto squares = [](std::span<const Real> v) {
        Real sum = 0;
        for (const Real one : v) sum += one * one;
        return sum;
    };
    for (const char* text : {"y = Σ_i w_i x_i² + a", "y = max_i |x_i w_i| a", "y = min x_i + a mean(x_i² w_i)",
                             "y = Σ_i (x_i − mean x_i)² / Σ w_i", "y = a s(x_i, a) + Σ w_i", "y = Σ_i a x_i s(w_i)"}) {
        CAPTURE(text);
        Families moved = f;
        const Formula formula(text, f.symbols, {{"s", Unit(), squares}});
        const std::vector<Real> g = formula.gradient(f.numbers());
        REQUIRE(g.size() == 7);
        for (std::size_t k = 0; k < 7; ++k) {
            constexpr Real h = 1e-5;
            Real& number = k < 3 ? moved.x[k] : k < 6 ? moved.w[k - 3] : moved.a;
            const Real kept = number;
            number = kept + h;
            const Real above = formula.evaluate(moved.numbers());
            number = kept - h;
            const Real below = formula.evaluate(moved.numbers());
            number = kept;
            CHECK_THAT(g[k], WithinAbs((above - below) / (2 * h), 1e-4 * (1 + std::abs(g[k]))));
        }
    }
}

// Pieces of formulas and what is none, put together by a generator of fixed seed.
TEST_CASE("formula: any text is read or refused at a letter of it, and no letter of it is lost") {
    const std::vector<std::string> pieces{"x", "x_i", "Σ",    "Σ_i ", "max", "mean ", "(",  ")", "|", "²",   "⁻¹", "^",    "√",
                                          "½", " ",   "   ",  "+",    "−",   "·",     "/",  "=", ",", "1.5", "f(", "π",    "°",
                                          "Δ", "ε̄",   "\xce", "_",    "a",   "sin",   "10", "e", "∇", "…",   "[",  "\xff", "\n"};
    std::uint32_t state = 1;
    const auto next = [&](std::size_t below) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::size_t>(state >> 8) % below;
    };
    std::size_t read = 0;
    for (int k = 0; k < 20000; ++k) {
        std::string text = k % 2 ? "y = " : "";
        for (std::size_t n = 1 + next(9); n > 0; --n) text += pieces[next(pieces.size())];
        CAPTURE(text);
        REQUIRE_NOTHROW(read += test::fuzz_formula(text));
    }
    CHECK(read > 500);
}

TEST_CASE("formula: with its numbers put in it reads back as what it gives") {
    const std::vector<Given> given{{"a", -1.5}, {"b", 0.25}, {"c", 2e-7}, {"x", -3}};
    for (const char* text : {"y = a b c",     "y = a² − b / x",      "y = −x",          "y = 1 / c",
                             "y = c²",        "y = (a + b) (x − a)", "y = a − (b − x)", "y = a / b / x",
                             "y = a / b · x", "y = ½ a x²",          "y = √(x²) + |a|", "y = max(a, b) − min(x, 0)",
                             "y = b^x",       "y = (1 + b)^(−a)",    "y = sin²(a / 2)", "y = a − x − b",
                             "y = −(a + b)²", "y = x^2 cos a",       "y = 10⁻³ a",      "y = |a| |x|",
                             "y = a (−x)"}) {
        CAPTURE(text);
        const Formula f = formula(text, given);
        const std::vector<Real> values = values_of(given);
        std::vector<FormulaNumbers> numbers;
        for (const Real& value : values) numbers.push_back({&value});
        const std::string printed = f.with_numbers(numbers, std::vector<std::string>(values.size()));
        CAPTURE(printed);
        CHECK_THAT(Formula(printed, {}).evaluate(std::vector<Real>{}), WithinRel(f.evaluate(values), 1e-5));
    }
}

TEST_CASE("formula: a unit is written as people write it") {
    CHECK(Unit("kg/s²").usual_text() == "N/m");
    CHECK(Unit("kg m²/s²").usual_text() == "J");
    CHECK(Unit("m/s²").usual_text() == Unit("m/s²").text());
    CHECK(Unit("cells").usual_text().empty());
}
