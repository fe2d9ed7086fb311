// What the lab remembers between two starts.
#include "app/settings.h"

#include "../process/process.h"

#include <pliant/math/error.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::viewer;
using namespace pliant::test;

namespace {

LabState fresh_lab() { return {{.session = Session("mesh/mass_spring")}}; }

}  // namespace

TEST_CASE("settings: everything is read back as it was written", "[settings]") {
    const Settings s{Theme::projector,
                     1.5f,
                     0.25,
                     Layout::slide,
                     false,
                     true,
                     {.left = 250, .lessons = 0.5f},
                     {"/a/b.json", "/c \"d\".json"},
                     {{"mesh/mass_spring", {{"solver", true}, {"material unused", false}}}}};
    CHECK(parse_settings(settings_text(s), "s") == s);
    CHECK(parse_settings(settings_text({}), "s") == Settings{});
}

TEST_CASE("settings: after a deck the lab opens with its controls", "[settings]") {
    Settings s;
    s.layout = Layout::deck;
    CHECK(parse_settings(settings_text(s), "s").layout == Layout::lab);
}

TEST_CASE("settings: what does not belong is passed over, what is no object is refused", "[settings]") {
    const Settings s = parse_settings(
        R"({"theme": 3, "scale": 99, "speed": -1, "layout": "round", "hints_shown": "no", "recent": [1], "later": {},
            "panels": {"left": -3, "right": 1e9, "lessons": 2, "plots": "wide", "other": 1}})",
        "s");
    CHECK(s == Settings{});
    for (const char* text : {"", "[]", "3", "{", "\xff"}) CHECK_THROWS_AS(parse_settings(text, "s"), Refused);
    const Settings many = parse_settings(R"({"recent": ["1","2","3","4","5","6","7","8","9","10"]})", "s");
    CHECK(many.recent.size() == most_recent);
}

TEST_CASE("settings: what follows the end, a NUL byte and a key given twice are refused with their place", "[settings]") {
    const std::string good = R"({"theme": "projector"})";
    CHECK(parse_settings(good + " \n", "s").theme == Theme::projector);
    for (const auto& [text, place] : {std::pair{good + std::string(1, '\0') + "more", "s:1:23: "},
                                      {good + "\n" + std::string(1, '\0'), "s:2:1: "},
                                      {good + "\nmore", "s:2:"},
                                      {good + good, "s:1:23: "},
                                      {std::string(R"({"theme": "dark",)") + "\n" + R"("theme": "projector"})", "s:2:1: "}}) {
        CAPTURE(text);
        CHECK_THROWS_WITH(parse_settings(text, "s"), Catch::Matchers::StartsWith(place));
    }
}

TEST_CASE("settings: a broken file replaces none that was set aside before", "[settings]") {
    const Scratch scratch;
    const std::string path = scratch.file("settings.json", "{\"theme\": ");
    scratch.file("settings.json.bad", "mine");
    const SettingsFile file(path);
    CHECK(file.trouble().find("settings.json.bad2") != std::string::npos);
    CHECK(contents_of(path + ".bad") == "mine");
    CHECK(contents_of(path + ".bad2") == "{\"theme\": ");
    CHECK(scratch.names() == std::vector<std::string>{"settings.json.bad", "settings.json.bad2"});
}

TEST_CASE("settings: changes are kept, flags are not", "[settings]") {
    const Scratch scratch;
    const fs::path path = scratch.folder() / "deep" / "settings.json";
    LabState lab = fresh_lab();
    {
        SettingsFile file(path);
        lab.theme = Theme::projector;  // as a flag sets it
        file.begin(lab);
        file.keep(lab, 10);
        CHECK_FALSE(fs::exists(path));  // nothing has changed
        lab.session.speed = 0.5;
        file.keep(lab, 10);
        CHECK(fs::exists(path));
        lab.scene.hints_shown = false;
        file.keep(lab, 0.1);
        CHECK_FALSE(SettingsFile(path).stored().hints_shown);  // not in every frame
        file.finish(lab);
    }
    const SettingsFile again(path);
    CHECK(again.trouble().empty());
    CHECK(again.stored().speed == 0.5);
    CHECK(again.stored().hints_shown == false);
    CHECK_FALSE(again.stored().theme);
    CHECK_FALSE(again.stored().scale);
}

TEST_CASE("settings: a broken file is set aside and told", "[settings]") {
    const Scratch scratch;
    const std::string path = scratch.file("settings.json", "{\"theme\": ");
    const SettingsFile file(path);
    CHECK(file.stored() == Settings{});
    CHECK(file.trouble().find("settings.json.bad") != std::string::npos);
    CHECK(scratch.names() == std::vector<std::string>{"settings.json.bad"});
    CHECK(contents_of(path + ".bad") == "{\"theme\": ");
}

TEST_CASE("settings: a place that cannot be written to is no trouble", "[settings]") {
    const Scratch scratch;
    SettingsFile file(scratch.file("file", "") + "/settings.json");
    LabState lab = fresh_lab();
    file.begin(lab);
    lab.scale = 2;
    CHECK_NOTHROW(file.finish(lab));
    SettingsFile none{fs::path()};
    none.begin(lab);
    lab.scale = 1;
    CHECK_NOTHROW(none.finish(lab));
}
