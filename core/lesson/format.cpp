#include <pliant/lesson/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant {
namespace {

struct Prefix {
    int exponent;
    std::string_view symbol;
};
constexpr std::array<Prefix, 9> prefixes{{{-9, "n"}, {-6, "µ"}, {-3, "m"}, {0, ""}, {3, "k"}, {6, "M"}, {9, "G"}, {12, "T"}, {-12, "p"}}};

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

std::string plain(Real value, int digits) {
    const Real size = std::abs(value);
    if (size != 0 && (size < 1e-3 || size >= 1e6)) return fmt::format("{:.{}e}", value, std::max(0, digits - 1));
    return fmt::format("{:.{}g}", value, digits);
}

}  // namespace

std::string format_quantity(Real value, std::string_view unit, int digits) {
    if (!std::isfinite(value)) return "undefined";
    if (value == 0) value = 0;  // no minus sign on zero
    const auto known = std::ranges::find(prefixable, unit, &Prefixable::unit);
    if (known != prefixable.end() && value != 0) {
        const int third = static_cast<int>(std::floor(std::log10(std::abs(value)) / 3 + 1e-12)) * 3;
        const int exponent = std::clamp(third, known->smallest, known->largest);
        const auto prefix = std::ranges::find(prefixes, exponent, &Prefix::exponent);
        return fmt::format("{} {}{}", plain(value * std::pow(10.0, -exponent), digits), prefix->symbol, unit);
    }
    return unit.empty() ? plain(value, digits) : fmt::format("{} {}", plain(value, digits), unit);
}

std::string format_exact(Real value) { return fmt::format("{}", value); }

std::string unit_or_dimensionless(std::string_view unit) { return unit.empty() ? "dimensionless" : fmt::format("in {}", unit); }

}  // namespace pliant
