// The commands of the program as CLI11 reads them: what each takes, and what it then does.
#pragma once
#include "command_line/options.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace pliant::viewer {

// Where the options of all commands are kept, and what is to be done.
struct CommandLine {
    std::function<int()> action;
    RunOptions run;
    PictureOptions picture;
    WindowOptions window;
    WhyOptions why;
    ClaimsOptions claims;
    StudyOptions study;
    WalkthroughOptions walkthrough;
    LectureOptions lecture;
    std::string lesson, folder = "out/tour", sources, over, handed_in;
    std::vector<std::string> stops;
    bool json = false, markdown = false, strict = false;
};

inline constexpr const char* lesson_help = "such as mesh/mass_spring; `pliant list` shows them";

// --- options that several commands take ---
void add_threads(CLI::App& command);
void add_strict(CLI::App& command, bool& strict);
void add_scene_options(CLI::App& command, RunOptions& options);
void add_run_options(CLI::App& command, RunOptions& options);
void add_window_options(CLI::App& command, WindowOptions& options);

// --- commands; what they read stays in `line` ---
void add_listing_commands(CLI::App& app, CommandLine& line);  // list, keys, describe
void add_run_commands(CLI::App& app, CommandLine& line);      // run, handin, compare, why, share
void add_picture_commands(CLI::App& app, CommandLine& line);  // shot, tour
void add_study_commands(CLI::App& app, CommandLine& line);    // claims, study
void add_slide_commands(CLI::App& app, CommandLine& line);    // walkthrough, lecture

}  // namespace pliant::viewer
