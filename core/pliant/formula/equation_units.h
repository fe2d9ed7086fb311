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

namespace pliant {

class SymbolUnits {
public:
    // One that is added with two different units says nothing any more.
    void add(std::string_view symbol, const Unit& unit);
    // Of "x", "x_i", "k₀", "fᵈ". An index, a prime or a tilde that was not declared does not change the unit.
    std::optional<Unit> of(const Notation& symbol) const;

private:
    std::map<std::string, Unit> units_;
    std::set<std::string> ambiguous_;
};

struct EquationCheck {
    bool known = false;      // the units of all sides, of two at least
    std::string mismatch{};  // "N and m/s²: f = g"; "" when all is well as far as it is known
};

// "a = b", "a ← b", "a = b = c", up to a comma or a word behind its last side.
EquationCheck check_units(std::string_view equation, const SymbolUnits& symbols);

}  // namespace pliant
