// The units of an equation as a lecture writes it, with ∇, Σ and transposes: of symbols whose units are known. Nothing is
// evaluated; a vector or a matrix has the unit of its entries.
#pragma once
#include <pliant/formula/notation.h>
#include <pliant/formula/unit.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

class SymbolUnits {
public:
    // One that is added with two different units says nothing any more.
    void add(std::string_view symbol, const Unit& unit);
    // In place of all that was added.
    void set(std::string_view symbol, const Unit& unit);
    // What others say of symbols that nothing is known of here.
    void complete_with(SymbolUnits others);
    // Of "x", "x_i", "k₀", "fᵈ". An index, a prime or a tilde that was not declared does not change the unit; two primes make a
    // rate of a rate. A hat may make a direction of a vector: nothing is known of it unless it is declared.
    std::optional<Unit> of(const Notation& symbol) const;

private:
    std::optional<Unit> declared(const Notation& symbol) const;

    std::map<std::string, Unit> units_;
    std::set<std::string> ambiguous_;
    std::vector<SymbolUnits> others_;
};

struct EquationCheck {
    bool known = false;      // the units of all sides
    std::string mismatch{};  // "N and m/s²: f = g"; "" when all is well as far as it is known
    std::string unknown{};   // the first symbol that is not, "x_ij", or "words"
};

// "a = b", "a ← b", "a ≤ b = c": one or several, parted by commas or words; what has no relation is none. Proportions have sides
// of any unit. A side of words alone is not known.
EquationCheck check_units(std::string_view equation, const SymbolUnits& symbols);

}  // namespace pliant
