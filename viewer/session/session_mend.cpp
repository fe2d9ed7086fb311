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

const Parameter* Session::locked_of_fix(std::size_t which) const {
    if (!autopsy_ || which >= autopsy_->fixes()) return nullptr;
    for (const auto& [key, value] : autopsy_->fix_at(which).assign)
        if (const Parameter& p = lesson().parameter(key); locked(p)) return &p;
    return nullptr;
}

void Session::mend(std::size_t which) {
    if (put_off([this, which] { mend(which); })) return;
    if (!autopsy_ || which >= autopsy_->fixes()) return;
    if (const Parameter* p = locked_of_fix(which); p && refuse_locked(*p)) return;
    Values before, wanted;
    for (const auto& [key, text] : autopsy_->fix_at(which).assign) {
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
