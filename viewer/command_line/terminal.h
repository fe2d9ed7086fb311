// Standard output and standard error. Neither can end a run: what fails on standard output is told at the end, and what cannot be
// told on standard error is left unsaid.
#pragma once
#include <pliant/math/error.h>

#include <string_view>

namespace pliant::viewer {

// Call first. A descriptor from 0 to 2 that is closed is taken, so that no file that is opened later gets its number, and whoever
// stops reading does not end the program.
void take_standard_descriptors();

// To standard output.
void print(std::string_view text);
// The same, at once.
void print_now(std::string_view text);

// To standard error: a line that begins with "pliant: ".
void tell(std::string_view sentence);
// To standard error as it is, at once: progress on a terminal.
void tell_raw(std::string_view text);

// The exit code of a program that would end with `code`: instead of 0 that of a refusal when standard output could not be
// written, which is told. A reader that has gone wanted no more, and is no reason.
int after_output(int code);

}  // namespace pliant::viewer
