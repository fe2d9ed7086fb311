#include "app/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

// Of one frame, for doing a static lesson again.
constexpr int settling_ms = 12;

}  // namespace

// ----------------------------------------------------------------------------------------------------- lessons, scenes

Session::Session(std::string_view lesson_name) { open(find_lesson(lesson_name)); }

void Session::open(const LessonEntry& entry, const Runner::Assignments& assignments, std::vector<Event> events) {
    // The new run is made before the old one is given up, so a refusal leaves everything as it was.
    auto runner = std::make_unique<Runner>(entry, assignments);
    runner->set_events(std::move(events));
    if (entry_ != &entry) inspector.forget_lesson();
    runner_ = std::move(runner);
    entry_ = &entry;
    ++open_count_;
    pinned_.reset();
    close_companion();
    undo_.clear();
    dismiss();
    walkthrough.reset();
    unlocked = false;
    playing = false;
    frame_afresh();
    colours = lesson().first_colours();
    range = {};
    reached_speed_ = 0;
    begin_run();
}

void Session::open_next(int direction) {
    const auto& all = lessons();
    const auto here =
        static_cast<int>(std::ranges::find(all, entry_->info.id, [](const LessonEntry& e) { return e.info.id; }) - all.begin());
    const int count = static_cast<int>(all.size());
    guarded([&] { open(all[static_cast<std::size_t>((here + direction + count) % count)]); });
}

void Session::open_scene(const SceneFile& scene) {
    open(find_lesson(scene.lesson), scene.parameters, scene.events);
    camera = scene.camera;
    if (!scene.view) return;
    if (!scene.view->field.empty()) colours = {scene.view->field, scene.view->component};
    if (!scene.view->stage.empty()) guarded([&] { runner_->run_to_stage(scene.view->stage); });
}

SceneFile Session::scene_file() const {
    SceneFile file = scene_of(*runner_);
    if (camera || viewpoint.turned()) file.camera = seen_by();
    const auto last = runner_->last_stage();
    file.view = SceneView{colours.field, colours.component,
                          runner_->inside_step() && last ? std::string(runner_->stages()[*last]->name) : ""};
    return file;
}

// ---------------------------------------------------------------------------------------------------------------- time

bool Session::guarded(const std::function<void()>& action) {
    try {
        action();
        return true;
    } catch (const Diverged& e) {
        tell(e);
    } catch (const Error& e) {
        say(Message::Kind::refused, e.what());
    }
    playing = false;
    return false;
}

void Session::begin_run() {
    ++run_count_;
    inspector.forget_run();
    before_.reset();
    recorder_.clear();
    costs_.clear();
    if (companion_) companion_->restart();
    range.forget();
    owed_ = 0;
    moved();
}

void Session::moved() {
    // In the past everything is recorded already.
    if (!runner_->inside_step() && runner_->place() == runner_->reach())
        guarded([&] {
            recorder_.record(*runner_);
            inspector.record(*runner_);
            costs_.record(*runner_);
        });
    if (companion_) companion_->follow(*runner_);
    if (!playing && !inspector.asked.empty()) guarded([&] { inspector.ask_again(*runner_); });
    view_changed();
}

void Session::view_changed() {
    const Field* field = lesson().find_field(colours.field);
    shows_change_ = false;
    if (!field || !field->in_use()) return;
    std::vector<Real> values;
    row_values(*field, colours.component, values);
    if (shows_difference()) {
        values = difference();
    } else if (const Field* beside = companion_ ? companion_->lesson().find_field(colours.field) : nullptr;
               beside && beside->in_use() && companion_->stopped().empty()) {
        std::vector<Real> of_b;
        row_values(*beside, colours.component, of_b);
        values.insert(values.end(), of_b.begin(), of_b.end());
    }
    range.update(values);
    if (inspector.compare != Compare::difference) return;
    guarded([&] { inspector.renew_trace(*runner_); });
    if (const auto change = inspector.change(*runner_, *field, colours.component)) {
        change_range_.update(*change);
        shows_change_ = true;
    }
}

bool Session::advance_one() {
    // A static lesson is played pass by pass, so that its solve can be watched.
    const bool pass_by_pass = runner_->is_static() || inspector.breaks.any();
    if (!std::exchange(armed_, true)) inspector.breaks.arm(*runner_);
    bool go_on = true;
    const bool done = guarded([&] {
        if (!pass_by_pass) return runner_->step();
        do {
            runner_->step_pass();
            if (const auto reason = inspector.breaks.stops(*runner_)) {
                inspector.stopped = *reason, go_on = false;
                tell_failed_assumption();
            }
        } while (go_on && !runner_->is_static() && runner_->inside_step());
    });
    if (!go_on) playing = false;
    moved();
    return done && go_on;
}

void Session::trace() {
    const bool looked_at = !playing || inspector.compare != Compare::now;
    runner_->trace_to(looked_at ? &inspector.trace : nullptr);
}

void Session::update(Real seconds, Real budget_ms) {
    trace();
    if (!playing) {
        armed_ = false;
        return;
    }
    inspector.stopped.clear();
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto spent_ms = [&] { return std::chrono::duration<Real, std::milli>(Clock::now() - start).count(); };
    if (runner_->is_static()) {
        if (lesson().at_rest() && !runner_->inside_step())
            playing = false;
        else
            advance_one();
        return;
    }
    owed_ += seconds * speed;
    const Real before = runner_->time();
    while (playing && owed_ >= runner_->time_step() && spent_ms() < budget_ms) {
        owed_ -= runner_->time_step();
        if (!advance_one()) break;
    }
    // What could not be run in time is dropped.
    owed_ = std::clamp(owed_, Real{0}, std::max(runner_->time_step(), seconds * speed));
    if (seconds > 0) reached_speed_ += 0.1 * ((runner_->time() - before) / seconds - reached_speed_);
}

void Session::run(const Until& until) {
    playing = false;
    advance(*runner_, until, [this] { moved(); });
}

void Session::step() {
    playing = false;
    trace();
    inspector.stopped.clear();
    guarded([&] { runner_->step(); });
    moved();
}

void Session::step_stage() {
    playing = false;
    trace();
    inspector.stopped.clear();
    guarded([&] { runner_->step_stage(); });
    moved();
}

void Session::run_to_stage(std::string_view name) {
    playing = false;
    trace();
    inspector.stopped.clear();
    guarded([&] { runner_->run_to_stage(name); });
    moved();
}

void Session::step_pass() {
    playing = false;
    trace();
    inspector.stopped.clear();
    guarded([&] { runner_->step_pass(); });
    moved();
}

void Session::pass_back() {
    playing = false;
    dismiss();
    bool found = true;
    guarded([&] { found = runner_->pass_back(); });
    keep_hand();
    if (!found) say(Message::Kind::info, "Nothing before this is stored.");
    moved();
}

void Session::go_to(Place place) {
    playing = false;
    dismiss();
    inspector.stopped.clear();
    guarded([&] { runner_->go_to(place); });
    view_changed();
    if (!inspector.asked.empty()) guarded([&] { inspector.ask_again(*runner_); });
}

void Session::step_back() {
    playing = false;
    dismiss();
    bool found = true;
    guarded([&] { found = runner_->step_back(); });
    keep_hand();
    if (!found)
        say(Message::Kind::info,
            runner_->place() == Place{} ? "This is the beginning." : "Steps before this one are no longer stored.");
    moved();
}

void Session::stage_back() {
    playing = false;
    dismiss();
    bool found = true;
    guarded([&] { found = runner_->stage_back(); });
    keep_hand();
    if (!found) say(Message::Kind::info, "Nothing before this is stored.");
    moved();
}

void Session::reset() {
    dismiss();
    guarded([&] { runner_->reset(); });
    begin_run();
}

// ---------------------------------------------------------------------------------------------------------- parameters

bool Session::set(const Values& values) {
    Runner::Assignments assignments;
    bool rebuilds = false;
    for (const auto& [key, value] : values) {
        const Parameter& p = lesson().parameter(key);
        rebuilds = rebuilds || p.info.effect == Effect::rebuild;
        assignments.emplace_back(key, p.text(value));
    }
    const bool all_was_done = lesson().at_rest() && !runner_->inside_step();
    const int dimension = lesson().dimension();
    if (!guarded([&] { runner_->assign(assignments); })) return false;
    dismiss();
    if (!rebuilds) {
        moved();
        settle(all_was_done);
        return true;
    }
    // The domain may have another size, or the scene another dimension.
    if (lesson().dimension() == 2 || lesson().dimension() != dimension) camera.reset();
    begin_run();
    settle(all_was_done);
    return true;
}

// What was done before the change is done again: a static lesson answers a slider at once. A long solve goes on from frame to
// frame.
void Session::settle(bool all_was_done) {
    if (!runner_->is_static() || !(all_was_done || playing)) return;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(settling_ms);
    const bool was_playing = playing;
    playing = true;
    do {
        if (!advance_one()) return;
        if (lesson().at_rest() && !runner_->inside_step()) return void(playing = was_playing);
    } while (Clock::now() < end);
}

void Session::assign(const Parameter& parameter, Real value, bool same_drag) {
    const std::string key(parameter.info.key);
    const bool beside = companion_ && companion_->owns(parameter);
    const Real before = (beside ? companion_->runner() : *runner_).wanted(parameter);
    if (before == value) return;
    if (locked(parameter))
        return say(Message::Kind::refused,
                   fmt::format("{} is locked on this slide: press L to unlock it, or end the walkthrough.", parameter.info.key));
    if (!(beside ? set_beside(parameter, value) : set({{key, value}}))) return;
    const bool joins = same_drag && !undo_.empty() && undo_.back().values.size() == 1 && undo_.back().values[0].first == key &&
                       undo_.back().beside == beside;
    if (!joins) undo_.push_back({{{key, before}}, beside});
}

void Session::enter(const Parameter& parameter, std::string_view text) {
    try {
        assign(parameter, parameter.parse(text));
    } catch (const Refused& e) {
        say(Message::Kind::refused, e.what());
    }
}

bool Session::assign_together(const Values& values) {
    Values before, wanted;
    for (const auto& [key, value] : values) {
        const Parameter& p = lesson().parameter(key);
        if (runner_->wanted(p) == value) continue;
        if (locked(p)) {
            say(Message::Kind::refused,
                fmt::format("{} is locked on this slide: press L to unlock it, or end the walkthrough.", key));
            return false;
        }
        before.emplace_back(key, runner_->wanted(p));
        wanted.emplace_back(key, value);
    }
    if (!wanted.empty() && !set(wanted)) return false;
    if (!before.empty()) undo_.push_back({std::move(before), false});
    reset();
    return true;
}

void Session::restore_default(const Parameter& parameter) { assign(parameter, parameter.info.initial); }

void Session::restore_defaults() {
    Values before, defaults;
    for (const Parameter* p : lesson().parameters) {
        if (runner_->wanted(*p) == p->info.initial) continue;
        before.emplace_back(p->info.key, runner_->wanted(*p));
        defaults.emplace_back(p->info.key, p->info.initial);
    }
    if (!defaults.empty() && set(defaults)) undo_.push_back({std::move(before), false});
}

void Session::undo() {
    if (undo_.empty()) return;
    const Undo& last = undo_.back();
    last.beside ? set_beside(companion_->lesson().parameter(last.values[0].first), last.values[0].second) : set(last.values);
    undo_.pop_back();
}

void Session::pull(const std::optional<Pull>& pulled) {
    if (!pulled) moves_handle_ = false;
    if (const Values values = pulled ? lesson().dragged(*pulled) : Values{}; !values.empty()) return move_handle(values);
    hand_ = pulled;
    hand_used_ = true;
    runner_->pull(pulled);
    if (companion_) companion_->pull(pulled, lesson());
}

// The moves of one drag are one step of undo.
void Session::move_handle(const Values& values) {
    Values before, wanted;
    for (const auto& [key, value] : values) {
        const Parameter& p = lesson().parameter(key);
        if (locked(p)) return say(Message::Kind::refused, fmt::format("{} is locked on this slide: press L to unlock it.", key));
        const Interval span = extreme ? p.accepted() : p.info.useful;
        before.emplace_back(key, runner_->wanted(p));
        wanted.emplace_back(key, std::clamp(value, span.min, span.max));
    }
    if (wanted == before) return;
    const auto kept = camera;  // what is under the pointer stays there
    const bool moved_it = set(wanted);
    camera = kept;
    if (!moved_it) return;
    if (!std::exchange(moves_handle_, true)) undo_.push_back({std::move(before), false});
}

void Session::keep_hand() {
    if (hand_used_) pull(hand_);
}

// ---------------------------------------------------------------------------------------------------------------- view

Scene Session::drawn() const {
    Scene picture;
    picture.colour_by = colours;
    picture.show_arrows = show_arrows, picture.show_labels = show_labels;
    if (shows_difference()) picture.override_values = difference();
    return picture;
}

void Session::show_cells(Scene& picture) const {
    if (smooth) return;
    for (GridMarks& g : picture.grids) g.smooth = false;
}

Scene Session::scene() {
    if (inspector.compare == Compare::before)
        if (auto before = other_scene()) return *std::move(before);
    Scene picture = drawn();
    const Field* field = lesson().find_field(colours.field);
    if (shows_change_ && field) picture.override_values = inspector.change(*runner_, *field, colours.component);
    lesson().draw(picture);
    show_cells(picture);
    return picture;
}

// It is drawn again only when the run, the stage or the colours are others.
std::optional<Scene> Session::other_scene() {
    if (inspector.compare == Compare::now || inspector.compare == Compare::difference) return std::nullopt;
    const std::string key = inspector.stage + "/" + colours.field + std::to_string(colours.component) + (show_arrows ? "a" : "") +
                            (show_labels ? "l" : "") + (smooth ? "s" : "");
    if (!before_ || before_place_ != runner_->place() || before_key_ != key) {
        Scene picture = drawn();
        bool found = false;
        guarded([&] { found = inspector.draw_before(*runner_, picture); });
        show_cells(picture);
        before_ = found ? std::optional(std::move(picture)) : std::nullopt;
        before_place_ = runner_->place();
        before_key_ = key;
    }
    return before_;
}

// ------------------------------------------------------------------------------------------------------ looking inside

void Session::compare(Compare what) {
    // Half of the place asks for another frame.
    if ((what == Compare::side_by_side) != (inspector.compare == Compare::side_by_side)) camera.reset();
    inspector.compare = what;
    before_.reset();
    change_range_.forget();
    view_changed();
}

void Session::ask(Inspector::Asked question) {
    playing = false;
    guarded([&] { inspector.ask(*runner_, std::move(question)); });
}

void Session::ask_back() {
    guarded([&] { inspector.ask_back(*runner_); });
}

void Session::toggle_break(std::string_view stage) {
    auto& stages = inspector.breaks.stages;
    if (const auto there = stages.find(stage); there != stages.end())
        stages.erase(there);
    else
        stages.emplace(stage);
}

}  // namespace pliant::viewer
