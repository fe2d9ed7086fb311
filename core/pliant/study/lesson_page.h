// What `pliant describe` tells of a lesson: what it declares, and the claims that stand beside it.
#pragma once
#include <pliant/lesson/registry.h>

#include <string>

namespace pliant {

std::string lesson_text(const LessonEntry& entry);
std::string lesson_json(const LessonEntry& entry);
// The page of the lesson in docs/lessons.
std::string lesson_markdown(const LessonEntry& entry);

}  // namespace pliant
