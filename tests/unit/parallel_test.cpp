// Loops in several threads: every part is done once, and nothing that is computed depends on their number.
#include "fluids_grids.h"

#include <pliant/fluids/advection.h>
#include <pliant/fluids/projection.h>
#include <pliant/math/background.h>
#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

#include <catch2/catch_test_macros.hpp>

#include <atomic>
#include <cmath>
#include <vector>

using namespace pliant;
using namespace pliant::test;

namespace {

// Threads for the length of a test.
class Threads {
public:
    explicit Threads(int count) { set_threads(count); }
    ~Threads() { set_threads(1); }
};

template <int Dim>
FaceField<Dim> flow_after(const StaggeredGridInfo<Dim>& info, const AdvectionSettings& settings, int count) {
    const Threads threads(count);
    const StaggeredGrid<Dim> grid(info);
    SemiLagrangian<Dim> advection(grid, settings);
    PressureProjection<Dim> projection(grid, {1e-7, 100});
    FaceField<Dim> u = random_velocity(grid);
    for (int k = 0; k < 3; ++k) {
        advection.advect(u, 0.8);
        projection.project(u, 0.1);
    }
    return u;
}

template <int Dim>
void same_in_any_number_of_threads(const StaggeredGridInfo<Dim>& info, const AdvectionSettings& settings) {
    const FaceField<Dim> one = flow_after(info, settings, 1);
    for (const int count : {2, 3, 7}) {
        const FaceField<Dim> more = flow_after(info, settings, count);
        INFO(count << " threads");
        for (int a = 0; a < Dim; ++a) CHECK(one[a] == more[a]);
    }
}

}  // namespace

TEST_CASE("every part of a loop is done once, in any number of threads", "[parallel]") {
    for (const int count : {1, 2, 3, 8}) {
        const Threads threads(count);
        std::vector<int> done(100'003, 0);
        std::vector<std::atomic<int>> parts(8);
        std::atomic<bool> out_of_range = false;
        parallel_parts(static_cast<Index>(done.size()), 1, [&](Index first, Index last, int part) {
            if (part < 0 || part >= count) return void(out_of_range = true);
            ++parts[static_cast<std::size_t>(part)];
            for (Index i = first; i < last; ++i) ++done[static_cast<std::size_t>(i)];
        });
        INFO(count << " threads");
        CHECK_FALSE(out_of_range);
        CHECK(std::ranges::all_of(done, [](int n) { return n == 1; }));
        for (std::size_t k = 0; k < parts.size(); ++k) CHECK(parts[k] == (k < static_cast<std::size_t>(count) ? 1 : 0));
    }
    parallel_parts(0, 1, [](Index first, Index last, int) { CHECK(first == last); });
    CHECK_THROWS_AS(set_threads(0), Refused);
}

TEST_CASE("a sum has the same bits in any number of threads", "[parallel]") {
    const VecX numbers = VecX::Random(1'000'001).array() * 1e3;
    const auto sum = [&](int count) {
        const Threads threads(count);
        return parallel_sum(numbers.size(), [&](Index first, Index last) { return numbers.segment(first, last - first).sum(); });
    };
    CHECK(std::abs(sum(1) - numbers.sum()) < 1e-9 * numbers.cwiseAbs().sum());
    for (const int count : {2, 3, 5}) CHECK(sum(1) == sum(count));
    CHECK(parallel_sum(0, [](Index, Index) { return 1.0; }) == 0);
}

TEST_CASE("a flow has the same bits in any number of threads", "[parallel][fluids]") {
    same_in_any_number_of_threads<2>(box<2>({160, 120}, false, 0.1), {});
    same_in_any_number_of_threads<2>(box<2>({129, 131}, true, 0.1), {.mac_cormack = true});
    same_in_any_number_of_threads<3>(box<3>({32, 24, 20}, false, 0.1), {.interpolation = Interpolation::monotone_cubic});
    StaggeredGridInfo<2> info = box<2>({150, 100}, false, 0.1);
    info.types.assign(15000, CellType::fluid);
    for (std::size_t c = 5000; c < 6000; ++c) info.types[c + c / 40 % 60] = CellType::solid;
    same_in_any_number_of_threads<2>(info, {});
}

TEST_CASE("a thread that works beside others keeps its loops to itself", "[parallel]") {
    const Threads three(3);
    {
        const SerialHere serial;
        CHECK(threads() == 1);
        { const SerialHere again; }
        CHECK(threads() == 1);
    }
    CHECK(threads() == 3);
}

TEST_CASE("every job is done once, and its loops stay in its thread", "[parallel]") {
    const Threads three(3);
    std::vector<std::atomic<int>> done(40), inner(40);
    parallel_jobs(40, [&](int k) {
        ++done[static_cast<std::size_t>(k)];
        parallel_parts(1'000'000, 1, [&](Index, Index, int) { ++inner[static_cast<std::size_t>(k)]; });
    });
    CHECK(std::ranges::all_of(done, [](const auto& n) { return n == 1; }));
    CHECK(std::ranges::all_of(inner, [](const auto& n) { return n == 1; }));
    CHECK(threads() == 3);
    CHECK(most_threads() >= 1);
}

TEST_CASE("work in the background gives its result, or what it threw", "[parallel]") {
    Background<int> seven([](const std::stop_token&) { return 7; });
    CHECK(seven.take() == 7);
    CHECK_FALSE(seven.done());
    Background<int> refused([](const std::stop_token&) -> int { throw Refused("No mesh."); });
    CHECK_THROWS_AS(refused.take(), Refused);
}

TEST_CASE("work in the background goes on until it is done, asked to stop, or its owner goes", "[parallel]") {
    std::atomic<bool> go = false, ended = false;
    Background<bool> waits([&](const std::stop_token&) {
        go.wait(false);
        return true;
    });
    CHECK_FALSE(waits.done());
    go = true;
    go.notify_all();
    CHECK(waits.take());

    const auto until_stopped = [&](const std::stop_token& stop) {
        while (!stop.stop_requested()) std::this_thread::yield();
        ended = true;
        return false;
    };
    Background<bool> endless(until_stopped);
    CHECK_FALSE(endless.done());
    endless.ask_to_stop();
    CHECK_FALSE(endless.take());
    CHECK(ended.exchange(false));
    { const Background<bool> left(until_stopped); }
    CHECK(ended);
}
