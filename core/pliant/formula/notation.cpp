#include <pliant/formula/notation.h>
#include <pliant/formula/unicode.h>
#include <pliant/formula/unit.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace pliant {
namespace {

using Kind = Notation::Kind;

constexpr std::array<std::string_view, 24> upright_names{"sin",  "cos",  "tan", "asin", "acos",  "atan",  "atan2", "sinh",
                                                         "cosh", "tanh", "exp", "ln",   "log10", "log",   "min",   "max",
                                                         "det",  "tr",   "div", "diag", "sign",  "floor", "curl",  "grad"};
constexpr std::array<std::string_view, 30> known_words{
    "in", "at", "by", "of", "or", "is",   "to",  "as",  "on",  "an",  "it",  "so", "be",  "no",         "if",
    "up", "we", "do", "go", "vs", "StVK", "CFL", "RMS", "FEM", "PDE", "SVD", "CG", "BDF", "MacCormack", "SPH"};

template <class Letters>
bool is_one_of(char32_t c, const Letters& letters) {
    return std::u32string_view(letters).find(c) != std::u32string_view::npos;
}
bool is_relation(char32_t c) { return is_one_of(c, U"=≤≥<>≈←→≠∈≪≫∝~"); }
bool is_sign(char32_t c) { return is_one_of(c, U"+−-·×:±∘⊗"); }
bool is_prefix(char32_t c) { return is_one_of(c, U"∂∇Δ∆δ"); }
bool is_large(char32_t c) { return is_one_of(c, U"Σ∑∫∏∮"); }
bool is_small_latin(char32_t c) { return c >= 'a' && c <= 'z'; }
bool is_latin(char32_t c) { return is_small_latin(c) || (c >= 'A' && c <= 'Z'); }

struct AccentedLetter {
    char32_t whole;
    std::string_view letter, accent;
};
constexpr std::array<AccentedLetter, 13> accented_letters{{{U'ũ', "u", "~"},
                                                           {U'ñ', "n", "~"},
                                                           {U'ã', "a", "~"},
                                                           {U'õ', "o", "~"},
                                                           {U'ẽ', "e", "~"},
                                                           {U'ṽ', "v", "~"},
                                                           {U'û', "u", "^"},
                                                           {U'ê', "e", "^"},
                                                           {U'ŷ', "y", "^"},
                                                           {U'ū', "u", "¯"},
                                                           {U'ẋ', "x", "˙"},
                                                           {U'ẍ', "x", "¨"},
                                                           {U'ẏ', "y", "˙"}}};
// "½" and its like, with the digits above and below the line.
constexpr std::array<std::pair<char32_t, std::string_view>, 8> small_fractions{
    {{U'½', "12"}, {U'¼', "14"}, {U'¾', "34"}, {U'⅓', "13"}, {U'⅔', "23"}, {U'⅙', "16"}, {U'⅛', "18"}, {U'⅕', "15"}}};
constexpr std::array<std::pair<char32_t, std::string_view>, 5> combining_accents{
    {{U'\u0302', "^"}, {U'\u0303', "~"}, {U'\u0304', "¯"}, {U'\u0307', "˙"}, {U'\u0308', "¨"}}};

std::string_view accent_of(char32_t c) {
    const auto found = std::ranges::find(combining_accents, c, [](const auto& a) { return a.first; });
    return found == combining_accents.end() ? std::string_view() : found->second;
}

// Pieces that a fraction may take as a factor.
bool is_factor(const Notation& n) {
    return n.kind == Kind::variable || n.kind == Kind::digits || n.kind == Kind::name || n.kind == Kind::fraction ||
           n.kind == Kind::root || n.kind == Kind::row || n.kind == Kind::scripts || n.kind == Kind::accent ||
           n.kind == Kind::fence || (n.kind == Kind::prefix && n.text != "−");
}
bool is_product_sign(const Notation& n) { return n.kind == Kind::sign && (n.text == "·" || n.text == "×"); }

class NotationReader {
public:
    NotationReader(std::string_view text, Numbers numbers) : text_(text), numbers_(numbers) {}
    Notation whole() {
        Notation all = row();
        // A closing letter that nothing opened stands for itself.
        while (at_ < text_.size()) {
            all.of.push_back({.kind = Kind::variable, .text = std::string(take_letter())});
            Notation more = row();
            std::ranges::move(more.of, std::back_inserter(all.of));
        }
        return all;
    }

private:
    char32_t here(std::size_t ahead = 0) const {
        std::size_t at = at_;
        for (; ahead > 0 && at < text_.size(); --ahead) at += code_point(text_, at).bytes;
        return at < text_.size() ? code_point(text_, at).letter : U'\0';
    }
    std::string_view take_letter() {
        const std::size_t bytes = code_point(text_, at_).bytes;
        at_ += bytes;
        return text_.substr(at_ - bytes, bytes);
    }
    std::size_t skip_blanks() {
        const std::size_t from = at_;
        while (here() == ' ') ++at_;
        return at_ - from;
    }

    // Up to a closing letter, or a bar where one is open.
    Notation row() {
        Notation all;
        for (;;) {
            const std::size_t blanks = skip_blanks();
            const char32_t c = here();
            if (c == 0 || c == ')' || c == ']' || c == '}' || c == U'⟩' || (closes_ != 0 && c == closes_ && bar_may_close(all)))
                return all;
            if (blanks > 1 && !all.of.empty()) all.of.push_back({.kind = Kind::gap});
            if (c == '/' && !all.of.empty()) {
                ++at_;
                all.of.push_back(fraction(all, blanks > 0));
                continue;
            }
            Notation next = unit_follows(all, blanks) ? unit() : piece(all);
            next.spaced = blanks > 0;
            all.of.push_back(std::move(next));
        }
    }
    static bool bar_may_close(const Notation& all) {
        return !all.of.empty() && all.of.back().kind != Kind::sign && all.of.back().kind != Kind::relation;
    }

    // Where a blank-free run from here ends.
    std::size_t token_end(std::size_t from) const {
        std::size_t end = from;
        while (end < text_.size() && std::string_view(" ,;:()[]=|").find(text_[end]) == std::string_view::npos) ++end;
        return end;
    }
    bool unit_follows(const Notation& all, std::size_t blanks) const {
        if (numbers_ == Numbers::plain || blanks != 1 || all.of.empty()) return false;
        const Notation& last = all.of.back().kind == Kind::scripts ? all.of.back().of[0] : all.of.back();
        const std::string_view token = text_.substr(at_, token_end(at_) - at_);
        return last.kind == Kind::digits && !token.empty() && (is_prefixed_unit(token) || token == "g");  // grams
    }
    // "kg m²/s²" up to a blank: upright letters, with their exponents.
    Notation unit() {
        Notation all;
        std::size_t end = token_end(at_);
        // "N m" has a blank in it.
        while (end + 1 < text_.size() && text_[end] == ' ' && token_end(end + 1) > end + 1 &&
               is_prefixed_unit(text_.substr(at_, token_end(end + 1) - at_)))
            end = token_end(end + 1);
        while (at_ < end) {
            Notation name{.kind = Kind::name};
            while (at_ < end && raised(here()).empty()) name.text += take_letter();
            all.of.push_back(with_scripts(std::move(name)));
        }
        return all;
    }

    // Behind the slash: what stands before it in the row goes above the line.
    Notation fraction(Notation& before, bool spaced) {
        std::vector<Notation> above;
        auto& of = before.of;
        while (!of.empty() && (is_factor(of.back()) || (spaced && !above.empty() && is_product_sign(of.back())))) {
            const bool blank = of.back().spaced;
            above.insert(above.begin(), std::move(of.back()));
            of.pop_back();
            if (!spaced && blank) break;
        }
        const bool first_spaced = !above.empty() && above.front().spaced;
        skip_blanks();
        Notation below;
        do below.of.push_back(piece(below));
        while (at_ < text_.size() && begins_tight_factor());
        if (here() == ' ' && here(1) != ' ') {
            ++at_;
            if (unit_follows(below, 1))
                below.of.push_back(unit()), below.of.back().spaced = true;
            else
                --at_;
        }
        return {.kind = Kind::fraction,
                .of = {without_parentheses({.of = std::move(above)}), without_parentheses(std::move(below))},
                .spaced = first_spaced};
    }
    bool begins_tight_factor() const {
        const char32_t c = here();
        return is_letter(c) || is_digit(c) || c == U'√' || is_prefix(c) || (c == '|' && closes_ != '|');
    }
    static Notation without_parentheses(Notation row) {
        if (row.of.size() == 1 && row.of[0].kind == Kind::fence && row.of[0].text == "()") return std::move(row.of[0].of[0]);
        return row;
    }

    // One piece with its indices and exponents.
    Notation piece(const Notation& before) {
        const std::size_t from = at_;
        Notation base = primary(before);
        if (at_ == from) base.text = take_letter();
        return with_scripts(std::move(base));
    }

    Notation primary(const Notation& before) {
        const char32_t c = here();
        if (c == '(' || c == '[' || c == '{' || c == U'⟨') return fenced(c);
        if (c == '|' || c == U'‖') return bars(c);
        if (is_digit(c)) return number();
        if (c == U'√') return root();
        if (is_latin(c)) return letters(before);
        if (is_large(c)) return {.kind = Kind::large, .text = std::string(take_letter())};
        if (const auto f = std::ranges::find(small_fractions, c, [](const auto& s) { return s.first; });
            f != small_fractions.end())
            return small_fraction(f->second);
        if (is_relation(c)) return relation();
        if (is_sign(c)) return sign(before);
        if (c == ',' || c == ';') return {.kind = Kind::comma, .text = std::string(take_letter())};
        if (is_prefix(c)) return {.kind = Kind::prefix, .text = std::string(take_letter())};
        const auto known = std::ranges::find(accented_letters, c, &AccentedLetter::whole);
        if (known != accented_letters.end()) {
            take_letter();
            return accented({.kind = Kind::variable, .text = std::string(known->letter)}, known->accent);
        }
        return combined({.kind = is_letter(c) ? Kind::variable : Kind::digits, .text = std::string(take_letter())});
    }
    static Notation accented(Notation base, std::string_view accent) {
        return {.kind = Kind::accent, .text = std::string(accent), .of = {std::move(base)}};
    }
    // With the accent that follows.
    Notation combined(Notation base) {
        const std::string_view accent = accent_of(here());
        if (accent.empty()) return base;
        take_letter();
        return accented(std::move(base), accent);
    }

    Notation small_fraction(std::string_view digits) {
        const auto digit = [&](std::size_t k) {
            return Notation{.of = {{.kind = Kind::digits, .text = std::string(digits.substr(k, 1))}}};
        };
        return {.kind = Kind::fraction, .text = std::string(take_letter()), .of = {digit(0), digit(1)}};
    }

    // "[J]" and "[10⁶ J/m³]" behind the name of an axis.
    std::optional<Notation> unit_in_brackets() {
        const std::size_t from = at_, end = text_.find(']', at_);
        if (numbers_ == Numbers::plain || end == text_.npos) return std::nullopt;
        Notation inner;
        ++at_;
        if (text_.substr(at_, 2) == "10" && text_.find(' ', at_) < end) inner.of.push_back(with_scripts(number())), skip_blanks();
        if (is_prefixed_unit(text_.substr(at_, end - at_))) {
            inner.of.push_back(unit());
            inner.of.back().spaced = true;
            if (at_ == end) return ++at_, Notation{.kind = Kind::fence, .text = "[]", .of = {std::move(inner)}};
        }
        at_ = from;
        return std::nullopt;
    }

    Notation fenced(char32_t open) {
        if (open == '[')
            if (auto bracketed = unit_in_brackets()) return std::move(*bracketed);
        const char32_t close = open == '(' ? ')' : open == '[' ? ']' : open == '{' ? '}' : U'⟩';
        std::string pair(take_letter());
        const char32_t outer = std::exchange(closes_, U'\0');
        Notation inner = row();
        closes_ = outer;
        // Left open: only the first letter is drawn.
        if (here() == close) pair += take_letter();
        if (pair == "[]")
            if (auto rows = grid_of(inner)) return std::move(*rows);
        return {.kind = Kind::fence, .text = std::move(pair), .of = {std::move(inner)}};
    }
    // "[a b; c d]": rows of equal length, their entries parted by blanks.
    static std::optional<Notation> grid_of(const Notation& inner) {
        Notation rows{.kind = Kind::grid, .of = {Notation{}}};
        bool after_gap = false;  // which has begun an entry
        for (std::size_t k = 0; k < inner.of.size(); ++k) {
            Notation n = inner.of[k];
            if (n.kind == Kind::comma && n.text == ",") return std::nullopt;
            if (n.kind == Kind::comma) {
                rows.of.emplace_back();
                continue;
            }
            if (n.kind == Kind::gap) {
                if (!rows.of.back().of.empty()) rows.of.back().of.emplace_back(), after_gap = true;
                continue;
            }
            // "c −s" are two entries, "c − s" is one.
            if (n.kind == Kind::sign && n.spaced && k + 1 < inner.of.size() && !inner.of[k + 1].spaced) n.kind = Kind::prefix;
            auto& entries = rows.of.back().of;
            const bool operand = !entries.empty() && !entries.back().of.empty() && entries.back().of.back().kind == Kind::sign;
            if (entries.empty() || (n.spaced && n.kind != Kind::sign && !operand && !after_gap)) entries.emplace_back();
            after_gap = false;
            entries.back().of.push_back(std::move(n));
        }
        const std::size_t columns = rows.of[0].of.size();
        const bool even = std::ranges::all_of(rows.of, [&](const Notation& r) { return r.of.size() == columns; });
        return rows.of.size() > 1 && even ? std::optional(std::move(rows)) : std::nullopt;
    }

    Notation bars(char32_t bar) {
        const std::size_t from = at_;
        const std::string mark(take_letter());
        const char32_t outer = std::exchange(closes_, bar);
        Notation inner = row();
        closes_ = outer;
        if (here() == bar && !inner.of.empty()) {
            take_letter();
            return {.kind = Kind::fence, .text = mark + mark, .of = {std::move(inner)}};
        }
        at_ = from + mark.size();
        return {.kind = Kind::sign, .text = mark};
    }

    Notation number() {
        const std::size_t from = at_;
        while (is_digit(here()) || (here() == '.' && is_digit(here(1)))) ++at_;
        // "2D" is a word.
        if (here() == 'D' && !is_letter(here(1))) return ++at_, Notation{.kind = Kind::words, .text = slice(from)};
        const std::size_t mantissa = at_;
        if (here() == 'e') {
            ++at_;
            if (here() == '+' || here() == '-') ++at_;
            while (is_digit(here())) ++at_;
            if (!is_digit(static_cast<unsigned char>(text_[at_ - 1]))) at_ = mantissa;
        }
        return {.kind = Kind::digits, .text = slice(from)};
    }
    std::string slice(std::size_t from) const { return std::string(text_.substr(from, at_ - from)); }

    Notation root() {
        take_letter();
        Notation under;
        under.of.push_back(piece(under));
        return {.kind = Kind::root, .of = {without_parentheses(std::move(under))}};
    }

    // "+=" and "−=" are one relation.
    Notation relation() {
        std::string text(take_letter());
        if (text == "<" && here() == '=') text = "≤", ++at_;
        return {.kind = Kind::relation, .text = std::move(text)};
    }
    Notation sign(const Notation& before) {
        std::string text(take_letter());
        if (text == "-") text = "−";
        if (here() == '=' && (text == "+" || text == "−")) return ++at_, Notation{.kind = Kind::relation, .text = text + "="};
        const Kind last = before.of.empty() ? Kind::gap : before.of.back().kind;
        const bool first = last == Kind::gap || last == Kind::sign || last == Kind::relation || last == Kind::comma ||
                           ((last == Kind::words || last == Kind::large) && here() != ' ');
        const bool apart = at_ > 1 && text_[at_ - 2] == ' ';
        if (text == ":" && (before.of.empty() || (here() == ' ' && !apart))) return {.kind = Kind::comma, .text = ":"};
        return {.kind = first && text != "·" ? Kind::prefix : Kind::sign, .text = std::move(text)};
    }

    // Where a run of Latin letters from here ends.
    std::size_t run_end(std::size_t at) const {
        while (at < text_.size() && is_latin(static_cast<unsigned char>(text_[at]))) ++at;
        return at;
    }
    bool is_word(std::size_t from, std::size_t end) const {
        const std::string_view run = text_.substr(from, end - from);
        const char32_t after = end < text_.size() ? code_point(text_, end).letter : U' ';
        if (after == '_' || lowered_digit(after) >= 0 || raised_digit(after) >= 0 || after == '(') return false;
        if (std::ranges::find(known_words, run) != known_words.end()) return true;
        // "St. Venant"
        const bool shortened = run.size() == 2 && after == '.' && end + 2 < text_.size() && text_[end + 1] == ' ';
        if (shortened && !is_small_latin(static_cast<unsigned char>(run[0])) &&
            is_small_latin(static_cast<unsigned char>(run[1])))
            return is_latin(static_cast<unsigned char>(text_[end + 2]));
        return run.size() > 2 && std::ranges::all_of(run.substr(1), [](char c) { return c >= 'a' && c <= 'z'; });
    }
    Notation letters(const Notation& before) {
        const std::size_t from = at_, end = run_end(at_);
        const std::string_view run = text_.substr(from, end - from);
        if (std::ranges::find(upright_names, run) != upright_names.end() || (run == "log" && text_.substr(end, 2) == "10")) {
            at_ = end + (run == "log" && text_.substr(end, 2) == "10" ? 2 : run == "atan" && text_.substr(end, 1) == "2" ? 1 : 0);
            return {.kind = Kind::name, .text = slice(from)};
        }
        if (run == "mean" && is_mean_of(end)) return at_ = end, Notation{.kind = Kind::name, .text = slice(from)};
        if (is_word(from, end) || is_article(before, from, end)) return words(from, end);
        return combined({.kind = Kind::variable, .text = std::string(take_letter())});
    }
    // "mean x_i", "mean_i x_i", "mean(x)"; else it is a word.
    bool is_mean_of(std::size_t end) const {
        if (end >= text_.size()) return false;
        const char32_t next = code_point(text_, end).letter;
        if (next != ' ') return next == '_' || next == '(' || !lowered(next).empty();
        if (end + 1 >= text_.size()) return false;
        const char32_t operand = code_point(text_, end + 1).letter;
        return operand == '|' || operand == '(' || (is_letter(operand) && !is_word(end + 1, run_end(end + 1)));
    }
    // "a" before a word.
    bool is_article(const Notation& before, std::size_t from, std::size_t end) const {
        if (text_.substr(from, end - from) != "a" || text_.substr(end, 1) != " ") return false;
        const std::size_t next_end = run_end(end + 1);
        if (!is_word(end + 1, next_end) || next_end == end + 1) return false;
        // A sentence begins with it, but no formula: "a step multiplies by".
        if (before.of.empty()) return numbers_ == Numbers::with_units && next_end > end + 3;
        return before.of.back().kind == Kind::words || before.of.back().kind == Kind::comma;
    }
    // As many words as follow each other, with their punctuation and hyphens.
    Notation words(std::size_t from, std::size_t end) {
        at_ = end;
        for (;;) {
            const char32_t c = here();
            if ((c == '\'' || c == U'’' || c == '-') && is_latin(here(1))) {
                ++at_, at_ = run_end(at_);
                continue;
            }
            if (c != ' ' || !is_latin(here(1))) break;
            const std::size_t next = at_ + 1, next_end = run_end(next);
            const bool article = text_.substr(next, next_end - next) == "a" && text_.substr(next_end, 1) == " " &&
                                 run_end(next_end + 1) > next_end + 1 && is_word(next_end + 1, run_end(next_end + 1));
            const std::string_view run = text_.substr(next, next_end - next);
            if (std::ranges::find(upright_names, run) != upright_names.end() || (!is_word(next, next_end) && !article)) break;
            at_ = next_end;
        }
        return {.kind = Kind::words, .text = slice(from)};
    }

    // ---- indices and exponents ----
    Notation with_scripts(Notation base) {
        Notation below, above;
        for (;;) {
            const char32_t c = here();
            if (c == '_' && at_ + 1 < text_.size())
                ++at_, index(below);
            else if (c == '^' && at_ + 1 < text_.size())
                ++at_, exponent(above);
            else if (c == '\'' || c == U'′')
                above.of.push_back({.kind = Kind::variable, .text = "′"}), take_letter();
            else if (c == U'″')
                above.of.push_back({.kind = Kind::variable, .text = "″"}), take_letter();
            else if (const std::string_view low = lowered(c); !low.empty())
                below.of.push_back(script_letter(low)), take_letter();
            else if (const std::string_view high = raised(c); !high.empty())
                above.of.push_back(script_letter(high)), take_letter();
            else
                break;
        }
        if (below.of.empty() && above.of.empty()) return base;
        return {.kind = Kind::scripts, .of = {std::move(base), std::move(below), std::move(above)}};
    }
    static Notation script_letter(std::string_view text) {
        const char32_t c = code_point(text, 0).letter;
        const Kind kind = is_digit(c) ? Kind::digits : is_letter(c) && c != 'T' ? Kind::variable : Kind::digits;
        return {.kind = kind, .text = std::string(text)};
    }
    // Letters and digits behind the underscore: a word of more than two letters stands upright.
    void index(Notation& below) {
        if (here() == '(' || here() == '{') {
            Notation inner = fenced(here());
            below.of.push_back(std::move(inner.of[0]));
            return;
        }
        std::size_t end = run_end(at_);
        if (end - at_ > 2 || text_.substr(at_, end - at_) == "in") {
            below.of.push_back({.kind = Kind::name, .text = std::string(text_.substr(at_, end - at_))});
            at_ = end;
            if (here() == '_') ++at_, below.of.push_back({.kind = Kind::comma, .text = ","}), index(below);
            return;
        }
        while (is_letter(here()) || is_digit(here()))
            below.of.push_back({.kind = is_digit(here()) ? Kind::digits : Kind::variable, .text = std::string(take_letter())});
        if (here() == '_') ++at_, below.of.push_back({.kind = Kind::comma, .text = ","}), index(below);
    }
    void exponent(Notation& above) {
        if (here() == U'−' || here() == '-') above.of.push_back({.kind = Kind::prefix, .text = "−"}), take_letter();
        Notation one;
        one.of.push_back(primary(one));
        one = without_parentheses(std::move(one));
        std::ranges::move(one.of, std::back_inserter(above.of));
    }

    std::string_view text_;
    Numbers numbers_;
    std::size_t at_ = 0;
    char32_t closes_ = U'\0';  // the bar that is open here
};

}  // namespace

Notation notation(std::string_view text, Numbers numbers) { return NotationReader(text, numbers).whole(); }

}  // namespace pliant
