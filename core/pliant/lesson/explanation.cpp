#include <pliant/formula/formula.h>
#include <pliant/formula/unicode.h>
#include <pliant/lesson/explanation.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

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

Input part(std::string formula, std::vector<Input> inputs) {
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

namespace {

// Terms with their signs; of a long sum the first ones stand for all.
template <class Sign, class Text>
std::string signed_terms(std::size_t count, Sign is_negative, Text text_of) {
    constexpr std::size_t most = 8;
    const std::size_t shown = count > most ? most - 2 : count;
    std::string text;
    for (std::size_t k = 0; k < shown; ++k) {
        const bool minus = is_negative(k);
        text += k == 0 ? (minus ? "−" : "") : (minus ? " − " : " + ");
        text += text_of(k);
    }
    if (shown < count) text += fmt::format(" + … ({} terms)", count);
    return text.empty() ? "0" : text;
}

}  // namespace

std::string products_text(std::span<const Real> factors_in_pairs) {
    std::vector<std::pair<Real, Real>> terms;
    for (std::size_t k = 0; k + 1 < factors_in_pairs.size(); k += 2)
        if (factors_in_pairs[k] != 0 && factors_in_pairs[k + 1] != 0)
            terms.emplace_back(factors_in_pairs[k], factors_in_pairs[k + 1]);
    return signed_terms(
        terms.size(), [&](std::size_t k) { return terms[k].first < 0; },
        [&](std::size_t k) { return fmt::format("{} · {}", as_factor(std::abs(terms[k].first)), as_factor(terms[k].second)); });
}

std::string sum_text(std::span<const Real> terms) {
    std::vector<Real> written;
    std::ranges::copy_if(terms, std::back_inserter(written), [](Real x) { return x != 0; });
    return signed_terms(
        written.size(), [&](std::size_t k) { return written[k] < 0; },
        [&](std::size_t k) { return as_factor(std::abs(written[k])); });
}

Explanation fixed_value(std::string formula, Real value) {
    return {.formula = std::move(formula), .inputs = {}, .evaluate = [value](std::span<const Real>) { return value; }};
}

Explanation sum_of(std::string formula, std::vector<Input> terms) {
    return {.formula = std::move(formula), .inputs = std::move(terms), .making = Making::sum};
}

Real sum_of_terms(Making making, std::span<const Real> values) {
    const std::size_t factors = factors_of(making);
    Real total = 0;
    for (std::size_t k = 0; k + factors <= values.size(); k += factors)
        total += factors == 2 ? values[k] * values[k + 1] : values[k];
    return total;
}

Explanation weighted_sum(std::string formula, const std::vector<std::pair<Input, Input>>& terms) {
    Explanation sum{.formula = std::move(formula), .making = Making::products};
    for (const auto& [weight, quantity] : terms) {
        if (weight.from == Input::From::constant && weight.value == 0) continue;
        sum.inputs.push_back(weight);
        sum.inputs.push_back(quantity);
    }
    return sum;
}

// ------------------------------------------------------------------------------------------------------- substitution
namespace {

// Does a number beside this multiply it?
bool multiplies(char32_t c) {
    return is_letter(c) || is_digit(c) || c == 0xbd || c == 0xbc || c == 0x221a || c == 0xb2 || c == 0xb3;
}

char32_t last_visible(std::string_view text) {
    char32_t last = 0;
    for (std::size_t i = 0; i < text.size();) {
        const auto [c, length] = code_point(text, i);
        if (c != ' ') last = c;
        i += length;
    }
    return last;
}
char32_t first_visible(std::string_view text) {
    const std::size_t at = text.find_first_not_of(' ');
    return at == std::string_view::npos ? U'\0' : code_point(text, at).letter;
}

std::string with_numbers(std::string_view right, const std::vector<Input>& inputs, std::span<const Real> values) {
    std::vector<std::string> symbols;
    for (const Input& in : inputs) symbols.push_back(in.symbol);
    std::string text;
    char32_t before = 0;  // the code point before this place, of the formula
    bool after_number = false;
    for (std::size_t at = 0; at < right.size();) {
        const auto [c, length] = code_point(right, at);
        const int k = continues_symbol(before) && !is_digit(before) ? -1 : symbol_at(right, at, symbols);
        if (k < 0) {
            if (after_number && c != ' ') {
                if (c == '(' || multiplies(first_visible(right.substr(at)))) {
                    if (c != 0xb2 && c != 0xb3) text += text.ends_with(' ') ? "· " : " · ";
                }
                after_number = false;
            } else if (c == '(' && text.ends_with(' ') && last_visible(text) == ')') {
                text += "· ";
            }
            text += right.substr(at, length);
            before = c;
            at += length;
            continue;
        }
        const char32_t last = last_visible(text);
        const bool product = after_number || multiplies(last) || last == ')' || (last == '|' && text.ends_with(' '));
        if (product) text += text.ends_with(' ') ? "· " : " · ";
        const Real value = values[static_cast<std::size_t>(k)];
        const std::size_t end = at + inputs[static_cast<std::size_t>(k)].symbol.size();
        const char32_t next = end < right.size() ? code_point(right, end).letter : U'\0';
        const bool alone = last == 0 || last == '(';
        const bool raised = next == 0xb2 || next == 0xb3;
        text += alone && !raised ? format_quantity(value, "", 6) : as_factor(value, raised);
        before = ' ';
        after_number = true;
        at = end;
    }
    return text;
}

}  // namespace

std::string substituted(const Explanation& explanation, std::span<const Real> values) {
    const std::string_view formula = explanation.formula;
    const std::size_t equals = formula.find('=');
    const std::string_view left = equals == std::string_view::npos ? "" : formula.substr(0, equals + 1);
    std::string_view right = equals == std::string_view::npos ? formula : formula.substr(equals + 1);
    right.remove_prefix(std::min(right.find_first_not_of(' '), right.size()));
    // A remark behind the formula holds no numbers.
    right = right.substr(0, right.find("   ("));
    const std::string numbers = explanation.substitute                   ? explanation.substitute(values)
                                : explanation.making == Making::sum      ? sum_text(values)
                                : explanation.making == Making::products ? products_text(values)
                                                                         : with_numbers(right, explanation.inputs, values);
    return left.empty() ? numbers : fmt::format("{} {}", left, numbers);
}

}  // namespace pliant
