// How wrong a run is, and what that costs: the error of the lesson's error_probe() over time, against its closed form or a finer
// run of the same scene, and the points (cost, error) that earlier settings reached. It draws nothing.
#pragma once
#include <pliant/run/recorder.h>
#include <pliant/run/runner.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

// Errors are relative to the largest reference value so far; NaN where there is none at that time, and at the start, which is no
// step's doing.
struct ErrorSeries {
    std::vector<Real> at;  // s, or the number of the step where the lesson is static
    std::vector<Real> error;
    std::optional<Real> latest() const;  // the last that is a number
};

// What another run of the same scene found, in the order of time.
struct Reference {
    Real at = 0, value = 0;  // on the axis of the run
};
using References = std::vector<Reference>;

// |value − exact| / max|exact|.
ErrorSeries error_against_exact(const TimeSeries& run);
// |value − reference| / max|reference|, at times that both have to 1e-9 of the last one.
ErrorSeries error_against(const TimeSeries& run, const References& references);

class LiveError {
public:
    static constexpr std::size_t longest_trail = 6, most_references = 2 * TimeSeries::most;

    // Where the settings of a run led.
    struct Reached {
        std::vector<Real> settings;  // in the order of the parameters
        Real cost = 0;               // ms per simulated second; per step where the lesson is static
        Real error = 0;
    };

    // Notices what has changed: call in every frame, also while nothing of this is shown. `run` counts the runs of the session.
    void look_at(const LessonEntry& entry, const Runner& runner, int run);
    // Measures the run as it is now; step_ms is what a step of it costs.
    void measure(const Runner& runner, const Recorder& recorder, std::optional<Real> step_ms);
    // Brings the finer run to the time of this one, as far as it gets within a budget.
    void advance_reference(const Runner& runner, const Recorder& recorder, Real budget_ms);

    // Is the finer run behind this one?
    bool catching_up(const Runner& runner) const;

    // The probe that is measured; null when the lesson names none.
    const Probe* probe() const { return probe_; }
    std::size_t probe_number() const { return probe_number_; }  // where there is one
    const ErrorSeries& exact() const { return exact_; }
    const ErrorSeries& finer() const { return finer_; }
    // Settings of the finer run, as "time step 1 ms"; empty when there is none.
    const std::string& reference() const { return reference_text_; }
    // Why there is no finer run, in words; empty otherwise.
    const std::string& no_reference() const { return no_reference_; }
    // A slider or a hand has acted since the run began: its error belongs to no single setting.
    bool mixed() const { return mixed_; }
    const std::optional<Reached>& now() const { return now_; }
    // Of earlier settings, the oldest first.
    const std::vector<Reached>& trail() const { return trail_; }
    // Memory of what the finer run found: held, and that may be held.
    std::size_t bytes() const { return references_.capacity() * sizeof(Reference); }
    std::size_t cap() const { return reference_ ? most_references * sizeof(Reference) : 0; }

private:
    void begin(const Runner& runner);
    void make_reference(const Runner& runner);
    void record_reference(const TimeSeries& run);
    void thin_references(const TimeSeries& run);
    void drop_reference(std::string why);
    void keep_point();

    const LessonEntry* entry_ = nullptr;
    int run_ = -1;
    std::vector<Real> settings_;
    bool mixed_ = false, is_static_ = false;
    const Probe* probe_ = nullptr;
    std::size_t probe_number_ = 0;
    ErrorSeries exact_, finer_;
    std::optional<Reached> now_;
    std::vector<Reached> trail_;

    std::unique_ptr<Runner> reference_;
    std::string reference_text_, no_reference_;
    References references_;
};

}  // namespace pliant::viewer
