#include <pliant/formula/formula.h>
#include <pliant/formula/notation.h>
#include <pliant/run/evaluation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace pliant {
namespace {

// The formula as data; empty when it cannot be read and need not be.
std::optional<Formula> read(const Answer& a, const Explanation& e) {
    std::vector<std::string> symbols;
    std::vector<Unit> units;
    for (const Answer& input : a.inputs) symbols.push_back(input.symbol);
    try {
        for (const Answer& input : a.inputs) units.emplace_back(input.unit);
    } catch (const Refused&) {
        units.clear();
    }
    try {
        return Formula(e.formula, std::move(symbols), std::move(units));
    } catch (const BadFormula&) {
        if (!e.evaluate) throw;
        return std::nullopt;
    }
}

// But for rounding. Where much cancels the lesson's own number counts.
bool same(Real by_formula, Real by_lesson) { return std::abs(by_formula - by_lesson) <= 1e-9 * std::abs(by_lesson) + 1e-300; }

using Evaluate = std::function<Real(std::span<const Real>)>;

// ∂/∂x of one input by a difference: it is moved by a part in a million of its size.
Real slope_by_difference(const Evaluate& evaluate, const Answer& a, std::vector<Real>& values, std::size_t k) {
    constexpr Real nudge = 1e-6;
    const Real kept = values[k], size = std::max(std::abs(kept), a.inputs[k].conditioning);
    if (size == 0) return 0;
    values[k] = kept + nudge * size;
    const Real slope = (evaluate(values) - a.evaluated) / (nudge * size);
    values[k] = kept;
    return slope;
}

// Where the formula is not known as data. Of the very many inputs of a long sum a sample stands for all.
std::vector<Real> gradient_by_differences(const Evaluate& evaluate, const Answer& a, std::vector<Real>& values) {
    constexpr std::size_t most = 512;
    const std::size_t stride = values.size() / most + 1;
    std::vector<Real> gradient(values.size(), 0);
    for (std::size_t k = 0; k < values.size(); k += stride)
        std::fill_n(gradient.begin() + static_cast<std::ptrdiff_t>(k), std::min(stride, values.size() - k),
                    slope_by_difference(evaluate, a, values, k));
    return gradient;
}

// A root at 0 has no slope there: what its inputs lose to rounding tells how much they matter.
std::vector<Real> gradient_of(const Formula& formula, const Answer& a, std::vector<Real>& values) {
    std::vector<Real> gradient = formula.gradient(values);
    const auto evaluate = [&](std::span<const Real> x) { return formula.evaluate(x); };
    for (std::size_t k = 0; k < gradient.size(); ++k)
        if (!std::isfinite(gradient[k])) gradient[k] = slope_by_difference(evaluate, a, values, k);
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
std::string unit_of(const std::optional<Formula>& formula, const Explanation& e) {
    if (formula && formula->has_units())
        if (const auto unit = formula->check_units().unit) return unit->usual_text();
    throw std::logic_error(fmt::format("the unit of \"{}\" does not follow from its inputs: give it by Input::part", e.formula));
}

std::vector<Real> gradient_of_terms(std::span<const Real> values, std::size_t factors) {
    std::vector<Real> gradient(values.size(), 1);
    for (std::size_t k = 0; factors == 2 && k + 1 < values.size(); k += 2)
        gradient[k] = values[k + 1], gradient[k + 1] = values[k];
    return gradient;
}

std::string unit_check_of_terms(const Answer& a, std::size_t factors) {
    const Unit declared(a.unit);
    for (std::size_t k = 0; k + factors <= a.inputs.size(); k += factors) {
        Unit term(a.inputs[k].unit);
        if (factors == 2) term = term * Unit(a.inputs[k + 1].unit);
        if (const std::string words = compared(declared, term); words != "ok") return words;
    }
    return "ok";
}

void evaluate_terms(Answer& a, Making making, std::span<const Real> values) {
    const std::size_t factors = factors_of(making);
    a.evaluated = sum_of_terms(making, values);
    take_sensitivities(a, gradient_of_terms(values, factors));
    a.latex = latex(a.formula);
    a.as_data = true;
    a.unit_check = unit_check_of_terms(a, factors);
}

void evaluate_formula(Answer& a, const Explanation& e, std::vector<Real>& values) {
    const std::optional<Formula> formula = read(a, e);
    a.evaluated = e.evaluate ? e.evaluate(values) : formula->evaluate(values);
    a.as_data = formula && (!e.evaluate || same(formula->evaluate(values), a.evaluated));
    take_sensitivities(a, a.as_data ? gradient_of(*formula, a, values) : gradient_by_differences(e.evaluate, a, values));
    a.latex = a.as_data ? formula->latex() : latex(e.formula);
    if (a.unit == unit_from_formula) a.unit = unit_of(formula, e);
    if (a.as_data && formula->has_units()) a.unit_check = unit_check(*formula, a);
}

}  // namespace

void evaluate(Answer& a, const Explanation& e) {
    std::vector<Real> values;
    for (const Answer& input : a.inputs) values.push_back(input.value);
    a.formula = e.formula;
    a.wrong_unit = e.wrong_unit;
    a.substituted = substituted(e, values);
    e.making == Making::formula || e.evaluate ? evaluate_formula(a, e, values) : evaluate_terms(a, e.making, values);
}

}  // namespace pliant
