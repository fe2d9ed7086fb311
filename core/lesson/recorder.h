// What the probes read, step by step: for plots and CSV files.
#pragma once
#include <pliant/lesson/runner.h>

#include <string>
#include <vector>

namespace pliant {

struct Series {
    std::vector<Real> value;  // NaN where the probe is undefined: a gap, never written out
    std::vector<Real> exact;  // empty when the probe has no closed form
};

class Recorder {
public:
    // Reads every probe of the runner now. A step that was recorded before, and all after it, is replaced: call it after any move
    // forward or back.
    void record(const Runner& runner);
    void clear();

    const std::vector<Index>& steps() const { return steps_; }
    const std::vector<Real>& times() const { return times_; }
    const Series& series(std::size_t probe) const { return series_[probe]; }
    bool empty() const { return steps_.empty(); }

    // "step,time [s],energy [J],energy exact [J]" and a row per step; undefined values are empty cells.
    std::string csv(const Lesson& lesson) const;

private:
    std::vector<Index> steps_;
    std::vector<Real> times_;
    std::vector<Series> series_;
};

}  // namespace pliant
