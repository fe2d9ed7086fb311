// What the commands take from the command line.
#pragma once
#include <pliant/document/scene_file.h>
#include <pliant/document/unused.h>
#include <pliant/lesson/registry.h>
#include <pliant/run/until.h>

#include "panels/layout.h"
#include "platform/context.h"
#include "render/palette.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pliant {
struct Claim;
}

namespace pliant::viewer {

// How to make a run and how far to take it.
struct RunOptions {
    std::string lesson, scene_path, preset;
    std::vector<std::string> settings;  // "key=value"
    std::optional<Index> steps;
    std::optional<Real> time;
    bool rest = false;
    std::string csv_path, vtu_path;
    std::string fields;  // "a,b", whose numbers go into the JSON
    bool json = false, summary = false;
    bool strict = false;  // what is set without effect is refused
};

// layout "": as the scene has it, or slide.
struct PictureOptions {
    std::string stage, field, size = "1280x720", theme = "dark", layout, backend = "any", out;
    int component = -1;
    std::optional<Index> slide;  // of the walkthrough, from 1
    bool revealed = false, patterns = false;
    float ui_scale = 1;
    Real seconds = 0;  // of an animation; 0: one picture
    int frames_per_second = 20;
    std::vector<std::string> beside;  // "key=value" of a second run
    std::string claim;                // whose card the lab shows, measured; "" for none
    bool difference = false;
    bool atlas = false;  // the lab shows the stability map of the first knobs
    std::string fill;    // what fills the screen; "" for nothing
};

struct WindowOptions {
    std::string lesson, scene_path, size = "1440x810", theme, state_path;  // theme "": as it was last
    float ui_scale = 0;                                                    // 0: as it was last, or as the screen asks
    long frames = 0;                                                       // stop after so many; 0: when closed
    bool no_settings = false;
    bool deck = false;             // opens the walkthrough of the lesson, paused
    bool presenter = false;        // with a window for the lecturer
    bool notes = false;            // writes the notes of each slide to standard output
    std::string slides_folder{};   // of pictures of the slides; "" for none
    bool questions = false;        // these go without the answers
    bool strict = false;           // what the scene or the walkthrough sets without effect is refused
    std::string lecture{};         // the file to show in the deck; "" for none
    std::optional<Index> slide{};  // of it, from 1; where it was left when not given
};

// `pliant lecture F`.
struct LectureOptions {
    std::string path, folder;  // of pictures, PDF file and handout; "" for none
    bool check = false, present = false;
    bool questions = false;  // pictures go without the answers
};

// The scene that lesson, scene file, preset and settings describe together; later ones win. Throws Refused.
SceneFile scene_from(const RunOptions& options);
// Tells on standard error what is set without effect, a line each; gives it back. Throws Refused for it when strict.
const std::vector<UnusedSetting>& tell_unused(const std::vector<UnusedSetting>& unused, bool strict);
// How far: what was asked for; without any, a static lesson runs to rest and another one for its demo steps.
Until until_from(const RunOptions& options, const LessonEntry& entry, bool is_static);
// Does the scene say how far, and the options nothing else?
bool runs_to_place(const RunOptions& options, const SceneFile& scene);

// "key=value" of an option, as pairs. Throws Refused.
Runner::Assignments assignments_from(const std::vector<std::string>& settings, std::string_view option = "--set");

// "1280x720". Throws Refused.
Size size_from(const std::string& text);
// Makes the folder where it is missing. Throws Refused.
void make_folder(const std::filesystem::path& folder);
Theme theme_from(const std::string& text);
Layout layout_from(const std::string& text);
float ui_scale_from(float scale);

int list_lessons(bool json);
int list_keys(bool markdown);
int describe(const std::string& lesson, bool json, bool markdown, const std::string& sources);
int run(const RunOptions& options);
struct WhyOptions {
    std::string field, stage;
    Index index = 0;
    int component = -1, depth = 1;
};
int why(const RunOptions& run, const WhyOptions& options);
int hand_in(const std::string& path, bool json);
// over: the key of a choice; that of the lesson's methods when empty.
int compare(const RunOptions& run, const std::string& over);
struct ClaimsOptions {
    std::vector<std::string> ids;  // all claims when empty
    bool json = false, markdown = false;
};
// Throws CheckFailed when a claim is refuted, or has another verdict than it expects.
int claims(const ClaimsOptions& options);
// These, reported as the options say. Throws CheckFailed when one is refuted.
int measure_claims(const std::vector<const Claim*>& list, const ClaimsOptions& options);
// A stability map: two knobs, and where to write it.
struct StudyOptions {
    std::vector<std::string> knobs;  // "time_step=1e-4:0.1:40:log"
    std::optional<Index> steps;
    std::optional<Real> time;
    std::optional<int> jobs;
    std::string probe, size = "1280x720", theme = "dark", out;
    float ui_scale = 1;
};
int study(const RunOptions& run, const StudyOptions& options);
int share(const RunOptions& options);
int shot(const RunOptions& run, const PictureOptions& picture);
int tour(const std::string& folder, const std::vector<std::string>& names, bool strict);
// The lessons that it shows: those that are named, in that order, and all when none is. Throws Refused.
std::vector<const LessonEntry*> lessons_of_tour(const std::vector<std::string>& names);
struct WalkthroughOptions {
    bool check = false;   // throws CheckFailed when an expectation is missed
    bool notes = false;   // prints those of the lecturer as well
    bool strict = false;  // what it sets without effect is refused
};
int walkthrough(const std::string& lesson, const WalkthroughOptions& options);
int window(const WindowOptions& options);
// Its outline, its check, its window or its pictures. Throws CheckFailed and Refused.
int lecture(const LectureOptions& lecture, const WindowOptions& window);
// A PNG file of every slide of the walkthrough.
int slides(const WindowOptions& options);

}  // namespace pliant::viewer
