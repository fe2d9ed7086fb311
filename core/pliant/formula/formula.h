// A formula as data. Its text, read against the symbols of what is put in, becomes a tree that is evaluated, differentiated,
// checked for units and typeset: what a person reads is what was computed.
#pragma once
#include <pliant/formula/unit.h>
#include <pliant/math/error.h>
#include <pliant/math/types.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// A text that cannot be read as a formula. The message shows the place in the text, in letters from 1, with a caret below it, and
// what may stand there.
struct BadFormula : Error {
    BadFormula(std::string_view text, std::size_t at_byte, std::string_view what);
};

enum class Operation {
    number,
    symbol,      // one number; of a family, the one whose turn it is
    family,      // all numbers of one, as a named function takes them
    negative,    // −a
    sum,         // a + b
    difference,  // a − b
    product,
    quotient,
    power,      // a^b
    root,       // √a
    magnitude,  // |a|
    call,
    named,     // a function that the formula was given
    total,     // Σ a over the families in a
    mean,      // likewise
    largest,   // max a
    smallest,  // min a
};
constexpr bool runs_over_family(Operation o) { return o >= Operation::total; }

enum class Function { sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, exp, ln, log10, min, max, mean, floor };
std::string_view name_of(Function function);

struct FormulaNode {
    Operation operation = Operation::number;
    std::vector<int> of{};           // operands: places of nodes before this one
    Real number = 0;                 // of a number
    int symbol = 0;                  // of a symbol or family: which of those that were declared; of a named function likewise
    Function function{};             // of a call
    std::size_t begin = 0, end = 0;  // where it stands in the text, in bytes
    bool grouped = false;            // in parentheses of its own
    bool of_degrees = false;         // a number in degrees, "180°"; a call of sine or its like that takes degrees
    int first = 0;                   // of what runs over a family, and of a named function: its first node
    int repeated_for = -1;           // which node evaluates it for each member of its families; −1: none
};

// What can stand in a formula: a number under its symbol or, under one symbol, the many numbers of a family, x_i of "Σ x_i".
struct FormulaSymbol {
    std::string text;
    std::optional<Unit> unit{};  // where it is known
    bool family = false;
};

// What no formula says, a solver's result or an eigenvalue: it stands in the text by its name, "det(F)", and takes the numbers of
// its arguments one after the other, of a family all.
struct FormulaFunction {
    std::string name;
    Unit unit{};
    std::function<Real(std::span<const Real>)> value;
};

// What is put in for a symbol, where it lies: one number, or those of a family.
struct FormulaNumbers {
    const Real* first = nullptr;
    std::size_t count = 1, stride = 1;
    Real operator[](std::size_t k) const { return first[k * stride]; }
};

// "left = right", of which the right side is read; what follows three blanks, or a comma or colon outside of parentheses, is a
// remark for people. The symbols are found first, the longest one that stands at a place: "EA" and "|x_ij|" can be symbols.
//
// The right side knows + − · / ^, products by juxtaposition, raised digits, ½ and its like, √, |a|, π, and the functions by name:
// "½ EA ε²", "4 sin²(κ/2)", "√((x_j − x_i)² + l²)", "max(a, b)". A quotient that a product by juxtaposition follows, "a / b c",
// is refused, since people read it in two ways.
//
// Σ runs over the families in the term that follows it, max, min and mean over those in their argument, each with an index below
// it or none: "Σ_b K_ab u_b", "max_i |x_i − mean x_i|". Families that run together have as many members.
class Formula {
public:
    // An angle in degrees becomes radians where sine and its like take it. Throws BadFormula.
    Formula(std::string text, std::vector<FormulaSymbol> symbols, std::vector<FormulaFunction> functions = {});

    const std::string& text() const { return text_; }
    std::string_view left() const { return std::string_view(text_).substr(0, left_end_); }
    std::string_view right() const { return std::string_view(text_).substr(right_begin_, right_end_ - right_begin_); }
    std::string_view remark() const { return std::string_view(text_).substr(remark_begin_); }  // "" without one
    const std::vector<FormulaSymbol>& symbols() const { return symbols_; }
    const std::vector<FormulaFunction>& functions() const { return functions_; }
    // Operands before what is made of them; the whole is the last.
    const std::vector<FormulaNode>& nodes() const { return nodes_; }

    // What is put in for the symbols, in their order. Allocates nothing, but for what named functions take and for formulas of
    // more than 128 nodes. Throws BadFormula where families that run together differ in size, or have no largest.
    Real evaluate(std::span<const FormulaNumbers> numbers) const;
    // Of a formula without families, a number for each symbol.
    Real evaluate(std::span<const Real> values) const;

    // ∂/∂x of each number that is put in, those of a family one after the other, by one reverse sweep; through named functions by
    // differences, of very many numbers by those of a sample. A largest changes with the member that wins.
    std::vector<Real> gradient(std::span<const FormulaNumbers> numbers) const;
    std::vector<Real> gradient(std::span<const Real> values) const;
    // Does a named function take the symbol, so that its derivative is a difference?
    bool by_differences(int symbol) const;

    // What is found out about the unit of the right side.
    struct UnitCheck {
        std::optional<Unit> unit{};  // empty when there is a mismatch, and of 0, which suits every unit
        std::string mismatch{};      // "m/s and m: v + x"; "" when all is well
    };
    bool has_units() const;
    // Only where the units of all symbols are known.
    UnitCheck check_units() const;

    // Of what stands at a node; empty where it is not known, or suits every unit.
    std::optional<Unit> unit_at(int node) const;

    // The right side with the numbers in place of the symbols, each with its unit as it is written, "½ · 3 kg · (2 m/s)²". Of the
    // terms of a long sum the largest ones are written, with how many more there are and what they add up to; none that is 0.
    std::string with_numbers(std::span<const FormulaNumbers> numbers, std::span<const std::string> units) const;

    // In LaTeX, "f = k \left(x - l\right)", without the remark.
    std::string latex() const;

private:
    friend class FormulaReader;
    friend class FormulaSweep;
    std::string text_;
    std::vector<FormulaSymbol> symbols_;
    std::vector<FormulaFunction> functions_;
    std::vector<FormulaNode> nodes_;
    std::size_t left_end_ = 0, right_begin_ = 0, right_end_ = 0, remark_begin_ = 0;

    void mark_degrees();
};

// Which symbol stands at this place of a text as a word of its own: the longest one; −1 for none.
int symbol_at(std::string_view text, std::size_t at, std::span<const FormulaSymbol> symbols);

}  // namespace pliant
