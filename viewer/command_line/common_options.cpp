// Options that several commands take.
#include <pliant/math/parallel.h>

#include "command_line/commands.h"

#include "command_line/number_options.h"

namespace pliant::viewer {

void add_threads(CLI::App& command) {
    command
        .add_option_function<std::string>(
            "--threads", [](const std::string& count) { set_threads(number_options::whole_from<int>("--threads", count)); },
            "of the fluid solvers, 1 when not given; the results do not depend on it")
        ->type_name("INT");
}

void add_strict(CLI::App& command, bool& strict) {
    command.add_flag(
        "--strict", strict,
        "refuse parameters that are set and have no effect in the scene; without it they are told on standard error");
}

void add_scene_options(CLI::App& command, RunOptions& o) {
    command.add_option("lesson", o.lesson, lesson_help);
    command.add_option("--set", o.settings, "a parameter, KEY=VALUE; may be given often")->allow_extra_args(false);
    command.add_option("--scene", o.scene_path, "a scene file, or a share string (pliant1:...)");
    command.add_option("--preset", o.preset, "a scene that comes with the lesson");
    add_strict(command, o.strict);
}

void add_run_options(CLI::App& command, RunOptions& o) {
    add_scene_options(command, o);
    add_number(command, "--steps", o.steps, "run so many steps");
    add_number(command, "--time", o.time, "run so many simulated seconds, to the nearest whole step");
    command.add_flag("--rest", o.rest, "run until nothing changes any more; refused where the scene never comes to rest");
    add_threads(command);
}

void add_window_options(CLI::App& command, WindowOptions& o) {
    add_threads(command);
    command.add_option("--size", o.size, "of the window")->capture_default_str();
    command.add_option("--theme", o.theme, "dark or projector; as it was last when not given");
    add_number(command, "--ui-scale", o.ui_scale,
               "of type and lines, 1 to 3; as it was last, or as the screen asks, when not given");
    command.add_flag("--no-settings", o.no_settings, "neither read nor keep what was set in earlier windows");
    add_number(command, "--frames", o.frames, "close after so many frames");
    command.add_option("--state", o.state_path, "keep the state of the lab in this JSON file, for tests and screen readers");
}

}  // namespace pliant::viewer
