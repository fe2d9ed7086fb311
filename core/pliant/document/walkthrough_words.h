// How the lines of a walkthrough fall into words.
#pragma once
#include <pliant/run/runner.h>

#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// Split at blanks.
std::vector<std::string> words_of_line(const std::string& line);
// "KEY=VALUE" words behind the first one. Throws Refused.
Runner::Assignments assignments_of(const std::vector<std::string>& words);
// Without the blanks at both ends.
std::string trimmed(std::string_view line);

}  // namespace pliant
