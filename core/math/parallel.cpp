#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

#if PLIANT_HAVE_TBB
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#endif

#include <atomic>

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

int most_threads() { return oneapi::tbb::info::default_concurrency(); }

void detail::run_in_threads(int count, void (*task)(void*, int), void* data) {
    using namespace oneapi::tbb;
    parallel_for(
        0, count, [task, data](int k) { task(data, k); }, simple_partitioner{});
}

#else

int most_threads() { return 1; }

void detail::run_in_threads(int count, void (*task)(void*, int), void* data) {
    for (int k = 0; k < count; ++k) task(data, k);
}

#endif

}  // namespace pliant
