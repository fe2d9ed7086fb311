// `pliant study`: the stability map of a lesson, in files.
#include <pliant/math/parallel.h>
#include <pliant/study/stability_report.h>
#include <pliant/text/file.h>

#include "app/map_picture.h"
#include "command_line/options.h"
#include "command_line/output_paths.h"
#include "command_line/terminal.h"
#include "platform/png_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <thread>

namespace pliant::viewer {
namespace {

// On a terminal a line that renews itself; else a line for each quarter.
class StudyProgress {
public:
    StudyProgress() : terminal_(isatty(STDERR_FILENO)) {}

    void tell(Index done, Index total) {
        const Index percent = 100 * done / total, quarter = 4 * done / total;
        if (terminal_ ? percent == told_ : quarter == told_) return;
        told_ = terminal_ ? percent : quarter;
        if (terminal_)
            tell_raw(fmt::format("\r\033[K{} % of {} cells", percent, total));
        else
            viewer::tell(fmt::format("{} of {} cells", done, total));
    }
    void clear() const {
        if (terminal_) tell_raw("\r\033[K");
    }

private:
    bool terminal_;
    Index told_ = 0;
};

MapOrder order_from(const RunOptions& run, const StudyOptions& o) {
    const SceneFile scene = scene_from(run);
    if (!scene.events.empty())
        throw Refused(fmt::format("{} plays events, which a map does not: give --set instead",
                                  run.preset.empty() ? "the scene" : run.preset));
    if (o.knobs.size() != 2)
        throw Refused(fmt::format("a map has two knobs, and --map gives {}: give --map KEY=FROM:TO:COUNT OTHER=FROM:TO:COUNT",
                                  o.knobs.size()));
    if (o.steps && o.time) throw Refused("give --steps or --time, not both");
    if (o.steps && *o.steps > 10'000'000) throw Refused("--steps is too large: give at most 10000000");
    MapOrder order{.lesson = &find_lesson(scene.lesson), .settings = scene.parameters, .probe = o.probe};
    const auto lesson = order.lesson->make();
    order.across = parse_knob(*lesson, o.knobs[0]), order.up = parse_knob(*lesson, o.knobs[1]);
    if (o.steps) order.steps = *o.steps;
    order.time = o.time;
    check_order(order);
    tell_unused(unused_settings(order), run.strict);
    return order;
}

int jobs_from(const StudyOptions& o) {
    if (!o.jobs) return most_threads();
    if (*o.jobs < 1 || *o.jobs > 256) throw Refused("--jobs", *o.jobs, "", "a whole number from 1 to 256");
    return *o.jobs;
}

}  // namespace

int study(const RunOptions& run, const StudyOptions& o) {
    const MapOrder order = order_from(run, o);
    const int jobs = jobs_from(o);
    const Size size = size_from(o.size);
    const Theme theme = theme_from(o.theme);
    const float scale = ui_scale_from(o.ui_scale);
    refuse_file_ending("--out", o.out);
    const std::filesystem::path folder(o.out);
    make_folder(folder);
    const auto file = [&](const char* name) { return (folder / name).string(); };
    for (const char* name : {"map.csv", "map.json", "map.png"}) check_writable(file(name));

    StudyProgress progress;
    const auto start = std::chrono::steady_clock::now();
    const StabilityMap map = make_stability_map(order, jobs, [&](Index done, Index total) { progress.tell(done, total); });
    const MapCost cost{std::chrono::duration<Real>(std::chrono::steady_clock::now() - start).count(), jobs};
    progress.clear();
    write_file(file("map.csv"), map_csv(map));
    write_file(file("map.json"), map_json(map, cost));
    write_png(map_image(map, size, theme, scale), file("map.png"));
    print(fmt::format("{}  {}, map.json, map.csv\n", map_text(map, cost), file("map.png")));
    return 0;
}

}  // namespace pliant::viewer
