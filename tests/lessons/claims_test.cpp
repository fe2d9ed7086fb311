// Every claim of the ledger: complete, measured as it is expected, the same each time, and told so on its page.
#include "../every_lesson.h"
#include "page_difference.h"

#include <fmt/format.h>
#include <pliant/math/background.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/file.h>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::test;

TEST_CASE("every claim: its declaration is complete") {
    REQUIRE_FALSE(claims().empty());
    std::set<std::string_view> ids;
    for (const Claim& c : claims()) {
        INFO(c.id);
        CHECK(ids.insert(c.id).second);
        CHECK(std::regex_match(std::string(c.id), std::regex("[EIMPRF][1-9][0-9]?")));
        for (const std::string_view text : {c.statement, c.source, c.experiment, c.figure, c.criterion, c.question})
            CHECK_FALSE(text.empty());
        CHECK(c.answers.size() >= 2);
        CHECK(std::set<std::string_view>(c.answers.begin(), c.answers.end()).size() == c.answers.size());
        CHECK(c.right_answer >= 0);
        CHECK(static_cast<std::size_t>(c.right_answer) < c.answers.size());
        CHECK(c.expected != Verdict::refuted);
        CHECK(c.measure);
    }
}

TEST_CASE("every claim: its lesson exists and accepts its scene", "[every_lesson]") {
    for (const Claim& c : claims()) {
        if (!is_asked_for(c.lesson)) continue;
        INFO(c.id);
        const LessonEntry& entry = find_lesson(c.lesson);
        CHECK(entry.info.id == c.lesson);
        std::set<std::string> keys;
        for (const auto& [key, value] : c.scene) CHECK(keys.insert(key).second);
        CHECK_NOTHROW(Runner(entry, c.scene, 0));
    }
}

TEST_CASE("every claim: measured, it has the verdict that is expected, and the same figure each time, in any thread",
          "[every_lesson]") {
    for (const Claim& c : claims()) {
        if (!is_asked_for(c.lesson)) continue;
        INFO(c.id);
        const ClaimResult first = measured(c);
        INFO(first.failure << (first.finding ? first.finding->text : ""));
        REQUIRE(first.finding);
        CHECK(first.finding->verdict == c.expected);
        CHECK(first.stands());
        // As in the lab, where another run goes on meanwhile.
        Background<ClaimResult> beside([&c](const std::stop_token&) { return measured(c); });
        const ClaimResult here = measured(c), there = beside.take();
        for (const ClaimResult* again : {&here, &there}) {
            REQUIRE(again->finding);
            CHECK(again->finding->verdict == first.finding->verdict);
            CHECK(again->finding->figure == first.finding->figure);
            CHECK(again->finding->text == first.finding->text);
            CHECK(again->finding->condition == first.finding->condition);
        }
    }
}

TEST_CASE("documentation: the page of the claims is up to date; scripts/docs makes it again") {
    std::vector<ClaimResult> results;
    for (const Claim& c : claims()) results.push_back(measured(c));
    CHECK(page_difference(read_file(fmt::format("{}/docs/claims.md", PLIANT_SOURCE_DIR)), claims_markdown(results)) == "");
}

TEST_CASE("documentation: pages are compared by their words, and by all but the last digits of their numbers") {
    CHECK(page_difference("E3 is 1.23×10⁻³ Pa", "E3 is 1.24×10⁻³ Pa") == "");
    CHECK(page_difference("off by 3×10⁻¹³, not more", "off by 10⁻¹¹, not more") == "");
    CHECK(page_difference("from −3.1e-17 to 5e+02", "from 2.1e-17 to 5.02e+02") == "");
    CHECK(page_difference("from −3.1e-2 to 5", "from 3.1e-2 to 5") != "");
    CHECK(page_difference("E3 is 1.23", "E4 is 1.23") != "");
    CHECK(page_difference("E3 is 1.23", "E3 is 1.33") != "");
    CHECK(page_difference("E3 is 1.23", "E3 was 1.23") != "");
    CHECK(page_difference("E3 is 10⁻³", "E3 is 10⁻⁴") != "");
    CHECK(page_difference("E3", "E3, E3") != "");
}
