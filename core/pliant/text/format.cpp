#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace pliant {
namespace {

struct Prefix {
    int exponent;
    std::string_view symbol;
};
constexpr std::array<Prefix, 9> prefixes{
    {{-9, "n"}, {-6, "µ"}, {-3, "m"}, {0, ""}, {3, "k"}, {6, "M"}, {9, "G"}, {12, "T"}, {-12, "p"}}};

// Units whose first symbol takes a prefix, with the smallest and largest exponent that people use for it.
struct Prefixable {
    std::string_view unit;
    int smallest, largest;
};
constexpr std::array<Prefixable, 12> prefixable{{{"Pa", -3, 12},
                                                 {"N", -6, 9},
                                                 {"J", -9, 9},
                                                 {"W", -6, 9},
                                                 {"Hz", 0, 9},
                                                 {"s", -9, 0},
                                                 {"m", -9, 3},
                                                 {"m/s", -6, 3},
                                                 {"N/m", -3, 12},
                                                 {"N s/m", -3, 9},
                                                 {"N·s/m", -3, 9},
                                                 {"Pa·s", -6, 6}}};

// Raised digits, as in 10⁻⁴.
std::string raised(int exponent) {
    constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char c : fmt::format("{}", std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

// "0.05", "1.2×10⁻⁷"
std::string plain(Real value, int digits) {
    const Real size = std::abs(value);
    const std::string text = fmt::format("{:.{}g}", value, digits);
    const auto e = text.find('e');
    if (e == std::string::npos && (size == 0 || size >= 1e-3)) return text;
    const std::string scientific = fmt::format("{:.{}e}", value, std::max(0, digits - 1));
    const auto at = scientific.find('e');
    std::string mantissa = scientific.substr(0, at);
    if (mantissa.find('.') != std::string::npos) mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.ends_with('.')) mantissa.pop_back();
    const std::string power = "10" + raised(std::stoi(scientific.substr(at + 1)));
    return mantissa == "1" ? power : mantissa == "-1" ? "-" + power : mantissa + "×" + power;
}

// None where the unit takes none.
Prefix prefix_for(Real value, std::string_view unit, int digits) {
    const auto known = std::ranges::find(prefixable, unit, &Prefixable::unit);
    if (known == prefixable.end() || value == 0 || !std::isfinite(value)) return {0, ""};
    // Of the number as it will be read: 0.99999 m/s is 1 m/s, not 1000 mm/s.
    const Real read = std::strtod(fmt::format("{:.{}e}", std::abs(value), std::max(0, digits - 1)).c_str(), nullptr);
    const int third = static_cast<int>(std::floor(std::log10(read) / 3 + 1e-12)) * 3;
    return *std::ranges::find(prefixes, std::clamp(third, known->smallest, known->largest), &Prefix::exponent);
}

}  // namespace

std::string format_quantity(Real value, std::string_view unit, int digits) {
    if (!std::isfinite(value)) return "undefined";
    if (value == 0) value = 0;  // no minus sign on zero
    if (unit.empty()) return plain(value, digits);
    const Prefix prefix = prefix_for(value, unit, digits);
    const Real scaled = prefix.exponent == 0 ? value : value * std::pow(10.0, -prefix.exponent);
    return fmt::format("{} {}{}", plain(scaled, digits), prefix.symbol, unit);
}

std::string unit_shown(Real value, std::string_view unit, int digits) {
    return std::string(prefix_for(value, unit, digits).symbol).append(unit);
}

std::string format_exact(Real value) { return fmt::format("{}", value); }

Real rounded_down(Real value, int digits) {
    // A number below the normal ones has fewer digits than it can be rounded to.
    if (!std::isnormal(value)) return value;
    const int last = static_cast<int>(std::floor(std::log10(std::abs(value)))) - digits + 1;
    // A number that has no more digits than these is kept, however its division rounds.
    const Real whole = std::floor(value / std::pow(10.0, last) * (1 + std::copysign(1e-14, value)));
    return std::strtod(fmt::format("{:.0f}e{}", whole, last).c_str(), nullptr);
}

std::string unit_or_dimensionless(std::string_view unit) { return unit.empty() ? "dimensionless" : fmt::format("in {}", unit); }

}  // namespace pliant
