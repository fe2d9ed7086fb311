#include "plot/canvas.h"

namespace pliant::viewer {

std::string shortened(const Canvas& canvas, std::string_view words, float width) {
    if (canvas.text_size(words).x <= width) return std::string(words);
    std::string text(words);
    while (!text.empty()) {
        // Takes away one whole UTF-8 letter: its continuation bytes begin with the bits 10.
        while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
        text.pop_back();
        while (!text.empty() && text.back() == ' ') text.pop_back();
        if (canvas.text_size(text + "…").x <= width) return text + "…";
    }
    return "";
}

}  // namespace pliant::viewer
