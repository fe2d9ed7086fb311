#include "panels/scene_messages.h"

#include <pliant/run/awaited.h>

#include "panels/companion_panel.h"
#include "panels/flowing_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace pliant::viewer {

void draw_banner(PanelContext& lab, const Rectangle& place) {
    const auto& message = lab.session.message();
    if (!message || lab.session.autopsy()) return;
    using Kind = Session::Message::Kind;
    const Rgba8 colour = message->kind == Kind::info ? quiet_colour : bad_colour;
    ImGui::SetCursorScreenPos({place.x + lab.px(10), place.y + lab.px(10)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, packed(colour, 0.94f));
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_WHITE);
    const float width = place.width - lab.px(20), wrap = width - lab.px(20);
    const float text_height = ImGui::CalcTextSize(message->text.c_str(), nullptr, false, wrap).y;
    const std::string text = message->text;
    ImGui::BeginChild("message", {width, text_height + ImGui::GetFrameHeight() + lab.px(22)},
                      ImGuiChildFlags_AlwaysUseWindowPadding);
    ImGui::PushTextWrapPos(wrap);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 90));
    if (ImGui::Button("Dismiss")) lab.session.dismiss();
    lab.note_control("dismiss");
    tooltip("Close this (Escape)", lab.scale);
    ImGui::PopStyleColor();
    ImGui::EndChild();
    ImGui::PopStyleColor(2);
}

void draw_unsolved(PanelContext& lab, const ScenePanelState& panel, const Rectangle& place) {
    const Session& s = lab.session;
    const bool waits = s.runner().is_static() && s.runner().place() == Place{} && !s.playing && !s.moving();
    // On a slide with a question that is for Next.
    const bool asked = s.walkthrough && s.walkthrough->slide().has_answer();
    if (!waits || asked || lab.layout != Layout::lab || lab.animation.progress) return;
    constexpr const char* words = "Not solved yet: press Space";
    const ImVec2 size = ImGui::CalcTextSize(words), pad = ImGui::GetStyle().FramePadding;
    const float width = size.x + 2 * pad.x, up = panel.hints_shown ? 3 * ImGui::GetTextLineHeight() + lab.px(42) : lab.px(10);
    if (width > place.width) return;
    ImGui::SetCursorScreenPos({place.x + (place.width - width) / 2, place.y + place.height - ImGui::GetFrameHeight() - up});
    if (ImGui::Button(words)) lab.wanted.push_back(Action::play);
    lab.note_control("solve");
}

void draw_hints(PanelContext& lab, ScenePanelState& panel, const Rectangle& place) {
    if (!panel.hints_shown || lab.layout != Layout::lab || lab.animation.progress) return;
    const bool can_pull = lab.session.lesson().can_pull().has_value();
    const std::string all = fmt::format(
        "{}\nSpace pauses; . goes one step, / one stage, , back\nMove a slider on the left; F1 shows all keys",
        can_pull ? "Pull it with the mouse; drag beside it to turn" : "Drag to move the picture, turn the wheel to zoom");
    const float pad = lab.px(8), button = ImGui::GetFrameHeight(), room = place.width - button - 3 * pad - lab.px(20);
    const std::string text = ImGui::CalcTextSize(all.c_str()).x > room ? flowing_text(all, ImGui::GetFont(), room) : all;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at{place.x + lab.px(10), place.y + place.height - size.y - 2 * pad - lab.px(10)};
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x + button + 3 * pad, at.y + size.y + 2 * pad},
                                              ImGui::GetColorU32(ImGuiCol_PopupBg, 0.88f), lab.px(5));
    ImGui::GetWindowDrawList()->AddText({at.x + pad, at.y + pad}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    ImGui::SetCursorScreenPos({at.x + size.x + 2 * pad, at.y + pad});
    if (ImGui::Button("×", {button, button})) panel.hints_shown = false;
    lab.note_control("hide hints");
}

void name_pinned(PanelContext& lab, ScenePanelState& panel, const Rectangle& place) {
    if (!lab.session.pinned()) return;
    const bool hinted = panel.hints_shown && lab.layout == Layout::lab;
    const float up = hinted ? 3 * ImGui::GetTextLineHeight() + lab.px(34) : lab.px(8);
    const ImVec2 at{place.x + lab.px(10), place.y + place.height - ImGui::GetTextLineHeight() - up};
    haloed_text(lab, at, lab.ink(Ink::text), pinned_text(lab.session));
}

namespace {

// A plate of words at the lower end of a picture.
void plate(PanelContext& lab, const Rectangle& place, const std::string& text, Rgba8 colour) {
    const float pad = lab.px(10), widest = place.width - 4 * pad;
    const float wrap = std::min(widest, ImGui::CalcTextSize(text.c_str()).x + 1);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 at{place.x + pad, place.y + place.height - size.y - 3 * pad};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(at, {at.x + wrap + 2 * pad, at.y + size.y + 2 * pad}, packed(colour, 0.94f), lab.px(4));
    draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + pad, at.y + pad}, IM_COL32_WHITE, text.c_str(), nullptr, wrap);
}

}  // namespace

void tell_of_beside(PanelContext& lab, const Rectangle& place) {
    const std::string& why = lab.session.companion()->stopped();
    if (!why.empty()) return plate(lab, place, fmt::format("B stopped, A goes on: {}", why), bad_colour);
    if (const std::string text = catching_up_text(lab.session); !text.empty()) plate(lab, place, text, quiet_colour);
}

namespace {

// Of words of this size: the lower left corner of a picture, or else the first one in which they lie on the fewest labels.
ImVec2 corner_beside(const std::vector<Rectangle>& labels, const Rectangle& place, ImVec2 size, ImVec2 margin) {
    const float left = place.x + margin.x, right = place.x + place.width - size.x - margin.x, top = place.y + margin.y,
                low = place.y + place.height - size.y - margin.y;
    const auto covered = [&](ImVec2 at) {
        return std::ranges::count_if(labels, [&](const Rectangle& l) {
            return l.x < at.x + size.x && at.x < l.x + l.width && l.y < at.y + size.y && at.y < l.y + l.height;
        });
    };
    const std::array corners{ImVec2{left, low}, ImVec2{right, low}, ImVec2{right, top}, ImVec2{left, top}};
    return *std::ranges::min_element(corners, {}, covered);
}

}  // namespace

void tell_awaited(PanelContext& lab, const Scene& scene, const Runner* runner, const Rectangle& place,
                  const std::vector<Rectangle>& labels) {
    if (!scene.awaits(scene.colour_by.field) || scene.override_values) return;
    const Field* field = runner ? runner->lesson().find_field(scene.colour_by.field) : nullptr;
    const std::string stage = field ? not_yet(awaited_stage(*runner, *field)) : "",
                      text = "Grey: " + (stage.empty() ? "not computed yet" : stage);
    // In a slide below the picture where it can be: headings and notes are above it. In the lab the hints are there.
    const bool low = lab.layout == Layout::deck;
    ImGui::PushFont(low ? lab.fonts.medium : lab.fonts.small);
    const ImVec2 pad{lab.px(6), lab.px(2)};
    const float wrap =
        low ? place.width - lab.px(20) : std::max(0.6f * place.width, std::min(place.width - lab.px(20), lab.px(240)));
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 at =
        low ? corner_beside(labels, place, size, {lab.px(10), lab.px(6)}) : ImVec2{place.x + lab.px(10), place.y + lab.px(4)};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled({at.x - pad.x, at.y - pad.y}, {at.x + size.x + pad.x, at.y + size.y + pad.y},
                        packed(palette(lab.theme).background, 0.8f), pad.x);
    draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, lab.ink(Ink::text), text.c_str(), nullptr, wrap);
    lab.controls["not computed yet"] = {at.x, at.y, size.x, size.y};
    ImGui::PopFont();
}

}  // namespace pliant::viewer
