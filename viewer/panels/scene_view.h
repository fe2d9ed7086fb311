// A picture in the window, and what the panel does with it.
#pragma once
#include "panels/scene_panel.h"

#include <initializer_list>
#include <string_view>
#include <vector>

namespace pliant::viewer {

struct View {
    KeptPicture picture;
    Projection projection;
    ImVec2 origin, size;
    const Lesson* lesson;  // whose numbers are read out; none in a picture of the past
    std::string heading;   // the name of the run or moment, where there are two
    bool first = true;     // the picture of A or of now, or the only one
    int dimension = 3;
    float above = 0;        // px of the strip over it that its notes stand in
    float label_width = 0;  // px from its left edge that words may take: the colour bar has the rest
};

// The size of marks and words in the picture against those of the lab.
float mark_scale(const PanelContext& lab);

// Words over the picture, at their marks. Gives where they are in the window.
std::vector<Rectangle> draw_labels(PanelContext& lab, ScenePanelState& panel, const View& view);

// What is said above a picture: the name of the run or moment, where there are two, and the notes of the lesson.
struct Notes {
    std::string_view heading;
    const std::vector<std::string>* lines;
};
// The height of the strip that they take above pictures of this width, px. It grows with them but does not shrink within a run,
// lest the picture jump, and leaves the picture two thirds of the room.
float notes_height(PanelContext& lab, ScenePanelState& panel, std::initializer_list<Notes> notes, float width, float room);
// Into the strip above the picture.
void draw_notes(PanelContext& lab, ScenePanelState& panel, const View& view);

// A ring around the thing that is inspected, or where the run broke down.
void mark_thing(PanelContext& lab, const View& view);
// A ring around the thing under the pointer, and all that is known of it.
void read_out(PanelContext& lab, const View& view, const Picked& picked);

// Turns, moves, pulls and picks by the mouse over the last item.
void handle_mouse(PanelContext& lab, ScenePanelState& panel, const View& view);
// Where the things to drag are, by name.
void note_handles(PanelContext& lab, const View& view);

}  // namespace pliant::viewer
