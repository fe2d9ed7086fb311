// A scene becomes the session: its runs are run again, and looked at as they were.
#include "session/session.h"

#include <pliant/math/watch.h>

#include "render/ghost.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

// The parameters of B at its start: those of A, and what it has otherwise.
Runner::Assignments with_changes(Runner::Assignments parameters, const Runner::Assignments& changes) {
    parameters.insert(parameters.end(), changes.begin(), changes.end());
    return parameters;
}

std::optional<Compare> comparison(std::string_view name) {
    for (const Compare c : {Compare::now, Compare::before, Compare::difference, Compare::side_by_side, Compare::swipe})
        if (name_of(c) == name) return c;
    return std::nullopt;
}

std::optional<On> kind_of_thing(const Lesson& lesson, std::string_view name, Index index) {
    for (const Field& f : lesson.fields)
        if (f.in_use() && name_of(f.on) == name && index < f.size()) return f.on;
    return std::nullopt;
}

ColourScale scale_of(const Interval& range, bool diverging) {
    return {range.min, range.max, diverging ? ColourMap::diverging : ColourMap::viridis};
}

// Throws Cancelled between two passes, and Diverged.
void run_on(Runner& runner, Place to, const Overview& overview, Index done, const std::function<void()>& after_pass) {
    while (runner.place() < to) {
        overview.tell(done + runner.place().step);
        runner.step_pass();
        after_pass();
    }
}

}  // namespace

// Of the session; the run of the scene has been made, and stands at its start.
class SceneOpening {
public:
    explicit SceneOpening(Session& session) : s_(session) {}
    void restore(const SceneFile& scene);

private:
    void restore_slide(const SceneFile& scene);
    void restore_view(const SceneView& view);
    void restore_stops(const SceneStops& stops);
    void restore_beside(const SceneBeside& beside);
    void restore_pinned(const ScenePinned& pinned);
    void run_again(const SceneFile& scene);
    void pin_from(const SceneInspector& inspected, Index step);
    void restore_colours(const SceneView& view);
    void restore_questions(const SceneInspector& inspected);

    Session& s_;
};

void Session::check(const SceneFile& scene) {
    const LessonEntry& entry = find_lesson(scene.lesson);
    Runner::check(entry, scene.parameters, scene.events);
    if (scene.beside)
        Runner::check(entry, with_changes(scene.parameters, scene.beside->set), scene.beside->events.value_or(scene.events));
    if (scene.pinned) Runner::check(entry, scene.pinned->run.parameters, scene.pinned->run.events);
}

void Session::open_scene(const SceneFile& scene) {
    if (put_off([this, scene] { open_scene(scene); })) return;
    check(scene);
    open(find_lesson(scene.lesson), scene.parameters, scene.events);
    SceneOpening(*this).restore(scene);
}

// First what decides how the run looks, then the run, then what is looked at in it.
void SceneOpening::restore(const SceneFile& scene) {
    if (scene.version() > 1) s_.inspector.forget_lesson();
    if (scene.slide) restore_slide(scene);
    s_.camera = scene.camera_follows ? std::nullopt : scene.camera;
    s_.own_aspect_ = static_cast<float>(scene.camera_aspect);
    if (scene.camera && scene.camera_follows) s_.viewpoint.turn_to(scene.camera->yaw, scene.camera->pitch);
    if (scene.view) restore_view(*scene.view);
    if (scene.version() > 1) restore_stops(scene.stops);
    if (scene.beside) restore_beside(*scene.beside);
    if (scene.place || scene.pinned || !scene.inspector.pinned.empty()) run_again(scene);
    if (scene.view && !scene.view->stage.empty() && !scene.place)
        s_.guarded([&] { s_.runner_->run_to_stage(scene.view->stage); });
    if (scene.beside && scene.beside->difference) s_.show_difference(true);
    s_.view_changed();
    if (scene.view) restore_colours(*scene.view);
    restore_questions(scene.inspector);
    if (scene.place && scene.place->fails) s_.guarded([&] { s_.runner_->step(); });
}

// As the slide is shown, and then as the run was left.
void SceneOpening::restore_slide(const SceneFile& scene) {
    const SceneSlide& slide = *scene.slide;
    s_.guarded([&] {
        if (slide.extension > s_.extensions().size())
            throw Refused(
                fmt::format("extension {} is not there: {} has {}", slide.extension, scene.lesson, s_.extensions().size()));
        if (!slide.lecture.empty())
            s_.open_lecture(read_lecture(slide.lecture), slide.number - 1);
        else
            slide.extension > 0 ? s_.open_extension(slide.extension - 1) : s_.start_walkthrough();
        if (!s_.walkthrough) return;
        if (s_.entry_->info.id != scene.lesson)
            throw Refused(fmt::format("slide {} of {} now shows another lesson", slide.number, slide.lecture));
        if (slide.extension == 0 && slide.lecture.empty()) s_.go_to_slide(slide.number - 1);
        if (slide.revealed && !s_.walkthrough->revealed()) s_.walkthrough_next();
        if (slide.predicted.given()) s_.walkthrough->restore(slide.predicted);
        s_.unlocked = slide.unlocked;
        s_.close_companion();
        s_.runner_->load(scene.parameters);
        s_.runner_->set_events(scene.events);
        s_.begin_run();
    });
}

void SceneOpening::restore_view(const SceneView& view) {
    if (!view.field.empty()) s_.colours = {view.field, view.component};
    s_.show_arrows = view.arrows, s_.show_labels = view.labels, s_.smooth = view.smooth;
    if (view.patterns) s_.patterns = true;
    s_.extreme = view.extreme;
    s_.inspector.compare = comparison(view.compare).value_or(Compare::now);
    s_.inspector.stage = view.of_stage;
    s_.inspector.swipe = static_cast<float>(view.swipe);
}

void SceneOpening::restore_stops(const SceneStops& stops) {
    Breakpoints& breaks = s_.inspector.breaks;
    breaks.clear();
    breaks.stages.insert(stops.stages.begin(), stops.stages.end());
    breaks.passes.insert(stops.passes.begin(), stops.passes.end());
    for (const std::string& text : stops.conditions) breaks.conditions.push_back(parse_condition(text, s_.lesson()));
    breaks.assumptions = stops.assumptions, breaks.laws = stops.laws;
}

void SceneOpening::restore_beside(const SceneBeside& beside) {
    s_.guarded([&] {
        s_.open_companion(beside.set);
        if (beside.events) s_.companion_->follow_script(*beside.events);
        s_.addresses_b_ = beside.addressed;
    });
}

// --------------------------------------------------------------------------------------------------- the runs again

// In a runner of its own, which leaves its picture and its numbers behind.
void SceneOpening::restore_pinned(const ScenePinned& pinned) {
    Runner run(*s_.entry_, pinned.run.parameters);
    run.set_events(pinned.run.events);
    Recorder recorder;
    recorder.record(run);
    const Overview overview("running the pinned run again", pinned.run.place.step);
    run_on(run, pinned.run.place.place(), overview, 0, [&] {
        if (!run.inside_step()) recorder.record(run);
    });
    apply_to(run, pinned.run.place.changes);
    Scene picture;
    picture.colour_by = {pinned.field, pinned.component};
    picture.show_arrows = s_.show_arrows, picture.show_labels = s_.show_labels;
    run.lesson().draw(picture);
    s_.pinned_ = Pinned{ghost_of(picture), std::move(recorder), settings_of(run), run.place().step, run.time(), pinned};
    ++s_.pin_count_;
}

void SceneOpening::pin_from(const SceneInspector& inspected, Index step) {
    for (const SceneNumber& n : inspected.pinned) {
        const Field* field = s_.lesson().find_field(n.field);
        if (n.from == step && field && field->in_use() && n.index < field->size())
            s_.inspector.pin(*s_.runner_, *field, n.index, n.component);
    }
}

void SceneOpening::run_again(const SceneFile& scene) {
    if (scene.pinned) s_.guarded([&] { restore_pinned(*scene.pinned); });
    const ScenePlace to = scene.place.value_or(ScenePlace{});
    pin_from(scene.inspector, 0);
    const bool went = s_.guarded([&] {
        const Overview overview("running to the place of the scene", to.step);
        run_on(*s_.runner_, to.place(), overview, 0, [&] {
            ++s_.passes_run_;
            if (s_.runner_->inside_step()) return;
            s_.record_step();
            pin_from(scene.inspector, s_.runner_->place().step);
            if (s_.companion_) s_.companion_->follow(*s_.runner_);
        });
        apply_to(*s_.runner_, to.changes);
        if (s_.companion_ && scene.beside) s_.companion_->apply(scene.beside->changes);
    });
    if (!went && s_.message_ && s_.message_->kind == Session::Message::Kind::info)
        return s_.say(
            Session::Message::Kind::info,
            fmt::format("Called off at step {} of {}. Space goes on from here; the scene opened again goes all the way.",
                        s_.runner_->place().step, to.step));
    if (went && s_.runner_->place() != to.place())
        s_.say(Session::Message::Kind::info,
               fmt::format("Step {} of this scene has no pass {}: the run stands at the end of the step.", to.step, to.passes));
    // Those that are followed from later on, because the run was reset or went back since.
    for (const SceneNumber& n : scene.inspector.pinned) pin_from({.pinned = {n}}, n.from);
}

// ------------------------------------------------------------------------------------------------ what is looked at

void SceneOpening::restore_colours(const SceneView& view) {
    s_.range.automatic = !view.fixed;
    if (view.range) s_.range.begin_with(scale_of(*view.range, view.diverging));
    if (view.change_range) s_.change_range_.begin_with(scale_of(*view.change_range, view.change_diverging));
}

void SceneOpening::restore_questions(const SceneInspector& inspected) {
    if (!inspected.on.empty()) {
        if (const auto on = kind_of_thing(s_.lesson(), inspected.on, inspected.index))
            s_.inspector.thing = Thing{*on, inspected.index};
        else
            s_.say(Session::Message::Kind::info,
                   fmt::format("The {} {} that was looked at is not there.", inspected.on, inspected.index));
    }
    for (const SceneNumber& n : inspected.asked) {
        Inspector::Asked question{.field = n.field, .index = n.index, .component = n.component};
        if (n.when) question.when = When{n.when->step, n.when->passes};
        if (!s_.guarded([&] { s_.inspector.ask(*s_.runner_, std::move(question)); })) return;
    }
}

}  // namespace pliant::viewer
