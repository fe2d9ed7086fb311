// What the probes read, step by step: for plots and CSV files.
#pragma once
#include <pliant/run/runner.h>
#include <pliant/run/time_series.h>

#include <optional>
#include <string>
#include <vector>

namespace pliant {

// In bounded memory, however long the run goes on.
class Recorder {
public:
    // Reads every probe of the runner now. A step that was recorded before, and all after it, is replaced: call it after any move
    // forward or back.
    void record(const Runner& runner);
    void clear();
    // What is looked at is another thing now. Numbers that read otherwise than `before` are recorded anew from here on.
    using Readings = std::vector<std::optional<Real>>;  // a value and an exact value of each probe
    static Readings readings(const Runner& runner);
    void look_again(const Runner& runner, const Readings& before);

    // Over the time in s, or over the steps where the lesson is static.
    const TimeSeries& series(std::size_t probe) const { return series_[probe]; }
    bool empty() const { return !last_; }
    Index last_step() const { return last_.value_or(0); }
    // The part of its axis that is on the screen; all of it when not given.
    void watch(std::size_t probe, const std::optional<Interval>& part);

    // Memory that is held, and that may be held.
    std::size_t bytes() const;
    std::size_t cap() const;

    // As the file of a run, with the steps that are kept of any probe. A probe that does not keep a step leaves its cell empty.
    std::string csv(const Lesson& lesson) const;

private:
    std::vector<TimeSeries> series_;
    std::optional<Index> last_;
    bool is_static_ = false;
};

// The lines of a CSV file of a run, each with its end: "step,time [s],energy [J],energy exact [J]", and a row per step with what
// the probes read. Undefined values are empty cells.
std::string csv_header(const Lesson& lesson);
std::string csv_row(const Runner& runner);

}  // namespace pliant
