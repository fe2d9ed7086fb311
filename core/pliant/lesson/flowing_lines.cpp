#include <pliant/lesson/flowing_lines.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

namespace pliant {
namespace {

constexpr std::array<std::string_view, 12> signs{"=", "×", "≤", "≥", "<", ">", "+", "−", "-", "·", "/", "≈"};

bool is_sign(const std::string& word) { return std::ranges::find(signs, word) != signs.end(); }

bool starts_with_digit(const std::string& word) { return !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])); }

// Is this so short that it is the unit of the number before it, as in "20 kPa"?
bool may_be_unit(const std::string& word) { return word.size() <= 4 && !starts_with_digit(word); }

}  // namespace

std::vector<std::string> flowing_lines(std::string_view text, double width,
                                       const std::function<double(const std::string&)>& width_of) {
    // Words, joined to those that they belong to.
    std::vector<std::string> groups;
    std::istringstream in{std::string(text)};
    std::string before;
    for (std::string word; in >> word; before = word) {
        const bool joins = is_sign(word) || is_sign(before) || (starts_with_digit(before) && may_be_unit(word));
        if (joins && !groups.empty() && width_of(groups.back() + " " + word) <= width)
            groups.back().append(" ").append(word);
        else
            groups.push_back(word);
    }
    std::vector<std::string> lines{""};
    for (const std::string& group : groups) {
        const std::string longer = lines.back().empty() ? group : lines.back() + " " + group;
        if (lines.back().empty() || width_of(longer) <= width)
            lines.back() = longer;
        else
            lines.push_back(group);
    }
    return lines;
}

double columns_of(const std::string& text) {
    const auto takes_one = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        const bool continues = (byte & 0xc0) == 0x80, combines = byte == 0xcc;
        return !continues && !combines;
    };
    return static_cast<double>(std::ranges::count_if(text, takes_one));
}

}  // namespace pliant
