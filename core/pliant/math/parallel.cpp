#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

#if PLIANT_HAVE_TBB
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <ctime>

namespace pliant {
namespace {
std::atomic<int> allowed{1};
thread_local int serial = 0;
}  // namespace

void set_threads(int count) {
    if (count < 1) throw Refused("threads", count, "", "at least 1");
    allowed = count;
}

int threads() { return serial ? 1 : allowed.load(); }

SerialHere::SerialHere() { ++serial; }
SerialHere::~SerialHere() { --serial; }

#if PLIANT_HAVE_TBB
namespace {

#ifdef CLOCK_THREAD_CPUTIME_ID

Real seconds_on(clockid_t clock) {
    timespec t;
    clock_gettime(clock, &t);
    return static_cast<Real>(t.tv_sec) + Real{1e-9} * static_cast<Real>(t.tv_nsec);
}

// Where other programs keep the cores busy, one thread is soon without a core in the middle of its part, and all others wait for
// it. A thread whose loops leave it waiting keeps them to itself for a while, and then tries again: how long they take depends on
// that, what they compute does not.
class Crowding {
public:
    bool found() {
        if (until_ > 0 && seconds_on(CLOCK_MONOTONIC) >= until_) until_ = 0;
        return until_ > 0;
    }

    template <class Loop>
    void watch(const Loop& loop) {
        if (++loops_ % watched != 0) return loop();  // the clock of a thread is not read for nothing
        const Real begin = seconds_on(CLOCK_MONOTONIC), used = seconds_on(CLOCK_THREAD_CPUTIME_ID);
        loop();
        const Real end = seconds_on(CLOCK_MONOTONIC);
        passed_ += end - begin;
        used_ += seconds_on(CLOCK_THREAD_CPUTIME_ID) - used;
        if (passed_ < enough_to_tell) return;
        const bool crowded = used_ < share_of_a_core * passed_;
        pause_ = crowded ? std::clamp(2 * pause_, shortest_pause, longest_pause) : forgetting * pause_;
        if (crowded) until_ = end + pause_;
        passed_ = used_ = 0;
    }

private:
    static constexpr Real enough_to_tell = 0.001, shortest_pause = 0.02, longest_pause = 0.64;  // s
    static constexpr Real share_of_a_core = 0.85;                                               // of a thread that is not held up
    static constexpr Real forgetting = 0.9;                                                     // of the pause, when it is not

    static constexpr unsigned watched = 4;  // every so many loops one is

    unsigned loops_ = 0;
    Real passed_ = 0, used_ = 0;  // s, in loops that were watched, and of these on a core
    Real pause_ = 0, until_ = 0;
};

#else  // a system that does not tell

class Crowding {
public:
    bool found() const { return false; }
    template <class Loop>
    void watch(const Loop& loop) {
        loop();
    }
};

#endif

}  // namespace

int most_threads() { return oneapi::tbb::info::default_concurrency(); }

void detail::run_jobs(int count, void (*job)(void*, int), void* data) {
    using namespace oneapi::tbb;
    parallel_for(
        0, count, [job, data](int k) { job(data, k); }, simple_partitioner{});
}

void detail::run_parts(int count, void (*part)(void*, int), void* data) {
    thread_local Crowding crowding;
    if (!crowding.found()) return crowding.watch([&] { run_jobs(count, part, data); });
    for (int k = 0; k < count; ++k) part(data, k);
}

#else

int most_threads() { return 1; }

void detail::run_jobs(int count, void (*job)(void*, int), void* data) {
    for (int k = 0; k < count; ++k) job(data, k);
}

void detail::run_parts(int count, void (*part)(void*, int), void* data) { run_jobs(count, part, data); }

#endif

}  // namespace pliant
