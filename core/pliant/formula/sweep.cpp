#include <pliant/formula/sweep.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {

// --------------------------------------------------------------------------------------------------------------- values

FormulaSweep::FormulaSweep(const Formula& formula, std::span<const FormulaNumbers> numbers) : f_(formula), x_(numbers) {
    const std::size_t nodes = f_.nodes_.size();
    if (nodes > small_.size()) large_.resize(nodes);
    v_ = nodes > small_.size() ? std::span<Real>(large_) : std::span<Real>(small_).first(nodes);
    for (std::size_t k = 0; k < nodes; ++k) {
        const FormulaNode& n = f_.nodes_[k];
        if (n.repeated_for < 0) v_[k] = runs_over_family(n.operation) ? over_families(static_cast<int>(k)) : value(n, 0);
    }
}

std::size_t FormulaSweep::members(int node) const {
    const FormulaNode& whole = f_.nodes_[static_cast<std::size_t>(node)];
    std::size_t count = 0;
    bool any = false;
    for (int k = whole.first; k < node; ++k) {
        const FormulaNode& n = f_.nodes_[static_cast<std::size_t>(k)];
        if (n.repeated_for != node || n.operation != Operation::symbol || !f_.symbols_[static_cast<std::size_t>(n.symbol)].family)
            continue;
        const std::size_t size = x_[static_cast<std::size_t>(n.symbol)].count;
        if (any && size != count)
            throw BadFormula(f_.text_, n.begin, fmt::format("families of {} and of {} numbers run together here", count, size));
        count = size, any = true;
    }
    return count;
}

void FormulaSweep::set_member(int node, std::size_t member) {
    for (int k = f_.nodes_[static_cast<std::size_t>(node)].first; k < node; ++k) {
        const FormulaNode& n = f_.nodes_[static_cast<std::size_t>(k)];
        if (n.repeated_for == node) v_[static_cast<std::size_t>(k)] = value(n, member);
    }
}

Real FormulaSweep::over_families(int node) {
    const FormulaNode& n = f_.nodes_[static_cast<std::size_t>(node)];
    const std::size_t count = members(node);
    const bool adds = n.operation == Operation::total || n.operation == Operation::mean;
    if (!adds && count == 0) throw BadFormula(f_.text_, n.begin, "its family is empty: there is no largest or smallest");
    Real whole = 0;
    for (std::size_t k = 0; k < count; ++k) {
        set_member(node, k);
        const Real one = at(n.of[0]);
        if (adds)
            whole += one;
        else if (k == 0 || (n.operation == Operation::largest ? one > whole : one < whole))
            whole = one;
    }
    return n.operation == Operation::mean && count > 0 ? whole / static_cast<Real>(count) : whole;
}

std::vector<Real> FormulaSweep::arguments(const FormulaNode& n) const {
    std::vector<Real> all;
    for (const int k : n.of) {
        const FormulaNode& argument = f_.nodes_[static_cast<std::size_t>(k)];
        if (argument.operation != Operation::family) {
            all.push_back(at(k));
            continue;
        }
        const FormulaNumbers& family = x_[static_cast<std::size_t>(argument.symbol)];
        for (std::size_t i = 0; i < family.count; ++i) all.push_back(family[i]);
    }
    return all;
}

Real FormulaSweep::value(const FormulaNode& n, std::size_t member) const {
    const auto operand = [&](std::size_t i) { return at(n.of[i]); };
    switch (n.operation) {
        case Operation::number:
            return n.number;
        case Operation::symbol: {
            const FormulaNumbers& numbers = x_[static_cast<std::size_t>(n.symbol)];
            return numbers[numbers.count > 1 ? member : 0];
        }
        case Operation::negative:
            return -operand(0);
        case Operation::sum:
            return operand(0) + operand(1);
        case Operation::difference:
            return operand(0) - operand(1);
        case Operation::product:
            return operand(0) * operand(1);
        case Operation::quotient:
            return operand(0) / operand(1);
        case Operation::power:
            return power_of(operand(0), operand(1));
        case Operation::root:
            return std::sqrt(operand(0));
        case Operation::magnitude:
            return std::abs(operand(0));
        case Operation::call: {
            Real whole = n.of_degrees ? operand(0) * radians_of_degree : operand(0);
            if (n.of.size() == 1 && n.function != Function::min && n.function != Function::max)
                whole = called(n.function, whole, 0);
            for (std::size_t i = 1; i < n.of.size(); ++i) whole = called(n.function, whole, operand(i));
            return whole;
        }
        case Operation::named:
            return f_.functions_[static_cast<std::size_t>(n.symbol)].value(arguments(n));
        case Operation::family:
        case Operation::total:
        case Operation::mean:
        case Operation::largest:
        case Operation::smallest:
            return 0;
    }
    return 0;
}

// ------------------------------------------------------------------------------------------------------------- gradient

std::size_t FormulaSweep::first_number(int symbol) const {
    std::size_t first = 0;
    for (int s = 0; s < symbol; ++s) first += x_[static_cast<std::size_t>(s)].count;
    return first;
}

std::vector<Real> FormulaSweep::gradient() {
    std::vector<Real> by_node(v_.size(), 0), by_number(first_number(static_cast<int>(x_.size())), 0);
    by_node.back() = 1;
    for (std::size_t k = v_.size(); k-- > 0;) {
        const FormulaNode& n = f_.nodes_[k];
        if (n.repeated_for >= 0 || by_node[k] == 0) continue;
        if (runs_over_family(n.operation))
            pass_back_over_families(static_cast<int>(k), by_node, by_number);
        else
            pass_back(static_cast<int>(k), 0, by_node, by_number);
    }
    return by_number;
}

void FormulaSweep::pass_back_over_families(int node, std::vector<Real>& by_node, std::vector<Real>& by_number) {
    const FormulaNode& n = f_.nodes_[static_cast<std::size_t>(node)];
    const std::size_t count = members(node);
    const bool adds = n.operation == Operation::total || n.operation == Operation::mean;
    const Real whole = at(node), g = by_node[static_cast<std::size_t>(node)];
    for (std::size_t member = 0; member < count; ++member) {
        set_member(node, member);
        if (!adds && at(n.of[0]) != whole) continue;
        for (int k = n.first; k < node; ++k)
            if (f_.nodes_[static_cast<std::size_t>(k)].repeated_for == node) by_node[static_cast<std::size_t>(k)] = 0;
        by_node[static_cast<std::size_t>(n.of[0])] += n.operation == Operation::mean ? g / static_cast<Real>(count) : g;
        for (int k = node - 1; k >= n.first; --k)
            if (f_.nodes_[static_cast<std::size_t>(k)].repeated_for == node && by_node[static_cast<std::size_t>(k)] != 0)
                pass_back(k, member, by_node, by_number);
        if (!adds) return;
    }
}

// A part in a million of the size of the numbers to be moved.
void FormulaSweep::pass_back_through(const FormulaNode& n, Real g, std::vector<Real>& by_node,
                                     std::vector<Real>& by_number) const {
    constexpr Real nudge = 1e-6;
    constexpr std::size_t most = 512;
    const auto& function = f_.functions_[static_cast<std::size_t>(n.symbol)].value;
    std::vector<Real> arguments_now = arguments(n);
    const Real here = function(arguments_now);
    std::size_t at_argument = 0;
    for (const int k : n.of) {
        const FormulaNode& argument = f_.nodes_[static_cast<std::size_t>(k)];
        const bool many = argument.operation == Operation::family;
        const std::size_t count = many ? x_[static_cast<std::size_t>(argument.symbol)].count : 1;
        Real size = 0;
        for (std::size_t i = 0; i < count; ++i) size = std::max(size, std::abs(arguments_now[at_argument + i]));
        const std::size_t stride = count / most + 1;
        for (std::size_t i = 0; size > 0 && i < count; i += stride) {
            Real& moved = arguments_now[at_argument + i];
            const Real kept = moved;
            moved = kept + nudge * size;
            const Real slope = g * (function(arguments_now) - here) / (moved - kept);
            moved = kept;
            for (std::size_t j = i; j < std::min(i + stride, count); ++j)
                (many ? by_number[first_number(argument.symbol) + j] : by_node[static_cast<std::size_t>(k)]) += slope;
        }
        at_argument += count;
    }
}

void FormulaSweep::pass_back(int node, std::size_t member, std::vector<Real>& by_node, std::vector<Real>& by_number) {
    const FormulaNode& n = f_.nodes_[static_cast<std::size_t>(node)];
    const Real g = by_node[static_cast<std::size_t>(node)], own = at(node);
    const auto operand = [&](std::size_t i) { return at(n.of[i]); };
    const auto pass_on = [&](std::size_t i, Real factor) { by_node[static_cast<std::size_t>(n.of[i])] += g * factor; };
    switch (n.operation) {
        case Operation::symbol:
            by_number[first_number(n.symbol) + (x_[static_cast<std::size_t>(n.symbol)].count > 1 ? member : 0)] += g;
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
            pass_on(0, 1 / operand(1)), pass_on(1, -own / operand(1));
            break;
        case Operation::power:
            if (operand(1) != 0) pass_on(0, operand(1) * power_of(operand(0), operand(1) - 1));
            if (f_.nodes_[static_cast<std::size_t>(n.of[1])].operation != Operation::number && operand(0) > 0)
                pass_on(1, own * std::log(operand(0)));
            break;
        case Operation::root:
            pass_on(0, 0.5 / own);
            break;
        case Operation::magnitude:
            pass_on(0, operand(0) < 0 ? -1 : 1);
            break;
        case Operation::call:
            if (n.function == Function::min || n.function == Function::max) {
                std::size_t wins = 0;
                while (wins + 1 < n.of.size() && operand(wins) != own) ++wins;
                pass_on(wins, 1);
            } else if (n.function == Function::atan2) {
                const Real square = operand(0) * operand(0) + operand(1) * operand(1);
                pass_on(0, operand(1) / square), pass_on(1, -operand(0) / square);
            } else {
                const Real unit = n.of_degrees ? radians_of_degree : 1;
                pass_on(0, slope_of(n.function, operand(0) * unit) * unit);
            }
            break;
        case Operation::named:
            pass_back_through(n, g, by_node, by_number);
            break;
        case Operation::number:
        case Operation::family:
        case Operation::total:
        case Operation::mean:
        case Operation::largest:
        case Operation::smallest:
            break;
    }
}

}  // namespace pliant
