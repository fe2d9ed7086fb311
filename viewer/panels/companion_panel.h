// What shows a pinned run and a second one, B, beside the present one, A: their names, the switch between them, their numbers.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

// "Δt = 2 ms", "explicit Euler", "ground off".
std::string setting_text(const Parameter& parameter, Real value);
// The settings of A, or of B, in which the two differ; the names of more than `most` of them are left out.
std::string differing_text(const Session& session, bool of_b, std::size_t most = 3);
// "A  Δt = 1 ms"; "A" alone when nothing differs.
std::string run_name(const Session& session, bool of_b, std::size_t most = 3);
// "B is catching up: 40 %"; "" while it keeps up with A.
std::string catching_up_text(const Session& session);
// "pinned at t = 0.3 s: Δt = 1 ms": how the pinned run differs from the present one.
std::string pinned_text(const Session& session);

void draw_pin_button(PanelContext& lab);
// Makes the second run; with one, which of the two the sliders set, and whether the picture shows their difference.
void draw_run_switch(PanelContext& lab);
// The key numbers of both runs, their differences, cost and error: below the plots of the lab, and on a slide in the place of its
// numbers.
void draw_companion_table(PanelContext& lab);
float companion_table_height(const PanelContext& lab);  // px below the plots; 0 without a second run, and on a slide

}  // namespace pliant::viewer
