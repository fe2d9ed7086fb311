#include "panels/flowing_text.h"

#include <pliant/lesson/flowing_lines.h>

#include <fmt/format.h>
#include <imgui.h>

#include <cfloat>

namespace pliant::viewer {

std::string flowing_text(const std::string& text, const ImFont* font, float width) {
    const auto lines = flowing_lines(text, static_cast<double>(width), [font](const std::string& words) {
        return static_cast<double>(font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, words.c_str()).x);
    });
    return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace pliant::viewer
