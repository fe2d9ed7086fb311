#include "plot/canvas.h"

namespace pliant::viewer {
namespace {

bool is_latin_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Takes away what is left of a word that was cut: a letter or two look like symbols.
void drop_stump(std::string& text, std::string_view whole) {
    constexpr std::size_t least = 3;
    std::size_t begin = text.size();
    while (begin > 0 && is_latin_letter(text[begin - 1])) --begin;
    const bool cut = text.size() < whole.size() && is_latin_letter(whole[text.size()]);
    if (cut && text.size() - begin < least) text.resize(begin);
    while (!text.empty() && (text.back() == ' ' || text.back() == '(' || text.back() == ',')) text.pop_back();
}

}  // namespace

std::string shortened(const Canvas& canvas, std::string_view words, float width) {
    if (canvas.text_size(words).x <= width) return std::string(words);
    std::string text(words);
    while (!text.empty()) {
        // Takes away one whole UTF-8 letter: its continuation bytes begin with the bits 10.
        while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
        text.pop_back();
        drop_stump(text, words);
        if (!text.empty() && canvas.text_size(text + "…").x <= width) return text + "…";
    }
    return "";
}

std::string shortened_name(const Canvas& canvas, std::string_view name, float width) {
    std::string cut = shortened(canvas, name, width);
    const bool of_run = name.size() > 3 && (name[0] == 'A' || name[0] == 'B') && name.substr(1, 2) == "  ";
    const bool letter_alone = cut.empty() || cut == std::string(name.substr(0, 1)) + "…";
    return of_run && letter_alone ? std::string(name.substr(0, 1)) : cut;
}

}  // namespace pliant::viewer
