#include "session/worker.h"

#include <system_error>
#include <utility>

namespace pliant::viewer {

Worker::Worker() {
    try {
        thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    } catch (const std::system_error&) {
        // begin() does the work itself.
    }
}

Worker::~Worker() { watch_.cancel(); }

void Worker::do_work() {
    const Watched watched(watch_);
    try {
        work_();
    } catch (...) {
        thrown_ = std::current_exception();
    }
}

void Worker::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return work_ != nullptr; })) {
        lock.unlock();
        do_work();
        lock.lock();
        work_ = nullptr;
        changed_.notify_all();
    }
}

void Worker::begin(std::function<void()> work) {
    begun_ = true;
    since_ = Clock::now();
    watch_.begin();
    {
        const std::scoped_lock lock(mutex_);
        thrown_ = nullptr;
        work_ = std::move(work);
    }
    changed_.notify_all();
    if (thread_.joinable()) return;
    do_work();
    work_ = nullptr;
}

bool Worker::finished(Real wait_ms) {
    if (!begun_) return true;
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, std::chrono::duration<Real, std::milli>(wait_ms), [this] { return work_ == nullptr; }))
        return false;
    begun_ = false;
    if (const auto thrown = std::exchange(thrown_, nullptr)) std::rethrow_exception(thrown);
    return true;
}

}  // namespace pliant::viewer
