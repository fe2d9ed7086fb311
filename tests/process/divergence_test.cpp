// A run that blows up: exit code 3, the place and the limit named, and no number anywhere that is not finite.
#include "pliant.h"

#include <cmath>
#include <cstdlib>

using namespace pliant::test;

namespace {

// Forward Euler grows without bound on springs without damping, whatever the time step; with this one within a few steps.
const Arguments blow_up{"run",   "mesh/mass_spring", "--set",   "integrator=explicit_euler",
                        "--set", "time_step=0.05",   "--steps", "2000"};

Outcome run_with(Arguments more) {
    more.insert(more.begin(), blow_up.begin(), blow_up.end());
    return call(more);
}

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace

TEST_CASE("a run that diverges names stage, field, index, step and limit", "[process]") {
    const Outcome outcome = run_with({"--json"});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == diverged);
    const Json run = Json::parse(outcome.out), failure = run["failure"];
    CHECK(run["status"] == "diverged");
    CHECK(failure["index"] >= 0);
    CHECK(failure["step"] == run["steps"].get<int>() + 1);
    for (const char* key : {"stage", "field", "what", "limit"}) {
        CAPTURE(key);
        CHECK_FALSE(failure[key].get<std::string>().empty());
        CHECK(contains(outcome.err, failure[key]));
    }
    CHECK(contains(outcome.err, "step " + failure["step"].dump()));
    CHECK(contains(outcome.err, "index " + failure["index"].dump()));

    // Stage and field are those of the lesson, and the hint has a number in it.
    const Json description = json_of({"describe", "mesh/mass_spring"});
    CHECK(contains(description["stages"].dump(), "\"name\":" + failure["stage"].dump()));
    CHECK(contains(description["fields"].dump(), "\"name\":" + failure["field"].dump()));
    CHECK(failure["limit"].get<std::string>().find_first_of("0123456789") != std::string::npos);
    CHECK(contains(failure["limit"], "time step"));
}

TEST_CASE("the report and the CSV file of a diverged run hold finite numbers only", "[process]") {
    const Scratch scratch;
    const std::string csv = scratch.path("probes.csv");
    const Outcome outcome = run_with({"--csv", csv});
    REQUIRE(outcome.exit_code == diverged);
    CHECK(contains(outcome.out, "diverged"));
    for (const std::string& text : {lower_case(outcome.out), lower_case(contents_of(csv))}) {
        CHECK_FALSE(contains(text, "nan"));
        CHECK_FALSE(contains(text, "inf"));
    }
    std::istringstream lines(contents_of(csv));
    std::string line;
    std::getline(lines, line);
    const auto columns = std::ranges::count(line, ',');
    int rows = 0;
    for (; std::getline(lines, line); ++rows) {
        CHECK(std::ranges::count(line, ',') == columns);
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
            CHECK((cell.empty() || std::isfinite(std::strtod(cell.c_str(), nullptr))));
    }
    CHECK(rows > 1);
}

TEST_CASE("the last good state of a diverged run is that of the steps before", "[process]") {
    const Outcome outcome = run_with({"--json"});
    REQUIRE(outcome.exit_code == diverged);
    const Json run = Json::parse(outcome.out);
    Arguments shorter = blow_up;
    shorter.back() = run["steps"].dump();
    CHECK(json_of(shorter)["probes"] == run["probes"]);
}

TEST_CASE("the picture of a diverged run is its last good state, and the exit code says why", "[process]") {
    const Scratch scratch;
    Arguments shot = blow_up;
    shot[0] = "shot";
    shot.insert(shot.end(), {"--layout", "lab", "--out", scratch.path("picture.png")});
    const Outcome outcome = call(shot);
    CHECK(outcome.exit_code == diverged);
    CHECK(contains(outcome.err, "stage"));
    CHECK(scratch.names() == std::vector<std::string>{"picture.png"});
}

TEST_CASE("the animation of a diverged run is not written", "[process]") {
    const Scratch scratch;
    Arguments shot = blow_up;
    shot[0] = "shot";
    shot.insert(shot.end(), {"--seconds", "1", "--out", scratch.path("picture.gif")});
    const Outcome outcome = call(shot);
    CHECK(outcome.exit_code == diverged);
    CHECK(scratch.names().empty());
}

TEST_CASE("the summary of a run says in sentences what holds, what fails and what ended it", "[process]") {
    const Outcome outcome = run_with({"--summary"});
    CHECK(outcome.exit_code == diverged);
    CHECK(contains(outcome.out, "The run stopped in step"));
    const Outcome well = call({"run", "mesh/mass_spring", "--steps", "3", "--summary"});
    CHECK(well.exit_code == 0);
    CHECK(contains(well.out, "Step 3, time"));
    CHECK(contains(well.out, "The assumption"));
    CHECK_FALSE(contains(well.out, "stopped"));
}

TEST_CASE("a body that never rests is reported, not run for ever", "[process][slow]") {
    const Outcome outcome = call({"run", "mesh/mass_spring", "--set", "cells_x=1", "--set", "cells_y=1", "--set", "cells_z=1",
                                  "--set", "damping=1e-12", "--set", "scene=hang", "--rest"});
    INFO(outcome.err);
    CHECK(outcome.exit_code == diverged);
    CHECK(contains(outcome.err, "no rest within 200000 steps"));
}
