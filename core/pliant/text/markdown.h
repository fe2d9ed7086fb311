// What the generated pages share.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

// Text for a cell of a Markdown table, where | ends the cell.
inline std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
    return escaped;
}

}  // namespace pliant
