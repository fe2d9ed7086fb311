// A formula laid out: letters and rules at their places. The origin is the left end of the first line's baseline, y points down.
#pragma once
#include <pliant/formula/notation.h>

#include <string_view>
#include <vector>

namespace pliant::viewer {

enum class MathFace {
    signs,  // the mathematical face, which has slanted letters at code points of their own
    words   // that of the lab
};

// How a letter extends from its place on the baseline, in px; y points down.
struct LetterBounds {
    float advance = 0, left = 0, top = 0, right = 0, bottom = 0;
};

// What the layout asks of the faces.
struct MathMetrics {
    virtual ~MathMetrics() = default;
    virtual LetterBounds bounds(char32_t letter, MathFace face, float size) const = 0;  // size: height of a line of type, px
};

struct PlacedLetter {
    char32_t letter = 0;
    MathFace face{};
    float size = 0, x = 0, y = 0;  // px; y of its baseline
    float stretch = 1;             // of its height, about `middle`
    float middle = 0;
};
struct PlacedRule {
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // corners, px
};

struct MathBox {
    float width = 0, above = 0, below = 0;  // the baseline of its first line is at 0
    std::vector<PlacedLetter> letters{};
    std::vector<PlacedRule> rules{};

    float height() const { return above + below; }
    void move(float dx, float dy);
    // Takes over what the other one has, at this place.
    void put(MathBox other, float dx, float dy);
};

enum class Fractions {
    stacked,
    in_line  // with a slash, where lines have to stay low
};

// The formula in type of this size, in lines of at most `width` where there are places to break it: between formulas, else at
// commas, before relations and signs, between words. What is still too wide is set once more with its fractions and parentheses
// in the line, where it breaks within them. `width` ≤ 0: one line.
MathBox set_formula(const Notation& formula, const MathMetrics& metrics, float size, float width = 0,
                    Fractions fractions = Fractions::stacked);

// The largest of the sizes from `largest` down to `smallest` (px) with which it fits into width × height, else the smallest.
MathBox fitted_formula(const Notation& formula, const MathMetrics& metrics, float largest, float smallest, float width,
                       float height);

}  // namespace pliant::viewer
