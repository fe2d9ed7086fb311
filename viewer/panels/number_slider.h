// The slider of a number, with scales of ours: a mouse reaches every useful value, and keys and wheel go by sensible steps.
#pragma once
#include "panels/slider_scale.h"

#include <imgui.h>

#include <optional>

namespace pliant::viewer {

// The drag that goes on, or the latest one: there is one pointer.
struct SliderDrag {
    ImGuiID slider = 0;
    Real began_with = 0;  // its value then: what it spans does not change while it is dragged
    Real place = 0;       // where the hand is, also beyond the ends
    bool moves = false;   // a press on the grip alone changes nothing
    bool joins = false;   // the next change is of one hand with the one before: one step of undo
};

// Draws it, as wide as the next item is to be. Gives the value that a hand sets in this frame: by a drag (with Shift ten times as
// finely), by the wheel over it with Alt or while the keys act on it, or, with_arrows, by ← and → (with Shift finer).
std::optional<Real> number_slider(const char* label, const Parameter& parameter, bool extreme, Real value, SliderDrag& drag,
                                  bool with_arrows);

}  // namespace pliant::viewer
