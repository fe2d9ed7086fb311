#include "tensor_why.h"

#include <fmt/format.h>
#include <Eigen/LU>

namespace pliant::why {
std::string entry(std::string_view name, int i, int j) { return fmt::format("{}_{}{}", name, i + 1, j + 1); }

Input entry_now(std::string_view name, std::string_view field, Index row, int i, int j) {
    return Input::now(entry(name, i, j), field, row, 3 * i + j);
}

std::vector<Input> all_entries(std::string_view name, std::string_view field, Index row) {
    std::vector<Input> inputs;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inputs.push_back(entry_now(name, field, row, i, j));
    return inputs;
}

Mat<3> matrix(std::span<const Real> x) { return Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>(x.data()); }

Explanation determinant(std::string_view field, Index row, std::string_view left) {
    return determinant(left, all_entries("F", field, row));
}

Explanation determinant(std::string_view left, std::vector<Input> entries) {
    return {fmt::format("{} = F_11 (F_22 F_33 − F_23 F_32) − F_12 (F_21 F_33 − F_23 F_31) + F_13 (F_21 F_32 − F_22 F_31)", left),
            std::move(entries)};
}

Explanation green(std::string_view field, Index row, int i, int j) {
    const auto H = [&](int r, int c) { return entry_now("H", field, row, r, c); };
    if (i == j)
        return {fmt::format("E_{0}{0} = H_{0}{0} + ½ (H_1{0}² + H_2{0}² + H_3{0}²)   (H = ∇u)", i + 1),
                {H(0, i), H(1, i), H(2, i)}};
    return {fmt::format("E_{0}{1} = ½ (H_{0}{1} + H_{1}{0} + H_1{0} H_1{1} + H_2{0} H_2{1} + H_3{0} H_3{1})   (H = ∇u)", i + 1,
                        j + 1),
            {H(0, i), H(1, i), H(2, i), H(0, j), H(1, j), H(2, j)}};
}

Explanation transposed_product(std::string_view name, std::string_view A, std::string_view field_A, std::string_view B,
                               std::string_view field_B, Index row, int i, int j) {
    std::vector<Input> inputs;
    std::string right;
    for (int k = 0; k < 3; ++k) {
        inputs.push_back(entry_now(A, field_A, row, k, i));
        if (A != B || i != j) inputs.push_back(entry_now(B, field_B, row, k, j));
        right += A == B && i == j ? fmt::format("{}{}²", k ? " + " : "", entry(A, k, i))
                                  : fmt::format("{}{} {}", k ? " + " : "", entry(A, k, i), entry(B, k, j));
    }
    return {fmt::format("{} = {}", entry(name, i, j), right), std::move(inputs)};
}

std::vector<Input> whole(std::string_view name, std::string_view field, Index row) {
    return family_of(std::string(name), all_entries(name, field, row));
}

Explanation of_matrix(std::string_view left, const std::string& function, std::string_view meaning, std::string_view name,
                      std::string_view field, Index row, std::function<Real(const Mat<3>&)> value, const std::string& unit) {
    return Explanation{fmt::format("{} = {}({}), {}", left, function, name, meaning), whole(name, field, row)}.by(
        function, unit, [value = std::move(value)](Values x) { return value(matrix(x)); });
}

Input in_radians(std::string symbol, const Parameter& degrees) {
    const std::string given = fmt::format("{}°", degrees.info.symbol);
    Explanation why{fmt::format("{} = {} π / 180°", symbol, given), {Input::of(degrees, given)}};
    return Input::part(std::move(symbol), degrees.info.unit == "°/m" ? "rad/m" : "rad", std::move(why));
}

}  // namespace pliant::why
