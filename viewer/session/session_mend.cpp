// The session after a run has broken down.
#include "session/session.h"

namespace pliant::viewer {

void Session::tell(const Diverged& divergence) {
    say(Message::Kind::diverged, divergence.what());
    autopsy_ = autopsy_of(*runner_, divergence.failure);
}

void Session::tell_failed_assumption() {
    const auto& failed = inspector.breaks.failed_assumption();
    if (!failed) return;
    dismiss();
    autopsy_ = autopsy_of(*runner_, lesson().assumptions[*failed]);
}

const Parameter* Session::locked_of_fix() const {
    if (!autopsy_ || !autopsy_->fix) return nullptr;
    for (const auto& [key, value] : autopsy_->fix->assign)
        if (const Parameter& p = lesson().parameter(key); locked(p)) return &p;
    return nullptr;
}

void Session::mend() {
    if (put_off([this] { mend(); })) return;
    if (!autopsy_ || !autopsy_->fix) return;
    if (const Parameter* p = locked_of_fix(); p && refuse_locked(*p)) return;
    Values before, wanted;
    for (const auto& [key, text] : autopsy_->fix->assign) {
        const Parameter& p = lesson().parameter(key);
        before.emplace_back(&p, runner_->wanted(p));
        wanted.emplace_back(&p, p.parse(text));
    }
    const bool restarts = autopsy_->restarts;
    if (!set(wanted)) return;
    if (restarts) reset();
    undo_.push_back({std::move(before), false});
    playing = true;
}

void Session::pick_failed() {
    if (autopsy_ && autopsy_->thing) inspector.thing = autopsy_->thing;
}

}  // namespace pliant::viewer
