// Loops over cells, and jobs, in several threads. What they compute does not depend on how many there are. The threads are
// those of oneTBB: they sleep while there is nothing to do, and whoever is free takes the next part, so that a thread that gets
// no core holds nobody up.
#pragma once
#include <pliant/math/types.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace pliant {

// How many threads long loops may use; 1 at first. Throws Refused for less than 1.
void set_threads(int count);
int threads();  // 1 where SerialHere says so

// How many can work at once: one on each core; without oneTBB a single one, whatever is asked for.
int most_threads();

// While one lives, loops of this thread run in it alone: it is one of several that each do work of their own.
class SerialHere {
public:
    SerialHere();
    ~SerialHere();
    SerialHere(const SerialHere&) = delete;
    SerialHere& operator=(const SerialHere&) = delete;
};

namespace detail {
// job(data, k) for every k below count, in any order, as many at once as there are threads. The jobs must not throw.
void run_jobs(int count, void (*job)(void*, int), void* data);
// The same for the parts of a loop, of which there may be thousands a second: one after the other while no core is free for them.
void run_parts(int count, void (*part)(void*, int), void* data);

constexpr Index least_work = 8192;  // numbers, below which a second thread costs more than it saves
}  // namespace detail

// job(k) for every k below count, as many at once as there are threads. Loops in a job stay in its thread. It must not throw.
template <class Job>
void parallel_jobs(int count, Job&& job) {
    const auto run = [](void* data, int k) {
        const SerialHere serial;
        (*static_cast<std::remove_reference_t<Job>*>(data))(k);
    };
    detail::run_jobs(count, run, &job);
}

// body(first, last, part) over consecutive parts of [0, count), one for each thread that is allowed; a single part where
// count · work, the numbers that are touched, is small. No two of them have the same number at once, so that each may have a
// buffer of its own. They must not write to the same places, and not throw.
template <class Body>
void parallel_parts(Index count, Index work, Body&& body) {
    const auto parts = static_cast<int>(count * work < detail::least_work ? 1 : std::min<Index>(threads(), count));
    if (parts <= 1) return body(Index{0}, count, 0);
    struct Task {
        Body& body;
        Index count;
        int parts;
    } task{body, count, parts};
    const auto run = [](void* data, int k) {
        const Task& t = *static_cast<Task*>(data);
        t.body(t.count * k / t.parts, t.count * (k + 1) / t.parts, k);
    };
    detail::run_parts(parts, run, &task);
}

// part(first, last) over pieces of [0, count) that depend on count alone, put together in their order: ((start ∘ a) ∘ b) ∘ …
template <class Part, class Join>
Real parallel_reduction(Index count, Real start, Part&& part, Join&& join) {
    constexpr Index most_pieces = 256, least_piece = 2048;
    const Index piece = std::max(least_piece, (count + most_pieces - 1) / most_pieces), pieces = (count + piece - 1) / piece;
    std::array<Real, most_pieces> found;
    parallel_parts(pieces, piece, [&](Index first, Index last, int) {
        for (Index k = first; k < last; ++k)
            found[static_cast<std::size_t>(k)] = part(k * piece, std::min(count, (k + 1) * piece));
    });
    Real whole = start;
    for (Index k = 0; k < pieces; ++k) whole = join(whole, found[static_cast<std::size_t>(k)]);
    return whole;
}

template <class Part>
Real parallel_sum(Index count, Part&& part) {
    return parallel_reduction(count, 0, part, [](Real a, Real b) { return a + b; });
}

template <class Vector>
Real parallel_dot(const Vector& x, const Vector& y) {
    return parallel_sum(
        x.size(), [&](Index first, Index last) { return x.segment(first, last - first).dot(y.segment(first, last - first)); });
}

// Σ x².
template <class Vector>
Real parallel_square(const Vector& x) {
    return parallel_dot(x, x);
}

// Largest magnitude.
template <class Vector>
Real parallel_max_norm(const Vector& x) {
    const auto part = [&](Index first, Index last) { return x.segment(first, last - first).cwiseAbs().maxCoeff(); };
    return parallel_reduction(x.size(), 0, part, [](Real a, Real b) { return std::max(a, b); });
}

}  // namespace pliant
