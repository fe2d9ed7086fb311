// What the lectures say of the methods: to predict, then to measure.
#pragma once
#include "panels/panel_context.h"
#include "session/claim_book.h"

namespace pliant::viewer {

struct ClaimsPanelState {
    ClaimBook book{};
    bool reveal = false, focus = false;  // the unfolded card is scrolled to; the keys go to it
};

void draw_claims(PanelContext& lab, ClaimsPanelState& panel);
// One claim alone in large type, for a slide: its question, and what came out once it has been measured.
void draw_claim_slide(PanelContext& lab, ClaimsPanelState& panel, const Claim& claim);

}  // namespace pliant::viewer
