#include <pliant/mesh/body_grid.h>

namespace pliant {

BodyGrid::BodyGrid(const Vec<3>& size, const std::array<int, 3>& cells) : half_(size / 2), cells_(cells) {
    points_.resize(3, (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1));
    for (int k = 0; k <= cells[2]; ++k)
        for (int j = 0; j <= cells[1]; ++j)
            for (int i = 0; i <= cells[0]; ++i)
                points_.col(number({i, j, k})) =
                    Vec<3>(2.0 * i / cells[0] - 1, 2.0 * j / cells[1] - 1, 2.0 * k / cells[2] - 1).cwiseProduct(half_);
    for (int axis = 0; axis < 3; ++axis)
        for (const int end : {0, cells[static_cast<std::size_t>(axis)]}) add_side(axis, end);
}

Index BodyGrid::number(const std::array<int, 3>& at) const { return at[0] + (cells_[0] + 1) * (at[1] + (cells_[1] + 1) * at[2]); }

void BodyGrid::add_side(int axis, int end) {
    const auto n = static_cast<std::size_t>(axis), a = (n + 1) % 3, b = (n + 2) % 3;
    for (int j = 0; j < cells_[b]; ++j)
        for (int i = 0; i < cells_[a]; ++i) {
            const auto corner = [&](int di, int dj) {
                std::array<int, 3> at{};
                at[n] = end, at[a] = i + di, at[b] = j + dj;
                return number(at);
            };
            faces_.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
        }
}

}  // namespace pliant
