#include "plot/interaction.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr Real zoom_per_notch = 1.15;
constexpr float least_box = 4;  // px of a side of a zoom box

Point pointer() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

bool on_x(const PlotLayout& layout, Point at) { return layout.area.contains(at) || layout.x_strip.contains(at); }
bool on_y(const PlotLayout& layout, Point at) { return layout.area.contains(at) || layout.y_strip.contains(at); }

Real part_x(const PlotLayout& layout, Point at) { return (at.x - layout.area.min.x) / layout.area.width(); }
Real part_y(const PlotLayout& layout, Point at) { return (layout.area.max.y - at.y) / layout.area.height(); }

bool wheel(const Hand& h) {
    const float notches = ImGui::GetIO().MouseWheel;
    const Point at = pointer();
    if (!on_x(h.layout, at) && !on_y(h.layout, at)) return false;
    // The window must not scroll as well.
    ImGui::SetItemKeyOwner(ImGuiKey_MouseWheelY);
    if (notches == 0) return false;
    const Real factor = std::pow(zoom_per_notch, notches);
    if (on_x(h.layout, at)) h.record.memory.x.fixed = zoomed(h.view.x, h.view.x_scale, part_x(h.layout, at), factor);
    if (on_y(h.layout, at)) h.record.memory.y.fixed = zoomed(h.view.y, h.view.y_scale, part_y(h.layout, at), factor);
    return true;
}

void press(const Hand& h) {
    const Point at = pointer();
    h.record.pressed = at;
    h.record.x_at_press = h.view.x;
    h.record.y_at_press = h.view.y;
    const bool in_area = h.layout.area.contains(at);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        h.record.drag = in_area ? PlotDrag::box : PlotDrag::click;
    else if (in_area)
        h.record.drag = PlotDrag::pan;
    else if (h.layout.x_strip.contains(at))
        h.record.drag = PlotDrag::pan_x;
    else if (h.layout.y_strip.contains(at))
        h.record.drag = PlotDrag::pan_y;
    else
        h.record.drag = PlotDrag::click;
}

bool pan(const Hand& h) {
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left)) return false;
    const Point at = pointer();
    PlotRecord& r = h.record;
    if (r.drag == PlotDrag::pan || r.drag == PlotDrag::pan_x)
        r.memory.x.fixed = panned(r.x_at_press, h.view.x_scale, part_x(h.layout, r.pressed) - part_x(h.layout, at));
    if (r.drag == PlotDrag::pan || r.drag == PlotDrag::pan_y)
        r.memory.y.fixed = panned(r.y_at_press, h.view.y_scale, part_y(h.layout, r.pressed) - part_y(h.layout, at));
    return r.drag != PlotDrag::click;
}

Box dragged_box(const Hand& h) {
    const Box area = h.layout.area;
    const Point at{std::clamp(pointer().x, area.min.x, area.max.x), std::clamp(pointer().y, area.min.y, area.max.y)},
        from = h.record.pressed;
    return {{std::min(at.x, from.x), std::min(at.y, from.y)}, {std::max(at.x, from.x), std::max(at.y, from.y)}};
}

bool zoom_to_box(const Hand& h) {
    const Box box = dragged_box(h);
    if (box.width() < least_box || box.height() < least_box) return false;
    zoom_to(h.record.memory.x, h.view.x, h.view.x_scale, part_x(h.layout, box.min), part_x(h.layout, box.max));
    zoom_to(h.record.memory.y, h.view.y, h.view.y_scale, part_y(h.layout, box.max), part_y(h.layout, box.min));
    return true;
}

bool toggle_in_legend(const Hand& h) {
    for (const LegendEntry& entry : h.layout.legend) {
        if (!entry.box.contains(pointer()) || !entry.box.contains(h.record.pressed)) continue;
        auto& hidden = h.record.memory.hidden;
        const std::string& name = h.model.series[entry.series].name;
        if (hidden.erase(name) == 0) hidden.insert(name);
        return true;
    }
    return false;
}

bool double_click(const Hand& h) {
    const Point at = pointer();
    if (!on_x(h.layout, at) && !on_y(h.layout, at)) return false;
    if (on_x(h.layout, at)) reset_axis(h.record.memory.x);
    if (on_y(h.layout, at)) reset_axis(h.record.memory.y);
    h.record.drag = PlotDrag::click;
    return true;
}

bool release(const Hand& h) {
    const PlotDrag drag = std::exchange(h.record.drag, PlotDrag::none);
    if (drag == PlotDrag::box) return zoom_to_box(h);
    return drag == PlotDrag::click && toggle_in_legend(h);
}

}  // namespace

void zoom_to(AxisMemory& axis, Range shown, AxisScale scale, Real a, Real b) {
    const Range range{value_at(shown, scale, a), value_at(shown, scale, b)};
    // Nothing to show between numbers that are equal but for rounding.
    if (widened(range, scale) == range) axis.fixed = range;
}

bool follow_pointer(const Hand& h) {
    bool changed = false;
    if (ImGui::IsItemHovered()) changed = wheel(h);
    if (ImGui::IsItemHovered() && (ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right)))
        press(h);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) changed |= double_click(h);
    if (h.record.drag == PlotDrag::none) return changed;
    if (ImGui::IsItemActive()) return pan(h) || changed;
    return release(h) || changed;
}

}  // namespace pliant::viewer
