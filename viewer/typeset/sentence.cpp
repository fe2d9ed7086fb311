#include "typeset/sentence.h"

#include <pliant/formula/unicode.h>
#include <pliant/lesson/flowing_lines.h>

#include "typeset/phrases.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace pliant::viewer {
namespace {

// Of the height of a line: above and below the baseline, and what parts two lines whose letters come close.
constexpr float ascent = 0.8f, descent = 0.2f, least_gap = 0.06f;
constexpr float beside_words = 0.93f;                      // the face of formulas, whose letters are larger
constexpr char kept_blank = '\x1f', kept_dollar = '\x1e';  // a blank at which no line ends, a $ that marks nothing

// Letters of the face of the words, one behind the other.
MathBox set_words(std::string_view text, const MathMetrics& metrics, float size) {
    MathBox box;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint c = code_point(text, at);
        at += c.bytes;
        const LetterBounds b = metrics.bounds(c.letter, MathFace::words, size);
        if (c.letter != ' ') {
            box.letters.push_back({.letter = c.letter, .face = MathFace::words, .size = size, .x = box.width});
            box.above = std::max(box.above, -b.top), box.below = std::max(box.below, b.bottom);
        }
        box.width += b.advance;
    }
    return box;
}

MathBox set_phrase(const Phrase& phrase, const MathMetrics& metrics, float size) {
    if (!phrase.formula) return set_words(phrase.text, metrics, size);
    return set_formula(notation(phrase.text, Numbers::with_units), metrics, beside_words * size, 0, Fractions::in_line);
}

// A line of a marked text.
MathBox set_line(std::string text, const MathMetrics& metrics, float size) {
    std::ranges::replace(text, kept_blank, ' ');
    MathBox line;
    for (Phrase& phrase : phrases_of(text)) {
        std::ranges::replace(phrase.text, kept_dollar, '$');
        const float x = line.width;
        line.put(set_phrase(phrase, metrics, size), x, 0);
    }
    return line;
}

// A formula in parts that each begin with a relation, but for the first.
std::vector<std::string> parts_of(const std::string& formula) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t at = formula.find(' '); at != std::string::npos; at = formula.find(' ', at + 1)) {
        const bool relation = std::ranges::any_of(std::array{" = ", " ≈ ", " ≤ ", " ≥ ", " < ", " > "}, [&](std::string_view r) {
            return std::string_view(formula).substr(at).starts_with(r);
        });
        if (!relation) continue;
        parts.push_back(formula.substr(from, at - from));
        from = at + 1;
    }
    parts.push_back(formula.substr(from));
    return parts;
}

// With its formulas between two $ and without blanks at which a line could end, where they have room in one; else in parts.
std::string marked(std::string_view text, const MathMetrics& metrics, float size, float width) {
    const auto fits = [&](const std::string& formula) {
        return width <= 0 || set_phrase({formula, true}, metrics, size).width <= width;
    };
    std::string all;
    for (const Phrase& phrase : phrases_of(text)) {
        std::vector<std::string> parts{phrase.text};
        if (phrase.formula && !fits(phrase.text)) parts = parts_of(phrase.text);
        for (std::string& part : parts) {
            if (&part != &parts.front()) all += ' ';
            const bool whole = phrase.formula && fits(part);
            std::ranges::replace(part, '$', kept_dollar);
            if (whole) std::ranges::replace(part, ' ', kept_blank);
            all += whole ? "$" + part + "$" : part;
        }
    }
    return all;
}

std::vector<std::string> lines_of(std::string_view text, const MathMetrics& metrics, float size, float width) {
    std::vector<std::string> lines;
    while (true) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string paragraph = marked(text.substr(0, end), metrics, size, width);
        if (width <= 0)
            lines.push_back(paragraph);
        else
            std::ranges::move(flowing_lines(paragraph, static_cast<double>(width),
                                            [&](const std::string& words) {
                                                return static_cast<double>(set_line(words, metrics, size).width);
                                            }),
                              std::back_inserter(lines));
        if (end == text.size()) return lines;
        text.remove_prefix(end + 1);
    }
}

}  // namespace

MathBox set_sentence(std::string_view text, const MathMetrics& metrics, float size, float width) {
    MathBox whole;
    float y = 0, lowest = 0;  // of the baseline of the line before, and of its letters
    bool first = true;
    for (const std::string& words : lines_of(text, metrics, size, width)) {
        MathBox line = set_line(words, metrics, size);
        if (!std::exchange(first, false)) y = std::max(y + size, lowest + line.above + least_gap * size);
        lowest = y + line.below;
        line.above = std::max(line.above, ascent * size), line.below = std::max(line.below, descent * size);
        whole.put(std::move(line), 0, y);
    }
    return whole;
}

}  // namespace pliant::viewer
