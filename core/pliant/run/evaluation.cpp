#include <pliant/formula/formula.h>
#include <pliant/formula/notation.h>
#include <pliant/run/evaluation.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace pliant {
namespace {

// What the formula of an explanation is read against, and what is put in: a symbol of its own for each input but those of a
// family.
struct Slots {
    std::vector<FormulaSymbol> symbols{};
    std::vector<std::string> units{};
    std::vector<std::vector<Real>> numbers{};
    std::vector<std::vector<std::size_t>> inputs{};  // that give them

    std::vector<FormulaNumbers> values() const {
        std::vector<FormulaNumbers> all;
        for (const auto& of_symbol : numbers) all.push_back({of_symbol.data(), of_symbol.size()});
        return all;
    }
    // By symbol, of one in the order of its inputs.
    std::vector<Real> by_input(std::span<const Real> flat, std::size_t count) const {
        std::vector<Real> all(count, 0);
        std::size_t at = 0;
        for (const auto& of_symbol : inputs)
            for (const std::size_t input : of_symbol) all[input] = flat[at++];
        return all;
    }
};

Unit unit_in(const FormulaText& formula, std::string_view symbol, std::string_view unit) {
    try {
        return Unit(unit);
    } catch (const Refused& e) {
        const std::size_t at = formula.find(symbol, std::min(formula.find('='), formula.size()));
        throw BadFormula(formula, at == formula.npos ? 0 : at, e.what());
    }
}

Slots slots_of(const Answer& a, const Explanation& e) {
    Slots slots;
    std::map<std::string, std::size_t> families;
    for (std::size_t k = 0; k < a.inputs.size(); ++k) {
        const Answer& input = a.inputs[k];
        const std::string& family = e.inputs[k].family;
        const auto known = families.find(family);
        if (!family.empty() && known != families.end()) {
            slots.numbers[known->second].push_back(input.value), slots.inputs[known->second].push_back(k);
            if (input.unit != slots.units[known->second])
                throw BadFormula(
                    e.formula, std::min(e.formula.find(family), e.formula.size()),
                    fmt::format("a family has one unit, not {} and {}", unit_or_dimensionless(slots.units[known->second]),
                                unit_or_dimensionless(input.unit)));
            continue;
        }
        if (!family.empty()) families.emplace(family, slots.symbols.size());
        const std::string& symbol = family.empty() ? input.symbol : family;
        slots.symbols.push_back({symbol, unit_in(e.formula, symbol, input.unit), !family.empty()});
        slots.units.push_back(input.unit);
        slots.numbers.push_back({input.value}), slots.inputs.push_back({k});
    }
    return slots;
}

Formula read(const Slots& slots, const Explanation& e) {
    std::vector<FormulaFunction> functions;
    for (const NamedFunction& f : e.functions) functions.push_back({f.name, unit_in(e.formula, f.name, f.unit), f.value});
    return Formula(e.formula, slots.symbols, std::move(functions));
}

// A root at 0 has no slope there: what its inputs lose to rounding tells how much they matter.
std::vector<Real> gradient_of(const Formula& formula, const Slots& slots, Answer& a) {
    const std::vector<FormulaNumbers> numbers = slots.values();
    std::vector<Real> gradient = slots.by_input(formula.gradient(numbers), a.inputs.size());
    for (std::size_t s = 0; s < slots.inputs.size(); ++s)
        for (std::size_t i = 0; i < slots.inputs[s].size(); ++i) {
            const std::size_t input = slots.inputs[s][i];
            if (std::isfinite(gradient[input])) continue;
            constexpr Real nudge = 1e-6;
            const Real size = std::max(std::abs(slots.numbers[s][i]), a.inputs[input].conditioning);
            Slots moved = slots;
            moved.numbers[s][i] += nudge * size;
            gradient[input] = size > 0 ? (formula.evaluate(moved.values()) - a.evaluated) / (nudge * size) : 0;
        }
    return gradient;
}

void take_sensitivities(Answer& a, std::span<const Real> gradient) {
    a.conditioning = 0;
    for (std::size_t k = 0; k < gradient.size(); ++k) {
        Answer& input = a.inputs[k];
        const Real slope = std::abs(gradient[k]);
        if (!std::isfinite(slope)) continue;
        input.sensitivity = slope * std::abs(input.value);
        a.conditioning += slope * std::max(std::abs(input.value), input.conditioning);
    }
}

std::string compared(const Unit& left, const std::optional<Unit>& right) {
    if (!right || *right == left) return "ok";
    return fmt::format("{} on the left, {} on the right", left.text(), right->text());
}

std::string unit_check(const Formula& formula, const Answer& a) {
    if (a.inputs.empty()) return "ok";  // a bare number stands in the unit of what it explains
    const Formula::UnitCheck found = formula.check_units();
    return found.mismatch.empty() ? compared(Unit(a.unit), found.unit) : found.mismatch;
}

// Of a part that does not say its unit.
std::string unit_of(const Formula& formula, const Explanation& e) {
    if (const auto unit = formula.check_units().unit) return unit->usual_text();
    throw BadFormula(e.formula, 0, "its unit does not follow from its inputs: give it by Input::part");
}

// The formula with its numbers: remarks that say when it holds stay.
std::string with_numbers(const Formula& formula, const Slots& slots) {
    const std::string_view remark = formula.remark();
    return fmt::format("{}{}{}{}", formula.left(), formula.left().empty() ? "" : " = ",
                       formula.with_numbers(slots.values(), slots.units), remark.starts_with(':') ? remark : "");
}

void evaluate_formula(Answer& a, const Explanation& e) {
    const Slots slots = slots_of(a, e);
    const Formula formula = read(slots, e);
    a.evaluated = formula.evaluate(slots.values());
    for (std::size_t s = 0; s < slots.inputs.size(); ++s)
        for (const std::size_t input : slots.inputs[s])
            a.inputs[input].by_differences = formula.by_differences(static_cast<int>(s));
    take_sensitivities(a, gradient_of(formula, slots, a));
    a.substituted = with_numbers(formula, slots);
    a.latex = formula.latex();
    if (a.unit == unit_from_formula) a.unit = unit_of(formula, e);
    a.unit_check = unit_check(formula, a);
}

}  // namespace

void evaluate(Answer& a, const Explanation& e) {
    a.formula = e.formula;
    a.wrong_unit = e.wrong_unit;
    try {
        evaluate_formula(a, e);
    } catch (const Error& bad) {
        a.trouble = fmt::format("{}: {}", e.formula.place(), bad.what());
        a.evaluated = a.value;
    }
}

}  // namespace pliant
