#include "command_line/command_line.h"

#include <pliant/math/parallel.h>
#include <pliant/study/claims.h>
#include <pliant/text/suggest.h>

#include "command_line/number_options.h"
#include "command_line/options.h"
#include "command_line/terminal.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <functional>
#include <sstream>
#include <system_error>

namespace pliant::viewer {
namespace {

constexpr const char* footer =
    "\nWithout a command the lab opens in a window.\n"
    "Exit codes: 0 done, 1 a check failed, 2 bad input refused, 3 the run diverged, 4 this machine lacks something.";

constexpr const char* lesson_help = "such as mesh/mass_spring; `pliant list` shows them";

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

[[noreturn]] void refuse_empty(const std::string& option, const std::string& meaning) {
    throw Refused(fmt::format("{} is empty ({}): give a value, or leave it out", option, meaning));
}

// An unset variable of a script is not a wish: no option takes an empty text.
void refuse_empty_values(CLI::App& app) {
    for (CLI::Option* o : app.get_options())
        if (o->get_items_expected_max() > 0)
            o->check([name = o->get_name(), meaning = o->get_description()](const std::string& text) {
                if (text.empty()) refuse_empty(name, meaning);
                return std::string();
            });
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) refuse_empty_values(*command);
}

// CLI11 would take the argument that follows for the value of "--scene=".
void check_values(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i)
        if (const std::string_view word = argv[i]; word.starts_with("--") && word.find('=') == word.size() - 1)
            refuse_empty(std::string(word), "nothing stands behind the sign");
}

// CLI11 would take a mistyped command for a stray argument.
void check_command(const CLI::App& app, int argc, const char* const* argv) {
    if (argc < 2 || argv[1][0] == '-') return;
    std::vector<std::string> known;
    for (const CLI::App* c : app.get_subcommands({})) known.push_back(c->get_name());
    if (std::ranges::find(known, argv[1]) != known.end()) return;
    throw Refused(
        fmt::format("no command is called '{}'{}; there are: {}", argv[1], did_you_mean(argv[1], known), fmt::join(known, ", ")));
}

int dispatch(int argc, const char* const* argv) {
    pliant::claims();  // a ledger that is not whole is refused before anything else
    CLI::App app("Pliant, a laboratory for physically based simulation: stop inside a time step and look at every quantity.",
                 "pliant");
    app.footer(footer);
    app.set_version_flag("--version", "pliant " PLIANT_VERSION);
    std::function<int()> action;
    RunOptions run_options;
    PictureOptions picture_options;
    WindowOptions window_options;
    WhyOptions why_options;
    ClaimsOptions claims_options;
    StudyOptions study_options;
    WalkthroughOptions walkthrough_options;
    LectureOptions lecture_options;
    std::string lesson, folder = "out/tour", sources, over, handed_in;
    std::vector<std::string> stops;
    bool json = false, markdown = false, strict = false;

    app.add_option("--lesson", window_options.lesson, "the lesson to open");
    app.add_option("--scene", window_options.scene_path, "the scene file to open, or a share string (pliant1:...)");
    add_strict(app, window_options.strict);
    add_window_options(app, window_options);

    CLI::App* list = app.add_subcommand("list", "the lessons");
    list->add_flag("--json", json, "as JSON");
    list->callback([&] { action = [&] { return list_lessons(json); }; });

    CLI::App* keys_command = app.add_subcommand("keys", "the keys of the lab, and what the mouse does");
    keys_command->add_flag("--markdown", markdown, "as the page of the documentation");
    keys_command->callback([&] { action = [&] { return list_keys(markdown); }; });

    CLI::App* describe_command = app.add_subcommand("describe", "parameters, stages, fields, probes and claims of a lesson");
    describe_command->add_option("lesson", lesson, lesson_help)->required();
    describe_command->add_flag("--json", json, "as JSON");
    describe_command->add_flag("--markdown", markdown, "as the page of the documentation");
    describe_command->add_option("--sources", sources,
                                 "with --markdown: the folder of the sources, whose code the page then shows");
    describe_command->callback([&] { action = [&] { return describe(lesson, json, markdown, sources); }; });

    CLI::App* run_command = app.add_subcommand("run", "run a lesson and print its probes, assumptions and costs");
    add_run_options(*run_command, run_options);
    run_command->add_option("--csv", run_options.csv_path, "write the probes of every step to this file");
    CLI::Option* run_json_flag = run_command->add_flag("--json", run_options.json, "print one JSON object");
    run_command->add_flag("--summary", run_options.summary, "print how the run stands in plain sentences")
        ->excludes(run_json_flag);
    run_command->callback([&] { action = [&] { return run(run_options); }; });

    CLI::App* hand_in_command =
        app.add_subcommand("handin", "what a student handed in: does each number come out, was the file changed by hand?");
    hand_in_command->add_option("file", handed_in, "NAME.handin.json")->required();
    hand_in_command->add_flag("--json", json, "print one JSON object");
    hand_in_command->callback([&] { action = [&] { return hand_in(handed_in, json); }; });

    CLI::App* compare_command =
        app.add_subcommand("compare", "all methods of a lesson in one scene: what lasts, how wrong it is, what it costs");
    add_run_options(*compare_command, run_options);
    compare_command->add_option("--over", over,
                                "the choice whose options are compared; that of the lesson's methods when not given");
    compare_command->add_flag("--json", run_options.json, "print one JSON object");
    compare_command->callback([&] { action = [&] { return compare(run_options, over); }; });

    CLI::App* why_command = app.add_subcommand("why", "how a number came about: its stage, formula and inputs");
    add_run_options(*why_command, run_options);
    why_command->add_option("--field", why_options.field, "a field or a probe")->required();
    add_number(*why_command, "--index", why_options.index, "the node, spring, cell, ... counted from 0");
    add_number(*why_command, "--component", why_options.component, "of a vector or tensor, from 0; -1 for its length");
    why_command->add_option("--stage", why_options.stage, "go on to the end of this stage, inside the next step, and ask there");
    add_number(*why_command, "--depth", why_options.depth, "how many levels of inputs to ask in turn")
        ->default_str(fmt::format("{}", why_options.depth));
    why_command->add_flag("--json", run_options.json, "print one JSON object");
    why_command->callback([&] { action = [&] { return why(run_options, why_options); }; });
    add_claims_command(app, claims_options, action);
    add_study_command(app, run_options, study_options, action);
    CLI::App* share_command = app.add_subcommand("share", "print a scene as one line of text, for a chat");
    add_scene_options(*share_command, run_options);
    share_command->callback([&] { action = [&] { return share(run_options); }; });

    CLI::App* shot_command = app.add_subcommand("shot", "run a lesson and write its picture");
    add_run_options(*shot_command, run_options);
    add_picture_options(*shot_command, picture_options);
    shot_command->callback([&] { action = [&] { return shot(run_options, picture_options); }; });

    CLI::App* tour_command = app.add_subcommand("tour", "every lesson: pictures, probes as CSV and an index page");
    tour_command->add_option("lesson", stops, "the lessons to show, all when none is named");
    tour_command->add_option("--out", folder, "the folder to write")->capture_default_str();
    add_strict(*tour_command, strict);
    tour_command->callback([&] { action = [&] { return tour(folder, stops, strict); }; });

    add_walkthrough_command(app, window_options, walkthrough_options, action);
    add_lecture_command(app, window_options, lecture_options, action);

    refuse_empty_values(app);
    check_values(argc, argv);
    check_command(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) {
        std::ostringstream text;
        app.exit(e, text, text);
        print(text.str());
        return 0;
    } catch (const CLI::ParseError& e) {
        throw Refused(fmt::format("{}; `pliant {}--help` shows what is accepted", e.what(),
                                  argc > 1 && argv[1][0] != '-' ? std::string(argv[1]) + " " : ""));
    }
    return action ? action() : window(window_options);
}

// The exit code; what goes wrong is told.
int dispatched(int argc, const char* const* argv) {
    try {
        return dispatch(argc, argv);
    } catch (const Error& e) {
        tell(e.what());
        return static_cast<int>(e.code());
    } catch (const std::bad_alloc&) {
        tell("there is not enough memory for this: lower the resolution or the number of cells");
        return static_cast<int>(ExitCode::refused);
    } catch (const std::system_error& e) {
        tell(fmt::format("this machine does not do what is needed: {}", e.what()));
        return static_cast<int>(ExitCode::machine_lacks);
    }
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    take_standard_descriptors();
    return after_output(dispatched(argc, argv));
}

}  // namespace pliant::viewer
