// Reads the right side of a formula. A descent over its grammar:
//   sum     = ["+" | "−"] product {("+" | "−") product}
//   product = power {["·" | "×"] power | "/" power}
//   power   = primary {raised digits | "^" (primary | "−" primary)}
//   primary = number | fraction | symbol | "π" | "(" sum ")" | "|" sum "|" | "√" primary | function | "Σ" [index] product
//   function = name [raised digits] (primary | "(" sum {"," sum} ")"), of max, min and mean also name [index] primary
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
    int call(int named);
    int total();
    // Over the families that stand in `inner` and that nothing has run over yet.
    int over_families(Operation operation, int first, int inner, std::size_t begin);
    bool has_free_family(int first, int last) const;
    void check_families() const;  // every one is run over
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
    int named_here() const;  // of the functions that the formula was given; −1 for none
    void skip_index();       // "_i", "ₛ" behind a sign that runs over families
    std::optional<Real> fraction_here() const;
    [[noreturn]] void refuse(std::string_view what) const;
    [[noreturn]] void refuse_unknown() const;

    // --- nodes ---
    int add(Operation operation, std::vector<int> of, std::size_t begin);
    int add_number(Real value, std::size_t begin);
    int node_count() const { return static_cast<int>(f_.nodes_.size()); }

    Formula& f_;
    std::string_view text_;
    std::size_t at_ = 0;
    int bars_ = 0;  // open ones around this place
};

}  // namespace pliant
