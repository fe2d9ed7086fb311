// A lab that is left running: what it records, and what a frame draws, do not grow with the run.
#include "app/lab.h"
#include "unseen.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

using namespace pliant;
using namespace pliant::viewer;

namespace {

constexpr std::string_view integrating = "time/integration";

// Corners of all that a frame draws.
int corners_of_a_frame(Lab& lab, Context& context) {
    for (int i = 0; i < 3; ++i) lab.frame(0), context.present();
    return ImGui::GetDrawData()->TotalVtxCount;
}

std::size_t samples_of_plots(const Session& s) {
    std::size_t most = 0;
    for (std::size_t i = 0; i < s.lesson().probes.size(); ++i) most = std::max(most, s.recorder().series(i).size());
    for (const Pin& pin : s.inspector.pins) most = std::max(most, pin.series.size());
    return most;
}

}  // namespace

TEST_CASE("a long run takes no more memory and no more points in a frame than a short one", "[lab]") {
    const auto context = test::open_unseen({1280, 720});
    Lab lab(*context, integrating);
    Session& s = lab.session();
    s.open(find_lesson(integrating), {{"time_step", "1e-5"}});
    s.inspector.pin(s.runner(), s.lesson().fields.front(), 0, -1);
    lab.state().plots.lesson = s.entry().info.id;
    lab.state().plots.picked = true;
    lab.state().plots.chosen = {s.inspector.pins[0].title, std::string(s.lesson().error_probe())};
    for (const bool costs : {false, true}) {
        CAPTURE(costs);
        lab.state().plots.cost_shown = costs;
        s.reset();
        s.run(Until::after_steps(20'000));
        const int after_a_while = corners_of_a_frame(lab, *context);
        s.run(Until::after_steps(200'000));
        const int after_long = corners_of_a_frame(lab, *context);
        CHECK(after_long <= after_a_while + after_a_while / 2);
        CHECK(samples_of_plots(s) <= TimeSeries::most);
        CHECK(s.recorder().series(0).steps().back() == 220'000);
        CHECK(s.recorded_bytes() <= s.recorded_cap());
        CHECK(s.recorded_cap() <= std::size_t{16} << 20);
        CHECK(lab.state().live_error.exact().at.size() <= TimeSeries::most);
        CHECK(lab.state().live_error.bytes() <= lab.state().live_error.cap());
    }
}

TEST_CASE("recording leaves a run as it is", "[lab]") {
    Session s(integrating);
    s.open(find_lesson(integrating), {{"time_step", "1e-4"}});
    s.run(Until::after_steps(50'000));
    Runner alone(find_lesson(integrating), {{"time_step", "1e-4"}}, 0);
    advance(alone, Until::after_steps(50'000));
    CHECK(state_hash(s.lesson()) == state_hash(alone.lesson()));
    // All steps are still there to see: both ends, and the largest swing.
    const TimeSeries& series = s.recorder().series(0);
    CHECK(series.thinned());
    CHECK(series.steps().front() == 0);
    CHECK(series.steps().back() == 50'000);
}

TEST_CASE("the part of a plot that is zoomed to stays dense", "[lab]") {
    Session s(integrating);
    s.open(find_lesson(integrating), {{"time_step", "1e-4"}});
    s.run(Until::after_steps(5'000));
    s.watch(0, Interval{0.1, 0.2});
    s.run(Until::after_steps(60'000));
    for (Index step = 1000; step <= 2000; ++step) REQUIRE(s.recorder().series(0).find(step));
    CHECK_FALSE(s.recorder().series(1).find(1001));
}

TEST_CASE("a finer run is measured against wherever the run has a sample", "[lab]") {
    const auto context = test::open_unseen({1280, 720});
    Lab lab(*context, integrating);
    Session& s = lab.session();
    s.open(find_lesson(integrating), {{"time_step", "1e-3"}});
    s.run(Until::after_steps(40'000));
    LiveError e;
    e.look_at(s.entry(), s.runner(), s.run_count());
    e.advance_reference(s.runner(), s.recorder(), 1e9);
    e.measure(s.runner(), s.recorder(), 1.0);
    REQUIRE(e.finer().latest());
    const auto known = std::ranges::count_if(e.finer().error, [](Real x) { return std::isfinite(x); });
    CHECK(known + 1 == static_cast<Index>(e.finer().at.size()));
    CHECK(e.bytes() <= e.cap());
}
