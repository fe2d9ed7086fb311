// What stands over, under and around what.
#include "typeset/math_setter.h"

#include <pliant/formula/unicode.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {

MathBox Setter::fraction(const Notation& n) const {
    const Setter inner = smaller(n.text.empty() ? fraction_size : script_size);
    MathBox above = inner.row(n.of[0]), below = inner.row(n.of[1]);
    const float y = axis(), line = thickness(), gap = size_ * fraction_gap, side = size_ * 0.06f;
    MathBox box;
    const float width = std::max(above.width, below.width) + 2 * side;
    const float up = y - line / 2 - gap - above.below, down = y + line / 2 + gap + below.above;
    box.put(above, (width - above.width) / 2, up);
    box.put(below, (width - below.width) / 2, down);
    box.rules.push_back({0, std::round(y - line / 2), width, std::round(y - line / 2) + line});
    box.width = width + side;
    return box;
}

MathBox Setter::root(const Notation& n) const {
    MathBox under = row(n.of[0]);
    const float line = thickness(), gap = size_ * 0.08f;
    const float top = -std::max(under.above, size_ * 0.5f) - gap - line, bottom = std::max(under.below, size_ * 0.05f);
    MathBox box = stretched(U'√', top, bottom);
    const float x = box.width, ceiling = std::round(-box.above);
    box.put(under, x, 0);
    box.rules.push_back({x - 1, ceiling, box.width + size_ * 0.05f, ceiling + line});
    box.width += size_ * 0.08f;
    return box;
}

namespace {

// Letters with room for an index below their right side.
bool undercut(const Notation& base) {
    return base.kind == Notation::Kind::variable && base.text.size() == 1 &&
           std::string_view("fFPTVWY").find(base.text[0]) != std::string_view::npos;
}

}  // namespace

// How far the last letter reaches: a slanted one leans over its advance.
float Setter::lean(const MathBox& box) const {
    if (box.letters.empty()) return 0;
    const PlacedLetter& last = box.letters.back();
    return last.x + metrics_.bounds(last.letter, last.face, last.size).right;
}

MathBox Setter::scripts(const Notation& n) const {
    MathBox box = piece(n.of[0]);
    const Setter inner = smaller(script_size);
    const bool tall = n.of[0].kind == Kind::fence || n.of[0].kind == Kind::grid || n.of[0].kind == Kind::fraction;
    float width = box.width;
    if (!n.of[2].of.empty()) {
        MathBox above = inner.row(n.of[2]);
        const float x = std::max(width, lean(box)) + size_ * 0.03f;
        const float raise = std::max(size_ * 0.32f, tall ? box.above - size_ * 0.35f : 0);
        width = std::max(width, x + above.width);
        box.put(std::move(above), x, -raise);
    }
    if (!n.of[1].of.empty()) {
        MathBox below = inner.row(n.of[1]);
        const float x = box.width + size_ * (undercut(n.of[0]) ? -0.1f : 0.03f);
        const float drop = std::max(size_ * 0.16f, tall ? box.below - size_ * 0.05f : 0);
        width = std::max(width, x + below.width);
        box.put(std::move(below), x, drop);
    }
    box.width = width;
    return box;
}

// Of a sum: its indices under and over it.
MathBox Setter::limits(const Notation& n) const {
    MathBox box = piece(n.of[0]);
    const Setter inner = smaller(script_size * 0.95f);
    const float gap = size_ * 0.06f, middle = box.width / 2, sign_above = box.above, sign_below = box.below;
    MathBox below = inner.row(n.of[1]), above = inner.row(n.of[2]);
    const float shift = std::max({0.f, below.width / 2 - middle, above.width / 2 - middle});
    box.move(shift, 0);
    if (below.width > 0) box.put(below, shift + middle - below.width / 2, sign_below + gap + below.above);
    if (above.width > 0) box.put(above, shift + middle - above.width / 2, -sign_above - gap - above.below);
    return box;
}

MathBox Setter::accent(const Notation& n) const {
    MathBox box = piece(n.of[0]);
    const char32_t mark = code_point(n.text, 0).letter;
    const char32_t letter = mark == '~' ? U'\u02dc' : mark == '^' ? U'\u02c6' : mark;
    const LetterBounds b = metrics_.bounds(letter, MathFace::signs, size_);
    const float height = std::max(b.bottom - b.top, 1.f), lean = size_ * 0.05f;
    const float x = box.width / 2 - (b.left + b.right) / 2 + lean;
    const float y = -box.above - size_ * 0.07f - b.bottom;
    box.letters.push_back({.letter = letter, .size = size_, .x = x, .y = y});
    box.above += size_ * 0.07f + height;
    return box;
}

MathBox Setter::fence(const Notation& n) const {
    MathBox inner = row(n.of[0]);
    const char32_t open = code_point(n.text, 0).letter;
    const std::size_t second = code_point(n.text, 0).bytes;
    const float margin = size_ * 0.06f;
    const float top = -inner.above - margin, bottom = inner.below + margin;
    MathBox box = stretched(open, top, bottom);
    const float pad = open == '|' || open == U'‖' ? size_ * 0.04f : 0;
    box.put(inner, box.width + pad, 0);
    if (second < n.text.size()) box.put(stretched(code_point(n.text, second).letter, top, bottom), box.width + pad, 0);
    return box;
}

MathBox Setter::grid(const Notation& n) const {
    std::vector<std::vector<MathBox>> cells;
    std::vector<float> widths(n.of[0].of.size(), 0), above, below;
    for (const Notation& r : n.of) {
        cells.emplace_back(), above.push_back(size_ * 0.5f), below.push_back(size_ * 0.15f);
        for (std::size_t k = 0; k < r.of.size(); ++k) {
            MathBox cell = row(r.of[k]);
            widths[k] = std::max(widths[k], cell.width);
            above.back() = std::max(above.back(), cell.above), below.back() = std::max(below.back(), cell.below);
            cells.back().push_back(std::move(cell));
        }
    }
    MathBox inner;
    float height = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) height += above[i] + below[i] + (i ? size_ * 0.25f : 0);
    float y = axis() - height / 2;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        y += above[i];
        float x = 0;
        for (std::size_t k = 0; k < cells[i].size(); ++k) {
            inner.put(cells[i][k], x + (widths[k] - cells[i][k].width) / 2, y);
            x += widths[k] + size_ * 0.6f;
        }
        inner.width = x - size_ * 0.6f;
        y += below[i] + size_ * 0.25f;
    }
    const float top = -inner.above - size_ * 0.05f, bottom = inner.below + size_ * 0.05f;
    MathBox box = stretched('[', top, bottom);
    box.put(std::move(inner), box.width, 0);
    box.put(stretched(']', top, bottom), box.width, 0);
    return box;
}

}  // namespace pliant::viewer
