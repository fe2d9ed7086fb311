#include "typeset/phrases.h"

#include <pliant/formula/unicode.h>
#include <pliant/formula/unit.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr std::array<std::string_view, 19> signs{"=", "≈", "≤", "≥", "<", ">", "+", "−", "·", "×",
                                                 "/", "←", "→", "∝", "≠", "±", ":", "≪", "≫"};
constexpr std::array<std::string_view, 16> names{"sin", "cos", "tan", "asin", "acos", "atan", "exp",  "ln",
                                                 "log", "min", "max", "det",  "tr",   "div",  "sinh", "tanh"};
constexpr std::size_t longest_group = 12;  // words between two parentheses of one formula

template <class List>
bool is_one_of(std::string_view text, const List& list) {
    return std::ranges::find(list, text) != list.end();
}

// A word of the sentence without the punctuation around it.
struct Token {
    std::size_t begin, end;            // in the sentence
    std::size_t core_begin, core_end;  // without punctuation
    std::size_t closed;                // without commas and the like, but with parentheses that other words opened

    bool bare_before() const { return core_begin == begin; }
    bool bare_behind() const { return core_end == end; }
};

bool latin(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// How many parentheses stay open behind the text; −1 when one is closed that was not opened.
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

// Letters of mathematics alone: Greek, signs, accents that combine, primes, indices.
bool is_mathematical(char32_t c) {
    return (c >= 0x370 && c < 0x400) || (c >= 0x2200 && c < 0x2300 && c != U'−' && c != U'∞') || (c >= 0x300 && c <= 0x308) ||
           c == U'′' || c == U'″' || c == U'‖' || c == U'⟨' || c == U'⟩' || c == U'ũ' || c == U'û' || c == U'ẋ' || c == U'ẍ' ||
           !lowered(c).empty();
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
    if (core.empty() || is_number(core) || is_prefixed_unit(core) || has_word(core)) return false;
    bool letter = false, mathematical = false;
    char32_t before = 0;
    for (std::size_t at = 0; at < core.size();) {
        const CodePoint c = code_point(core, at);
        letter = letter || is_letter(c.letter) || is_mathematical(c.letter);
        mathematical = mathematical || is_mathematical(c.letter) || c.letter == '^' || c.letter == '=' || c.letter == '_' ||
                       c.letter == '|' || (c.letter == '/' && before != 0) || (!raised(c.letter).empty() && before != 0);
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
           !is_prefixed_unit(core) && (core.size() == 1 || (core[1] >= 'A' && core[1] <= 'Z'));
}

// What may stand behind a number and is no symbol then.
bool is_unit_of_number(std::string_view core) {
    constexpr std::array<std::string_view, 3> others{"g", "%", "°"};
    return is_prefixed_unit(core) || is_one_of(core, others);
}

class PhraseReader {
public:
    explicit PhraseReader(std::string_view text) : text_(text), tokens_(tokens_of(text)) {}

    std::vector<Phrase> read() {
        std::size_t written = 0;
        std::vector<Phrase> all;
        for (std::size_t i = 0; i < tokens_.size();) {
            symbols_ = 0;
            const auto end = formula_from(i);
            if (!end || symbols_ == 0) {
                i = end.value_or(i + 1);
                continue;
            }
            const std::size_t from = start_of(i), to = tokens_[*end - 1].core_end;
            if (from > written) all.push_back({std::string(text_.substr(written, from - written)), false});
            all.push_back({std::string(text_.substr(from, to - from)), true});
            written = to;
            i = *end;
        }
        if (written < text_.size()) all.push_back({std::string(text_.substr(written)), false});
        return all;
    }

private:
    std::string_view core(std::size_t i) const {
        const Token& t = tokens_[i];
        return text_.substr(t.core_begin, t.core_end - t.core_begin);
    }
    // A parenthesis that the sentence opened is none of the formula in it.
    std::size_t start_of(std::size_t i) const {
        const Token& t = tokens_[i];
        return t.core_begin + (opens_sentence_ && *opens_sentence_ == i ? 1 : 0);
    }
    bool sign_at(std::size_t i) const {
        return i < tokens_.size() && tokens_[i].bare_before() && tokens_[i].bare_behind() && is_one_of(core(i), signs);
    }

    // The end of the tokens from i on whose parentheses close again, as one; none when they do not.
    std::optional<std::size_t> group_end(std::size_t i) const {
        for (std::size_t k = i; k < std::min(i + longest_group, tokens_.size()); ++k) {
            const int open = open_behind(group(i, k + 1));
            if (open == 0) return k + 1;
            if (open < 0 || tokens_[k].closed != tokens_[k].end) return std::nullopt;
        }
        return std::nullopt;
    }
    std::string_view group(std::size_t i, std::size_t end) const {
        return text_.substr(tokens_[i].core_begin, tokens_[end - 1].closed - tokens_[i].core_begin);
    }
    bool symbolic_inside(std::size_t i, std::size_t end) const {
        for (std::size_t k = i; k < end; ++k) {
            std::string_view part = core(k);
            while (!part.empty() && std::string_view("([{").find(part.front()) != std::string_view::npos) part.remove_prefix(1);
            while (!part.empty() && std::string_view(")]}").find(part.back()) != std::string_view::npos) part.remove_suffix(1);
            if (has_word(part)) return false;
            if (is_symbol(part) || (may_be_symbol(part) && end > i + 1)) return true;
        }
        return false;
    }

    // One factor; `inside`: a formula has begun before it.
    std::optional<std::size_t> factor(std::size_t i, bool inside, bool beside_sign) {
        if (i >= tokens_.size()) return std::nullopt;
        const std::string_view word = core(i);
        const int open = open_behind(word);
        if (open > 0) {
            const auto end = group_end(i);
            if (!end || !symbolic_inside(i, *end)) return std::nullopt;
            // "(ν = ½)" behind a word is a remark.
            const bool whole = group(i, *end).front() == '(' && group(i, *end).back() == ')';
            if (whole && !inside) return std::nullopt;
            tokens_[*end - 1].core_end = tokens_[*end - 1].closed;
            return ++symbols_, end;
        }
        if (is_symbol(word) || (beside_sign && may_be_symbol(word))) return ++symbols_, i + 1;
        if (is_one_of(word, names) && tokens_[i].bare_behind()) return factor(i + 1, true, beside_sign);
        return std::nullopt;
    }

    // What signs tie together; a number may have its unit, or a symbol behind it.
    std::optional<std::size_t> operand(std::size_t i, bool inside) {
        if (i >= tokens_.size()) return std::nullopt;
        std::size_t at = i;
        bool number = false;
        if (is_number(core(at))) {
            number = true, ++at;
            if (at < tokens_.size() && tokens_[at - 1].bare_behind() && is_unit_of_number(core(at))) return at + 1;
        }
        for (;;) {
            if (at > i && (!tokens_[at - 1].bare_behind() || at >= tokens_.size() || !tokens_[at].bare_before())) break;
            const bool beside_sign = sign_at(at + 1) || (at > 0 && sign_at(at - 1));
            const auto next = factor(at, inside || at > i, beside_sign);
            if (!next) break;
            at = *next;
        }
        return at > i || number ? std::optional(at) : std::nullopt;
    }

    std::optional<std::size_t> formula_from(std::size_t i) {
        opens_sentence_.reset();
        auto end = operand(i, false);
        if (!end && core(i).size() > 1 && core(i).front() == '(') {
            // Within a remark in parentheses.
            Token& t = tokens_[i];
            const Token kept = t;
            ++t.core_begin;
            end = operand(i, false);
            t = kept;
            if (end) opens_sentence_ = i;
        }
        if (!end) return std::nullopt;
        while (tokens_[*end - 1].bare_behind() && sign_at(*end)) {
            const int before = symbols_;
            const auto next = operand(*end + 1, true);
            if (!next) {
                symbols_ = before;
                break;
            }
            end = next;
        }
        return end;
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::optional<std::size_t> opens_sentence_{};
    int symbols_ = 0;  // in the formula that is being read
};

}  // namespace

std::vector<Phrase> phrases_of(std::string_view sentence) {
    std::vector<Phrase> all;
    for (bool marked = false; !sentence.empty(); marked = !marked) {
        const std::size_t end = sentence.find('$');
        // One that is not closed stands for itself.
        if (!marked && end != std::string_view::npos && sentence.find('$', end + 1) == std::string_view::npos) {
            std::ranges::move(PhraseReader(sentence).read(), std::back_inserter(all));
            break;
        }
        const std::string_view part = sentence.substr(0, end);
        if (marked)
            all.push_back({std::string(part), true});
        else
            std::ranges::move(PhraseReader(part).read(), std::back_inserter(all));
        sentence.remove_prefix(std::min(part.size() + 1, sentence.size()));
    }
    return all;
}

}  // namespace pliant::viewer
