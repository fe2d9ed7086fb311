// What the lab shows at once.
#pragma once
#include <string_view>

namespace pliant::viewer {

// lab: all panels. slide: the picture, its plots and the numbers that matter, large. deck: a slide of the walkthrough beside
// them.
enum class Layout { lab, slide, deck };
std::string_view name_of(Layout layout);

}  // namespace pliant::viewer
