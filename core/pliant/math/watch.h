// What a long computation tells those who wait for it, and how they call it off.
#pragma once
#include <pliant/math/error.h>
#include <pliant/math/types.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace pliant {

// A computation was called off by the person who waited for it. What it was about is as before it.
struct Cancelled : Error {
    Cancelled() : Error(ExitCode::check_failed, "Called off.") {}
};

// In any thread: who waits looks and cancels; who computes tells and asks.
class Watch {
public:
    Watch() = default;
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    // --- for who waits ---
    // The computation ends at its next cancel_point, once: what is done to leave things in order is not cancelled as well.
    void cancel() { cancel_ = true; }
    bool cancelling() const { return cancel_; }
    // False while what is done can only be finished.
    bool cancellable() const { return cancellable_; }
    struct Progress {
        std::string what{};         // "newton"; "" when nothing was told
        Index done = 0, total = 0;  // total 0: nobody knows
        Real seconds = 0;           // since this part began
        // Of the part that `what` names: 0 to 1, and how long it will take from now at the pace so far, s.
        std::optional<Real> share() const;
        std::optional<Real> seconds_left() const;
    };
    Progress progress() const;

    // --- for who computes, which is done through the functions below ---
    void begin();  // anew
    void tell(std::string_view what, Index done, Index total);
    bool take_cancel() { return cancel_.load(std::memory_order_relaxed) && cancel_.exchange(false); }
    void allow_cancel(bool allowed) { cancellable_ = allowed; }

private:
    using Clock = std::chrono::steady_clock;
    std::atomic<bool> cancel_ = false, cancellable_ = true;
    mutable std::mutex telling_;
    std::string what_;
    Index done_ = 0, total_ = 0;
    Clock::time_point since_{};
};

// While one lives, what this thread computes tells the watch and ends when it is cancelled.
class Watched {
public:
    explicit Watched(Watch& watch);
    ~Watched();
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;

private:
    Watch* const outer_;
};

// While one lives, what this thread computes is not cancelled: left half way, it would stand nowhere.
class Uncancelled {
public:
    Uncancelled();
    ~Uncancelled();
    Uncancelled(const Uncancelled&) = delete;
    Uncancelled& operator=(const Uncancelled&) = delete;
};

// While one lives, whoever waits is told of the whole: what its parts tell is not shown. They can be called off as before.
class Overview {
public:
    Overview(std::string_view what, Index total);
    ~Overview();
    Overview(const Overview&) = delete;
    Overview& operator=(const Overview&) = delete;
    void tell(Index done) const;

private:
    const std::string what_;
    const Index total_;
};

// Between two parts of a long computation, where it can be left: throws Cancelled when that is asked for. Costs nothing to speak
// of. Not to be called in a parallel loop.
void cancel_point();
// So many parts of this many are done (total 0: nobody knows of how many); a cancel_point as well.
void tell_progress(std::string_view what, Index done, Index total = 0);

}  // namespace pliant
