#include "session/session.h"

#include <pliant/lesson/setting_words.h>
#include <pliant/math/watch.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {

// ----------------------------------------------------------------------------------------------------- what has to wait

bool Session::put_off(std::function<void()> act) {
    if (!holding_) return false;
    waiting_.push_back(std::move(act));
    return true;
}

void Session::later(std::function<void()> act) {
    if (!put_off(act)) guarded(act);
}

void Session::do_waiting() {
    for (const auto& act : std::exchange(waiting_, {})) guarded(act);
}

// ----------------------------------------------------------------------------------------------------- lessons, scenes

Session::Session(std::string_view lesson_name) { open(find_lesson(lesson_name)); }

void Session::open(const LessonEntry& entry, const Runner::Assignments& assignments, std::vector<Event> events) {
    if (put_off([this, &entry, assignments, events] { open(entry, assignments, events); })) return;
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
    lecture_.reset();
    extension_.reset();
    unlocked = false;
    playing = false;
    frame_afresh();
    colours = lesson().first_colours();
    range = {};
    reached_speed_ = 0;
    begin_run();
}

void Session::open_next(int direction) {
    if (put_off([this, direction] { open_next(direction); })) return;
    const auto& all = lessons();
    const auto here =
        static_cast<int>(std::ranges::find(all, entry_->info.id, [](const LessonEntry& e) { return e.info.id; }) - all.begin());
    const int count = static_cast<int>(all.size());
    guarded([&] { open(all[static_cast<std::size_t>((here + direction + count) % count)]); });
}

namespace {
// A refusal that begins with the key of a parameter begins with its name.
std::string refusal_said(const Runner* run, const Error& e) {
    const std::string_view what = e.what();
    if (run)
        for (const Parameter* p : run->lesson().parameters)
            if (what.starts_with(std::string(p->info.key) + " = ")) return refusal_words(*p, what);
    return std::string(what);
}
}  // namespace

bool Session::guarded(const std::function<void()>& action) {
    try {
        action();
        return true;
    } catch (const Cancelled&) {
        say(Message::Kind::info, "Called off.");
    } catch (const Diverged& e) {
        tell(e);
    } catch (const Error& e) {
        say(Message::Kind::refused, refusal_said(runner_.get(), e));
    }
    playing = false;
    return false;
}

void Session::begin_run() {
    ++run_count_;
    goal_ = nullptr;
    inspector.forget_run();
    recorder_.clear();
    costs_.clear();
    if (companion_) companion_->restart();
    range.forget();
    owed_ = 0;
    moved();
}

// ------------------------------------------------------------------------------------------------------ looking inside

void Session::compare(Compare what) {
    if (put_off([this, what] { compare(what); })) return;
    inspector.compare = what;
    change_range_.forget();
    view_changed();
}

void Session::ask(Inspector::Asked question) {
    if (put_off([this, question] { ask(question); })) return;
    playing = false;
    guarded([&] { inspector.ask(*runner_, std::move(question)); });
}

void Session::ask_back() {
    if (put_off([this] { ask_back(); })) return;
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
