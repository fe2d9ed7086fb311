// Which parts of a sentence are formulas.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pliant::viewer {

struct Phrase {
    std::string text;
    bool formula = false;
};

// In their order; one behind the other they are the sentence, blanks and punctuation in those that are words. A formula is what
// stands between two $ (which go), and else a symbol with all that signs and relations tie to it: "the cube of edge", "L",
// " grows by", "ΔL/L = 0.5". A symbol is a Greek letter, a Latin one that stands alone, or what has an index, an exponent or a
// mathematical sign; words, numbers and units are none, and neither is a letter that is a word or the name of a run unless a sign
// stands beside it: a, A, B, I.
std::vector<Phrase> phrases_of(std::string_view sentence);

}  // namespace pliant::viewer
