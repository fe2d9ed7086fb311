#include <pliant/math/error.h>
#include <pliant/text/source_code.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace pliant {
namespace {

using Place = std::size_t;
constexpr Place nowhere = std::string_view::npos;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

// The source with blanks in place of remarks, texts, letters and lines of the preprocessor: of the same length.
class BareCode {
public:
    explicit BareCode(std::string_view source) : source_(source), bare_(source) {
        while (at_ < source_.size()) step();
    }
    std::string take() { return std::move(bare_); }

private:
    bool here(std::string_view text) const { return source_.substr(at_).starts_with(text); }
    void blank_to(Place end) {
        for (end = std::min(end, source_.size()); at_ < end; ++at_)
            if (source_[at_] != '\n') bare_[at_] = ' ';
    }
    Place behind(std::string_view text, Place from) const {
        const Place found = source_.find(text, from);
        return found == nowhere ? nowhere : found + text.size();
    }
    Place behind_quoted(char quote) const {
        Place end = at_ + 1;
        while (end < source_.size() && source_[end] != quote) end += source_[end] == '\\' ? 2 : 1;
        return end + 1;
    }
    bool starts_line() const {
        const Place before = source_.substr(0, at_).find_last_not_of(" \t");
        return before == nowhere || source_[before] == '\n';
    }
    void step() {
        const bool in_word = at_ > 0 && is_word(source_[at_ - 1]);
        if (here("//") || (here("#") && starts_line())) return blank_to(source_.find('\n', at_));
        if (here("/*")) return blank_to(behind("*/", at_));
        if (here("R\"") && !in_word) {
            const Place open = source_.find('(', at_);
            if (open == nowhere) return blank_to(nowhere);
            return blank_to(behind(fmt::format("){}\"", source_.substr(at_ + 2, open - at_ - 2)), open));
        }
        if (here("\"") || (here("'") && !in_word)) return blank_to(behind_quoted(source_[at_]));
        ++at_;
    }

    std::string_view source_;
    std::string bare_;
    Place at_ = 0;
};

class DefinitionFinder {
public:
    DefinitionFinder(std::string_view source, std::string_view function)
        : source_(source), function_(function), bare_(BareCode(source).take()) {}

    // Where the longest begins and ends; nowhere when there is none.
    std::pair<Place, Place> find() const {
        std::pair<Place, Place> longest{nowhere, nowhere};
        for (Place at = bare_.find(function_); at != nowhere; at = bare_.find(function_, at + 1)) {
            if (!may_be_name(at)) continue;
            const Place body = body_behind(behind_name(at));
            const Place end = body == nowhere ? nowhere : behind_pair(body);
            if (end == nowhere) continue;
            const Place start = with_remarks(start_of(at));
            if (longest.first == nowhere || end - start > longest.second - longest.first) longest = {start, end};
        }
        return longest;
    }

private:
    Place behind_name(Place at) const { return at + function_.size(); }
    char letter(Place at) const { return at < bare_.size() ? bare_[at] : '\0'; }
    Place skip_blanks(Place at) const {
        while (is_blank(letter(at))) ++at;
        return at;
    }
    std::string_view word_at(Place at) const {
        Place end = at;
        while (is_word(letter(end))) ++end;
        return std::string_view(bare_).substr(at, end - at);
    }

    // Whole, and behind a type or a class: not behind an operator, as calls are.
    bool may_be_name(Place at) const {
        if (is_word(letter(behind_name(at))) || (at > 0 && is_word(bare_[at - 1]))) return false;
        Place before = at;
        while (before > 0 && is_blank(bare_[before - 1])) --before;
        if (before == 0) return true;
        const char c = bare_[before - 1];
        if (c == ':') return before > 1 && bare_[before - 2] == ':';
        if (c == '>') return before < 2 || bare_[before - 2] != '-';
        return is_word(c) || c == '&' || c == '*' || c == ';' || c == '{' || c == '}' || c == ']';
    }

    // Behind the bracket that closes the one at `open`.
    Place behind_pair(Place open) const {
        int depth = 0;
        for (Place at = open; at < bare_.size(); ++at) {
            if (std::string_view("([{").find(bare_[at]) != nowhere) ++depth;
            if (std::string_view(")]}").find(bare_[at]) != nowhere && --depth == 0) return at + 1;
        }
        return nowhere;
    }

    // The brace that opens the body of a definition whose name ends here.
    Place body_behind(Place name_end) const {
        Place at = skip_blanks(name_end);
        if (letter(at) != '(' || (at = behind_pair(at)) == nowhere) return nowhere;
        static constexpr std::array<std::string_view, 5> allowed{"const", "noexcept", "override", "final", "try"};
        for (at = skip_blanks(at);; at = skip_blanks(at)) {
            if (letter(at) == '{') return at;
            if (bare_.compare(at, 2, "->") == 0) return bare_.find_first_of("{;", at);
            if (letter(at) == ':') return body_behind_members(at + 1);
            if (letter(at) == '(' && (at = behind_pair(at)) != nowhere) continue;
            if (letter(at) == '&') {
                ++at;
                continue;
            }
            const std::string_view word = at == nowhere ? "" : word_at(at);
            if (std::ranges::find(allowed, word) == allowed.end()) return nowhere;
            at += word.size();
        }
    }
    // Behind "a(1), b{2}" of a constructor.
    Place body_behind_members(Place at) const {
        for (;;) {
            at = bare_.find_first_of("({;", at);
            if (at == nowhere || bare_[at] == ';' || (at = behind_pair(at)) == nowhere) return nowhere;
            at = skip_blanks(at);
            if (letter(at) == '{') return at;
            if (letter(at) != ',') return nowhere;
            ++at;
        }
    }

    // Behind what ends before the definition; the start of its first line.
    Place start_of(Place name) const {
        const Place before = bare_.find_last_of(";{}", name - std::min<Place>(name, 1));
        Place first = skip_blanks(before == nowhere || name == 0 ? 0 : before + 1);
        // "public:" and its like.
        if (const Place colon = first + word_at(first).size(); letter(colon) == ':' && letter(colon + 1) != ':')
            first = skip_blanks(colon + 1);
        const Place line = source_.rfind('\n', first);
        return line == nowhere ? 0 : line + 1;
    }
    Place with_remarks(Place start) const {
        while (start > 0) {
            const Place end = start - 1, line = end == 0 ? nowhere : source_.rfind('\n', end - 1);
            const Place from = line == nowhere ? 0 : line + 1;
            if (!without_blanks(source_.substr(from, end - from)).starts_with("//")) break;
            start = from;
        }
        return start;
    }

    std::string_view source_, function_;
    std::string bare_;
};

std::vector<std::string_view> split_at(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (Place from = 0; from <= text.size();) {
        const Place end = std::min(text.find(at, from), text.size());
        parts.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return parts;
}

}  // namespace

std::vector<CodePlace> code_places(std::string_view text) {
    std::vector<CodePlace> places;
    for (const std::string_view of_a_file : split_at(text, ';')) {
        const Place colon = of_a_file.find(": ");
        const std::string_view file = without_blanks(of_a_file.substr(0, colon));
        for (const std::string_view function : split_at(colon == nowhere ? "" : of_a_file.substr(colon + 2), ',')) {
            if (file.empty() || without_blanks(function).empty())
                throw Refused(fmt::format(
                    "'{}' names no code: give \"path/of/file.cpp: function\", several functions with commas, several files with "
                    "semicolons",
                    text));
            places.push_back({std::string(file), std::string(without_blanks(function))});
        }
    }
    return places;
}

CodeExcerpt definition_in(std::string_view source, std::string_view function, std::string_view path) {
    const auto [start, end] = DefinitionFinder(source, function).find();
    if (start == nowhere) throw Refused(fmt::format("{} defines no function '{}'", path, function));
    const auto lines = split_at(source.substr(start, end - start), '\n');
    const Place indent = std::min(lines.front().find_first_not_of(' '), lines.front().size());
    CodeExcerpt excerpt{
        .text = "", .first_line = static_cast<int>(std::ranges::count(source.substr(0, start), '\n')) + 1, .lines = lines.size()};
    for (const std::string_view line : lines) {
        const Place shift = std::min({indent, line.find_first_not_of(' '), line.size()});
        excerpt.text += fmt::format("{}\n", line.substr(shift));
    }
    return excerpt;
}

std::string first_lines(const CodeExcerpt& excerpt, std::size_t most) {
    if (excerpt.lines <= most) return excerpt.text;
    Place end = 0;
    for (std::size_t i = 0; i < most; ++i) end = excerpt.text.find('\n', end) + 1;
    return excerpt.text.substr(0, end) + fmt::format("// … {} more lines\n", excerpt.lines - most);
}

}  // namespace pliant
