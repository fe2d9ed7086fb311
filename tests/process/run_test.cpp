// `pliant run`: how far it runs, that it repeats itself to the bit, and that its numbers read back as they were.
#include "pliant.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <cstdlib>

using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinULP;

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows read_csv(const std::string& text) {
    Rows rows;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        rows.emplace_back();
        std::istringstream cells(line + ",");
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
}

// The columns that a lesson's probes fill.
std::vector<std::string> columns_of(const Json& description) {
    std::vector<std::string> columns{"step", "time [s]"};
    for (const Json& probe : description["probes"]) {
        const std::string name = probe["name"],
                          unit = probe["unit"].get<std::string>().empty() ? "" : " [" + probe["unit"].get<std::string>() + "]";
        columns.push_back(name + unit);
        if (probe["exact"]) columns.push_back(name + " exact" + unit);
    }
    return columns;
}

// A cell against a number of the JSON output: the same to the bit, and empty where that has none.
bool same_number(const std::string& cell, const Json& value) {
    return value.is_null() ? cell.empty() : !cell.empty() && std::strtod(cell.c_str(), nullptr) == value.get<double>();
}

void check_row(const std::vector<std::string>& row, const Json& run, const Json& description) {
    CHECK(std::stoll(row[0]) == run["steps"]);
    CHECK(same_number(row[1], run["time"]));
    std::size_t column = 2;
    for (const Json& probe : description["probes"]) {
        const Json& measured = run["probes"][probe["name"].get<std::string>()];
        CAPTURE(probe["name"], row[column]);
        CHECK(same_number(row[column++], measured["value"]));
        if (probe["exact"]) CHECK(same_number(row[column++], measured["exact"]));
    }
}

// s; 0 for a static lesson.
double step_of(const std::string& lesson) { return json_of({"run", lesson, "--steps", "1"})["time"]; }

std::vector<std::string> moving_lessons() {
    auto names = every_lesson();
    std::erase_if(names, [](const std::string& lesson) { return step_of(lesson) == 0; });
    return names;
}

}  // namespace

TEST_CASE("the CSV file holds every probe of every step, to the bit", "[process][every_lesson]") {
    const Scratch scratch;
    for (const std::string& lesson : every_lesson()) {
        CAPTURE(lesson);
        const Json description = json_of({"describe", lesson});
        const std::string csv = scratch.path("probes.csv");
        const Json run = json_of({"run", lesson, "--steps", "3", "--csv", csv});
        const Rows rows = read_csv(contents_of(csv));
        REQUIRE(rows.size() == 1 + 4);
        CHECK(rows[0] == columns_of(description));
        for (const auto& row : rows) REQUIRE(row.size() == rows[0].size());
        check_row(rows[1], json_of({"run", lesson, "--steps", "0"}), description);
        check_row(rows[4], run, description);
    }
}

TEST_CASE("the same call gives the same output, but for the cost", "[process][every_lesson]") {
    const Scratch scratch;
    const std::string first = scratch.path("first.csv"), second = scratch.path("second.csv");
    for (const std::string& lesson : every_lesson()) {
        CAPTURE(lesson);
        const Json a = json_of({"run", lesson, "--steps", "5", "--csv", first}),
                   b = json_of({"run", lesson, "--steps", "5", "--csv", second});
        CHECK(without_cost(a).dump() == without_cost(b).dump());
        CHECK(contents_of(first) == contents_of(second));
    }
}

TEST_CASE("the language of the machine changes no number", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        Arguments run{"run", lesson, "--steps", "2", "--json"};
        const Json parameters = json_of({"describe", lesson})["parameters"];
        if (std::ranges::any_of(parameters, [](const Json& p) { return p["key"] == "time_step"; }))
            run.insert(run.end(), {"--set", "time_step=0.0015"});
        const Outcome german = call(run, {{"LC_ALL", "de_DE.UTF-8"}}), neutral = call(run, {{"LC_ALL", "C"}});
        INFO(lesson << "\n" << german.err << neutral.err);
        REQUIRE(german.exit_code == 0);
        REQUIRE(neutral.exit_code == 0);
        CHECK(without_cost(Json::parse(german.out)) == without_cost(Json::parse(neutral.out)));
    }
}

TEST_CASE("no step leaves the initial state", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        CAPTURE(lesson);
        const Json run = json_of({"run", lesson, "--steps", "0"});
        CHECK(run["steps"] == 0);
        CHECK(run["time"] == 0.0);
        for (const auto& [stage, milliseconds] : run["cost"].items()) CHECK(milliseconds == 0.0);
    }
}

TEST_CASE("a time between two steps is rounded to the nearest, and said so", "[process][every_lesson]") {
    for (const std::string& lesson : moving_lessons()) {
        CAPTURE(lesson);
        const double dt = step_of(lesson);
        const auto run_for = [&](double steps) { return call({"run", lesson, "--time", exactly(steps * dt), "--json"}); };
        for (const auto& [asked, done] : {std::pair{0.4, 0}, {0.6, 1}, {2.4, 2}, {2.6, 3}}) {
            CAPTURE(asked);
            const Outcome outcome = run_for(asked);
            REQUIRE(outcome.exit_code == 0);
            CHECK(Json::parse(outcome.out)["steps"] == done);
            CHECK(contains(outcome.err, "rounded to whole steps"));
        }
        const Outcome whole = run_for(3);
        CHECK(Json::parse(whole.out)["steps"] == 3);
        CHECK(whole.err.empty());
    }
}

TEST_CASE("a time, and as many steps as it holds, are the same run", "[process][every_lesson]") {
    for (const std::string& lesson : moving_lessons()) {
        CAPTURE(lesson);
        const double dt = step_of(lesson);
        const Json by_time = json_of({"run", lesson, "--time", exactly(7 * dt)}),
                   by_steps = json_of({"run", lesson, "--steps", "7"});
        CHECK(without_cost(by_time) == without_cost(by_steps));
        CHECK_THAT(by_time["time"].get<double>(), WithinULP(7 * dt, 2));
    }
}

TEST_CASE("100000 steps of a microsecond make a tenth of a second", "[process][slow]") {
    const Json run = json_of({"run", "mesh/mass_spring", "--set", "cells_x=1", "--set", "cells_y=1", "--set", "cells_z=1",
                              "--set", "time_step=1e-6", "--steps", "100000"});
    CHECK(run["steps"] == 100000);
    CHECK_THAT(run["time"].get<double>(), WithinAbs(0.1, 1e-9));
}

TEST_CASE("a static lesson comes to rest", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        if (step_of(lesson) > 0) continue;
        CAPTURE(lesson);
        const Json rest = json_of({"run", lesson, "--rest"});
        CHECK(rest["status"] == "at_rest");
        CHECK(rest["steps"] > 0);
        CHECK(without_cost(rest) == without_cost(json_of({"run", lesson})));
        CHECK(without_cost(rest) == without_cost(json_of({"run", lesson, "--time", "5"})));
    }
}

TEST_CASE("a number given on the command line is used and printed to the bit", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const Json& p : parameters_of(lesson)) {
            if (p["kind"] != "number") continue;
            // Close to the default, with all the digits that a number has.
            const double low = p["useful"][0], high = p["useful"][1], initial = p["default"];
            const double value =
                std::nextafter(initial + 1e-3 * (initial < high ? std::min(high - initial, initial) : low - initial) / 3, high);
            CAPTURE(lesson, p["key"], value);
            const std::string key = p["key"];
            const Json run = json_of({"run", lesson, "--steps", "0", "--set", key + "=" + exactly(value)});
            CHECK(run["parameters"][key].get<double>() == value);
        }
}

TEST_CASE("of several values for one parameter the last one counts", "[process]") {
    const Json run =
        json_of({"run", "elasticity/moduli", "--steps", "0", "--set", "poisson_ratio=0.1", "--set", "poisson_ratio=0.2"});
    CHECK(run["parameters"]["poisson_ratio"] == 0.2);
}

TEST_CASE("what a run prints of its parameters is a scene that gives the same run", "[process]") {
    const Scratch scratch;
    const std::vector<Arguments> runs{
        {"run", "elasticity/moduli", "--set", "test=shear", "--set", "poisson_ratio=0.123456789012345678", "--set",
         "resolution=2"},
        {"run", "mesh/mass_spring", "--steps", "4", "--set", "k_structural=333.3333333333333", "--set",
         "integrator=semi_implicit_euler"},
        {"run", "fluids/navier_stokes", "--steps", "2", "--set", "viscosity=0.001", "--set", "resolution=16"}};
    for (const Arguments& arguments : runs) {
        INFO(sentence(arguments));
        Json run = json_of(arguments);
        const Json scene{{"pliant", 1}, {"lesson", run["lesson"]}, {"parameters", run["parameters"]}};
        Json again = json_of(
            {"run", "--scene", scratch.file("scene.json", scene.dump(1)), "--steps", std::to_string(run["steps"].get<int>())});
        // All parameters are set now, also those that this scene does not use.
        for (Json* j : {&run, &again}) j->erase("unused");
        CHECK(without_cost(again) == without_cost(run));
    }
}

TEST_CASE("a parameter on the command line wins over the scene file", "[process]") {
    const Scratch scratch;
    const std::string scene = scratch.file(
        "scene.json", R"({"pliant": 1, "lesson": "elasticity/moduli", "parameters": {"poisson_ratio": 0.1, "resolution": 2}})");
    const Json run = json_of({"run", "moduli", "--scene", scene, "--set", "poisson_ratio=0.2", "--steps", "0"});
    CHECK(run["parameters"]["poisson_ratio"] == 0.2);
    CHECK(run["parameters"]["resolution"] == 2);
}

TEST_CASE("the number of threads changes no digit, and none is refused", "[process]") {
    const Arguments run{"run", "fluids/navier_stokes", "--set", "resolution=160", "--steps", "4", "--json"};
    const auto probes = [&](const char* threads) {
        Arguments arguments = run;
        arguments.insert(arguments.end(), {"--threads", threads});
        const Outcome outcome = call(arguments);
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return Json::parse(outcome.out)["probes"];
    };
    CHECK(probes("1") == probes("3"));
    Arguments none = run;
    none.insert(none.end(), {"--threads", "0"});
    const Outcome outcome = call(none);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "at least 1"));
}

TEST_CASE("the table of a long run has every step", "[run]") {
    const Scratch scratch;
    const std::string csv = scratch.path("long.csv");
    CHECK(json_of({"run", "time/integration", "--steps", "40000", "--csv", csv})["steps"] == 40000);
    const Rows rows = read_csv(contents_of(csv));
    REQUIRE(rows.size() == 40002);
    for (std::size_t i = 1; i < rows.size(); ++i) REQUIRE(rows[i][0] == std::to_string(i - 1));
}
