#include "command_line/command_line.h"

#include <pliant/study/claims.h>
#include <pliant/text/suggest.h>

#include "command_line/commands.h"
#include "command_line/terminal.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>
#include <system_error>

namespace pliant::viewer {
namespace {

constexpr const char* footer =
    "\nWithout a command the lab opens in a window.\n"
    "Exit codes: 0 done, 1 a check failed, 2 bad input refused, 3 the run diverged, 4 this machine lacks something.";

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
    CommandLine o;
    app.add_option("--lesson", o.window.lesson, "the lesson to open");
    app.add_option("--scene", o.window.scene_path, "the scene file to open, or a share string (pliant1:...)");
    add_strict(app, o.window.strict);
    add_window_options(app, o.window);
    add_listing_commands(app, o);
    add_run_commands(app, o);
    add_picture_commands(app, o);
    add_study_commands(app, o);
    add_slide_commands(app, o);

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
    return o.action ? o.action() : window(o.window);
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
