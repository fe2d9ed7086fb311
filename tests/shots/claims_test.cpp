// Claims as a person goes through them in the lab: predict, measure, open as a scene; and what happens meanwhile.
#include <pliant/math/error.h>
#include <pliant/math/watch.h>

#include "app/lab.h"
#include "app/state_report.h"
#include "app/summary.h"
#include "command_line/options.h"
#include "session/claim_book.h"
#include "waiting.h"
#include "walker.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

#include <atomic>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
using Phase = ClaimBook::Phase;

namespace {

Claim claim_with(std::string_view id, std::function<Finding()> measure) {
    return {.id = std::string(id),
            .lesson = "elasticity/moduli",
            .statement = "It is so.",
            .source = "U",
            .experiment = "It is tried.",
            .figure = "number",
            .criterion = "≤ 1",
            .question = "Is it so?",
            .answers = {"no", "yes"},
            .right_answer = 1,
            .scene = {{"test", "shear"}},
            .measure = std::move(measure)};
}

Finding found() { return {0.5, Verdict::reproduced, "It is so.", ""}; }

// Frames go by until nothing is measured any longer.
bool wait_for(ClaimBook& book) {
    return comes_true([&] {
        book.update();
        return !book.busy();
    });
}

}  // namespace

TEST_CASE("a person predicts, measures, and learns whether that was right", "[session]") {
    const Claim c = claim_with("E90", found);
    ClaimBook book;
    CHECK(book.phase(c) == Phase::asked);
    book.predict(c, 1);
    book.predict(c, 0);  // another mind
    CHECK(book.phase(c) == Phase::predicted);
    CHECK(book.prediction(c) == 0);
    CHECK_FALSE(book.was_right(c));
    CHECK_THROWS_AS(book.predict(c, 2), Refused);
    CHECK_THROWS_AS(book.predict(c, -1), Refused);
    book.measure(c);
    REQUIRE(wait_for(book));
    CHECK(book.phase(c) == Phase::measured);
    CHECK(book.result(c)->finding->figure == 0.5);
    CHECK(book.was_right(c) == false);
    book.predict(c, 1);  // too late
    CHECK(book.prediction(c) == 0);
    book.forget(c);
    CHECK(book.phase(c) == Phase::asked);
    book.predict(c, 1);
    book.measure(c);
    REQUIRE(wait_for(book));
    CHECK(book.was_right(c) == true);
}

TEST_CASE("without a prediction nothing was right or wrong", "[session]") {
    const Claim c = claim_with("E90", found);
    ClaimBook book;
    book.measure_now(c);
    CHECK(book.phase(c) == Phase::measured);
    CHECK_FALSE(book.was_right(c));
}

TEST_CASE("an experiment that fails says so on its card", "[session]") {
    const Claim c = claim_with("E90", []() -> Finding { throw Refused("No mesh."); });
    ClaimBook book;
    book.measure(c);
    REQUIRE(wait_for(book));
    CHECK(book.phase(c) == Phase::failed);
    CHECK_THAT(book.result(c)->failure, ContainsSubstring("E90") && ContainsSubstring("No mesh."));
}

TEST_CASE("experiments are made one after the other, and the lab goes on meanwhile", "[session]") {
    std::atomic<bool> go = false;
    std::atomic<int> at_once = 0, most = 0;
    const auto slow = [&] {
        most = std::max(most.load(), ++at_once);
        go.wait(false);
        --at_once;
        return found();
    };
    const Claim first = claim_with("E90", slow), second = claim_with("E91", slow);
    ClaimBook book;
    book.measure(first);
    book.measure(second);
    book.measure(first);  // once is enough
    Session session = walking();
    session.playing = true;
    for (int frame = 0; frame < 30; ++frame) {
        session.update(1.0 / 60, 1e9);
        book.update();
    }
    session.open_next(1);
    book.update();
    CHECK(session.entry().info.id != "time/walker");
    CHECK(book.phase(first) == Phase::measuring);
    CHECK(book.phase(second) == Phase::waiting);
    book.forget(first);  // not while it is measured
    CHECK(book.phase(first) == Phase::measuring);
    go = true;
    go.notify_all();
    REQUIRE(wait_for(book));
    CHECK(book.phase(first) == Phase::measured);
    CHECK(book.phase(second) == Phase::measured);
    CHECK(most == 1);
}

TEST_CASE("an experiment can be called off, and then stands as it was asked", "[session]") {
    const auto endless = []() -> Finding {
        for (;;) tell_progress("springs", 1, 4);
    };
    const Claim first = claim_with("E90", endless), second = claim_with("E91", found), third = claim_with("E92", found);
    ClaimBook book;
    book.predict(first, 1);
    for (const Claim* c : {&first, &second, &third}) book.measure(*c);
    REQUIRE(comes_true([&] { return book.watch().progress().share() == 0.25; }));
    CHECK(book.phase(second) == Phase::waiting);
    book.cancel(second);
    CHECK(book.phase(second) == Phase::asked);
    book.cancel(first);
    REQUIRE(wait_for(book));
    CHECK(book.phase(first) == Phase::predicted);
    CHECK(book.result(first) == nullptr);
    CHECK(book.phase(third) == Phase::measured);
    CHECK(book.phase(second) == Phase::asked);
    book.measure(first);
    REQUIRE(comes_true([&] { return book.watch().progress().done == 1; }));
    // The lab that closes calls it off.
}

TEST_CASE("a lab that closes waits for the experiment under way and makes no other", "[session]") {
    std::atomic<int> begun = 0, ended = 0;
    std::atomic<bool> closing = false;
    const auto slow = [&] {
        ++begun;
        begun.notify_all();
        closing.wait(false);
        ++ended;
        return found();
    };
    const Claim first = claim_with("E90", slow), second = claim_with("E91", slow);
    {
        ClaimBook book;
        book.measure(first);
        book.measure(second);
        begun.wait(0);
        closing = true;
        closing.notify_all();
    }
    CHECK(begun == 1);
    CHECK(ended == 1);
}

TEST_CASE("a claim opens as a scene of its lesson, and a scene that is refused leaves the session as it was", "[session]") {
    Session session = walking();
    open_as_scene(session, find_claim("E4"));
    CHECK(session.entry().info.id == "elasticity/moduli");
    for (const auto& [key, value] : find_claim("E4").scene) {
        const Parameter& p = session.lesson().parameter(key);
        CHECK(session.runner().wanted(p) == p.parse(value));
    }
    CHECK(session.lesson().at_rest());

    Claim wrong = claim_with("E90", found);
    wrong.scene = {{"poisson_ratio", "7"}};
    open_as_scene(session, wrong);
    REQUIRE(session.message());
    CHECK_THAT(session.message()->text, ContainsSubstring("Poisson's ratio"));
    CHECK(session.runner().wanted(session.lesson().parameter("poisson_ratio")) != 7);
}

TEST_CASE("the lab lists the claims of the open lesson, or of all", "[session]") {
    ClaimBook book;
    const auto here = book.listed("elasticity/moduli");
    REQUIRE(here.size() >= 3);
    CHECK(book.unfolded("elasticity/moduli") == here.front());
    book.unfold(*here[1]);
    CHECK(book.unfolded("elasticity/moduli") == here[1]);
    CHECK(book.listed("time/walker").empty());
    CHECK(book.unfolded("time/walker") == nullptr);
    book.all = true;
    CHECK(book.listed("time/walker").size() == claims().size());
    CHECK(book.unfolded("time/walker") == here[1]);
}

TEST_CASE("the key for claims brings their tab to the front with the keys on the card", "[session]") {
    const auto context = open_headless({1280, 720});
    Lab lab(*context, "elasticity/moduli");
    const auto state_after = [&](int frames) {
        for (int i = 0; i < frames; ++i) lab.frame(1.0 / 60);
        return nlohmann::json::parse(state_json(lab.state()));
    };
    CHECK(state_after(3)["claims"]["shown"] == false);
    lab.perform(Action::claims);
    const auto state = state_after(4);
    CHECK(state["claims"]["shown"] == true);
    CHECK(state["claims"]["unfolded"] == "E3");
    CHECK(state["claims"]["cards"]["E3"]["stage"] == "asked");
    CHECK(state["focus"]["control"] == "claim E3");
    for (const char* control :
         {"claim E3", "claim E4", "claim answer 0", "claims of all", "claim run", "claim scene", "tab claims"})
        CHECK(state["controls"].contains(control));
}

TEST_CASE("the summary tells the claim, and what was measured", "[session]") {
    const auto context = open_headless({1280, 720});
    Lab lab(*context, "elasticity/moduli");
    CHECK_THAT(summary_of(lab.state()), !ContainsSubstring("Claim E3"));
    lab.perform(Action::claims);
    for (int i = 0; i < 4; ++i) lab.frame(1.0 / 60);
    CHECK_THAT(summary_of(lab.state()), ContainsSubstring("Claim E3: Young's modulus") && ContainsSubstring("2: the same.") &&
                                            ContainsSubstring("It is not measured yet."));
    const Claim& c = find_claim("E3");
    lab.state().claims.book.predict(c, 1);
    lab.state().claims.book.measure_now(c);
    CHECK_THAT(summary_of(lab.state()), ContainsSubstring("You chose 2.") && ContainsSubstring("It is reproduced: largest") &&
                                            ContainsSubstring("criterion ≤ 10⁻⁹") && ContainsSubstring("The right answer is 2."));
}

TEST_CASE("the command fails when a claim does", "[session]") {
    const auto refuted = claim_with("E98", [] { return Finding{2, Verdict::refuted, "It is not so.", ""}; });
    CHECK_THROWS_AS(viewer::measure_claims({&refuted}, {.ids = {}, .json = true}), CheckFailed);
    CHECK(viewer::claims({.ids = {"E3"}, .json = true}) == 0);
}
