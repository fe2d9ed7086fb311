// What a stability map costs, and what the runner adds to the steps of a small lesson.
#include <benchmark/benchmark.h>
#include <pliant/study/stability_map.h>

namespace {

using namespace pliant;

const Runner::Assignments one_cell{{"cells_x", "1"}, {"cells_y", "1"}, {"cells_z", "1"}, {"scene", "spin"}};

MapOrder order_of(Index cells, Index steps) {
    const LessonEntry& entry = find_lesson("mass_spring");
    const auto lesson = entry.make();
    return {.lesson = &entry,
            .settings = one_cell,
            .across = useful_knob(lesson->parameter("time_step"), cells),
            .up = useful_knob(lesson->parameter("k_structural"), cells),
            .steps = steps};
}

// Of 12 × 12 cells with 200 steps.
void stability_map(benchmark::State& state) {
    const MapOrder order = order_of(12, 200);
    for (auto _ : state) benchmark::DoNotOptimize(make_stability_map(order, static_cast<int>(state.range(0))));
    state.SetItemsProcessed(state.iterations() * 144);
    state.SetLabel("cells");
}
BENCHMARK(stability_map)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

// A cell begins with its parameters and a reset.
void load_cell(benchmark::State& state) {
    const MapOrder order = order_of(4, 200);
    Runner runner(*order.lesson, order.settings, 0);
    for (auto _ : state) runner.load(cell_assignments(order, runner.lesson(), 1, 2));
}
BENCHMARK(load_cell)->Unit(benchmark::kMicrosecond);

void step_without_history(benchmark::State& state) {
    Runner runner(find_lesson("mass_spring"), one_cell, 0);
    for (auto _ : state) runner.step();
}
BENCHMARK(step_without_history)->Unit(benchmark::kMicrosecond);

}  // namespace
