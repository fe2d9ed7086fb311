// What a stability map costs, and what the runner adds to the steps of a small lesson.
#include <benchmark/benchmark.h>
#include <pliant/study/stability_map.h>

namespace {

using namespace pliant;

struct Studied {
    const char *lesson, *across, *up;
    Runner::Assignments settings;
};
// One degree of freedom, and a lattice of one cell.
const Studied oscillator{"time/integration", "time_step", "omega", {}};
const Studied lattice{
    "mass_spring", "time_step", "k_structural", {{"cells_x", "1"}, {"cells_y", "1"}, {"cells_z", "1"}, {"scene", "spin"}}};

MapOrder order_of(const Studied& s, Index cells) {
    const LessonEntry& entry = find_lesson(s.lesson);
    const auto lesson = entry.make();
    return {.lesson = &entry,
            .settings = s.settings,
            .across = useful_knob(lesson->parameter(s.across), cells),
            .up = useful_knob(lesson->parameter(s.up), cells)};
}

// Of 40 × 40 cells with 200 steps, by so many threads.
void stability_map(benchmark::State& state, const Studied& s) {
    const MapOrder order = order_of(s, 40);
    for (auto _ : state) benchmark::DoNotOptimize(make_stability_map(order, static_cast<int>(state.range(0))));
    state.SetItemsProcessed(state.iterations() * 1600);
    state.SetLabel("cells");
}
BENCHMARK_CAPTURE(stability_map, oscillator, oscillator)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stability_map, lattice, lattice)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

// A cell begins with its parameters and a reset.
void load_cell(benchmark::State& state, const Studied& s) {
    const MapOrder order = order_of(s, 4);
    Runner runner(*order.lesson, order.settings, 0);
    for (auto _ : state) runner.load(cell_assignments(order, runner.lesson(), 1, 2));
}
BENCHMARK_CAPTURE(load_cell, oscillator, oscillator)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(load_cell, lattice, lattice)->Unit(benchmark::kMicrosecond);

// What a cell pays for each step, the runner's part included.
void step_without_history(benchmark::State& state, const Studied& s) {
    Runner runner(find_lesson(s.lesson), s.settings, 0);
    for (auto _ : state) runner.step();
}
BENCHMARK_CAPTURE(step_without_history, oscillator, oscillator)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step_without_history, lattice, lattice)->Unit(benchmark::kMicrosecond);

}  // namespace
