// What a slide of a lecture shows in the place of a run, and what it does when it comes up.
#pragma once
#include "app/deck_layout.h"

namespace pliant::viewer {

enum class ShownBySlide { run, words, picture, claim, atlas };
// Of the slide that is shown; a walkthrough shows runs.
ShownBySlide shown_by_slide(const LabState& lab);
// Has the slide words to be set beside what it shows?
bool slide_has_words(const LabState& lab);

// The words, and what stands beside them, in the room below the title.
void place_without_run(const LabState& lab, DeckPlaces& places, const Rectangle& room);
void draw_shown_by_slide(LabState& lab);

// Call when another slide has come up: its claim is unfolded, its knobs are set.
void begin_lecture_slide(LabState& lab);
// Call in every frame: a map that has been made is there again when one comes back to its slide.
void keep_of_lecture_slide(LabState& lab);
// What Next does before it goes on: the claim is measured, the map is made. False when there is nothing of the kind, or it is
// done.
bool show_more_of_slide(LabState& lab);
bool next_shows_more(const LabState& lab);  // would it do something?

}  // namespace pliant::viewer
