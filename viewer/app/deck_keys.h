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
    // Outside a deck: the ring is at a control that keys went to, not the mouse nor a panel that came up; Space acts on it.
    bool ring_has_space() const { return went_there_; }

private:
    void follow_ring();

    bool held_ = false;    // a text is typed, a list is open, or the ring is seen
    bool typing_ = false;  // of these, the first
    bool ring_ = false;    // of these, the last
    bool went_there_ = false;
    int going_ = 0;    // frames in which what a key asked for can still move the ring
    unsigned at_ = 0;  // the control with the ring, where no list is open
};

}  // namespace pliant::viewer
