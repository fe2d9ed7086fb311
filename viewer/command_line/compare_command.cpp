// `pliant compare`: all methods of a lesson in one scene.
#include <pliant/study/method_comparison.h>

#include "command_line/options.h"
#include "command_line/terminal.h"

namespace pliant::viewer {

int compare(const RunOptions& options, const std::string& over) {
    const SceneFile scene = scene_from(options);
    const LessonEntry& entry = find_lesson(scene.lesson);
    tell_unused(unused_settings(scene), options.strict);
    const bool is_static = Runner(entry, scene.parameters, 0).is_static();
    const MethodComparison comparison = compare_methods(scene, over, until_from(options, entry, is_static));
    print(options.json ? comparison_json(comparison) : comparison_text(comparison));
    return 0;
}

}  // namespace pliant::viewer
