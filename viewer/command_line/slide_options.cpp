// The commands that show slides: of a lesson, and of a lecture.
#include "command_line/commands.h"

#include "command_line/number_options.h"

#include <fmt/format.h>

namespace pliant::viewer {
namespace {

// What the pictures of slides and the window of a deck have in common.
bool of_pictures(const CLI::Option& o) { return o.check_name("--size") || o.check_name("--theme") || o.check_name("--ui-scale"); }

// Size, theme and the like where nothing is drawn.
void refuse_look_of_nothing(const CLI::Option_group& look, bool draws) {
    for (const CLI::Option* option : look.get_options())
        if (option->count() > 0 && !draws) throw Refused(fmt::format("{} is for --present or --out", option->get_name()));
}

void add_presenter(CLI::App& command, WindowOptions& o, CLI::Option* present) {
    command.add_flag("--presenter", o.presenter, "with --present: a second window for the lecturer, with notes and clock")
        ->needs(present);
}

void add_walkthrough_command(CLI::App& app, WindowOptions& o, WalkthroughOptions& headless, std::function<int()>& action) {
    CLI::App* command = app.add_subcommand("walkthrough", "play the walkthrough of a lesson");
    command->add_option("lesson", o.lesson, lesson_help)->required();
    CLI::Option* checks = command->add_flag("--check", headless.check, "exit with 1 when an expectation is missed");
    CLI::Option* present =
        command->add_flag("--present", o.deck, "show it in a window, as a deck for a lecture")->excludes(checks);
    add_presenter(*command, o, present);
    command->add_flag("--notes", o.notes, "print the lecturer's notes as well");
    CLI::Option* out = command->add_option("--out", o.slides_folder,
                                           "the folder for slide_01.png and so on, a picture of each "
                                           "slide with its answer; made where it is missing");
    out->excludes(checks)->excludes(present);
    command->add_flag("--questions", o.questions, "with --out: the slides without their answers")->needs(out);
    add_strict(*command, o.strict);
    CLI::Option_group* look = command->add_option_group("window", "with --present; size, theme and scale with --out as well");
    add_window_options(*look, o);
    for (CLI::Option* option : look->get_options())
        if (!of_pictures(*option)) option->needs(present);
    command->callback([&o, &headless, &action, look, present, out] {
        const bool pictures = out->count() > 0;
        refuse_look_of_nothing(*look, pictures || present->count() > 0);
        headless.notes = o.notes, headless.strict = o.strict;
        action = [&o, &headless, pictures] {
            return pictures ? slides(o) : o.deck ? window(o) : walkthrough(o.lesson, headless);
        };
    });
}

void add_lecture_command(CLI::App& app, WindowOptions& o, LectureOptions& l, std::function<int()>& action) {
    CLI::App* command = app.add_subcommand("lecture", "a lecture in one file: slides of several lessons, one after the other");
    command->add_option("file", l.path, "the lecture, .json or .md")->required();
    CLI::Option* checks =
        command->add_flag("--check", l.check, "play every slide, and exit with 1 when an expectation is missed");
    CLI::Option* present = command->add_flag("--present", l.present, "show it in a window")->excludes(checks);
    add_presenter(*command, o, present);
    CLI::Option* out = command->add_option(
        "--out", l.folder, "the folder for slide_01.png and so on, lecture.pdf and handout.html; made where it is missing");
    out->excludes(checks)->excludes(present);
    command->add_flag("--questions", l.questions, "with --out: the slides without their answers")->needs(out);
    add_number(*command, "--slide", o.slide, "with --present: the slide to begin with, from 1; where it was left when not given")
        ->needs(present);
    CLI::Option_group* look = command->add_option_group("window", "with --present; size, theme and scale with --out as well");
    add_window_options(*look, o);
    for (CLI::Option* option : look->get_options())
        if (!of_pictures(*option)) option->needs(present);
    command->callback([&o, &l, &action, look] {
        refuse_look_of_nothing(*look, l.present || !l.folder.empty());
        o.lecture = l.present ? l.path : "";
        action = [&o, &l] { return lecture(l, o); };
    });
}

}  // namespace

void add_slide_commands(CLI::App& app, CommandLine& o) {
    add_walkthrough_command(app, o.window, o.walkthrough, o.action);
    add_lecture_command(app, o.window, o.lecture, o.action);
}

}  // namespace pliant::viewer
