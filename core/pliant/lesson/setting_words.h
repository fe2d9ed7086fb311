// Parameters and their values as people say them: the one place that turns a setting into words, with the name, the value and the
// unit of the parameter.
#pragma once
#include <pliant/lesson/lesson.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

// "20 ms", "“implicit Euler”", "on".
std::string value_words(const Parameter& parameter, Real value);
// A parameter and a value of it: "time step to 20 ms", with "to" between the two, or "time step 20 ms" without.
std::string setting_words(const Parameter& parameter, Real value, std::string_view between = "");
// Keys with values as a scene writes them: "time step to 20 ms and ground to off". Throws Refused for what the lesson does not
// know.
std::string settings_words(const Lesson& lesson, const std::vector<std::pair<std::string, std::string>>& settings,
                           std::string_view between = "");
// "0 to 1000 TN/m", "above 0 to 1", "0 to below 1".
std::string range_words(const Interval& range, std::string_view unit);
// What went wrong with this parameter, for whoever does not see its key: "time_step = 3 kg is ..." begins with its name.
std::string refusal_words(const Parameter& parameter, std::string_view refusal);

// "a", "a and b", "a, b and c".
std::string listed_words(const std::vector<std::string>& parts);

}  // namespace pliant
