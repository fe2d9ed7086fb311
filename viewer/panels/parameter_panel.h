// The sliders of the lesson.
#pragma once
#include "panels/number_slider.h"
#include "panels/panel_context.h"
#include "session/usage.h"

#include <map>
#include <string>

namespace pliant::viewer {

// Headings that a person has opened or folded, of each lesson by its id: "material", and "material unused" for the fold with what
// the scene does not use. Others are as they are at first.
using FoldedHeadings = std::map<std::string, std::map<std::string, bool>>;

struct ParameterPanelState {
    UsageReasons usage{};
    SliderDrag drag{};
    FoldedHeadings headings{};
};

// All of them, group by group.
void draw_parameters(PanelContext& lab, ParameterPanelState& panel);
// One control. Large ones are for the deck.
void draw_parameter(PanelContext& lab, ParameterPanelState& panel, const Parameter& parameter, bool large = false);

// Is the heading of a group open? As the person left it; at first where the lesson says so, or where all of its sliders fit, and
// in any case while a slide names one of its parameters.
bool heading_open(const PanelContext& lab, const ParameterPanelState& panel, Group group);
bool unused_shown(const PanelContext& lab, const ParameterPanelState& panel, Group group);
void open_heading(const PanelContext& lab, ParameterPanelState& panel, Group group, bool open);
void show_unused(const PanelContext& lab, ParameterPanelState& panel, Group group, bool show);

}  // namespace pliant::viewer
