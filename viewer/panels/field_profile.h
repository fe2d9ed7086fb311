// A field along a line through the body, and over a grid, read from the marks of the picture: so it works for every lesson.
#pragma once
#include <pliant/lesson/lesson.h>

#include <array>
#include <span>
#include <vector>

namespace pliant::viewer {

struct FieldProfile {
    std::vector<Real> position, value;  // sorted by position, m
};

// The rows of a field whose marks lie nearest to the line along `axis` (0 to 2) that passes the framed box at the fractions
// `across` (0 to 1) of the other axes, in their order. rows: one number per thing that the field is on.
FieldProfile field_profile(const Lesson& lesson, const Scene& scene, On on, std::span<const Real> rows, int axis,
                           std::array<Real, 2> across);

}  // namespace pliant::viewer
