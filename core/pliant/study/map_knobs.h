// The two axes of a stability map: a parameter of a lesson and the values that it takes.
#pragma once
#include <pliant/lesson/lesson.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

enum class Spacing { linear, log, list };

struct Knob {
    std::string key;
    Spacing spacing = Spacing::linear;
    std::vector<Real> values{};  // strictly ascending, except in a list; a choice counts its options from 0
};

inline constexpr Index most_knob_values = 512;

// `count` values from a to b, both included. Of a whole number they are rounded. Throws Refused for fewer than 2 or too many, a
// range that is empty or that the parameter does not accept, a choice or a switch, log spacing of what is not positive, and
// whole numbers that coincide.
Knob knob_of(const Parameter& parameter, Real a, Real b, Index count, Spacing spacing);
// A list: numbers, or the options of a choice. Throws Refused for fewer than 2 and for one that is given twice.
Knob knob_of(const Parameter& parameter, std::vector<Real> values);
// "time_step=1e-4:0.1:40:log", "omega=1:100:20", "scheme=explicit_euler,implicit_euler". Throws Refused.
Knob parse_knob(const Lesson& lesson, std::string_view text);
// The same text again.
std::string text_of(const Lesson& lesson, const Knob& knob);

// The range that its slider spans, in `count` values; every option of a choice or a switch.
Knob useful_knob(const Parameter& parameter, Index count);

// Can it be an axis now: does the scene use it, and does it take at least two values?
bool can_be_knob(const Parameter& parameter);
// Those that the lesson names, or its time step and what is most like a stiffness. Throws Refused when there are no two.
std::pair<const Parameter*, const Parameter*> first_knobs(const Lesson& lesson);

}  // namespace pliant
