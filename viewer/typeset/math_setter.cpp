// Letters, rows of pieces, and the gaps between them.
#include "typeset/math_setter.h"

#include <pliant/formula/unicode.h>

#include "typeset/math_letters.h"

#include <algorithm>

namespace pliant::viewer {

namespace {

// Indices stand below it: of Σ, and of max, min and mean.
bool takes_limits(const Notation& n) {
    using Kind = Notation::Kind;
    return n.kind == Kind::large || (n.kind == Kind::name && (n.text == "max" || n.text == "min" || n.text == "mean"));
}

}  // namespace

MathBox Setter::letters(std::string_view text, bool leans, MathFace face) const {
    MathBox box;
    if (prose_) face = MathFace::words;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint c = code_point(text, at);
        at += c.bytes;
        const char32_t letter = face == MathFace::signs && leans ? slanted(c.letter) : c.letter;
        const LetterBounds b = metrics_.bounds(letter, face, size_);
        box.letters.push_back({.letter = letter, .face = face, .size = size_, .x = box.width});
        box.width += b.advance;
        box.above = std::max(box.above, -b.top), box.below = std::max(box.below, b.bottom);
    }
    return box;
}

// One letter as high as from top to bottom, or higher.
MathBox Setter::stretched(char32_t letter, float top, float bottom) const {
    const LetterBounds b = metrics_.bounds(letter, MathFace::signs, size_);
    const float middle = (b.top + b.bottom) / 2, height = std::max(b.bottom - b.top, 1.f);
    const float stretch = std::max(1.f, (bottom - top) / height), half = height * stretch / 2;
    const float centre = stretch > 1 ? (top + bottom) / 2 : middle;
    MathBox box{.width = b.advance, .above = half - centre, .below = half + centre};
    box.letters.push_back({.letter = letter, .size = size_, .y = centre - middle, .stretch = stretch, .middle = centre});
    return box;
}

float Setter::gap_between(const Notation* before, const Notation& next) const {
    if (!before) return 0;
    const auto is = [](const Notation* n, Kind kind) { return n->kind == kind; };
    if (is(before, Kind::gap) || next.kind == Kind::gap) return size_ * between_formulas / 2;
    if (next.kind == Kind::comma) return 0;
    if (is(before, Kind::comma)) return size_ * after_comma;
    // Parentheses that stand in the line.
    if (before->text == "(" || next.text == ")") return 0;
    if (is(before, Kind::words) || next.kind == Kind::words) return size_ * beside_words;
    if (is_script()) return 0;
    const bool relation = is(before, Kind::relation) || next.kind == Kind::relation;
    if (relation) return size_ * around_relation;
    const bool sign = is(before, Kind::sign) || next.kind == Kind::sign;
    if (sign) return size_ * (next.spaced ? around_sign : 0.04f);
    if (is(before, Kind::name) && next.kind != Kind::fence && next.text != "(") return size_ * after_name;
    if (is(before, Kind::large) || (is(before, Kind::scripts) && takes_limits(before->of[0]))) return size_ * after_name;
    if (is(before, Kind::prefix)) return 0;
    return next.spaced ? size_ * between_factors : 0;
}

MathBox Setter::row(const Notation& n) const {
    MathBox box;
    const Notation* before = nullptr;
    for (const Notation& part : n.of) {
        const float x = box.width + gap_between(before, part);
        box.put(piece(part), x, 0);
        before = &part;
    }
    return box;
}

MathBox Setter::piece(const Notation& n) const {
    switch (n.kind) {
        case Kind::row:
            return row(n);
        case Kind::variable:
            return letters(n.text, true);
        case Kind::words:
            return letters(n.text, false, MathFace::words);
        case Kind::gap:
            return {};
        case Kind::fraction:
            return fraction(n);
        case Kind::root:
            return root(n);
        case Kind::scripts:
            return takes_limits(n.of[0]) ? limits(n) : scripts(n);
        case Kind::accent:
            return accent(n);
        case Kind::fence:
            return fence(n);
        case Kind::grid:
            return grid(n);
        case Kind::large: {
            const MathBox sign = smaller(1).letters(n.text);
            const float more = is_script() ? 1.f : 1.25f;
            return stretched(sign.letters[0].letter, axis() - more * (sign.height() / 2), axis() + more * (sign.height() / 2));
        }
        default:
            return letters(n.text);
    }
}

}  // namespace pliant::viewer
