// Entries of 3 × 3 matrices as inputs of explanations.
#pragma once
#include <pliant/lesson/explanation.h>

#include <string>
#include <string_view>
#include <vector>

namespace pliant::energies {

// "F₁₂" of row 0 and column 1.
std::string entry_name(std::string_view matrix, int row, int column);
// That entry of a tensor field, now.
Input entry(std::string_view matrix, std::string_view field, int row, int column);
// All nine, row by row.
std::vector<Input> all_entries(std::string_view matrix, std::string_view field);

// The first nine numbers as a matrix, row by row; and as text: "[1.2 0.3 0; 0 0.9 0.1; 0.05 0 1.1]".
Mat<3> matrix_of(std::span<const Real> rows);
std::string matrix_text(std::span<const Real> rows);
// "1.2² + 0.3² + 0.9²"
std::string squares_text(std::span<const Real> x);

// A value that follows from nothing but the words of its formula.
Explanation fixed_value(std::string formula, Real value);

}  // namespace pliant::energies
