// The session after a run has broken down.
#include "app/session.h"

#include <fmt/format.h>

#include <algorithm>

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
    if (!autopsy_ || !autopsy_->fix) return;
    if (const Parameter* p = locked_of_fix())
        return say(Message::Kind::refused,
                   fmt::format("{} is locked on this slide: press L to unlock it, or end the walkthrough.", p->info.key));
    Values before, wanted;
    for (const auto& [key, text] : autopsy_->fix->assign) {
        const Parameter& p = lesson().parameter(key);
        before.emplace_back(key, runner_->wanted(p));
        wanted.emplace_back(key, p.parse(text));
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
