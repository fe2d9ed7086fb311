#include "typeset/words_of_formulas.h"

#include <pliant/formula/unicode.h>
#include <pliant/formula/unit.h>

#include <algorithm>
#include <array>

namespace pliant::viewer {
namespace {

constexpr std::array<std::string_view, 19> signs{"=", "≈", "≤", "≥", "<", ">", "+", "−", "·", "×",
                                                 "/", "←", "→", "∝", "≠", "±", ":", "≪", "≫"};
constexpr std::array<std::string_view, 16> names{"sin", "cos", "tan", "asin", "acos", "atan", "exp",  "ln",
                                                 "log", "min", "max", "det",  "tr",   "div",  "sinh", "tanh"};

template <class List>
bool is_one_of(std::string_view text, const List& list) {
    return std::ranges::find(list, text) != list.end();
}

bool latin(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Letters of mathematics alone: Greek, signs, accents that combine, primes, indices.
bool is_mathematical(char32_t c) {
    return (c >= 0x370 && c < 0x400) || (c >= 0x2200 && c < 0x2300 && c != U'−' && c != U'∞') || (c >= 0x300 && c <= 0x308) ||
           c == U'′' || c == U'″' || c == U'‖' || c == U'⟨' || c == U'⟩' || c == U'ũ' || c == U'û' || c == U'ẋ' || c == U'ẍ' ||
           !lowered(c).empty();
}

}  // namespace

bool is_sign_word(std::string_view word) { return is_one_of(word, signs); }
bool is_function_name(std::string_view word) { return is_one_of(word, names); }

int open_behind(std::string_view text) {
    int depth = 0;
    for (const char c : text) {
        if (c == '(' || c == '[' || c == '{') ++depth;
        if ((c == ')' || c == ']' || c == '}') && --depth < 0) return -1;
    }
    return depth;
}

std::vector<Token> tokens_of(std::string_view text) {
    std::vector<Token> all;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == ' ' || text[at] == '\n') {
            ++at;
            continue;
        }
        Token t{at, std::min(text.find_first_of(" \n", at), text.size()), 0, 0, 0};
        t.core_begin = t.begin, t.core_end = t.end;
        const auto core = [&] { return text.substr(t.core_begin, t.core_end - t.core_begin); };
        while (core().size() > 1 && std::string_view(".,;:!?\"").find(core().back()) != std::string_view::npos) --t.core_end;
        t.closed = t.core_end;
        while (core().size() > 1 && core().back() == ')' && open_behind(core()) < 0) --t.core_end;
        while (core().size() > 1 && std::string_view(".,;:!?\"").find(core().back()) != std::string_view::npos) --t.core_end;
        if (core().size() > 1 && (core().front() == '"')) ++t.core_begin;
        all.push_back(t);
        at = t.end;
    }
    return all;
}

bool is_number(std::string_view core) {
    bool digit = false;
    for (std::size_t at = 0; at < core.size();) {
        const CodePoint c = code_point(core, at);
        const bool fraction = (c.letter >= 0xbc && c.letter <= 0xbe) || (c.letter >= 0x2150 && c.letter <= 0x215f);
        digit = digit || is_digit(c.letter) || fraction;
        const bool sign = c.letter == U'−' || c.letter == '-' || c.letter == '.' || c.letter == U'⁻';
        if (!is_digit(c.letter) && !fraction && !sign && raised_digit(c.letter) < 0) return false;
        at += c.bytes;
    }
    return digit;
}

// A run of letters that is a word: three of them or more, not the name of a function, and no short index.
bool has_word(std::string_view core) {
    constexpr std::size_t longest_index = 6;
    for (std::size_t at = 0; at < core.size();) {
        std::size_t end = at;
        while (end < core.size() && latin(static_cast<unsigned char>(core[end]))) ++end;
        const bool index = at > 0 && core[at - 1] == '_' && end - at <= longest_index;
        if (end - at > 2 && !index && !is_one_of(core.substr(at, end - at), names)) return true;
        at = std::max(end, at + 1);
    }
    return false;
}

bool is_symbol(std::string_view core) {
    // N and m are units behind a number alone, where nobody asks.
    if (core.empty() || is_number(core) || (core.size() > 1 && is_prefixed_unit(core)) || has_word(core)) return false;
    bool letter = false, mathematical = false;
    char32_t before = 0;
    for (std::size_t at = 0; at < core.size();) {
        const CodePoint c = code_point(core, at);
        letter = letter || is_letter(c.letter) || is_mathematical(c.letter);
        mathematical = mathematical || is_mathematical(c.letter) || c.letter == '^' || c.letter == '=' || c.letter == '_' ||
                       c.letter == '|' || ((c.letter == '/' || c.letter == U'·') && before != 0) ||
                       (!raised(c.letter).empty() && before != 0);
        before = c.letter;
        at += c.bytes;
    }
    if (mathematical) return letter;
    // "x", "dx", "2u", "−k", "f(x)".
    const std::size_t from = core.find_first_not_of("0123456789.");
    if (from == std::string_view::npos) return false;
    const std::string_view rest = core.substr(core.substr(from).starts_with("−") ? from + 3 : from);
    const bool applied = rest.size() > 3 && latin(static_cast<unsigned char>(rest[0])) && rest[1] == '(' && rest.back() == ')';
    if (rest.size() == 1 && latin(static_cast<unsigned char>(rest[0])))
        return from > 0 ? rest != "D" : rest != "a" && rest != "A" && rest != "B" && rest != "I";
    if (rest.size() == 2 && rest[0] == 'd' && from == 0) return rest[1] >= 'A' && rest[1] <= 'Z';
    return applied;
}

// A letter or two that are a symbol where a sign stands beside them.
bool may_be_symbol(std::string_view core) {
    return core.size() < 3 && std::ranges::all_of(core, [](char c) { return latin(static_cast<unsigned char>(c)); }) &&
           (core.size() == 1 || !is_prefixed_unit(core)) && (core.size() == 1 || (core[1] >= 'A' && core[1] <= 'Z'));
}

// What may stand behind a number and is no symbol then.
bool is_unit_of_number(std::string_view core) {
    constexpr std::array<std::string_view, 3> others{"g", "%", "°"};
    return is_prefixed_unit(core) || is_one_of(core, others);
}

}  // namespace pliant::viewer
