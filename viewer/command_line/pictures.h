// What the commands that write pictures share.
#pragma once
#include "app/lab.h"
#include "platform/image.h"

#include <cstddef>

namespace pliant::viewer {

// The lab as it stands. ImGui needs a frame to learn the sizes of its windows, and plots one more to settle their ranges.
Image capture(Lab& lab, Context& context);

// A slide of the walkthrough, from 0. Unlike a person at the window, a command is refused what goes wrong: throws Refused.
void show_slide(Session& session, std::size_t n, bool revealed);

}  // namespace pliant::viewer
