#include <pliant/run/breakpoints.h>
#include <pliant/run/revisit.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

// Runs on, pass by pass, until a breakpoint stops it or `go_on` (asked behind every whole step) is false. Empty: not stopped by
// one.
std::optional<std::string> run_to_break(Runner& runner, Breakpoints& breakpoints, const std::function<bool()>& go_on) {
    breakpoints.arm(runner);
    while (true) {
        runner.step_pass();
        if (auto reason = breakpoints.stops(runner)) return reason;
        if (!runner.inside_step() && !go_on()) return std::nullopt;
    }
}

bool within(const Runner& runner, Index steps) { return runner.place().step < steps; }

}  // namespace

TEST_CASE("a run stops before a stage") {
    Runner runner(find_lesson("navier_stokes"));
    Breakpoints breaks;
    breaks.stages.insert("projection");
    const auto reason = run_to_break(runner, breaks, [&] { return within(runner, 5); });
    REQUIRE(reason);
    CHECK_THAT(*reason, ContainsSubstring("before projection"));
    CHECK(runner.stages()[runner.next_stage()]->name == "projection");
    CHECK(runner.passes_in_stage() == 0);
    CHECK(runner.place().step == 0);
    // Again: in the next step.
    REQUIRE(run_to_break(runner, breaks, [&] { return within(runner, 5); }));
    CHECK(runner.place().step == 1);
}

TEST_CASE("a run stops after each pass of a loop") {
    Runner runner(find_lesson("navier_stokes"));
    Breakpoints breaks;
    breaks.passes.insert("projection");
    REQUIRE(run_to_break(runner, breaks, [&] { return within(runner, 5); }));
    CHECK(runner.passes_in_stage() == 1);
    REQUIRE(run_to_break(runner, breaks, [&] { return within(runner, 5); }));
    CHECK(runner.passes_in_stage() == 2);
}

TEST_CASE("a run stops when a probe crosses a limit, once") {
    Runner runner(find_lesson("mass_spring"));
    Breakpoints breaks;
    breaks.conditions.push_back(parse_condition("  height<  0.3 ", runner.lesson()));
    const auto reason = run_to_break(runner, breaks, [&] { return within(runner, 2000); });
    REQUIRE(reason);
    CHECK_THAT(*reason, ContainsSubstring("height < 0.3"));
    CHECK(*runner.lesson().probe("height").value() < 0.3);
    const Index stopped = runner.place().step;
    REQUIRE(runner.go_to({stopped, 0}));
    CHECK(*runner.lesson().probe("height").value() >= 0.3);
    runner.step();
    // It holds now, and does not stop the run again while it goes on to hold.
    run_to_break(runner, breaks, [&] { return within(runner, stopped + 10); });
    CHECK(runner.place().step == stopped + 10);
}

TEST_CASE("a run stops when an assumption or a law fails") {
    Runner runner(find_lesson("navier_stokes"), {{"stirring", "20"}, {"time_step", "0.1"}});
    Breakpoints breaks;
    breaks.assumptions = true;
    const auto reason = run_to_break(runner, breaks, [&] { return within(runner, 200); });
    REQUIRE(reason);
    CHECK_THAT(*reason, ContainsSubstring("fails"));
    CHECK(!runner.inside_step());
}

TEST_CASE("without breakpoints a run goes on") {
    Runner runner(find_lesson("navier_stokes"));
    Breakpoints breaks;
    CHECK(!breaks.any());
    CHECK(!run_to_break(runner, breaks, [&] { return within(runner, 3); }));
    CHECK(runner.place() == Place{3, 0});
}

TEST_CASE("conditions that are not understood are refused in words") {
    const Runner runner(find_lesson("navier_stokes"));
    const Lesson& lesson = runner.lesson();
    CHECK_THROWS_MATCHES(parse_condition("max_divergense > 1", lesson), Refused,
                         MessageMatches(ContainsSubstring("max_divergence")));
    for (const char* text : {"", "cfl", "cfl >", "> 3", "cfl > x", "cfl > 1e999", "cfl > 3 s", "cfl >> 3", "cfl = 3"})
        CHECK_THROWS_AS(parse_condition(text, lesson), Refused);
    CHECK(parse_condition("cfl>=-3e-2", lesson) == Condition{"cfl", ">=", -3e-2});
}

TEST_CASE("a run goes back and forward again over what it has run, with the same bits") {
    Runner runner(find_lesson("mass_spring"));
    std::vector<std::uint64_t> hashes;
    for (int k = 0; k < 10; ++k) hashes.push_back(state_hash(runner.lesson())), runner.step();
    runner.step_stage();
    const Place furthest = runner.place();
    REQUIRE(runner.go_to({3, 0}));
    CHECK(state_hash(runner.lesson()) == hashes[3]);
    CHECK(runner.reach() == furthest);
    REQUIRE(runner.go_to({7, 0}));
    CHECK(state_hash(runner.lesson()) == hashes[7]);
    REQUIRE(runner.go_to(furthest));
    CHECK(runner.place() == furthest);
    CHECK(!runner.go_to({furthest.step + 1, 0}));
    // A change in the past is another future.
    REQUIRE(runner.go_to({3, 0}));
    runner.assign("gravity", 1);
    CHECK(runner.reach() == Place{3, 0});
    CHECK(!runner.go_to({7, 0}));
    runner.step();
    CHECK(state_hash(runner.lesson()) != hashes[4]);
}

TEST_CASE("a revisit keeps what was changed since the last step") {
    Runner runner(find_lesson("mass_spring"));
    for (int k = 0; k < 4; ++k) runner.step();
    runner.assign("gravity", 3);
    {
        Revisit revisit(runner);
        REQUIRE(revisit.start_of(2));
        revisit.pass();
        CHECK(runner.lesson().parameter("gravity").value() == 9.81);
        CHECK(!revisit.trace().empty());
    }
    CHECK(runner.place() == Place{4, 0});
    CHECK(runner.lesson().parameter("gravity").value() == 3);
}

TEST_CASE("a trace has each stage's fields before and after") {
    Runner runner(find_lesson("navier_stokes"));
    StepTrace trace;
    runner.trace_to(&trace);
    runner.step();
    runner.run_to_stage("projection");
    const Lesson& lesson = runner.lesson();
    const auto stage = [&](std::string_view name) -> const Stage& {
        return *std::ranges::find(lesson.stages, name, &Stage::name);
    };
    const Stage& projection = stage("projection");
    const auto before = trace.before(lesson, projection, "velocity"), after = trace.after(lesson, projection, "velocity");
    REQUIRE(before.size() == after.size());
    REQUIRE(!before.empty());
    CHECK(!std::equal(before.begin(), before.end(), after.begin()));
    const auto now = lesson.field("velocity").view();
    CHECK(std::equal(after.begin(), after.end(), now.begin()));
    // The stage before it left what the projection found.
    const auto advected = trace.after(lesson, stage("viscosity"), "velocity");
    CHECK(std::equal(before.begin(), before.end(), advected.begin()));
    runner.trace_to(nullptr);
}
