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
// The card of one claim alone, for a slide: its question, its measurement, what came out.
void draw_claim_card(PanelContext& lab, ClaimsPanelState& panel, const Claim& claim);

}  // namespace pliant::viewer
