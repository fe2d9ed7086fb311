// The commands that find something out by many runs.
#include "command_line/commands.h"

#include "command_line/number_options.h"

#include <fmt/format.h>

namespace pliant::viewer {
namespace {

void add_claims_command(CLI::App& app, ClaimsOptions& o, std::function<int()>& action) {
    CLI::App* command = app.add_subcommand("claims", "what the lectures say of each method, measured now");
    command->add_option("id", o.ids, "such as E3; all when none is given");
    CLI::Option* json = command->add_flag("--json", o.json, "print one JSON object");
    command->add_flag("--markdown", o.markdown, "as the page of the documentation")->excludes(json);
    command->callback([&] { action = [&] { return claims(o); }; });
}

void add_study_command(CLI::App& app, RunOptions& run, StudyOptions& o, std::function<int()>& action) {
    CLI::App* command = app.add_subcommand("study", "where a lesson is stable: a map of two parameters, beside theory");
    command->add_option("lesson", run.lesson, lesson_help)->required();
    command
        ->add_option("--map", o.knobs,
                     "two knobs, across and up: KEY=FROM:TO:COUNT, KEY=FROM:TO:COUNT:log or KEY=VALUE,VALUE,...")
        ->required();
    command->add_option("--set", run.settings, "a parameter that all cells have, KEY=VALUE; may be given often")
        ->allow_extra_args(false);
    command->add_option("--preset", run.preset, "a scene that comes with the lesson");
    add_strict(*command, run.strict);
    add_number(*command, "--steps", o.steps, "steps of each cell, 200 when not given; a cell that is in doubt makes more");
    add_number(*command, "--time", o.time, "in place of --steps: simulated seconds of each cell");
    command->add_option("--probe", o.probe, "what is watched, \"energy\" when not given");
    add_number(*command, "--jobs", o.jobs, "threads, as many as the machine has when not given; the map does not depend on it");
    command->add_option("--out", o.out, "the folder for map.png, map.json and map.csv; made where it is missing")->required();
    command->add_option("--size", o.size, "of the picture, WIDTHxHEIGHT in pixels")->capture_default_str();
    add_number(*command, "--ui-scale", o.ui_scale, "of its type and lines, 1 to 3")->default_str(fmt::format("{}", o.ui_scale));
    command->add_option("--theme", o.theme, "dark or projector")->capture_default_str();
    command->callback([&] { action = [&] { return study(run, o); }; });
}

}  // namespace

void add_study_commands(CLI::App& app, CommandLine& o) {
    add_claims_command(app, o.claims, o.action);
    add_study_command(app, o.run, o.study, o.action);
}

}  // namespace pliant::viewer
