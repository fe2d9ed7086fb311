#include "command_line/options.h"
#include "command_line/terminal.h"

#include <pliant/document/share.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace pliant::viewer {

Runner::Assignments assignments_from(const std::vector<std::string>& settings, std::string_view option) {
    Runner::Assignments result;
    for (const std::string& s : settings) {
        const auto equals = s.find('=');
        if (equals == std::string::npos || equals == 0) throw Refused(fmt::format("{} {} is not KEY=VALUE", option, s));
        result.emplace_back(s.substr(0, equals), s.substr(equals + 1));
    }
    return result;
}

SceneFile scene_from(const RunOptions& o) {
    if (o.lesson.empty() && o.scene_path.empty())
        throw Refused("name a lesson or give --scene FILE; `pliant list` shows the lessons");
    if (!o.scene_path.empty() && !o.preset.empty()) throw Refused("give --scene or --preset, not both");
    SceneFile scene;
    if (!o.lesson.empty()) scene.lesson = find_lesson(o.lesson).info.id;
    if (!o.preset.empty()) scene = preset(find_lesson(o.lesson), o.preset);
    if (!o.scene_path.empty()) {
        const std::string wanted = scene.lesson;
        scene = open_scene_text(o.scene_path);
        for (const std::string& note : scene.notes) tell(note);
        if (!wanted.empty() && scene.lesson != wanted)
            throw Refused(fmt::format("{} is a scene of {}, not of {}: name that lesson or leave the name out",
                                      is_share(o.scene_path) ? "the share string" : o.scene_path, scene.lesson, wanted));
    }
    for (auto& setting : assignments_from(o.settings)) scene.parameters.push_back(std::move(setting));
    return scene;
}

const std::vector<UnusedSetting>& tell_unused(const std::vector<UnusedSetting>& unused, bool strict) {
    std::string all;
    for (const UnusedSetting& u : unused) {
        if (!strict) tell(u.text());
        all += (all.empty() ? "" : "; ") + u.text();
    }
    if (strict && !all.empty()) throw Refused(fmt::format("{} (refused by --strict: leave it out, or set what it needs)", all));
    return unused;
}

Until until_from(const RunOptions& o, const LessonEntry& entry, bool is_static) {
    if (o.steps.has_value() + o.time.has_value() + o.rest > 1) throw Refused("give one of --steps, --time and --rest");
    if (o.steps) return Until::after_steps(*o.steps);
    if (o.time) return Until::after_time(*o.time);
    if (o.rest || is_static) return Until::at_rest();
    return Until::after_steps(entry.info.demo_steps);
}

bool runs_to_place(const RunOptions& o, const SceneFile& scene) { return scene.place && !o.steps && !o.time && !o.rest; }

Size size_from(const std::string& text) {
    Size size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = separated ? std::from_chars(width.ptr + 1, end, size.height) : width;
    if (!separated || height.ec != std::errc() || height.ptr != end || size.width < 200 || size.height < 150 ||
        size.width > largest_side || size.height > largest_side)
        throw Refused(
            fmt::format("--size {} is not accepted: give WIDTHxHEIGHT in pixels from 200x150 to {}x{}, such as 1280x720", text,
                        largest_side, largest_side));
    return size;
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder))
        throw Refused(
            fmt::format("{} cannot be made: {}", folder.string(), error ? error.message() : "something else has that name"));
}

Theme theme_from(const std::string& text) {
    if (text == "dark") return Theme::dark;
    if (text == "projector") return Theme::projector;
    throw Refused(fmt::format("--theme {} is not accepted: give dark or projector", text));
}

Layout layout_from(const std::string& text) {
    if (text == "slide") return Layout::slide;
    if (text == "lab") return Layout::lab;
    if (text == "deck") return Layout::deck;
    if (text == "presenter") return Layout::presenter;
    throw Refused(
        fmt::format("--layout {} is not accepted: give slide (picture, plots, numbers), lab (all panels), deck (a slide of the "
                    "walkthrough) or presenter (the lecturer's page of it)",
                    text));
}

float ui_scale_from(float scale) {
    if (!(scale >= 1 && scale <= 3)) throw Refused("--ui-scale", scale, "", "a number from 1 to 3");
    return scale;
}

}  // namespace pliant::viewer
