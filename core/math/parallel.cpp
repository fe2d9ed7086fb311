#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

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

namespace detail {

void run_in_threads(int count, void (*task)(void*, int), void* data) {
#pragma omp parallel for schedule(static, 1) num_threads(count)
    for (int k = 0; k < count; ++k) task(data, k);
}

}  // namespace detail
}  // namespace pliant
