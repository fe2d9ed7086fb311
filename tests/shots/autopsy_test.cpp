// What is said of a run that broke down, and what the fix does.
#include "app/summary.h"
#include "parameters.h"
#include "session/session.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

namespace {

// A number that grows by a factor in each step, up to a bound, and an assumption that fails before it gets there.
class Grower final : public Lesson {
public:
    Number factor{*this, {.key = "factor", .initial = 1, .useful = {0, 10}}};
    Number start{*this, {.key = "start", .unit = "m", .initial = 1, .useful = {0, 10}, .effect = Effect::rebuild}};
    Switch from_start{*this, {.key = "fix_start", .initial = 0}};

    Grower() {
        state = {state_array("x", "m", x_)};
        fields = {{.name = "x", .unit = "m", .view = view_of(x_), .bound = [] { return 100.0; }}};
        stages = {{.name = "grow_up", .run = [this] { x_ *= factor; }, .writes = {"x"}}};
        probes = {{.name = "x", .unit = "m", .value = [this] { return x_[0]; }}};
        assumptions = {{.name = "small_x",
                        .unit = "m",
                        .value = [this] { return x_.maxCoeff(); },
                        .limit = [] { return 20.0; },
                        .formula = "x ≤ 20 m",
                        .broken = "it is too large",
                        .fix =
                            [] {
                                return std::optional(Fix{"x₀ = 0.5 m", {{"start", "0.5"}}});
                            }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return 0.1; }
    void reset() override { x_ = VecX::Constant(3, start), x_[0] = 0; }
    std::string blow_up_hint() const override { return "the factor is above 1"; }
    std::optional<Fix> fix(const Failure&) const override {
        if (from_start) return Fix{"x₀ = 0.1 m, factor 2", {{"start", "0.1"}, {"factor", "2"}}};
        return Fix{"factor 1", {{"factor", "1"}}};
    }
    std::vector<Fix> other_fixes(const Failure&) const override { return {Fix{"factor ½", {{"factor", "0.5"}}}}; }
    void draw(Scene& scene) const override { scene.points.push_back({.at = {position(0, 0)}, .pick = {.pickable = true}}); }

private:
    VecX x_;
};

const LessonEntry grower{{.id = "time/grower", .title = "Grower", .summary = ""},
                         [] { return std::unique_ptr<Lesson>(new Grower); }};

Session growing(const Runner::Assignments& assignments) {
    Session session(lessons().front().info.id);
    session.open(grower, assignments);
    session.playing = true;
    return session;
}

void play(Session& session) {
    for (int frame = 0; frame < 60 && session.playing; ++frame) session.update(0.1, 1e9);
}

}  // namespace

TEST_CASE("an autopsy names stage, element, number, bound and by how much", "[session][autopsy]") {
    Session session = growing({{"factor", "10"}});
    play(session);
    REQUIRE(session.autopsy());
    const Autopsy& a = *session.autopsy();
    CHECK(a.headline == "Stopped in step 3: stage grow up");
    CHECK(a.where == "x of node 1");
    CHECK_THAT(a.against, ContainsSubstring("1 km") || ContainsSubstring("1000 m"));
    CHECK_THAT(a.against, ContainsSubstring("100 m") && ContainsSubstring("10 times the bound"));
    CHECK(a.limit == "the factor is above 1");
    CHECK(a.thing == Thing{On::node, 1});
    CHECK(a.restarts);
    session.pick_failed();
    CHECK(session.inspector.thing == Thing{On::node, 1});
    session.dismiss();
    CHECK_FALSE(session.autopsy());
    CHECK_FALSE(session.message());
}

TEST_CASE("a fix of a blow-up starts again, since what is left is torn, and is undone in one step", "[session][autopsy]") {
    Session session = growing({{"factor", "10"}});
    play(session);
    REQUIRE(session.autopsy());
    REQUIRE(session.runner().place() == Place{2, 0});
    session.mend();
    CHECK_FALSE(session.autopsy());
    CHECK(session.playing);
    CHECK(session.runner().place() == Place{});
    CHECK(wanted(session, "factor") == 1);
    session.step();
    CHECK(session.runner().place().step == 1);
    session.undo();
    CHECK(wanted(session, "factor") == 10);
    CHECK_FALSE(session.can_undo());
}

TEST_CASE("each fix that is recommended can be taken", "[session][autopsy]") {
    Session session = growing({{"factor", "10"}});
    play(session);
    REQUIRE(session.autopsy());
    REQUIRE(session.autopsy()->fixes() == 2);
    CHECK_THAT(session.autopsy()->text(), ContainsSubstring("To mend it: factor 1, or factor ½"));
    session.mend(1);
    CHECK(wanted(session, "factor") == 0.5);
    CHECK(session.runner().place() == Place{});
    session.undo();
    CHECK(wanted(session, "factor") == 10);
}

TEST_CASE("a fix that rebuilds restarts, with all its parameters as one step of undo", "[session][autopsy]") {
    Session session = growing({{"factor", "10"}, {"fix_start", "true"}});
    play(session);
    REQUIRE(session.autopsy());
    CHECK(session.autopsy()->restarts);
    session.mend();
    CHECK(session.runner().place() == Place{});
    CHECK(wanted(session, "start") == 0.1);
    CHECK(wanted(session, "factor") == 2);
    session.undo();
    CHECK(wanted(session, "start") == 1);
    CHECK(wanted(session, "factor") == 10);
    CHECK_FALSE(session.can_undo());
}

TEST_CASE("an assumption that stops the run has an autopsy with its own fix", "[session][autopsy]") {
    Session session = growing({{"factor", "3"}});
    session.inspector.breaks.assumptions = true;
    play(session);
    REQUIRE(session.autopsy());
    CHECK_FALSE(session.message());
    CHECK(session.autopsy()->headline == "Stopped after step 3: the assumption small x fails");
    CHECK_THAT(session.autopsy()->against, ContainsSubstring("27 m") && ContainsSubstring("1.35 times the limit"));
    CHECK(session.autopsy()->limit == "It is too large");
    session.mend();
    CHECK(wanted(session, "start") == 0.5);
    CHECK(session.runner().place() == Place{});
}

TEST_CASE("a fix does not touch what the slide locks", "[session][autopsy]") {
    Session session("mesh/mass_spring");
    session.start_walkthrough();
    REQUIRE(session.walkthrough);
    for (std::size_t n = 0; n < session.walkthrough->walkthrough().slides.size(); ++n) {
        session.go_to_slide(n);
        const Parameter& dt = session.lesson().parameter("time_step");
        if (!session.locked(dt)) continue;
        session.unlocked = true;
        session.assign(session.lesson().parameter("integrator"), 0);
        session.assign(dt, 0.05);
        session.run(Until::after_steps(0));
        for (int k = 0; k < 3000 && !session.autopsy(); ++k) session.step();
        if (!session.autopsy()) continue;
        session.unlocked = false;
        const Real before = wanted(session, "time_step");
        REQUIRE(session.locked_of_fix());
        session.mend();
        CHECK(wanted(session, "time_step") == before);
        REQUIRE(session.message());
        CHECK_THAT(session.message()->text, ContainsSubstring("locked"));
        return;
    }
    SKIP("no slide locks the time step");
}

TEST_CASE("the excess over a bound of zero is told as a difference", "[autopsy]") {
    CHECK(excess(11.6, 1, "", "bound") == "11.6 times the bound");
    CHECK(excess(0.5, 0, "m", "limit") == "500 mm beyond the limit");
}

TEST_CASE("the summary tells what fails, what is picked and the last message", "[session][summary]") {
    LabState lab{{.session = growing({{"factor", "10"}})}};
    CHECK_THAT(summary_of(lab), ContainsSubstring("Lesson Grower.") && ContainsSubstring("No stage has run yet") &&
                                    ContainsSubstring("The assumption small x holds"));
    play(lab.session);
    lab.session.pick_failed();
    const std::string text = summary_of(lab);
    CHECK_THAT(text, ContainsSubstring("Step 2,") && ContainsSubstring("The assumption small x fails") &&
                         ContainsSubstring("5 times the limit"));
    CHECK_THAT(text, ContainsSubstring("Picked: node 1.") && ContainsSubstring("The run is paused."));
    CHECK_THAT(text, ContainsSubstring("Stopped in step 3: stage grow up"));
}
