#include "named_entries.h"

#include <pliant/lesson/format.h>

#include <fmt/format.h>

#include <array>

namespace pliant::energies {

std::string entry_name(std::string_view matrix, int row, int column) {
    constexpr std::array<std::string_view, 3> below{"₁", "₂", "₃"};
    return fmt::format("{}{}{}", matrix, below[static_cast<std::size_t>(row)], below[static_cast<std::size_t>(column)]);
}

Input entry(std::string_view matrix, std::string_view field, int row, int column) {
    return Input::now(entry_name(matrix, row, column), field, 0, 3 * row + column);
}

std::vector<Input> all_entries(std::string_view matrix, std::string_view field) {
    std::vector<Input> inputs;
    for (int k = 0; k < 9; ++k) inputs.push_back(entry(matrix, field, k / 3, k % 3));
    return inputs;
}

Mat<3> matrix_of(std::span<const Real> rows) { return Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>(rows.data()); }

std::string matrix_text(std::span<const Real> rows) {
    std::string text = "[";
    for (std::size_t k = 0; k < 9; ++k)
        text += fmt::format("{}{}", format_quantity(rows[k], "", 4), k == 8 ? "]" : k % 3 == 2 ? "; " : " ");
    return text;
}

std::string squares_text(std::span<const Real> x) {
    std::string text;
    for (const Real value : x)
        if (value != 0) text += fmt::format("{}{}²", text.empty() ? "" : " + ", as_factor(value, true));
    return text.empty() ? "0" : text;
}

Explanation fixed_value(std::string formula, Real value) {
    return {.formula = std::move(formula), .inputs = {}, .evaluate = [value](std::span<const Real>) { return value; }};
}

}  // namespace pliant::energies
