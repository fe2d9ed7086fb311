// What the lab remembers from one start to the next, in $XDG_CONFIG_HOME/pliant/settings.json or ~/.config/pliant/settings.json.
// Only the window reads and writes it: pictures and tests without a window do not depend on it.
#pragma once
#include "app/lab_state.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

struct Settings {
    std::optional<Theme> theme;
    std::optional<float> scale;  // of the interface, 1 to 3
    std::optional<Real> speed;   // simulated seconds per second
    std::optional<Layout> layout;
    std::optional<bool> hints_shown;
    std::optional<bool> patterns;     // as well as colours
    PanelSizes panels{};              // where borders were dragged to
    std::vector<std::string> recent;  // scene files, the latest first
    FoldedHeadings headings{};        // of parameters, by lesson
    std::string hand_in_file{};       // that was saved last
    bool operator==(const Settings&) const = default;
};

// Throws Refused for text that holds no settings; keys that are not known are ignored.
Settings parse_settings(std::string_view text, std::string_view path);
std::string settings_text(const Settings& settings);

// What the lab shows now.
Settings settings_of(const LabState& lab);

// Empty when the environment names no place.
std::filesystem::path settings_path();

// Reads at the start, and writes what has changed.
class SettingsFile {
public:
    // An empty path: nothing is read and nothing written. A file that cannot be understood is set aside with the ending .bad, and
    // `trouble` tells so.
    explicit SettingsFile(std::filesystem::path path);
    const Settings& stored() const { return stored_; }
    const std::string& trouble() const { return trouble_; }

    // What is shown at first: a flag of the command line is no change.
    void begin(const LabState& lab) { seen_ = settings_of(lab); }
    // Call in every frame: writes at most once in two seconds, and only what has changed.
    void keep(const LabState& lab, Real seconds);
    // At the end: writes what is not yet written.
    void finish(const LabState& lab);

private:
    void note(const LabState& lab);
    void write();

    std::filesystem::path path_;
    Settings stored_, seen_;
    std::string trouble_;
    bool changed_ = false;
    Real waited_ = 0;  // s since the last write
};

}  // namespace pliant::viewer
