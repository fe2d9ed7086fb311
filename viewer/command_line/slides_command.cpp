// `pliant walkthrough LESSON --out DIR`: a picture of every slide.
#include <pliant/text/texts.h>

#include "command_line/options.h"
#include "command_line/output_paths.h"
#include "command_line/pictures.h"
#include "command_line/terminal.h"
#include "platform/headless_context.h"
#include "platform/png_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace pliant::viewer {

int slides(const WindowOptions& o) {
    const std::filesystem::path folder(o.slides_folder);
    const LessonEntry& entry = find_lesson(o.lesson);
    const std::size_t count = walkthrough_of(entry).slides.size();
    const Size size = size_from(o.size);
    const Theme theme = o.theme.empty() ? Theme::projector : theme_from(o.theme);
    const float scale = o.ui_scale == 0 ? 1 : ui_scale_from(o.ui_scale);
    refuse_file_ending("--out", o.slides_folder);
    tell_unused(unused_settings(entry, walkthrough_of(entry)), o.strict);
    make_folder(folder);
    const auto context = open_headless(size);
    Lab lab(*context, entry.info.id);
    lab.set_theme(theme);
    lab.set_scale(scale);
    lab.state().layout = Layout::deck;
    for (std::size_t n = 0; n < count; ++n) {
        show_slide(lab.session(), n, !o.questions);
        const auto file = folder / fmt::format("slide_{:02}.png", n + 1);
        write_png(capture(lab, *context), file.string());
        print(file.string() + "\n");
    }
    return 0;
}

}  // namespace pliant::viewer
