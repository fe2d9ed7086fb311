// Runs earlier passes of a run again, to look at what they found, and brings the run back to the present, to the bit.
#pragma once
#include <pliant/math/watch.h>
#include <pliant/run/runner.h>

namespace pliant {

class Revisit {
public:
    // Throws Refused when the runner stands in a revisit already.
    explicit Revisit(Runner& runner);
    // Comes back, if come_back() was not called.
    ~Revisit();
    Revisit(const Revisit&) = delete;
    Revisit& operator=(const Revisit&) = delete;

    // To the start of a step, with the fields as the step before it left them and the parameters of that step; false when it
    // is no longer stored, or lies ahead.
    bool start_of(Index step);
    // One pass on; after the last pass of the step, into the next one's start.
    void pass();
    // What the stages of the present step have found so far.
    const StepTrace& trace() const { return trace_; }
    void come_back();
    Place here() const { return here_; }

private:
    const Uncancelled replay_{};
    Runner& runner_;
    const Place here_;
    StepTrace trace_;
    StepTrace* const outer_;
    std::vector<Real> parameters_;
    Runner::Writes pending_;
    std::optional<Failure> failure_;
    std::optional<Pull> pull_;
    std::vector<std::optional<LawStart>> law_starts_;
    Real base_time_, base_dt_;
    Index base_step_;
    long revision_;
    bool moved_ = false;
};

}  // namespace pliant
