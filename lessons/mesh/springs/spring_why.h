// What the explanations of spring nets share: the ends, the lengths and the springs of a node, of fields "position" and others
// with three components per node.
#pragma once
#include <pliant/lesson/explanation.h>
#include <pliant/solids/springs.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::springs {

using Reading = Input (*)(std::string symbol, std::string_view field, Index index, int component);  // Input::now, ...

// Appends the three coordinates of two nodes in turns: x_j, x_i, y_j, y_i, ... with `before` before each letter.
void append_ends(std::vector<Input>& inputs, Reading at, std::string_view field, std::string_view before, Index j, Index i);

// The vector from the second end to the first, of inputs in that order.
inline Vec<3> difference(std::span<const Real> ends) { return {ends[0] - ends[1], ends[2] - ends[3], ends[4] - ends[5]}; }

// |x_j − x_i|, from the positions.
Input length_between(Reading at, Index j, Index i);

Input rest_length(const Springs& springs, Index s);

inline Index other_end(const Springs& springs, Index s, Index node) { return springs.i(s) == node ? springs.j(s) : springs.i(s); }

}  // namespace pliant::springs
