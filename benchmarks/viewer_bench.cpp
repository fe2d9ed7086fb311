// What a frame of the lab costs, at rest and with the step of the lesson it shows, and whether it keeps 60 frames a second; what
// opening it costs; what the runner adds to a step; how fast a state is stored.
#include <benchmark/benchmark.h>
#include <pliant/run/history.h>
#include <pliant/run/runner.h>

#include "app/lab.h"
#include "app/redraw.h"
#include "late.h"

#include <algorithm>
#include <chrono>
#include <string>

using namespace pliant;
using namespace pliant::viewer;

namespace {

void frame(benchmark::State& state, const char* lesson, bool stepping) {
    const auto context = open_headless({1280, 720});
    Lab lab(*context, lesson);
    for (int i = 0; i < 3; ++i) lab.frame(0), context->present();
    for (auto _ : state) {
        if (stepping) lab.session().runner().is_static() ? lab.session().step_pass() : lab.session().step();
        lab.frame(0);
        context->present();
    }
}

// A lab that plays as in its window, which wants 60 frames a second: how many come too late.
void playing(benchmark::State& state, const char* lesson) {
    using Clock = std::chrono::steady_clock;
    const auto context = open_headless({1280, 720});
    Lab lab(*context, lesson);
    for (int i = 0; i < 3; ++i) lab.frame(0), context->present();
    lab.work_beside({});
    Session& s = lab.session();
    long frames = 0, late = 0;
    Real longest = 0;
    const Index first = s.runner().place().step;
    for (auto _ : state) {
        const auto start = Clock::now();
        if (!lab.busy()) s.playing = true;
        if (lab.frame(Redraw::frame_seconds)) context->present();
        const Real seconds = std::chrono::duration<Real>(Clock::now() - start).count();
        longest = std::max(longest, seconds);
        ++frames, late += seconds > Redraw::frame_seconds;
    }
    lab.call_off();
    state.counters["late %"] = 100 * static_cast<Real>(late) / static_cast<Real>(frames);
    state.counters["longest ms"] = 1000 * longest;
    state.counters["steps/frame"] = static_cast<Real>(s.runner().place().step - first) / static_cast<Real>(frames);
}

const LateBenchmarks every_lesson([] {
    for (const LessonEntry& entry : lessons()) {
        const std::string id(entry.info.id);
        const char* const name = entry.info.id.data();
        const auto add = [&](const std::string& title, auto run) {
            benchmark::RegisterBenchmark((title + "/" + id).c_str(), run)->Unit(benchmark::kMillisecond)->UseRealTime();
        };
        add("frame/at_rest", [name](benchmark::State& state) { frame(state, name, false); });
        add("frame/stepping", [name](benchmark::State& state) { frame(state, name, true); });
        add("frame/playing", [name](benchmark::State& state) { playing(state, name); });
    }
});

// From nothing to the first frame on the screen.
void first_frame(benchmark::State& state) {
    for (auto _ : state) {
        const auto context = open_headless({1280, 720});
        Lab lab(*context);
        lab.frame(0);
        context->present();
    }
}
BENCHMARK(first_frame)->Unit(benchmark::kMillisecond)->UseRealTime();

// A step through the runner against the stages called bare: what stopping, timing, guarding and storing cost.
void step_by_runner(benchmark::State& state, const char* lesson) {
    Runner runner(find_lesson(lesson));
    for (auto _ : state) runner.step();
}
BENCHMARK_CAPTURE(step_by_runner, mass_spring, "mesh/mass_spring")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step_by_runner, navier_stokes, "fluids/navier_stokes")->Unit(benchmark::kMicrosecond);

void store_state(benchmark::State& state) {
    Runner runner(find_lesson("fluids/navier_stokes"), {{"resolution", "256"}});
    std::vector<Real> buffer;
    for (auto _ : state) {
        save_state(runner.lesson(), buffer);
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(buffer.size() * sizeof(Real)));
}
BENCHMARK(store_state);

}  // namespace
