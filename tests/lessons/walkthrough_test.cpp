// The format of walkthroughs, what a slide locks, and going to a slide.
#include <pliant/document/walkthrough.h>

#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

// A point that moves at a constant speed.
class Walker final : public Lesson {
public:
    Number speed{*this, {.key = "speed", .unit = "m/s", .initial = 1, .useful = {0, 10}}};
    Number start{*this, {.key = "start", .unit = "m", .initial = 0, .useful = {0, 5}, .effect = Effect::rebuild}};

    Walker() {
        state = {state_array("x", "m", x_)};
        fields = {{.name = "x", .unit = "m", .view = view_of(x_)}, {.name = "twice", .unit = "m", .view = view_of(x_)}};
        stages = {{.name = "walk", .run = [this] { x_[0] += 0.5 * speed; }, .writes = {"x"}}};
        probes = {{.name = "x", .unit = "m", .value = [this] { return x_[0]; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return 0.5; }
    void reset() override { x_ = VecX::Constant(1, start); }
    void draw(Scene&) const override {}

private:
    VecX x_;
};

const LessonEntry walker{{.id = "time/walker", .title = "Walker", .summary = ""},
                         [] { return std::unique_ptr<Lesson>(new Walker); }};

constexpr std::string_view three_slides = R"(# Walking
## One
Words.
```ask
Where?
```
```do
run 2 steps
show twice
```
```answer
At 1 m.
```
```controls
speed
```
```notes
Two minutes.
Point at x.

They say 2 m.
```
## Two
```do
set speed=3
run 1 steps
```
```expect
x = 2.5 within 0
```
```controls
none
```
## Three
```do
set start=2
run 1 steps
```
)";

struct Played {
    explicit Played(std::string_view text = three_slides) : runner(walker), player(runner, parse_walkthrough(text, "w.md")) {}
    Real x() const { return *runner.lesson().probe("x").value(); }
    Real speed() const { return runner.lesson().parameter("speed").value(); }
    Runner runner;
    WalkthroughPlayer player;
};

void check_refused(std::string_view text, const std::string& place, const std::string& what) {
    CAPTURE(text);
    CHECK_THROWS_WITH(Played(text), ContainsSubstring(place) && ContainsSubstring(what));
}

}  // namespace

TEST_CASE("notes are read as words for the lecturer", "[walkthrough]") {
    const Walkthrough w = parse_walkthrough(three_slides, "w.md");
    REQUIRE(w.slides.size() == 3);
    CHECK(w.slides[0].notes() == "Two minutes. Point at x. They say 2 m.");
    CHECK(w.slides[1].notes().empty());
    CHECK(w.slides[0].has(BlockKind::notes));
}

TEST_CASE("a slide allows the parameters of its controls, all without the block and none with an empty one", "[walkthrough]") {
    Played p;
    CHECK(p.player.allows("speed"));
    CHECK_FALSE(p.player.allows("start"));
    p.player.go_to_slide(1);
    CHECK_FALSE(p.player.allows("speed"));
    p.player.go_to_slide(2);
    CHECK(p.player.allows("speed"));
    CHECK(p.player.allows("start"));

    const Played empty("## One\n```controls\n```\n");
    CHECK_FALSE(empty.player.allows("speed"));
    const Played both("## One\n```controls\nspeed\nstart\n```\n");
    CHECK(both.player.allows("start"));
}

TEST_CASE("controls that name no parameter are refused with file, line and the nearest key", "[walkthrough]") {
    check_refused("# T\n## One\n```controls\nstart\nspede\n```\n", "w.md:5", "'speed'");
    check_refused("## One\n```controls\nnone speed\n```\n", "w.md:3", "'none' stands alone");
    check_refused("## One\n```control\nspeed\n```\n", "w.md:2", "controls");
    check_refused("## One\n```notes\nspeed\n", "w.md:3", "no end");
    check_refused("```notes\n```\n## One\n", "w.md:1", "before the first slide");
}

// A walkthrough whose one slide does this, or expects it: what is wrong is told when it is set up, or played.
void check_line_refused(const std::string& block, const std::string& line, const std::string& what) {
    const auto play = [&] {
        Played p("## One\n```" + block + "\n" + line + "\n```\n");
        p.player.next();
    };
    CAPTURE(block, line);
    CHECK_THROWS_WITH(play(), ContainsSubstring("w.md:3") && ContainsSubstring(what));
}

TEST_CASE("an action or an expectation with more, or less, than it says is refused with file and line", "[walkthrough]") {
    for (const char* action : {"reset now", "release 3", "set", "preset", "show x twice", "step", "show"})
        check_line_refused("do", action, "no such action");
    for (const char* run : {"run", "run 1.5 steps", "run 0x10 steps", "run +-5 steps", "run 10 stepsize", "run 10 steps more",
                            "run nan s", "run 1,2,5 s", "run rest now", "run 3"})
        check_line_refused("do", run, "run needs one of");
    for (const char* pull :
         {"pull", "pull 1 to 0 0", "pull 1.5 to 0 0 0", "pull 1 at 0 0 0", "pull 1 to 0 0 0 0", "pull 1 to 0 0 inf"})
        check_line_refused("do", pull, "pull needs");
    for (const char* expectation : {"x = 0 within 1 relative more", "x < 1 more", "x = 0 within 1 2", "x < 2 exactly 3"})
        check_line_refused("expect", expectation, "in '");
    Played decimal("## One\n```do\nrun 010 steps\n```\n");
    decimal.player.next();
    CHECK(decimal.x() == 5);
}

TEST_CASE("a slide that asks without a prediction takes words, and nothing else", "[walkthrough]") {
    Played p("## One\n```ask\nWhy?\n```\n```answer\nSo.\n```\n## Two\n```ask\nWhy?\n```\n");
    WalkthroughPlayer& player = p.player;
    REQUIRE(player.prediction());
    CHECK(player.prediction()->kind == Prediction::Kind::words);
    CHECK_THROWS_AS(player.guess({.option = 0u}), Refused);
    CHECK_THROWS_AS(player.guess({.number = 1}), Refused);
    CHECK_THROWS_AS(player.guess({.words = std::string(longest_answer + 1, 'a')}), Refused);
    CHECK_THROWS_AS(player.say_right(true), Refused);
    player.guess({.words = "Because", .was_right = true});
    CHECK_FALSE(player.guess().was_right);  // said once the answer is shown
    CHECK_THROWS_AS(player.say_right(true), Refused);
    player.next();
    player.say_right(false);
    CHECK(player.guess().was_right == false);
    player.next();
    CHECK_FALSE(player.prediction());  // nothing would answer it
}

TEST_CASE("what is predicted once the answer was seen is marked, what was said before stays as it is", "[walkthrough]") {
    Played p(
        "## One\n```ask\nHow far?\n```\n```predict\nchoice\nFar | x > 0\nNear | x < 0\n```\n```do\nrun 1 step\n```\n"
        "## Two\n```ask\nAnd now?\n```\n```predict\nchoice\nFar | x > 0\nNear | x < 0\n```\n```do\nrun 1 step\n```\n");
    WalkthroughPlayer& player = p.player;
    player.next();
    player.back();
    player.guess({.option = 0u});  // skipped before
    CHECK(player.guess().after_answer);
    player.next();
    REQUIRE(player.verdict());
    CHECK(player.verdict()->words.find("after the answer") != std::string::npos);
    player.next();
    player.guess({.option = 1u});  // nothing of this slide has been seen
    CHECK_FALSE(player.guess().after_answer);
    player.next();
    CHECK(player.verdict()->words.find("after the answer") == std::string::npos);
    player.back();
    player.guess({.option = 1u});  // says the same again
    CHECK_FALSE(player.guess().after_answer);
    player.guess({.option = 0u});
    CHECK(player.guess().after_answer);
}

TEST_CASE("a NUL byte in a walkthrough is refused with its line and column", "[walkthrough]") {
    using namespace std::string_view_literals;
    check_refused("# T\n## One\nab\0c\n"sv, "w.md:3", "column 3");
    check_refused("## One\n\0```do\nrun 1 steps\n```\n"sv, "w.md:2", "column 1");
    check_refused("\0"sv, "w.md:1", "column 1");
}

TEST_CASE("going to a slide plays what comes before it", "[walkthrough]") {
    Played p, straight;
    p.player.go_to_slide(2);
    CHECK(p.player.slide_number() == 2);
    CHECK_FALSE(p.player.revealed());
    CHECK(p.player.results().empty());
    CHECK(p.player.shown_field() == "twice");
    for (int i = 0; i < 4; ++i) straight.player.next();
    CHECK(straight.player.slide_number() == 2);
    CHECK(p.x() == straight.x());
    CHECK(p.x() == 2);  // set up: the third slide starts at 2 m
    CHECK(p.speed() == 3);
    CHECK(state_hash(p.runner.lesson()) == state_hash(straight.runner.lesson()));
    p.player.go_to_slide(0);
    CHECK(p.x() == 0);
    CHECK(p.speed() == 1);
    CHECK(p.player.shown_field().empty());
    CHECK_THROWS_WITH(p.player.go_to_slide(3), ContainsSubstring("slide 4") && ContainsSubstring("1 to 3"));
    CHECK(p.player.slide_number() == 0);
}

TEST_CASE("a slide that is reset is as it was before anything was changed on it", "[walkthrough]") {
    Played p;
    p.player.go_to_slide(1);
    const auto hash = state_hash(p.runner.lesson());
    p.runner.assign("speed", 7);
    for (int i = 0; i < 3; ++i) p.runner.step();
    p.runner.assign("start", 4);
    p.player.next();
    REQUIRE(p.player.revealed());
    REQUIRE_FALSE(p.player.results().at(0).met);
    p.player.reset_slide();
    CHECK(p.player.slide_number() == 1);
    CHECK_FALSE(p.player.revealed());
    CHECK(state_hash(p.runner.lesson()) == hash);
    CHECK(p.speed() == 3);  // as the slide is set up
    p.player.next();
    CHECK(p.player.results().at(0).met);
}

TEST_CASE("a slide that hides or plots what is not there is refused, with its line and what can be", "[walkthrough]") {
    Runner runner(walker);
    const auto play = [&](const std::string& block) {
        WalkthroughPlayer(runner, parse_walkthrough("## One\nWords.\n" + block, "w.md"));
    };
    CHECK_NOTHROW(play("```hide\nx twice speed labels titles legends theory lights\n```\n```plots\nx\n```\n"));
    CHECK_THROWS_WITH(play("```hide\nspede\n```\n"), ContainsSubstring("w.md:4: 'spede'") && ContainsSubstring("titles"));
    CHECK_THROWS_WITH(play("```plots\ntwice\n```\n"), ContainsSubstring("w.md:4: 'twice'") && ContainsSubstring("curve"));
    CHECK_THROWS_WITH(play("```do\nsolve\n```\n"), ContainsSubstring("w.md:4") && ContainsSubstring("static"));
}
