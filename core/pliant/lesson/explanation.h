// How a number came about: the formula that gives it and what was put into it. A lesson declares the formula with references to
// its inputs; the values are looked up where the inputs live, so that an explanation cannot state other numbers than those that
// were computed.
#pragma once
#include <pliant/lesson/parameter.h>
#include <pliant/math/types.h>

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// One number of a field: row `index`, and of a vector or tensor the component, counted from 0. Of a probe: index 0.
struct Question {
    std::string_view field;
    Index index = 0;
    int component = 0;
};

// The text of a formula, and where in the sources it stands, for whoever has to mend it.
class FormulaText : public std::string {
public:
    FormulaText() = default;
    template <std::convertible_to<std::string> Text>
    FormulaText(Text&& text, const char* file = __builtin_FILE(), unsigned line = __builtin_LINE())
        : std::string(std::forward<Text>(text)), file_(file), line_(line) {}
    // "lessons/mesh/rod/rod_why.cpp:77"
    std::string place() const;

private:
    // As std::source_location has them, which not every compiler of today knows.
    const char* file_ = "";
    unsigned line_ = 0;
};

using Values = std::span<const Real>;

struct Explanation;

// In place of the unit of a part: what its formula gives.
inline constexpr const char* unit_from_formula = "?";

// A number that a formula takes.
struct Input {
    enum class From {
        parameter,
        constant,  // of the mesh, the grid or the method: a weight, a length
        now,       // a field (or probe), after the stage pass that is explained
        before,    // a field before the stage
        earlier,   // a field before the latest pass of the stage
        part       // an intermediate result with an explanation of its own
    };
    From from = From::constant;
    std::string symbol;    // as the formula writes it
    std::string family{};  // of one of many: the symbol under which the formula writes all of them
    std::string name{};    // of the parameter or field; what a constant means
    Index index = 0;
    int component = 0;
    Real value = 0;                            // of a constant; looked up for all others
    std::string unit{};                        // of a part may be unit_from_formula
    std::shared_ptr<const Explanation> why{};  // of a part
    std::function<Real()> value_now{};         // of a constant that changes: what it is now
    bool all = false;                          // of a probe's formula: every row of the field

    Input() = default;
    Input(const Parameter& parameter);  // under its own symbol: "{length, segments}" are two inputs
    static Input of(const Parameter& parameter) { return parameter; }
    static Input of(const Parameter& parameter, std::string symbol);
    static Input constant(std::string symbol, Real value, std::string unit, std::string meaning);
    // A constant that is asked for whenever the formula is evaluated: the time, the steps that are done.
    static Input live(std::string symbol, std::string unit, std::string meaning, std::function<Real()> value);
    static Input now(std::string symbol, std::string_view field, Index index, int component = 0);
    // A component of all rows of a field, in the formula of a probe: a family.
    static Input all_of(std::string symbol, std::string_view field, int component = 0);
    static Input before(std::string symbol, std::string_view field, Index index, int component = 0);
    static Input earlier(std::string symbol, std::string_view field, Index index, int component = 0);
    static Input part(std::string symbol, std::string unit, Explanation why);
    // The same as one of a family.
    Input in(std::string family_symbol) const;

private:
    Input(From from, std::string symbol, std::string name, std::string unit);
};

// What cannot be said in the grammar: it takes its arguments one after the other, of a family all.
struct NamedFunction {
    std::string name, unit;
    std::function<Real(Values)> value;
};

// `formula` is "left = right", read as data and evaluated (see Formula): every input's symbol stands in the right side, or that
// of its family, and so does the name of every function. One that cannot be read, or whose inputs have a unit that is none, is
// told with its place in the sources wherever the answer is shown, and fails the tests.
struct Explanation {
    FormulaText formula;
    std::vector<Input> inputs{};
    std::vector<NamedFunction> functions{};
    bool wrong_unit = false;  // on purpose: the slide's formula, which a lesson shows to be so

    // With a function that its formula calls by name: Explanation{"λ = largest(F)", …}.by("largest(F)", "", …).
    Explanation by(std::string name, std::string unit, std::function<Real(Values)> value) &&;
};

// An intermediate result: its symbol is the left side of its formula, and its unit follows from those of its inputs,
// part("Δs = L / N", {length, segments}).
Input part(FormulaText formula, std::vector<Input> inputs);

// Σ w q of two families under their symbols, weighted_sum("u = Σ_k w_k q_k", "w_k", "q_k", …). Weights of 0 are left out; without
// any other the sum is 0.
Explanation weighted_sum(FormulaText formula, const std::string& weights, const std::string& quantities,
                         const std::vector<std::pair<Input, Input>>& terms);
// "f = Σ f_j", of so many inputs under one symbol. None of them gives 0.
Explanation sum_of(FormulaText formula, const std::string& family, std::vector<Input> terms);
// The inputs as one family.
std::vector<Input> family_of(const std::string& symbol, std::vector<Input> inputs);

// "u = 0: held by the support": a value that is the number in its formula.
Explanation fixed_value(FormulaText formula);

// A number as it stands in a product: "0.5", "(-3)"; and before an exponent: "(10⁻³)".
std::string as_factor(Real value, bool raised = false);

}  // namespace pliant
