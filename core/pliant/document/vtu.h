// What a run has found, for programs that read the files of VTK, such as ParaView.
#pragma once
#include <pliant/run/runner.h>

#include <string>
#include <vector>

namespace pliant {

// Throws Refused where the lesson shows no body and no grid.
void require_grid(const LessonEntry& entry, const Lesson& lesson);

// The grid of a lesson as it is now, with every field in use: on points and cells where it has a row for each, else as an array
// of its own (FieldData); the time [s] as TimeValue. Vectors of two numbers are written with a third, 0, and tensors of 2 × 2 as
// 3 × 3. Throws Refused as require_grid, and for a number that is not finite.
std::string vtu_text(const LessonEntry& entry, const Lesson& lesson, Real time);

// Files of one run: the time [s] and the path of each, as seen from the collection.
struct VtuFrame {
    Real time = 0;
    std::string path;
};
// The .pvd that ties them together.
std::string pvd_text(const std::vector<VtuFrame>& frames);

}  // namespace pliant
