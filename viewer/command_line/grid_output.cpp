#include "command_line/grid_output.h"

#include <pliant/text/file.h>

#include "command_line/options.h"
#include "command_line/output_paths.h"
#include "command_line/terminal.h"

#include <fmt/format.h>

#include <filesystem>

namespace pliant::viewer {

GridOutput::GridOutput(const std::string& path, const LessonEntry& entry, const Lesson& lesson)
    : path_(path), entry_(entry), every_step_(ending_of(path) == ".pvd") {
    if (path_.empty()) return;
    require_ending("--vtu", path_, {".vtu", ".pvd"}, "a state is written as VTU, and every step as a collection of them, PVD");
    require_grid(entry, lesson);
    check_writable(path_);
    if (!every_step_) return;
    folder_ = std::filesystem::path(path_).replace_extension().string();
    make_folder(folder_);
}

void GridOutput::note(const Runner& runner) {
    if (!every_step_) return;
    const std::string name = fmt::format("step_{:06}.vtu", runner.place().step);
    const std::filesystem::path folder(folder_);
    write_file((folder / name).string(), vtu_text(entry_, runner.lesson(), runner.time()));
    // Without a clock steps are counted.
    frames_.push_back(
        {runner.is_static() ? static_cast<Real>(runner.place().step) : runner.time(), (folder.filename() / name).string()});
}

void GridOutput::finish(const Runner& runner, bool broke_down) {
    if (path_.empty()) return;
    if (every_step_) return write_file(path_, pvd_text(frames_));
    if (broke_down) return tell(fmt::format("{} is not written: the run broke down, and has no last state", path_));
    write_file(path_, vtu_text(entry_, runner.lesson(), runner.time()));
}

}  // namespace pliant::viewer
