// Reads the right side of a formula. A descent over its grammar:
//   sum     = ["+" | "−"] product {("+" | "−") product}
//   product = power {["·" | "×"] power | "/" power}
//   power   = primary {raised digits | "^" (primary | "−" primary)}
//   primary = number | fraction | symbol | "π" | "(" sum ")" | "|" sum "|" | "√" primary | function
#pragma once
#include <pliant/formula/formula.h>

#include <optional>

namespace pliant {

class FormulaReader {
public:
    // The formula must outlive the reader, which fills it.
    explicit FormulaReader(Formula& formula) : f_(formula), text_(formula.text_) {}
    void read();

private:
    using Node = FormulaNode;

    void split();
    // --- the grammar; each gives the place of its node ---
    int sum();
    int product();
    int power();
    int primary();
    int grouped();
    int magnitude();
    int root();
    int call(Function function);
    int number();

    // --- letters ---
    char32_t here() const { return at_ < f_.right_end_ ? code_point_here() : U'\0'; }
    char32_t code_point_here() const;
    bool take(char32_t letter);  // after blanks
    void skip_blanks();
    bool begins_factor();                  // may a factor of a product by juxtaposition stand here?
    std::optional<int> exponent_digits();  // raised ones, with their sign
    int symbol_here() const;               // −1 for none
    std::optional<Function> function_here() const;
    std::optional<Real> fraction_here() const;
    [[noreturn]] void refuse(std::string_view what) const;

    // --- nodes ---
    int add(Operation operation, std::vector<int> of, std::size_t begin);
    int add_number(Real value, std::size_t begin);

    Formula& f_;
    std::string_view text_;
    std::size_t at_ = 0;
    int bars_ = 0;  // open ones around this place
};

}  // namespace pliant
