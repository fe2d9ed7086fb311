#include "panels/plot_choice.h"

#include <algorithm>
#include <iterator>

namespace pliant::viewer {
namespace {

std::vector<std::string_view> plots_of_scene(const Lesson& lesson) {
    std::vector<std::string_view> names = lesson.first_plots();
    if (!names.empty()) return names;
    for (const Probe& probe : lesson.probes)
        if (names.size() < 2) names.push_back(probe.name);
    return names;
}

// Those that the slide names, else those of the scene.
std::vector<std::string> wanted_plots(const Session& s) {
    if (const auto of_slide = s.walkthrough ? s.walkthrough->slide().plots() : std::nullopt) return *of_slide;
    const auto of_scene = plots_of_scene(s.lesson());
    return {of_scene.begin(), of_scene.end()};
}

}  // namespace

void choose_first_plots(PanelContext& lab, PlotPanelState& panel) {
    const std::string_view lesson = lab.session.entry().info.id;
    if (panel.lesson != lesson) panel.lesson = lesson, panel.picked = false, panel.memory.clear();
    if (panel.picked) return;
    panel.chosen = wanted_plots(lab.session);
}

namespace {

void toggle(PlotPanelState& panel, std::string_view name, const std::string& label) {
    auto& chosen = panel.chosen;
    const auto found = std::ranges::find(chosen, name);
    bool on = found != chosen.end();
    if (!ImGui::Checkbox((label + "##" + std::string(name)).c_str(), &on)) return;
    panel.picked = true;
    on ? chosen.push_back(std::string(name)) : void(chosen.erase(found));
}

}  // namespace

void plot_menu(PanelContext& lab, PlotPanelState& panel) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##plots", panel.cost_shown ? "cost & error" : "plots …", ImGuiComboFlags_HeightLarge))
        return lab.note_control("plots");
    ImGui::Checkbox("cost & error  (C)", &panel.cost_shown);
    tooltip("In place of the plots: ms per stage, the error over time, and the error against the cost", lab.scale);
    ImGui::Separator();
    const Lesson& lesson = lab.session.lesson();
    for (const Probe& p : lesson.probes) toggle(panel, p.name, words(p.name));
    for (const Line& l : lesson.lines)
        if (l.in_use()) toggle(panel, l.name, words(l.name));
    toggle(panel, plot_names::along, "the field along a line");
    if (lab.scene_has_grid) toggle(panel, plot_names::heat_map, "the field as a heat map");
    ImGui::EndCombo();
}

namespace {

bool shown_now(const PanelContext& lab, const std::string& name) {
    for (const Line& line : lab.session.lesson().lines)
        if (line.name == name) return line.in_use();
    return true;
}

}  // namespace

std::vector<std::string> shown_plots(const PanelContext& lab, const PlotPanelState& panel) {
    const bool deck = lab.layout == Layout::deck;
    const std::vector<std::string> wanted = deck ? wanted_plots(lab.session) : panel.chosen;
    std::vector<std::string> shown;
    std::ranges::copy_if(wanted, std::back_inserter(shown), [&](const std::string& n) { return shown_now(lab, n); });
    if (lab.layout == Layout::lab)
        for (const Pin& pin : lab.session.inspector.pins) shown.push_back(pin.title);
    if (deck && shown.size() > 2) shown.resize(2);
    return shown;
}

bool slide_has_plots(const PanelContext& lab) { return !wanted_plots(lab.session).empty(); }

std::string first_plot_of_scene(const Lesson& lesson) {
    const auto names = plots_of_scene(lesson);
    return names.empty() ? "" : std::string(names.front());
}

bool has_plot(const PanelContext& lab, std::string_view name) {
    const Session& s = lab.session;
    if (name == plot_names::along || name == plot_names::cost) return true;
    if (name == plot_names::heat_map) return lab.scene_has_grid;
    if (std::ranges::any_of(s.inspector.pins, [&](const Pin& pin) { return pin.title == name; })) return true;
    return std::ranges::any_of(s.lesson().probes, [&](const Probe& p) { return p.name == name; }) ||
           std::ranges::any_of(s.lesson().lines, [&](const Line& l) { return l.name == name && l.in_use(); });
}

}  // namespace pliant::viewer
