// What is plotted, and how.
#pragma once
#include "plot/plot.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace pliant::viewer {

struct PlotPanelState {
    PlotState memory;
    PlotHooks hooks;
    std::string lesson;               // that the choice below belongs to
    std::vector<std::string> chosen;  // names of probes and lines, "along" for the field along a line, "map" for the heat map
    int run = 0;                      // that the ranges belong to
    int axis = 0;                     // of the field along a line
    std::array<Real, 2> across{0.5, 0.5};
};

}  // namespace pliant::viewer
