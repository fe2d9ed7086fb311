// Formulas laid out, with letters that are all of one size.
#include "typeset/math_box.h"

#include "typeset/math_letters.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <string>

using namespace pliant;
using namespace pliant::viewer;

namespace {

// As wide as half the type, as high as 0.7 of it, with a tail of 0.1.
struct EvenLetters final : MathMetrics {
    LetterBounds bounds(char32_t, MathFace, float size) const override {
        return {0.5f * size, 0.05f * size, -0.7f * size, 0.45f * size, 0.1f * size};
    }
};
const EvenLetters even;

MathBox set(std::string_view text, float width = 0, Fractions fractions = Fractions::stacked) {
    return set_formula(notation(text), even, 20, width, fractions);
}

const PlacedLetter& letter(const MathBox& box, char32_t c) {
    const auto found =
        std::ranges::find_if(box.letters, [&](const PlacedLetter& l) { return l.letter == c || l.letter == slanted(c); });
    REQUIRE(found != box.letters.end());
    return *found;
}

// All letters and rules lie in the box that is told.
void check_bounds(const MathBox& box) {
    for (const PlacedLetter& l : box.letters) {
        const float half = 0.4f * l.size * l.stretch, middle = l.stretch > 1 ? l.middle : l.y - 0.3f * l.size;
        CHECK(l.x >= -0.01f);
        CHECK(l.x + 0.45f * l.size <= box.width + 0.01f);
        CHECK(middle - half >= -box.above - 0.01f);
        CHECK(middle + half <= box.below + 0.01f);
    }
    for (const PlacedRule& r : box.rules) {
        CHECK(r.x0 >= -1.01f);
        CHECK(r.y0 >= -box.above - 0.6f);
        CHECK(r.y1 <= box.below + 0.6f);
    }
}

}  // namespace

TEST_CASE("typeset: what stands over what") {
    const MathBox box = set("a / b + x_i² + √c");
    CHECK(letter(box, 'a').y < letter(box, 'b').y);
    REQUIRE(box.rules.size() == 2);
    CHECK(letter(box, 'a').y < box.rules[0].y0);
    CHECK(box.rules[0].y1 < letter(box, 'b').y - 0.6f * letter(box, 'b').size);
    CHECK(letter(box, 'i').y > letter(box, 'x').y);
    CHECK(letter(box, 'i').size < letter(box, 'x').size);
    CHECK(letter(box, '2').y < letter(box, 'x').y);
    CHECK(box.rules[1].y0 < letter(box, 'c').y - 0.7f * letter(box, 'c').size);
    check_bounds(box);
}

TEST_CASE("typeset: indices of a sum stand under it, a matrix in rows and columns") {
    const MathBox sum = set("Σ_b K");
    CHECK(letter(sum, 'b').y > letter(sum, U'Σ').y);
    check_bounds(sum);
    const MathBox matrix = set("[a b; c d]");
    CHECK(letter(matrix, 'a').y == letter(matrix, 'b').y);
    CHECK(letter(matrix, 'c').y > letter(matrix, 'a').y);
    CHECK(letter(matrix, 'a').x == letter(matrix, 'c').x);
    CHECK(letter(matrix, 'b').x > letter(matrix, 'a').x);
    check_bounds(matrix);
}

TEST_CASE("typeset: indices of max, min and mean stand under them as those of a sum do") {
    for (const char* text : {"y = max_k x", "y = min_k x", "y = mean_k x", "y = Σ_k x"}) {
        const MathBox box = set(text);
        CAPTURE(text);
        const PlacedLetter &k = letter(box, 'k'), &x = letter(box, 'x');
        CHECK(k.y > x.y + 0.5f * x.size);
        CHECK(k.x < x.x);
        CHECK(k.size < x.size);
        check_bounds(box);
    }
}

TEST_CASE("typeset: a number and its unit stand above and below a line together") {
    const MathBox box = set_formula(notation("3 kg / (2 s)", Numbers::with_units), even, 20, 0);
    REQUIRE(box.rules.size() == 1);
    for (const char32_t above : U"3kg")
        if (above != 0) CHECK(letter(box, above).y < box.rules[0].y0);
    for (const char32_t below : U"2s")
        if (below != 0) CHECK(letter(box, below).y > box.rules[0].y1);
    check_bounds(box);
}

TEST_CASE("typeset: parentheses are as high as what they hold") {
    const MathBox box = set("(a / b)");
    CHECK(letter(box, '(').stretch > 1.5f);
    CHECK(set("(a)").letters[0].stretch < 1.3f);
}

TEST_CASE("typeset: a formula is no wider than its room where it can be broken") {
    const std::string text = GENERATE("p = (a + b + c + d − e (f − g) / h) / 4", "explicit: x′ = x + Δt v,  v′ = v + Δt f/m",
                                      "y = |a + b| + √(c + d) + [a b; c d] + e^f");
    const float width = GENERATE(400.f, 200.f, 120.f);
    INFO(text << " in " << width);
    const MathBox wide = set(text), box = set(text, width);
    CHECK(box.width <= width);
    CHECK(box.height() >= wide.height() * (wide.width > width ? 0.6f : 1.f));
    check_bounds(box);
}

TEST_CASE("typeset: formulas side by side are parted before one of them is broken") {
    const MathBox box = set("a = b + c,  d = e + f", 150);
    CHECK(letter(box, 'c').y == letter(box, 'a').y);
    CHECK(letter(box, 'd').y > letter(box, 'a').y);
    CHECK(letter(box, 'f').y == letter(box, 'd').y);
    CHECK(letter(box, 'd').x == letter(box, 'a').x);
}

TEST_CASE("typeset: in a line fractions get the parentheses that they need") {
    const auto letters = [](std::string_view text) {
        std::string all;
        for (const PlacedLetter& l : set(text, 0, Fractions::in_line).letters) {
            if (l.letter < 128) all += static_cast<char>(l.letter);
            for (const char c : {'a', 'b', 'c', 'd'})
                if (l.letter == slanted(static_cast<char32_t>(c))) all += c;
        }
        return all;
    };
    CHECK(letters("a / b") == "a/b");
    CHECK(letters("a b / (c d)") == "ab/(cd)");
    CHECK(letters("(a + b) / c") == "(a+b)/c");
    CHECK(letters("(a + b) c / 2") == "(a+b)c/2");
}

TEST_CASE("typeset: the type is the largest that fits") {
    const Notation text = notation("x = a + b + c + d + e");
    const MathBox large = fitted_formula(text, even, 40, 10, 1000, 100), small = fitted_formula(text, even, 40, 10, 100, 20);
    CHECK(large.letters[0].size == 40);
    CHECK(small.letters[0].size < 20);
    CHECK(fitted_formula(text, even, 40, 10, 1, 1).letters[0].size == 10);
}

TEST_CASE("typeset: angle brackets are as high as what they hold") {
    const MathBox box = set("⟨a / b⟩");
    CHECK(letter(box, U'⟨').stretch > 1.5f);
    CHECK(letter(box, U'⟩').stretch > 1.5f);
    check_bounds(box);
}

TEST_CASE("typeset: any text can be set in any room") {
    const std::string text = GENERATE("", " ", ")", "((", "|", "a |", "/", "a /", "_", "x_", "√", "Σ", "[a; b c]", "\xff\xfe",
                                      "½½", "one word after the other and so on");
    const float width = GENERATE(0.f, 1.f, 50.f);
    INFO(text);
    const MathBox box = set(text, width);
    CHECK(box.width >= 0);
    CHECK(box.height() >= 0);
}
