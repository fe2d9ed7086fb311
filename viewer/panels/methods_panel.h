// All methods of the lesson at the present setting: a table, a plot, and each row a run to set beside this one.
#pragma once
#include "panels/panel_context.h"
#include "panels/plot_panel.h"
#include "session/method_table.h"

namespace pliant::viewer {

struct MethodsPanelState {
    MethodTable table{};
    PlotState memory{};
    bool focus = false;  // its first control gets the keys
};

void draw_methods(PanelContext& lab, MethodsPanelState& panel);

// The menu of the last item, a parameter: what if it were half or twice as much, or another option.
void what_if_menu(PanelContext& lab, const Parameter& parameter);
// What the one difference of run B does to the key numbers; nothing without one.
void draw_what_if_words(PanelContext& lab);

}  // namespace pliant::viewer
