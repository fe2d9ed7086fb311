// The unit of a formula follows from those of its symbols: terms have the same, powers are numbers, functions take numbers.
#include <pliant/formula/formula.h>

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace pliant {
namespace {

using Found = std::optional<Unit>;  // empty: suits every unit, as 0 does

struct Mismatch {
    std::string words;
};

bool takes_angle(Function f) { return f == Function::sin || f == Function::cos || f == Function::tan; }
bool compares(Function f) { return f == Function::min || f == Function::max || f == Function::floor; }

std::string unit_words(const Unit& unit) { return unit.is_number() ? "a number" : unit.text(); }

class UnitSweep {
public:
    explicit UnitSweep(const Formula& formula) : formula_(formula) {
        for (const FormulaNode& n : formula.nodes()) found_.push_back(of(n));
    }
    const Found& whole() const { return found_.back(); }
    const Found& at(int node) const { return found_[static_cast<std::size_t>(node)]; }

private:
    std::string_view written(const FormulaNode& n) const {
        return std::string_view(formula_.text()).substr(n.begin, n.end - n.begin);
    }
    [[noreturn]] void refuse(const FormulaNode& n, const std::string& words) const {
        throw Mismatch{fmt::format("{} in {}", words, written(n))};
    }
    Found same(const FormulaNode& n, const Found& a, const Found& b) const {
        if (!a || !b) return a ? a : b;
        if (*a != *b) refuse(n, fmt::format("{} and {}", unit_words(*a), unit_words(*b)));
        return a;
    }
    Found number(const FormulaNode& n, const Found& a, std::string_view what) const {
        if (a && !a->is_number()) refuse(n, fmt::format("{} of {}", what, unit_words(*a)));
        return Unit();
    }
    Found raised(const FormulaNode& n) const {
        number(n, at(n.of[1]), "a power");
        const Found base = at(n.of[0]);
        if (!base || base->is_number()) return base;
        const FormulaNode& exponent = formula_.nodes()[static_cast<std::size_t>(n.of[1])];
        if (exponent.operation != Operation::number || exponent.number != std::round(exponent.number))
            refuse(n, fmt::format("{} raised to no whole number", unit_words(*base)));
        return base->power(static_cast<int>(exponent.number));
    }
    Found root_of(const FormulaNode& n) const {
        const Found square = at(n.of[0]);
        if (!square) return square;
        const auto side = square->power(1, 2);
        if (!side) refuse(n, fmt::format("a root of {}", unit_words(*square)));
        return side;
    }
    Found of_call(const FormulaNode& n) const {
        if (compares(n.function) || n.function == Function::atan2) {
            Found whole = at(n.of[0]);
            for (const int k : n.of) whole = same(n, whole, at(k));
            return compares(n.function) ? whole : Found(Unit());
        }
        const Found argument = at(n.of[0]);
        if (takes_angle(n.function) && argument == Unit("°")) return Unit();
        return number(n, argument, name_of(n.function));
    }
    Found of(const FormulaNode& n) const {
        const auto operand = [&](std::size_t i) { return at(n.of[i]); };
        switch (n.operation) {
            case Operation::number:
                return n.of_degrees ? Found(Unit("°")) : n.number == 0 ? Found() : Found(Unit());
            case Operation::symbol:
            case Operation::family:
                return formula_.symbols()[static_cast<std::size_t>(n.symbol)].unit;
            case Operation::named:
                return formula_.functions()[static_cast<std::size_t>(n.symbol)].unit;
            case Operation::negative:
            case Operation::magnitude:
            case Operation::total:
            case Operation::mean:
            case Operation::largest:
            case Operation::smallest:
                return operand(0);
            case Operation::sum:
            case Operation::difference:
                return same(n, operand(0), operand(1));
            case Operation::product:
                return operand(0) && operand(1) ? Found(*operand(0) * *operand(1)) : Found();
            case Operation::quotient:
                return operand(0) && operand(1) ? Found(*operand(0) / *operand(1)) : Found();
            case Operation::power:
                return raised(n);
            case Operation::root:
                return root_of(n);
            case Operation::call:
                return of_call(n);
        }
        return Found();
    }

    const Formula& formula_;
    std::vector<Found> found_;
};

}  // namespace

Formula::UnitCheck Formula::check_units() const {
    try {
        return {UnitSweep(*this).whole(), ""};
    } catch (const Mismatch& m) {
        return {std::nullopt, m.words};
    }
}

std::optional<Unit> Formula::unit_at(int node) const {
    try {
        return has_units() ? UnitSweep(*this).at(node) : std::nullopt;
    } catch (const Mismatch&) {
        return std::nullopt;
    }
}

void Formula::mark_degrees() {
    std::optional<UnitSweep> sweep;
    try {
        sweep.emplace(*this);
    } catch (const Mismatch&) {
        return;  // told by check_units
    }
    for (FormulaNode& n : nodes_)
        if (n.operation == Operation::call) n.of_degrees = takes_angle(n.function) && sweep->at(n.of[0]) == Unit("°");
}

}  // namespace pliant
