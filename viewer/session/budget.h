// How much may be run before the next frame: in a window milliseconds; in tests passes, which are the same on every machine.
#pragma once
#include <pliant/math/types.h>

#include <chrono>
#include <limits>

namespace pliant::viewer {

struct Budget {
    // No step is begun that would not end within `milliseconds`, by the last one's cost; one that is under way is cut a little
    // later.
    Budget(Real milliseconds = 12) : ms(milliseconds) {}
    static Budget of_passes(Index count) {
        Budget b = unlimited();
        b.passes = count;
        return b;
    }
    static Budget unlimited() { return {std::numeric_limits<Real>::infinity()}; }

    Real ms;
    Index passes = std::numeric_limits<Index>::max();
};

// What is left of a budget, from when it is made.
class Spending {
public:
    explicit Spending(const Budget& budget) : budget_(budget) {}
    void pass() { ++passes_; }
    // The first step is begun whatever it costs.
    bool may_begin_step(Real ms) const { return passes_ == 0 || since_start_ms() + ms <= budget_.ms; }
    bool spent() const { return passes_ >= budget_.passes || since_start_ms() >= over * budget_.ms; }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr Real over = 1.4;
    Real since_start_ms() const { return std::chrono::duration<Real, std::milli>(Clock::now() - start_).count(); }

    Budget budget_;
    Index passes_ = 0;
    Clock::time_point start_ = Clock::now();
};

}  // namespace pliant::viewer
