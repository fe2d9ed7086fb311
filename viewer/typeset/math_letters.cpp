#include "typeset/math_letters.h"

namespace pliant::viewer {

char32_t slanted(char32_t letter) {
    constexpr char32_t capital = 0x1d434, small = 0x1d44e, greek_small = 0x1d6fc;
    // Its code point is that of Planck's constant.
    if (letter == 'h') return 0x210e;
    if (letter >= 'A' && letter <= 'Z') return capital + (letter - 'A');
    if (letter >= 'a' && letter <= 'z') return small + (letter - 'a');
    if (letter == U'ϕ') letter = U'φ';
    if (letter >= U'α' && letter <= U'ω') return greek_small + (letter - U'α');
    return letter;
}

}  // namespace pliant::viewer
