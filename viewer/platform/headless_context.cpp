#include "platform/headless_context.h"

#include <imgui.h>
#include <pliant/math/error.h>

namespace pliant::viewer {

void HeadlessContext::gui_attach() { ImGui::GetIO().BackendPlatformName = "pliant_headless"; }

void HeadlessContext::gui_begin_frame(Real dt) {
    if (!(dt > 0)) throw Refused("frame time", dt, "s", "a positive number");
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size_.width), static_cast<float>(size_.height)};
    io.DisplayFramebufferScale = {1, 1};
    io.DeltaTime = static_cast<float>(dt);
}

void HeadlessContext::gui_detach() { ImGui::GetIO().BackendPlatformName = nullptr; }

}  // namespace pliant::viewer
