// A lecture on the command line: its outline, its check, its pictures.
#include "pliant.h"

using namespace pliant::test;

namespace {

const std::string good =
    "# Mine\n## Words\nSome.\n## A rod\n```show\nlesson mesh/rod\nminutes 2\n```\n```do\nrun 3 steps\n```\n"
    "```expect\nstep = 3 within 0\n```\n```answer\nThree.\n```\n";
const std::string missed = "## Missed\n```show\nlesson mesh/rod\n```\n```expect\nstep = 4 within 0\n```\n";
const std::string wrong = "## Wrong\n```show\nlesson mesh/rodd\n```\n";

Arguments lecture(const std::string& file, Arguments more = {}) {
    more.insert(more.begin(), {"lecture", file});
    return more;
}

}  // namespace

TEST_CASE("a lecture tells its slides and minutes, and one that comes with Pliant needs no file", "[process]") {
    const std::string text = output_of(lecture("soft_bodies"));
    CHECK(contains(text, "45 min planned"));
    CHECK(contains(text, "claim E6"));
    CHECK(contains(text, "stability map of time/integration"));
    CHECK(contains(text, "mesh/mass_spring, two runs"));
}

TEST_CASE("a lecture is checked: 0 when all is met, 1 when not, 2 when a slide cannot be shown", "[process]") {
    const Scratch scratch;
    const auto checked = [&](const std::string& text) { return call(lecture(scratch.file("l.md", text), {"--check"})); };
    CHECK(checked(good).exit_code == 0);
    const Outcome one = checked(good + missed), two = checked(good + wrong + missed);
    CHECK(one.exit_code == 1);
    CHECK(contains(one.err, "l.md:23: step = 4"));
    CHECK(two.exit_code == 2);
    CHECK(contains(two.err, "l.md:20: no lesson is called 'mesh/rodd' (did you mean 'mesh/rod'?)"));
    CHECK(contains(two.out, "Missed: misses what it expects"));
    CHECK(contains(two.out, "4 slides: 1 expectation met, 1 missed; 1 cannot be shown"));
}

TEST_CASE("a lecture becomes pictures, a PDF file and a handout with share strings that open", "[process]") {
    const Scratch scratch;
    const std::string folder = scratch.path("out");
    const Arguments small{"--out", folder, "--size", "640x360"};
    REQUIRE(call(lecture(scratch.file("l.md", good + wrong), small)).exit_code == 0);
    CHECK(contents_of(folder + "/slide_02.png").starts_with("\x89PNG"));
    CHECK(fs::exists(folder + "/slide_03.png"));
    const std::string pdf = contents_of(folder + "/lecture.pdf"), page = contents_of(folder + "/handout.html");
    CHECK(contains(pdf, "/Count 3"));
    CHECK(contains(page, "slide_02.png"));
    const auto at = page.find("pliant1:");
    REQUIRE(at != page.npos);
    CHECK(json_of({"run", "--scene", page.substr(at, page.find('<', at) - at), "--steps", "0"})["lesson"] == "mesh/rod");
    REQUIRE(call(lecture(scratch.path("l.md"), small)).exit_code == 0);
    CHECK(contents_of(folder + "/lecture.pdf") == pdf);
    CHECK(contents_of(folder + "/handout.html") == page);
}

TEST_CASE("a lecture that cannot be read is refused, and so are options that do not go together", "[process]") {
    const Scratch scratch;
    const std::string file = scratch.file("l.md", good);
    for (const auto& [arguments, words] : std::vector<std::pair<Arguments, std::string>>{
             {lecture("soft_bodie"), "did you mean 'soft_bodies'"},
             {lecture(scratch.path("none.json")), "none.json"},
             {lecture(scratch.file("e.json", "{\"pliant_lecture\": 1,\n\"slides\": [")), "e.json:2"},
             {lecture(file, {"--check", "--present"}), "--present"},
             {lecture(file, {"--slide", "2"}), "--present"},
             {lecture(file, {"--theme", "dark"}), "--present or --out"},
             {lecture(file, {"--out", file}), "l.md"}}) {
        const Outcome outcome = call(arguments);
        INFO(sentence(arguments) << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, words));
    }
}
