// Every claim of the ledger: complete, measured as it is expected, the same each time, and told so on its page.
#include "../every_lesson.h"

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

namespace {

// A page as words and numbers in turn: numbers differ from compiler to compiler in their last digits.
struct Piece {
    std::string words;
    Real number = 0;
};

// "3.2×10⁻¹³" as "3.2e-13", "10⁻⁹" as "1e-9".
std::string plain_numbers(std::string text) {
    const std::vector<std::pair<std::string, std::string>> raised{{"⁻", "-"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"},
                                                                  {"³", "3"}, {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"},
                                                                  {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
    static const std::regex power(R"((\d)×10((?:⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)+)|\b10((?:⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)+))");
    std::string result;
    for (std::smatch m; std::regex_search(text, m, power); text = m.suffix()) {
        std::string exponent = m[2].matched ? m.str(2) : m.str(3);
        for (const auto& [sign, digit] : raised)
            for (std::size_t at; (at = exponent.find(sign)) != std::string::npos;) exponent.replace(at, sign.size(), digit);
        result += m.prefix().str() + (m[1].matched ? m.str(1) : "1") + "e" + exponent;
    }
    return result + text;
}

std::vector<Piece> pieces_of(const std::string& text) {
    static const std::regex number(R"(\d+(?:\.\d+)?(?:e[-+]?\d+)?)");
    const std::string plain = plain_numbers(text);
    std::vector<Piece> pieces;
    auto at = plain.begin();
    for (std::sregex_iterator m(plain.begin(), plain.end(), number), end; m != end; ++m) {
        pieces.push_back({std::string(at, plain.begin() + m->position()), std::stod(m->str())});
        at = plain.begin() + m->position() + m->length();
    }
    pieces.push_back({std::string(at, plain.end())});
    return pieces;
}

// A number that is rounding may have either sign.
std::string without_sign(std::string words) {
    for (const std::string sign : {"−", "-"})
        if (words.ends_with(sign)) words.resize(words.size() - sign.size());
    return words;
}

bool alike(Real a, Real b) {
    constexpr Real digits = 0.02;
    return a == b || std::abs(a - b) <= digits * std::max(a, b);
}

bool alike(const Piece& a, const Piece& b) {
    constexpr Real rounding = 1e-9;
    if (a.number > 0 && b.number > 0 && a.number < rounding && b.number < rounding)
        return without_sign(a.words) == without_sign(b.words);
    return a.words == b.words && alike(a.number, b.number);
}

// The first place where two pages differ, or "".
std::string difference(const std::string& page, const std::string& wanted) {
    const auto a = pieces_of(page), b = pieces_of(wanted);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (!alike(a[i], b[i]))
            return fmt::format("'{}{}' where '{}{}' is measured", a[i].words, a[i].number, b[i].words, b[i].number);
    return a.size() == b.size() ? "" : "one page is longer";
}

}  // namespace

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
            if (c.timed) continue;
            CHECK(again->finding->figure == first.finding->figure);
            CHECK(again->finding->text == first.finding->text);
            CHECK(again->finding->condition == first.finding->condition);
        }
    }
}

TEST_CASE("documentation: the page of the claims is up to date; scripts/docs makes it again") {
    std::vector<ClaimResult> results;
    for (const Claim& c : claims()) results.push_back(measured(c));
    CHECK(difference(read_file(fmt::format("{}/docs/claims.md", PLIANT_SOURCE_DIR)), claims_markdown(results)) == "");
}

TEST_CASE("documentation: pages are compared by their words, and by all but the last digits of their numbers") {
    CHECK(difference("E3 is 1.23×10⁻³ Pa", "E3 is 1.24×10⁻³ Pa") == "");
    CHECK(difference("off by 3×10⁻¹³, not more", "off by 10⁻¹¹, not more") == "");
    CHECK(difference("from −3.1e-17 to 5e+02", "from 2.1e-17 to 5.02e+02") == "");
    CHECK(difference("from −3.1e-2 to 5", "from 3.1e-2 to 5") != "");
    CHECK(difference("E3 is 1.23", "E4 is 1.23") != "");
    CHECK(difference("E3 is 1.23", "E3 is 1.33") != "");
    CHECK(difference("E3 is 1.23", "E3 was 1.23") != "");
    CHECK(difference("E3 is 10⁻³", "E3 is 10⁻⁴") != "");
    CHECK(difference("E3", "E3, E3") != "");
}
