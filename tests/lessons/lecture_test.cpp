// Lectures: one file, JSON or Markdown, whose slides bring what they show; a slide that is wrong leaves the others as they are.
#include <pliant/document/share.h>
#include <pliant/lecture/lecture.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

Lecture json(const std::string& slides) {
    return parse_lecture(R"({"pliant_lecture": 1, "title": "T", "slides": [)" + slides + "]}", "l.json");
}

Lecture markdown(const std::string& slides) { return parse_lecture("# T\n" + slides, "l.md"); }

const std::string falls_json = R"(
{"title": "Falls", "minutes": 3, "text": "Words.", "lesson": "mesh/mass_spring", "set": {"cells_x": 6, "ground": false},
 "field": "velocity", "beside": {"damping_mode": "none"}, "ask": "How far?", "do": ["reset", "run 10 steps"],
 "expect": ["step = 10 within 0", "B step = 10 within 0"], "answer": "Far.", "notes": "Look.", "controls": "gravity"})";
const std::string falls_markdown =
    "## Falls\nWords.\n```show\nminutes 3\nlesson mesh/mass_spring\nset cells_x=6\nset ground=false\nfield velocity\nbeside "
    "damping_mode=none\n```\n```ask\nHow far?\n```\n```do\nreset\nrun 10 steps\n```\n```expect\nstep = 10 within 0\nB step = 10 "
    "within 0\n```\n```answer\nFar.\n```\n```notes\nLook.\n```\n```controls\ngravity\n```\n";

std::string words_of(const Slide& s) {
    std::string text = s.title;
    for (const Block& b : s.blocks) text += "|" + std::to_string(static_cast<int>(b.kind)) + b.paragraph();
    return text;
}

}  // namespace

TEST_CASE("lecture: JSON and Markdown say the same") {
    const Lecture a = json(falls_json), b = markdown(falls_markdown);
    for (const Lecture& l : {a, b}) {
        REQUIRE(l.slides.size() == 1);
        const LectureSlide& s = l.slides[0];
        CHECK(s.trouble.empty());
        CHECK(s.minutes == 3);
        CHECK(s.lesson() == "mesh/mass_spring");
        CHECK(s.scene->parameters == Runner::Assignments{{"cells_x", "6"}, {"ground", "false"}});
        CHECK(s.scene->view->field == "velocity");
        CHECK(*s.beside == Runner::Assignments{{"damping_mode", "none"}});
        CHECK(s.slide.notes() == "Look.");
        CHECK(s.slide.allows("gravity"));
        CHECK_FALSE(s.slide.allows("mass"));
        const auto results = played(l, 0);
        REQUIRE(results.size() == 2);
        CHECK(results[0].met);
        CHECK(results[1].met);
        CHECK(results[1].text.starts_with("B "));
    }
    CHECK(words_of(a.slides[0].slide) == words_of(b.slides[0].slide));
}

TEST_CASE("lecture: slides of a deck come by title or number, each up to its place") {
    const Lecture l = json(R"({"deck": "mesh/mass_spring", "slides": ["Landing", 1], "minutes": 4, "notes": "Mine."})");
    REQUIRE(l.slides.size() == 2);
    CHECK(l.slides[0].slide.title == "Landing");
    CHECK(l.slides[0].deck == DeckSlide{"mesh/mass_spring", 1});
    CHECK(l.slides[1].deck->number == 0);
    CHECK(l.minutes() == 4);
    CHECK_THAT(l.slides[0].slide.notes(), ContainsSubstring("Mine."));
    for (const ExpectationResult& r : played(l, 0)) CHECK(r.met);
    const Lecture all = markdown("## All\n```show\ndeck mesh/rod\n```\n");
    CHECK(all.slides.size() == walkthrough_of(find_lesson("mesh/rod")).slides.size());
}

TEST_CASE("lecture: what is not there is told with its place and what is accepted, and the other slides go on") {
    const auto [slide, words] = GENERATE(table<std::string, std::string>(
        {{R"({"title": "x", "lesson": "mesh/mas_spring"})", "mesh/mass_spring"},
         {R"({"title": "x", "lesson": "mesh/rod", "preset": "one_mod"})", "one_mode"},
         {R"({"title": "x", "lesson": "mesh/rod", "set": {"segments": -1}})", "segments"},
         {R"({"title": "x", "lesson": "mesh/rod", "field": "nothing"})", "nothing"},
         {R"({"claim": "E99"})", "E1"},
         {R"({"title": "x", "picture": "not_there.png"})", "not_there.png"},
         {R"({"title": "x", "scene": "not_there.json"})", "not_there.json"},
         {R"({"title": "x", "scene": "pliant1:AAAA"})", "share string"},
         {R"({"title": "x", "scene": {"pliant": 1, "lesson": "mesh/rod", "parameters": {"segment": 2}}})", "segments"},
         {R"({"deck": "mesh/rod", "slides": ["From position to strain"]})", "From positions to strain"},
         {R"({"deck": "mesh/rod", "slides": [99]})", "slides 1 to"},
         {R"({"title": "x", "lessn": 1})", "lesson"},
         {R"({"title": "x", "minutes": 0, "text": "a"})", "above 0"},
         {R"({"title": "x", "preset": "beam"})", "needs 'lesson'"},
         {R"({"title": "x", "claim": "E6", "lesson": "mesh/rod"})", "a slide opens one"},
         {R"({"title": "x", "lesson": "time/integration", "atlas": ["time_step=1:0.1:3", "omega=1:2:3"]})", "time_step"},
         {R"({"title": "x", "lesson": "time/integration", "fill": "everything"})", "picture, plot"},
         {R"({"title": "x", "lesson": "time/integration", "beside": {"scheme": "none"}})", "integrator"},
         {R"({"title": "x", "do": ["reset"]})", "needs 'lesson'"},
         {R"({"text": "no title"})", "title"},
         {R"(17)", "object"}}));
    INFO(slide);
    const Lecture l = json(slide + "," + falls_json);
    REQUIRE(l.slides.size() == 2);
    CHECK_THAT(l.slides[0].trouble, ContainsSubstring("l.json:1:") && ContainsSubstring(words));
    CHECK_THROWS_WITH(played(l, 0), ContainsSubstring(words));
    CHECK(l.slides[1].trouble.empty());
}

TEST_CASE("lecture: what is wrong in a scene of JSON is told where it stands in the file") {
    const Lecture l = json(
        "\n{\"title\": \"x\",\n \"scene\": {\"pliant\": 1, \"lesson\": \"mesh/rod\",\n  \"parameters\": {\"segments\": -2}}}");
    CHECK_THAT(l.slides.at(0).trouble, ContainsSubstring("l.json:4:18: segments = -2") && !ContainsSubstring("l.json:3"));
}

TEST_CASE("lecture: a Markdown slide tells the line of what is wrong") {
    const Lecture l = markdown("## A\n```show\nlesson mesh/rod\nprset x\n```\n## B\nWords.\n");
    CHECK_THAT(l.slides.at(0).trouble, ContainsSubstring("l.md:5: unknown word 'prset'") && ContainsSubstring("preset"));
    CHECK(l.slides.at(1).trouble.empty());
    CHECK_THROWS_WITH(parse_lecture("## A\nWords.\n", "l.md"), ContainsSubstring("no title"));
}

TEST_CASE("lecture: what is no lecture at all is refused") {
    const auto [text, words] =
        GENERATE(table<std::string, std::string>({{"{}", "pliant_lecture"},
                                                  {R"({"pliant_lecture": 2, "title": "T", "slides": [{}]})", "newer"},
                                                  {R"({"pliant_lecture": 1, "title": "T", "slides": []})", "one at least"},
                                                  {R"({"pliant_lecture": 1, "slides": [{}]})", "'title'"},
                                                  {R"({"pliant_lecture": 1, "titel": "T"})", "title"},
                                                  {"{", "JSON"},
                                                  {"", "slide"},
                                                  {"# T\n", "slide"}}));
    INFO(text);
    CHECK_THROWS_WITH(parse_lecture(text, "l.json"), ContainsSubstring("l.json") && ContainsSubstring(words));
    CHECK_THROWS_WITH(read_lecture("soft_body"), ContainsSubstring("did you mean 'soft_bodies'"));
}

TEST_CASE("lecture: a slide that is added reads back, and the rest stays") {
    const std::string path = GENERATE("l.json", "l.md");
    const LectureSlide first = json(falls_json).slides[0];
    const std::string once = with_slide_added("", path, first),
                      twice = with_slide_added(once, path, json(R"({"claim": "E6"})").slides[0]);
    const std::string thrice = with_slide_added(
        twice, path,
        json(R"({"title": "Map", "lesson": "time/integration", "atlas": ["time_step=0.01:1:4:log", "damping_ratio=0:1:3"]})")
            .slides[0]);
    const Lecture l = parse_lecture(thrice, path);
    REQUIRE(l.slides.size() == 3);
    for (const LectureSlide& s : l.slides) CHECK(s.trouble.empty());
    CHECK(words_of(l.slides[0].slide) == words_of(first.slide));
    CHECK(scene_text(*l.slides[0].scene) == scene_text(*first.scene));
    CHECK(l.slides[0].beside == first.beside);
    CHECK(l.slides[1].claim == "E6");
    CHECK(l.slides[2].atlas->first.values.size() == 4);
    if (path == "l.md") CHECK(thrice.starts_with(once));
    CHECK_THROWS_AS(with_slide_added("{}", path, first), Refused);
}

TEST_CASE("lecture: those that come with Pliant take 45 minutes, have notes, and are met") {
    CHECK(lecture_names().size() >= 2);
    for (const std::string& name : lecture_names()) {
        const Lecture l = read_lecture(name);
        INFO(name);
        CHECK(l.minutes() == 45);
        std::vector<std::string> pictures;
        int expectations = 0;
        for (std::size_t n = 0; n < l.slides.size(); ++n) {
            const LectureSlide& s = l.slides[n];
            INFO(s.slide.title);
            CHECK(s.trouble.empty());
            CHECK(s.minutes > 0);
            CHECK_FALSE(s.slide.notes().empty());
            for (const ExpectationResult& r : played(l, n)) {
                INFO(r.text << " (" << r.measured << ")");
                CHECK(r.met);
                ++expectations;
            }
            pictures.push_back("slide_" + std::to_string(n) + ".png");
        }
        CHECK(expectations > 20);
        const std::string page = handout_html(l, pictures);
        std::size_t shared = 0, at = 0;
        while ((at = page.find("<code>pliant1:", at)) != page.npos) {
            const std::size_t end = page.find("</code>", at);
            CHECK_NOTHROW(read_share(page.substr(at + 6, end - at - 6)));
            ++shared, at = end;
        }
        CHECK(shared == static_cast<std::size_t>(
                            std::ranges::count_if(l.slides, [](const LectureSlide& s) { return !s.lesson().empty(); })));
        CHECK_THAT(page, !ContainsSubstring(l.slides[0].slide.notes()));
    }
}
