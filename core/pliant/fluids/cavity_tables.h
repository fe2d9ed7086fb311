// The velocity on the centre lines of the lid-driven cavity at Re = 100, in units of the lid's speed and the cavity's width
// [Ghia1982, Tables I and II].
#pragma once
#include <pliant/math/types.h>

#include <array>

namespace pliant::cavity {

struct TableRow {
    Real position, velocity;
};

// u(x = 1/2, y)
inline constexpr std::array<TableRow, 12> u_on_vertical_line{{{0, 0},
                                                              {0.0547, -0.03717},
                                                              {0.1016, -0.06434},
                                                              {0.1719, -0.10150},
                                                              {0.2813, -0.15662},
                                                              {0.4531, -0.21090},
                                                              {0.5, -0.20581},
                                                              {0.6172, -0.13641},
                                                              {0.7344, 0.00332},
                                                              {0.8516, 0.23151},
                                                              {0.9531, 0.68717},
                                                              {1, 1}}};

// v(x, y = 1/2)
inline constexpr std::array<TableRow, 10> v_on_horizontal_line{{{0, 0},
                                                                {0.0625, 0.09233},
                                                                {0.1563, 0.16077},
                                                                {0.2344, 0.17527},
                                                                {0.5, 0.05454},
                                                                {0.8047, -0.24533},
                                                                {0.8594, -0.22445},
                                                                {0.9063, -0.16914},
                                                                {0.9453, -0.10313},
                                                                {1, 0}}};

}  // namespace pliant::cavity
