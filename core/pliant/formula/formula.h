// A formula as data. Its text, read against the symbols of what is put in, becomes a tree that is evaluated, differentiated,
// checked for units and typeset: what a person reads is what was computed.
#pragma once
#include <pliant/formula/unit.h>
#include <pliant/math/error.h>
#include <pliant/math/types.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// A text that cannot be read as a formula. The message shows the place in the text, in letters from 1, and what may stand there.
struct BadFormula : Error {
    BadFormula(std::string_view text, std::size_t at_byte, std::string_view what);
};

enum class Operation {
    number,
    symbol,
    negative,    // −a
    sum,         // a + b
    difference,  // a − b
    product,
    quotient,
    power,      // a^b
    root,       // √a
    magnitude,  // |a|
    call
};

enum class Function { sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, exp, ln, log10, min, max, floor };
std::string_view name_of(Function function);

struct FormulaNode {
    Operation operation = Operation::number;
    std::vector<int> of{};           // operands: places of nodes before this one
    Real number = 0;                 // of a number
    int symbol = 0;                  // of a symbol: which of those that were declared
    Function function{};             // of a call
    std::size_t begin = 0, end = 0;  // where it stands in the text, in bytes
    bool grouped = false;            // in parentheses of its own
    bool of_degrees = false;         // a number in degrees, "180°"; a call of sine or its like that takes degrees
};

// "left = right", of which the right side is read; what follows three blanks, or a comma or colon outside of parentheses, is a
// remark for people. The symbols are found first, the longest one that stands at a place: "EA" and "|x_ij|" can be symbols.
//
// The right side knows + − · / ^, products by juxtaposition, raised digits, ½ and its like, √, |a|, π, and the functions by name:
// "½ EA ε²", "4 sin²(κ/2)", "√((x_j − x_i)² + l²)", "max(a, b)". A quotient that a product by juxtaposition follows, "a / b c",
// is refused, since people read it in two ways.
class Formula {
public:
    // units: of the symbols, in their order; without any, nothing is known of them. An angle in degrees becomes radians where
    // sine and its like take it. Throws BadFormula.
    Formula(std::string text, std::vector<std::string> symbols, std::vector<Unit> units = {});

    const std::string& text() const { return text_; }
    std::string_view left() const { return std::string_view(text_).substr(0, left_end_); }
    std::string_view right() const { return std::string_view(text_).substr(right_begin_, right_end_ - right_begin_); }
    std::string_view remark() const { return std::string_view(text_).substr(remark_begin_); }  // "" without one
    const std::vector<std::string>& symbols() const { return symbols_; }
    const std::vector<FormulaNode>& nodes() const {
        return nodes_;
    }  // operands before what is made of them; the whole is the last

    // values: of the symbols, in their order.
    Real evaluate(std::span<const Real> values) const;
    // ∂/∂x of each symbol, by one reverse sweep.
    std::vector<Real> gradient(std::span<const Real> values) const;

    // What is found out about the unit of the right side.
    struct UnitCheck {
        std::optional<Unit> unit{};  // empty when there is a mismatch, and of 0, which suits every unit
        std::string mismatch{};      // "m/s and m: v + x"; "" when all is well
    };
    bool has_units() const { return units_.size() == symbols_.size(); }
    // Only where the units of the symbols are known.
    UnitCheck check_units() const;

    // In LaTeX, "f = k \left(x - l\right)", without the remark.
    std::string latex() const;

private:
    friend class FormulaReader;
    std::string text_;
    std::vector<std::string> symbols_;
    std::vector<Unit> units_;
    std::vector<FormulaNode> nodes_;
    std::size_t left_end_ = 0, right_begin_ = 0, right_end_ = 0, remark_begin_ = 0;

    std::vector<Real> values_of_nodes(std::span<const Real> values) const;
    void mark_degrees();
};

// Which symbol stands at this place of a text as a word of its own: the longest one; −1 for none.
int symbol_at(std::string_view text, std::size_t at, std::span<const std::string> symbols);

}  // namespace pliant
