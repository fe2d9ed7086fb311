// Explanations of numbers that are made from the entries of a 3 × 3 tensor, which a field holds row by row.
#pragma once
#include <pliant/lesson/explanation.h>

namespace pliant::why {

// "F_12" of the row and column counted from 0.
std::string entry(std::string_view name, int i, int j);
// That entry of the field as it is now.
Input entry_now(std::string_view name, std::string_view field, Index row, int i, int j);
// All nine, row by row, and the matrix that their values make.
std::vector<Input> all_entries(std::string_view name, std::string_view field, Index row);
Mat<3> matrix(std::span<const Real> x);

// The same as one family, "F", that a named function takes.
std::vector<Input> whole(std::string_view name, std::string_view field, Index row);

// The determinant of F, along its first row.
Explanation determinant(std::string_view field, Index row, std::string_view left = "det F");
Explanation determinant(std::string_view left, std::vector<Input> entries);
// E_ij = ½ (H_ij + H_ji + Σ H_ki H_kj) of the displacement gradient H.
Explanation green(std::string_view field, Index row, int i, int j);
// S_ij = Σ A_ki B_kj, an entry of A^T B.
Explanation transposed_product(std::string_view name, std::string_view A, std::string_view field_A, std::string_view B,
                               std::string_view field_B, Index row, int i, int j);
// A number that is found from all entries by a named function: "λ₁ = sv₁(F), the largest singular value".
Explanation of_matrix(std::string_view left, const std::string& function, std::string_view meaning, std::string_view name,
                      std::string_view field, Index row, std::function<Real(const Mat<3>&)> value, const std::string& unit = "");
// What is in degrees, in radians: a part with this symbol.
Input in_radians(std::string symbol, const Parameter& degrees);

}  // namespace pliant::why
