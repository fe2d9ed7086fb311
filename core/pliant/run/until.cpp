#include <pliant/run/until.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant {
namespace {

void one_step(Runner& runner, const std::function<void()>& after_step) {
    runner.step();
    if (after_step) after_step();
}

void run_to_rest(Runner& runner, const std::function<void()>& after_step) {
    if (const std::string why = runner.lesson().unrest(); !why.empty())
        throw Refused(fmt::format("this scene never comes to rest: {}. Give --steps or --time", why));
    for (Index i = 0; !runner.lesson().at_rest(); ++i) {
        if (i == max_steps_to_rest)
            throw Diverged({.stage = {},
                            .field = {},
                            .index = -1,
                            .step = runner.place().step,
                            .time = runner.time(),
                            .what = fmt::format("no rest within {} steps", i),
                            .limit = "Give --steps or --time, or let something take the energy out (damping, viscosity)"});
        one_step(runner, after_step);
    }
}

// The time step may change on the way (an event), so the clock is asked again after every step.
void run_for_time(Runner& runner, Real end, const std::function<void()>& after_step) {
    while (runner.time() + runner.time_step() / 2 <= end) one_step(runner, after_step);
}

}  // namespace

void advance(Runner& runner, const Until& until, const std::function<void()>& after_step) {
    switch (until.what) {
        case Until::What::steps:
            if (until.steps < 0) throw Refused("steps", static_cast<Real>(until.steps), "", "a whole number from 0 on");
            for (Index i = 0; i < until.steps; ++i) one_step(runner, after_step);
            break;
        case Until::What::time:
            if (!std::isfinite(until.time) || until.time < 0) throw Refused("time", until.time, "s", "a finite time from 0 s on");
            if (runner.is_static())
                run_to_rest(runner, after_step);
            else
                run_for_time(runner, runner.time() + until.time, after_step);
            break;
        case Until::What::rest:
            run_to_rest(runner, after_step);
            break;
    }
}

}  // namespace pliant
