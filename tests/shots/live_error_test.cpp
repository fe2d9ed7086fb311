// What a run costs and how wrong it is, with costs that are given rather than measured.
#include "session/live_error.h"
#include "session/cost_history.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <limits>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Real endless_ms = 1e9;

// x' = −x by explicit Euler, with or without its closed form and a finer run.
class Decay final : public Lesson {
public:
    Number dt{*this, {.key = "time_step", .symbol = "Δt", .unit = "s", .initial = 0.1, .useful = {1e-4, 1}}};
    Switch closed_form{*this, {.key = "closed_form", .initial = 1}};
    Number parts{*this, {.key = "parts", .initial = 4, .useful = {0, 1000}, .effect = Effect::rebuild}};

    Decay() {
        state = {state_array("x", "m", x_), state_array("t", "s", t_)};
        fields = {{.name = "x", .unit = "m", .view = view_of(x_)}};
        stages = {{.name = "decay", .run = [this] { x_[0] -= dt * x_[0], t_[0] += dt; }, .writes = {"x"}}};
        probes = {{.name = "x",
                   .unit = "m",
                   .value = [this] { return x_[0]; },
                   .exact = [this](Real t) { return closed_form ? std::optional(2 * std::exp(-t)) : std::nullopt; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return dt; }
    void reset() override { x_ = VecX::Constant(1, 2), t_ = VecX::Zero(1); }
    void draw(Scene&) const override {}
    std::vector<std::pair<std::string, std::string>> finer() const override {
        if (parts == 0) return {};
        return {{"time_step", std::to_string(dt / parts)}};
    }

private:
    VecX x_ = VecX::Zero(1), t_ = VecX::Zero(1);
};

const LessonEntry decay{{.id = "time/decay", .title = "Decay", .summary = ""}, [] { return std::unique_ptr<Lesson>(new Decay); }};

struct Run {
    explicit Run(const Runner::Assignments& assignments = {}) : runner(decay, assignments) { recorder.record(runner); }
    void steps(int count) {
        for (int i = 0; i < count; ++i) runner.step(), recorder.record(runner);
    }
    void restart() {
        runner.reset();
        recorder.clear();
        recorder.record(runner);
        ++number;
    }
    void look(LiveError& e, Real step_ms, Real budget_ms = endless_ms) {
        e.look_at(decay, runner, number);
        e.advance_reference(runner, recorder, budget_ms);
        e.measure(runner, recorder, step_ms);
    }
    Runner runner;
    Recorder recorder;
    int number = 1;
};

References found_by(const Run& run) {
    const TimeSeries& series = run.recorder.series(0);
    References found;
    for (std::size_t i = 0; i < series.size(); ++i) found.push_back({series.at()[i], series.values()[i]});
    return found;
}

Real euler(Real dt, int steps) { return 2 * std::pow(1 - dt, steps); }

}  // namespace

TEST_CASE("the cost of a stage is the median of its latest steps", "[session]") {
    CostHistory costs;
    CHECK_FALSE(costs.step_ms());
    for (int i = 1; i <= 20; ++i) costs.record(i, 0.1 * i, std::vector<Real>{2.0, i == 15 ? 500.0 : 3.0});
    REQUIRE(costs.step_ms());
    CHECK(*costs.step_ms() == 5);
    for (const Real ms : costs.stage_ms(1)) CHECK(ms == 3);
    CHECK(costs.places().size() == 20);
    CHECK_THAT(costs.places().back(), WithinAbs(2, 1e-12));
    // It follows what changes for good.
    for (int i = 21; i <= 30; ++i) costs.record(i, 0.1 * i, std::vector<Real>{7.0, 3.0});
    CHECK(costs.stage_ms(0).back() == 7);
    CHECK(*costs.step_ms() == 10);
}

TEST_CASE("the cost forgets the oldest steps, and those that were taken back", "[session]") {
    CostHistory costs;
    const std::vector<Real> ms{1.0, std::numeric_limits<Real>::quiet_NaN()};
    for (int i = 1; i <= 1000; ++i) costs.record(i, i, ms);
    CHECK(costs.places().size() == CostHistory::capacity);
    CHECK(costs.places().front() == 401);
    costs.record(990, 990, ms);
    CHECK(costs.places().back() == 990);
    // A stage that does not run leaves a gap, and costs nothing.
    CHECK(std::isnan(costs.stage_ms(1).back()));
    CHECK(*costs.step_ms() == 1);
    Run run;
    CostHistory of_run;
    for (int i = 0; i < 5; ++i) run.runner.step(), of_run.record(run.runner);
    CHECK(of_run.places().size() == 5);
    run.runner.step_back();
    of_run.record(run.runner);
    CHECK(of_run.places().size() == 4);
}

TEST_CASE("the error from the closed form is relative to its largest value", "[session]") {
    Run run;
    run.steps(10);
    const ErrorSeries e = error_against_exact(run.recorder.series(0));
    REQUIRE(e.latest());
    CHECK_THAT(*e.latest(), WithinRel(std::abs(euler(0.1, 10) - 2 * std::exp(-1)) / 2, 1e-9));
    CHECK(std::isnan(e.error.front()));
}

TEST_CASE("errors from another run are compared at equal times only", "[session]") {
    Run run, other(Runner::Assignments{{"time_step", "0.15"}});
    run.steps(9);
    other.steps(6);
    const ErrorSeries e = error_against(run.recorder.series(0), found_by(other));
    for (std::size_t i = 1; i < e.error.size(); ++i) {
        CAPTURE(i);
        // 0.3, 0.6 and 0.9 s are times of both.
        REQUIRE(std::isfinite(e.error[i]) == (i % 3 == 0));
        if (i % 3 == 0) CHECK_THAT(e.error[i], WithinRel(std::abs(euler(0.1, int(i)) - euler(0.15, int(i) * 2 / 3)) / 2, 1e-9));
    }
}

TEST_CASE("without a closed form the error is measured against a finer run, as far as it got", "[session]") {
    Run run(Runner::Assignments{{"closed_form", "off"}});
    LiveError e;
    run.look(e, 1);
    run.steps(10);
    run.look(e, 1, 0);  // no time: it has not got anywhere
    CHECK_FALSE(e.exact().latest());
    CHECK_FALSE(e.finer().latest());
    run.look(e, 1);
    REQUIRE(e.finer().latest());
    CHECK_THAT(*e.finer().latest(), WithinRel(std::abs(euler(0.1, 10) - euler(0.025, 40)) / 2, 1e-9));
    CHECK_THAT(e.reference(), ContainsSubstring("time step 25 ms"));
    CHECK(e.no_reference().empty());
}

TEST_CASE("a lesson without a finer run says so", "[session]") {
    Run run(Runner::Assignments{{"closed_form", "off"}, {"parts", "0"}});
    LiveError e;
    run.look(e, 1);
    run.steps(3);
    run.look(e, 1);
    CHECK_FALSE(e.now());
    CHECK_THAT(e.no_reference(), ContainsSubstring("no finer run"));
    // One that is refused, too.
    Run refused(Runner::Assignments{{"closed_form", "off"}, {"parts", "0.01"}});
    LiveError other;
    refused.look(other, 1);
    CHECK_THAT(other.no_reference(), ContainsSubstring("refused"));
}

TEST_CASE("the point of a setting stays when a slider moves on", "[session]") {
    Run run;
    LiveError e;
    run.look(e, 3);
    run.steps(10);
    run.look(e, 3);
    REQUIRE(e.now());
    CHECK_THAT(e.now()->cost, WithinRel(30.0, 1e-12));  // 3 ms for 0.1 s
    const Real error = e.now()->error;
    CHECK(e.trail().empty());

    run.runner.assign("time_step", 0.05);
    run.look(e, 3);
    // The rest of this run belongs to no single setting.
    CHECK(e.mixed());
    CHECK_THAT(e.no_reference(), ContainsSubstring("Reset"));
    REQUIRE(e.trail().size() == 1);
    CHECK(e.trail()[0].settings[0] == 0.1);
    CHECK(e.trail()[0].error == error);

    run.restart();
    run.look(e, 3);
    CHECK_FALSE(e.mixed());
    CHECK(e.trail().size() == 1);
    CHECK_FALSE(e.now());
    run.steps(20);
    run.look(e, 3);
    REQUIRE(e.now());
    CHECK_THAT(e.now()->cost, WithinRel(60.0, 1e-12));
    CHECK(e.now()->error < 0.6 * error);

    // The same setting again takes the place of its point; the trail does not grow for ever.
    run.restart();
    run.look(e, 3);
    CHECK(e.trail().size() == 2);
    run.steps(20);
    run.look(e, 4);
    run.restart();
    run.look(e, 4);
    REQUIRE(e.trail().size() == 2);
    CHECK_THAT(e.trail()[1].cost, WithinRel(80.0, 1e-12));
    for (int i = 1; i < 20; ++i) {
        run.runner.assign("time_step", 0.01 * i);
        run.restart();
        run.look(e, 1);
        run.steps(3);
        run.look(e, 1);
    }
    CHECK(e.trail().size() == LiveError::longest_trail);
}
