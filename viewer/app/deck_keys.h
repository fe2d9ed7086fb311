// What a key of the lab does, it does not do to the focus as well; and in a deck a control has the keys only after Tab went to
// it.
#pragma once

namespace pliant::viewer {

class DeckKeys {
public:
    // Behind the start of a frame of ImGui, before its keys are handled.
    void begin_frame(bool deck, bool card = false);
    // Before its end.
    void end_frame(bool deck);
    // The deck gets its keys back. False when it had them.
    bool let_go();

private:
    bool held_ = false;    // a text is typed, a list is open, or the ring is seen
    bool typing_ = false;  // of these, the first
    bool ring_ = false;    // of these, the last
};

}  // namespace pliant::viewer
