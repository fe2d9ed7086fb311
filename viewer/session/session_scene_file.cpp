// The session as a scene.
#include "session/session.h"

#include <utility>

namespace pliant::viewer {

class SceneTaking {
public:
    explicit SceneTaking(const Session& session) : s_(session) {}
    SceneView view() const;
    SceneBeside beside() const;
    SceneStops stops() const;
    SceneInspector inspector() const;

private:
    const Session& s_;
};

SceneFile Session::scene_file() const {
    const SceneTaking taking(*this);
    SceneRun run = run_of(*runner_);
    SceneFile file{
        .lesson = std::string(entry_->info.id), .parameters = std::move(run.parameters), .events = std::move(run.events)};
    if (camera || viewpoint.turned()) file.camera = camera ? *camera : seen_by();
    if (camera) file.camera_aspect = Real{own_aspect_};
    file.camera_follows = !camera && viewpoint.turned();
    file.view = taking.view();
    run.place.fails = autopsy_ && runner_->failure();
    if (run.place != ScenePlace{}) file.place = std::move(run.place);
    if (companion_) file.beside = taking.beside();
    if (pinned_) file.pinned = pinned_->scene;
    file.stops = taking.stops();
    file.inspector = taking.inspector();
    if (walkthrough && !lecture_)
        file.slide = SceneSlide{.number = walkthrough->slide_number() + 1,
                                .extension = extension_ ? *extension_ + 1 : 0,
                                .revealed = walkthrough->revealed(),
                                .unlocked = unlocked,
                                .predicted = walkthrough->guess()};
    return file;
}

// A range that the numbers of now would give again is not kept.
SceneView SceneTaking::view() const {
    SceneView view{.field = s_.colours.field, .component = s_.colours.component};
    view.fixed = !s_.range.automatic;
    if (const auto values = s_.shown_values();
        !values.empty() && (view.fixed || s_.range.scale != scale_for(values, s_.range.scale.map == ColourMap::diverging))) {
        view.range = Interval{s_.range.scale.min, s_.range.scale.max};
        view.diverging = s_.range.scale.map == ColourMap::diverging;
    }
    if (s_.shows_change_) {
        view.change_range = Interval{s_.change_range_.scale.min, s_.change_range_.scale.max};
        view.change_diverging = s_.change_range_.scale.map == ColourMap::diverging;
    }
    view.arrows = s_.show_arrows, view.labels = s_.show_labels, view.smooth = s_.smooth, view.patterns = s_.patterns,
    view.extreme = s_.extreme;
    view.compare = name_of(s_.inspector.compare);
    view.of_stage = s_.inspector.stage;
    view.swipe = Real{s_.inspector.swipe};
    return view;
}

SceneBeside SceneTaking::beside() const {
    const Runner& b = s_.companion_->runner();
    SceneRun of_a = run_of(*s_.runner_), of_b = run_of(b);
    SceneBeside beside{.changes = of_b.place.changes, .addressed = s_.addresses_b_, .difference = s_.shows_difference()};
    for (std::size_t i = 0; i < b.lesson().parameters.size(); ++i) {
        const Parameter &p = *b.lesson().parameters[i], &same_of_a = *s_.lesson().parameters[i];
        if (const Real value = b.recording().start(p); value != s_.runner_->recording().start(same_of_a))
            beside.set.emplace_back(p.info.key, p.text(value));
    }
    if (of_b.events != of_a.events) beside.events = std::move(of_b.events);
    return beside;
}

SceneStops SceneTaking::stops() const {
    const Breakpoints& breaks = s_.inspector.breaks;
    SceneStops stops{.stages = {breaks.stages.begin(), breaks.stages.end()},
                     .passes = {breaks.passes.begin(), breaks.passes.end()},
                     .assumptions = breaks.assumptions,
                     .laws = breaks.laws};
    for (const Condition& c : breaks.conditions) stops.conditions.push_back(c.text());
    return stops;
}

SceneInspector SceneTaking::inspector() const {
    SceneInspector in;
    if (s_.inspector.thing) in.on = name_of(s_.inspector.thing->on), in.index = s_.inspector.thing->index;
    for (const Inspector::Asked& q : s_.inspector.asked) {
        in.asked.push_back({.field = q.field, .index = q.index, .component = q.component});
        if (q.when) in.asked.back().when = Place{q.when->step, q.when->passes};
    }
    for (const Pin& p : s_.inspector.pins)
        in.pinned.push_back({.field = p.field, .index = p.index, .component = p.component, .from = p.from});
    return in;
}

}  // namespace pliant::viewer
