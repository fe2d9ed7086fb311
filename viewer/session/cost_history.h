// What each stage of a step cost, step by step: the latest steps of a run, for plots and for comparing runs.
#pragma once
#include <pliant/run/runner.h>

#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace pliant::viewer {

class CostHistory {
public:
    static constexpr std::size_t capacity = 600;  // steps

    // After a whole step, or a move back: what was recorded for later steps is forgotten.
    void record(const Runner& runner);
    // A step that ended at `at`, with the ms of each stage; NaN for one that did not run.
    void record(Index step, Real at, std::span<const Real> ms);
    void clear() { rows_.clear(); }
    bool empty() const { return rows_.empty(); }

    // Where each recorded step ended: s, or the number of the step where the lesson is static.
    std::vector<Real> places() const;
    // ms of a stage per step, each the median of the latest few.
    std::vector<Real> stage_ms(std::size_t stage) const;
    // ms of a whole step now, likewise; empty before the first.
    std::optional<Real> step_ms() const;

private:
    struct Row {
        Index step;
        Real at;
        std::vector<Real> ms;
    };
    void forget_from(Index step);
    std::deque<Row> rows_;
};

}  // namespace pliant::viewer
