// Predictions of slides: how they are read, and how they compare with what comes.
#include <pliant/document/prediction.h>
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/math/error.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

Prediction read(std::vector<std::string> lines) { return read_prediction({BlockKind::predict, std::move(lines), 7}, "w.md"); }

std::string refusal(std::vector<std::string> lines) {
    try {
        read(std::move(lines));
    } catch (const Refused& e) {
        return e.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("prediction: a choice has words and a condition for each answer") {
    const Prediction p = read({"choice", "It grows | energy > 1", "", "It stays | energy = 1 within 0.1"});
    CHECK(p.kind == Prediction::Kind::choice);
    REQUIRE(p.options.size() == 2);
    CHECK(p.options[1].words == "It stays");
    CHECK(p.options[1].condition == "energy = 1 within 0.1");
    CHECK(p.options[1].line == 10);
    CHECK_THAT(refusal({"choice", "It grows"}), ContainsSubstring("w.md:8:") && ContainsSubstring("WORDS | CONDITION"));
    CHECK_THAT(refusal({"choice", "It grows | energy > 1"}), ContainsSubstring("2 to 9 answers"));
}

TEST_CASE("prediction: what is no prediction is refused with its line") {
    CHECK_THAT(refusal({}), ContainsSubstring("begins with one of"));
    CHECK_THAT(refusal({"guess"}), ContainsSubstring("w.md:7:") && ContainsSubstring("'guess'"));
    CHECK_THAT(refusal({"number energy"}), ContainsSubstring("within TOLERANCE"));
    CHECK_THAT(refusal({"number energy within 0"}), ContainsSubstring("above 0"));
    CHECK_THAT(refusal({"sketch energy over 0.2 s from 3 to 1"}), ContainsSubstring("from less to more"));
    CHECK_THAT(refusal({"sketch energy over x s from 0 to 1"}), ContainsSubstring("'x' is no number"));
}

TEST_CASE("prediction: a number is right within its tolerance, and says by how much it is off") {
    const Prediction p = read({"number frequency within 0.2 relative"});
    const PredictionVerdict near = judge_number(p, {.number = 0.16}, 0.15, "rad/s"),
                            far = judge_number(p, {.number = 0.3}, 0.15, "rad/s");
    CHECK(near.right);
    CHECK_FALSE(far.right);
    CHECK_THAT(far.words,
               ContainsSubstring("100 % off") && ContainsSubstring("up to 20 %") && ContainsSubstring("not this time"));
    CHECK_THAT(judge_number(p, {}, 0.15, "rad/s").words, ContainsSubstring("The run gives"));
    CHECK_FALSE(judge_number(p, {}, 0.15, "rad/s").right);
}

TEST_CASE("prediction: a curve is compared with the one that is measured, on average over the plot's height") {
    const Prediction p = read({"sketch energy over 2 s from 0 to 10"});
    const Track track{{0, 1}, {0.5, 2}, {1, 3}, {2, 5}};
    const Sketch measured = sampled(track, 2);
    REQUIRE(measured.size() == sketch_points);
    CHECK(measured.front() == 1);
    CHECK(measured.back() == 5);
    CHECK(std::abs(measured[sketch_points / 2] - 3) < 1e-12);
    const PredictionVerdict same = judge_sketch(p, {.sketch = sketch_typed("1, 5")}, measured, "J");
    CHECK(same.right);
    CHECK_THAT(same.words, ContainsSubstring("0 %"));
    const PredictionVerdict off = judge_sketch(p, {.sketch = sketch_typed("3 7")}, measured, "J");
    CHECK_FALSE(off.right);
    CHECK_THAT(off.words, ContainsSubstring("2 J") && ContainsSubstring("20 %"));
    CHECK_THROWS_AS(sketch_typed("3"), Refused);
    CHECK_THROWS_AS(sketch_typed("3, much"), Refused);
    // A run that ends before the plot does goes on at its last value.
    CHECK(sampled({{0, 1}, {1, 3}}, 2).back() == 3);
    CHECK(sampled({}, 2).empty());
}

TEST_CASE("prediction: an answer in words is repeated, and judged by nobody but who gave it") {
    Guess guess{.words = "It swings on"};
    CHECK(guess.given());
    CHECK(verdict_of_words(guess).words == "You said: “It swings on”.");
    CHECK(verdict_of_words({.words = "Does it?"}).words == "You said: “Does it?”");
    CHECK_FALSE(verdict_of_words(guess).right);
    guess.was_right = true;
    CHECK_THAT(verdict_of_words(guess).words, ContainsSubstring("as you say"));
    CHECK_FALSE(verdict_of_words(guess).right);
    CHECK(verdict_of_words({}).words.empty());
}

TEST_CASE("a slide hides what is expected or predicted, and what it names") {
    const Walkthrough w = parse_walkthrough(
        "## One\n```predict\nchoice\nA | energy > 1\nB | sag < 1\n```\n```expect\nheight = 1 within "
        "2\n```\n```hide\nlabels profile\n```\n## Two\n```predict\nnumber speed within 1\n```\n",
        "w.md");
    for (const char* name : {"energy", "sag", "height", "labels", "profile"}) CHECK(w.slides[0].hides(name));
    CHECK_FALSE(w.slides[0].hides("speed"));
    CHECK_FALSE(w.slides[1].hides("speed"));  // nothing will reveal it
}

TEST_CASE("the set-up of a slide ends with its first other action, and with what is solved") {
    SetUp set_up;
    for (const char* line : {"set a=1", "", "preset x", "show u", "solve"}) CHECK(set_up.takes(line));
    for (const char* line : {"set a=2", "", "run rest"}) CHECK_FALSE(set_up.takes(line));
    SetUp expecting;
    CHECK(expecting.takes("reset"));
    expecting.end();
    CHECK_FALSE(expecting.takes("set a=1"));
}

TEST_CASE("a slide names the plots beside it") {
    const Walkthrough w =
        parse_walkthrough("## One\n```plots\nsag energy\nprofile\n```\n## Two\n## Three\n```plots\nnone\n```\n", "w.md");
    CHECK(w.slides[0].plots() == std::vector<std::string>{"sag", "energy", "profile"});
    CHECK_FALSE(w.slides[1].plots());
    CHECK(w.slides[2].plots() == std::vector<std::string>{});
}
