// The commands that make pictures.
#include "command_line/commands.h"

#include "command_line/number_options.h"

#include <fmt/format.h>

namespace pliant::viewer {
namespace {

void add_picture_options(CLI::App& command, PictureOptions& o) {
    command.add_option("--out", o.out, "the PNG file to write, or with --seconds the GIF file")->required();
    add_number(command, "--seconds", o.seconds, "play on and write so many seconds as an animated GIF, 1 to 30");
    add_number(command, "--fps", o.frames_per_second, "its frames per second, 1 to 50")
        ->default_str(fmt::format("{}", o.frames_per_second));
    command.add_option("--stage", o.stage, "go on to the end of this stage, inside the next step");
    command.add_option("--field", o.field, "the field that colours the picture");
    add_number(command, "--component", o.component, "its component, from 0; -1 for the whole");
    command.add_flag("--patterns", o.patterns, "show the sign by patterns as well as by colours");
    command.add_option("--size", o.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_number(command, "--ui-scale", o.ui_scale, "of type and lines, 1 to 3")->default_str(fmt::format("{}", o.ui_scale));
    command.add_option("--theme", o.theme, "dark or projector")->capture_default_str();
    command.add_option("--layout", o.layout, "slide (picture, plots, numbers), lab (all panels), deck or presenter (--slide)")
        ->capture_default_str();
    add_number(command, "--slide", o.slide, "with --layout deck or presenter: the slide of the walkthrough, from 1");
    command.add_flag("--revealed", o.revealed, "with --layout deck or presenter: with the answer");
    command.add_option("--beside", o.beside, "KEY=VALUE: a second run, B, with this change, beside the first; may be repeated")
        ->allow_extra_args(false);
    command.add_flag("--difference", o.difference, "with --beside: the difference of the two runs in one picture");
    command.add_option("--claim", o.claim, "with --layout lab: the card of this claim, such as E3, measured");
    command.add_flag("--atlas", o.atlas, "with --layout lab: the stability map of the lesson's first knobs");
    command.add_option("--fill", o.fill, "what fills the picture: picture, matrix, atlas, or a plot, as in 'plot energy'");
    command.add_option("--backend", o.backend, "any, osmesa or egl")->capture_default_str();
}

}  // namespace

void add_picture_commands(CLI::App& app, CommandLine& o) {
    CLI::App* shot_command = app.add_subcommand("shot", "run a lesson and write its picture");
    add_run_options(*shot_command, o.run);
    add_picture_options(*shot_command, o.picture);
    shot_command->callback([&o] { o.action = [&o] { return shot(o.run, o.picture); }; });

    CLI::App* tour_command = app.add_subcommand("tour", "every lesson: pictures, probes as CSV and an index page");
    tour_command->add_option("lesson", o.stops, "the lessons to show, all when none is named");
    tour_command->add_option("--out", o.folder, "the folder to write")->capture_default_str();
    add_strict(*tour_command, o.strict);
    tour_command->callback([&o] { o.action = [&o] { return tour(o.folder, o.stops, o.strict); }; });
}

}  // namespace pliant::viewer
