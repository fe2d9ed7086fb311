// What lies over the whole screen: the lens around the pointer, and the black-out of a lecture.
#include <imgui_internal.h>

#include "app/lab.h"

#include <algorithm>

namespace pliant::viewer {

// A black screen takes all inputs but where the mouse is and what is let go.
void Lab::lift_black_out() {
    if (!state_.black) return;
    ImVector<ImGuiInputEvent>& queue = ImGui::GetCurrentContext()->InputEventsQueue;
    const auto pressed = [](const ImGuiInputEvent& e) {
        return (e.Type == ImGuiInputEventType_Key && e.Key.Down) ||
               (e.Type == ImGuiInputEventType_MouseButton && e.MouseButton.Down);
    };
    if (std::any_of(queue.begin(), queue.end(), pressed)) state_.black = false;
    ImVector<ImGuiInputEvent> kept;
    for (const ImGuiInputEvent& e : queue)
        if (!pressed(e) && e.Type != ImGuiInputEventType_Text && e.Type != ImGuiInputEventType_MouseWheel) kept.push_back(e);
    queue.swap(kept);
}

void Lab::draw_over_all() {
    if (state_.lens_shown && !state_.black) lens_.draw(state_, context_.framebuffer_size());
    if (state_.black) ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize, IM_COL32_BLACK);
}

}  // namespace pliant::viewer
