// The program `pliant`: its commands, their options, and the exit codes.
#pragma once

namespace pliant::viewer {

// Does what the arguments ask for and returns the exit code (see ExitCode). Messages for people go to standard error.
int run_command_line(int argc, const char* const* argv);

}  // namespace pliant::viewer
