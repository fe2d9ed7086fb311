#include "app/settings.h"

#include <pliant/math/error.h>
#include <pliant/text/file.h>
#include <pliant/text/json_positions.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace pliant::viewer {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
constexpr Real least_seconds = 2;  // between two writes

// The value of a key when it is of this type.
template <class T>
std::optional<T> read(const Json& json, const char* key) {
    if (!json.contains(key)) return std::nullopt;
    try {
        return json[key].get<T>();
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

template <class T>
void put(Json& json, const char* key, const std::optional<T>& value) {
    if (value) json[key] = *value;
}

struct SizeKey {
    const char* key;
    std::optional<float> PanelSizes::*size;
    float least, most;  // that are taken
};
constexpr float most_px = 4000;
constexpr SizeKey size_keys[]{{"left", &PanelSizes::left, 1, most_px},
                              {"right", &PanelSizes::right, 1, most_px},
                              {"plots", &PanelSizes::plots, 1, most_px},
                              {"lessons", &PanelSizes::lessons, 0, 1},
                              {"walkthrough", &PanelSizes::walkthrough, 0, 1}};

PanelSizes read_sizes(const Json& json) {
    PanelSizes sizes;
    if (!json.contains("panels") || !json["panels"].is_object()) return sizes;
    for (const SizeKey& k : size_keys)
        if (const auto size = read<float>(json["panels"], k.key); size && *size >= k.least && *size <= k.most)
            sizes.*k.size = size;
    return sizes;
}

void put_sizes(Json& json, const PanelSizes& sizes) {
    Json panels = Json::object();
    for (const SizeKey& k : size_keys) put(panels, k.key, sizes.*k.size);
    if (!panels.empty()) json["panels"] = std::move(panels);
}

FoldedHeadings read_headings(const Json& json) {
    FoldedHeadings headings;
    if (!json.contains("headings") || !json["headings"].is_object()) return headings;
    for (const auto& [lesson, folds] : json["headings"].items()) {
        if (!folds.is_object()) continue;
        for (const auto& [heading, open] : folds.items())
            if (open.is_boolean()) headings[lesson][heading] = open.get<bool>();
    }
    return headings;
}

void put_headings(Json& json, const FoldedHeadings& headings) {
    for (const auto& [lesson, folds] : headings)
        for (const auto& [heading, open] : folds) json["headings"][lesson][heading] = open;
}

}  // namespace

Settings parse_settings(std::string_view text, std::string_view path) {
    const Json json = parse_json(text, path).value;
    if (!json.is_object()) throw Refused(fmt::format("{} holds no settings: it is not a JSON object", path));
    Settings s;
    if (const auto theme = read<std::string>(json, "theme"))
        if (*theme == "dark" || *theme == "projector") s.theme = *theme == "dark" ? Theme::dark : Theme::projector;
    if (const auto layout = read<std::string>(json, "layout"))
        if (*layout == "lab" || *layout == "slide") s.layout = *layout == "lab" ? Layout::lab : Layout::slide;
    if (const auto scale = read<float>(json, "scale"); scale && *scale >= 1 && *scale <= 3) s.scale = scale;
    if (const auto speed = read<Real>(json, "speed"); speed && *speed > 0 && *speed <= 1000) s.speed = speed;
    s.hints_shown = read<bool>(json, "hints_shown");
    s.patterns = read<bool>(json, "patterns");
    s.panels = read_sizes(json);
    s.headings = read_headings(json);
    s.recent = read<std::vector<std::string>>(json, "recent").value_or(std::vector<std::string>{});
    if (s.recent.size() > most_recent) s.recent.resize(most_recent);
    s.hand_in_file = read<std::string>(json, "hand_in_file").value_or("");
    return s;
}

std::string settings_text(const Settings& s) {
    Json json = Json::object();
    if (s.theme) json["theme"] = *s.theme == Theme::dark ? "dark" : "projector";
    if (s.layout) json["layout"] = *s.layout == Layout::slide ? "slide" : "lab";  // a deck belongs to its lecture
    put(json, "scale", s.scale);
    put(json, "speed", s.speed);
    put(json, "hints_shown", s.hints_shown);
    put(json, "patterns", s.patterns);
    put_sizes(json, s.panels);
    put_headings(json, s.headings);
    json["recent"] = s.recent;
    if (!s.hand_in_file.empty()) json["hand_in_file"] = s.hand_in_file;
    // A path need not be UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Settings settings_of(const LabState& lab) {
    return {lab.theme, lab.ui_scale, lab.session.speed,       lab.layout,      lab.scene.hints_shown, lab.session.patterns,
            lab.sizes, lab.recent,   lab.parameters.headings, lab.hand_in.file};
}

fs::path settings_path() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    // The XDG Base Directory Specification ignores a relative path.
    if (config && fs::path(config).is_absolute()) return fs::path(config) / "pliant" / "settings.json";
    const char* home = std::getenv("HOME");
    if (home && *home) return fs::path(home) / ".config" / "pliant" / "settings.json";
    return {};
}

SettingsFile::SettingsFile(fs::path path) : path_(std::move(path)) {
    std::error_code ignored;
    if (path_.empty() || !fs::exists(path_, ignored)) return;
    try {
        stored_ = parse_settings(read_file(path_.string()), path_.string());
    } catch (const Error& e) {
        const fs::path aside = set_aside(path_, ".bad");
        trouble_ = aside.empty()
                       ? fmt::format("{}. The lab starts with its first settings.", e.what())
                       : fmt::format("{}. It is kept as {}; the lab starts with its first settings.", e.what(), aside.string());
    }
}

void SettingsFile::note(const LabState& lab) {
    const Settings now = settings_of(lab);
    const auto take = [&](auto member) {
        if (now.*member == seen_.*member) return;
        stored_.*member = now.*member;
        changed_ = true;
    };
    take(&Settings::theme), take(&Settings::scale), take(&Settings::speed), take(&Settings::layout);
    take(&Settings::hints_shown), take(&Settings::patterns), take(&Settings::panels), take(&Settings::headings),
        take(&Settings::recent), take(&Settings::hand_in_file);
    seen_ = now;
}

void SettingsFile::write() {
    if (path_.empty() || !std::exchange(changed_, false)) return;
    try {
        std::error_code ignored;
        fs::create_directories(path_.parent_path(), ignored);
        write_file(path_.string(), settings_text(stored_));
    } catch (const Error&) {
        // A home that cannot be written to is no reason to disturb: nothing is remembered.
        path_.clear();
    }
}

void SettingsFile::keep(const LabState& lab, Real seconds) {
    note(lab);
    waited_ += seconds;
    if (!changed_ || waited_ < least_seconds) return;
    waited_ = 0;
    write();
}

void SettingsFile::finish(const LabState& lab) {
    note(lab);
    write();
}

}  // namespace pliant::viewer
