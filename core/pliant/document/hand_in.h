// What a student hands in: predictions, numbers, answers and pictures of one or several lessons, in one JSON file,
// NAME.handin.json:
//
//   {"pliant_handin": 1, "name": "Ada", "entries": [...], "checksum": "sha256:..."}
//
// An entry has a "kind" and "lesson", and
//   prediction   slide, question, predicted, came, right, words; and, to be played again, scene (as the slide was entered),
//                script (the events of its scene), left (as a person left it, where something was changed before the answer was
//                shown), slide_text (what it does and asks) and guess: {"option": 1}, {"number": 0.2} or {"sketch": [...]}
//   measurement  scene (a share string), step, passes, probe, value, unit; note
//   answer       slide, question, text; came and own_verdict ("right" or "not right") where it was given on a slide before the
//                lesson's own answer was shown, which is what came
//   picture      scene, step, passes, png (base64); note
// A prediction, or an answer, that was given when the lesson's answer had been seen has "after_answer": true.
// "time" is that of the simulation, s. The checksum is that of all else, so what was changed by hand is noticed; it does not
// prove who made the file, nor that nobody has computed it anew.
#pragma once
#include <pliant/document/prediction.h>
#include <pliant/run/runner.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

class WalkthroughPlayer;

struct HandInEntry {
    enum class Kind { prediction, measurement, answer, picture };
    Kind kind = Kind::answer;
    std::string lesson;                       // id
    std::string slide{}, question{};          // where it was asked; "" outside a walkthrough
    std::string predicted{}, came{}, text{};  // text: of an answer, the words of a verdict, or a note
    bool right = false;
    std::optional<bool> own_verdict{};  // of an answer: does the person say that it was right?
    bool after_answer = false;          // was it said when the lesson's own answer had been seen?
    std::string scene{};                // a share string: parameters and what was done
    Index step = 0, passes = 0;
    Real time = 0;  // s, simulated
    std::string probe{}, unit{};
    Real value = 0;
    std::string png{};  // base64
    // --- of a prediction ---
    std::string slide_text{};      // the blocks of its slide that play and judge it, as a walkthrough has them
    std::string script{}, left{};  // share strings; "" for none
    Guess guess{};
    bool operator==(const HandInEntry&) const = default;
};

struct HandIn {
    std::string name;  // as the student typed it
    std::vector<HandInEntry> entries{};
    bool operator==(const HandIn&) const = default;
};

// The file, with its checksum; it reads back as the same, numbers to the bit.
std::string hand_in_text(const HandIn& hand_in);

inline constexpr std::string_view hand_in_ending = ".handin.json";
// "ada_lovelace_mass_spring.handin.json": from the name and the lesson, or of several lessons "work"; the lesson where no entry
// names one. Without signs that a file system refuses.
std::string hand_in_file_name(const HandIn& hand_in, std::string_view lesson);

struct HandInRead {
    HandIn hand_in;
    bool unchanged = false;  // the checksum is that of the rest
};
// Throws Refused, with line and column, for what is no hand-in.
HandInRead read_hand_in(std::string_view text, std::string_view path);

// Where a run stands, and a probe there, as an entry. Throws Refused when the probe has no value.
HandInEntry measurement_of(const Runner& runner, std::string_view probe);
// What was predicted on a slide whose answer is shown, with all that plays it again.
HandInEntry prediction_of(const Runner& runner, const WalkthroughPlayer& player);

struct HandInFinding {
    bool repeated = false;  // was there something to repeat?
    bool holds = true;
    std::string words;
};
// Each measurement in its scene again: does the number come out, to a part in 10⁶? Each prediction on its slide again: is the
// verdict the same? Answers and pictures are not repeated. claim: repeats what was predicted of a claim; nothing where it is
// none.
using RepeatClaim = std::function<std::optional<HandInFinding>(const HandInEntry&)>;
std::vector<HandInFinding> check_hand_in(const HandIn& hand_in, const RepeatClaim& claim = {});
// The slide of a prediction, played again. Throws Refused and Diverged.
HandInFinding repeated_prediction(const HandInEntry& entry);

// For people, and as {"name", "unchanged", "holds", "entries": [{..., "repeated", "holds", "words"}]}.
std::string hand_in_report(const HandInRead& read, const std::vector<HandInFinding>& findings);
std::string hand_in_report_json(const HandInRead& read, const std::vector<HandInFinding>& findings);

}  // namespace pliant
