#include <pliant/text/number_text.h>
#include <pliant/text/quantity_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace pliant {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 9> unit_prefixes{
    {{"m", -3}, {"µ", -6}, {"k", 3}, {"M", 6}, {"c", -2}, {"n", -9}, {"p", -12}, {"G", 9}, {"T", 12}}};
// First symbols that take a prefix.
constexpr std::array<std::string_view, 8> units_with_prefix{"m", "s", "Pa", "N", "J", "W", "Hz", "g"};

std::string_view stripped(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

bool is_decimal(char c) { return c >= '0' && c <= '9'; }

// Where the number ends that a text begins with: sign, digits with a point or comma, exponent.
std::size_t end_of_number(std::string_view text) {
    std::size_t at = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
    if (at < text.size() && text[at] == '-') ++at;  // the reader of numbers refuses two signs
    while (at < text.size() && (is_decimal(text[at]) || text[at] == '.' || text[at] == ',')) ++at;
    if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
    std::size_t power = at + 1;
    if (power < text.size() && (text[power] == '+' || text[power] == '-')) ++power;
    if (power >= text.size() || !is_decimal(text[power])) return at;
    while (power < text.size() && is_decimal(text[power])) ++power;
    return power;
}

// "m/s^2" and "m/s2" as "m/s²", "N*s/m" and "N·s/m" as "N s/m", "us" as "µs", "deg" as "°".
std::string normal_unit(std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> same{
        {{"^", ""}, {"2", "²"}, {"3", "³"}, {"4", "⁴"}, {"*", " "}, {"·", " "}, {"μ", "µ"}, {"deg", "°"}, {"u", "µ"}}};
    std::string text(unit);
    for (const auto& [from, to] : same)
        for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    return text;
}

// The power of the first symbol of a unit that may bear a prefix: 2 of "m²/s"; 0 when it takes none.
int power_of_first(std::string_view unit) {
    for (const std::string_view symbol : units_with_prefix) {
        if (!unit.starts_with(symbol)) continue;
        const std::string_view rest = unit.substr(symbol.size());
        if (rest.starts_with("²")) return 2;
        if (rest.starts_with("³")) return 3;
        if (rest.starts_with("⁴")) return 4;
        if (rest.empty() || rest.starts_with(" ") || rest.starts_with("/")) return 1;
    }
    return 0;
}

// The power of ten by which a number with the unit `written` is larger than one in `unit`; empty when it is another unit.
std::optional<int> exponent_between(std::string_view written, std::string_view unit) {
    if (written == unit || (unit == "1/s" && written == "/s")) return 0;
    if (unit.starts_with("kg")) {
        const auto from_grams = exponent_between(written, unit.substr(1));
        return from_grams ? std::optional(*from_grams - 3) : std::nullopt;
    }
    const int power = power_of_first(unit);
    for (const auto& [sign, exponent] : unit_prefixes) {
        const bool suits = power != 0 && (sign != "c" || unit.starts_with("m"));
        if (suits && written.starts_with(sign) && written.substr(sign.size()) == unit) return exponent * power;
    }
    return std::nullopt;
}

// Could this be meant as a unit? "*3" and "x10" are no such thing.
bool looks_like_unit(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || (c & 0x80) != 0; };
    const std::string_view behind_one = text.starts_with("1/") ? text.substr(2) : text.starts_with("/") ? text.substr(1) : text;
    if (behind_one.empty() || !letter(behind_one.front())) return false;
    for (std::size_t i = 1; i < behind_one.size(); ++i) {
        const char c = behind_one[i];
        if (letter(c) || c == '/' || c == ' ' || c == '^' || c == '*') continue;
        if (c < '2' || c > '4' || is_decimal(behind_one[i - 1])) return false;
    }
    return true;
}

// The digits with another power of ten, read in one go: 35 ms are exactly the number 0.035.
QuantityText times_power(std::string_view number, int exponent) {
    if (read_number(number).ambiguous) return {0, QuantityText::Problem::ambiguous};
    const auto e = number.find_first_of("eE");
    const Real written = e == number.npos ? 0 : finite_number(number.substr(e + 1)).value_or(0);
    const NumberText read =
        exponent == 0 ? read_number(number) : read_number(fmt::format("{}e{:.0f}", number.substr(0, e), written + exponent));
    using Problem = QuantityText::Problem;
    const Problem problem = read.ambiguous                                 ? Problem::ambiguous
                            : read.error == std::errc::result_out_of_range ? Problem::out_of_range
                            : read.good()                                  ? Problem::none
                                                                           : Problem::no_number;
    return {read.value, problem};
}

}  // namespace

QuantityText read_quantity(std::string_view text, std::string_view unit, std::string_view unit_if_none) {
    text = stripped(text);
    const std::size_t end = end_of_number(text);
    // "inf" and "nan" are refused as numbers, not as units.
    const bool has_digits = std::ranges::any_of(text.substr(0, end), is_decimal);
    const std::string_view number = has_digits ? text.substr(0, end) : text, written = stripped(text.substr(number.size()));
    if (written.empty())
        return times_power(number,
                           unit_if_none.empty() ? 0 : exponent_between(normal_unit(unit_if_none), normal_unit(unit)).value_or(0));
    if (!looks_like_unit(written)) return {0, QuantityText::Problem::no_number};
    const auto exponent =
        unit.empty() && written == "%" ? std::optional(-2) : exponent_between(normal_unit(written), normal_unit(unit));
    if (!exponent || (unit.empty() && written != "%")) return {0, QuantityText::Problem::other_unit, written};
    QuantityText result = times_power(number, *exponent);
    result.unit = written;
    return result;
}

std::string quantity_in(Real value, std::string_view unit, std::string_view written_unit) {
    const int exponent = unit.empty() ? 0 : exponent_between(normal_unit(written_unit), normal_unit(unit)).value_or(0);
    std::array<char, 64> digits{};
    // The shortest that reads back, with its point moved.
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::scientific).ptr;
    const std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
    const auto e = text.find('e');
    if (e == text.npos) return std::string(text);
    const int power = std::stoi(std::string(text.substr(e + 1))) - exponent;
    const std::string moved = fmt::format("{}e{}", text.substr(0, e), power);
    const auto plain = finite_number(moved);
    // Written plainly where that says the same digits.
    const std::string shown = plain && std::abs(power) < 7 ? fmt::format("{}", *plain) : moved;
    const std::string number = times_power(shown, exponent).value == value ? shown : moved;
    return written_unit.empty() ? number : fmt::format("{} {}", number, written_unit);
}

std::string units_accepted(std::string_view unit) {
    if (power_of_first(unit.starts_with("kg") ? unit.substr(1) : unit) == 0) return std::string(unit);
    if (unit.starts_with("kg")) return fmt::format("{} or {}", unit, unit.substr(1));
    const bool small = unit.starts_with("m") || unit.starts_with("s");
    return small ? fmt::format("{}, m{} or µ{}", unit, unit, unit) : fmt::format("{}, k{} or M{}", unit, unit, unit);
}

}  // namespace pliant
