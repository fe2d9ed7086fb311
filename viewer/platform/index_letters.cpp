#include "platform/index_letters.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

constexpr unsigned lowered = 0xe000, raised = 0xe400, letters_end = 0x400;  // Latin and Greek
constexpr unsigned minus = 0x2212, lowered_minus = 0xe800, raised_minus = 0xe801;
constexpr unsigned prime = 0x2032;
constexpr std::size_t longest_index = 10;
constexpr float drop = 0.2f, rise = 0.22f;  // of the height of the type

using Codes = std::u32string;

Codes decoded(std::string_view text) {
    Codes codes;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        unsigned code = 0;
        at += ImTextCharFromUtf8(&code, at, end);
        codes.push_back(code);
    }
    return codes;
}

std::string encoded(const Codes& codes) {
    std::string text;
    for (const char32_t code : codes) {
        char bytes[5];
        text += ImTextCharToUtf8(bytes, static_cast<unsigned>(code));
    }
    return text;
}

bool latin(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool digit(char32_t c) { return c >= '0' && c <= '9'; }
bool greek(char32_t c) { return c >= 0x370 && c < letters_end; }
bool accented(char32_t c) { return (c >= 0xc0 && c < 0x370) || (c >= 0x1e00 && c < 0x1f00); }

// A symbol ends at `end`: a Greek or accented letter, a prime, or one Latin letter that does not end a word.
bool symbol_ends(const Codes& text, std::size_t end) {
    if (end == 0) return false;
    const char32_t last = text[end - 1];
    if (greek(last) || accented(last) || last == prime) return true;
    const char32_t before = end > 1 ? text[end - 2] : U' ';
    return latin(last) && !latin(before) && !digit(before) && before != '_';
}

// Where the index that begins at `at` ends; `at` where none does.
std::size_t index_end(const Codes& text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && (latin(text[end]) || digit(text[end]) || greek(text[end]))) ++end;
    return end - at <= longest_index && (end == text.size() || text[end] != '_') ? end : at;
}

bool has_letter(char32_t c) { return (c >= ' ' && c < letters_end) || c == minus; }

// Where the bracket that opens at `at` closes, if all in it can be raised; `at` otherwise.
std::size_t exponent_end(const Codes& text, std::size_t at) {
    if (at >= text.size() || text[at] != '(') return at;
    int depth = 0;
    for (std::size_t end = at; end < text.size() && has_letter(text[end]); ++end) {
        depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
        if (depth == 0) return end;
    }
    return at;
}

// The letter that Unicode has a lowered form of; 0 for all others. In the fonts those are too small to be read from afar.
char32_t unlowered(char32_t c) {
    constexpr std::u32string_view lowered_forms = U"₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₒₓₕₖₗₘₙₚₛₜᵢᵣᵤᵥⱼ", letters = U"0123456789+−aeoxhklmnpstiruvj";
    static_assert(lowered_forms.size() == letters.size());
    const std::size_t at = lowered_forms.find(c);
    return at == std::u32string_view::npos ? 0 : letters[at];
}

bool plain(std::string_view text) {
    return std::ranges::none_of(text, [](char c) { return c == '_' || c == '^' || static_cast<unsigned char>(c) >= 0xe1; });
}

char32_t moved(char32_t c, unsigned base, unsigned minus_there) { return c == minus ? minus_there : base + c; }

}  // namespace

std::string with_index_letters(std::string_view text) {
    if (plain(text)) return std::string(text);
    const Codes all = decoded(text);
    Codes result;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (const std::size_t end = index_end(all, i + 1); all[i] == '_' && end > i + 1 && symbol_ends(all, i)) {
            for (++i; i < end; ++i) result.push_back(moved(all[i], lowered, lowered_minus));
            --i;
        } else if (const std::size_t close = exponent_end(all, i + 1); all[i] == '^' && close > i + 1) {
            for (i += 2; i < close; ++i) result.push_back(moved(all[i], raised, raised_minus));
        } else if (const char32_t letter = unlowered(all[i])) {
            result.push_back(moved(letter, lowered, lowered_minus));
        } else {
            result.push_back(all[i]);
        }
    }
    return encoded(result);
}

void add_index_letters(ImFont& font, const ImFont& small) {
    const float same_line = font.Ascent - small.Ascent;
    const auto add = [&](const ImFontGlyph& g, unsigned code, float down) {
        const float y = std::round(same_line + down * font.FontSize);
        font.AddGlyph(nullptr, static_cast<ImWchar>(code), g.X0, g.Y0 + y, g.X1, g.Y1 + y, g.U0, g.V0, g.U1, g.V1, g.AdvanceX);
    };
    for (const ImFontGlyph& g : small.Glyphs) {
        const auto code = static_cast<char32_t>(g.Codepoint);
        if (!has_letter(code)) continue;
        add(g, static_cast<unsigned>(moved(code, lowered, lowered_minus)), drop);
        add(g, static_cast<unsigned>(moved(code, raised, raised_minus)), -rise);
    }
    font.BuildLookupTable();
}

}  // namespace pliant::viewer
