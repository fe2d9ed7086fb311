// The lessons, to search and to open.
#pragma once
#include "panels/panel_context.h"

#include <string>

namespace pliant::viewer {

struct LessonListState {
    std::string search{};
    std::string listed{};  // the lesson that the list has scrolled to
    bool focus = false;    // the search gets the keys
};

void draw_lesson_list(PanelContext& lab, LessonListState& panel);

}  // namespace pliant::viewer
