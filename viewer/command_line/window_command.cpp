// The lab in a window.
#include <pliant/lesson/file.h>

#include "app/lab.h"
#include "app/state_report.h"
#include "command_line/options.h"

#include <chrono>

namespace pliant::viewer {
namespace {

void open_first(Lab& lab, const WindowOptions& o) {
    Session& s = lab.session();
    if (!o.scene_path.empty()) s.open_scene(read_scene(o.scene_path));
    s.playing = true;
}

}  // namespace

int window(const WindowOptions& o) {
    const Size size = size_from(o.size);
    const Theme theme = theme_from(o.theme);
    const std::string lesson = o.lesson.empty() ? "mesh/mass_spring" : std::string(find_lesson(o.lesson).info.id);
    if (o.ui_scale != 0) ui_scale_from(o.ui_scale);
    const auto context = open_context(Backend::window, size);
    Lab lab(*context, lesson);
    lab.set_theme(theme);
    lab.set_scale(o.ui_scale != 0 ? o.ui_scale : context->ui_scale());
    open_first(lab, o);
    StateReport report(o.state_path);

    using Clock = std::chrono::steady_clock;
    auto last = Clock::now();
    for (long frame = 0; !context->close_requested() && (o.frames == 0 || frame < o.frames); ++frame) {
        context->poll_events();
        const auto now = Clock::now();
        lab.frame(std::chrono::duration<Real>(now - last).count());
        last = now;
        context->present();
        report.write(lab.state());
    }
    return 0;
}

}  // namespace pliant::viewer
