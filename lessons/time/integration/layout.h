// Where the parts of the picture stand: the portrait is the square from −1 to 1.
#pragma once
#include "integration.h"

namespace pliant::integration {

inline constexpr Real region_x = 2.35;  // the middle of the plane of λΔt
inline constexpr Index start_handle = 0, root_handle = 1;

struct InkOf {
    Ink ink;
    bool dashed;
};
InkOf ink_of(Scheme scheme);

}  // namespace pliant::integration
