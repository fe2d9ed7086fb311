#include "plot/ticks.h"

#include <fmt/format.h>
#include <pliant/text/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::viewer {
namespace {

// Ends of an axis count as reached within this part of a step.
constexpr Real rounding_of_ticks = 1e-6;
// Numbers with more digits than this are counted from an offset instead.
constexpr int most_digits = 5;

int decade_of(Real size) { return static_cast<int>(std::floor(std::log10(size) + 1e-12)); }

// The exponent, a multiple of 3, that numbers up to `size` are given in; 0 for sizes that read well as they are.
int engineering_exponent(Real size) {
    if (!(size > 0) || (size >= 1e-2 && size < 1e4)) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(size) / 3 + 1e-12));
}

// The unit of numbers that are given in 10^exponent of `unit`.
std::string scaled_unit(std::string_view unit, int exponent) {
    if (exponent == 0) return std::string(unit);
    const std::string one = format_quantity(std::pow(10.0, exponent), unit);
    if (!unit.empty() && one.starts_with("1 ")) return one.substr(2);
    return unit.empty() ? "×" + power_of_ten(exponent) : power_of_ten(exponent) + " " + std::string(unit);
}

std::string fixed(Real value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, std::max(0, decimals));
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
    return text;
}

struct Multiples {
    Real first, last;  // whole numbers
    Real step;
    Real at(Real k) const { return k * step; }
};

Multiples multiples_in(Range range, int most) {
    Real step = nice_step(range.span(), most);
    Multiples found{std::ceil(range.lo / step - rounding_of_ticks), std::floor(range.hi / step + rounding_of_ticks), step};
    // One more than the count of steps may fit.
    while (found.last - found.first + 1 > most) {
        step = nice_step(step * 1.5, 1);
        found = {std::ceil(range.lo / step - rounding_of_ticks), std::floor(range.hi / step + rounding_of_ticks), step};
    }
    return found;
}

Ticks linear_ticks(Range range, int most, std::string_view unit) {
    const Multiples multiples = multiples_in(range, most);
    const Real size = std::max(std::abs(range.lo), std::abs(range.hi));
    const bool from_offset = decade_of(size) - decade_of(multiples.step) >= most_digits;

    // Counted from the middle, rounded to where the numbers begin to differ.
    const Real coarse = std::pow(10.0, decade_of(range.span()) + 1);
    const Real offset = from_offset ? std::round((range.lo / 2 + range.hi / 2) / coarse) * coarse : 0;
    const int exponent = engineering_exponent(from_offset ? range.span() : size);
    const Real scale = std::pow(10.0, exponent);
    const int decimals = exponent - decade_of(multiples.step);

    Ticks result;
    result.unit = scaled_unit(unit, exponent);
    if (from_offset) {
        const int written_out = decade_of(size) < 7 ? decade_of(size) + 1 : 1;  // "2000000", not "2e+06"
        const int digits = std::max({1, decade_of(size) - decade_of(coarse) + 2, written_out});
        result.offset = fmt::format("{:.{}g}{}{}", offset, digits, unit.empty() ? "" : " ", unit);
    }
    for (Real k = multiples.first; k <= multiples.last; ++k) {
        const Real value = multiples.at(k);
        const std::string text = fixed((value - offset) / scale, decimals);
        const bool signed_text = from_offset && text.find_first_of("123456789") != std::string::npos && !text.starts_with('-');
        result.ticks.push_back({value, signed_text ? "+" + text : text});
    }
    return result;
}

// Numbers on a log axis are written out or, where some would be long, carry their own power of ten.
std::string log_text(int factor, int exponent, bool written_out) {
    if (written_out) return fixed(factor * std::pow(10.0, exponent), -exponent);
    return (factor == 1 ? "" : std::to_string(factor) + "·") + power_of_ten(exponent);
}

Ticks log_ticks(Range range, int most, std::string_view unit) {
    const Real lo = std::log10(range.lo), hi = std::log10(range.hi);
    const int first = static_cast<int>(std::floor(lo + rounding_of_ticks)),
              last = static_cast<int>(std::floor(hi + rounding_of_ticks));
    const int decades =
        static_cast<int>(std::floor(hi + rounding_of_ticks)) - static_cast<int>(std::ceil(lo - rounding_of_ticks)) + 1;
    int stride = 1;
    while ((decades + stride - 1) / stride > most) ++stride;
    // Which of 2 to 9 are numbered too, by how much room there is.
    const bool twos_and_fives = stride == 1 && 3 * (hi - lo) + 1 <= most && hi - lo < 2;

    const bool written_out = first >= -3 && last <= 3;

    Ticks result;
    result.unit = unit;
    for (int exponent = first; exponent <= last; ++exponent) {
        const bool numbered = ((exponent % stride) + stride) % stride == 0;
        for (int factor = 1; factor <= (stride == 1 ? 9 : 1); ++factor) {
            const Real place = exponent + std::log10(factor);
            if (place < lo - rounding_of_ticks || place > hi + rounding_of_ticks) continue;
            const bool text = numbered && (factor == 1 || (twos_and_fives && (factor == 2 || factor == 5)));
            result.ticks.push_back({factor * std::pow(10.0, exponent), text ? log_text(factor, exponent, written_out) : ""});
        }
    }
    return result;
}

}  // namespace

std::string power_of_ten(int exponent) {
    constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) text += raised[static_cast<std::size_t>(digit - '0')];
    return text;
}

Ticks make_ticks(Range range, AxisScale scale, int most, std::string_view unit) {
    most = std::max(1, most);
    if (scale == AxisScale::linear) return linear_ticks(range, most, unit);
    Ticks ticks = log_ticks(range, most, unit);
    // A stretch so short that it holds less than two round numbers is numbered as a linear axis is.
    const auto numbered =
        std::count_if(ticks.ticks.begin(), ticks.ticks.end(), [](const Tick& tick) { return !tick.text.empty(); });
    return numbered < 2 && range.hi / range.lo < 100 ? linear_ticks(range, most, unit) : ticks;
}

std::string axis_text(std::string_view label, const Ticks& ticks) {
    std::string text(label);
    const auto append = [&text](const std::string& part) { text += (text.empty() ? "" : " ") + part; };
    // A tick of 2 at "ω = 1.5 rad/s + … [mrad/s]" is 1.502 rad/s.
    if (!ticks.offset.empty()) append((text.empty() ? "" : "= ") + ticks.offset + " + …");
    if (!ticks.unit.empty()) append("[" + ticks.unit + "]");
    return text;
}

}  // namespace pliant::viewer
