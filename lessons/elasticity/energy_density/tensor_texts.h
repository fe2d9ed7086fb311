// Numbers of 3 × 3 matrices as they stand in formulas.
#pragma once
#include <pliant/lesson/explanation.h>

#include <string>

namespace pliant::energies {

// Nine numbers, row by row: "[1.2 0.3 0; 0 0.9 0.1; 0.05 0 1.1]".
std::string matrix_text(std::span<const Real> rows);
// "1.2² + 0.3² + 0.9²"
std::string squares_text(std::span<const Real> x);

}  // namespace pliant::energies
