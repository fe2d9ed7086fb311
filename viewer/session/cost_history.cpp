#include "session/cost_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::viewer {
namespace {

constexpr std::size_t smoothed_over = 9;  // steps

// NaN when there is no finite number.
Real median(std::vector<Real> numbers) {
    std::erase_if(numbers, [](Real x) { return !std::isfinite(x); });
    if (numbers.empty()) return std::numeric_limits<Real>::quiet_NaN();
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::ranges::nth_element(numbers, middle);
    return *middle;
}

}  // namespace

void CostHistory::forget_from(Index step) {
    while (!rows_.empty() && rows_.back().step >= step) rows_.pop_back();
}

void CostHistory::record(const Runner& runner) {
    const Index step = runner.place().step;
    if (step == 0) return clear();
    if (!rows_.empty() && rows_.back().step >= step) return forget_from(step + 1);
    std::vector<Real> ms;
    for (const Stage& stage : runner.lesson().stages)
        ms.push_back(runner.cost(stage).runs && stage.in_use() ? runner.cost(stage).last_ms
                                                               : std::numeric_limits<Real>::quiet_NaN());
    record(step, runner.is_static() ? static_cast<Real>(step) : runner.time(), ms);
}

void CostHistory::record(Index step, Real at, std::span<const Real> ms) {
    forget_from(step);
    rows_.push_back({step, at, {ms.begin(), ms.end()}});
    if (rows_.size() > capacity) rows_.pop_front();
}

std::vector<Real> CostHistory::places() const {
    std::vector<Real> places;
    for (const Row& row : rows_) places.push_back(row.at);
    return places;
}

std::vector<Real> CostHistory::stage_ms(std::size_t stage) const {
    std::vector<Real> smooth, window;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        window.clear();
        for (std::size_t k = i + 1 > smoothed_over ? i + 1 - smoothed_over : 0; k <= i; ++k)
            if (stage < rows_[k].ms.size()) window.push_back(rows_[k].ms[stage]);
        smooth.push_back(median(window));
    }
    return smooth;
}

std::optional<Real> CostHistory::step_ms() const {
    std::vector<Real> sums;
    for (auto row = rows_.rbegin(); row != rows_.rend() && sums.size() < smoothed_over; ++row) {
        sums.push_back(0);
        for (const Real ms : row->ms)
            if (std::isfinite(ms)) sums.back() += ms;
    }
    return sums.empty() ? std::nullopt : std::optional(median(sums));
}

}  // namespace pliant::viewer
