#include "mesh/springs/spring_why.h"

#include <pliant/lesson/array.h>

#include <fmt/format.h>

namespace pliant::springs {

void append_ends(std::vector<Input>& inputs, Reading at, std::string_view field, std::string_view before, Index j, Index i) {
    for (int c = 0; c < 3; ++c) {
        const char* letter = axis_name(c);
        inputs.push_back(at(fmt::format("{}{}_j", before, letter), field, j, c));
        inputs.push_back(at(fmt::format("{}{}_i", before, letter), field, i, c));
    }
}

Input length_between(Reading at, Index j, Index i) {
    Explanation e{.formula = "|x_ij| = √((x_j − x_i)² + (y_j − y_i)² + (z_j − z_i)²)", .inputs = {}};
    append_ends(e.inputs, at, "position", "", j, i);
    return Input::part("|x_ij|", "m", std::move(e));
}

Input rest_length(const Springs& springs, Index s) {
    return Input::constant("l", springs.rest_length()[s], "m", "rest length of the spring");
}

}  // namespace pliant::springs
