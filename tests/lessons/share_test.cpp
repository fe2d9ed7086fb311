// Share strings: they carry a scene to the bit, survive a chat, and refuse what is no longer whole.
#include "../every_lesson.h"

#include <pliant/document/share.h>
#include <pliant/lesson/registry.h>
#include <pliant/text/file.h>
#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;

namespace {

// A value that no one would type: all its digits count.
Real odd_value(const Parameter& p, std::mt19937_64& random) {
    const Interval& range = p.info.useful;
    const Real share = std::uniform_real_distribution<Real>(0.1, 0.9)(random);
    const Real value = range.min + share * (range.max - range.min);
    return p.info.kind == Kind::number ? value : std::round(value);
}

SceneFile small_scene() {
    return {.lesson = "time/bead_chain",
            .parameters = {{"mass", "0.1"}},
            .events = {{.step = 3, .assign = {{"stiffness", "7.000000000000001"}}}}};
}

std::string refusal(std::string_view text) {
    try {
        read_share(text);
    } catch (const Refused& e) {
        return e.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("share string: every parameter of every lesson comes back to the bit", "[every_lesson]") {
    std::mt19937_64 random(11);
    for (const LessonEntry& entry : every_lesson())
        for (int round = 0; round < 5; ++round) {
            const auto lesson = entry.make();
            SceneFile scene{.lesson = std::string(entry.info.id), .parameters = {}};
            std::vector<Real> values;
            for (const Parameter* p : lesson->parameters) {
                values.push_back(odd_value(*p, random));
                scene.parameters.emplace_back(p->info.key, p->text(values.back()));
            }
            const SceneFile again = read_share(share_text(scene));
            CHECK(again.lesson == scene.lesson);
            REQUIRE(again.parameters.size() == values.size());
            for (std::size_t i = 0; i < values.size(); ++i) {
                const auto& [key, text] = again.parameters[i];
                INFO(entry.info.id << " " << key << " " << text);
                CHECK(std::bit_cast<std::uint64_t>(lesson->parameter(key).parse(text)) ==
                      std::bit_cast<std::uint64_t>(values[i]));
            }
        }
}

TEST_CASE("share string: every preset comes back, and is short", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson())
        for (const std::string& name : preset_names(entry.info.id)) {
            const SceneFile scene = preset(entry, name);
            const std::string text = share_text(scene);
            INFO(text);
            CHECK(scene_text(read_share(text)) == scene_text(scene));
            CHECK(text.size() < 600);
            CHECK(text.starts_with("pliant1:"));
            CHECK(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_:") == text.npos);
        }
}

TEST_CASE("share string: camera, view and events come back") {
    SceneFile scene = small_scene();
    scene.camera = Camera{{0.1, -2, 3e-7}, 4.5, 0.6, -0.25};
    scene.view = SceneView{"force", -1, "kick"};
    scene.events.push_back({.step = 9, .pull = Pull{2, {0, 0, 1.0 / 3}, {0, 1, 0.5}}});
    scene.events.push_back({.step = 12, .release = true});
    const SceneFile again = read_share(share_text(scene));
    CHECK(again.camera == scene.camera);
    CHECK(again.view == scene.view);
    REQUIRE(again.events.size() == 3);
    CHECK(again.events[1].pull->from == Vec<3>(0, 0, 1.0 / 3));
    CHECK(scene_text(again) == scene_text(scene));
}

TEST_CASE("share string: blanks and line ends do not matter") {
    const std::string text = share_text(small_scene());
    std::string wrapped = " \n";
    for (std::size_t i = 0; i < text.size(); i += 7) wrapped += text.substr(i, 7) + (i % 2 ? "\r\n" : "\n\t ");
    CHECK(is_share(wrapped.substr(0, 24)));
    CHECK(scene_text(read_share(wrapped)) == scene_text(small_scene()));
}

TEST_CASE("share string: what is not whole is refused in words") {
    const std::string text = share_text(small_scene());
    CHECK_THAT(refusal(""), ContainsSubstring("begins with \"pliant1:\""));
    CHECK_THAT(refusal("{\"pliant\": 1}"), ContainsSubstring("no share string"));
    CHECK_THAT(refusal("pliant:" + text.substr(8)), ContainsSubstring("no share string"));
    CHECK_THAT(refusal("pliant2:" + text.substr(8)), ContainsSubstring("version 2") && ContainsSubstring("update Pliant"));
    CHECK_THAT(refusal("pliant1:"), ContainsSubstring("cut off"));
    CHECK_THAT(refusal(text + "="), ContainsSubstring("'='"));
    CHECK_THAT(refusal(text.substr(0, 30) + "\xc3\xa4" + text.substr(30)), ContainsSubstring("0xc3"));
    for (std::size_t length = 8; length < text.size(); ++length) {
        CAPTURE(length);
        CHECK_THAT(refusal(text.substr(0, length)), ContainsSubstring("cut off"));
    }
    CHECK_THAT(refusal(text + "AAAA"), ContainsSubstring("behind its end"));
}

TEST_CASE("share string: a letter that was changed is noticed") {
    const std::string text = share_text(small_scene());
    for (std::size_t i = 8; i + 1 < text.size(); ++i) {
        std::string changed = text;
        changed[i] = changed[i] == 'A' ? 'B' : 'A';
        CAPTURE(i);
        CHECK_THAT(refusal(changed), ContainsSubstring("share string"));
    }
    std::string checksum = text;
    checksum[checksum.size() - 3] = checksum[checksum.size() - 3] == 'A' ? 'B' : 'A';
    CHECK_THAT(refusal(checksum), ContainsSubstring("checksum"));
}

TEST_CASE("share string: a scene that is too large is refused on both ways") {
    SceneFile scene = small_scene();
    for (Index i = 0; i < 40000; ++i) scene.events.push_back({.step = 10 + i, .assign = {{"stiffness", "7"}}});
    CHECK_THROWS_AS(share_text(scene), Refused);
    // 2 MB of blanks: under two thousand letters.
    const std::string bomb = [] {
        const auto file = std::string(PLIANT_SOURCE_DIR "/tests/fuzz/corpus/share_string/refused_too_much.txt");
        return read_file(file);
    }();
    CHECK(bomb.size() < 4000);
    CHECK_THAT(refusal(bomb), ContainsSubstring("1048576 bytes"));
}

TEST_CASE("share string: what a scene file may not say, it may not say either") {
    const std::string wrong = [] { return read_file(PLIANT_SOURCE_DIR "/tests/fuzz/corpus/share_string/refused_scene.txt"); }();
    CHECK_THAT(refusal(wrong), ContainsSubstring("share string:1:") && ContainsSubstring("mesh/mass_spring"));
}

TEST_CASE("share string: a NUL byte in the scene or among the letters is refused") {
    // {"pliant":1,"lesson":"time/bead_chain"}, a NUL byte and {}.
    CHECK_THAT(refusal("pliant1:eNqrVirIyUzMK1GyMtRRykktLs7PU7JSKsnMTdVPSk1MiU_OSMzMU6plqK4FADJuDnY"),
               ContainsSubstring("share string:1:40: ") && ContainsSubstring("NUL"));
    const std::string text = share_text(small_scene());
    CHECK_THAT(refusal(text + std::string(1, '\0')), ContainsSubstring("0x00"));
    CHECK_THAT(refusal(text + std::string(1, '\0') + "and more"), ContainsSubstring("0x00"));
}

TEST_CASE("share string: it is told from a path") {
    CHECK(is_share(" pliant1:abc"));
    CHECK(is_share("pliant12:"));
    CHECK_FALSE(is_share("pliant:1"));
    CHECK_FALSE(is_share("pliant1.json"));
    CHECK_FALSE(is_share("a/pliant1:"));
    CHECK_FALSE(is_share(""));
    CHECK(open_scene_text(share_text(small_scene())).lesson == "time/bead_chain");
    CHECK_THROWS_AS(open_scene_text("no/such/file.json"), Refused);
}
