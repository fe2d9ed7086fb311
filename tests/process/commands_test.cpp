// Every command does what its help says.
#include "pliant.h"

#include <catch2/generators/catch_generators.hpp>

#include <set>

using namespace pliant::test;

namespace {

std::set<std::string> names_in(const Json& list, const std::string& key = "name") {
    std::set<std::string> names;
    for (const Json& item : list) names.insert(item[key]);
    return names;
}

std::set<std::string> keys_of(const Json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.insert(key);
    return keys;
}

}  // namespace

TEST_CASE("help and version need nothing", "[process]") {
    CHECK(output_of({"--version"}).starts_with("pliant "));
    const std::string help = output_of({"--help"});
    for (const std::string command : {"list", "describe", "run", "shot", "tour", "claims", "walkthrough"}) {
        CHECK(contains(help, command));
        CHECK(contains(output_of({command, "--help"}), "--help"));
    }
    CHECK(contains(help, "Exit codes"));
}

TEST_CASE("list shows every lesson, for people and for programs", "[process]") {
    const std::string text = output_of({"list"});
    const Json lessons = json_of({"list"});
    REQUIRE(lessons.size() >= 3);
    for (const Json& lesson : lessons) {
        CHECK(contains(text, lesson["lesson"]));
        CHECK(contains(text, lesson["title"]));
        CHECK(lesson["lesson"].get<std::string>().starts_with(lesson["chapter"].get<std::string>() + "/"));
        CHECK(lesson["summary"].get<std::string>().size() > 10);
    }
}

TEST_CASE("describe shows every declaration, in all three forms", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        CAPTURE(lesson);
        const Json description = json_of({"describe", lesson});
        const std::string text = output_of({"describe", lesson}), page = output_of({"describe", lesson, "--markdown"});
        CHECK(page.starts_with("# "));
        for (const char* list : {"parameters", "stages", "fields", "probes"}) {
            CAPTURE(list);
            const auto names = names_in(description[list], list == std::string("parameters") ? "key" : "name");
            CHECK(names.size() == description[list].size());
            CHECK_FALSE(names.empty());
            for (const std::string& name : names) {
                CHECK(contains(text, name));
                // A stage is a section of its own.
                CHECK(contains(page, list == std::string("stages") ? ". " + name : "`" + name + "`"));
            }
        }
        for (const Json& p : description["parameters"]) CHECK_FALSE(p["help"].get<std::string>().empty());
    }
}

TEST_CASE("a lesson may be named without its chapter", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        const std::string short_name = lesson.substr(lesson.find('/') + 1);
        CHECK(json_of({"describe", short_name}) == json_of({"describe", lesson}));
    }
}

TEST_CASE("run reports what the lesson declares", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        CAPTURE(lesson);
        const Json description = json_of({"describe", lesson});
        Json run = json_of({"run", lesson, "--steps", "3"});
        for (const char* key : {"lesson", "parameters", "dimension", "steps", "time", "status", "probes", "lines", "assumptions",
                                "conserved", "cost"})
            CHECK(run.contains(key));
        CHECK(run["lesson"] == lesson);
        CHECK(run["dimension"] == description["dimension"]);
        CHECK(run["steps"] == 3);
        CHECK((run["status"] == "ok" || run["status"] == "at_rest"));
        // Under the name of today; what is there for older scripts as well says so.
        Json of_today = Json::object();
        for (const auto& [name, probe] : run["probes"].items())
            if (!probe.contains("now")) of_today[name] = probe;
        run["probes"] = of_today;
        CHECK(keys_of(run["probes"]) == names_in(description["probes"]));
        for (const Json& p : description["parameters"]) CHECK(run["parameters"][p["key"].get<std::string>()] == p["default"]);
        for (const Json& p : description["probes"]) CHECK(run["probes"][p["name"].get<std::string>()]["unit"] == p["unit"]);
        const auto stages = names_in(description["stages"]);
        CHECK_FALSE(run["cost"].empty());
        for (const auto& [stage, milliseconds] : run["cost"].items()) {
            CHECK(stages.contains(stage));
            CHECK(milliseconds.get<double>() >= 0);
        }
        const std::string text = output_of({"run", lesson, "--steps", "3"});
        for (const auto& [probe, value] : run["probes"].items()) CHECK(contains(text, probe));
    }
}

TEST_CASE("the presets of a lesson run", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const std::string& preset : presets_of(lesson)) {
            CAPTURE(lesson, preset);
            CHECK(json_of({"run", lesson, "--preset", preset, "--steps", "1"})["steps"] == 1);
        }
}

TEST_CASE("every walkthrough finds what it expects", "[process][slow][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        const Outcome outcome = call({"walkthrough", lesson, "--check"});
        INFO(lesson << "\n" << outcome.out << outcome.err);
        CHECK(outcome.exit_code == 0);
        CHECK(contains(outcome.out, ", 0 missed"));
        CHECK_FALSE(contains(outcome.out, "\n0 expectations met"));
    }
}

TEST_CASE("shot writes a picture of the size asked for", "[process][slow][every_lesson]") {
    const Scratch scratch;
    for (const std::string& lesson : every_lesson()) {
        CAPTURE(lesson);
        // One of the stages that run in the first scene.
        const std::string stage = json_of({"run", lesson, "--steps", "1"})["cost"].begin().key(),
                          picture = scratch.path("picture.png");
        CHECK(output_of({"shot", lesson, "--steps", "1", "--stage", stage, "--size", "640x360", "--theme", "projector", "--out",
                         picture})
                  .empty());
        const std::string png = contents_of(picture);
        REQUIRE(png.size() > 2000);
        CHECK(png.substr(1, 3) == "PNG");
        const auto side = [&](std::size_t at) {
            return static_cast<unsigned char>(png[at]) * 256 + static_cast<unsigned char>(png[at + 1]);
        };
        CHECK(side(18) == 640);
        CHECK(side(22) == 360);
        CHECK(scratch.names() == std::vector<std::string>{"picture.png"});
    }
}

TEST_CASE("walkthrough writes a picture of every slide, with its answer or without", "[process]") {
    const Scratch scratch;
    const std::string folder = scratch.path("a/slides"), questions = scratch.path("questions");
    const std::string told = output_of({"walkthrough", "moduli", "--out", folder, "--size", "640x360"});
    output_of({"walkthrough", "moduli", "--out", questions, "--questions", "--size", "640x360"});
    for (int n = 1; n <= 8; ++n) {
        const std::string name = "slide_0" + std::to_string(n) + ".png";
        CAPTURE(name);
        CHECK(contains(told, name));
        const std::string picture = contents_of(fs::path(folder) / name);
        CHECK(picture.starts_with("\x89PNG"));
        CHECK(picture != contents_of(fs::path(questions) / name));
    }
    CHECK_FALSE(fs::exists(fs::path(folder) / "slide_09.png"));
}

TEST_CASE("tour shows a lesson and its presets on one page", "[process][slow][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        const Scratch scratch;
        const std::string folder = scratch.path("a/tour");
        CHECK(contains(output_of({"tour", lesson, "--out", folder}), "index.html"));
        const std::string page = contents_of(folder + "/index.html");
        std::string stem = lesson;
        std::ranges::replace(stem, '/', '_');
        std::vector<std::string> stops{stem};
        for (const std::string& preset : presets_of(lesson)) stops.push_back(stem + "_" + preset);
        for (const std::string& stop : stops) {
            CAPTURE(stop);
            CHECK(contains(page, stop + ".png"));
            CHECK(contents_of(folder + "/" + stop + ".png").size() > 5000);
            CHECK(contents_of(folder + "/" + stop + "_lab.png").size() > 5000);
            CHECK(contents_of(folder + "/" + stop + ".csv").starts_with("step,time [s]"));
            CHECK(Json::parse(contents_of(folder + "/" + stop + ".json"))["lesson"] == lesson);
        }
    }
}

TEST_CASE("a tour shows the lessons that are named, in that order, and refuses what is none", "[process]") {
    const Scratch scratch;
    output_of({"tour", "moduli", "elasticity/deformation_gradient", "--out", scratch.path("tour")});
    const std::string page = contents_of(scratch.path("tour/index.html"));
    const auto first = page.find("elasticity_moduli.png"), second = page.find("elasticity_deformation_gradient.png");
    REQUIRE(second != page.npos);
    CHECK(first < second);
    const Outcome outcome = call({"tour", "modulli", "--out", scratch.path("none")});
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "'elasticity/moduli'"));
    CHECK_FALSE(fs::exists(scratch.path("none")));
}
