#include <pliant/math/watch.h>

namespace pliant {
namespace {
thread_local Watch* watch_of_thread = nullptr;
thread_local int uncancelled = 0, overviews = 0;

void tell_cancellable() {
    if (watch_of_thread) watch_of_thread->allow_cancel(uncancelled == 0);
}
}  // namespace

std::optional<Real> Watch::Progress::share() const {
    return total > 0 ? std::optional(static_cast<Real>(done) / static_cast<Real>(total)) : std::nullopt;
}

std::optional<Real> Watch::Progress::seconds_left() const {
    if (total <= 0 || done <= 0) return std::nullopt;
    return seconds * static_cast<Real>(total - done) / static_cast<Real>(done);
}

Watch::Progress Watch::progress() const {
    const std::scoped_lock lock(telling_);
    return {what_, done_, total_, std::chrono::duration<Real>(Clock::now() - since_).count()};
}

void Watch::begin() {
    const std::scoped_lock lock(telling_);
    cancel_ = false;
    what_.clear();
    done_ = total_ = 0;
    since_ = Clock::now();
}

void Watch::tell(std::string_view what, Index done, Index total) {
    const std::scoped_lock lock(telling_);
    if (what != what_ || done < done_) since_ = Clock::now();
    what_ = what;
    done_ = done, total_ = total;
}

Watched::Watched(Watch& watch) : outer_(watch_of_thread) {
    watch_of_thread = &watch;
    tell_cancellable();
}
Watched::~Watched() { watch_of_thread = outer_; }

Uncancelled::Uncancelled() {
    ++uncancelled;
    tell_cancellable();
}
Uncancelled::~Uncancelled() {
    --uncancelled;
    tell_cancellable();
}

Overview::Overview(std::string_view what, Index total) : what_(what), total_(total) { ++overviews; }
Overview::~Overview() { --overviews; }

void Overview::tell(Index done) const {
    if (watch_of_thread && overviews == 1) watch_of_thread->tell(what_, done, total_);
}

void cancel_point() {
    if (watch_of_thread && uncancelled == 0 && watch_of_thread->take_cancel()) throw Cancelled();
}

void tell_progress(std::string_view what, Index done, Index total) {
    if (!watch_of_thread) return;
    if (overviews == 0) watch_of_thread->tell(what, done, total);
    cancel_point();
}

}  // namespace pliant
