#include <pliant/math/constrained_system.h>
#include <pliant/math/error.h>

#include <fmt/format.h>

namespace pliant {

ConstrainedSystem::ConstrainedSystem(const SparseMatrix& full, const std::vector<char>& prescribed) {
    if (full.rows() != full.cols() || static_cast<std::size_t>(full.cols()) != prescribed.size())
        throw Refused(fmt::format("a {} × {} matrix does not fit {} unknowns", full.rows(), full.cols(), prescribed.size()));

    std::vector<int> number(prescribed.size(), -1);
    for (std::size_t i = 0; i < prescribed.size(); ++i)
        if (!prescribed[i]) {
            number[i] = static_cast<int>(free_.size());
            free_.push_back(static_cast<int>(i));
        }

    // Keep the entries whose row and column are both free.
    std::vector<int> rows, columns = {0};
    for (const int column : free_) {
        for (int i = full.outerIndexPtr()[column]; i < full.outerIndexPtr()[column + 1]; ++i) {
            const int row = number[static_cast<std::size_t>(full.innerIndexPtr()[i])];
            if (row < 0) continue;
            rows.push_back(row);
            source_.push_back(i);
        }
        columns.push_back(static_cast<int>(rows.size()));
    }
    matrix_.resize(size(), size());
    matrix_.resizeNonZeros(static_cast<Index>(rows.size()));
    std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
    std::copy(columns.begin(), columns.end(), matrix_.outerIndexPtr());
    update(full);
}

void ConstrainedSystem::update(const SparseMatrix& full) {
    Real* value = matrix_.valuePtr();
    for (const int i : source_) *value++ = full.valuePtr()[i];
}

void ConstrainedSystem::reduce(const VecX& full, VecX& reduced) const {
    reduced.resize(size());
    for (Index i = 0; i < size(); ++i) reduced[i] = full[free_[static_cast<std::size_t>(i)]];
}

void ConstrainedSystem::expand(const VecX& reduced, VecX& full) const {
    for (Index i = 0; i < size(); ++i) full[free_[static_cast<std::size_t>(i)]] = reduced[i];
}

}  // namespace pliant
