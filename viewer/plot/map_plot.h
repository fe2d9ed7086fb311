// A stability map as a picture: classes by colour and by mark, the bound of theory, a legend with counts. On any canvas.
#pragma once
#include <pliant/study/stability_theory.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plot/canvas.h"
#include "plot/style.h"

namespace pliant::viewer {

// What is drawn of a map, made once: the map must outlive it. One without cells is an empty field between its axes.
struct MapPicture {
    explicit MapPicture(const StabilityMap& shown);

    struct Axis {
        std::string label, unit;         // "time step Δt", "s"
        std::vector<std::string> names;  // of the values of a list
    };
    const StabilityMap* map;
    Axis across, up;
    std::vector<std::array<MapPlace, 2>> bound;
    std::vector<char> wrong;            // does the cell contradict theory?
    std::optional<MapPlace> present{};  // a point to mark
};

// Where things came to lie.
struct MapPlaces {
    Box area;  // of the cells

    std::optional<std::pair<Index, Index>> cell(const StabilityMap& map, Point at) const;
    Box box(const StabilityMap& map, Index i, Index j) const;
    Point point(const StabilityMap& map, MapPlace place) const;
};

// The legend stands at the right of the cells, or below them.
MapPlaces draw_map(Canvas& canvas, Box whole, const MapPicture& picture, const PlotStyle& style, bool legend_beside);

Rgba8 colour_of(Stability kind);
// A square of its colour with its mark.
void draw_class(Canvas& canvas, Box box, Stability kind, const PlotStyle& style);

}  // namespace pliant::viewer
