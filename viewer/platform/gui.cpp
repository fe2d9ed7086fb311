#include "platform/gui.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "platform/gl.h"

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

void Gui::end_frame() {
    ImGui::Render();
    const Size size = context_.framebuffer_size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace pliant::viewer
