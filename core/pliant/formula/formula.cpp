#include <pliant/formula/formula.h>
#include <pliant/formula/reader.h>
#include <pliant/formula/sweep.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace pliant {

Real power_of(Real base, Real exponent) {
    if (exponent == 2) return base * base;
    if (exponent == 3) return base * base * base;
    if (exponent == 1) return base;
    return std::pow(base, exponent);
}

Real called(Function f, Real a, Real b) {
    switch (f) {
        case Function::sin:
            return std::sin(a);
        case Function::cos:
            return std::cos(a);
        case Function::tan:
            return std::tan(a);
        case Function::asin:
            return std::asin(a);
        case Function::acos:
            return std::acos(a);
        case Function::atan:
            return std::atan(a);
        case Function::atan2:
            return std::atan2(a, b);
        case Function::sinh:
            return std::sinh(a);
        case Function::cosh:
            return std::cosh(a);
        case Function::tanh:
            return std::tanh(a);
        case Function::exp:
            return std::exp(a);
        case Function::ln:
            return std::log(a);
        case Function::log10:
            return std::log10(a);
        case Function::floor:
            return std::floor(a);
        case Function::min:
            return std::min(a, b);
        case Function::max:
            return std::max(a, b);
        case Function::mean:
            return a;
    }
    return 0;
}

Real slope_of(Function f, Real a) {
    switch (f) {
        case Function::sin:
            return std::cos(a);
        case Function::cos:
            return -std::sin(a);
        case Function::tan:
            return 1 / (std::cos(a) * std::cos(a));
        case Function::asin:
            return 1 / std::sqrt(1 - a * a);
        case Function::acos:
            return -1 / std::sqrt(1 - a * a);
        case Function::atan:
            return 1 / (1 + a * a);
        case Function::sinh:
            return std::cosh(a);
        case Function::cosh:
            return std::sinh(a);
        case Function::tanh:
            return 1 / (std::cosh(a) * std::cosh(a));
        case Function::exp:
            return std::exp(a);
        case Function::ln:
            return 1 / a;
        case Function::log10:
            return 1 / (a * std::numbers::ln10);
        default:
            return 0;  // floor: but where it jumps
    }
}

Formula::Formula(std::string text, std::vector<FormulaSymbol> symbols, std::vector<FormulaFunction> functions)
    : text_(std::move(text)), symbols_(std::move(symbols)), functions_(std::move(functions)) {
    FormulaReader(*this).read();
    if (has_units()) mark_degrees();
}

bool Formula::has_units() const {
    return std::ranges::all_of(symbols_, [](const FormulaSymbol& s) { return s.unit.has_value(); });
}

bool Formula::by_differences(int symbol) const {
    const auto takes = [&](const FormulaNode& n) {
        return (n.operation == Operation::symbol || n.operation == Operation::family) && n.symbol == symbol;
    };
    for (auto n = nodes_.begin(); n != nodes_.end(); ++n)
        if (n->operation == Operation::named && std::any_of(nodes_.begin() + n->first, n, takes)) return true;
    return false;
}

namespace {

std::vector<FormulaNumbers> one_by_one(std::span<const Real> values) {
    std::vector<FormulaNumbers> numbers;
    for (const Real& value : values) numbers.push_back({&value});
    return numbers;
}

}  // namespace

Real Formula::evaluate(std::span<const FormulaNumbers> numbers) const { return FormulaSweep(*this, numbers).whole(); }
Real Formula::evaluate(std::span<const Real> values) const { return evaluate(one_by_one(values)); }

std::vector<Real> Formula::gradient(std::span<const FormulaNumbers> numbers) const {
    return FormulaSweep(*this, numbers).gradient();
}
std::vector<Real> Formula::gradient(std::span<const Real> values) const { return gradient(one_by_one(values)); }

}  // namespace pliant
