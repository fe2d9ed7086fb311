// What `pliant describe` tells of a lesson: what it declares, and the claims that stand beside it.
#pragma once
#include <pliant/lesson/registry.h>

#include <string>

namespace pliant {

std::string lesson_text(const LessonEntry& entry);
std::string lesson_json(const LessonEntry& entry);

// The page of the lesson in docs/lessons: why, the stages with their formulas and code, what its default scene and its claims
// come to, extensions, and tables of all that it declares. Runs the scene and measures the claims. sources: the folder that the
// files of the stages lie in, the root of the repository, or "": then their code is named and not shown. Throws Refused for a
// stage whose code is not there.
std::string lesson_markdown(const LessonEntry& entry, const std::string& sources);

}  // namespace pliant
