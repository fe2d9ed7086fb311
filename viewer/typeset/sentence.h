// Sentences laid out, with the formulas in them.
#pragma once
#include "typeset/math_box.h"

#include <string_view>

namespace pliant::viewer {

// Words with formulas among them (phrases.h), in lines no wider than `width` px unless a single word is; `width` ≤ 0: only the
// ends of lines in the text end a line. The first line's baseline is as far from the top, and lines are as far apart, as those of
// words alone: by `size`, or more where a formula needs it.
MathBox set_sentence(std::string_view text, const MathMetrics& metrics, float size, float width = 0);

}  // namespace pliant::viewer
