// Lessons register themselves; nothing else lists them.
#pragma once
#include <pliant/lesson/lesson.h>

#include <memory>
#include <string_view>
#include <vector>

namespace pliant {

struct LessonInfo {
    std::string_view id;       // "mesh/mass_spring": chapter/lesson
    std::string_view title;    // "Mass–spring lattice"
    std::string_view summary;  // one sentence for the list
    Index demo_steps = 100;    // steps after which its picture is worth showing; what `run` does when not told
};

struct LessonEntry {
    LessonInfo info;
    std::unique_ptr<Lesson> (*make)();
    std::string_view chapter() const { return info.id.substr(0, info.id.find('/')); }
};

// All lessons, chapter by chapter in the order of the lectures.
const std::vector<LessonEntry>& lessons();

// By id, or by the part after the chapter. Throws Refused with the nearest known lesson.
const LessonEntry& find_lesson(std::string_view name);

void register_lesson(const LessonEntry& entry);

// At namespace scope of a lesson's source:
//   const Registration<MassSpring> registration{{.id = "mesh/mass_spring", .title = ..., .summary = ...}};
template <class L>
struct Registration {
    explicit Registration(const LessonInfo& info) {
        register_lesson({info, [] { return std::unique_ptr<Lesson>(new L); }});
    }
};

}  // namespace pliant
