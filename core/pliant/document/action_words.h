// What a walkthrough does and expects, in words for people.
#pragma once
#include <pliant/lesson/lesson.h>

#include <string>

namespace pliant {

// "set scene=spin time_step=2e-3" becomes "Set scene to spin, and time step to 2 ms". A line that is none of these stays as it
// is.
std::string action_words(const std::string& line, const Lesson& lesson);
// "energy > 0.5 before" becomes "energy above half ..." in plain signs: "energy > 0.5 times its value before".
std::string expectation_words(const std::string& line, const Lesson& lesson);

}  // namespace pliant
