// The values of a formula's nodes for given numbers, and how the whole changes with each of them.
#pragma once
#include <pliant/formula/formula.h>

#include <array>

namespace pliant {

// The slope of its one argument, of a function by name.
Real slope_of(Function function, Real at);
Real called(Function function, Real a, Real b);
// A whole power by products, so that x² has the bits of x · x.
Real power_of(Real base, Real exponent);

inline constexpr Real radians_of_degree = 0.017453292519943295;

class FormulaSweep {
public:
    FormulaSweep(const Formula& formula, std::span<const FormulaNumbers> numbers);

    // Of a node that nothing repeats.
    Real at(int node) const { return v_[static_cast<std::size_t>(node)]; }
    Real whole() const { return v_.back(); }
    // Of what runs over families: how many members they have. It takes the values that belong to one of them, and their whole.
    std::size_t members(int node) const;
    void set_member(int node, std::size_t k);
    // What a named function takes.
    std::vector<Real> arguments(const FormulaNode& n) const;

    std::vector<Real> gradient();

private:
    Real value(const FormulaNode& n, std::size_t member) const;
    Real over_families(int node);
    // Passes what the whole changes with a node on to its operands.
    void pass_back(int node, std::size_t member, std::vector<Real>& by_node, std::vector<Real>& by_number);
    void pass_back_over_families(int node, std::vector<Real>& by_node, std::vector<Real>& by_number);
    void pass_back_through(const FormulaNode& n, Real g, std::vector<Real>& by_node, std::vector<Real>& by_number) const;
    std::size_t first_number(int symbol) const;

    const Formula& f_;
    std::span<const FormulaNumbers> x_;
    std::array<Real, 128> small_;  // holds the values of most formulas
    std::vector<Real> large_{};
    std::span<Real> v_;
};

}  // namespace pliant
