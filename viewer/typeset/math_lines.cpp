// Where a formula is broken into lines.
#include "typeset/math_setter.h"

#include <algorithm>
#include <string>
#include <utility>

namespace pliant::viewer {

std::vector<Notation> formulas_of(const Notation& row) {
    std::vector<Notation> all(1);
    for (const Notation& n : row.of)
        if (n.kind == Notation::Kind::gap)
            all.emplace_back();
        else
            all.back().of.push_back(n);
    return all;
}

namespace {

bool may_break_before(const Notation* before, const Notation& next) {
    if (!before) return false;
    if (before->kind == Notation::Kind::gap || before->kind == Notation::Kind::comma || before->kind == Notation::Kind::words)
        return true;
    return next.kind == Notation::Kind::relation || next.kind == Notation::Kind::words ||
           (next.kind == Notation::Kind::sign && next.spaced);
}

}  // namespace

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

}  // namespace pliant::viewer
