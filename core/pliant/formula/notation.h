// A formula as it is set: what stands over, beside, above and below what. Read from any text in the linear format of the
// formulas, of declared symbols or not; what cannot be read stays as it is written, so that there is always something to see.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// A piece of a formula, with the pieces that it is made of.
struct Notation {
    enum class Kind {
        row,       // pieces side by side
        variable,  // one letter, or one with its accent
        digits,    // a number
        name,      // of a function: sin, det; a unit
        words,     // of a sentence, with the blanks between them
        sign,      // between two operands: + − · × :
        prefix,    // before its operand: −, ∂, ∇, ∆
        relation,  // = ≤ ≈ ← →
        comma,     // and semicolon
        large,     // Σ ∫: takes its indices above and below
        gap,       // between formulas of one line
        fraction,  // of[0] over of[1]; text: "½" of one that is a single letter
        root,      // of[0]
        scripts,   // of[0] with of[1] below and of[2] above; rows, which may be empty
        accent,    // text over of[0]: "~", "^", "¯", "˙"
        fence,     // of[0] between the two letters of text: "()", "||", "⟨⟩"; one letter where it is left open
        grid       // rows of a matrix, each a row of rows
    };
    Kind kind = Kind::row;
    std::string text{};
    std::vector<Notation> of{};
    bool spaced = false;  // a blank stands before it in the text
};

// "a / b" puts all factors of its term over the next one, "EA/Δs" what is written without blanks; indices follow "_" or stand as
// small letters; exponents follow "^", likewise; "[a b; c d]" with blanks between its entries is a matrix.
//
// with_units: what follows a number and is a unit, "0.3 m/s", is set as one.
enum class Numbers { plain, with_units };
Notation notation(std::string_view text, Numbers numbers = Numbers::plain);

// With its fractions and parentheses in the line, "a b / (c d)", where it can be broken within them.
Notation in_line(const Notation& row);
// Neither symbols nor relations stand in it: words, numbers and units alone.
bool is_prose(const Notation& row);

// The same in LaTeX.
std::string latex(const Notation& notation);
std::string latex(std::string_view text);

}  // namespace pliant
