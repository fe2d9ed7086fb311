// Numbers put into formulas.
#include <pliant/lesson/explanation.h>
#include <catch2/catch_test_macros.hpp>

#include <vector>

using namespace pliant;

namespace {

// The formula with constants of these symbols and values.
std::string put_in(std::string formula, const std::vector<std::pair<std::string, Real>>& numbers) {
    Explanation e{.formula = std::move(formula), .inputs = {}, .evaluate = {}};
    std::vector<Real> values;
    for (const auto& [symbol, value] : numbers) {
        e.inputs.push_back(Input::constant(symbol, value, "", ""));
        values.push_back(value);
    }
    return substituted(e, values);
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
    CHECK(put_in("a = max(− v, 0)", {{"v", -3}}) == "a = max(− (-3), 0)");
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
    CHECK(put_in("a = u_left − u", {{"u", 1}}) == "a = u_left − 1");
    CHECK(put_in("a = max(a, m)", {{"a", 1}, {"m", 2}}) == "a = max(1, 2)");
    CHECK(put_in("a = x′ − x", {{"x", 1}, {"x′", 2}}) == "a = 2 − 1");
    CHECK(put_in("a = f + fᵈ + f(x′)", {{"f", 1}, {"fᵈ", 2}, {"f(x′)", 3}}) == "a = 1 + 2 + 3");
    CHECK(put_in("a = f + fᵈ", {{"f", 1}}) == "a = 1 + fᵈ");
    CHECK(put_in("a = kₛ k", {{"k", 2}, {"kₛ", 3}}) == "a = 3 · 2");
    CHECK(put_in("T = k (|x_ij| − l)", {{"k", 2}, {"|x_ij|", 3}, {"l", 1}}) == "T = 2 · (3 − 1)");
    CHECK(put_in("v = x_i − x_ij", {{"x_i", 1}, {"x_ij", 2}}) == "v = 1 − 2");
}

TEST_CASE("words of a formula stay as they are") {
    CHECK(put_in("f = 0: no springs", {}) == "f = 0: no springs");
    CHECK(put_in("v′ = v: the support holds the node", {{"v", 0}}) == "v′ = 0: the support holds the node");
}

TEST_CASE("sums write a few of their terms") {
    CHECK(sum_text(std::vector<Real>{}) == "0");
    CHECK(sum_text(std::vector<Real>{-1, 2, -3}) == "−1 + 2 − 3");
    CHECK(sum_text(std::vector<Real>(10, 1)) == "1 + 1 + 1 + 1 + 1 + 1 + … (10 terms)");
    CHECK(sum_text(std::vector<Real>{0, 1, 0}) == "1");
    CHECK(products_text(std::vector<Real>{2, 0, 3, 1}) == "3 · 1");
    CHECK(products_text(std::vector<Real>{2, 3, -4, -5}) == "2 · 3 − 4 · (-5)");
    const Explanation e = sum_of("E = Σ e", {Input::constant("e", 1, "", ""), Input::constant("e", 2, "", "")});
    CHECK(e.making == Making::sum);
    CHECK(substituted(e, std::vector<Real>{1, 2}) == "E = 1 + 2");
}
