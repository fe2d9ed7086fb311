// All keys, and what the mouse does.
#pragma once

namespace pliant::viewer {

// `shown` becomes false when it is closed.
void draw_help(bool& shown);

}  // namespace pliant::viewer
