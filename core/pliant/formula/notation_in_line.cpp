// Formulas as sentences have them.
#include <pliant/formula/notation.h>

#include <algorithm>
#include <utility>

namespace pliant {
namespace {

using Kind = Notation::Kind;

void append_in_line(const Notation& n, Notation& out);

void append_fenced(const Notation& row, bool spaced, Notation& out) {
    out.of.push_back({.kind = Kind::digits, .text = "(", .spaced = spaced});
    const std::size_t first = out.of.size();
    for (const Notation& part : row.of) append_in_line(part, out);
    if (first < out.of.size()) out.of[first].spaced = false;
    out.of.push_back({.kind = Kind::digits, .text = ")"});
}

// below: the line, where more than one factor needs parentheses; a unit belongs to its number.
void append_group(const Notation& row, bool spaced, bool below, Notation& out) {
    const std::size_t first = out.of.size();
    const auto stands_alone = [](const Notation& n) { return n.kind != Kind::prefix && n.kind != Kind::row; };
    const bool factors = below && std::ranges::count_if(row.of, stands_alone) > 1;
    const bool one = !factors && std::ranges::none_of(row.of, [](const Notation& n) {
        return n.kind == Kind::sign || n.kind == Kind::relation || (n.kind == Kind::fraction && n.text.empty());
    });
    if (!one) return append_fenced(row, spaced, out);
    for (const Notation& part : row.of) append_in_line(part, out);
    if (first < out.of.size()) out.of[first].spaced = spaced;
}

void append_in_line(const Notation& n, Notation& out) {
    if (n.kind == Kind::fraction && n.text.empty()) {
        append_group(n.of[0], n.spaced, false, out);
        out.of.push_back({.kind = Kind::sign, .text = "/"});
        append_group(n.of[1], false, true, out);
    } else if (n.kind == Kind::fence && n.text == "()") {
        append_fenced(n.of[0], n.spaced, out);
    } else if (n.kind == Kind::scripts && n.of[0].kind == Kind::fence && n.of[0].text == "()") {
        append_fenced(n.of[0].of[0], n.spaced, out);
        Notation close{.kind = Kind::scripts, .of = {std::move(out.of.back()), n.of[1], n.of[2]}};
        out.of.back() = std::move(close);
    } else {
        // Within other fences, under roots, in indices.
        Notation whole = n;
        for (Notation& part : whole.of)
            if (part.kind == Kind::row && n.kind != Kind::fraction) part = in_line(part);
        out.of.push_back(std::move(whole));
    }
}

}  // namespace

Notation in_line(const Notation& row) {
    Notation all;
    for (const Notation& part : row.of) append_in_line(part, all);
    return all;
}

bool is_prose(const Notation& row) {
    return std::ranges::none_of(row.of, [](const Notation& n) {
        return n.kind == Kind::variable || n.kind == Kind::relation || n.kind == Kind::accent || n.kind == Kind::large ||
               (n.kind == Kind::fraction && n.text.empty()) || (!n.of.empty() && n.text.empty() && !is_prose(n)) ||
               (n.kind == Kind::fence && !is_prose(n.of[0]));
    });
}

}  // namespace pliant
