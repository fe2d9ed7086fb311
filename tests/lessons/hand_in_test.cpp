// What is handed in reads back to the bit, says whether it was changed, and its numbers come out again.
#include <pliant/document/hand_in.h>
#include <pliant/document/share.h>
#include <pliant/document/walkthrough.h>
#include <pliant/math/error.h>
#include <pliant/run/until.h>
#include <pliant/text/sha256.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <functional>
#include <string>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using EntryKind = HandInEntry::Kind;

namespace {

HandIn measured() {
    HandIn h{.name = "Ada “B” Müller"};
    Runner springs(find_lesson("mesh/mass_spring"), {{"scene", "spin"}});
    advance(springs, Until::after_steps(40));
    springs.assign("time_step", 1e-3);
    advance(springs, Until::after_steps(20));
    h.entries.push_back(measurement_of(springs, "energy"));
    Runner flow(find_lesson("fluids/projection"));
    flow.run_to_stage("pressure");
    h.entries.push_back(measurement_of(flow, "cell_pressure"));
    h.entries.push_back(
        {.kind = EntryKind::answer, .lesson = "mesh/rod", .slide = "A fixed end", .question = "What comes back?", .text = "It."});
    h.entries.push_back({.kind = EntryKind::answer,
                         .lesson = "mesh/rod",
                         .slide = "A fixed end",
                         .question = "Why?",
                         .came = "So.",
                         .text = "Because.",
                         .own_verdict = false,
                         .after_answer = true});
    h.entries.push_back({.kind = EntryKind::prediction,
                         .lesson = "mesh/rod",
                         .slide = "s",
                         .predicted = "a",
                         .came = "b",
                         .text = "w",
                         .right = true});
    return h;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("hand-in: SHA-256 and base64 give what their standards say") {
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("f") == "Zg==");
    for (const std::string& text : {std::string(), std::string("a"), std::string("ab\0c", 4), std::string("\xff\xfe\xfd")})
        CHECK(from_base64(base64(text)) == text);
    CHECK_THROWS_AS(from_base64("Zg="), Refused);
    CHECK_THROWS_AS(from_base64("Z!=="), Refused);
}

TEST_CASE("hand-in: it reads back the same, and its numbers come out again") {
    const HandIn h = measured();
    const HandInRead read = read_hand_in(hand_in_text(h), "h.json");
    CHECK(read.unchanged);
    CHECK(read.hand_in == h);
    const auto findings = check_hand_in(read.hand_in);
    REQUIRE(findings.size() == 5);
    for (const HandInFinding& f : findings) {
        INFO(f.words);
        CHECK(f.holds);
    }
    CHECK(findings[0].repeated);
    CHECK(findings[1].repeated);
    CHECK_FALSE(findings[2].repeated);
    CHECK_THAT(hand_in_report(read, findings),
               ContainsSubstring("comes out") && ContainsSubstring("1 of 1 prediction was right") &&
                   ContainsSubstring("cannot tell who") && ContainsSubstring("Because. (“I was not right”)"));
}

TEST_CASE("hand-in: a change by hand is said; blanks are none") {
    const std::string text = hand_in_text(measured());
    std::string spread = text;
    for (std::size_t at = 0; (at = spread.find("\n", at)) != std::string::npos; at += 3) spread.insert(at, "  ");
    CHECK(read_hand_in(spread, "h.json").unchanged);
    const HandInRead renamed = read_hand_in(changed(text, "Ada", "Eve"), "h.json");
    CHECK_FALSE(renamed.unchanged);
    CHECK_THAT(hand_in_report(renamed, check_hand_in(renamed.hand_in)), ContainsSubstring("was changed after it was saved"));
    CHECK_FALSE(read_hand_in(changed(text, "\"right\": true", "\"right\": false"), "h.json").unchanged);
}

TEST_CASE("hand-in: a number that does not come out is told with what does") {
    HandIn h = measured();
    h.entries[0].value *= 1.01;
    const auto findings = check_hand_in(h);
    CHECK_FALSE(findings[0].holds);
    CHECK_THAT(findings[0].words, ContainsSubstring("is handed in, and") && ContainsSubstring("comes out"));
    h.entries[0].scene = "pliant1:xyz";
    CHECK_FALSE(check_hand_in(h)[0].holds);
}

namespace {

// The slide of this title, answered with the guess after what a person does there.
HandInEntry answered(std::string_view lesson, std::string_view title, const Guess& guess,
                     const std::function<void(Runner&)>& meanwhile = {}) {
    Runner runner(find_lesson(lesson));
    WalkthroughPlayer player(runner, walkthrough_of(find_lesson(lesson)));
    const auto& slides = player.walkthrough().slides;
    const auto found = std::ranges::find(slides, title, &Slide::title);
    REQUIRE(found != slides.end());
    player.go_to_slide(static_cast<std::size_t>(found - slides.begin()));
    player.guess(guess);
    if (meanwhile) meanwhile(runner);
    player.next();
    return prediction_of(runner, player);
}

std::string slide_with(std::string_view lesson, Prediction::Kind kind) {
    Runner runner(find_lesson(lesson));
    const WalkthroughPlayer player(runner, walkthrough_of(find_lesson(lesson)));
    for (const Slide& slide : player.walkthrough().slides)
        for (const Block& b : slide.blocks)
            if (b.kind == BlockKind::predict && read_prediction(b, "").kind == kind) return slide.title;
    FAIL("no slide of " << lesson << " asks for such a prediction");
    return "";
}

}  // namespace

TEST_CASE("hand-in: a prediction is played again, whatever its kind, and the verdict is the same") {
    HandIn h{.name = "Ada"};
    const std::string choice = slide_with("mesh/mass_spring", Prediction::Kind::choice),
                      sketch = slide_with("mesh/mass_spring", Prediction::Kind::sketch),
                      number = slide_with("time/integration", Prediction::Kind::number);
    h.entries.push_back(answered("mesh/mass_spring", choice, {.option = 0}));
    h.entries.push_back(answered("mesh/mass_spring", choice, {.option = 1}));
    h.entries.push_back(answered("mesh/mass_spring", sketch, {.sketch = Sketch(sketch_points, 5)}));
    h.entries.push_back(answered("time/integration", number, {.number = 0.25}));
    // Changed and run on before the answer was shown.
    h.entries.push_back(answered("mesh/mass_spring", choice, {.option = 0}, [](Runner& r) {
        advance(r, Until::after_steps(3));
        r.assign("mass", 2 * r.lesson().parameter("mass").value());
        advance(r, Until::after_steps(2));
    }));
    CHECK_FALSE(h.entries.back().left.empty());
    const HandInRead read = read_hand_in(hand_in_text(h), "h.json");
    CHECK(read.hand_in == h);
    for (const HandInFinding& f : check_hand_in(read.hand_in)) {
        INFO(f.words);
        CHECK(f.repeated);
        CHECK(f.holds);
    }

    SECTION("another verdict, guess, result or slide does not come out") {
        HandIn other = h;
        other.entries[0].right = !other.entries[0].right;
        other.entries[1].came = "nothing";
        other.entries[2].guess.sketch = sampled({{0, 1e9}, {1, 1e9}}, 1);
        other.entries[2].right = true;
        other.entries[3].scene = "pliant1:none";
        const auto findings = check_hand_in(other);
        for (std::size_t k = 0; k < 4; ++k) {
            INFO(findings[k].words);
            CHECK_FALSE(findings[k].holds);
        }
    }
    SECTION("a slide that asks something else than this version's is said to") {
        HandIn other = h;
        other.entries[0].slide_text += "```do\nrelease\n```\n";
        const HandInFinding finding = check_hand_in(other)[0];
        CHECK_THAT(finding.words, ContainsSubstring("asks something else"));
    }
}

TEST_CASE("hand-in: the file is called after the person and the lesson") {
    HandIn h{.name = "Ada “B” Müller / 3"};
    CHECK(hand_in_file_name(h, "mesh/rod") == "ada_“b”_müller_3_rod.handin.json");
    h.entries.push_back({.kind = EntryKind::answer, .lesson = "mesh/cloth", .text = "It."});
    CHECK(hand_in_file_name(h, "mesh/rod") == "ada_“b”_müller_3_cloth.handin.json");
    h.entries.push_back({.kind = EntryKind::answer, .lesson = "mesh/rod", .text = "It."});
    CHECK(hand_in_file_name(h, "mesh/rod") == "ada_“b”_müller_3_work.handin.json");
    CHECK(hand_in_file_name({.name = ""}, "mesh/rod") == "rod.handin.json");
    CHECK(hand_in_file_name({.name = "../"}, "mesh/rod") == "rod.handin.json");
}

TEST_CASE("hand-in: what is none is refused with its place") {
    CHECK_THROWS_WITH(read_hand_in("{\"pliant\": 1}", "h.json"),
                      ContainsSubstring("h.json:1:") && ContainsSubstring("no hand-in"));
    CHECK_THROWS_WITH(read_hand_in("{\"pliant_handin\": 2}", "h.json"), ContainsSubstring("version 1"));
    CHECK_THROWS_WITH(read_hand_in("{\"pliant_handin\": 1, \"name\": \"a\", \"entries\": [{\"kind\": \"guess\"}]}", "h.json"),
                      ContainsSubstring("'guess'"));
    CHECK_THROWS_WITH(read_hand_in("{\"pliant_handin\": 1, \"name\": \"a\", \"entries\": [{\"kind\": \"answer\", \"lesson\": "
                                   "\"mesh/rod\", \"own_verdict\": \"perhaps\"}]}",
                                   "h.json"),
                      ContainsSubstring("'perhaps' is no verdict"));
    CHECK_THROWS_WITH(
        read_hand_in("{\"pliant_handin\": 1, \"name\": \"a\", \"entries\": [{\"kind\": \"measurement\", \"lesson\": "
                     "\"mesh/rod\", \"scene\": \"x\", \"step\": 0.5, \"passes\": 0, \"time\": 0}]}",
                     "h.json"),
        ContainsSubstring("\"step\""));
}
