// `pliant study`: the files of a stability map, what is told meanwhile, and what is refused.
#include "pliant.h"

#include <numeric>
#include <sstream>

using namespace pliant::test;

namespace {

// A lattice of one cell: each run takes a few milliseconds.
Arguments study(const std::vector<std::string>& knobs, const std::string& out, const Arguments& more = {}) {
    Arguments all{"study", "mass_spring", "--map"};
    all.insert(all.end(), knobs.begin(), knobs.end());
    all.insert(all.end(), {"--out", out, "--steps", "20"});
    for (const char* setting : {"cells_x=1", "cells_y=1", "cells_z=1", "scene=spin"}) all.insert(all.end(), {"--set", setting});
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

const std::vector<std::string> usual{"time_step=1e-3:0.5:6:log", "k_structural=100,1000,10000"};

}  // namespace

TEST_CASE("study writes a map as picture, JSON and table, and tells what came out", "[process][atlas]") {
    const Scratch scratch;
    const std::string out = scratch.path("new/maps");
    const Outcome outcome = call(study(usual, out, {"--jobs", "2", "--size", "800x500"}));
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(contains(outcome.out, "mesh/mass_spring: time_step=0.001:0.5:6:log across, k_structural=100,1000,10000 up"));
    CHECK(contains(outcome.out, "18 cells in "));
    CHECK(contains(outcome.out, "with 2 jobs"));
    CHECK(contains(outcome.err, "pliant: 18 of 18 cells\n"));  // no terminal: plain lines
    CHECK_FALSE(contains(outcome.err, "\r"));
    CHECK(std::ranges::count(outcome.err, '\n') == 4);

    const std::string csv = contents_of(out + "/map.csv"), text = contents_of(out + "/map.json");
    CHECK(csv.starts_with("time_step [s],k_structural [N/m],class,"));
    CHECK(std::ranges::count(csv, '\n') == 19);
    for (const char* bad : {"nan", "NaN", "inf,", "Infinity", "-nan"}) {
        CHECK_FALSE(contains(csv, bad));
        CHECK_FALSE(contains(text, bad));
    }
    const Json map = Json::parse(text);
    CHECK(map["knobs"][0]["values"].size() == 6);
    CHECK(map["knobs"][1]["values"] == Json{100.0, 1000.0, 10000.0});
    CHECK(map["settings"]["cells_x"] == 1);
    CHECK(map["steps"] == 20);
    CHECK(map["probe"] == "energy");
    const Json& counts = map["counts"];
    CHECK(std::accumulate(counts.begin(), counts.end(), 0, [](int sum, const Json& n) { return sum + n.get<int>(); }) == 18);
    CHECK(counts["diverged"].get<int>() > 0);
    CHECK(counts["diverged"].get<int>() < 18);
    CHECK(map["agreement"]["contradicts"] == 0);
    CHECK_FALSE(map["bound"].empty());
    CHECK(map["cost"]["jobs"] == 2);
    CHECK(contents_of(out + "/map.png").size() > 10000);
}

TEST_CASE("the table of a map has the same bits for any number of jobs", "[process][atlas]") {
    const Scratch scratch;
    for (const char* jobs : {"1", "2", "3"})
        REQUIRE(call(study(usual, scratch.path(jobs), {"--jobs", jobs, "--size", "400x300"})).exit_code == 0);
    const std::string one = contents_of(scratch.path("1/map.csv"));
    CHECK(contents_of(scratch.path("2/map.csv")) == one);
    CHECK(contents_of(scratch.path("3/map.csv")) == one);
}

TEST_CASE("a choice is a knob by its options, and a time stands for steps", "[process][atlas]") {
    const Scratch scratch;
    Arguments arguments = study({"time_step=1e-3:0.1:4:log", "integrator=explicit_euler,implicit_euler"}, scratch.path("maps"),
                                {"--size", "400x300"});
    std::erase_if(arguments, [](const std::string& a) { return a == "--steps" || a == "20"; });
    arguments.insert(arguments.end(), {"--time", "0.05", "--ui-scale", "1.5", "--theme", "projector"});
    const Outcome outcome = call(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const Json map = Json::parse(contents_of(scratch.path("maps/map.json")));
    CHECK(map["knobs"][1]["values"] == Json{"explicit_euler", "implicit_euler"});
    CHECK(map["time"] == 0.05);
    CHECK(map["cells"]["steps"][4] == 50);
}

TEST_CASE("study refuses in words, before it makes anything", "[process][atlas]") {
    const Scratch scratch;
    const std::string out = scratch.path("maps"), dt = "time_step=1e-3:0.5:6:log", k = "k_structural=100:1000:3";
    const auto refusal = [&](const Arguments& arguments) {
        const Outcome outcome = call(arguments);
        INFO(sentence(arguments) << "\n" << outcome.out);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.out.empty());
        CHECK_FALSE(fs::exists(out));
        return outcome.err;
    };
    CHECK(contains(refusal(study({dt, "k_structual=100:1000:3"}, out)), "did you mean 'k_structural'"));
    CHECK(contains(refusal(study({dt, "integrator=0:2:3"}, out)), "integrator=explicit_euler,"));
    CHECK(contains(refusal(study({dt, "time_step=1e-3:1e-2:3"}, out)), "twice"));
    CHECK(contains(refusal(study({dt, "k_structural=100:1000:1"}, out)), "2 to"));
    CHECK(contains(refusal(study({dt, "k_structural=-5:1000:3"}, out)), "accepted range"));
    CHECK(contains(refusal(study({dt, "k_structural=0:1000:3:log"}, out)), "above 0"));
    CHECK(contains(refusal(study({dt}, out)), "two knobs"));
    CHECK(contains(refusal(study({dt, k, "mass=1,2"}, out)), "two knobs"));
    CHECK(contains(refusal(study({dt, k}, out, {"--set", "k_structural=3"})), "leave out --set"));
    CHECK(contains(refusal(study({dt, k}, out, {"--time", "1"})), "not both"));
    CHECK(contains(refusal(study({dt, k}, out, {"--jobs", "0"})), "--jobs"));
    CHECK(contains(refusal(study({dt, k}, out, {"--probe", "energi"})), "did you mean 'energy'"));
    CHECK(contains(refusal(study({dt, k}, out, {"--size", "10x10"})), "--size"));
    CHECK(contains(refusal({"study", "mas_spring", "--map", dt, k, "--out", out}), "mass_spring"));
    CHECK(contains(refusal({"study", "mass_spring", "--map", dt, k, "--out", out, "--steps", "2"}), "--steps"));
    CHECK(contains(refusal({"study", "mass_spring", "--map", dt, k}), "--out"));
    CHECK(contains(refusal({"study", "moduli", "--map", "youngs_modulus=1e6,2e6", "load=1,2", "--out", out}), "at once"));
    scratch.file("plain", "not a folder");
    CHECK(contains(refusal(study({dt, k}, scratch.path("plain"))), "plain"));
}

TEST_CASE("a picture of the atlas needs the lab", "[process][atlas]") {
    const Scratch scratch;
    const Outcome outcome = call({"shot", "mass_spring", "--atlas", "--out", scratch.path("x.png")});
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "--layout lab"));
    CHECK_FALSE(fs::exists(scratch.path("x.png")));
}
