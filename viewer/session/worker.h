// A thread that does the work of the lab, so that its window is never held up: either the worker has the run or the window does,
// never both.
#pragma once
#include <pliant/math/watch.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace pliant::viewer {

class Worker {
public:
    // Where the system has no thread to give, all work is done at once, in the thread that begins it.
    Worker();
    // What is under way is cancelled and waited for.
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    // Only when nothing is under way.
    void begin(std::function<void()> work);
    // Waits for what is under way, so many ms at most: true when it is done, or nothing was. Throws what it threw.
    bool finished(Real wait_ms);
    bool busy() const { return begun_; }
    Real seconds() const { return std::chrono::duration<Real>(Clock::now() - since_).count(); }  // since it began
    Watch& watch() { return watch_; }
    const Watch& watch() const { return watch_; }

private:
    using Clock = std::chrono::steady_clock;
    void run(const std::stop_token& stop);
    void do_work();

    Watch watch_;
    bool begun_ = false;  // of the window's thread alone
    Clock::time_point since_{};

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::function<void()> work_;  // null once it is done
    std::exception_ptr thrown_;
    std::jthread thread_;  // last: it is waited for before the others go
};

// What is told of work that takes long.
struct BusyWords {
    std::string title, line;
};
BusyWords busy_words(const Watch::Progress& progress, Real seconds);

}  // namespace pliant::viewer
