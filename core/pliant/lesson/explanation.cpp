#include <pliant/lesson/explanation.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace pliant {

Input::Input(From from_, std::string symbol_, std::string name_, std::string unit_)
    : from(from_), symbol(std::move(symbol_)), name(std::move(name_)), unit(std::move(unit_)) {}

Input::Input(const Parameter& parameter) : Input(of(parameter, std::string(parameter.info.symbol))) {}

Input Input::of(const Parameter& parameter, std::string symbol) {
    Input in(From::parameter, std::move(symbol), std::string(parameter.info.key), std::string(parameter.info.unit));
    in.value = parameter.value();
    return in;
}

Input Input::constant(std::string symbol, Real value, std::string unit, std::string meaning) {
    Input in(From::constant, std::move(symbol), std::move(meaning), std::move(unit));
    in.value = value;
    return in;
}

Input Input::now(std::string symbol, std::string_view field, Index index, int component) {
    Input in(From::now, std::move(symbol), std::string(field), "");
    in.index = index, in.component = component;
    return in;
}
Input Input::all_of(std::string symbol, std::string_view field, int component) {
    Input in = now(symbol, field, 0, component);
    in.family = std::move(symbol), in.all = true;
    return in;
}
Input Input::live(std::string symbol, std::string unit, std::string meaning, std::function<Real()> value) {
    Input in = constant(std::move(symbol), 0, std::move(unit), std::move(meaning));
    in.value_now = std::move(value);
    return in;
}
Input Input::before(std::string symbol, std::string_view field, Index index, int component) {
    Input in = now(std::move(symbol), field, index, component);
    in.from = From::before;
    return in;
}
Input Input::earlier(std::string symbol, std::string_view field, Index index, int component) {
    Input in = now(std::move(symbol), field, index, component);
    in.from = From::earlier;
    return in;
}

Input Input::part(std::string symbol, std::string unit, Explanation why) {
    Input in(From::part, std::move(symbol), "", std::move(unit));
    in.why = std::make_shared<const Explanation>(std::move(why));
    return in;
}

Input Input::in(std::string family_symbol) const {
    Input one = *this;
    one.family = std::move(family_symbol);
    return one;
}

std::string FormulaText::place() const {
    std::string_view file = file_;
    for (const std::string_view folder : {"lessons/", "core/", "viewer/", "tests/", "docs/"})
        if (const std::size_t at = file.rfind(folder); at != file.npos && at > 0) {
            file.remove_prefix(at);
            break;
        }
    return fmt::format("{}:{}", file, line_);
}

Explanation Explanation::by(std::string name, std::string unit, std::function<Real(Values)> value) && {
    name.resize(std::min(name.find('('), name.size()));
    functions.push_back({std::move(name), std::move(unit), std::move(value)});
    return std::move(*this);
}

Input part(FormulaText formula, std::vector<Input> inputs) {
    std::string symbol = formula.substr(0, formula.find(" = "));
    return Input::part(std::move(symbol), unit_from_formula, {std::move(formula), std::move(inputs)});
}

// --------------------------------------------------------------------------------------------------------------- sums

std::string as_factor(Real value, bool raised) {
    const std::string text = format_quantity(value, "", 6);
    return value < 0 || (raised && text.find("10") != std::string::npos && !std::isdigit(static_cast<unsigned char>(text.back())))
               ? fmt::format("({})", text)
               : text;
}

Explanation fixed_value(FormulaText formula) { return {std::move(formula)}; }

namespace {

Explanation nothing_added(const FormulaText& formula) {
    Explanation e{formula};
    static_cast<std::string&>(e.formula) = formula.substr(0, formula.find(" = ")) + " = 0: nothing is added";
    return e;
}

}  // namespace

std::vector<Input> family_of(const std::string& symbol, std::vector<Input> inputs) {
    for (Input& one : inputs) one.family = symbol;
    return inputs;
}

Explanation sum_of(FormulaText formula, const std::string& family, std::vector<Input> terms) {
    if (terms.empty()) return nothing_added(formula);
    return {std::move(formula), family_of(family, std::move(terms))};
}

Explanation weighted_sum(FormulaText formula, const std::string& weights, const std::string& quantities,
                         const std::vector<std::pair<Input, Input>>& terms) {
    std::vector<Input> inputs;
    for (const auto& [weight, quantity] : terms) {
        if (weight.from == Input::From::constant && weight.value == 0) continue;
        inputs.push_back(weight.in(weights));
        inputs.push_back(quantity.in(quantities));
    }
    if (inputs.empty()) return nothing_added(formula);
    return {std::move(formula), std::move(inputs)};
}

}  // namespace pliant
