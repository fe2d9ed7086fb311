// A student at the desk: what waits, what is said, what is noted and handed in.
#include <pliant/document/hand_in.h>

#include "../process/process.h"
#include "app/state_report.h"
#include "app/summary.h"
#include "lab_hand.h"

#include <pliant/text/file.h>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

using namespace pliant;
using namespace pliant::viewer;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Json = nlohmann::json;

namespace {

// In a folder of its own.
class AtDesk : public LabHand {
public:
    explicit AtDesk(std::string_view lesson = "mesh/mass_spring") : LabHand(lesson) { fs::current_path(scratch.folder()); }
    ~AtDesk() { fs::current_path(before_); }
    Json report() { return Json::parse(state_json(state())); }
    void answer(const std::string& name) {
        REQUIRE(state().files.asking());
        state().files.name = name;
        state().files.accept();
        if (state().files.asks_to_replace()) state().files.replace();
        frames(4);
    }
    Scratch scratch;

private:
    fs::path before_ = fs::current_path();
};

}  // namespace

TEST_CASE("a change inside a step is marked as waiting, with both values, until the next one begins", "[desk]") {
    AtDesk desk;
    Session& s = desk.session();
    s.run(Until::after_steps(3));
    s.step_stage();
    desk.frames(2);
    REQUIRE(s.runner().inside_step());
    const Parameter& dt = s.lesson().parameter("time_step");
    const Real before = dt.value();
    s.assign(dt, before / 2);
    desk.frames(3);
    CHECK(s.runner().waits(dt));
    CHECK(desk.state().controls.contains("waiting time_step"));
    CHECK(desk.report()["waiting"]["time_step"]["now"] == dt.text(before));
    CHECK(desk.report()["waiting"]["time_step"]["then"] == dt.text(before / 2));
    CHECK_THAT(summary_of(desk.state()), ContainsSubstring("until the next step begins"));
    s.step();
    desk.frames(3);
    CHECK(s.runner().time_step() == before);
    CHECK(desk.state().controls.contains("waiting time_step"));
    s.step();
    desk.state().controls.clear();
    desk.frames(3);
    CHECK(s.runner().time_step() == before / 2);
    CHECK_FALSE(s.runner().waits(dt));
    CHECK_FALSE(desk.state().controls.contains("waiting time_step"));
    CHECK(desk.report().contains("waiting") == false);
}

TEST_CASE("one number for one step: state, summary, stops, and why", "[desk]") {
    AtDesk desk;
    Session& s = desk.session();
    s.run(Until::after_steps(5));
    CHECK(desk.report()["step_shown"] == 5);
    s.step_stage();
    s.ask({.field = "velocity", .index = 3, .component = 1});
    desk.frames(3);
    CHECK(desk.report()["step_shown"] == 6);
    CHECK_THAT(summary_of(desk.state()), ContainsSubstring("Step 6"));
    REQUIRE(s.inspector.answer);
    const Answer& a = *s.inspector.answer;
    CHECK(desk.report()["inspector"]["answer"]["step"] == step_number(a.when));
    CHECK(step_number(When{5, 2}) == 6);
    CHECK(step_number(When{5, 0}) == 5);
}

TEST_CASE("the summary tells of the second run and the pinned one", "[desk]") {
    AtDesk desk;
    Session& s = desk.session();
    CHECK_THAT(summary_of(desk.state()), !ContainsSubstring("Beside it"));
    s.open_companion({{"time_step", "0.002"}});
    s.run(Until::after_time(0.02));
    desk.frames(2);
    const std::string text = summary_of(desk.state());
    CHECK_THAT(text, ContainsSubstring("Beside it runs B, with time step 2 ms in place of") &&
                         ContainsSubstring("B stands at step 10, time 20 ms") && ContainsSubstring(" in A and ") &&
                         ContainsSubstring("The sliders set"));
}

TEST_CASE("leaving the walkthrough leaves the run as it is", "[desk]") {
    AtDesk desk;
    Session& s = desk.session();
    s.start_walkthrough();
    s.walkthrough_next();
    desk.frames(4);
    REQUIRE(s.walkthrough->revealed());
    s.run(Until::after_steps(7));
    desk.frames(4);
    const Json before = desk.report();
    REQUIRE(before["step"] > 0);
    desk.click("walkthrough");
    desk.frames(6);
    CHECK_FALSE(s.walkthrough);
    for (const char* key : {"step", "passes", "time", "parameters", "probes"}) {
        CAPTURE(key);
        CHECK(desk.report()[key] == before[key]);
    }
}

TEST_CASE("F6 goes from the lessons to the parameters, and the arrows reach their sliders", "[desk]") {
    AtDesk desk;
    desk.state().lesson_list.focus = true;  // in the search, where a text is typed
    desk.frames(3);
    REQUIRE(ImGui::GetIO().WantTextInput);
    const auto focus = [&] { return desk.state().focus ? desk.report()["focus"]["control"].get<std::string>() : ""; };
    desk.press(ImGuiKey_F6);
    desk.frames(3);
    std::vector<std::string> seen{focus()};
    for (int k = 0; k < 6; ++k) desk.press(ImGuiKey_DownArrow), seen.push_back(focus());
    CAPTURE(seen);
    const auto is_parameter = [&](const std::string& control) {
        return std::ranges::any_of(desk.session().lesson().parameters,
                                   [&](const Parameter* p) { return p->info.key == control; });
    };
    CHECK(std::ranges::any_of(seen, is_parameter));
}

TEST_CASE("the picture is noted while its window stays, and the file to hand in is this person's own", "[desk]") {
    AtDesk desk;
    desk.state().hand_in.shown = true;
    desk.frames(3);
    desk.click("hand-in picture");
    desk.frames(8);
    desk.state().controls.clear();
    desk.frames(3);
    CHECK(desk.state().hand_in.shown);
    CHECK(desk.state().controls.contains("hand-in picture"));
    REQUIRE(desk.session().notebook.hand_in().entries.size() == 1);
    CHECK(desk.session().notebook.hand_in().entries[0].kind == HandInEntry::Kind::picture);

    desk.session().notebook.set_name("Ada Lovelace");
    desk.scratch.file("bob.handin.json", hand_in_text({.name = "Bob"}));
    desk.frames(3);
    desk.click("hand-in save");
    desk.frames(3);
    CHECK(desk.state().files.name == "ada_lovelace_mass_spring.handin.json");
    desk.answer("bob.handin.json");
    REQUIRE(desk.state().files.asking());
    CHECK_THAT(desk.state().files.complaint(), ContainsSubstring("Bob"));
    CHECK(read_hand_in(read_file(desk.scratch.path("bob.handin.json")), "").hand_in.name == "Bob");
    desk.answer("mine.handin.json");
    CHECK_FALSE(desk.state().files.asking());
    const std::string mine = desk.scratch.path("mine.handin.json");
    CHECK(read_hand_in(read_file(mine), "").hand_in.name == "Ada Lovelace");
    // It is proposed from now on, to her alone.
    const auto proposed = [&] {
        desk.state().hand_in.wants_save = true;
        desk.frames(3);
        const std::string name = desk.state().files.name;
        desk.state().files.cancel();
        desk.frames(3);
        return name;
    };
    CHECK(fs::path(proposed()).filename() == "mine.handin.json");
    desk.session().notebook.set_name("Eve");
    CHECK(proposed() == "eve_mass_spring.handin.json");
}

TEST_CASE("what a person sets is refused by its name, not by its key", "[desk]") {
    AtDesk desk("fluids/navier_stokes");
    Session& s = desk.session();
    const Parameter& dt = s.lesson().parameter("time_step");
    s.enter(dt, "1e9");
    CHECK_THAT(desk.told(), ContainsSubstring("time step = ") && ContainsSubstring("accepted range"));
    s.enter(dt, "3 kg");
    CHECK_THAT(desk.told(), ContainsSubstring("time step = ") && !ContainsSubstring("time_step"));
    s.assign(dt, 1e9);
    CHECK_THAT(desk.told(), ContainsSubstring("time step = ") && !ContainsSubstring("time_step"));
}
