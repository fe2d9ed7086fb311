#include "typeset/math_box.h"

#include "typeset/math_setter.h"

#include <algorithm>
#include <string>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr float least_before_breaking = 0.7f;

// Words one by one, so that a line can end between them.
Notation with_single_words(const Notation& row) {
    Notation all;
    for (const Notation& n : row.of) {
        if (n.kind != Notation::Kind::words) {
            all.of.push_back(n);
            continue;
        }
        std::string_view rest = n.text;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            all.of.push_back({.kind = Notation::Kind::words, .text = std::string(rest.substr(0, end)), .spaced = true});
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return all;
}

}  // namespace

void MathBox::move(float dx, float dy) {
    for (PlacedLetter& l : letters) l.x += dx, l.y += dy, l.middle += dy;
    for (PlacedRule& r : rules) r.x0 += dx, r.x1 += dx, r.y0 += dy, r.y1 += dy;
    width += dx, above -= dy, below += dy;
}

void MathBox::put(MathBox other, float dx, float dy) {
    other.move(dx, dy);
    width = std::max(width, other.width);
    above = std::max(above, other.above), below = std::max(below, other.below);
    letters.insert(letters.end(), other.letters.begin(), other.letters.end());
    rules.insert(rules.end(), other.rules.begin(), other.rules.end());
}

MathBox set_formula(const Notation& formula, const MathMetrics& metrics, float size, float width, Fractions fractions) {
    Setter setter(metrics, size, size);
    if (is_prose(formula)) setter.set_prose();
    const Notation words = with_single_words(formula);
    const bool stacked = fractions == Fractions::stacked;
    MathBox box = stacked ? setter.lines(words, width) : MathBox{};
    if (stacked && (width <= 0 || box.width <= width)) return box;
    MathBox second = setter.lines(in_line(words), width);
    return !stacked || second.width < box.width ? second : box;
}

MathBox fitted_formula(const Notation& formula, const MathMetrics& metrics, float largest, float smallest, float width,
                       float height) {
    const float step = std::max(0.5f, largest / 24);
    const auto broken = [&](float size) {
        return std::ranges::any_of(formulas_of(formula),
                                   [&](const Notation& part) { return set_formula(part, metrics, size).width > width; });
    };
    // Somewhat smaller before a formula is broken.
    for (const bool whole : {true, false})
        for (float size = largest; size > std::max(smallest, whole ? least_before_breaking * largest : 0.f); size -= step) {
            if (whole && broken(size)) continue;
            MathBox box = set_formula(formula, metrics, size, width);
            if (box.width <= width && box.height() <= height) return box;
        }
    return set_formula(formula, metrics, smallest, width);
}

}  // namespace pliant::viewer
