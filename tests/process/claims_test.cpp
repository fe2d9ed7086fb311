// `pliant claims`: what is measured, how it is told, and the exit codes.
#include "pliant.h"

#include <cmath>
#include <set>
#include <sstream>

using namespace pliant::test;

namespace {

std::vector<std::string> ids_of(const Json& list) {
    std::vector<std::string> ids;
    for (const Json& claim : list) ids.push_back(claim["id"]);
    return ids;
}

// Of all lessons, as `describe` tells them.
std::set<std::string> declared() {
    std::set<std::string> ids;
    for (const std::string& lesson : lesson_names()) {
        const Json description = json_of({"describe", lesson});
        for (const Json& claim : description["claims"]) ids.insert(claim["id"].get<std::string>());
    }
    return ids;
}

std::size_t columns(const std::string& line) {
    return static_cast<std::size_t>(
        std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

TEST_CASE("claims measures every claim of every lesson, and all of them stand", "[process][slow]") {
    const Outcome outcome = call({"claims", "--json"}, {});
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());  // progress is for terminals
    const Json all = Json::parse(outcome.out);
    const auto ids = ids_of(all["claims"]);
    CHECK(std::set<std::string>(ids.begin(), ids.end()) == declared());
    CHECK(all["refuted"] == 0);
    CHECK(all["failed"] == 0);
    CHECK(all["reproduced"].get<std::size_t>() + all["qualified"].get<std::size_t>() == ids.size());
    for (const Json& c : all["claims"]) {
        INFO(c["id"]);
        CHECK(c["verdict"] == c["expected"]);
        CHECK(std::isfinite(c["value"].get<double>()));
        CHECK_FALSE(c["finding"].get<std::string>().empty());
        CHECK(c["seconds"].get<double>() >= 0);
    }
}

TEST_CASE("claims are named by id, in either case and each once, and come in that order", "[process]") {
    CHECK(ids_of(json_of({"claims", "e5", "E3", "E5", "e3"})["claims"]) == std::vector<std::string>{"E5", "E3"});
    const Json one = json_of({"claims", "E4"});
    REQUIRE(one["claims"].size() == 1);
    CHECK(one["claims"][0]["lesson"] == "elasticity/moduli");
    CHECK(one["claims"][0]["value"].get<double>() <= 1e-9);
    CHECK(one["claims"][0]["verdict"] == "reproduced");
    CHECK(one["reproduced"] == 1);
}

TEST_CASE("the table of claims fits a terminal of 100 columns", "[process]") {
    const std::string text = output_of({"claims", "E3", "E4", "E5"});
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(columns(line) <= 100);
    }
    for (const char* words : {"E3", "E4", "E5", "≤ 10⁻⁹", "reproduced", "steel", "3 claims: 3 reproduced, in "})
        CHECK(contains(text, words));
}

TEST_CASE("an unknown claim is refused before anything is measured", "[process]") {
    for (const Arguments& arguments : {Arguments{"claims", "E3", "Q7"}, Arguments{"claims", "Q7", "--json"}}) {
        const Outcome outcome = call(arguments);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.out.empty());
        CHECK(contains(outcome.err, "'Q7'"));
        for (const std::string& id : declared()) CHECK(contains(outcome.err, id));
    }
    CHECK(call({"claims", "--json", "--markdown"}).exit_code == 2);
    CHECK(call({"claims", ""}).exit_code == 2);
}

TEST_CASE("claims as a page", "[process]") {
    const std::string page = output_of({"claims", "E3", "--markdown"});
    CHECK(page.starts_with("# Claims\n"));
    CHECK(contains(page, "### E3: reproduced"));
    CHECK_FALSE(contains(page, "### E4"));
}

TEST_CASE("describe lists the claims of a lesson, in all three forms", "[process]") {
    const std::string text = output_of({"describe", "moduli"}), page = output_of({"describe", "moduli", "--markdown"});
    const Json list = json_of({"describe", "moduli"})["claims"];
    CHECK(list.size() >= 3);
    for (const Json& c : list) {
        CHECK(contains(text, c["id"].get<std::string>() + " "));
        CHECK(contains(text, c["statement"]));
        CHECK(contains(page, "- **" + c["id"].get<std::string>() + ", "));
        CHECK(c["answers"].size() >= 2);
        CHECK(c["right_answer"].get<std::size_t>() < c["answers"].size());
    }
}

TEST_CASE("a picture of a claim needs the lab and a claim", "[process]") {
    const auto refused = [](const char* layout, const char* claim) {
        const Outcome outcome = call({"shot", "moduli", "--layout", layout, "--claim", claim, "--out", "x.png"});
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(fs::exists("x.png"));
        return outcome.err;
    };
    const Scratch scratch;
    output_of({"shot", "moduli", "--layout", "lab", "--claim", "e3", "--size", "1280x720", "--out", scratch.path("card.png")});
    CHECK(contents_of(scratch.path("card.png")).size() > 20000);
    CHECK(contains(refused("slide", "E3"), "--layout lab"));
    CHECK(contains(refused("lab", "Q7"), "'Q7'"));
}
