// What an animation shall be, before its file is chosen.

#include "panels/animation_panel.h"

#include <fmt/format.h>

namespace pliant::viewer {
namespace {

constexpr const char* popup = "An animation";
constexpr int longest = 30;  // s

void choices(PanelContext& lab) {
    AnimationOrder& order = lab.animation;
    ImGui::SetNextItemWidth(lab.px(160));
    const auto text = slider_or_text(lab.typed, "seconds", fmt::format("{}", order.seconds), [&] {
        ImGui::SliderInt("seconds", &order.seconds, 1, longest, "%d", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    });
    if (text) lab.take_typed([&] { order.seconds = static_cast<int>(whole_typed("seconds", *text, 1, longest)); });
    lab.note_control("animation seconds");
    tooltip("How long the animation takes to watch", lab.scale);
    for (const int width : {480, 640, 960}) {
        if (ImGui::RadioButton(fmt::format("{} px", width).c_str(), order.width == width)) order.width = width;
        lab.note_control(fmt::format("animation {} px", width));
        tooltip("How wide it is at most; a wider one is a larger file", lab.scale);
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

void choose_file(PanelContext& lab) {
    lab.animation.asking = false;
    const std::string_view id = lab.session.entry().info.id;
    lab.files.ask(FileChoice::Purpose::save, "Save the animation as GIF", {".gif"},
                  std::string(id.substr(id.find('/') + 1)) + ".gif",
                  [&order = lab.animation](const std::string& path) { order.path = path; });
}

}  // namespace

void draw_animation_panel(PanelContext& lab) {
    if (!lab.animation.asking) return;
    if (!ImGui::IsPopupOpen(popup)) ImGui::OpenPopup(popup);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(popup, nullptr,
                                ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
        return;
    ImGui::PushTextWrapPos(lab.px(360));
    ImGui::TextUnformatted(
        fmt::format(
            "The run plays on at {:g} simulated seconds per second, whatever the machine needs for it, and the picture of "
            "the scene is recorded with 20 frames per second.",
            lab.session.speed)
            .c_str());
    ImGui::PopTextWrapPos();
    choices(lab);
    if (ImGui::Button("Choose a file…")) choose_file(lab);
    lab.note_control("animation file");
    tooltip("Then the recording begins", lab.scale);
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) lab.animation.asking = false;
    lab.note_control("animation cancel");
    tooltip("Record nothing (Escape)", lab.scale);
    if (!lab.animation.asking) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pliant::viewer
