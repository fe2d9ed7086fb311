// Where the parts of a slide stand in the deck.
#pragma once
#include "app/lab_state.h"

namespace pliant::viewer {

struct DeckPlaces {
    Rectangle title, words, parameters, picture, plots, numbers, notes;  // of no height: not shown
    Rectangle other;            // what a slide of a lecture shows in the place of a run: a picture, a claim or a map
    bool plots_in_row = false;  // below the picture rather than beside it
};

// The words stand at the left. The picture gets the room in which its scene is seen largest: with the plots at the right or in a
// row below, and with the sliders below the words, where that costs these no size of type, or below the picture.
DeckPlaces deck_places(const LabState& lab, float width, float height);

}  // namespace pliant::viewer
