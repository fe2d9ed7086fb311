#include "typeset/math_letters.h"

namespace pliant::viewer {
namespace {

struct FirstLetters {
    char32_t capital, small, greek_capital, greek_small, partial;
};
constexpr FirstLetters slanted{0x1d434, 0x1d44e, 0x1d6e2, 0x1d6fc, 0x1d715}, bold{0x1d400, 0x1d41a, 0x1d6a8, 0x1d6c2, 0x1d6db};

}  // namespace

char32_t shaped(char32_t letter, LetterShape shape) {
    if (shape == LetterShape::upright) return letter;
    const FirstLetters& first = shape == LetterShape::slanted ? slanted : bold;
    // Its code point is that of Planck's constant.
    if (letter == 'h' && shape == LetterShape::slanted) return 0x210e;
    if (letter >= 'A' && letter <= 'Z') return first.capital + (letter - 'A');
    if (letter >= 'a' && letter <= 'z') return first.small + (letter - 'a');
    if (letter == U'ϕ') letter = U'φ';
    // Capital Greek stands upright.
    if (letter >= U'Α' && letter <= U'Ω' && shape == LetterShape::bold) return first.greek_capital + (letter - U'Α');
    if (letter >= U'α' && letter <= U'ω') return first.greek_small + (letter - U'α');
    if (letter == U'∂' && shape == LetterShape::bold) return first.partial;
    return letter;
}

}  // namespace pliant::viewer
