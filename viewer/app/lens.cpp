#include "app/lens.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pliant::viewer {

void Lens::make_texture_for(int side) {
    if (side == side_) return;
    side_ = side;
    texture_ = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

void Lens::take(const ImDrawList*, const ImDrawCmd* command) {
    const Lens& lens = *static_cast<const Lens*>(command->UserCallbackData);
    glBindTexture(GL_TEXTURE_2D, lens.texture_);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, lens.x_, lens.y_, lens.side_, lens.side_);
}

void Lens::draw(const PanelContext& lab, Size framebuffer) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 mouse = io.MousePos, display = io.DisplaySize;
    if (mouse.x < 0 || mouse.y < 0 || mouse.x >= display.x || mouse.y >= display.y) return;
    const float across = lab.px(radius), pixels = io.DisplayFramebufferScale.x;
    const int side = static_cast<int>(std::lround(2 * across * pixels / enlargement));
    if (side < 2 || side > std::min(framebuffer.width, framebuffer.height)) return;
    make_texture_for(side);
    // Near an edge the lens shows what lies beside the mouse, rather than nothing.
    const auto corner = [&](float middle, int length) {
        return std::clamp(static_cast<int>(std::lround(middle * pixels)) - side / 2, 0, length - side);
    };
    x_ = corner(mouse.x, framebuffer.width);
    y_ = framebuffer.height - side - corner(mouse.y, framebuffer.height);
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    draw.AddCallback(&Lens::take, this);
    draw.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(static_cast<GLuint>(texture_)));
    draw.AddImageRounded(texture, {mouse.x - across, mouse.y - across}, {mouse.x + across, mouse.y + across}, {0, 1}, {1, 0},
                         IM_COL32_WHITE, across);
    const float line = std::max(3.f, lab.px(5));
    draw.AddCircle(mouse, across, packed(palette(lab.theme).background), 0, 2 * line);
    draw.AddCircle(mouse, across, lab.ink(Ink::accent), 0, line);
}

}  // namespace pliant::viewer
