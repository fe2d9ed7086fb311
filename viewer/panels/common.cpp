#include "panels/lab_state.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {

FixedPanel::FixedPanel(const char* name, const Rectangle& r, int extra_flags) {
    ImGui::SetNextWindowPos({r.x, r.y});
    ImGui::SetNextWindowSize({std::max(r.width, 1.f), std::max(r.height, 1.f)});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | extra_flags);
}

FixedPanel::~FixedPanel() { ImGui::End(); }

void LabState::take_typed(const std::function<void()>& action) {
    try {
        action();
    } catch (const Refused& e) {
        session.say(Session::Message::Kind::refused, e.what());
    }
}

void LabState::note_control(const std::string& name) {
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    controls[name] = {a.x, a.y, b.x - a.x, b.y - a.y};
}

std::string_view name_of(Layout layout) { return layout == Layout::lab ? "lab" : layout == Layout::slide ? "slide" : "deck"; }

void fitted_text(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return ImGui::TextUnformatted(text.c_str());
    std::string cut = text;
    while (!cut.empty() && ImGui::CalcTextSize((cut + "…").c_str()).x > width) {
        // Takes off one whole UTF-8 character.
        while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80) cut.pop_back();
        if (!cut.empty()) cut.pop_back();
    }
    ImGui::TextUnformatted((cut + "…").c_str());
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_DelayShort)) ImGui::SetTooltip("%s", text.c_str());
}

void haloed_text(LabState& lab, ImVec2 at, unsigned colour, const std::string& text) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const Rgba8 b = palette(lab.theme).background;
    const unsigned halo = packed(b, 0.75f);
    const float d = std::max(1.f, lab.px(1));
    for (const auto& [x, y] : {std::pair{-d, 0.f}, {d, 0.f}, {0.f, -d}, {0.f, d}, {-d, -d}, {d, d}, {-d, d}, {d, -d}})
        draw->AddText({at.x + x, at.y + y}, halo, text.c_str());
    draw->AddText(at, colour, text.c_str());
}

void tooltip(const std::string& text, float scale) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_DelayShort | ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(320 * scale);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool flowing_button(LabState& lab, const std::string& label, const std::string& name, const std::string& help, bool first) {
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (!first) {
        ImGui::SameLine();
        if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    }
    const bool pressed = ImGui::Button(label.c_str());
    lab.note_control(name);
    tooltip(help, lab.scale);
    return pressed;
}

std::string without_marks(const std::string& text) {
    std::string plain;
    for (const char c : text)
        if (c != '`' && c != '*') plain += c;
    return plain;
}

std::string words(std::string_view key) {
    std::string text(key);
    std::ranges::replace(text, '_', ' ');
    if (text.starts_with("youngs ")) text.replace(0, 7, "Young's ");
    if (text.starts_with("poisson ")) text.replace(0, 8, "Poisson ");
    if (text == "cfl") return "CFL";
    if (text.size() > 1 && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace pliant::viewer
