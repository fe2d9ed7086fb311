// Numbers put into a formula, from its tree: with their units, and with parentheses where a sign, a power or a divisor needs
// them.
#include <pliant/formula/reader.h>
#include <pliant/formula/sweep.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace pliant {
namespace {

enum class Binding { sum, product, whole };  // how closely a text holds together

struct Printed {
    std::string text;
    Binding binding = Binding::whole;
};

std::string enclosed(const std::string& text) { return fmt::format("({})", text); }
std::string at_least(Binding needed, const Printed& p) { return p.binding < needed ? enclosed(p.text) : p.text; }

class NumbersPrinter {
public:
    NumbersPrinter(const Formula& formula, std::span<const FormulaNumbers> numbers, std::span<const std::string> units)
        : f_(formula), x_(numbers), units_(units), sweep_(formula, numbers) {}

    std::string whole() { return print(static_cast<int>(f_.nodes().size()) - 1, true).text; }

private:
    const FormulaNode& node(int k) const { return f_.nodes()[static_cast<std::size_t>(k)]; }
    std::string written(const FormulaNode& n) const { return f_.text().substr(n.begin, n.end - n.begin); }

    // first: nothing stands before it, or an opening parenthesis.
    Printed print(int k, bool first) {
        const FormulaNode& n = node(k);
        if (!n.grouped) return bare(k, n, first);
        const Printed inner = bare(k, n, true);
        const bool needless = inner.binding == Binding::whole && !inner.text.starts_with('-');
        return {needless ? inner.text : enclosed(inner.text)};
    }

    Printed bare(int k, const FormulaNode& n, bool first) {
        // Within a longer sum a mean or a largest stands as what it gives.
        if (in_family_ && runs_over_family(n.operation) && node(n.of[0]).operation == Operation::symbol)
            return number(sweep_.at(k), units_[static_cast<std::size_t>(node(n.of[0]).symbol)], first);
        const auto operand = [&](std::size_t i, bool stands_first) { return print(n.of[i], stands_first); };
        switch (n.operation) {
            case Operation::number:
                return {written(n)};
            case Operation::symbol: {
                const FormulaNumbers& numbers = x_[static_cast<std::size_t>(n.symbol)];
                return number(numbers[numbers.count > 1 ? member_ : 0], units_[static_cast<std::size_t>(n.symbol)], first);
            }
            case Operation::negative:
                return {"−" + at_least(Binding::product, operand(0, false)), Binding::sum};
            case Operation::sum:
            case Operation::difference:
                return {fmt::format("{} {} {}", operand(0, first).text, n.operation == Operation::sum ? "+" : "−",
                                    n.operation == Operation::sum && node(n.of[1]).operation == Operation::total
                                        ? operand(1, false).text
                                        : at_least(Binding::product, operand(1, false))),
                        Binding::sum};
            case Operation::product:
                return {fmt::format("{} · {}", at_least(Binding::product, operand(0, first)),
                                    at_least(Binding::product, operand(1, false))),
                        Binding::product};
            case Operation::quotient:
                return {fmt::format("{} / {}", at_least(Binding::product, operand(0, first)),
                                    at_least(Binding::whole, operand(1, false))),
                        Binding::product};
            case Operation::power:
                return power(n);
            case Operation::root:
                return {"√" + (node(n.of[0]).grouped ? enclosed(bare(n.of[0], node(n.of[0]), true).text)
                                                     : at_least(Binding::whole, operand(0, false)))};
            case Operation::magnitude:
                return {fmt::format("|{}|", operand(0, true).text)};
            case Operation::call:
                return {fmt::format("{}({})", name_of(n.function), listed(n))};
            case Operation::named:
                return named(k, n, first);
            case Operation::family:
                return {};
            case Operation::total:
                return total(k, n, first);
            case Operation::mean:
                return mean(k, n);
            case Operation::largest:
            case Operation::smallest:
                return {fmt::format("{}({})", n.operation == Operation::largest ? "max" : "min", members(k, n))};
        }
        return {};
    }

    Printed number(Real value, const std::string& unit, bool first) const {
        const std::string text = format_quantity(value, unit, 6);
        if (text.starts_with('-') && !first) return {enclosed(text)};
        const bool one = text.find(' ') == text.npos && text.find("×") == text.npos;
        return {text, one && !text.starts_with('-') ? Binding::whole : Binding::product};
    }

    // "3²", "(2 m/s)²", "sin²(0.5)", "2^(−0.3)"
    Printed power(const FormulaNode& n) {
        const FormulaNode& base = node(n.of[0]);
        const FormulaNode& exponent = node(n.of[1]);
        const std::string raised = exponent.operation == Operation::number && !exponent.grouped ? written(exponent) : "";
        const bool digits = !raised.empty() && !(raised[0] >= '0' && raised[0] <= '9');
        if (base.operation == Operation::call && !base.grouped && digits)
            return {fmt::format("{}{}({})", name_of(base.function), raised, listed(base))};
        const Printed below = print(n.of[0], false);
        // 10⁻³ has an exponent already.
        const bool bare_number = below.text.find("10") != below.text.npos && base.operation == Operation::symbol &&
                                 below.text.back() != ')' && (static_cast<unsigned char>(below.text.back()) & 0x80) != 0;
        const std::string text = bare_number ? enclosed(below.text) : at_least(Binding::whole, below);
        if (digits) return {text + raised};
        return {fmt::format("{}^({})", text, bare(n.of[1], exponent, true).text)};
    }

    std::string listed(const FormulaNode& n) {
        std::string all;
        for (const int k : n.of)
            all += (all.empty() ? "" : ", ") + (node(k).grouped ? bare(k, node(k), true) : print(k, true)).text;
        return all;
    }

    // ---- families ----
    // Of terms that are long themselves fewer.
    static std::size_t shown_of(std::size_t count, bool long_terms = false) {
        const std::size_t most = long_terms ? 4 : 8;
        return count > most ? most - 2 : count;
    }
    static bool is_long(int k, const FormulaNode& n) { return k - n.first > 8; }

    // Those that are not 0, or all where that leaves none.
    std::vector<std::size_t> telling(int k, const FormulaNode& n) {
        std::vector<std::size_t> some;
        for (std::size_t i = 0; i < sweep_.members(k); ++i) {
            sweep_.set_member(k, i);
            if (sweep_.at(n.of[0]) != 0) some.push_back(i);
        }
        return some;
    }
    Printed member(int k, const FormulaNode& n, std::size_t i, bool first) {
        sweep_.set_member(k, i);
        const std::size_t outer = std::exchange(member_, i);
        const bool outside = std::exchange(in_family_, true);
        Printed one = print(n.of[0], first);
        member_ = outer, in_family_ = outside;
        return one;
    }
    // By their size, the largest first; those of one size stay in turn.
    void sort_by_size(int k, const FormulaNode& n, std::vector<std::size_t>& members) {
        const auto size = [&](std::size_t i) {
            sweep_.set_member(k, i);
            return std::abs(sweep_.at(n.of[0]));
        };
        std::ranges::stable_sort(members, std::ranges::greater{}, size);
    }
    // "15 more, together −0.2 N".
    std::string rest_of(int k, const FormulaNode& n, std::span<const std::size_t> members) {
        Real sum = 0;
        for (const std::size_t i : members) sweep_.set_member(k, i), sum += sweep_.at(n.of[0]);
        const auto unit = f_.unit_at(n.of[0]);
        return fmt::format("{} more, together {}", members.size(),
                           format_quantity(sum, unit && !unit->is_number() ? unit->usual_text() : "", 6));
    }
    // Terms with their signs; of a long sum the largest ones stand for all.
    Printed added(int k, const FormulaNode& n, std::vector<std::size_t> members) {
        if (members.empty()) return {"0"};
        std::string text;
        const std::size_t shown = shown_of(members.size(), is_long(k, n));
        if (shown < members.size()) sort_by_size(k, n, members);
        Binding binding = Binding::sum;
        for (std::size_t i = 0; i < shown; ++i) {
            const Printed one = member(k, n, members[i], true);
            const bool minus = one.text.starts_with('-');
            text += i == 0 ? (minus ? "−" : "") : (minus ? " − " : " + ");
            text += minus ? one.text.substr(1) : at_least(Binding::product, one);
            if (members.size() == 1 && !minus) binding = one.binding;
        }
        if (shown < members.size()) text += fmt::format(" + … ({})", rest_of(k, n, std::span(members).subspan(shown)));
        return {text, binding};
    }
    Printed total(int k, const FormulaNode& n, bool first) {
        Printed all = added(k, n, telling(k, n));
        if (all.text.starts_with("−") && !first) return {enclosed(all.text)};
        return all;
    }
    Printed mean(int k, const FormulaNode& n) {
        return {fmt::format("{} / {}", at_least(Binding::product, added(k, n, telling(k, n))), sweep_.members(k)),
                Binding::product};
    }
    std::string members(int k, const FormulaNode& n) {
        const std::size_t count = sweep_.members(k), shown = shown_of(count, is_long(k, n));
        std::string text;
        for (std::size_t i = 0; i < shown; ++i) text += (i ? ", " : "") + member(k, n, i, true).text;
        if (shown < count) text += fmt::format(", … ({} numbers)", count);
        return text;
    }

    // ---- named functions ----
    // Alone it shows what it takes; within a formula, what it gives.
    Printed named(int k, const FormulaNode& n, bool first) {
        const FormulaFunction& function = f_.functions()[static_cast<std::size_t>(n.symbol)];
        if (static_cast<std::size_t>(k) + 1 < f_.nodes().size())
            return number(sweep_.at(k), function.unit.is_number() ? "" : function.unit.usual_text(), first);
        std::string all;
        for (const int of : n.of)
            all += (all.empty() ? "" : ", ") +
                   (node(of).operation == Operation::family ? family(node(of).symbol) : print(of, true).text);
        return {fmt::format("{}({})", function.name, all)};
    }
    // Nine numbers are a matrix.
    std::string family(int symbol) {
        const FormulaNumbers& numbers = x_[static_cast<std::size_t>(symbol)];
        const std::string& unit = units_[static_cast<std::size_t>(symbol)];
        std::string text;
        if (numbers.count == 9) {
            for (std::size_t i = 0; i < 9; ++i)
                text += fmt::format("{}{}", i == 0 ? "" : i % 3 ? " " : "; ", format_quantity(numbers[i], "", 6));
            return unit.empty() ? fmt::format("[{}]", text) : fmt::format("[{}] {}", text, unit);
        }
        const std::size_t shown = shown_of(numbers.count);
        for (std::size_t i = 0; i < shown; ++i) text += (i ? ", " : "") + format_quantity(numbers[i], unit, 6);
        if (shown < numbers.count) text += fmt::format(", … ({} numbers)", numbers.count);
        return text;
    }

    const Formula& f_;
    std::span<const FormulaNumbers> x_;
    std::span<const std::string> units_;
    FormulaSweep sweep_;
    std::size_t member_ = 0;
    bool in_family_ = false;
};

}  // namespace

std::string Formula::with_numbers(std::span<const FormulaNumbers> numbers, std::span<const std::string> units) const {
    return NumbersPrinter(*this, numbers, units).whole();
}

}  // namespace pliant
