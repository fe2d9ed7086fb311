// The lessons, to search and to open.
#pragma once
#include "panels/panel_context.h"

#include <string>
#include <string_view>
#include <vector>

namespace pliant::viewer {

struct LessonListState {
    std::string search{};
    std::string listed{};  // the lesson that the list has scrolled to
    bool focus = false;    // the search gets the keys
    int marked = 0;        // of what is found: Enter opens it
};

// Those in which it is found: as a title or an id, at the start of one, within one, in a summary; all, in their order, for "".
std::vector<const LessonEntry*> found_lessons(std::string_view search);

void draw_lesson_list(PanelContext& lab, LessonListState& panel);

}  // namespace pliant::viewer
