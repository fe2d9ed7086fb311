// The borders between panels, which can be dragged.
#pragma once
#include <optional>

namespace pliant::viewer {

struct LabState;

// Where the borders were dragged to; empty: where they stand by themselves. Widths in px at UI scale 1, heights as a part of the
// room.
struct PanelSizes {
    std::optional<float> left{}, right{};           // of the panels beside the picture
    std::optional<float> plots{};                   // beside the picture of the slide layout
    std::optional<float> lessons{}, walkthrough{};  // above the parameters; above the plots
    bool operator==(const PanelSizes&) const = default;
};

// How far a panel may reach from the edge that it stands at, px.
struct PanelReach {
    float usual = 0, least = 0, most = 0;
};

// A border that is dragged to the side (else up and down).
struct PanelBorder {
    const char* name;  // of the control
    bool sideways = true;
    float edge = 0, direction = 1;  // where the panel begins, px, and whether it grows to the right and down, or the other way
    float from = 0, length = 0;     // of the border, across the direction, px
    float unit = 1;                 // px in 1 of what is kept
};

// The size of the panel in this frame, px: call before what stands at either side is drawn. A double click gives it its usual
// size.
float size_at_border(LabState& lab, const PanelBorder& border, const PanelReach& reach, std::optional<float>& kept);

// The borders lie above the panels if this is called before the first of these is drawn.
void make_borders();

}  // namespace pliant::viewer
