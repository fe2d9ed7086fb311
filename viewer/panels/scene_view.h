// A picture in the window, and what the panel does with it.
#pragma once
#include "panels/lab_state.h"

namespace pliant::viewer {

struct View {
    KeptPicture picture;
    Projection projection;
    ImVec2 origin, size;
    const Lesson* lesson;  // whose numbers are read out; none in a picture of the past
    std::string heading;   // the name of the run or moment, where there are two
    bool first = true;     // the picture of A or of now, or the only one
    int dimension = 3;
};

// The size of marks and words in the picture against those of the lab.
float mark_scale(const LabState& lab);

// Words over the picture: at their marks, and in its corner.
void draw_labels(LabState& lab, const View& view);
void draw_notes(LabState& lab, const View& view);

// A ring around the thing that is inspected, or where the run broke down.
void mark_thing(LabState& lab, const View& view);
// A ring around the thing under the pointer, and all that is known of it.
void read_out(LabState& lab, const View& view, const Picked& picked);

// Turns, moves, pulls and picks by the mouse over the last item.
void handle_mouse(LabState& lab, const View& view);
// Where the things to drag are, by name.
void note_handles(LabState& lab, const View& view);

}  // namespace pliant::viewer
