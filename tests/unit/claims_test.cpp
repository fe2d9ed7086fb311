// The ledger of claims: its order, what is asked of it, what an experiment may give, and the reports.
#include <pliant/math/error.h>
#include <pliant/study/claims_reader.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

Finding reproduced(Real figure = 0.25) { return {figure, Verdict::reproduced, "A quarter was measured.", ""}; }

Claim claim_with(std::string_view id, std::function<Finding()> measure, Verdict expected = Verdict::reproduced) {
    return {.id = std::string(id),
            .lesson = "time/none",
            .statement = "A statement that is long enough to be wrapped within its column, |v'|² and ẍ included.",
            .source = "U: a slide",
            .experiment = "Something is measured.",
            .figure = "share of the whole",
            .unit = "",
            .criterion = "≤ 0.5 in every case that was tried here",
            .question = "How much?",
            .answers = {"little", "much"},
            .scene = {{"speed", "2"}},
            .expected = expected,
            .measure = std::move(measure)};
}

// A claim as claims.md has it; more entries may follow.
std::string words_of(std::string_view id, std::string_view more = "") {
    return fmt::format(
        "## {}\n\nIt holds,\nas was said.\n\n- source: U: a slide\n- experiment: Something\n  is measured.\n- figure: a share\n"
        "- criterion: ≤ 0.5\n{}- question: How much?\n  - [ ] little\n  - [x] very\n    much\n\n",
        id, more);
}

// Out of order, and in two chapters' order of files.
const std::string first_words = "# Claims\n\nWords before the first.\n\n" + words_of("F2") + words_of("E10") + words_of("M1"),
                  other_words = words_of("I1") + words_of("E2");
const TextRegistration texts{{{"time/none/claims.md", first_words}, {"time/some/claims.md", other_words}}};
const ClaimRegistration f2{"F2", [] { return reproduced(); }};
const ClaimRegistration e10{"E10", [] { return reproduced(); }};
const ClaimRegistration m1{"M1", [] { return reproduced(); }};
const ClaimRegistration e2{"E2", [] { return reproduced(); }};
const ClaimRegistration i1{"I1", [] { return reproduced(); }};

std::string ids() {
    std::string text;
    for (const Claim& c : claims()) text += c.id + " ";
    return text;
}

// Of a claim that lives as long as the test.
ClaimResult result_of(const Claim& c) { return measured(c); }

std::size_t columns(const std::string& line) {
    return static_cast<std::size_t>(
        std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

TEST_CASE("claims stand in the order of the lectures, then by number", "[claims]") { CHECK(ids() == "E2 E10 I1 M1 F2 "); }

TEST_CASE("a claim is found by its id in either case, and an unknown one is refused with those there are", "[claims]") {
    CHECK(find_claim("E10").id == "E10");
    CHECK(&find_claim("e10") == &find_claim("E10"));
    CHECK(chapter_of(find_claim("m1")) == "Mesh-based Lagrangian methods");
    CHECK(claims_of("time/none").size() == 3);
    CHECK(claims_of("time/other").empty());
    for (const char* id : {"E1", "E100", "", "10", "E10 "})
        CHECK_THROWS_WITH(find_claim(id),
                          ContainsSubstring("E2, E10, I1, M1, F2") && ContainsSubstring(std::string("'") + id + "'"));
    CHECK_THROWS_AS(find_claim("X1"), Refused);
}

TEST_CASE("the words of a claim are read, lines that go on included", "[claims]") {
    const auto read = read_claims("Words before.\n" +
                                      words_of("E7",
                                               "- unit: Pa\n- expected: qualified\n"
                                               "- scene: speed=2\n  load=1e4\n") +
                                      words_of("E8"),
                                  "time/none");
    REQUIRE(read.size() == 2);
    const Claim& c = read[0];
    CHECK(c.id == "E7");
    CHECK(c.lesson == "time/none");
    CHECK(c.statement == "It holds, as was said.");
    CHECK(c.source == "U: a slide");
    CHECK(c.experiment == "Something is measured.");
    CHECK(c.figure == "a share");
    CHECK(c.unit == "Pa");
    CHECK(c.criterion == "≤ 0.5");
    CHECK(c.question == "How much?");
    CHECK(c.answers == std::vector<std::string>{"little", "very much"});
    CHECK(c.right_answer == 1);
    CHECK(c.scene == std::vector<std::pair<std::string, std::string>>{{"speed", "2"}, {"load", "1e4"}});
    CHECK(c.expected == Verdict::qualified);
    CHECK(read[1].id == "E8");
    CHECK(read[1].expected == Verdict::reproduced);
    CHECK(read[1].scene.empty());
    CHECK(read[1].unit.empty());
}

TEST_CASE("words of a claim that are not whole are refused with their place, and with what to do", "[claims]") {
    const auto refusal = [](const std::string& text) {
        try {
            read_claims(text, "time/none");
        } catch (const Refused& e) {
            return std::string(e.what());
        }
        return std::string("it was read");
    };
    const auto without = [](const std::string& part) {
        std::string text = words_of("E7");
        return text.erase(text.find(part), part.size());
    };
    CHECK_THAT(refusal(""), ContainsSubstring("time/none/claims.md:0: there is no claim: begin one with '## ID'"));
    CHECK_THAT(refusal(words_of("E7", "- colour: blue\n")),
               ContainsSubstring("claims.md:11: 'colour' is no entry of a claim; known: source, experiment"));
    CHECK_THAT(refusal(words_of("E7", "- coloured\n")), ContainsSubstring("'coloured' is no entry"));
    CHECK_THAT(refusal(words_of("E7", "- figure: another\n")), ContainsSubstring("E7 has two entries 'figure'"));
    CHECK_THAT(refusal(words_of("E7", "- expected: refuted\n")), ContainsSubstring("'refuted' cannot be expected"));
    CHECK_THAT(refusal(words_of("E7", "- scene: speed\n")), ContainsSubstring("'speed' is not KEY=VALUE"));
    CHECK_THAT(refusal(words_of("E7", "loose words\n")), ContainsSubstring("'loose words' is neither an entry"));
    CHECK_THAT(refusal(words_of("E7", "  - [x] early\n")), ContainsSubstring("an answer stands below '- question:'"));
    CHECK_THAT(refusal(without("It holds,\nas was said.\n")), ContainsSubstring("E7 has no statement"));
    for (const std::string entry : {"source: U: a slide", "criterion: ≤ 0.5", "figure: a share"})
        CHECK_THAT(refusal(without("- " + entry + "\n")),
                   ContainsSubstring("E7 has no " + entry.substr(0, entry.find(':')) + ": give '- "));
    CHECK_THAT(refusal(without("  - [ ] little\n")), ContainsSubstring("E7 has 1 answers, 1 of them right"));
    CHECK_THAT(refusal(without("x] very\n    much") + "  - [ ] none\n"), ContainsSubstring("0 of them right"));
}

TEST_CASE("a claim has words and one measurement, or the ledger is refused", "[claims]") {
    const auto measure = [] { return reproduced(); };
    const std::string e7 = words_of("E7"), e8 = words_of("E8"), odd = words_of("X7"), worse = words_of("E7b");
    const auto joined = joined_claims({{"time/none", e8}, {"time/some", e7}}, {{"E7", measure}, {"E8", measure}});
    REQUIRE(joined.size() == 2);
    CHECK(joined[0].id == "E7");
    CHECK(joined[0].lesson == "time/some");
    CHECK(joined[0].measure().figure == 0.25);
    CHECK_THROWS_WITH(joined_claims({{"time/none", e7}}, {}), ContainsSubstring("time/none/claims.md: nothing measures E7"));
    CHECK_THROWS_WITH(joined_claims({{"time/none", e7}}, {{"E7", measure}, {"E9", measure}}),
                      ContainsSubstring("E9 is measured, but has no words: give '## E9'"));
    CHECK_THROWS_WITH(joined_claims({{"time/none", e7}}, {{"E7", measure}, {"E7", measure}}),
                      ContainsSubstring("E7 is measured by two functions"));
    CHECK_THROWS_WITH(joined_claims({{"time/none", e7}, {"time/some", e7}}, {{"E7", measure}}),
                      ContainsSubstring("time/none/claims.md and time/some/claims.md: both have a claim E7"));
    for (const std::string& text : {odd, worse})
        CHECK_THROWS_WITH(joined_claims({{"time/none", text}}, {}), ContainsSubstring("is no id of a claim: give the letter"));
}

TEST_CASE("what an experiment found is told with its time", "[claims]") {
    const Claim c = claim_with("E90", [] { return reproduced(); });
    const ClaimResult r = result_of(c);
    REQUIRE(r.finding);
    CHECK(r.finding->figure == 0.25);
    CHECK(r.failure.empty());
    CHECK(r.seconds >= 0);
    CHECK(outcome_of(r) == "reproduced");
    CHECK(figure_text(r) == "0.25");
    CHECK(r.stands());
}

TEST_CASE("an experiment that gives no result fails, and never silently", "[claims]") {
    const auto failure_of = [](std::function<Finding()> measure) {
        const Claim c = claim_with("E91", std::move(measure));
        const ClaimResult r = measured(c);
        CHECK_FALSE(r.finding);
        CHECK_FALSE(r.stands());
        CHECK(outcome_of(r) == "failed");
        CHECK(figure_text(r).empty());
        CHECK(r.failure.starts_with("E91: "));
        CHECK(fallen(std::vector{r}) == r.failure);
        return r.failure;
    };
    CHECK_THAT(failure_of([] { return reproduced(std::nan("")); }), ContainsSubstring("not a finite number"));
    CHECK_THAT(failure_of([] { return reproduced(std::numeric_limits<Real>::infinity()); }), ContainsSubstring("inf"));
    CHECK_THAT(failure_of([] { return Finding{1, Verdict::qualified, "Sometimes.", ""}; }), ContainsSubstring("no condition"));
    CHECK_THAT(failure_of([] { return Finding{1, Verdict::reproduced, "", ""}; }), ContainsSubstring("no words"));
    CHECK_THAT(failure_of([]() -> Finding { throw Refused("load", 1, "Pa", "less"); }),
               ContainsSubstring("was refused") && ContainsSubstring("load"));
    CHECK_THAT(
        failure_of([]() -> Finding { throw Diverged({.stage = "solve", .field = "x", .what = "is too large", .limit = ""}); }),
        ContainsSubstring("diverged") && ContainsSubstring("is too large"));
    CHECK_THAT(failure_of([]() -> Finding { throw std::runtime_error("no luck"); }), ContainsSubstring("no luck"));
}

TEST_CASE("a claim stands with the verdict that is expected of it, and never refuted", "[claims]") {
    const auto stands = [](Verdict verdict, Verdict expected) {
        const Claim c = claim_with(
            "E92",
            [verdict] {
                return Finding{1, verdict, "So it is.", "While x < 1."};
            },
            expected);
        const ClaimResult r = measured(c);
        CHECK(fallen(std::vector{r}).empty() == r.stands());
        return r.stands();
    };
    using enum Verdict;
    CHECK(stands(reproduced, reproduced));
    CHECK(stands(qualified, qualified));
    CHECK_FALSE(stands(qualified, reproduced));
    CHECK_FALSE(stands(reproduced, qualified));
    CHECK_FALSE(stands(refuted, reproduced));
    CHECK_FALSE(stands(refuted, refuted));
}

TEST_CASE("a figure for generated pages tells no rounding", "[claims]") {
    CHECK(steady_figure(1.23456) == "1.23");
    CHECK(steady_figure(3e-13) == "below 10⁻⁹");
    CHECK(steady_figure(-3e-13, "m") == "below 10⁻⁹ m");
    CHECK(steady_figure(0) == "below 10⁻⁹");
    CHECK(steady_figure(2e-9) == "2×10⁻⁹");
    CHECK(steady_figure(3e-13, "", 1e-12) == "below 10⁻¹²");
    CHECK(steady_figure(3e-12, "", 1e-12) == "3×10⁻¹²");
    const auto rounding = [](std::string_view criterion) {
        Claim c = claim_with("E91", [] { return reproduced(); });
        c.criterion = criterion;
        return rounding_of(c);
    };
    CHECK(rounding("≤ 10⁻¹²") == Catch::Approx(1e-12));
    CHECK(rounding("≤ 10⁻¹³, and more") == Catch::Approx(1e-13));
    CHECK(rounding("≤ 10⁻⁶, as many forces") == 1e-9);
    CHECK(rounding("1 ± 0.1") == 1e-9);
    CHECK(steady_figure(123456, "Pa") == "123 kPa");
}

TEST_CASE("the table has 100 columns, and says all that was found", "[claims]") {
    const Claim good = claim_with("E93", [] { return reproduced(); }),
                limited = claim_with("E94",
                                     [] {
                                         return Finding{0.4, Verdict::qualified, "It holds at first.", "While x is below 1."};
                                     }),
                failed = claim_with("E95", []() -> Finding { throw Refused("No mesh."); });
    const std::vector<ClaimResult> results{measured(good), measured(limited), measured(failed)};
    const std::string text = claims_text(results);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(columns(line) <= 100);
        CHECK_FALSE(line.ends_with(' '));
    }
    for (const char* words : {"E93", "0.25", "reproduced", "A quarter was measured.", "share of the whole", "While x is below 1.",
                              "E95: the experiment was refused: No mesh.", "Expected: reproduced.",
                              "3 claims: 1 reproduced, 1 qualified, 1 failed, in "})
        CHECK_THAT(text, ContainsSubstring(words));
    CHECK(text ==
          claims_head() + claims_row(results[0]) + claims_row(results[1]) + claims_row(results[2]) + claims_tail(results));
    CHECK_THAT(fallen(results),
               ContainsSubstring("E94 is qualified, where reproduced was expected") && ContainsSubstring("E95: "));
}

TEST_CASE("the JSON has every part of a claim, and the counts", "[claims]") {
    const Claim limited = claim_with(
                    "E94",
                    [] {
                        return Finding{0.4, Verdict::qualified, "It holds at first.", "While x is below 1."};
                    },
                    Verdict::qualified),
                failed = claim_with("E95", []() -> Finding { throw Refused("No mesh."); });
    const auto j = nlohmann::json::parse(claims_json(std::vector{measured(limited), measured(failed)}));
    CHECK(j["reproduced"] == 0);
    CHECK(j["qualified"] == 1);
    CHECK(j["refuted"] == 0);
    CHECK(j["failed"] == 1);
    const auto& first = j["claims"][0];
    for (const char* key : {"id", "lesson", "statement", "source", "experiment", "figure", "value", "unit", "criterion",
                            "verdict", "expected", "finding", "condition", "failure", "seconds", "scene"})
        CHECK(first.contains(key));
    CHECK(first["value"] == 0.4);
    CHECK(first["verdict"] == "qualified");
    CHECK(first["condition"] == "While x is below 1.");
    CHECK(first["scene"]["speed"] == "2");
    CHECK(j["claims"][1]["value"].is_null());
    CHECK(j["claims"][1]["verdict"] == "failed");
    CHECK_THAT(j["claims"][1]["failure"].get<std::string>(), ContainsSubstring("No mesh."));
}

TEST_CASE("the page tells rounding by its level, other figures by their digits", "[claims]") {
    const Claim share = claim_with("I90", [] { return reproduced(0.75); });
    const Claim rounding = claim_with("E90", [] { return Finding{3.21e-14, Verdict::reproduced, "Nothing is left.", ""}; });
    const std::string page = claims_markdown(std::vector{measured(rounding), measured(share)});
    CHECK_THAT(page, ContainsSubstring("## Elasticity") && ContainsSubstring("## Time integration"));
    CHECK_THAT(page, ContainsSubstring("### E90: reproduced") && ContainsSubstring("**below 10⁻⁹**. Nothing is left."));
    CHECK_THAT(page, ContainsSubstring("### I90: reproduced") && ContainsSubstring("**0.75**"));
    CHECK_THAT(page, ContainsSubstring("[time/none](lessons/time_none.md), `pliant run time/none --set speed=2`"));
    CHECK_THAT(page, !ContainsSubstring("3.21"));
}
