// What a person predicts on a slide before the run goes on, and how it compares with what the run gives.
//
// A ```predict block asks for one of three things; its first line says which.
//   choice                                    a line for each answer: WORDS | CONDITION. The right one is the one whose
//   condition,
//                                             written as an expectation, the run meets
//   number PROBE within TOLERANCE [relative]  the probe after the actions
//   sketch PROBE over T s from A to B         a curve of the probe, drawn before the run into a plot of that span and height
//                                             (over N steps in a static lesson); it is right when it is off by at most 15 % of
//                                             the height, on average
// A slide that asks without such a block takes an answer in words, which only the person who gave it can judge.
#pragma once
#include <pliant/lesson/lesson.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pliant {

struct Block;

struct Prediction {
    enum class Kind { choice, number, sketch, words };
    struct Option {
        std::string words, condition;
        int line = 0;  // in the file
    };
    Kind kind = Kind::choice;
    std::vector<Option> options{};  // of a choice, at most 9
    std::string probe{};            // of a number or a sketch
    Real tolerance = 0;
    bool relative = false;
    Real span = 0;      // of a sketch: s or steps
    Interval height{};  // of a sketch, in the unit of the probe
};

// Throws Refused with the line of the file.
Prediction read_prediction(const Block& block, const std::string& path);
// What the probe has to be; throws Refused.
void check_prediction(const Prediction& prediction, const Lesson& lesson);

// A curve over the span of a sketch at equal distances, first and last included.
inline constexpr std::size_t sketch_points = 33;
using Sketch = std::vector<Real>;

// What a person says: a choice, a number, a sketch or an answer in words.
struct Guess {
    std::optional<std::size_t> option{};
    std::optional<Real> number{};
    Sketch sketch{};
    std::string words{};
    std::optional<bool> was_right{};  // of words: what the person says of them once the answer is shown
    bool after_answer = false;        // was the answer of the slide seen before?
    bool given() const { return option || number || !sketch.empty() || !words.empty(); }
    bool operator==(const Guess&) const = default;
};
inline constexpr std::size_t longest_answer = 500;  // bytes

// As many values as a sketch has, on straight lines between those given at equal distances: at least 2. Throws Refused.
Sketch sketch_through(const std::vector<Real>& values);
// "3, 5; 8" or "3 5 8", in the unit of the probe. Throws Refused, saying what is accepted.
Sketch sketch_typed(const std::string& text);

// What was measured from the start of the actions on: s or steps since then, and the probe.
using Track = std::vector<std::pair<Real, Real>>;
// The track where a sketch has its points; the last value behind its end. Empty without a track.
Sketch sampled(const Track& track, Real span);

struct PredictionVerdict {
    bool right = false;
    std::string predicted, came;  // "It grows", "0.2 rad/s"
    std::string words;            // all of it in sentences
};
// That a guess was made once the answer had been seen, behind such a verdict.
void note_after_answer(PredictionVerdict& verdict, const Guess& guess);

// met: which conditions of a choice hold now. measured: the probe now.
PredictionVerdict judge_choice(const Prediction& prediction, const Guess& guess, const std::vector<bool>& met);
PredictionVerdict judge_number(const Prediction& prediction, const Guess& guess, Real measured, const std::string& unit);
// It repeats the answer, and what the person says of it; it is never right by itself.
PredictionVerdict verdict_of_words(const Guess& guess);
PredictionVerdict judge_sketch(const Prediction& prediction, const Guess& guess, const Sketch& measured, const std::string& unit);

}  // namespace pliant
