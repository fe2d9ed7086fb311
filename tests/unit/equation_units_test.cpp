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
}

TEST_CASE("equations: both units are named where they differ") {
    CHECK(wrong("u ← ũ − ∇p"));
    CHECK(wrong("f = −ω²x"));
    CHECK(wrong("u = x + u"));
    CHECK(wrong("ω = k/m"));
    CHECK(checked("u ← ũ − ∇p").mismatch.find("m/s") != std::string::npos);
}

TEST_CASE("equations: what is not declared is not known") {
    CHECK_FALSE(checked("q = r").known);
    CHECK_FALSE(checked("f = k x̂").known);
    CHECK_FALSE(checked("m x″ = f").known);
    CHECK_FALSE(checked("u").known);
    CHECK_FALSE(checked("u = A x").known);
    CHECK(checked("u = A x").mismatch.empty());
    SymbolUnits units;
    units.add("a", Unit("m")), units.add("a", Unit("s")), units.add("b", Unit("m"));
    CHECK_FALSE(check_units("a = b", units).known);
}
