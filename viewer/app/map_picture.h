// A stability map as a picture of its own, drawn without a window.
#pragma once
#include <pliant/study/stability_report.h>

#include "panels/theme.h"
#include "platform/image.h"

#include <string>

namespace pliant::viewer {

// What holds in every cell: choices that are in use, the settings, and how long a cell runs.
std::string map_conditions(const StabilityMap& map);

// Throws Refused for a size that no context has, MachineLacks without GL.
Image map_image(const StabilityMap& map, Size size, Theme theme, float ui_scale);

}  // namespace pliant::viewer
