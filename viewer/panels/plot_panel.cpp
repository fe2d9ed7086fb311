#include "panels/plot_panel.h"

#include "panels/companion_panel.h"
#include "panels/field_plots.h"
#include "panels/methods_panel.h"
#include "panels/plot_choice.h"
#include "panels/run_plots.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

void draw_named(PanelContext& lab, PlotPanelState& panel, Plot& plot, const std::string& name, Point size) {
    for (Pin& pin : lab.session.inspector.pins)
        if (pin.title == name) return plot_pin(lab, plot, pin, size);
    if (name == plot_names::along) return plot_along(lab, panel, plot, size);
    if (name == plot_names::heat_map) return plot_map(lab, plot, size);
    const Lesson& lesson = lab.session.lesson();
    for (std::size_t i = 0; i < lesson.probes.size(); ++i)
        if (lesson.probes[i].name == name) return plot_probe(lab, plot, i, size);
    for (const Line& line : lesson.lines)
        if (line.name == name && line.in_use()) return plot_line(lab.session, plot, line, size);
}

// With the entry of its menu that lets it fill the screen.
PlotHooks hooks_of(PanelContext& lab, const PlotPanelState& panel, const std::string& name) {
    PlotHooks hooks = panel.hooks;
    hooks.filled = static_cast<bool>(lab.fill);
    hooks.fill = [&lab, name] { lab.fill = lab.fill ? Fill{} : Fill{Filled::plot, name}; };
    return hooks;
}

void draw_one(PanelContext& lab, PlotPanelState& panel, const PlotStyle& style, const std::string& name, Point size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = size.x > 0 ? size.x : ImGui::GetContentRegionAvail().x;
    Plot plot(panel.memory, style, hooks_of(lab, panel, name));
    draw_named(lab, panel, plot, name, size);
    lab.note_fillable({at.x, at.y, width, size.y}, {Filled::plot, name});
}

void begin_plots(PanelContext& lab, PlotPanelState& panel) {
    choose_first_plots(lab, panel);
    if (std::exchange(panel.run, lab.session.run_count()) != lab.session.run_count()) panel.memory.refit();
    follow_live_error(lab);
    // A plot that fills the screen is that of its layout, with its zoom.
    if (!lab.fill || panel.memory.place == 0) panel.memory.place = 1 + static_cast<unsigned>(lab.layout);
}

// How many plots are seen at once, whole; in the lab the others are scrolled to. On a slide, where nobody scrolls, none is cut,
// and one that has no room for its axes is left out.
std::size_t rows_of_plots(const PanelContext& lab, std::size_t count, float least) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y, room = ImGui::GetContentRegionAvail().y;
    const bool scrolls = lab.layout == Layout::lab;
    if (!scrolls && room < lab.px(80)) return 0;
    const std::size_t most = scrolls ? std::min<std::size_t>(count, 3) : count;
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(room + spacing, 0.f) / (least + spacing)), 1, most);
}

void say_empty(const PlotPanelState& panel) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", panel.chosen.empty() ? "No plot is chosen."
                                                   : "None of the chosen plots belongs to this scene: choose others above.");
    ImGui::PopTextWrapPos();
}

void cost_and_error(PanelContext& lab, PlotPanelState& panel, const PlotStyle& style) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const std::string name(plot_names::cost);
    Plot plot(panel.memory, style, hooks_of(lab, panel, name));
    draw_cost_and_error(lab, plot);
    lab.note_fillable({at.x, at.y, room.x, room.y}, {Filled::plot, name});
}

void table_below(PanelContext& lab) {
    if (companion_table_height(lab) > 0) draw_companion_table(lab);
}

}  // namespace

std::optional<Interval> zoomed_part(const Plot& plot) {
    const auto x = plot.zoomed_x();
    return x ? std::optional(Interval{x->lo, x->hi}) : std::nullopt;
}

PlotTheme plot_theme(Theme theme) { return theme == Theme::dark ? PlotTheme::dark : PlotTheme::projector; }

void draw_plots(PanelContext& lab, PlotPanelState& panel) {
    begin_plots(lab, panel);
    if (lab.layout == Layout::lab) plot_menu(lab, panel), draw_what_if_words(lab);
    if (panel.cost_shown && lab.layout != Layout::deck) return cost_and_error(lab, panel, style_of_plots(lab)), table_below(lab);
    std::vector<std::string> shown = shown_plots(lab, panel);
    if (shown.empty()) return say_empty(panel), table_below(lab);
    ImGui::BeginChild("plots", {0, -companion_table_height(lab)}, ImGuiChildFlags_None,
                      ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_NoBackground);
    const float spacing = ImGui::GetStyle().ItemSpacing.y,
                least = lab.layout == Layout::lab ? lab.px(150) : std::min(lab.px(130), ImGui::GetContentRegionAvail().y);
    const std::size_t rows = rows_of_plots(lab, shown.size(), least);
    if (lab.layout != Layout::lab) shown.resize(rows);
    if (shown.empty()) return ImGui::EndChild(), table_below(lab);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const auto count = static_cast<float>(rows);
    // They fill the room, but are hardly higher than wide; in a deck, where the legend has rows of its own, a little more.
    const float highest = (lab.layout == Layout::deck ? 1.35f : 1.1f) * room.x;
    const float height = std::clamp((room.y - spacing * (count - 1)) / count, least, std::max(least, highest));
    for (const std::string& name : shown) draw_one(lab, panel, style_of_plots(lab), name, {0, height});
    ImGui::EndChild();
    table_below(lab);
}

PlotStyle style_of_plots(const PanelContext& lab) {
    PlotStyle style = plot_style(plot_theme(lab.theme), lab.scale);
    style.mathematics = &lab.fonts.mathematics;
    return style;
}

void draw_plots_in_row(PanelContext& lab, PlotPanelState& panel) {
    begin_plots(lab, panel);
    const std::vector<std::string> shown = shown_plots(lab, panel);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.x, count = static_cast<float>(std::max<std::size_t>(shown.size(), 1));
    const float width = std::min((room.x - gap * (count - 1)) / count, 2.6f * room.y);
    for (const std::string& name : shown) {
        if (name != shown.front()) ImGui::SameLine(0, gap);
        draw_one(lab, panel, style_of_plots(lab), name, {width, room.y});
    }
}

void draw_filled_plot(PanelContext& lab, PlotPanelState& panel) {
    begin_plots(lab, panel);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    constexpr float least_lines = 24;  // in the height of the screen
    ImFont* font = lab.fonts.normal;
    for (ImFont* larger : {lab.fonts.medium, lab.fonts.large, lab.fonts.larger})
        if (least_lines * larger->FontSize <= room.y) font = larger;
    PlotStyle style = plot_style(plot_theme(lab.theme), lab.scale * font->FontSize / lab.fonts.normal->FontSize);
    style.mathematics = &lab.fonts.mathematics;
    ImGui::PushFont(font);
    if (lab.fill.plot == plot_names::cost)
        cost_and_error(lab, panel, style);
    else
        draw_one(lab, panel, style, lab.fill.plot, {room.x, room.y});
    ImGui::PopFont();
}

}  // namespace pliant::viewer
