// A lecture in the lab: its slides come up in the deck with what they show, and what is on the screen goes into one.
#include "app/lab.h"

#include "../process/process.h"
#include "platform/pdf_file.h"
#include "platform/png_file.h"

#include <pliant/lecture/lecture.h>
#include <pliant/text/file.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::viewer;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;

namespace {

class Hall {
public:
    Hall() { lab.state().scene.hints_shown = false, frames(3); }
    void frames(int count) {
        for (int i = 0; i < count; ++i) lab.frame(0.01), context->present();
    }
    void press(Action action) {
        lab.state().wanted.push_back(action);
        frames(2);
    }
    // Until nothing is measured or mapped any more.
    void wait() {
        while (lab.state().claims.book.busy() || lab.state().atlas.atlas.busy()) frames(1);
        frames(2);
    }
    // Controls that are gone stay in the list, so it is made anew.
    bool shows(const std::string& control) {
        lab.state().controls.clear();
        frames(1);
        return lab.state().controls.contains(control);
    }
    Session& session() { return lab.session(); }

    Scratch scratch;
    std::unique_ptr<Context> context = open_headless({1280, 720});
    Lab lab{*context, "elasticity/moduli"};
};

const char* const five = R"({"pliant_lecture": 1, "title": "Five", "slides": [
  {"title": "Words", "text": "Nothing but words.", "notes": "Smile."},
  {"title": "Two runs", "lesson": "mesh/mass_spring", "set": {"scene": "spin"}, "beside": {"damping_mode": "naive"},
   "do": ["run 5 steps"], "expect": ["step = 5 within 0"], "answer": "Five.", "controls": "mass"},
  {"deck": "mesh/rod", "slides": [2]},
  {"claim": "E1"},
  {"title": "Map", "lesson": "time/integration", "atlas": ["time_step=0.01:1:8:log", "damping_ratio=0:1:8"]},
  {"title": "Not there", "lesson": "mesh/nothing", "text": "These words are shown."}]})";

}  // namespace

TEST_CASE("a lecture goes through its slides, forward and back", "[lab][lecture]") {
    Hall h;
    h.lab.open_lecture(parse_lecture(five, "five.json"));
    h.frames(3);
    CHECK(h.lab.in_deck());
    CHECK(h.session().slide_count() == 6);
    CHECK(h.session().slide_after()->title == "Two runs");
    CHECK_FALSE(h.shows("scene"));

    h.press(Action::walkthrough_next);
    CHECK(h.session().slide_number() == 1);
    CHECK(h.session().companion() != nullptr);
    CHECK(h.shows("scene"));
    CHECK(h.shows("mass"));
    CHECK_FALSE(h.shows("gravity"));
    CHECK_FALSE(h.session().walkthrough->revealed());
    h.press(Action::walkthrough_next);
    CHECK(h.session().walkthrough->revealed());
    CHECK(h.session().runner().place().step == 5);
    CHECK(h.session().companion()->runner().place().step == 5);

    h.press(Action::walkthrough_next);
    CHECK(h.session().entry().info.id == "mesh/rod");
    CHECK(h.session().walkthrough->slide().title == walkthrough_of(find_lesson("mesh/rod")).slides[1].title);
    h.press(Action::walkthrough_back);
    CHECK(h.session().slide_number() == 1);
    CHECK(h.session().runner().place().step == 0);
    CHECK(h.session().companion() != nullptr);
    h.press(Action::last_slide);
    CHECK(h.session().slide_number() == 5);
    CHECK_THAT(h.session().walkthrough->slide().blocks.back().paragraph(), ContainsSubstring("mesh/nothing"));
    h.press(Action::walkthrough_next);
    CHECK_THAT(h.session().message()->text, ContainsSubstring("last slide"));
}

TEST_CASE("a lecture keeps what was predicted on a slide that is left", "[lab][lecture]") {
    Hall h;
    h.lab.open_lecture(parse_lecture(R"({"pliant_lecture": 1, "title": "Two", "slides": [
        {"deck": "mesh/mass_spring", "slides": ["Landing"]}, {"title": "Words", "text": "Nothing but words."}]})",
                                     "two.json"));
    h.frames(3);
    REQUIRE(h.session().walkthrough->prediction());
    h.session().predict({.option = 1u});
    h.session().go_to_slide(1);
    h.session().go_to_slide(0);
    CHECK(h.session().walkthrough->guess().option == 1u);
    CHECK_FALSE(h.session().walkthrough->revealed());
}

TEST_CASE("next measures a claim and makes a map before it goes on", "[lab][lecture]") {
    Hall h;
    h.lab.open_lecture(parse_lecture(five, "five.json"), 3);
    h.frames(3);
    CHECK(h.shows("claim answer 0"));
    h.press(Action::walkthrough_next);
    h.wait();
    CHECK(h.session().slide_number() == 3);
    CHECK(h.lab.state().claims.book.result(find_claim("E1")) != nullptr);
    h.press(Action::walkthrough_next);
    CHECK(h.session().slide_number() == 4);
    h.press(Action::walkthrough_next);
    h.wait();
    REQUIRE(h.lab.state().atlas.atlas.map());
    CHECK(h.lab.state().atlas.atlas.map()->columns() == 8);
    CHECK(h.lab.state().atlas.atlas.map()->order.across.key == "time_step");
    CHECK(h.shows("atlas map"));
}

TEST_CASE("another lesson ends a lecture, and the lab shows its slide beside the run", "[lab][lecture]") {
    Hall h;
    h.lab.open_lecture(parse_lecture(five, "five.json"), 1);
    h.frames(3);
    h.press(Action::leave_deck);
    CHECK(h.lab.state().layout == Layout::lab);
    CHECK(h.session().lecture());
    CHECK(h.shows("walkthrough next"));
    h.press(Action::deck);
    CHECK(h.lab.in_deck());
    h.session().open(find_lesson("mesh/rod"));
    h.frames(2);
    CHECK_FALSE(h.session().lecture());
    CHECK(h.lab.state().layout == Layout::lab);
}

TEST_CASE("what is on the screen goes into a lecture, which is made where it is missing", "[lab][lecture]") {
    Hall h;
    const std::string file = (h.scratch.folder() / "mine.json").string();
    h.session().assign_together({{"poisson_ratio", 0.4}});
    h.press(Action::add_scene);
    REQUIRE(h.lab.state().files.asking());
    h.lab.state().files.name = file;
    h.lab.state().files.accept();
    h.frames(3);
    CHECK_THAT(h.session().message()->text, ContainsSubstring("slide 1 of mine.json"));
    h.session().start_walkthrough();
    h.session().go_to_slide(2);
    h.press(Action::add_slide);
    h.lab.state().side_wanted = SideTab::claims;
    h.frames(2);
    h.press(Action::add_claim);
    const Lecture made = read_lecture(file);
    REQUIRE(made.slides.size() == 3);
    CHECK(made.slides[0].scene->parameters == Runner::Assignments{{"poisson_ratio", "0.4"}});
    CHECK(made.slides[1].deck == DeckSlide{"elasticity/moduli", 2});
    CHECK(made.slides[2].claim == "E3");
    h.lab.drop_file(file);
    h.frames(3);
    CHECK(h.session().lecture());
    CHECK(h.session().runner().lesson().parameter("poisson_ratio").value() == 0.4);
    CHECK(h.session().slide_count() == 3);
    h.press(Action::add_scene);
    CHECK(h.session().slide_count() == 4);  // the lecture that is shown has it at once
}

TEST_CASE("a picture of a lecture is shown, and one that is no PNG is told", "[lab][lecture]") {
    Hall h;
    Image red{.width = 40, .height = 20, .rgb = {}};
    for (int i = 0; i < 800; ++i) red.rgb.insert(red.rgb.end(), {255, 0, 0});
    write_png(red, h.scratch.folder() / "red.png");
    const std::string text = R"({"pliant_lecture": 1, "title": "T", "slides": [{"title": "Red", "picture": "red.png"}]})";
    h.lab.open_lecture(parse_lecture(text, (h.scratch.folder() / "l.json").string()));
    h.frames(3);
    const Rectangle r = h.lab.state().controls.at("slide picture");
    CHECK(std::abs(r.width - 2 * r.height) < 2);
    h.lab.frame(0);
    const Image seen = read_pixels(*h.context);
    const auto* pixel = seen.row(static_cast<int>(r.y + r.height / 2)).data() + 3 * static_cast<int>(r.x + r.width / 2);
    CHECK(pixel[0] > 250);
    CHECK(pixel[1] < 5);
}

TEST_CASE("pages of a PDF file", "[pdf]") {
    const auto made = [](int pages) {
        PdfFile pdf("Three");
        for (int i = 0; i < pages; ++i) pdf.add_page({.width = 16, .height = 9, .rgb = std::vector<std::uint8_t>(432, 99)});
        return pdf.bytes();
    };
    const std::string three = made(3);
    CHECK(three.starts_with("%PDF-"));
    CHECK_THAT(three,
               ContainsSubstring("/Count 3") && ContainsSubstring("%%EOF") && ContainsSubstring("/MediaBox [ 0 0 960 540"));
    CHECK(three == made(3));
    CHECK_THROWS_AS(made(0), Refused);
}
