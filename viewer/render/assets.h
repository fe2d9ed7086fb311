// What is read rather than compiled: the texts in assets/, embedded when the program is built.
#pragma once
#include <string_view>

namespace pliant::viewer {

// By its path in assets/: "colour_maps/viridis.csv"; empty when there is none.
std::string_view asset(std::string_view path);

}  // namespace pliant::viewer
