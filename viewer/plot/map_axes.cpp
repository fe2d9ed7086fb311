#include "plot/map_axes.h"

#include <algorithm>
#include <cmath>

#include "plot/layout.h"

namespace pliant::viewer {
namespace {

AxisScale scale_of(const Knob& k) { return k.spacing == Spacing::log ? AxisScale::log : AxisScale::linear; }
Range range_of(const Knob& k) { return {knob_value(k, -0.5), knob_value(k, static_cast<Real>(k.values.size()) - 0.5)}; }
bool has_names(const Knob& k) { return k.spacing == Spacing::list; }

// Every so many of the names are written.
Index stride_of(float needed, float each) {
    return static_cast<Index>(std::clamp(std::ceil(needed / std::max(each, 0.5f)), 1.f, 512.f));
}

}  // namespace

MapAxes::MapAxes(Canvas& canvas, const MapPicture& picture, const PlotStyle& style)
    : canvas_(canvas), p_(picture), style_(style), em_(canvas.line_height()) {}

float MapAxes::fit_up(float height, float most) {
    const Knob& k = p_.map->order.up;
    float widest = 0;
    if (has_names(k)) {
        for (const std::string& n : p_.up.names) widest = std::max(widest, canvas_.text_size(n).x);
        return std::min(widest, most);
    }
    up_ = ticks_that_fit(range_of(k), scale_of(k), p_.up.unit, std::max(height, em_), true, canvas_);
    for (const Tick& t : up_.ticks) widest = std::max(widest, canvas_.text_size(t.text).x);
    return widest;
}

void MapAxes::fit_across(float width) {
    const Knob& k = p_.map->order.across;
    if (!has_names(k)) across_ = ticks_that_fit(range_of(k), scale_of(k), p_.across.unit, width, false, canvas_);
}

void MapAxes::draw(const MapPlaces& places, Box whole) const {
    const Box& area = places.area;
    const Knob &x = p_.map->order.across, &y = p_.map->order.up;
    has_names(x) ? name_columns(places) : number_across(places);
    has_names(y) ? name_rows(places, area.min.x - whole.min.x - 0.5f * em_) : number_up(places);
    const std::string across =
                          shortened(canvas_, has_names(x) ? p_.across.label : axis_text(p_.across.label, across_), whole.width()),
                      up = has_names(y) ? p_.up.label : axis_text(p_.up.label, up_);
    const float left = (area.min.x + area.max.x - canvas_.text_size(across).x) / 2;
    canvas_.text({std::clamp(left, whole.min.x, std::max(whole.min.x, whole.max.x - canvas_.text_size(across).x)),
                  area.max.y + 1.5f * em_},
                 style_.text, across);
    canvas_.text({whole.min.x, area.min.y - 1.45f * em_}, style_.text, shortened(canvas_, up, whole.width()));
}

void MapAxes::number_across(const MapPlaces& places) const {
    const Box& area = places.area;
    const Knob& k = p_.map->order.across;
    const AxisMap map(range_of(k), scale_of(k), area.min.x, area.max.x);
    for (const Tick& t : across_.ticks) {
        const auto at = static_cast<float>(map.pixel(t.value));
        if (at < area.min.x - 1 || at > area.max.x + 1) continue;
        canvas_.segment({at, area.max.y}, {at, area.max.y + (t.text.empty() ? 0.15f : 0.3f) * em_}, style_.frame,
                        style_.width(1));
        canvas_.text({at - canvas_.text_size(t.text).x / 2, area.max.y + 0.35f * em_}, style_.text, t.text);
    }
}

void MapAxes::number_up(const MapPlaces& places) const {
    const Box& area = places.area;
    const Knob& k = p_.map->order.up;
    const AxisMap map(range_of(k), scale_of(k), area.max.y, area.min.y);
    for (const Tick& t : up_.ticks) {
        const auto at = static_cast<float>(map.pixel(t.value));
        if (at < area.min.y - 1 || at > area.max.y + 1) continue;
        canvas_.segment({area.min.x - (t.text.empty() ? 0.15f : 0.3f) * em_, at}, {area.min.x, at}, style_.frame,
                        style_.width(1));
        const Point size = canvas_.text_size(t.text);
        canvas_.text({area.min.x - 0.4f * em_ - size.x, at - size.y / 2}, style_.text, t.text);
    }
}

// Short names are left out where they would touch, long ones are cut.
void MapAxes::name_columns(const MapPlaces& places) const {
    float widest = 0;
    for (const std::string& n : p_.across.names) widest = std::max(widest, canvas_.text_size(n).x);
    const float each = places.box(*p_.map, 0, 0).width();
    const Index stride = stride_of(std::min(widest + 0.4f * em_, 4 * em_), each);
    for (Index i = 0; i < p_.map->columns(); i += stride) {
        const Box box = places.box(*p_.map, i, 0);
        const std::string text =
            shortened(canvas_, p_.across.names[static_cast<std::size_t>(i)], static_cast<float>(stride) * each - 0.3f * em_);
        const float middle = (box.min.x + box.max.x) / 2;
        canvas_.text({middle - canvas_.text_size(text).x / 2, places.area.max.y + 0.35f * em_}, style_.text, text);
    }
}

void MapAxes::name_rows(const MapPlaces& places, float room) const {
    const Index stride = stride_of(em_, places.box(*p_.map, 0, 0).height());
    for (Index j = 0; j < p_.map->rows(); j += stride) {
        const Box box = places.box(*p_.map, 0, j);
        const std::string text = shortened(canvas_, p_.up.names[static_cast<std::size_t>(j)], room);
        const Point size = canvas_.text_size(text);
        canvas_.text({places.area.min.x - 0.4f * em_ - size.x, (box.min.y + box.max.y - size.y) / 2}, style_.text, text);
    }
}

}  // namespace pliant::viewer
