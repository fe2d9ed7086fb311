// The rhythm of an oscillation that is watched step by step: when it last rose through 0.
#pragma once
#include <pliant/math/types.h>

#include <optional>

namespace pliant {

class Rhythm {
public:
    void reset() { memory_.setZero(); }

    // The value at a time, s. Swings of less than `least` to below 0 are not counted; with a `least` of 0, what does not swing
    // at all but for rounding, none are.
    void note(Real time, Real value, Real least);

    // The mean over the latest periods, at most `most_periods`, s; empty before the first is complete.
    std::optional<Real> period() const;

    // All that lives from one step to the next.
    VecX& memory() { return memory_; }

    static constexpr Index most_periods = 4;

private:
    enum Slot : Index { latest_time, latest_value, armed, count, first_crossing };

    VecX memory_ = VecX::Zero(first_crossing + most_periods + 1);
};

}  // namespace pliant
