// The buttons of time and the switches of the picture, above the stages.
#include "panels/stage_bar.h"

#include "panels/companion_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

// What has no room for this width beside what was drawn before stands below it.
void wrap_control(float width) {
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

float switch_width(const char* label) {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label).x;
}

// A switch of the picture, likewise.
bool switched(const char* label, bool& on) {
    wrap_control(switch_width(label));
    return ImGui::Checkbox(label, &on);
}

bool transport_button(PanelContext& lab, const char* name, const char* control, const char* help) {
    wrap_control(ImGui::CalcTextSize(name).x + 2 * ImGui::GetStyle().FramePadding.x);
    const bool used = ImGui::Button(name);
    lab.note_control(control);
    tooltip(help, lab.scale);
    ImGui::SameLine(0, lab.px(4));
    return used;
}

constexpr float least_colour_menu = 84, most_colour_menu = 140, speed_menu_width = 60;  // px at scale 1
// Of the switches behind the menu of colours.
float switches_width(const PanelContext& lab) {
    float sum = 0;
    for (const char* label : {"auto", "arrows", "smooth"})
        if (std::string_view(label) != "smooth" || lab.scene_has_grid)
            sum += switch_width(label) + ImGui::GetStyle().ItemSpacing.x;
    return sum;
}

void colour_menu(PanelContext& lab) {
    Session& s = lab.session;
    const Field* shown = s.lesson().find_field(s.colours.field);
    std::string current = shown ? words(shown->name) : "none";
    if (shown && s.colours.component >= 0)
        current += "." + component_names(*shown)[static_cast<std::size_t>(s.colours.component)];
    // Small enough for the switches behind it.
    wrap_control(lab.px(least_colour_menu));
    ImGui::SetNextItemWidth(
        std::clamp(ImGui::GetContentRegionAvail().x - switches_width(lab), lab.px(least_colour_menu), lab.px(most_colour_menu)));
    if (ImGui::BeginCombo("##colour", current.c_str(), ImGuiComboFlags_HeightLarge)) {
        if (ImGui::Selectable("none", !shown)) s.colours = {};
        for (const Field& f : s.lesson().fields) {
            if (!f.in_use()) continue;
            const auto names = component_names(f);
            for (int c = -1; c < (f.rank == Rank::scalar ? 0 : f.components); ++c) {
                const std::string name =
                    words(f.name) + (c < 0 ? (f.rank == Rank::vector ? "  | |" : "") : "." + names[static_cast<std::size_t>(c)]);
                if (ImGui::Selectable(name.c_str(), shown == &f && s.colours.component == c))
                    s.colours = {std::string(f.name), c}, s.range = {}, s.view_changed();
                if (!f.help.empty()) tooltip(std::string(f.help), lab.scale);
            }
        }
        ImGui::EndCombo();
    }
    lab.note_control("colour");
    tooltip("The field that colours the picture", lab.scale);
    ImGui::SameLine();
    if (switched("auto", s.range.automatic)) s.view_changed();
    lab.note_control("auto range");
    tooltip("The colour bar follows the numbers; switched off, its range stays", lab.scale);
}

void speed_menu(PanelContext& lab) {
    Session& s = lab.session;
    wrap_control(lab.px(speed_menu_width));
    ImGui::SetNextItemWidth(lab.px(speed_menu_width));
    if (ImGui::BeginCombo("##speed", fmt::format("{:g}×", s.speed).c_str())) {
        for (const Real speed : {0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0})
            if (ImGui::Selectable(fmt::format("{:g}×", speed).c_str(), s.speed == speed)) s.speed = speed;
        ImGui::EndCombo();
    }
    lab.note_control("speed");
    tooltip("Simulated seconds per second to play at", lab.scale);
}

}  // namespace

void draw_transport(PanelContext& lab, StageBarState& panel) {
    Session& s = lab.session;
    const float top = ImGui::GetCursorScreenPos().y;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {lab.px(5), ImGui::GetStyle().FramePadding.y});
    if (transport_button(lab, s.playing ? "Pause" : "Play", "play", "Play or pause (Space)")) s.toggle_play();
    if (transport_button(lab, "Pass", "pass", "One pass of the stage's inner loop (;)")) s.step_pass();
    if (transport_button(lab, "Stage", "stage", "One stage (/)")) s.step_stage();
    if (transport_button(lab, "Step", "step", "One step (.)")) s.step();
    if (transport_button(lab, "‹ Stage", "stage back", "One stage back, from stored states (,)")) s.stage_back();
    if (transport_button(lab, "‹ Step", "back",
                         "One step back, from stored states; inside a step, to the same stage of the step before (<)"))
        s.step_back();
    if (transport_button(lab, "Reset", "reset", "Start again from the parameters (R)")) s.reset();
    draw_pin_button(lab);
    ImGui::PopStyleVar();
    if (!s.runner().is_static()) {
        speed_menu(lab);
        ImGui::SameLine(0, lab.px(8));
    }
    colour_menu(lab);
    ImGui::SameLine();
    switched("arrows", s.show_arrows);
    lab.note_control("arrows");
    if (lab.scene_has_grid) {
        ImGui::SameLine();
        switched("smooth", s.smooth);
        lab.note_control("smooth");
        tooltip("Interpolate between cell centres, or show the cells as they are", lab.scale);
    }
    const float row = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y;
    panel.transport_rows = 1 + static_cast<int>(std::lround((ImGui::GetItemRectMin().y - top) / row));
}

}  // namespace pliant::viewer
