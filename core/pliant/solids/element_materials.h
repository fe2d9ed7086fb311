// The materials of the elements of a body, one each.
#pragma once
#include <pliant/continuum/moduli.h>

#include <vector>

namespace pliant {

// Throws Refused, naming the element, unless there is one material for each element and every one of them is stable in Dim
// dimensions: mu > 0 and Dim lambda + 2 mu > 0, all finite [Pa].
template <int Dim>
void check_materials(const std::vector<Lame>& materials, Index elements);

}  // namespace pliant
