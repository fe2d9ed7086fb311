// The scene of a run, and the run of a scene.
#include <pliant/document/scene_file.h>

#include <algorithm>
#include <utility>

namespace pliant {

namespace {
Runner::Assignments start_of(const Runner& runner) {
    Runner::Assignments parameters;
    for (const Parameter* p : runner.lesson().parameters)
        if (const Real value = runner.recording().start(*p); value != p->info.initial)
            parameters.emplace_back(p->info.key, p->text(value));
    return parameters;
}

std::vector<Event> both(std::vector<Event> script, const std::vector<Event>& recorded) {
    script.insert(script.end(), recorded.begin(), recorded.end());
    std::ranges::stable_sort(script, {}, &Event::step);
    return script;
}
}  // namespace

SceneFile scene_of(const Runner& runner) {
    return {.lesson = std::string(runner.info().id),
            .parameters = start_of(runner),
            .events = both(runner.events(), runner.recording().events())};
}

SceneRun run_of(const Runner& runner) {
    SceneRun run{.parameters = start_of(runner)};
    run.place.step = runner.place().step, run.place.passes = runner.place().passes;
    // What takes effect with the next step. Before the first one it is an event like any other.
    const Index next = runner.inside_step() ? run.place.step + 1 : run.place.step;
    std::vector<Event> recorded = runner.recording().events();
    if (next > 0 && !recorded.empty() && recorded.back().step >= next) {
        const Event& last = recorded.back();
        run.place.changes = {last.assign, last.pull, last.release};
        recorded.pop_back();
    }
    run.events = both(runner.events(), recorded);
    return run;
}

SceneFile placed_scene_of(const Runner& runner) {
    SceneRun run = run_of(runner);
    SceneFile scene{
        .lesson = std::string(runner.info().id), .parameters = std::move(run.parameters), .events = std::move(run.events)};
    if (run.place != ScenePlace{}) scene.place = std::move(run.place);
    return scene;
}

void apply_to(Runner& runner, const SceneChanges& changes) {
    if (!changes.set.empty()) runner.assign(changes.set);
    if (changes.pull || changes.release) runner.pull(changes.pull);
}

void play_to_place(Runner& runner, const SceneFile& scene) {
    runner.load(scene.parameters);
    runner.set_events(scene.events);
    if (!scene.place) return;
    while (runner.place().step < scene.place->step) runner.step();
    while (runner.place() < scene.place->place()) runner.step_pass();
    apply_to(runner, scene.place->changes);
}

}  // namespace pliant
