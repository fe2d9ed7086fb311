#include "platform/gui.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "platform/gl.h"

#include <cmath>
#include <limits>

namespace pliant::viewer {
namespace {
#if defined(__EMSCRIPTEN__)
constexpr const char* shader_version = "#version 300 es";
#else
constexpr const char* shader_version = "#version 330 core";
#endif
}  // namespace

Gui::Gui(Context& context) : context_(context), imgui_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(imgui_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    context_.gui_attach();
    ImGui_ImplOpenGL3_Init(shader_version);
}

Gui::~Gui() {
    ImGui::SetCurrentContext(imgui_);
    context_.make_current();
    ImGui_ImplOpenGL3_Shutdown();
    context_.gui_detach();
    ImGui::DestroyContext(imgui_);
}

void Gui::begin_frame(Real dt) {
    ImGui::SetCurrentContext(imgui_);
    ImGui_ImplOpenGL3_NewFrame();
    context_.gui_begin_frame(dt);
    ImGui::NewFrame();
}

bool Gui::has_input() const { return !imgui_->InputEventsQueue.empty(); }

// ImGui shows the cursor in the first 0.8 s of every 1.2 s.
Real Gui::next_blink() const {
    constexpr Real period = 1.2, shown = 0.8;
    if (!imgui_->IO.WantTextInput || !imgui_->IO.ConfigInputTextCursorBlink) return std::numeric_limits<Real>::infinity();
    const Real running = static_cast<Real>(imgui_->InputTextState.CursorAnim);  // below 0 just after a key: it shows
    const Real at = running < 0 ? running : std::fmod(running, period);
    return (at < shown ? shown : period) - at;
}

void Gui::end_frame() {
    ImGui::Render();
    draw(*ImGui::GetDrawData());
}

void Gui::draw_again(ImDrawList& over) {
    ImGui::SetCurrentContext(imgui_);
    const ImDrawData& last = *ImGui::GetDrawData();
    ImDrawData card;
    card.Valid = true;
    card.DisplayPos = last.DisplayPos, card.DisplaySize = last.DisplaySize, card.FramebufferScale = last.FramebufferScale;
    card.AddDrawList(&over);
    draw(*ImGui::GetDrawData());
    draw(card);
}

void Gui::draw(ImDrawData& data) {
    const Size size = context_.framebuffer_size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    ImGui_ImplOpenGL3_RenderDrawData(&data);
}

}  // namespace pliant::viewer
