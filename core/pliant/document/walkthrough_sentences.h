// What a walkthrough does and expects, as it is said to a person: in its file the lines are for programs.
#pragma once
#include <pliant/lesson/lesson.h>

#include <functional>
#include <string>
#include <string_view>

namespace pliant {

struct Slide;

// Of the key of a parameter: must its value not be told?
using Hides = std::function<bool(std::string_view)>;

// "set ν to 0.45 and Method to “one linear step”", "run 50 steps", "run until nothing changes any more". A line that is none of
// the actions stays as it is.
std::string action_sentence(const Lesson& lesson, const std::string& line, const Hides& hidden = {});

// What Next does on a slide whose answer does not show: "Next: run 50 steps". Beside a question it says no more than the kind,
// "Next: sets it and runs", since a value may answer it. "" where nothing waits for Next.
std::string next_sentence(const Lesson& lesson, const Slide& slide);

// "the stretch is 0.38, expected above 0.34". name: of a probe or a parameter, or time or step; comparison as the walkthrough
// writes it; tolerance: of "=", in the unit of the number, relative: a part of `right`. what: of the right side, where it is no
// plain number: "the exact value", "before".
struct ExpectedNumber {
    std::string_view name, comparison;
    Real left = 0, right = 0, tolerance = 0;
    bool relative = false;
    std::string what{};
};
std::string expectation_sentence(const Lesson& lesson, const ExpectedNumber& expected);

}  // namespace pliant
