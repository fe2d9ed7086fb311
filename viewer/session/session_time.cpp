// How the session moves its run: pass by pass, within what a frame may take, and back through the stored past.
#include "session/session.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {

// --------------------------------------------------------------------------------------------- what follows from a move

void Session::record_step() {
    // In the past everything is recorded already.
    if (runner_->inside_step() || runner_->place() != runner_->reach()) return;
    guarded([&] {
        recorder_.record(*runner_);
        inspector.record(*runner_);
        costs_.record(*runner_);
    });
}

void Session::seen() {
    if (shows_last_step()) return;
    if (!playing && !goal_ && !inspector.asked.empty()) guarded([&] { inspector.ask_again(*runner_); });
    view_changed();
}

void Session::moved() {
    record_step();
    if (companion_ && !sliced) companion_->follow(*runner_);
    seen();
}

void Session::trace() {
    const bool looked_at = !playing || inspector.compare != Compare::now;
    runner_->trace_to(looked_at ? &inspector.trace : nullptr);
}

// --------------------------------------------------------------------------------------------------------- pass by pass

// False when the run stops here: it broke down, or one of the stops that it obeys holds.
bool Session::advance_pass(bool obeys_stops) {
    const bool stops = obeys_stops && inspector.breaks.any();
    if (stops && !std::exchange(armed_, true)) inspector.breaks.arm(*runner_);
    ++passes_run_;
    bool go_on = guarded([&] { runner_->step_pass(); });
    if (!runner_->inside_step()) record_step();
    if (!go_on || !stops) return go_on;
    guarded([&] {
        const auto reason = inspector.breaks.stops(*runner_);
        if (!reason) return;
        go_on = playing = false;
        inspector.stopped = *reason;
        tell_failed_assumption();
    });
    return go_on;
}

bool Session::beside_is_behind() const { return companion_ && !companion_->caught_up(*runner_); }

// B first, so that two pictures are of one time.
void Session::play(Real seconds, Spending& spending) {
    inspector.stopped.clear();
    if (runner_->is_static()) {
        // One pass a frame, so that the solve can be watched.
        if (lesson().at_rest() && !runner_->inside_step())
            playing = false;
        else if (!beside_is_behind())
            advance_pass(true);
        return;
    }
    owed_ += seconds * speed;
    const Real before = runner_->time();
    const bool was_cut = runner_->inside_step();
    while (playing && !spending.spent()) {
        if (beside_is_behind()) {
            spending.pass();
            if (!companion_->follow_a_pass(*runner_)) break;
            continue;
        }
        if (!runner_->inside_step()) {
            if (owed_ < runner_->time_step() || !spending.may_begin_step(runner_->step_ms())) break;
            owed_ -= runner_->time_step();
        }
        spending.pass();
        if (!advance_pass(true)) break;
        // What several frames were needed for is shown before the next step begins.
        if (was_cut && !runner_->inside_step()) break;
    }
    // What could not be run in time is dropped.
    owed_ = std::clamp(owed_, Real{0}, std::max(runner_->time_step(), seconds * speed));
    if (seconds > 0) reached_speed_ += 0.1 * ((runner_->time() - before) / seconds - reached_speed_);
}

void Session::work_towards_goal(Spending& spending) {
    while (goal_ && !spending.spent()) {
        spending.pass();
        // B goes along, so that what is seen meanwhile is of one time.
        if (sliced && beside_is_behind() && companion_->follow_a_pass(*runner_)) continue;
        if (!advance_pass(false) || goal_()) goal_ = nullptr;
    }
}

void Session::update(Real seconds, Budget budget) {
    trace();
    const long before = runner_->revision();
    const Place place = runner_->place();
    Spending spending(budget);
    if (goal_)
        work_towards_goal(spending);
    else if (playing)
        play(seconds, spending);
    if (!playing) armed_ = false;
    while (beside_is_behind() && !spending.spent()) {
        spending.pass();
        if (!companion_->follow_a_pass(*runner_)) break;
    }
    updates_in_step_ = runner_->inside_step() && runner_->place().step == place.step ? updates_in_step_ + 1 : 0;
    if (runner_->revision() != before) seen();
}

bool Session::shows_last_step() const {
    constexpr int patience = 20;  // updates
    return playing && sliced && runner_->inside_step() && updates_in_step_ < patience && !runner_->is_static() &&
           inspector.compare == Compare::now;
}

bool Session::under_way() const { return playing || goal_ || beside_is_behind(); }

void Session::toggle_play() {
    if (put_off([this] { toggle_play(); })) return;
    // A step that is under way is finished first; who does not want to wait for it asks again.
    const bool in_a_step = sliced && runner_->inside_step() && !runner_->is_static() && !inspector.breaks.any();
    if (goal_)
        goal_ = nullptr, seen();
    else if (std::exchange(playing, !playing) && in_a_step)
        begin_to(end_of_step());
}

// -------------------------------------------------------------------------------------------------------------- forward

std::function<bool()> Session::end_of_step() const {
    return [this, step = runner_->place().step] { return runner_->place().step != step; };
}

void Session::begin_to(std::function<bool()> reached) {
    goal_ = std::move(reached);
    if (sliced) return;
    trace();
    Spending without_end{Budget::unlimited()};
    work_towards_goal(without_end);
    moved();
}

void Session::move_to(std::function<bool()> reached) {
    playing = false;
    inspector.stopped.clear();
    begin_to(std::move(reached));
}

void Session::step() {
    if (put_off([this] { step(); })) return;
    move_to(end_of_step());
}

void Session::step_stage() {
    if (put_off([this] { step_stage(); })) return;
    move_to([this] { return runner_->passes_in_stage() == 0; });
}

void Session::step_pass() {
    if (put_off([this] { step_pass(); })) return;
    move_to([] { return true; });
}

void Session::run_to_stage(std::string_view name) {
    if (put_off([this, name = std::string(name)] { run_to_stage(name); })) return;
    const auto is_wanted = [name = std::string(name)](const Stage* s) { return s->name == name; };
    if (std::ranges::none_of(runner_->stages(), is_wanted)) return void(guarded([&] { runner_->run_to_stage(name); }));
    move_to([this, is_wanted] {
        const auto last = runner_->last_stage();
        return runner_->passes_in_stage() == 0 && last && is_wanted(runner_->stages()[*last]);
    });
}

void Session::run(const Until& until) {
    playing = false;
    advance(*runner_, until, [this] { moved(); });
}

// What was done before the change is done again: a static lesson answers a slider at once. A long solve goes on from frame to
// frame.
void Session::settle(bool all_was_done) {
    if (!runner_->is_static() || !(all_was_done || playing)) return;
    begin_to([this] { return lesson().at_rest() && !runner_->inside_step(); });
}

// ----------------------------------------------------------------------------------------------------------------- back

void Session::go_back(bool (Runner::*move)(), const std::string& nothing_there) {
    if (put_off([this, move, nothing_there] { go_back(move, nothing_there); })) return;
    playing = false;
    goal_ = nullptr;
    dismiss();
    bool found = true;
    guarded([&] { found = (runner_.get()->*move)(); });
    keep_hand();
    if (!found) say(Message::Kind::info, nothing_there);
    moved();
}

void Session::pass_back() { go_back(&Runner::pass_back, "Nothing before this is stored."); }
void Session::stage_back() { go_back(&Runner::stage_back, "Nothing before this is stored."); }
void Session::step_back() {
    go_back(&Runner::step_back,
            runner_->place() == Place{} ? "This is the beginning." : "Steps before this one are no longer stored.");
}

void Session::go_to(Place place) {
    if (put_off([this, place] { go_to(place); })) return;
    playing = false;
    goal_ = nullptr;
    dismiss();
    inspector.stopped.clear();
    guarded([&] { runner_->go_to(place); });
    seen();
}

void Session::reset() {
    if (put_off([this] { reset(); })) return;
    dismiss();
    guarded([&] { runner_->reset(); });
    begin_run();
}

}  // namespace pliant::viewer
