// How a number came about: the formula that gives it and what was put into it. A lesson declares the formula with references to
// its inputs; the values are looked up where the inputs live, so that an explanation cannot state other numbers than those that
// were computed.
#pragma once
#include <pliant/lesson/parameter.h>
#include <pliant/math/types.h>

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
    std::string symbol;  // as the formula writes it
    std::string name{};  // of the parameter or field; what a constant means
    Index index = 0;
    int component = 0;
    Real value = 0;                            // of a constant; looked up for all others
    std::string unit{};                        // of a part may be unit_from_formula
    std::shared_ptr<const Explanation> why{};  // of a part

    Input() = default;
    Input(const Parameter& parameter);  // under its own symbol: "{length, segments}" are two inputs
    static Input of(const Parameter& parameter) { return parameter; }
    static Input of(const Parameter& parameter, std::string symbol);
    static Input constant(std::string symbol, Real value, std::string unit, std::string meaning);
    static Input now(std::string symbol, std::string_view field, Index index, int component = 0);
    static Input before(std::string symbol, std::string_view field, Index index, int component = 0);
    static Input earlier(std::string symbol, std::string_view field, Index index, int component = 0);
    static Input part(std::string symbol, std::string unit, Explanation why);

private:
    Input(From from, std::string symbol, std::string name, std::string unit);
};

// How the inputs make the value.
enum class Making {
    formula,  // as its right side says
    sum,      // all inputs are added
    products  // pairs of inputs are multiplied and added
};

// `formula` is "left = right"; every input's symbol stands in the right side, which is read as data and evaluated (see Formula),
// and is replaced by its number in the substituted formula. The inputs of a sum, or of a sum of products, are its terms, and its
// right side describes them.
//
// What no formula says: `evaluate` gives the value back from the values of the inputs, in their order, and `substitute` writes
// these.
struct Explanation {
    std::string formula;
    std::vector<Input> inputs{};
    std::function<Real(std::span<const Real>)> evaluate{};
    std::function<std::string(std::span<const Real>)> substitute{};
    Making making = Making::formula;
    bool wrong_unit = false;  // on purpose: the slide's formula, which a lesson shows to be so
};

// An intermediate result: its symbol is the left side of its formula, and its unit follows from those of its inputs,
// part("Δs = L / N", {length, segments}).
Input part(std::string formula, std::vector<Input> inputs);

// Σ w q: pairs of a weight and a quantity, after `head` inputs that `evaluate` of the caller may need. formula: "u = Σ w u_k".
// Terms of weight 0 are left out.
Explanation weighted_sum(std::string formula, const std::vector<std::pair<Input, Input>>& terms);

// Σ q, "a + b − c + …" where numbers are put in: of quantities that are added as they are. No term gives 0.
Explanation sum_of(std::string formula, std::vector<Input> terms);

// How many inputs make a term of a sum, or of a sum of products.
inline std::size_t factors_of(Making making) { return making == Making::products ? 2 : 1; }
// Of the values of the inputs, where they make a sum, or a sum of products.
Real sum_of_terms(Making making, std::span<const Real> values);

// A value that follows from nothing but the words of its formula: "u = 0: held by the support".
Explanation fixed_value(std::string formula, Real value);

// The numbers of a formula written out: the right side of the formula with each symbol replaced. Negative numbers are put into
// parentheses where an operator stands before them.
std::string substituted(const Explanation& explanation, std::span<const Real> values);

// A number as it stands in a product: "0.5", "(-3)"; and before an exponent: "(10⁻³)".
std::string as_factor(Real value, bool raised = false);

// "3 · 0.5 + 2 · 0.25 + … (12 terms)": for formulas that sum many terms. Terms that are 0 are not written.
std::string products_text(std::span<const Real> factors_in_pairs);
// "3 + 0.25 − 2 + … (12 terms)"
std::string sum_text(std::span<const Real> terms);

}  // namespace pliant
