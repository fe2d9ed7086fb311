// The commands that tell what there is, and those that run a scene.
#include "command_line/commands.h"

#include "command_line/number_options.h"

namespace pliant::viewer {

void add_listing_commands(CLI::App& app, CommandLine& o) {
    CLI::App* list = app.add_subcommand("list", "the lessons");
    list->add_flag("--json", o.json, "as JSON");
    list->callback([&o] { o.action = [&o] { return list_lessons(o.json); }; });

    CLI::App* keys_command = app.add_subcommand("keys", "the keys of the lab, and what the mouse does");
    keys_command->add_flag("--markdown", o.markdown, "as the page of the documentation");
    keys_command->callback([&o] { o.action = [&o] { return list_keys(o.markdown); }; });

    CLI::App* describe_command = app.add_subcommand("describe", "parameters, stages, fields, probes and claims of a lesson");
    describe_command->add_option("lesson", o.lesson, lesson_help)->required();
    describe_command->add_flag("--json", o.json, "as JSON");
    describe_command->add_flag("--markdown", o.markdown, "as the page of the documentation");
    describe_command->add_option("--sources", o.sources,
                                 "with --markdown: the folder of the sources, whose code the page then shows");
    describe_command->callback([&o] { o.action = [&o] { return describe(o.lesson, o.json, o.markdown, o.sources); }; });
}

void add_run_commands(CLI::App& app, CommandLine& o) {
    CLI::App* run_command = app.add_subcommand("run", "run a lesson and print its probes, assumptions and costs");
    add_run_options(*run_command, o.run);
    run_command->add_option("--csv", o.run.csv_path, "write the probes of every step to this file");
    run_command->add_option("--vtu", o.run.vtu_path,
                            "write the last state, with all fields, to this .vtu, or every step to this .pvd and a folder");
    CLI::Option* run_json_flag = run_command->add_flag("--json", o.run.json, "print one JSON object");
    run_command->add_option("--fields", o.run.fields, "fields whose numbers go into the JSON, as a,b")->needs(run_json_flag);
    run_command->add_flag("--summary", o.run.summary, "print how the run stands in plain sentences")->excludes(run_json_flag);
    run_command->callback([&o] { o.action = [&o] { return run(o.run); }; });

    CLI::App* hand_in_command = app.add_subcommand(
        "handin", "what a student handed in: does each number and prediction come out again, was the file changed by hand?");
    hand_in_command->add_option("file", o.handed_in, "NAME.handin.json")->required();
    hand_in_command->add_flag("--json", o.json, "print one JSON object");
    hand_in_command->callback([&o] { o.action = [&o] { return hand_in(o.handed_in, o.json); }; });

    CLI::App* compare_command =
        app.add_subcommand("compare", "all methods of a lesson in one scene: what lasts, how wrong it is, what it costs");
    add_run_options(*compare_command, o.run);
    compare_command->add_option("--over", o.over,
                                "the choice whose options are compared; that of the lesson's methods when not given");
    compare_command->add_flag("--json", o.run.json, "print one JSON object");
    compare_command->callback([&o] { o.action = [&o] { return compare(o.run, o.over); }; });

    CLI::App* why_command = app.add_subcommand("why", "how a number came about: its stage, formula and inputs");
    add_run_options(*why_command, o.run);
    why_command->add_option("--field", o.why.field, "a field or a probe")->required();
    add_number(*why_command, "--index", o.why.index, "the node, spring, cell, ... counted from 0");
    add_number(*why_command, "--component", o.why.component, "of a vector or tensor, from 0; -1 for its length");
    why_command->add_option("--stage", o.why.stage, "go on to the end of this stage, inside the next step, and ask there");
    add_number(*why_command, "--depth", o.why.depth, "how many levels of inputs to ask in turn")
        ->default_str(fmt::format("{}", o.why.depth));
    why_command->add_flag("--json", o.run.json, "print one JSON object");
    why_command->callback([&o] { o.action = [&o] { return why(o.run, o.why); }; });
    CLI::App* share_command = app.add_subcommand("share", "print a scene as one line of text, for a chat");
    add_scene_options(*share_command, o.run);
    share_command->callback([&o] { o.action = [&o] { return share(o.run); }; });
}

}  // namespace pliant::viewer
