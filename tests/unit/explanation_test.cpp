// Numbers put into formulas.
#include <pliant/run/evaluation.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <vector>

using namespace pliant;

namespace {

struct Given {
    std::string symbol;
    Real value = 0;
    std::string unit{}, family{};
};

Answer answer_of(const Explanation& e) {
    Answer a;
    for (const Input& in : e.inputs) a.inputs.push_back({.symbol = in.symbol, .value = in.value, .unit = in.unit});
    evaluate(a, e);
    return a;
}

// The formula with constants of these symbols and values.
Explanation given(FormulaText formula, const std::vector<Given>& numbers) {
    Explanation e{std::move(formula)};
    for (const Given& g : numbers) e.inputs.push_back(Input::constant(g.symbol, g.value, g.unit, "").in(g.family));
    return e;
}

std::string put_in(std::string formula, const std::vector<Given>& numbers) {
    const Answer a = answer_of(given(std::move(formula), numbers));
    return a.trouble.empty() ? a.substituted : a.trouble;
}

}  // namespace

TEST_CASE("numbers replace symbols on the right side alone") {
    CHECK(put_in("v = v + a", {{"v", 1}, {"a", 2}}) == "v = 1 + 2");
    CHECK(put_in("a / b", {{"a", 1}, {"b", 2}}) == "1 / 2");
}

TEST_CASE("symbols that stand side by side are multiplied") {
    CHECK(put_in("s = ν Δt", {{"ν", 3}, {"Δt", 0.5}}) == "s = 3 · 0.5");
    CHECK(put_in("s = 2 μ ε", {{"μ", 3}, {"ε", 4}}) == "s = 2 · 3 · 4");
    CHECK(put_in("E = ½ m", {{"m", 3}}) == "E = ½ · 3");
    CHECK(put_in("f = k (x − l)", {{"k", 2}, {"x", 5}, {"l", 1}}) == "f = 2 · (5 − 1)");
    CHECK(put_in("f = (x − l) (x − k)", {{"k", 2}, {"x", 5}, {"l", 1}}) == "f = (5 − 1) · (5 − 2)");
    CHECK(put_in("f = (x − l) k", {{"k", 2}, {"x", 5}, {"l", 1}}) == "f = (5 − 1) · 2");
}

TEST_CASE("negative numbers are put into parentheses where an operator stands before them") {
    CHECK(put_in("a = b", {{"b", -2}}) == "a = -2");
    CHECK(put_in("a = b − c", {{"b", -2}, {"c", -3}}) == "a = -2 − (-3)");
    CHECK(put_in("a = b c", {{"b", 2}, {"c", -3}}) == "a = 2 · (-3)");
    CHECK(put_in("a = max(b, 0)", {{"b", -2}}) == "a = max(-2, 0)");
    CHECK(put_in("a = max(− v, 0)", {{"v", -3}}) == "a = max(−(-3), 0)");
}

TEST_CASE("squares keep their exponent, of a negative number outside its parentheses") {
    CHECK(put_in("q = v²", {{"v", 3}}) == "q = 3²");
    CHECK(put_in("q = v²", {{"v", -3}}) == "q = (-3)²");
    CHECK(put_in("q = v²", {{"v", 2e-7}}) == "q = (2×10⁻⁷)²");
    CHECK(put_in("q = √(v_x² + v_y²)", {{"v_x", -3}, {"v_y", 4}}) == "q = √((-3)² + 4²)");
    CHECK(put_in("q = m v²", {{"m", 2}, {"v", 3}}) == "q = 2 · 3²");
}

TEST_CASE("a symbol is a whole word, and the longest one counts") {
    CHECK(put_in("a = u_left − u", {{"u", 1}, {"u_left", 2}}) == "a = 2 − 1");
    CHECK(put_in("a = max(a, m)", {{"a", 1}, {"m", 2}}) == "a = max(1, 2)");
    CHECK(put_in("a = x′ − x", {{"x", 1}, {"x′", 2}}) == "a = 2 − 1");
    CHECK(put_in("a = f + fᵈ + f(x′)", {{"f", 1}, {"fᵈ", 2}, {"f(x′)", 3}}) == "a = 1 + 2 + 3");
    CHECK(put_in("a = kₛ k", {{"k", 2}, {"kₛ", 3}}) == "a = 3 · 2");
    CHECK(put_in("T = k (|x_ij| − l)", {{"k", 2}, {"|x_ij|", 3}, {"l", 1}}) == "T = 2 · (3 − 1)");
    CHECK(put_in("v = x_i − x_ij", {{"x_i", 1}, {"x_ij", 2}}) == "v = 1 − 2");
}

TEST_CASE("words of a formula stay as they are") {
    CHECK(put_in("f = 0: no springs", {}) == "f = 0: no springs");
    CHECK(put_in("v′ = v: the support holds the node", {{"v", 0}}) == "v′ = 0: the support holds the node");
}

TEST_CASE("numbers keep their units, in parentheses below a line and under a power") {
    CHECK(put_in("E = ½ m v²", {{"m", 3, "kg"}, {"v", 2, "m/s"}}) == "E = ½ · 3 kg · (2 m/s)²");
    CHECK(put_in("a = f / m", {{"f", 3, "N"}, {"m", 2, "kg"}}) == "a = 3 N / (2 kg)");
    CHECK(put_in("x′ = x − Δt v", {{"x", 1, "m"}, {"Δt", 2, "s"}, {"v", -3, "m/s"}}) == "x′ = 1 m − 2 s · (-3 m/s)");
    CHECK(put_in("q = 1 / x", {{"x", 2e-7}}) == "q = 1 / (2×10⁻⁷)");
    CHECK(put_in("q = a^b", {{"a", 2}, {"b", -3}}) == "q = 2^(-3)");
    CHECK(put_in("q = (1 + s)^(−ν)", {{"s", 0.5}, {"ν", 0.3}}) == "q = (1 + 0.5)^(−0.3)");
    CHECK(put_in("q = sin²(κ / 2) cos φ", {{"κ", 3}, {"φ", -1}}) == "q = sin²(3 / 2) · cos(-1)");
}

TEST_CASE("sums write a few of their terms") {
    const auto family = [](const std::string& symbol, const std::vector<Real>& values, const std::string& unit = "") {
        std::vector<Given> all;
        for (const Real x : values) all.push_back({symbol + std::to_string(all.size()), x, unit, symbol});
        return all;
    };
    CHECK(put_in("y = Σ x", family("x", {-1, 2, -3})) == "y = −1 + 2 − 3");
    CHECK(put_in("y = Σ x", family("x", std::vector<Real>(10, 1))) == "y = 1 + 1 + 1 + 1 + 1 + 1 + … (4 more, together 4)");
    // The largest first, whatever their sign; those of one size in turn.
    CHECK(put_in("y = Σ x", family("x", {1, -1, 2, 1, 7, -9, 1, 1, 4, -3}, "N")) ==
          "y = −9 N + 7 N + 4 N − 3 N + 2 N + 1 N + … (4 more, together 2 N)");
    CHECK(put_in("y = Σ_i x_i", family("x_i", {0, 1, 0})) == "y = 1");
    CHECK(put_in("y = Σ x", family("x", {0, 0})) == "y = 0");
    CHECK(put_in("y = 2 Σ x", family("x", {1, 2}, "m")) == "y = 2 · (1 m + 2 m)");
    CHECK(put_in("y = mean x", family("x", {1, 2, 0}, "m")) == "y = (1 m + 2 m) / 3");
    CHECK(put_in("y = max_i |x_i|", family("x_i", {1, -2})) == "y = max(|1|, |-2|)");
    CHECK(put_in("y = Σ_i (x_i − mean x_i)²", family("x_i", {1, 3}, "m")) == "y = (1 m − 2 m)² + (3 m − 2 m)²");
    CHECK(put_in("y = Σ_i (x_i − 1) (x_i − 2) (x_i − 3)", family("x_i", {4, 5, 6, 7, 8})) ==
          "y = (8 − 1) · (8 − 2) · (8 − 3) + (7 − 1) · (7 − 2) · (7 − 3) + … (3 more, together 90)");
    std::vector<Given> pairs = family("w", {2, -4});
    for (const Given& g : family("q", {3, -5})) pairs.push_back(g);
    CHECK(put_in("y = Σ w q", pairs) == "y = 2 · 3 − 4 · (-5)");
}

TEST_CASE("a named function stands in the formula by its name") {
    const auto length = [](Values x) { return std::hypot(x[0], x[1]); };
    Explanation e{"y = 2 k |·|(a, b)",
                  {Input::constant("k", 3, "N/m", ""), Input::constant("a", 3, "m", ""), Input::constant("b", 4, "m", "")}};
    const Answer a = answer_of(Explanation(e).by("|·|(a, b)", "m", length));
    CHECK(a.trouble == "");
    CHECK(a.evaluated == 30);
    CHECK(a.substituted == "y = 2 · 3 N/m · 5 m");
    CHECK(!a.inputs[0].by_differences);
    CHECK(a.inputs[1].by_differences);
    CHECK_THAT(a.inputs[1].sensitivity, Catch::Matchers::WithinRel(6 * 0.6 * 3, 1e-5));
    const Answer alone = answer_of(given("y = f(x)", {{"x", 3, "m", "x"}, {"x", 4, "m", "x"}}).by("f", "m", length));
    CHECK(alone.substituted == "y = f(3 m, 4 m)");
}

TEST_CASE("a formula that cannot be read says where it stands and what is wrong with it") {
    const auto trouble = [](const Explanation& e) { return answer_of(e).trouble; };
    using Catch::Matchers::ContainsSubstring;
    const std::string unknown = trouble(given("x′ = x + Δx", {{"x", 1, "m"}, {"Δt", 1, "s"}}));
    CHECK_THAT(unknown, ContainsSubstring("explanation_test.cpp:"));
    CHECK_THAT(unknown, ContainsSubstring("no symbol 'Δx' is declared") && ContainsSubstring("x, Δt"));
    CHECK_THAT(unknown, ContainsSubstring("\n  x′ = x + Δx\n           ^"));
    CHECK_THAT(trouble(given("y = a b", {{"a", 1, "furlong"}, {"b", 1}})),
               ContainsSubstring("'furlong' is no unit") && ContainsSubstring("\n      ^"));
    CHECK_THAT(trouble(given("y = a / b c", {{"a", 1}, {"b", 1}, {"c", 1}})), ContainsSubstring("two ways"));
    CHECK_THAT(trouble(given("y = Σ a", {{"a", 1}})), ContainsSubstring("no family"));
    CHECK_THAT(trouble(given("y = 2 x", {{"x_1", 1, "", "x"}, {"x_2", 1, "", "x"}})), ContainsSubstring("many numbers"));
    CHECK_THAT(trouble(given("y = Σ x", {{"x_1", 1, "m", "x"}, {"x_2", 1, "s", "x"}})), ContainsSubstring("one unit"));
    CHECK_THAT(trouble(given("y = Σ x z", {{"x_1", 1, "", "x"}, {"x_2", 1, "", "x"}, {"z_1", 1, "", "z"}})),
               ContainsSubstring("of 2 and of 1"));
    CHECK_THAT(answer_of(given("y = x", {{"x", 1, "m"}})).unit_check, ContainsSubstring("m on the right"));
}

TEST_CASE("an answer with a formula that cannot be read says so, and is never a blank") {
    const Answer bad = answer_of(given("y = a + zz", {{"a", 1}}));
    CHECK(has_trouble(bad));
    CHECK_THAT(why_text(bad), Catch::Matchers::ContainsSubstring("y = a + zz\n") &&
                                  Catch::Matchers::ContainsSubstring("cannot be evaluated") &&
                                  Catch::Matchers::ContainsSubstring("explanation_test.cpp:"));
    CHECK_THAT(why_json(bad, 1),
               Catch::Matchers::ContainsSubstring("\"error\": \"") && Catch::Matchers::ContainsSubstring("no symbol 'zz'"));
    Answer above = answer_of(given("z = y", {{"y", 2}}));
    CHECK(!has_trouble(above));
    above.inputs[0].trouble = bad.trouble;
    CHECK(has_trouble(above));
}

TEST_CASE("a sum of nothing is 0") { CHECK(put_in(sum_of("f = Σ_j f_j", "f_j", {}).formula, {}) == "f = 0: nothing is added"); }
