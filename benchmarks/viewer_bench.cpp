// What a frame of the lab costs, without and with the step of the lesson it shows; what opening it costs; what the runner adds to
// a step; how fast a state is stored.
#include <benchmark/benchmark.h>
#include <pliant/lesson/history.h>
#include <pliant/lesson/runner.h>

#include "app/lab.h"

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
BENCHMARK_CAPTURE(frame, moduli_paused, "elasticity/moduli", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, mass_spring_paused, "mesh/mass_spring", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, navier_stokes_paused, "fluids/navier_stokes", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, mass_spring_stepping, "mesh/mass_spring", true)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, navier_stokes_stepping, "fluids/navier_stokes", true)->Unit(benchmark::kMillisecond)->UseRealTime();

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
