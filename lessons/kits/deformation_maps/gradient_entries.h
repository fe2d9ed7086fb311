// The nine entries of a deformation gradient as parameters F11 ... F33, row by row.
#pragma once
#include <pliant/lesson/lesson.h>

#include <deque>

namespace pliant {

class GradientEntries {
public:
    // They join the lesson now, with the entries of a map that does a little of everything. used: as for a parameter.
    void join(Lesson& owner, Interval useful, Interval accepted, std::string_view help, const std::function<bool()>& used) {
        static constexpr std::array<std::string_view, 9> keys{"F11", "F12", "F13", "F21", "F22", "F23", "F31", "F32", "F33"},
            symbols{"F₁₁", "F₁₂", "F₁₃", "F₂₁", "F₂₂", "F₂₃", "F₃₁", "F₃₂", "F₃₃"};
        static constexpr std::array<Real, 9> values{1.2, 0.3, 0, 0, 0.9, 0.1, 0.05, 0, 1.1};
        for (std::size_t k = 0; k < 9; ++k)
            entries_.emplace_back(owner, quantity(keys[k], symbols[k], "", values[k], useful, accepted, help).rebuilds(), used);
    }

    const Number& operator()(int i, int j) const { return entries_[static_cast<std::size_t>(3 * i + j)]; }
    Mat<3> matrix() const {
        return Mat<3>::NullaryExpr(
            [this](Index i, Index j) -> Real { return (*this)(static_cast<int>(i), static_cast<int>(j)); });
    }
    // Mended by F = I.
    Fix none() const {
        Fix fix{"F = I", {}};
        for (int k = 0; k < 9; ++k) fix.assign.emplace_back((*this)(k / 3, k % 3).info.key, k % 4 == 0 ? "1" : "0");
        return fix;
    }

private:
    std::deque<Number> entries_;
};

}  // namespace pliant
