// Units of equations as lectures write them.
#include <pliant/formula/equation_units.h>

#include <catch2/catch_test_macros.hpp>

#include <string_view>

using namespace pliant;

namespace {

EquationCheck checked(std::string_view equation) {
    SymbolUnits units;
    for (const auto& [symbol, unit] : {std::pair{"u", "m/s"}, {"p", "m²/s²"}, {"Δt", "s"},  {"x", "m"}, {"f", "N"},
                                       {"fᵈ", "N"},           {"m", "kg"},    {"k", "N/m"}, {"l", "m"}, {"ε", ""},
                                       {"σ", "Pa"},           {"λ", "Pa"},    {"μ", "Pa"},  {"I", ""},  {"F", ""},
                                       {"EA", "N"},           {"Δs", "m"},    {"ω", "1/s"}, {"ζ", ""},  {"v", "m/s"},
                                       {"k₀", "N/m"}})
        units.add(symbol, Unit(unit));
    return check_units(equation, units);
}

bool right(std::string_view equation) { return checked(equation).known && checked(equation).mismatch.empty(); }
bool wrong(std::string_view equation) { return !checked(equation).mismatch.empty(); }

}  // namespace

TEST_CASE("equations: sides of the same unit") {
    CHECK(right("Δt ∇²p = ∇·ũ"));
    CHECK(right("u ← ũ − Δt ∇p"));
    CHECK(right("σ = λ tr(ε) I + 2 μ ε"));
    CHECK(right("fᵢ = k (|xᵢⱼ| − l) xᵢⱼ/|xᵢⱼ|"));
    CHECK(right("k = EA/Δs = k₀"));
    CHECK(right("f = m (−ω²x − 2 ζ ω v)"));
    CHECK(right("v′ = v + Δt (f + fᵈ)/m"));
    CHECK(right("u(x) ← u(x − Δt u(x − ½Δt u(x)))"));
    CHECK(right("∇·u = 0"));
    CHECK(right("ω = √(k/m)"));
    CHECK(right("ε = |∂x/∂x| − 1, a remark"));
    CHECK(right("m x″ = f"));
    CHECK(right("det F = 1"));
    CHECK(right("dε = dx/l"));
    CHECK(right("a first guess, x = x + Δt v or x = x"));
    CHECK(right("f ≤ k x"));
    CHECK(right("σ:ε = tr(σ ε)"));
    CHECK(right("div u = ω"));
    CHECK(right("F ⊗ F = I"));
    CHECK(right("ln det F = atan2(x, l) + max(ε, ζ)"));
}

TEST_CASE("equations: both units are named where they differ") {
    CHECK(wrong("u ← ũ − ∇p"));
    CHECK(wrong("f = −ω²x"));
    CHECK(wrong("u = x + u"));
    CHECK(wrong("ω = k/m"));
    CHECK(wrong("m x″ = v"));
    CHECK(wrong("a first guess, x = x or x = v"));
    CHECK(wrong("f ≤ x"));
    CHECK(wrong("ε = sin(x)"));
    CHECK(wrong("dε = dx"));
    CHECK(wrong("x = max(x, ε)"));
    CHECK(checked("u ← ũ − ∇p").mismatch.find("m/s") != std::string::npos);
}

TEST_CASE("equations: what is not declared is not known") {
    CHECK_FALSE(checked("q = r").known);
    CHECK_FALSE(checked("f = k x̂").known);
    CHECK_FALSE(checked("u").known);
    CHECK(checked("u = the speed of the wall").unknown == "words");
    CHECK(checked("u = k q_i").unknown == "q_i");
    CHECK_FALSE(checked("x = det σ").known);
    CHECK(checked("f ~ x").mismatch.empty());
    CHECK_FALSE(checked("f ~ x").known);
    CHECK_FALSE(checked("u = A x").known);
    CHECK(checked("u = A x").mismatch.empty());
    SymbolUnits units;
    units.add("a", Unit("m")), units.add("a", Unit("s")), units.add("b", Unit("m"));
    CHECK_FALSE(check_units("a = b", units).known);
}

TEST_CASE("equations: a hat is a symbol of its own, what is set holds, others complete it") {
    SymbolUnits units, others;
    units.add("x", Unit("m")), units.add("a", Unit("m")), units.add("a", Unit("s"));
    others.add("x", Unit("s")), others.add("b", Unit("m")), others.add("x_b", Unit("s"));
    CHECK_FALSE(check_units("x = b", units).known);
    units.complete_with(others);
    CHECK(check_units("x = b", units).known);
    CHECK(check_units("x_b = b", units).mismatch == "");
    CHECK_FALSE(check_units("a = x", units).known);
    units.set("a", Unit("m")), units.set("x̂", Unit(""));
    CHECK(check_units("a = x = x_i x̂_ij", units).known);
    CHECK(check_units("a = x = x_i x̂_ij", units).mismatch == "");
    CHECK(check_units("a = x̂", units).mismatch != "");
}
