#include "typeset/math_box.h"

#include <pliant/formula/unicode.h>

#include "typeset/math_letters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace pliant::viewer {
namespace {

using Kind = Notation::Kind;

// Lengths in heights of a line of type, after the look of the face.
constexpr float script_size = 0.72f, smallest_script = 0.55f, fraction_size = 0.92f;
constexpr float around_sign = 0.20f, around_relation = 0.25f, after_comma = 0.22f, between_formulas = 1.1f, beside_words = 0.24f,
                between_factors = 0.13f, after_name = 0.14f;
constexpr float least_before_breaking = 0.7f;

// Indices stand below it: of Σ, and of max, min and mean.
bool takes_limits(const Notation& n) {
    return n.kind == Kind::large || (n.kind == Kind::name && (n.text == "max" || n.text == "min" || n.text == "mean"));
}
constexpr float fraction_gap = 0.10f, rule = 0.055f, line_gap = 0.30f, indent = 1.2f;

// The layout of one formula at one size.
class Setter {
public:
    Setter(const MathMetrics& metrics, float size, float whole) : metrics_(metrics), size_(size), whole_(whole) {}

    // In the face of the words: of a sentence that has numbers but no symbols.
    void set_prose() { prose_ = true; }

    MathBox lines(const Notation& row, float width) const;

private:
    Setter smaller(float factor) const {
        Setter inner(metrics_, std::max(size_ * factor, whole_ * smallest_script), whole_);
        inner.prose_ = prose_;
        return inner;
    }
    bool is_script() const { return size_ < 0.8f * whole_; }
    float thickness() const { return std::max(1.f, std::round(size_ * rule)); }
    // Of the line on which fractions and signs are centred.
    float axis() const {
        const LetterBounds minus = metrics_.bounds(U'−', MathFace::signs, size_);
        return (minus.top + minus.bottom) / 2;
    }

    MathBox letters(std::string_view text, bool leans = false, MathFace face = MathFace::signs) const;
    MathBox stretched(char32_t letter, float top, float bottom) const;
    MathBox piece(const Notation& n) const;
    MathBox row(const Notation& n) const;
    MathBox fraction(const Notation& n) const;
    MathBox root(const Notation& n) const;
    MathBox scripts(const Notation& n) const;
    MathBox limits(const Notation& n) const;
    MathBox accent(const Notation& n) const;
    MathBox fence(const Notation& n) const;
    float lean(const MathBox& box) const;
    MathBox grid(const Notation& n) const;
    float gap_between(const Notation* before, const Notation& next) const;

    const MathMetrics& metrics_;
    float size_, whole_;
    bool prose_ = false;
};

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

// Letters with room for an index below their right side.
bool undercut(const Notation& base) {
    return base.kind == Kind::variable && base.text.size() == 1 &&
           std::string_view("fFPTVWY").find(base.text[0]) != std::string_view::npos;
}

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

std::vector<Notation> formulas_of(const Notation& row) {
    std::vector<Notation> all(1);
    for (const Notation& n : row.of)
        if (n.kind == Kind::gap)
            all.emplace_back();
        else
            all.back().of.push_back(n);
    return all;
}

bool may_break_before(const Notation* before, const Notation& next) {
    if (!before) return false;
    if (before->kind == Kind::gap || before->kind == Kind::comma || before->kind == Kind::words) return true;
    return next.kind == Kind::relation || next.kind == Kind::words || (next.kind == Kind::sign && next.spaced);
}

// Words one by one, so that a line can end between them.
Notation with_single_words(const Notation& row) {
    Notation all;
    for (const Notation& n : row.of) {
        if (n.kind != Kind::words) {
            all.of.push_back(n);
            continue;
        }
        std::string_view rest = n.text;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            all.of.push_back({.kind = Kind::words, .text = std::string(rest.substr(0, end)), .spaced = true});
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return all;
}

// Greedy: a line takes what it can, first whole formulas, then what stays together in one that is too wide. The lines of a
// formula behind its first are indented.
MathBox Setter::lines(const Notation& row, float width) const {
    MathBox whole, line;
    float left = 0;  // of the present line
    const auto finish = [&](float next_left) {
        if (!line.letters.empty()) {
            const bool first = whole.letters.empty();
            const float y = first ? 0 : whole.below + size_ * line_gap + std::max(line.above, size_ * 0.5f);
            whole.put(std::exchange(line, {}), left, y);
        }
        left = next_left;
    };
    const auto put = [&](MathBox box, float gap) {
        const float x = line.letters.empty() ? 0 : line.width + gap;
        line.put(std::move(box), x, 0);
    };
    const auto fits = [&](const MathBox& box, float gap) {
        return width <= 0 || left + line.width + (line.letters.empty() ? 0 : gap) + box.width <= width;
    };
    for (const Notation& formula : formulas_of(row)) {
        MathBox box = this->row(formula);
        const float gap = size_ * between_formulas;
        if (!fits(box, gap)) finish(0);
        if (fits(box, gap)) {
            put(std::move(box), gap);
            continue;
        }
        const Notation* before = nullptr;
        for (std::size_t k = 0; k < formula.of.size();) {
            std::size_t end = k + 1;
            while (end < formula.of.size() && !may_break_before(&formula.of[end - 1], formula.of[end])) ++end;
            const Notation together{.of = {formula.of.begin() + static_cast<std::ptrdiff_t>(k),
                                           formula.of.begin() + static_cast<std::ptrdiff_t>(end)}};
            const float space = gap_between(before, formula.of[k]);
            MathBox chunk = this->row(together);
            if (!fits(chunk, space)) finish(k ? size_ * indent : 0);
            put(std::move(chunk), space);
            before = &formula.of[end - 1], k = end;
        }
    }
    finish(0);
    return whole;
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
