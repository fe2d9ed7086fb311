// The words of claims, which lie beside the lesson as claims.md.
//
// The format is Markdown and reads well as it is. What stands before the first claim introduces the file itself. `## ID` begins a
// claim; the paragraph under it is its statement, and a list says the rest, where indented lines go on:
//   ## E3
//
//   Young's modulus is stress over strain in tension, a number of the material alone.
//
//   - source: which lecture, which slide
//   - experiment: what is done, in a sentence
//   - figure: what the number is
//   - unit: of the figure; left out where it has none
//   - criterion: ≤ 10⁻⁹
//   - expected: reproduced or qualified; the first where it is left out
//   - scene: KEY=VALUE ..., parameters of the lesson that show it
//   - question: asked before the experiment is made
//     - [ ] a wrong answer
//     - [x] the right one
#pragma once
#include <pliant/study/claims.h>

#include <string_view>
#include <vector>

namespace pliant {

// The claims of a lesson ("elasticity/moduli") without what measures them, in the order of the text. Throws Refused with the
// place, "elasticity/moduli/claims.md:12".
std::vector<Claim> read_claims(std::string_view text, std::string_view lesson);

}  // namespace pliant
