// `pliant why`: how a number came about.
#include <pliant/run/why.h>

#include "command_line/options.h"
#include "command_line/terminal.h"

#include <fmt/format.h>

namespace pliant::viewer {

int why(const RunOptions& options, const WhyOptions& w) {
    constexpr int deepest = 8;
    if (w.depth < 0 || w.depth > deepest)
        throw Refused(fmt::format("--depth {}: give 0 to {} levels; their number grows with every level", w.depth, deepest));
    const SceneFile scene = scene_from(options);
    const LessonEntry& entry = find_lesson(scene.lesson);
    Runner runner(entry, scene.parameters);
    runner.set_events(scene.events);
    tell_unused(unused_settings(scene), options.strict);
    advance(runner, until_from(options, entry, runner.is_static()));
    if (!w.stage.empty()) runner.run_to_stage(w.stage);
    const Answer answer = pliant::why(runner, w.field, w.index, w.component, std::max(w.depth, 1));
    print(options.json ? why_json(answer, w.depth) : why_text(answer));
    return has_trouble(answer) ? static_cast<int>(ExitCode::check_failed) : 0;
}

}  // namespace pliant::viewer
