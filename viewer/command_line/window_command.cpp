// The lab in a window.
#include <pliant/lesson/file.h>

#include "app/lab.h"
#include "app/state_report.h"
#include "command_line/options.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

namespace pliant::viewer {
namespace {

void open_first(Lab& lab, const WindowOptions& o) {
    Session& s = lab.session();
    if (!o.scene_path.empty()) s.open_scene(read_scene(o.scene_path));
    s.playing = !o.deck;
    if (!o.deck) return;
    walkthrough_of(s.entry());  // refused, rather than a message, when there is none
    lab.open_deck();
}

// Writes the lecturer's notes to standard output, for a terminal on another screen, whenever the slide changes.
class NotesPrinter {
public:
    void look_at(const std::optional<WalkthroughPlayer>& player) {
        if (!player || shown_ == player->slide_number()) return;
        shown_ = player->slide_number();
        const std::string notes = player->slide().notes();
        fmt::print("{} / {}  {}\n{}\n\n", *shown_ + 1, player->walkthrough().slides.size(), player->slide().title,
                   notes.empty() ? "(no notes)" : notes);
        std::fflush(stdout);
    }

private:
    std::optional<std::size_t> shown_;
};

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
    NotesPrinter notes;

    using Clock = std::chrono::steady_clock;
    auto last = Clock::now();
    for (long frame = 0; !context->close_requested() && (o.frames == 0 || frame < o.frames); ++frame) {
        context->poll_events();
        const auto now = Clock::now();
        lab.frame(std::chrono::duration<Real>(now - last).count());
        last = now;
        context->present();
        if (o.notes) notes.look_at(lab.session().walkthrough);
        report.write(lab.state());
    }
    return 0;
}

}  // namespace pliant::viewer
