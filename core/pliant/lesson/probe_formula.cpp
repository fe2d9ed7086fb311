#include <pliant/lesson/lesson.h>
#include <pliant/lesson/probe_formula.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant {

ProbeFormula::ProbeFormula(const Lesson& lesson, FormulaText text, std::vector<Input> inputs)
    : lesson_(lesson), text_(std::move(text)), inputs_(std::move(inputs)) {}

FormulaSymbol ProbeFormula::symbol_of(const Input& in, Slot& slot) const {
    std::string_view unit = in.unit;
    switch (in.from) {
        case Input::From::parameter:
            slot.parameter = &lesson_.parameter(in.name);
            break;
        case Input::From::now:
            slot.field = lesson_.find_field(in.name);
            if (!slot.field) slot.probe = &lesson_.probe(in.name);
            unit = slot.field ? slot.field->unit : slot.probe->unit;
            break;
        case Input::From::part:
            slot.part = std::make_unique<ProbeFormula>(lesson_, in.why->formula, in.why->inputs);
            slot.part->resolve();
            if (unit == unit_from_formula) return {in.symbol, slot.part->formula_->check_units().unit, false};
            break;
        default:
            break;
    }
    return {in.all ? in.family : in.symbol, Unit(unit), in.all};
}

void ProbeFormula::resolve() {
    slots_.resize(inputs_.size());
    numbers_.resize(inputs_.size());
    std::vector<FormulaSymbol> symbols;
    try {
        for (std::size_t k = 0; k < inputs_.size(); ++k) symbols.push_back(symbol_of(inputs_[k], slots_[k]));
        formula_.emplace(text_, std::move(symbols));
    } catch (const Error& e) {
        throw CheckFailed(fmt::format("{}: {}", text_.place(), e.what()));
    }
    for (const Real& number : numbers_) slots_of_formula_.push_back({&number});
}

// False where there is no number.
bool ProbeFormula::fill(const Input& in, const Slot& slot, std::size_t k) {
    Real& number = numbers_[k];
    if (slot.field) {
        const auto view = slot.field->view();
        const auto components = static_cast<std::size_t>(slot.field->components), c = static_cast<std::size_t>(in.component);
        if (in.all) return slots_of_formula_[k] = {view.data() + c, view.size() / components, components}, true;
        const std::size_t at = static_cast<std::size_t>(in.index) * components + c;
        if (in.index < 0 || at >= view.size()) return false;
        return number = view[at], true;
    }
    if (slot.probe || slot.part) {
        const std::optional<Real> value = slot.probe ? slot.probe->value() : slot.part->value();
        return number = value.value_or(0), value.has_value();
    }
    return number = slot.parameter ? slot.parameter->value() : in.value_now ? in.value_now() : in.value, true;
}

std::optional<Real> ProbeFormula::value() {
    if (!formula_) resolve();
    for (std::size_t k = 0; k < inputs_.size(); ++k)
        if (!fill(inputs_[k], slots_[k], k)) return std::nullopt;
    const Real value = formula_->evaluate(slots_of_formula_);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Explanation ProbeFormula::explanation() const {
    Explanation e{text_};
    for (const Input& in : inputs_) {
        if (!in.all) {
            e.inputs.push_back(in);
            continue;
        }
        const Index rows = lesson_.field(in.name).size();
        for (Index n = 0; n < rows; ++n)
            e.inputs.push_back(Input::now(fmt::format("{}_{}", in.symbol, n), in.name, n, in.component).in(in.family));
    }
    return e;
}

Probe Probe::formula(const Lesson& lesson, FormulaText text, std::vector<Input> inputs) const {
    return formula(lesson, Explanation{std::move(text), std::move(inputs)});
}
Probe Probe::formula(const Lesson& lesson, Explanation e) const {
    const auto shared = std::make_shared<ProbeFormula>(lesson, std::move(e.formula), std::move(e.inputs));
    Probe probe = *this;
    probe.value = [shared] { return shared->value(); };
    probe.explain = [shared] { return shared->explanation(); };
    return probe;
}

}  // namespace pliant
