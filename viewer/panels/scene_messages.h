// Words that lie over the picture, at a place of the window.
#pragma once
#include "panels/scene_panel.h"

namespace pliant::viewer {

// The message of the session, with what can be done about it.
void draw_banner(PanelContext& lab, const Rectangle& place);
// The first three things to try, until they are put away.
// In the lab: a static lesson that nothing was solved of yet says so, with a button that does it.
void draw_unsolved(PanelContext& lab, const ScenePanelState& panel, const Rectangle& place);
void draw_hints(PanelContext& lab, ScenePanelState& panel, const Rectangle& place);
// How the pinned run differs, at the lower left above the hints.
void name_pinned(PanelContext& lab, ScenePanelState& panel, const Rectangle& place);
// Why B does not go on, or how far it has come to where A is, over its picture.
void tell_of_beside(PanelContext& lab, const Rectangle& place);
// In a picture whose field no stage has computed yet: which one will. runner: null for a picture of
// the past. labels: words of the picture, which it keeps off on a slide.
void tell_awaited(PanelContext& lab, const Scene& scene, const Runner* runner, const Rectangle& place,
                  const std::vector<Rectangle>& labels);

}  // namespace pliant::viewer
