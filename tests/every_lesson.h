// The lessons that a generic test goes through: all of them, or the one that the environment names in PLIANT_LESSON. ctest runs
// the cases with the tag [every_lesson] once for each lesson, under the lesson's label.
#pragma once
#include <pliant/lesson/registry.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace pliant::test {

// "" for all.
inline std::string lesson_asked_for() {
    const char* name = std::getenv("PLIANT_LESSON");
    return name ? name : "";
}

inline bool is_asked_for(std::string_view id) { return lesson_asked_for().empty() || lesson_asked_for() == id; }

// Throws Refused for a name that no lesson has.
inline std::vector<std::reference_wrapper<const LessonEntry>> every_lesson() {
    if (const std::string name = lesson_asked_for(); !name.empty()) return {find_lesson(name)};
    return {lessons().begin(), lessons().end()};
}

}  // namespace pliant::test
