// How long to run.
#pragma once
#include <pliant/run/runner.h>

#include <functional>
#include <optional>

namespace pliant {

struct Until {
    enum class What { steps, time, rest } what = What::steps;
    Index steps = 0;
    Real time = 0;  // s

    static Until after_steps(Index count) { return {What::steps, count, 0}; }
    static Until after_time(Real seconds) { return {What::time, 0, seconds}; }
    static Until at_rest() { return {What::rest, 0, 0}; }
};

// Runs whole steps; calls after_step, where given, behind each of them. A time that is not a multiple of the time step is rounded
// to the nearest one: steps are never shortened. A static lesson has no clock: any time runs it to rest. Throws Refused for a
// negative count, a time that is negative or not finite, or a scene that never comes to rest; Diverged as the runner does, and
// when rest is not reached in max_steps_to_rest.
void advance(Runner& runner, const Until& until, const std::function<void()>& after_step = {});

inline constexpr Index max_steps_to_rest = 200000;

}  // namespace pliant
