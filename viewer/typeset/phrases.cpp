#include "typeset/phrases.h"

#include <pliant/formula/unit.h>

#include "typeset/words_of_formulas.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr std::size_t longest_group = 12;  // words between two parentheses of one formula

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
        return i < tokens_.size() && tokens_[i].bare_before() && tokens_[i].bare_behind() && is_sign_word(core(i));
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

    // "per m", "in N".
    bool names_unit(std::size_t i) const {
        return core(i).size() == 1 && is_prefixed_unit(core(i)) && i > 0 && (core(i - 1) == "per" || core(i - 1) == "in");
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
        if (names_unit(i)) return std::nullopt;
        if (is_symbol(word) || (beside_sign && may_be_symbol(word))) return ++symbols_, i + 1;
        if (is_function_name(word) && tokens_[i].bare_behind()) return factor(i + 1, true, beside_sign);
        return std::nullopt;
    }

    // What signs tie together; a number may have its unit, or a symbol behind it.
    std::optional<std::size_t> operand(std::size_t i, bool inside) {
        if (i >= tokens_.size()) return std::nullopt;
        std::size_t at = i;
        bool number = false;
        if (is_number(core(at))) {
            number = true, ++at;
            const auto unit_at = [&](std::size_t k) {
                return k < tokens_.size() && tokens_[k - 1].bare_behind() && tokens_[k].bare_before() &&
                       is_unit_of_number(core(k));
            };
            if (unit_at(at)) {
                while (unit_at(at)) ++at;
                return at;
            }
        }
        for (;;) {
            if (at > i && (!tokens_[at - 1].bare_behind() || at >= tokens_.size() || !tokens_[at].bare_before())) break;
            const bool begun = inside || at > i;
            const bool beside_symbol =
                core(at).size() == 2 && at + 1 < tokens_.size() && tokens_[at].bare_behind() && is_symbol(core(at + 1));
            const bool beside_sign = sign_at(at + 1) || (begun && at > 0 && sign_at(at - 1)) || beside_symbol;
            const auto next = factor(at, begun, beside_sign);
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
