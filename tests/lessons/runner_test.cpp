// The runner on the bead chain, whose exact motion is known.
#include <pliant/document/report.h>
#include <pliant/run/recorder.h>
#include <pliant/run/revisit.h>
#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

const LessonEntry& chain() { return find_lesson("time/bead_chain"); }

Real error_at_one_second(const char* dt) {
    Runner runner(chain(), {{"time_step", dt}});
    advance(runner, Until::after_time(1));
    const Probe& middle = runner.lesson().probe("middle");
    return std::abs(*runner.value(middle) - *runner.exact(middle));
}

// A lesson made to fail: its second stage writes a number that is not finite in step 4.
class Failing final : public Lesson {
    Switch infinite{*this, {.key = "infinite", .initial = 1}};
    VecX x = VecX::Zero(3);

public:
    Failing() {
        state = {state_array("x", "m", x)};
        fields = {{.name = "x", .unit = "m", .view = view_of(x), .bound = [] { return 100.0; }}};
        stages = {{.name = "move", .run = [this] { x.array() += 1; }, .writes = {"x"}},
                  {.name = "fail",
                   .run =
                       [this] {
                           if (x[1] == 4) x[1] = infinite ? HUGE_VAL : 1000;
                       },
                   .writes = {"x"}}};
    }
    int dimension() const override { return 2; }
    void reset() override { x.setZero(); }
    Real time_step() const override { return 0.5; }
    void draw(Scene&) const override {}
    std::string blow_up_hint() const override { return "lower it"; }
};
const LessonEntry failing{{.id = "time/failing", .title = "Failing", .summary = ""},
                          [] { return std::unique_ptr<Lesson>(new Failing); }};

// Counts passes: stages a, b and c, where b takes three passes and c sends the loop back to b twice.
class Looping final : public Lesson {
public:
    VecX trace = VecX::Zero(1);
    int passes = 0, rounds = 0;
    std::string log;
    Looping() {
        state = {state_array("trace", "", trace)};
        fields = {{.name = "trace", .view = view_of(trace)}};
        stages = {{.name = "a",
                   .run =
                       [this] {
                           log += "a";
                           rounds = 0;
                       },
                   .writes = {"trace"}},
                  {.name = "b",
                   .run =
                       [this] {
                           log += "b";
                           ++passes;
                       },
                   .writes = {"trace"},
                   .again = [this] { return passes < 3; },
                   .begin =
                       [this] {
                           log += "(";
                           passes = 0;
                       },
                   .end = [this] { log += ")"; }},
                  {.name = "c",
                   .run =
                       [this] {
                           log += "c";
                           ++rounds;
                       },
                   .writes = {"trace"},
                   .again = [this] { return rounds < 2; },
                   .loop_from = "b"}};
    }
    int dimension() const override { return 2; }
    void reset() override { trace.setZero(), log.clear(); }
    Real time_step() const override { return 0; }
    void draw(Scene&) const override {}
};
const LessonEntry looping{{.id = "time/looping", .title = "Looping", .summary = ""},
                          [] { return std::unique_ptr<Lesson>(new Looping); }};

// Three stages that note their names, forward or backward; `middle` left out of the order comes last.
class Ordered final : public Lesson {
    Choice<int> order{*this,
                      {.key = "order", .effect = Effect::rebuild},
                      {{"forward", "forward"}, {"backward", "backward"}, {"middle_last", "the middle last"}}};
    VecX x = VecX::Zero(1);

public:
    std::string log;
    Ordered() {
        state = {state_array("x", "", x)};
        fields = {{.name = "x", .view = view_of(x)}};
        for (const std::string_view name : {"first", "middle", "last"})
            stages.push_back({.name = name, .run = [this, name] { log += name[0], x[0] += 1; }, .writes = {"x"}});
        stages[1].again = [this] { return log.size() % 2 == 0; };
    }
    int dimension() const override { return 2; }
    std::vector<std::string_view> stage_order() const override {
        if (order == 1) return {"last", "middle", "first"};
        if (order == 2) return {"first", "last"};
        return {};
    }
    void reset() override { x.setZero(), log.clear(); }
    Real time_step() const override { return 1; }
    void draw(Scene&) const override {}
};
const LessonEntry ordered{{.id = "time/ordered", .title = "Ordered", .summary = ""},
                          [] { return std::unique_ptr<Lesson>(new Ordered); }};

}  // namespace

TEST_CASE("runner: stages run in the order that the lesson names, and none of them moves") {
    Runner runner(ordered);
    StepTrace trace;
    runner.trace_to(&trace);
    const auto& log = static_cast<const Ordered&>(runner.lesson()).log;
    const Stage *first = &runner.lesson().stages[0], *middle = &runner.lesson().stages[1], *last = &runner.lesson().stages[2];
    using Order = std::vector<const Stage*>;
    CHECK(runner.stages() == Order{first, middle, last});
    runner.step();
    CHECK(log == "fmml");

    // After a reset for another order the stages are where they were, by name, and with their costs.
    runner.assign({{"order", "backward"}});
    CHECK(runner.stages() == Order{last, middle, first});
    CHECK(std::vector<std::string_view>{first->name, middle->name, last->name} ==
          std::vector<std::string_view>{"first", "middle", "last"});
    CHECK(runner.cost(*middle).runs == 0);
    runner.step();
    CHECK(log == "lmmf");
    CHECK(runner.cost(*middle).passes == 2);
    CHECK(runner.cost(*last).passes == 1);
    REQUIRE(runner.executed_before().size() == 3);
    CHECK(runner.executed_before().front().stage == last);
    CHECK(trace.after(runner.lesson(), *last, "x")[0] == 1);
    CHECK(trace.after(runner.lesson(), *middle, "x")[0] == 3);
    CHECK(trace.after(runner.lesson(), *first, "x")[0] == 4);

    runner.assign({{"order", "middle_last"}});
    CHECK(runner.stages() == Order{first, last, middle});
    runner.step();
    CHECK(log == "flm");
    // The past of one order is gone over again in the same one.
    runner.step();
    REQUIRE(runner.step_back());
    CHECK(runner.stages() == Order{first, last, middle});
}

TEST_CASE("runner: the bead chain converges to its normal mode at first order") {
    const Real coarse = error_at_one_second("0.01"), middle = error_at_one_second("0.005"), fine = error_at_one_second("0.0025");
    CHECK(std::log2(coarse / middle) == Catch::Approx(1).margin(0.1));
    CHECK(std::log2(middle / fine) == Catch::Approx(1).margin(0.05));
}

TEST_CASE("runner: the clock counts steps") {
    Runner runner(chain(), {{"time_step", "1e-6"}}, 0);
    advance(runner, Until::after_steps(100000));
    CHECK(std::abs(runner.time() - 0.1) < 1e-9);
    // A new time step starts a new count from there.
    runner.assign("time_step", 0.01);
    runner.step();
    CHECK(runner.time() == Catch::Approx(0.11).epsilon(1e-12));
}

TEST_CASE("runner: a time that is no multiple of the step is rounded to the nearest") {
    Runner runner(chain(), {{"time_step", "0.1"}});
    advance(runner, Until::after_time(0.26));
    CHECK(runner.place().step == 3);
    CHECK_THROWS_AS(advance(runner, Until::after_time(-1)), Refused);
    CHECK_THROWS_AS(advance(runner, Until::after_time(std::nan(""))), Refused);
    CHECK_THROWS_AS(advance(runner, Until::after_steps(-1)), Refused);
}

TEST_CASE("runner: stages run in order and can be stopped after") {
    Runner runner(chain());
    CHECK_FALSE(runner.inside_step());
    runner.step_stage();
    CHECK(runner.inside_step());
    CHECK(runner.stages()[*runner.last_stage()]->name == "force");
    CHECK(runner.stages()[runner.next_stage()]->name == "kick");
    runner.run_to_stage("drift");
    CHECK(runner.place() == Place{1, 0});
    CHECK_THROWS_WITH(runner.run_to_stage("drft"), ContainsSubstring("drift"));
}

TEST_CASE("runner: inner loops by pass, begin and end, and loops over several stages") {
    Runner runner(looping);
    const auto& log = static_cast<const Looping&>(runner.lesson()).log;
    runner.step_pass();
    CHECK(log == "a");
    runner.step_pass();
    CHECK(log == "a(b");
    CHECK(runner.passes_in_stage() == 1);
    runner.step_stage();
    CHECK(log == "a(bbb)");
    runner.step();
    CHECK(log == "a(bbb)c(bbb)c");
    CHECK(runner.place() == Place{1, 0});
    CHECK(runner.cost(runner.lesson().stages[1]).runs == 2);
    CHECK(runner.cost(runner.lesson().stages[1]).passes == 6);
}

TEST_CASE("runner: a live parameter waits for the next step; a rebuild one resets") {
    Runner runner(chain());
    runner.step_stage();
    runner.assign("stiffness", 400);
    CHECK(runner.lesson().parameter("stiffness").value() == 100);
    CHECK(runner.wanted(runner.lesson().parameter("stiffness")) == 400);
    runner.step();
    runner.step_stage();
    CHECK(runner.lesson().parameter("stiffness").value() == 400);
    runner.assign("amplitude", 0.2);
    CHECK(runner.place() == Place{});
    CHECK(*runner.value(runner.lesson().probe("middle")) > 0.19);
    CHECK_THROWS_WITH(runner.assign("stiffnes", 1), ContainsSubstring("'stiffness'"));
    CHECK_THROWS_AS(runner.assign("mass", -1), Refused);
    CHECK(runner.lesson().parameter("mass").value() == 1);
    // What waits counts in the run that begins next, whoever begins it.
    runner.step_stage();
    runner.assign("stiffness", 150);
    runner.reset();
    CHECK(runner.lesson().parameter("stiffness").value() == 150);
    runner.step_stage();
    runner.assign("stiffness", 250);
    runner.assign("amplitude", 0.3);
    CHECK(runner.place() == Place{});
    CHECK(runner.lesson().parameter("stiffness").value() == 250);
}

TEST_CASE("runner: stepping back past a change brings back what was before it, and forgets the future") {
    Runner runner(chain());
    runner.step();
    const auto at_one = state_hash(runner.lesson());
    runner.assign("stiffness", 900);
    runner.step();
    REQUIRE(runner.step_back());
    CHECK(state_hash(runner.lesson()) == at_one);
    CHECK(runner.lesson().parameter("stiffness").value() == 900);
    REQUIRE(runner.step_back());
    CHECK(runner.lesson().parameter("stiffness").value() == 100);
    CHECK_FALSE(runner.step_back());
}

TEST_CASE("runner: a step back inside a step keeps the stages that are done; a step has one number everywhere") {
    Runner runner(looping);  // a, then b three times and c, twice over: 9 passes
    runner.step(), runner.step();
    CHECK(place_words(runner.place()) == "step 2");
    for (int pass = 0; pass < 3; ++pass) runner.step_pass();
    CHECK(runner.place() == Place{2, 3});
    CHECK(place_words(runner.place()) == "step 3, 3 passes done");
    REQUIRE(runner.step_back());
    CHECK(runner.place() == Place{1, 3});
    CHECK(runner.passes_in_stage() == 2);
    REQUIRE(runner.step_back());
    CHECK(runner.place() == Place{0, 3});
    REQUIRE(runner.step_back());
    CHECK(runner.place() == Place{});
    CHECK_FALSE(runner.step_back());
    // By stages: what was done before stays.
    runner.step_pass(), runner.step_pass();
    CHECK(place_words(runner.place()) == "step 1, 2 passes done");
    REQUIRE(runner.stage_back());
    CHECK(runner.place() == Place{0, 1});
}

TEST_CASE("runner: the ring of stored states keeps its cap") {
    Runner small(chain(), {}, 20000);
    for (int i = 0; i < 200; ++i) small.step();
    CHECK(small.history().bytes() <= 20000);
    CHECK(small.history().size() > 5);
    CHECK_FALSE(small.go_to({3, 0}));
    CHECK(small.place().step == 200);
    CHECK(small.step_back());
    CHECK(small.place().step == 199);
}

TEST_CASE("runner: what is not finite, or beyond its bound, is named; the last good state stays") {
    for (const bool infinite : {true, false}) {
        Runner runner(failing, {{"infinite", infinite ? "true" : "false"}}, infinite ? 0 : 1 << 20);
        for (int i = 0; i < 3; ++i) runner.step();
        try {
            runner.step();
            FAIL("it went on");
        } catch (const Diverged& e) {
            CHECK(e.failure.stage == "fail");
            CHECK(e.failure.field == "x");
            CHECK(e.failure.index == 1);
            CHECK(e.failure.step == 4);
            CHECK(e.failure.time == 2);
            CHECK(e.failure.limit == "lower it");
        }
        CHECK(runner.place() == Place{3, 0});
        REQUIRE(runner.failure());
        CHECK(std::ranges::all_of(runner.lesson().fields[0].view(), [](Real x) { return x == 3; }));
    }
}

TEST_CASE("runner: events happen at the start of their step") {
    Runner with(chain()), without(chain());
    with.set_events({{.step = 5, .assign = {{"stiffness", "300"}}}});
    for (int i = 0; i < 5; ++i) with.step(), without.step();
    CHECK(state_hash(with.lesson()) == state_hash(without.lesson()));
    with.step(), without.step();
    CHECK(state_hash(with.lesson()) != state_hash(without.lesson()));
    CHECK_THROWS_AS(with.set_events({{.step = 1, .assign = {{"nonsense", "3"}}}}), Refused);
}

TEST_CASE("runner: a conserved quantity is watched while it should hold") {
    Runner runner(chain());
    for (int i = 0; i < 300; ++i) runner.step();
    CHECK(runner.holds(0) == Holds::yes);
    // Beyond Δt = 2/ω the highest mode grows, first by rounding alone.
    Runner unstable(chain(), {{"time_step", "0.25"}});
    for (int i = 0; i < 30 && unstable.holds(0) == Holds::yes; ++i) unstable.step();
    CHECK(unstable.holds(0) == Holds::no);
    CHECK(unstable.lesson().assumptions[0].value() > unstable.lesson().assumptions[0].limit());
}

namespace {

// A sound state with one probe that is not a number, and a law for it.
class Undefined final : public Lesson {
    VecX x = VecX::Zero(1);

public:
    Undefined() {
        state = {state_array("x", "m", x)};
        stages = {{.name = "move", .run = [this] { x[0] += 1; }}};
        probes = {{.name = "sound", .value = [this] { return x[0]; }},
                  {.name = "ratio", .value = [this] { return (x[0] - 2) / (x[0] - 2); }},
                  {.name = "exact", .value = [] { return 1.0; }, .exact = [this](Real) { return std::log(1 - x[0]); }}};
        lines = {{.name = "lost", .sample = [](Curve&) { throw Diverged(Failure{}); }}, {.name = "kept", .sample = [](Curve& c) {
                                                                                             c = {{1}, {2}};
                                                                                         }}};
        for (const Law law : {Law::constant, Law::never_grows, Law::zero})
            conserved.push_back({.probe = "ratio", .law = law, .tolerance = [] { return 10.0; }});
    }
    int dimension() const override { return 2; }
    void reset() override { x.setZero(); }
    Real time_step() const override { return 1; }
    void draw(Scene&) const override {}
};
const LessonEntry undefined{{.id = "time/undefined", .title = "Undefined", .summary = ""},
                            [] { return std::unique_ptr<Lesson>(new Undefined); }};

}  // namespace

TEST_CASE("report: a number that is not finite is undefined, and takes no other along") {
    Runner runner(undefined);
    CHECK_NOTHROW(runner.check_probes());
    runner.step(), runner.step();
    CHECK_THROWS_AS(runner.check_probes(), Diverged);
    for (std::size_t law = 0; law < 3; ++law) CHECK(runner.holds(law) == Holds::no);
    const auto report = nlohmann::json::parse(run_json(runner, {}));
    CHECK(report["probes"]["sound"]["value"] == 2);
    CHECK(report["probes"]["ratio"]["value"].is_null());
    CHECK(report["probes"]["exact"]["exact"].is_null());
    CHECK(report["conserved"]["ratio"]["status"] == "violated");
    CHECK(report["lines"]["lost"]["value"].empty());
    CHECK(report["lines"]["kept"]["value"].size() == 1);
    CHECK_THAT(run_text(runner), ContainsSubstring("sound") && ContainsSubstring("undefined"));
}

TEST_CASE("recorder: one row per step, replaced after stepping back") {
    Runner runner(chain());
    Recorder recorder;
    recorder.record(runner);
    for (int i = 0; i < 4; ++i) runner.step(), recorder.record(runner);
    CHECK(recorder.series(0).steps().size() == 5);
    runner.step_back(), runner.step_back();
    recorder.record(runner);
    CHECK(recorder.series(0).steps().back() == 2);
    const std::string csv = recorder.csv(runner.lesson());
    CHECK(csv.starts_with("step,time [s],energy [J],middle [m],middle exact [m]\n0,0,"));
    CHECK(std::ranges::count(csv, '\n') == 4);
}

TEST_CASE("recorder: a million steps take no more than its cap, and leave the run as it is", "[slow]") {
    constexpr int million = 1'000'000;
    Runner recorded(chain(), {}, 0), alone(chain(), {}, 0);
    Recorder recorder;
    recorder.record(recorded);
    Real low = *recorded.value(recorded.lesson().probes[0]), high = low;
    for (int i = 0; i < million; ++i) {
        recorded.step(), alone.step();
        recorder.record(recorded);
        const Real energy = *recorded.value(recorded.lesson().probes[0]);
        low = std::min(low, energy), high = std::max(high, energy);
    }
    CHECK(recorder.bytes() <= recorder.cap());
    CHECK(recorder.cap() <= std::size_t{2} << 20);
    CHECK(state_hash(recorded.lesson()) == state_hash(alone.lesson()));
    const TimeSeries& energy = recorder.series(0);
    CHECK(energy.steps().back() == million);
    CHECK(std::ranges::min(energy.values()) == low);
    CHECK(std::ranges::max(energy.values()) == high);
}

TEST_CASE("runner: parameters are set by themselves as by their names, to the bit") {
    Runner by_name(chain()), by_number(chain());
    const Parameter& dt = by_number.lesson().parameter("time_step");
    const Real value = Real{1} / 300;
    by_name.assign({{"time_step", dt.text(value)}}), by_number.assign_values({{&dt, value}});
    for (int i = 0; i < 20; ++i) by_name.step(), by_number.step();
    CHECK(state_hash(by_name.lesson()) == state_hash(by_number.lesson()));
    CHECK_THROWS_AS(by_number.assign_values({{&dt, -1}}), Refused);
    CHECK_THROWS_AS(by_number.assign_values({{&dt, std::nan("")}}), Refused);
    CHECK(dt.value() == value);
    CHECK_THROWS_AS(by_number.assign_values({{&by_name.lesson().parameter("time_step"), value}}), std::logic_error);
}

TEST_CASE("runner: its revision tells whether a picture may have changed") {
    Runner runner(chain());
    long last = runner.revision();
    const auto changed = [&] { return std::exchange(last, runner.revision()) != last; };
    CHECK_FALSE(changed());
    runner.step_pass();
    CHECK(changed());
    runner.step();
    CHECK(changed());
    runner.assign("time_step", 0.01);
    CHECK(changed());
    runner.step_back();
    CHECK(changed());
    runner.reset();
    CHECK(changed());
    runner.load({});
    CHECK(changed());
    runner.step(), runner.step(), changed();
    // A look back brings back the same bits.
    {
        Revisit revisit(runner);
        REQUIRE(revisit.start_of(0));
        revisit.pass();
    }
    CHECK_FALSE(changed());
}
