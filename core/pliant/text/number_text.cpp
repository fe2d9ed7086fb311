#include <pliant/text/number_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace pliant {

namespace {

bool is_figure(char c) { return c >= '0' && c <= '9'; }

// One to three digits that do not begin with 0, the comma, and three digits to the end.
bool may_separate_thousands(std::string_view text, std::size_t comma) {
    const std::string_view before = text.substr(text.starts_with('-') ? 1 : 0, comma - (text.starts_with('-') ? 1 : 0)),
                           behind = text.substr(comma + 1);
    return !before.empty() && before.size() <= 3 && before.front() != '0' && std::ranges::all_of(before, is_figure) &&
           behind.size() == 3 && std::ranges::all_of(behind, is_figure);
}

}  // namespace

NumberText read_number(std::string_view text) {
    NumberText result;
    std::string with_point;
    if (text.starts_with('+')) text.remove_prefix(text.size() > 1 && text[1] == '-' ? 0 : 1);
    if (const auto comma = text.find(','); comma != text.npos) {
        result.ambiguous = may_separate_thousands(text, comma);
        result.error = std::errc::invalid_argument;
        if (result.ambiguous || text.find_first_of(",.", comma + 1) != text.npos || text.find('.') != text.npos) return result;
        with_point = text;
        with_point[comma] = '.';
        text = with_point;
    }
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, result.value);
    result.error = error == std::errc() && end != last ? std::errc::invalid_argument : error;
    return result;
}

std::optional<Real> finite_number(std::string_view text) {
    const NumberText read = read_number(text);
    return read.good() && std::isfinite(read.value) ? std::optional(read.value) : std::nullopt;
}

bool is_whole(Real value) { return value == std::floor(value) && std::abs(value) < 9e15; }

std::optional<Index> whole_number(std::string_view text) {
    const auto value = finite_number(text);
    return value && is_whole(*value) ? std::optional(static_cast<Index>(*value)) : std::nullopt;
}

}  // namespace pliant
