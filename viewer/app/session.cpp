#include "app/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace pliant::viewer {

// ----------------------------------------------------------------------------------------------------------- colours

void ColourRange::update(const std::vector<Real>& values) {
    if (values.empty() || (!automatic && !fresh_)) return;
    const ColourScale wanted = scale_for(values);
    const Real size = std::max(std::abs(scale.min), std::abs(scale.max)),
               wanted_size = std::max(std::abs(wanted.min), std::abs(wanted.max));
    // Follows when the numbers reach beyond the range or fill less than a third of it, so that colours do not flicker.
    const bool outside = wanted.min < scale.min || wanted.max > scale.max || wanted.map != scale.map;
    const bool lost = wanted_size < size / 3 || (wanted.max - wanted.min) < (scale.max - scale.min) / 3;
    if (std::exchange(fresh_, false) || outside || lost) scale = wanted;
}

// ----------------------------------------------------------------------------------------------------- lessons, scenes

Session::Session(std::string_view lesson_name) { open(find_lesson(lesson_name)); }

void Session::open(const LessonEntry& entry, const Runner::Assignments& assignments, std::vector<Event> events) {
    // The new run is made before the old one is given up, so a refusal leaves everything as it was.
    auto runner = std::make_unique<Runner>(entry, assignments);
    runner->set_events(std::move(events));
    runner_ = std::move(runner);
    entry_ = &entry;
    pinned_.reset();
    close_companion();
    undo_.clear();
    message_.reset();
    walkthrough.reset();
    unlocked = false;
    playing = false;
    camera.reset();
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
    file.camera = camera;
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
        say(Message::Kind::diverged, e.what());
    } catch (const Error& e) {
        say(Message::Kind::refused, e.what());
    }
    playing = false;
    return false;
}

void Session::begin_run() {
    ++run_count_;
    recorder_.clear();
    costs_.clear();
    if (companion_) companion_->restart();
    range.forget();
    owed_ = 0;
    moved();
}

void Session::moved() {
    if (!runner_->inside_step()) guarded([&] { recorder_.record(*runner_); }), costs_.record(*runner_);
    if (companion_) companion_->follow(*runner_);
    view_changed();
}

void Session::view_changed() {
    const Field* field = lesson().find_field(colours.field);
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
}

bool Session::advance_one() {
    // A static lesson is played pass by pass, so that its solve can be watched.
    const bool done = guarded([&] { runner_->is_static() ? runner_->step_pass() : runner_->step(); });
    moved();
    return done;
}

void Session::update(Real seconds, Real budget_ms) {
    if (!playing) return;
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
    guarded([&] { runner_->step(); });
    moved();
}

void Session::step_stage() {
    playing = false;
    guarded([&] { runner_->step_stage(); });
    moved();
}

void Session::run_to_stage(std::string_view name) {
    playing = false;
    guarded([&] { runner_->run_to_stage(name); });
    moved();
}

void Session::step_pass() {
    playing = false;
    guarded([&] { runner_->step_pass(); });
    moved();
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

bool Session::set(const Parameter& parameter, Real value) {
    const bool rebuilds = parameter.info.effect == Effect::rebuild;
    if (!guarded([&] { runner_->assign(parameter.info.key, value); })) return false;
    dismiss();
    if (!rebuilds) return moved(), true;
    if (lesson().dimension() == 2) camera.reset();  // the domain may have another size
    begin_run();
    return true;
}

void Session::assign(const Parameter& parameter, Real value, bool same_drag) {
    const bool beside = companion_ && companion_->owns(parameter);
    const Real before = (beside ? companion_->runner() : *runner_).wanted(parameter);
    if (before == value) return;
    if (locked(parameter))
        return say(Message::Kind::refused,
                   fmt::format("{} is locked on this slide: press L to unlock it, or end the walkthrough.", parameter.info.key));
    if (!(beside ? set_beside(parameter, value) : set(parameter, value))) return;
    const bool joins = same_drag && !undo_.empty() && undo_.back().key == parameter.info.key && undo_.back().beside == beside;
    if (!joins) undo_.push_back({std::string(parameter.info.key), before, beside});
}

void Session::restore_default(const Parameter& parameter) { assign(parameter, parameter.info.initial); }

void Session::undo() {
    if (undo_.empty()) return;
    const Undo& last = undo_.back();
    last.beside ? set_beside(companion_->lesson().parameter(last.key), last.value)
                : set(lesson().parameter(last.key), last.value);
    undo_.pop_back();
}

void Session::pull(const std::optional<Pull>& pulled) {
    hand_ = pulled;
    hand_used_ = true;
    runner_->pull(pulled);
    if (companion_) companion_->pull(pulled, lesson());
}

void Session::keep_hand() {
    if (hand_used_) pull(hand_);
}

// ---------------------------------------------------------------------------------------------------------------- view

Scene Session::scene() const { return picture_of(lesson()); }

Scene Session::picture_of(const Lesson& of) const {
    Scene picture;
    picture.colour_by = colours;
    picture.show_arrows = show_arrows, picture.show_labels = show_labels;
    if (shows_difference()) picture.override_values = difference();
    of.draw(picture);
    if (!smooth)
        for (GridMarks& g : picture.grids) g.smooth = false;
    return picture;
}

}  // namespace pliant::viewer
