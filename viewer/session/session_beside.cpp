// The session with a run pinned behind the present one, and with a second one beside it.
#include "session/session.h"

#include "render/ghost.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {

// ------------------------------------------------------------------------------------------------------- recorded

void Session::watch(std::size_t probe, const std::optional<Interval>& part) {
    recorder_.watch(probe, part);
    if (companion_) companion_->watch(probe, part);
}

std::size_t Session::recorded_bytes() const {
    std::size_t sum = recorder_.bytes();
    if (companion_) sum += companion_->recorder().bytes();
    if (pinned_) sum += pinned_->recorder.bytes();
    for (const Pin& pin : inspector.pins) sum += pin.series.bytes();
    return sum;
}

std::size_t Session::recorded_cap() const {
    std::size_t sum = recorder_.cap();
    if (companion_) sum += companion_->recorder().cap();
    if (pinned_) sum += pinned_->recorder.cap();
    for (const Pin& pin : inspector.pins) sum += pin.series.cap();
    return sum;
}

// --------------------------------------------------------------------------------------------------------- pinned

void Session::toggle_pin() {
    if (put_off([this] { toggle_pin(); })) return;
    if (pinned_) {
        pinned_.reset();
    } else {
        Scene ghost = ghost_of(scene());
        pinned_ = Pinned{std::move(ghost),      recorder_,       settings_of(*runner_),
                         runner_->place().step, runner_->time(), {run_of(*runner_), colours.field, colours.component}};
    }
    ++pin_count_;
}

// ------------------------------------------------------------------------------------------------------ two at once

void Session::open_companion(const Runner::Assignments& changes) {
    make_companion(changes);
    start_both();
}

void Session::make_companion(const Runner::Assignments& changes) {
    if (walkthrough && !lecture_)
        throw Refused("A second run is not made while a walkthrough plays: end the walkthrough, then press 2.");
    companion_ = std::make_unique<Companion>(*entry_, *runner_, changes);
    ++companion_count_;
}

void Session::beside_to_now(const Runner::Assignments& changes) {
    const Index steps = runner_->place().step;
    const auto& done = runner_->recording().events();
    const bool repeats = std::ranges::all_of(done, [](const Event& e) { return e.step == 0; });
    if (repeats && steps > 0) return run_beside_to_a(changes);
    open_companion(changes);
    if (steps > 0)
        say(Message::Kind::info, "A was changed on its way: both run again from the start, under what the sliders say now.");
    if (runner_->is_static()) return begin_to([this] { return lesson().at_rest() && !runner_->inside_step(); });
    if (steps == 0) return;
    begin_to([this, steps] { return runner_->place().step >= steps; });
}

// A does what it does from its start on, so that B alone has to run.
void Session::run_beside_to_a(const Runner::Assignments& changes) {
    playing = false;
    goal_ = nullptr;
    dismiss();
    make_companion(changes);
    range.forget();
    if (!sliced) companion_->follow(*runner_);
    view_changed();
}

std::optional<Real> Session::catching_up() const {
    if (!companion_ || !companion_->stopped().empty() || !companion_->far_behind(*runner_)) return std::nullopt;
    const Runner& b = companion_->runner();
    const Real share = runner_->is_static() ? static_cast<Real>(b.place().step) / static_cast<Real>(runner_->place().step)
                                            : b.time() / runner_->time();
    return std::clamp(share, Real{0}, Real{1});
}

void Session::close_companion() {
    if (put_off([this] { close_companion(); })) return;
    if (!companion_) return;
    companion_.reset();
    addresses_b_ = difference_ = false;
    std::erase_if(undo_, [](const Undo& u) { return u.beside; });
    range.forget();
    view_changed();
}

void Session::toggle_companion() {
    if (put_off([this] { toggle_companion(); })) return;
    if (companion_) return close_companion();
    // A that plays goes on when B has come to it.
    const bool plays = playing;
    guarded([&] { runner_->place().step > 0 ? beside_to_now({}) : open_companion(); });
    playing = plays;
}

void Session::address(bool b) { addresses_b_ = b && companion_; }

// From the start, so that both have run for the same time under what the sliders say.
void Session::start_both() {
    dismiss();
    guarded([&] { runner_->reset(); });
    begin_run();
}

bool Session::set_beside(const Parameter& parameter, Real value) {
    const bool rebuilds = parameter.info.effect == Effect::rebuild;
    if (!guarded([&] { companion_->assign(parameter, value); })) return false;
    if (rebuilds && lesson().dimension() == 2) camera.reset();
    if (rebuilds) return start_both(), true;
    if (!sliced) companion_->follow(*runner_);
    view_changed();
    return true;
}

// ------------------------------------------------------------------------------------------------------- difference

bool Session::has_difference() const {
    const Field* a = lesson().find_field(colours.field);
    const Field* b = companion_ ? companion_->lesson().find_field(colours.field) : nullptr;
    return a && b && a->in_use() && b->in_use() && a->view().size() == b->view().size() && !catching_up();
}

void Session::show_difference(bool on) {
    if (put_off([this, on] { show_difference(on); })) return;
    if (on && !has_difference())
        return say(Message::Kind::info,
                   !companion_ ? "There is one run only: press 2 for a second one."
                   : catching_up()
                       ? "B is still catching up with A: their difference can be shown once both are of one time."
                       : "The two runs hold the field that is shown in different sizes: there is no difference to show.");
    difference_ = on;
    range.forget();
    view_changed();
}

// Of a scalar or a component A − B; of a vector or tensor as a whole the length of A − B.
std::vector<Real> Session::difference() const {
    const Field field = lesson().field(colours.field);
    const auto a = field.view(), b = companion_->lesson().field(colours.field).view();
    std::vector<Real> numbers(a.begin(), a.end()), rows;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] -= b[i];
    Field of_difference = field;
    of_difference.view = view_of(numbers);
    row_values(of_difference, colours.component, rows);
    return rows;
}

}  // namespace pliant::viewer
