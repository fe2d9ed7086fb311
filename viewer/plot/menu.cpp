// The menu of a plot, and what it exports.
#include <imgui.h>

#include <algorithm>

#include "plot/csv.h"
#include "plot/interaction.h"
#include "plot/svg_canvas.h"

namespace pliant::viewer {
namespace {

constexpr Real zoom_per_choice = 1.5;

void zoom_about_middle(const Hand& h, Real factor) {
    h.record.memory.x.fixed = zoomed(h.view.x, h.view.x_scale, 0.5, factor);
    h.record.memory.y.fixed = zoomed(h.view.y, h.view.y_scale, 0.5, factor);
}

// Switches of one axis. A scale change starts the range anew, since a range may make no sense on the other scale.
void axis_switches(const char* name, AxisMemory& memory, AxisScale scale, Range shown) {
    ImGui::PushID(name);
    bool log = scale == AxisScale::log, fixed = memory.fixed.has_value();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name);
    ImGui::SameLine(3 * ImGui::GetFontSize());
    if (ImGui::Checkbox("log scale", &log)) {
        memory.scale = log ? AxisScale::log : AxisScale::linear;
        reset_axis(memory);
    }
    ImGui::SameLine();
    if (ImGui::Checkbox("fixed range", &fixed)) {
        if (fixed)
            memory.fixed = shown;
        else
            reset_axis(memory);
    }
    ImGui::PopID();
}

void colour_switch(AxisMemory& memory, Range shown) {
    bool fixed = memory.fixed.has_value();
    if (!ImGui::Checkbox("fixed range of colours", &fixed)) return;
    if (fixed)
        memory.fixed = shown;
    else
        reset_axis(memory);
}

void series_switches(const Hand& h) {
    auto& hidden = h.record.memory.hidden;
    for (const Series& series : h.model.series) {
        bool shown = !hidden.contains(series.name);
        if (!ImGui::Checkbox(series.name.c_str(), &shown)) continue;
        if (shown)
            hidden.erase(series.name);
        else
            hidden.insert(series.name);
    }
}

std::vector<Real> middles(Range extent, AxisScale declared, Index count) {
    std::vector<Real> result;
    for (Index i = 0; i < count; ++i)
        result.push_back(value_at(extent, declared, (static_cast<Real>(i) + 0.5) / static_cast<Real>(count)));
    return result;
}

}  // namespace

std::string plot_csv(const PlotModel& model, const PlotMemory& memory) {
    const Axis &x = model.axes.x, &y = model.axes.y;
    if (model.heat && model.series.empty()) {
        const HeatMap& heat = *model.heat;
        return grid_to_csv(with_unit(x.label, x.unit), with_unit(y.label, y.unit), with_unit(heat.name, heat.unit),
                           middles(heat.x, x.scale, heat.nx), middles(heat.y, y.scale, heat.ny), heat.values);
    }
    std::vector<CsvSeries> columns;
    for (const Series& series : model.series) {
        if (!memory.hidden.contains(series.name)) columns.push_back({series.name, series.xs, series.ys});
    }
    return to_csv(x.label, x.unit, y.unit, columns);
}

std::string plot_svg(const Hand& h, const Canvas& measure) {
    SvgCanvas canvas(h.layout.whole, measure);
    DrawBuffers buffers;
    draw_plot(
        {canvas, h.model, h.record.memory, h.view, h.layout, h.style, buffers, h.layout.x_map(h.view), h.layout.y_map(h.view)});
    return canvas.document();
}

void plot_menu(const Hand& h, const Canvas& measure, bool open) {
    if (open) ImGui::OpenPopup("menu");
    if (!ImGui::BeginPopup("menu")) return;
    PlotMemory& memory = h.record.memory;
    if (h.hooks.fill && ImGui::MenuItem(h.hooks.filled ? "Back" : "Fill the screen", "X")) h.hooks.fill();
    if (ImGui::MenuItem("Reset the view", "double click")) {
        reset_axis(memory.x);
        reset_axis(memory.y);
    }
    if (ImGui::MenuItem("Zoom in", "wheel")) zoom_about_middle(h, zoom_per_choice);
    if (ImGui::MenuItem("Zoom out", "wheel")) zoom_about_middle(h, 1 / zoom_per_choice);
    ImGui::Separator();
    axis_switches("x", memory.x, h.view.x_scale, h.view.x);
    axis_switches("y", memory.y, h.view.y_scale, h.view.y);
    if (h.model.heat) colour_switch(memory.colour, h.view.colour);
    ImGui::Separator();
    if (!h.model.series.empty()) {
        series_switches(h);
        ImGui::Separator();
    }
    if (ImGui::MenuItem("Copy as CSV")) ImGui::SetClipboardText(plot_csv(h.model, memory).c_str());
    if (h.hooks.save_png && ImGui::MenuItem("Save as PNG")) h.record.wants_png = true;
    if (h.hooks.save_svg && ImGui::MenuItem("Save as SVG")) h.hooks.save_svg(h.model.title, plot_svg(h, measure));
    ImGui::EndPopup();
}

}  // namespace pliant::viewer
