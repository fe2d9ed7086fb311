// The state of the lab as a file, rewritten in every frame and when the lab comes to rest: tests that drive the window by mouse
// and keys read it back, and so can a screen reader.
#pragma once
#include "app/lab_state.h"
#include "session/worker.h"

#include <optional>
#include <string>

namespace pliant::viewer {

// {"lesson", "step" (whole steps done), "passes", "step_shown" (the number that people see), "waiting": {key: {"now", "then"}}
// (for the next step), "stage", "time", "playing", "parameters": {...}, "probes": {...}, "pulling", "message",
// "autopsy" (the words of its card), "summary" (while it is shown), "patterns", "focus": {"control", "place"} (what the keys act
// on), "layout", "fill" (what fills the screen; else ""), "black" (the
// screen), "lens", "full_screen", "presenter" (what the
// window of the lecturer tells; null without it), "slide" (from 1; 0 without a walkthrough), "extension" (that is open, from 1;
// else 0), "revealed", "unlocked", "notes", "companion" (of run B; null without one), "pinned", "cost_shown", "frame" (how many
// were drawn), "busy": {"title", "line", "frames"} (of the card, while work takes long; else null), "resting" (no more is drawn
// until something changes), "inspector":
// {...}, "claims": {"shown", "all", "unfolded", "cards": {id: {"stage", "prediction", "right", "verdict", "figure"}}},
// "controls": {name: [x, y, width, height]}}
std::string state_json(const LabState& lab);

class StateReport {
public:
    // Writes to this path; nothing when it is empty.
    explicit StateReport(std::string path) : path_(std::move(path)) {}
    // Throws Refused when the file cannot be written.
    void write(const LabState& lab);
    // While the worker has the run: the state as it was written last, and the words and the button of the card.
    void write_busy(const BusyWords& words, const std::optional<Rectangle>& cancel, long frames);

private:
    std::string path_, last_;
};

}  // namespace pliant::viewer
