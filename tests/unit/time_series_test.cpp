// A number that is recorded for as long as a run goes on.
#include <pliant/run/time_series.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

using namespace pliant;

namespace {

constexpr Index last_step = 1'000'000;
constexpr Real step_length = 1e-5;

// An oscillation with a spike, a dip and a moment at which it is not defined.
constexpr Index spike_at = 123'457, dip_at = 700'001, undefined_at = 345'678;
Real sample_of(Index step) {
    if (step == undefined_at) return TimeSeries::undefined;
    return std::sin(1e-3 * static_cast<Real>(step)) + (step == spike_at ? 40 : step == dip_at ? -30 : 0);
}

TimeSeries series_of(Index steps, bool has_exact = false) {
    TimeSeries series(has_exact);
    for (Index step = 0; step <= steps; ++step)
        series.add(step, step_length * static_cast<Real>(step), sample_of(step), 2 * std::cos(1e-3 * static_cast<Real>(step)));
    return series;
}

}  // namespace

TEST_CASE("a series keeps its cap over a million steps, and its ends and extremes") {
    for (const bool has_exact : {false, true}) {
        const TimeSeries series = series_of(last_step, has_exact);
        CHECK(series.size() <= TimeSeries::most);
        CHECK(series.size() >= TimeSeries::most / 4);
        CHECK(series.bytes() <= series.cap());
        CHECK(series.thinned());
        CHECK(series.steps().front() == 0);
        CHECK(series.steps().back() == last_step);
        CHECK(std::ranges::is_sorted(series.steps()));
        const auto kept = [&](Index step) { return series.values()[series.find(step).value()]; };
        CHECK(kept(spike_at) == sample_of(spike_at));
        CHECK(kept(dip_at) == sample_of(dip_at));
        CHECK(std::isnan(kept(undefined_at)));
        for (std::size_t i = 0; i < series.size(); ++i)
            if (series.steps()[i] != undefined_at) REQUIRE(series.values()[i] == sample_of(series.steps()[i]));
    }
}

TEST_CASE("a series draws the same envelope as all samples would") {
    const TimeSeries series = series_of(last_step);
    constexpr Index block = 4096;
    for (Index begin = 0; begin + block <= last_step; begin += block) {
        CAPTURE(begin);
        Real low = HUGE_VAL, high = -HUGE_VAL, low_kept = HUGE_VAL, high_kept = -HUGE_VAL;
        for (Index step = begin; step < begin + block; ++step)
            if (const Real x = sample_of(step); std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
        for (std::size_t i = 0; i < series.size(); ++i)
            if (const Real x = series.values()[i]; series.steps()[i] / block == begin / block && std::isfinite(x))
                low_kept = std::min(low_kept, x), high_kept = std::max(high_kept, x);
        REQUIRE(low == low_kept);
        REQUIRE(high == high_kept);
    }
}

TEST_CASE("a short run is kept whole, and the latest steps of a long one are dense") {
    CHECK(series_of(10'000).size() == 10'001);
    CHECK_FALSE(series_of(10'000).thinned());
    const TimeSeries series = series_of(last_step);
    for (Index step = last_step - 100; step <= last_step; ++step) CHECK(series.find(step));
}

TEST_CASE("what is on the screen stays dense while the run goes on") {
    TimeSeries series;
    const auto go_on = [&](Index from, Index to) {
        for (Index step = from; step < to; ++step) series.add(step, step_length * static_cast<Real>(step), sample_of(step));
    };
    go_on(0, 10'000);
    series.watch(Interval{0.02, 0.05});  // steps 2000 to 5000
    go_on(10'000, last_step);
    for (Index step = 2000; step <= 5000; ++step) REQUIRE(series.find(step));
    CHECK_FALSE(series.find(1001));
    CHECK(series.bytes() <= series.cap());
    // A part too large for that is thinned out too.
    series.watch(Interval{0, 10});
    go_on(last_step, last_step + 50'000);
    CHECK(series.size() <= TimeSeries::most);
    // Once nobody looks, it goes as well.
    series.watch(std::nullopt);
    go_on(last_step + 50'000, last_step + 200'000);
    CHECK_FALSE(series.find(3001));
    CHECK(series.find(spike_at));
}

TEST_CASE("a series goes back: later steps are forgotten and added anew") {
    TimeSeries series = series_of(last_step);
    series.add(500'000, 5, -1);
    CHECK(series.steps().back() == 500'000);
    CHECK(series.values().back() == -1);
    CHECK(series.find(spike_at));
    CHECK_FALSE(series.find(dip_at));
    series.clear();
    CHECK(series.empty());
    series.add(0, 0, 1);
    CHECK(series.size() == 1);
    CHECK_FALSE(series.thinned());
}

TEST_CASE("the scale of an exact value counts samples that are no longer kept") {
    TimeSeries series(true);
    for (Index step = 0; step <= last_step; ++step) {
        const Real exact = std::exp(1e-5 * static_cast<Real>(step)) * std::sin(0.1 * static_cast<Real>(step));
        series.add(step, static_cast<Real>(step), exact, exact);
    }
    Real largest = 0;
    std::size_t i = 0;
    for (Index step = 0; step <= last_step; ++step) {
        largest = std::max(largest, std::abs(std::exp(1e-5 * static_cast<Real>(step)) * std::sin(0.1 * static_cast<Real>(step))));
        if (i < series.size() && series.steps()[i] == step) REQUIRE(series.scale()[i++] == largest);
    }
    CHECK(i == series.size());
}

TEST_CASE("series make a table with a row for each step that any of them keeps") {
    TimeSeries a, b(true);
    a.add(0, 0, 1), a.add(1, 0.5, 2);
    b.add(1, 0.5, 3, 4), b.add(2, 1, TimeSeries::undefined, 5);
    CHECK(csv_rows({&a, &b}, true) == "0,0,1,,\n1,0.5,2,3,4\n2,1,,,5\n");
    CHECK(csv_rows({&a}, false) == "0,0,1\n1,0,2\n");
    CHECK(csv_column("energy", "J") == "energy [J]");
    CHECK(csv_column("count", "") == "count");
}
