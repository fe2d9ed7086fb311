// The program `pliant` as a person calls it, and what it tells about its lessons.
#pragma once
#include "process.h"

#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace pliant::test {

using Json = nlohmann::ordered_json;

// Exit codes, as README lists them.
inline constexpr int refused = 2, diverged = 3, machine_lacks = 4;

// None of these needs a display, so none is given one unless it is in the environment asked for.
inline Outcome call(const Arguments& arguments, const Environment& more = {}) {
    Environment environment{{"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}};
    environment.insert(environment.end(), more.begin(), more.end());
    return run_process(PLIANT_PROGRAM, arguments, environment);
}

// The same through a shell that opens and closes descriptors: "2>&-".
inline Outcome call_with(const std::string& redirections, const Arguments& arguments) {
    Arguments words{"-c", "exec \"$0\" \"$@\" " + redirections, PLIANT_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_process("/bin/sh", words, {{"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}});
}

inline std::string sentence(const Arguments& arguments) {
    std::string text = "pliant";
    for (const std::string& a : arguments) text += " " + a;
    return text;
}

// Standard output of a call that has to go well.
inline std::string output_of(const Arguments& arguments) {
    const Outcome outcome = call(arguments);
    INFO(sentence(arguments) << "\n" << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
}

inline Json json_of(Arguments arguments) {
    arguments.push_back("--json");
    return Json::parse(output_of(arguments));
}

inline std::vector<std::string> lesson_names() {
    std::vector<std::string> names;
    for (const Json& lesson : json_of({"list"})) names.push_back(lesson["lesson"]);
    return names;
}

// The lessons that a case with the tag [every_lesson] goes through: all, or the one that the environment names in PLIANT_LESSON.
inline std::vector<std::string> every_lesson() {
    if (const char* name = std::getenv("PLIANT_LESSON"); name && *name) return {name};
    return lesson_names();
}

inline std::vector<std::string> presets_of(const std::string& lesson) { return json_of({"describe", lesson})["presets"]; }

inline Json parameters_of(const std::string& lesson) {
    Json parameters = json_of({"describe", lesson})["parameters"];
    REQUIRE_FALSE(parameters.empty());
    return parameters;
}

// A number that reads back as it was.
inline std::string exactly(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

// Settings as options of a run.
inline Arguments with(Arguments run, const std::vector<std::string>& settings) {
    for (const std::string& s : settings) run.insert(run.end(), {"--set", s});
    return run;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Of a probe in what `run --json` printed.
inline double value(const Json& run, const std::string& probe) { return run["probes"][probe]["value"].get<double>(); }

// No probe of it is other than a number or undefined.
inline void check_finite(const Json& run) {
    for (const auto& [name, probe] : run["probes"].items()) {
        INFO(name);
        CHECK((probe["value"].is_null() || std::isfinite(probe["value"].get<double>())));
    }
}

// The message of a call that has to be refused, in one line, and which says all of `words`.
inline std::string refusal(const Arguments& arguments, const std::vector<std::string>& words = {}) {
    const Outcome outcome = call(arguments);
    INFO(sentence(arguments) << "\n" << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("pliant: "));
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    for (const std::string& w : words) {
        INFO("the message should say: " << w);
        CHECK(contains(outcome.err, w));
    }
    return outcome.err;
}

// What a run found, without what it cost.
inline Json without_cost(Json run) {
    run.erase("cost");
    return run;
}

}  // namespace pliant::test
