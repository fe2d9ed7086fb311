#include "panels/typed_number.h"

#include <imgui_internal.h>
#include <pliant/math/error.h>
#include <pliant/text/format.h>
#include <pliant/text/number_text.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

void begin_typing(TypedNumber& typed, ImGuiID control, const std::string& now) {
    typed.control = control;
    typed.text.fill('\0');
    now.copy(typed.text.data(), typed.text.size() - 1);
}

bool typing_starts(ImGuiID id, const ImRect& frame) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    if (g.CurrentItemFlags & ImGuiItemFlags_Disabled) return false;
    const bool free = g.ActiveId == 0 || g.ActiveId == id || g.ActiveIdAllowOverlap;
    const bool clicked = g.IO.KeyCtrl && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered() &&
                         ImGui::IsMouseHoveringRect(frame.Min, frame.Max);
    return (clicked && free) || (g.NavActivateId == id && (g.NavActivateFlags & ImGuiActivateFlags_PreferInput));
}

void draw_text(TypedNumber& typed, const char* label, ImGuiID id, const ImRect& frame) {
    if (!ImGui::ItemAdd(frame, id, &frame, ImGuiItemFlags_Inputable)) return ImGui::ItemSize(frame);
    ImGui::TempInputText(frame, id, label, typed.text.data(), static_cast<int>(typed.text.size()),
                         ImGuiInputTextFlags_AutoSelectAll);
}

// What the last item, if it is that of the text, has been left with.
std::optional<std::string> entered(TypedNumber& typed, ImGuiID id) {
    if (typed.control != id || !ImGui::IsItemDeactivated()) return std::nullopt;
    typed.control = 0;
    return ImGui::IsItemDeactivatedAfterEdit() ? std::optional<std::string>(typed.text.data()) : std::nullopt;
}

}  // namespace

std::optional<std::string> slider_or_text(TypedNumber& typed, const char* label, const std::string& now,
                                          const std::function<void()>& draw_slider) {
    const ImGuiID id = ImGui::GetID(label);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImRect frame(from, {from.x + ImGui::CalcItemWidth(), from.y + ImGui::GetFrameHeight()});
    bool typing = ImGui::TempInputIsActive(id);
    if (!typing && typing_starts(id, frame)) begin_typing(typed, id, now), typing = true;
    // Tab goes to it to type, as to any field of text.
    ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);
    typing ? draw_text(typed, label, id, frame) : draw_slider();
    ImGui::PopItemFlag();
    return entered(typed, id);
}

namespace {

std::optional<std::string> text_field(TypedNumber& typed, const char* label, const char* hint, const std::string& now,
                                      ImGuiInputTextFlags flags) {
    const ImGuiID id = ImGui::GetID(label);
    // Unless it is typed into, the field shows what there is.
    decltype(typed.text) shown{};
    now.copy(shown.data(), shown.size() - 1);
    auto& text = typed.control == id ? typed.text : shown;
    ImGui::InputTextWithHint(label, hint, text.data(), text.size(), flags);
    if (ImGui::IsItemActivated()) begin_typing(typed, id, now);
    return entered(typed, id);
}

}  // namespace

std::optional<std::string> number_field(TypedNumber& typed, const char* label, const std::string& now) {
    return text_field(typed, label, "", now, ImGuiInputTextFlags_AutoSelectAll);
}

std::optional<std::string> words_field(TypedNumber& typed, const char* label, const char* hint, const std::string& now) {
    ImGui::SetNextItemWidth(-1);
    return text_field(typed, label, hint, now, ImGuiInputTextFlags_None);
}

Index whole_typed(std::string_view name, std::string_view text, Index least, Index most) {
    const auto value = whole_number(text);
    if (!value || *value < least || *value > most)
        throw Refused(fmt::format("{} = '{}' is not accepted: give a whole number from {} to {}", name, text, least, most));
    return *value;
}

Real number_typed(std::string_view name, std::string_view text, Real least, Real most) {
    const auto value = finite_number(text);
    if (!value || *value < least || *value > most)
        throw Refused(fmt::format("{} = '{}' is not accepted: give a number from {} to {}", name, text, format_exact(least),
                                  format_exact(most)));
    return *value;
}

}  // namespace pliant::viewer
