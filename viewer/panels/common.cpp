#include "panels/panel_context.h"

#include <imgui_internal.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

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

void PanelContext::take_typed(const std::function<void()>& action) {
    try {
        action();
    } catch (const Refused& e) {
        session.say(Session::Message::Kind::refused, e.what());
    }
}

void PanelContext::note_control(const std::string& name) {
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    controls[name] = {a.x, a.y, b.x - a.x, b.y - a.y};
    const ImGuiWindow& w = *ImGui::GetCurrentWindow();
    const ImRect& shown = w.ClipRect;
    constexpr float hair = 1.5f;  // px
    const bool bar = !(w.Flags & ImGuiWindowFlags_NoScrollbar);
    const bool across = (a.x < shown.Min.x - hair || b.x > shown.Max.x + hair) && !(bar && w.ScrollMax.x > 0),
               up = (a.y < shown.Min.y - hair || b.y > shown.Max.y + hair) && !(bar && w.ScrollMax.y > 0);
    if (across || up) cut.insert(name);
}

std::string_view name_of(SideTab tab) {
    constexpr std::string_view names[]{"plots", "inspect", "claims", "atlas", "methods"};
    return names[static_cast<std::size_t>(tab)];
}
std::string_view name_of(Layout layout) {
    switch (layout) {
        case Layout::lab:
            return "lab";
        case Layout::slide:
            return "slide";
        case Layout::deck:
            return "deck";
        case Layout::presenter:
            return "presenter";
    }
    return "";
}

std::string with_ellipsis(std::string text, float width) {
    while (!text.empty() && ImGui::CalcTextSize((text + "…").c_str()).x > width) {
        // Takes off one whole UTF-8 character.
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
        if (!text.empty()) text.pop_back();
    }
    return text + "…";
}

void fitted_text(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return ImGui::TextUnformatted(text.c_str());
    ImGui::TextUnformatted(with_ellipsis(text, width).c_str());
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_DelayShort)) ImGui::SetTooltip("%s", text.c_str());
}

void haloed_text(PanelContext& lab, ImVec2 at, unsigned colour, const std::string& text) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const Rgba8 b = palette(lab.theme).background;
    const unsigned halo = packed(b, 0.75f);
    const float d = std::max(1.f, lab.px(1));
    for (const auto& [x, y] : {std::pair{-d, 0.f}, {d, 0.f}, {0.f, -d}, {0.f, d}, {-d, -d}, {d, d}, {-d, d}, {d, -d}})
        draw->AddText({at.x + x, at.y + y}, halo, text.c_str());
    draw->AddText(at, colour, text.c_str());
}

void place_tip() {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    if (g.NavDisableHighlight || !g.NavDisableMouseHover) return;
    const ImRect panel = g.CurrentWindow->RootWindow->Rect(), item = g.LastItemData.Rect;
    const bool on_the_left = panel.GetCenter().x < g.IO.DisplaySize.x / 2;
    ImGui::SetNextWindowPos({on_the_left ? panel.Max.x : panel.Min.x, item.Min.y}, ImGuiCond_Always,
                            {on_the_left ? 0.f : 1.f, 0});
}

void place_tip_beside(const Rectangle& size) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    const ImRect panel = g.CurrentWindow->RootWindow->Rect(), item = g.LastItemData.Rect;
    const ImVec2 display = g.IO.DisplaySize;
    const bool on_the_left = panel.GetCenter().x < display.x / 2, narrow = panel.GetWidth() < 0.45f * display.x;
    ImVec2 at{on_the_left ? panel.Max.x : panel.Min.x - size.width, item.Min.y};
    if (!narrow) at = {item.Min.x, item.Min.y - size.height - ImGui::GetStyle().ItemSpacing.y};
    at.x = std::clamp(at.x, 0.f, std::max(0.f, display.x - size.width));
    at.y = std::clamp(at.y, 0.f, std::max(0.f, display.y - size.height));
    ImGui::SetNextWindowPos(at);
}

void tooltip(const std::string& text, float scale) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_DelayShort | ImGuiHoveredFlags_AllowWhenDisabled)) return;
    place_tip();
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(320 * scale);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool flowing_button(PanelContext& lab, const std::string& label, const std::string& name, const std::string& help, bool first) {
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

std::string capitalised(std::string text) {
    const bool symbol = text.size() < 2 || text[1] == ' ';
    if (!symbol && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string words(std::string_view key) { return capitalised(spoken(key)); }

std::string not_yet(const Stage* awaited) {
    return awaited ? fmt::format("not computed yet: the stage “{}” does it", words(awaited->name)) : "";
}

namespace {

// Small letters and digits alone, with lowered digits as plain ones.
std::string spelled(std::string_view text) {
    std::string letters(text);
    constexpr std::string_view lowered = "₀₁₂₃₄₅₆₇₈₉";
    for (std::size_t digit = 0; digit < 10; ++digit) {
        const std::string_view sign = lowered.substr(3 * digit, 3);
        for (auto at = letters.find(sign); at != std::string::npos; at = letters.find(sign))
            letters.replace(at, 3, 1, static_cast<char>('0' + digit));
    }
    std::erase_if(letters, [](char c) { return c == ' ' || c == '_'; });
    std::ranges::transform(letters, letters.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return letters;
}

}  // namespace

bool says_the_same(std::string_view key, std::string_view symbol) { return spelled(key) == spelled(symbol); }

std::string name_with_symbol(std::string_view key, std::string_view symbol, std::string_view gap) {
    std::string name = words(key);
    if (symbol.empty()) return name;
    if (says_the_same(key, symbol)) return std::string(symbol);
    return name.append(gap).append(symbol);
}

}  // namespace pliant::viewer
