// Why is this number what it is? Any value of a run, traced to the stage that wrote it, its formula with the numbers put in, and
// its inputs, each of which can be asked again, down to parameters and the state before.
#pragma once
#include <pliant/run/runner.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pliant {

// After so many passes of a step; passes may reach the end of the step.
struct When {
    Index step = 0, passes = 0;
    auto operator<=>(const When&) const = default;
};
// As people count steps: of a value, the step that made it.
inline Index step_number(const When& when) { return step_number(Place{when.step, when.passes}); }
// The place where the runner stands, as the end of its latest step when it stands between two.
When now_of(const Runner& runner);

struct Answer {
    enum class Kind {
        computed,  // by a stage, or defined by other fields
        combined,  // the length of a vector, the norm of a tensor: of its components
        part,      // an intermediate result
        parameter,
        constant,
        state,  // what the step before left, or the initial state
        given   // a number that nothing explains further
    };
    Kind kind = Kind::given;
    std::string symbol{}, field{};  // field: or the probe, the key of the parameter, the meaning of a constant
    Index index = 0;
    int component = -1;
    bool of_probe = false;
    Real value = 0;
    std::string unit{}, stage{}, source{}, formula{}, substituted{};
    std::vector<Answer> inputs{};
    When when{};                  // of the value: where to ask again
    Real evaluated = 0;           // the formula, evaluated again from the inputs; value where there is none
    Real conditioning = 0;        // Σ |input · ∂formula/∂input|, of a part its own: the size of what cancels in the formula
    Real sensitivity = 0;         // of an input: |x ∂f/∂x| of the formula that it is put into, in the unit of what that gives
    std::string latex{};          // the formula; "" where it cannot be read as data
    std::string unit_check{};     // "ok", or what differs between the sides; "" where units or formula are not known
    bool wrong_unit = false;      // as the slide has it, on purpose
    std::string trouble{};        // why its formula cannot be read, and where it stands in the sources; "" where it can
    bool by_differences = false;  // of an input: a function without a formula takes it, whose slope is a difference
    bool together = false;        // of an input: an unknown of the same solve, found at once with what it is put into
    bool leftover = false;        // of an input: what that solve has left of the equation
    bool can_ask = false;         // has inputs that are not listed here for want of depth
};

// One number: of a field, or of a probe with the index 0; now, where no time is given.
struct AskedNumber {
    std::string_view field;
    Index index = 0;
    int component = -1;
    std::optional<When> when{};
};

// field: the name of a field or of a probe; "probe:NAME" where a probe bears the name of a field.
// The component -1 asks for the length of a vector or the norm of a tensor. depth: levels of inputs, at least 1. The run is where
// it was afterwards, to the bit. Throws Refused for a field, probe, index or component that does not exist, and for a time that
// is no longer stored.
Answer why(Runner& runner, std::string_view field, Index index, int component, int depth = 1,
           std::optional<When> when = std::nullopt);
// Many at once, with one way back through the run.
std::vector<Answer> why(Runner& runner, std::span<const AskedNumber> questions, int depth = 1);

// Is there a formula in it that cannot be evaluated?
bool has_trouble(const Answer& answer);

// "field, index, value, unit, step, passes, stage, formula, substituted, latex, unit_check, inputs[]", the inputs likewise down
// to the depth, and each with its sensitivity. step: as people count them, the one that made the value.
std::string why_json(const Answer& answer, int depth);
// For people: one line a value, inputs indented below it.
std::string why_text(const Answer& answer);
// "The sides differ in their unit: m/s on the left, m on the right."; "" where they do not, or nothing is known of them.
std::string unit_words(const Answer& answer);
// "Solved together with 1023 others: ..."; "" of what is not an unknown of a solve.
std::string words_of_solve(const Answer& answer, const Lesson& lesson);
// The inputs of an answer in the order in which people read them: of many, those that matter most come first.
std::vector<const Answer*> inputs_to_read(const Answer& answer);
// "velocity x of cell 413", "viscosity": what the number is.
std::string title_of(const Answer& answer, const Lesson& lesson);

}  // namespace pliant
