#include "panels/flowing_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cfloat>
#include <sstream>
#include <string_view>
#include <vector>

namespace pliant::viewer {
namespace {

constexpr std::array<std::string_view, 12> signs{"=", "×", "≤", "≥", "<", ">", "+", "−", "-", "·", "/", "≈"};

bool is_sign(const std::string& word) { return std::ranges::find(signs, word) != signs.end(); }

bool starts_with_digit(const std::string& word) { return !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])); }

// Is this so short that it is the unit of the number before it, as in "20 kPa"?
bool may_be_unit(const std::string& word) { return word.size() <= 4 && !starts_with_digit(word); }

float width_of(const ImFont* font, const std::string& text) {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

}  // namespace

std::string flowing_text(const std::string& text, const ImFont* font, float width) {
    // Words, joined to those that they belong to.
    std::vector<std::string> groups;
    std::istringstream in(text);
    std::string before;
    for (std::string word; in >> word; before = word) {
        const bool joins = is_sign(word) || is_sign(before) || (starts_with_digit(before) && may_be_unit(word));
        if (joins && !groups.empty() && width_of(font, fmt::format("{} {}", groups.back(), word)) <= width)
            groups.back().append(" ").append(word);
        else
            groups.push_back(word);
    }
    std::string result, line;
    for (const std::string& group : groups) {
        const std::string longer = line.empty() ? group : fmt::format("{} {}", line, group);
        if (line.empty() || width_of(font, longer) <= width) {
            line = longer;
            continue;
        }
        result.append(line).append("\n");
        line = group;
    }
    return result + line;
}

}  // namespace pliant::viewer
