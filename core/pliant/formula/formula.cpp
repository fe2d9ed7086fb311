#include <pliant/formula/formula.h>
#include <pliant/formula/reader.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace pliant {
namespace {

constexpr Real radians_of_degree = std::numbers::pi / 180;

// A whole power by products, so that x² has the bits of x · x.
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
    }
    return 0;
}

// Of a function of one argument.
Real slope(Function f, Real a) {
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

bool is_one_of_two(Function f) { return f == Function::min || f == Function::max; }

}  // namespace

Formula::Formula(std::string text, std::vector<std::string> symbols, std::vector<Unit> units)
    : text_(std::move(text)), symbols_(std::move(symbols)), units_(std::move(units)) {
    FormulaReader(*this).read();
    if (has_units()) mark_degrees();
}

std::vector<Real> Formula::values_of_nodes(std::span<const Real> values) const {
    std::vector<Real> v(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const FormulaNode& n = nodes_[k];
        const auto operand = [&](std::size_t i) { return v[static_cast<std::size_t>(n.of[i])]; };
        switch (n.operation) {
            case Operation::number:
                v[k] = n.number;
                break;
            case Operation::symbol:
                v[k] = values[static_cast<std::size_t>(n.symbol)];
                break;
            case Operation::negative:
                v[k] = -operand(0);
                break;
            case Operation::sum:
                v[k] = operand(0) + operand(1);
                break;
            case Operation::difference:
                v[k] = operand(0) - operand(1);
                break;
            case Operation::product:
                v[k] = operand(0) * operand(1);
                break;
            case Operation::quotient:
                v[k] = operand(0) / operand(1);
                break;
            case Operation::power:
                v[k] = power_of(operand(0), operand(1));
                break;
            case Operation::root:
                v[k] = std::sqrt(operand(0));
                break;
            case Operation::magnitude:
                v[k] = std::abs(operand(0));
                break;
            case Operation::call: {
                Real whole = n.of_degrees ? operand(0) * radians_of_degree : operand(0);
                if (n.of.size() == 1 && !is_one_of_two(n.function)) whole = called(n.function, whole, 0);
                for (std::size_t i = 1; i < n.of.size(); ++i) whole = called(n.function, whole, operand(i));
                v[k] = whole;
                break;
            }
        }
    }
    return v;
}

Real Formula::evaluate(std::span<const Real> values) const { return values_of_nodes(values).back(); }

std::vector<Real> Formula::gradient(std::span<const Real> values) const {
    const std::vector<Real> v = values_of_nodes(values);
    std::vector<Real> by_node(nodes_.size(), 0), by_symbol(symbols_.size(), 0);
    by_node.back() = 1;
    for (std::size_t k = nodes_.size(); k-- > 0;) {
        const FormulaNode& n = nodes_[k];
        const Real g = by_node[k];
        if (g == 0) continue;
        const auto operand = [&](std::size_t i) { return v[static_cast<std::size_t>(n.of[i])]; };
        const auto pass_on = [&](std::size_t i, Real factor) { by_node[static_cast<std::size_t>(n.of[i])] += g * factor; };
        switch (n.operation) {
            case Operation::number:
                break;
            case Operation::symbol:
                by_symbol[static_cast<std::size_t>(n.symbol)] += g;
                break;
            case Operation::negative:
                pass_on(0, -1);
                break;
            case Operation::sum:
                pass_on(0, 1), pass_on(1, 1);
                break;
            case Operation::difference:
                pass_on(0, 1), pass_on(1, -1);
                break;
            case Operation::product:
                pass_on(0, operand(1)), pass_on(1, operand(0));
                break;
            case Operation::quotient:
                pass_on(0, 1 / operand(1)), pass_on(1, -v[k] / operand(1));
                break;
            case Operation::power:
                if (operand(1) != 0) pass_on(0, operand(1) * power_of(operand(0), operand(1) - 1));
                if (nodes_[static_cast<std::size_t>(n.of[1])].operation != Operation::number && operand(0) > 0)
                    pass_on(1, v[k] * std::log(operand(0)));
                break;
            case Operation::root:
                pass_on(0, 0.5 / v[k]);
                break;
            case Operation::magnitude:
                pass_on(0, operand(0) < 0 ? -1 : 1);
                break;
            case Operation::call:
                if (is_one_of_two(n.function)) {
                    for (std::size_t i = 0; i < n.of.size(); ++i)
                        if (operand(i) == v[k]) {
                            pass_on(i, 1);
                            break;
                        }
                } else if (n.function == Function::atan2) {
                    const Real square = operand(0) * operand(0) + operand(1) * operand(1);
                    pass_on(0, operand(1) / square), pass_on(1, -operand(0) / square);
                } else {
                    const Real unit = n.of_degrees ? radians_of_degree : 1;
                    pass_on(0, slope(n.function, operand(0) * unit) * unit);
                }
                break;
        }
    }
    return by_symbol;
}

}  // namespace pliant
