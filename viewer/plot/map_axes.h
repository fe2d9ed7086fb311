// The numbers, or names, along the two axes of a map.
#pragma once
#include "plot/map_plot.h"
#include "plot/ticks.h"

namespace pliant::viewer {

class MapAxes {
public:
    MapAxes(Canvas& canvas, const MapPicture& picture, const PlotStyle& style);

    // Width of the numbers left of an area of this height, px; names take `most` of it.
    float fit_up(float height, float most);
    void fit_across(float width);
    // `whole`: what the map and its legend may cover.
    void draw(const MapPlaces& places, Box whole) const;

private:
    void number_across(const MapPlaces& places) const;
    void number_up(const MapPlaces& places) const;
    void name_columns(const MapPlaces& places) const;
    void name_rows(const MapPlaces& places, float room) const;

    Canvas& canvas_;
    const MapPicture& p_;
    const PlotStyle& style_;
    const float em_;
    Ticks across_, up_;
};

}  // namespace pliant::viewer
