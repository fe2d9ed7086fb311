// What looking inside costs: a step with nobody looking, with the stages traced, and a question.
#include <benchmark/benchmark.h>
#include <pliant/run/breakpoints.h>
#include <pliant/run/why.h>

namespace {

using namespace pliant;

enum Mode { off, traced, passes_watched };

// off: the run as it is without an inspector. The others against it tell what is paid for looking.
void step(benchmark::State& state, const char* lesson) {
    Runner runner(find_lesson(lesson));
    StepTrace trace;
    Breakpoints breaks;
    for (int k = 0; k < 50; ++k) runner.step();
    const auto mode = static_cast<Mode>(state.range(0));
    if (mode == traced) runner.trace_to(&trace);
    if (mode == passes_watched) breaks.stages.insert("no such stage"), breaks.assumptions = true;
    for (auto _ : state) {
        if (mode != passes_watched) {
            runner.step();
            continue;
        }
        do {
            runner.step_pass();
            benchmark::DoNotOptimize(breaks.stops(runner));
        } while (runner.inside_step());
    }
    runner.trace_to(nullptr);
    state.SetLabel(mode == off ? "nobody looks" : mode == traced ? "stages traced" : "breakpoints set");
}
BENCHMARK_CAPTURE(step, navier_stokes, "navier_stokes")
    ->Arg(off)
    ->Arg(traced)
    ->Arg(passes_watched)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, mass_spring, "mass_spring")->Arg(off)->Arg(traced)->Arg(passes_watched)->Unit(benchmark::kMicrosecond);

void question(benchmark::State& state, const char* lesson, const char* field) {
    Runner runner(find_lesson(lesson));
    for (int k = 0; k < 50; ++k) runner.step();
    for (auto _ : state) benchmark::DoNotOptimize(why(runner, field, 60, 0));
}
BENCHMARK_CAPTURE(question, navier_stokes, "navier_stokes", "velocity")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(question, mass_spring, "mass_spring", "velocity")->Unit(benchmark::kMillisecond);

// A snapshot against copying as many bytes.
void snapshot(benchmark::State& state) {
    Runner runner(find_lesson("navier_stokes"), {{"resolution", "256"}});
    std::vector<Real> buffer;
    save_state(runner.lesson(), buffer);
    for (auto _ : state) {
        save_state(runner.lesson(), buffer);
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(buffer.size() * sizeof(Real)));
}
BENCHMARK(snapshot);

void plain_copy(benchmark::State& state) {
    const std::vector<Real> from(3 * 65536 + 512, 1.0);
    std::vector<Real> to(from.size());
    for (auto _ : state) {
        std::copy(from.begin(), from.end(), to.begin());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(from.size() * sizeof(Real)));
}
BENCHMARK(plain_copy);

}  // namespace
