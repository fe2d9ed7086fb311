// A parameter that a scene does not use: what a lesson says of it is true, and what it would need is found and said.
#include "../every_lesson.h"

#include <pliant/document/report.h>
#include <pliant/document/scene_file.h>
#include <pliant/document/unused.h>
#include <pliant/document/walkthrough.h>
#include <pliant/run/runner.h>
#include <pliant/text/stored_file.h>
#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

using namespace pliant;
using namespace pliant::test;

namespace {

using SceneSettings = Runner::Assignments;

std::string text_of_settings(const SceneSettings& settings) {
    std::string text;
    for (const auto& [key, value] : settings) text += " " + key + "=" + value;
    return text;
}

SceneSettings with_settings(SceneSettings settings, const SceneSettings& more) {
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
}

bool is_accepted(const LessonEntry& entry, const SceneSettings& settings) try {
    const Runner runner(entry, settings, 0);
    return true;
} catch (const Refused&) {
    return false;
}

// The first scene, the presets, and each of these with one option of a choice or a switch taken otherwise.
std::vector<SceneSettings> scenes_of(const LessonEntry& entry) {
    std::vector<SceneSettings> scenes{{}};
    for (const std::string& name : preset_names(entry.info.id)) scenes.push_back(preset(entry, name).parameters);
    const auto lesson = entry.make();
    for (const Parameter* p : lesson->parameters) {
        if (p->info.kind != Kind::choice && p->info.kind != Kind::toggle) continue;
        for (Real k = 0; k <= p->info.useful.max; ++k) {
            SceneSettings changed{{std::string(p->info.key), p->text(k)}};
            if (k != p->info.initial && is_accepted(entry, changed)) scenes.push_back(std::move(changed));
        }
    }
    return scenes;
}

template <class Numbers>
void add_bits(std::string& bits, const Numbers& numbers) {
    const auto bytes = std::as_bytes(std::span(numbers));
    bits.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

// All marks of the picture.
void add_picture(std::string& bits, const Lesson& lesson) {
    Scene scene;
    scene.colour_by = lesson.first_colours();
    lesson.draw(scene);
    for (const auto& m : scene.points) add_bits(bits, m.at), add_bits(bits, m.values);
    for (const auto& m : scene.lines) add_bits(bits, m.ends), add_bits(bits, m.values);
    for (const auto& m : scene.triangles) add_bits(bits, m.corners), add_bits(bits, m.values);
    for (const auto& m : scene.arrows) add_bits(bits, m.from), add_bits(bits, m.to), add_bits(bits, m.values);
    for (const auto& m : scene.grids) add_bits(bits, m.values);
    for (const auto& m : scene.labels) add_bits(bits, m.at), bits += m.text;
    for (const auto& m : scene.matrices) add_bits(bits, m.entries), bits += m.name;
    for (const std::string& note : scene.notes) bits += note;
}

// Everything that a run shows after a few steps, but what it was given and what it cost.
std::string found_by(const LessonEntry& entry, const SceneSettings& settings) {
    Runner runner(entry, settings, 0);
    std::string bits;
    try {
        for (int i = 0; i < (runner.is_static() ? 1 : 3); ++i) runner.step();
    } catch (const Diverged& e) {
        return bits + e.what();
    }
    const Lesson& lesson = runner.lesson();
    for (const StateArray& a : lesson.state) add_bits(bits, a.view());
    for (const Field& f : lesson.fields)
        if (f.in_use()) add_bits(bits, f.view());
    auto report = nlohmann::ordered_json::parse(run_json(runner, {}));
    for (const char* key : {"parameters", "cost"}) report.erase(key);
    bits += report.dump();
    add_picture(bits, lesson);
    return bits;
}

// Another value of each parameter that the scene does not use: at the lower, or the upper, end of its slider; another file.
SceneSettings unused_otherwise(const LessonEntry& entry, const SceneSettings& settings, bool upper) {
    const Runner runner(entry, settings, 0);
    SceneSettings changed;
    for (const Parameter* p : runner.lesson().parameters) {
        if (p->used()) continue;
        const std::vector<std::string> bodies = bundled_bodies(p->info.endings);
        if (!bodies.empty()) {
            changed.emplace_back(p->info.key, upper ? bodies.back() : bodies.front());
            continue;
        }
        const Interval& range = p->info.useful;
        Real value = upper ? range.max : range.min;
        if (!p->accepted().contains(value)) value = p->info.kind == Kind::number ? (range.min + range.max) / 2 : p->value();
        if (value != p->value()) changed.emplace_back(p->info.key, p->text(value));
    }
    return changed;
}

// SceneSettings that say what the needs say.
SceneSettings settings_for(const LessonEntry& entry, const std::vector<Need>& way, std::size_t option) {
    const auto lesson = entry.make();
    SceneSettings settings;
    for (const Need& need : way) {
        const Parameter& p = lesson->parameter(need.key);
        std::string value = need.values[std::min(option, need.values.size() - 1)];
        if (need.what == Need::What::above) value = p.text(p.info.useful.max);
        if (need.what == Need::What::below) value = p.text(p.info.useful.min);
        settings.emplace_back(need.key, value);
    }
    return settings;
}

}  // namespace

TEST_CASE("every lesson: a parameter that is said to be unused changes nothing", "[every_lesson][slow]") {
    for (const LessonEntry& entry : every_lesson()) {
        for (const SceneSettings& scene : scenes_of(entry)) {
            const std::string before = found_by(entry, scene);
            for (const bool upper : {false, true}) {
                const SceneSettings otherwise = unused_otherwise(entry, scene, upper);
                if (otherwise.empty()) continue;
                INFO(entry.info.id << text_of_settings(scene) << "\nand what is not used:" << text_of_settings(otherwise));
                std::string culprits;
                try {
                    if (found_by(entry, with_settings(scene, otherwise)) == before) continue;
                    culprits = " some of them together";
                } catch (const Refused& e) {
                    culprits = e.what();
                }
                for (const auto& one : otherwise)
                    if (is_accepted(entry, with_settings(scene, {one})) && found_by(entry, with_settings(scene, {one})) != before)
                        culprits += " " + one.first;
                INFO("these have an effect:" << culprits);
                CHECK(false);
            }
        }
    }
}

TEST_CASE("every lesson: with what an unused parameter is said to need it is used", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        for (const SceneSettings& scene : scenes_of(entry)) {
            const Runner runner(entry, scene, 0);
            for (const Parameter* p : runner.lesson().parameters) {
                if (p->used()) continue;
                const Ways ways = ways_to_use(entry, scene, p->info.key);
                INFO(entry.info.id << text_of_settings(scene) << "\n" << p->info.key << " is used with " << text_of(ways));
                CHECK_FALSE(ways.empty());
                for (const auto& way : ways) {
                    std::size_t options = 1;
                    for (const Need& need : way) options = std::max(options, need.values.size());
                    for (std::size_t k = 0; k < options; ++k) {
                        const SceneSettings changed = with_settings(scene, settings_for(entry, way, k));
                        INFO("set:" << text_of_settings(changed));
                        const auto lesson = entry.make();
                        for (const auto& [key, value] : changed) lesson->parameter(key).set(lesson->parameter(key).parse(value));
                        CHECK(lesson->parameter(p->info.key).used());
                    }
                }
            }
        }
    }
}

TEST_CASE("every lesson: what comes with it sets nothing that is not used", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        std::string unused;
        for (const std::string& name : preset_names(entry.info.id))
            for (const UnusedSetting& u : unused_settings(preset(entry, name))) unused += "\n" + name + ": " + u.text();
        if (!find_text(std::string(entry.info.id) + "/walkthrough.md").empty())
            for (const UnusedSetting& u : unused_settings(entry, walkthrough_of(entry))) unused += "\n" + u.text();
        INFO(entry.info.id << unused);
        CHECK(unused.empty());
    }
}
