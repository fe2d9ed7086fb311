// The drawn body: a box of regularly spaced material points about the origin, and the faces of its surface.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <vector>

namespace pliant {

class BodyGrid {
public:
    // size in m; cells along x, y, z, each at least 1. Points count fastest along x, then y, then z.
    BodyGrid(const Vec<3>& size, const std::array<int, 3>& cells);

    const Points<3>& points() const { return points_; }  // m
    const Vec<3>& half() const { return half_; }         // of the size, m
    // The four corners of each face of a cell on the surface, anticlockwise or clockwise, neighbours side by side.
    const std::vector<std::array<Index, 4>>& faces() const { return faces_; }

private:
    Index number(const std::array<int, 3>& at) const;
    void add_side(int axis, int end);

    Vec<3> half_;
    std::array<int, 3> cells_;
    Points<3> points_;
    std::vector<std::array<Index, 4>> faces_;
};

}  // namespace pliant
