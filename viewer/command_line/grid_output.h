// `pliant run --vtu F`: the last state, or every step, for ParaView.
#pragma once
#include <pliant/document/vtu.h>

#include <optional>
#include <string>

namespace pliant::viewer {

class GridOutput {
public:
    // "" writes nothing. F.vtu: the last state; F.pvd: every step that is noted, in the folder F. Throws Refused for another
    // ending, a lesson without a grid, and a path that cannot be written.
    GridOutput(const std::string& path, const LessonEntry& entry, const Lesson& lesson);
    void note(const Runner& runner);
    // Ends with what there is. A run that broke down has no last state.
    void finish(const Runner& runner, bool broke_down);

private:
    std::string path_, folder_;
    const LessonEntry& entry_;
    bool every_step_ = false;
    std::vector<VtuFrame> frames_;
};

}  // namespace pliant::viewer
