#include "panels/theme.h"

#include <imgui.h>

#include "platform/font.h"

#include <array>
#include <vector>

namespace pliant::viewer {
namespace {

ImVec4 shade(int r, int g, int b, float a = 1) { return {r / 255.f, g / 255.f, b / 255.f, a}; }

void dark_colours(ImVec4* c) {
    ImGui::StyleColorsDark();
    c[ImGuiCol_WindowBg] = shade(26, 29, 36);
    c[ImGuiCol_ChildBg] = shade(26, 29, 36);
    c[ImGuiCol_PopupBg] = shade(34, 38, 47);
    c[ImGuiCol_Border] = shade(58, 64, 76);
    c[ImGuiCol_Text] = shade(226, 230, 236);
    c[ImGuiCol_TextDisabled] = shade(140, 147, 158);
    c[ImGuiCol_FrameBg] = shade(44, 49, 60);
    c[ImGuiCol_FrameBgHovered] = shade(56, 63, 77);
    c[ImGuiCol_FrameBgActive] = shade(66, 74, 90);
    c[ImGuiCol_Button] = shade(52, 59, 73);
    c[ImGuiCol_ButtonHovered] = shade(68, 78, 97);
    c[ImGuiCol_ButtonActive] = shade(60, 110, 160);
    c[ImGuiCol_Header] = shade(45, 80, 118);
    c[ImGuiCol_HeaderHovered] = shade(54, 94, 138);
    c[ImGuiCol_HeaderActive] = shade(60, 104, 152);
    c[ImGuiCol_SliderGrab] = shade(104, 160, 215);
    c[ImGuiCol_SliderGrabActive] = shade(140, 190, 240);
    c[ImGuiCol_CheckMark] = shade(120, 180, 235);
    c[ImGuiCol_Separator] = shade(52, 57, 68);
    c[ImGuiCol_NavHighlight] = shade(245, 215, 60);
    c[ImGuiCol_Tab] = shade(38, 43, 53);
    c[ImGuiCol_TabActive] = shade(52, 90, 130);
    c[ImGuiCol_TabHovered] = shade(64, 108, 155);
}

void projector_colours(ImVec4* c) {
    ImGui::StyleColorsLight();
    c[ImGuiCol_WindowBg] = shade(255, 255, 255);
    c[ImGuiCol_ChildBg] = shade(255, 255, 255);
    c[ImGuiCol_PopupBg] = shade(255, 255, 255);
    c[ImGuiCol_Border] = shade(130, 136, 145);
    c[ImGuiCol_Text] = shade(0, 0, 0);
    c[ImGuiCol_TextDisabled] = shade(85, 90, 98);
    c[ImGuiCol_FrameBg] = shade(228, 232, 238);
    c[ImGuiCol_FrameBgHovered] = shade(210, 220, 232);
    c[ImGuiCol_FrameBgActive] = shade(190, 208, 228);
    c[ImGuiCol_Button] = shade(216, 223, 232);
    c[ImGuiCol_ButtonHovered] = shade(192, 208, 226);
    c[ImGuiCol_ButtonActive] = shade(150, 185, 220);
    c[ImGuiCol_Header] = shade(190, 213, 238);
    c[ImGuiCol_HeaderHovered] = shade(172, 202, 234);
    c[ImGuiCol_HeaderActive] = shade(150, 188, 228);
    c[ImGuiCol_SliderGrab] = shade(0, 95, 160);
    c[ImGuiCol_SliderGrabActive] = shade(0, 70, 125);
    c[ImGuiCol_CheckMark] = shade(0, 80, 140);
    c[ImGuiCol_NavHighlight] = shade(195, 70, 0);
}

}  // namespace

Fonts load_fonts(float scale) {
    ImGui::GetIO().Fonts->Clear();
    const std::array heights{15 * scale, 12.5f * scale, 19 * scale, 24 * scale, 29 * scale, 34 * scale};
    const LoadedFonts loaded = add_fonts(heights);
    const std::vector<ImFont*>& all = loaded.words;
    return {.normal = all[0],
            .small = all[1],
            .medium = all[2],
            .large = all[3],
            .larger = all[4],
            .huge = all[5],
            .mathematics = MathType(loaded.mathematics, all)};
}

void apply_theme(Theme theme, float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    theme == Theme::dark ? dark_colours(style.Colors) : projector_colours(style.Colors);
    style.WindowRounding = 0;
    style.WindowBorderSize = 1;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.GrabMinSize = 12;
    style.WindowPadding = {8, 7};
    style.FramePadding = {6, 3};
    style.ItemSpacing = {7, 5};
    style.ScrollbarSize = 11;
    style.FrameBorderSize = theme == Theme::projector ? 1.f : 0.f;
    style.ScaleAllSizes(scale);
}

unsigned packed(Rgba8 c, float opacity) { return IM_COL32(c.r, c.g, c.b, static_cast<int>(c.a * opacity)); }

unsigned ink(Theme theme, Ink role, float opacity) { return packed(palette(theme).of(role), opacity); }

}  // namespace pliant::viewer
