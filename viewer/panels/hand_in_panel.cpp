#include "panels/hand_in_panel.h"

#include <pliant/document/summary.h>
#include <pliant/text/format.h>

#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace pliant::viewer {
namespace {

using EntryKind = HandInEntry::Kind;

std::string entry_line(const HandInEntry& e) {
    const std::string where = e.slide.empty() ? e.lesson : fmt::format("{}, {}", e.lesson, e.slide);
    switch (e.kind) {
        case EntryKind::prediction:
            if (e.after_answer) return fmt::format("– {}: {} (after the answer)", where, e.predicted);
            return fmt::format("{} {}: {}", e.right ? "✓" : "✗", where, e.predicted);
        case EntryKind::measurement:
            return fmt::format("{}: {} = {} at t = {}", e.lesson, words(e.probe), format_quantity(e.value, e.unit),
                               format_quantity(e.time, "s"));
        case EntryKind::answer:
            return fmt::format("{}{}: {}", !e.own_verdict ? "" : *e.own_verdict ? "✓ " : "✗ ", where, e.text);
        case EntryKind::picture:
            return fmt::format("{}: a picture at t = {}", e.lesson, format_quantity(e.time, "s"));
    }
    return "";
}

void name_field(PanelContext& lab, HandInPanelState& panel) {
    Notebook& notebook = lab.session.notebook;
    ImGui::SetNextItemWidth(lab.px(240));
    if (!ImGui::InputTextWithHint("##name", "your name", panel.name.data(), panel.name.size())) {
        // Also what was read from a file.
        if (!ImGui::IsItemActive() && notebook.hand_in().name != panel.name.data()) {
            panel.name.fill('\0');
            notebook.hand_in().name.copy(panel.name.data(), panel.name.size() - 1);
        }
    } else {
        notebook.set_name(panel.name.data());
    }
    lab.note_control("hand-in name");
}

void entries(PanelContext& lab, float height) {
    Notebook& notebook = lab.session.notebook;
    std::optional<std::size_t> gone;
    ImGui::BeginChild("entries", {0, height}, ImGuiChildFlags_Border, ImGuiWindowFlags_NavFlattened);
    const auto& all = notebook.hand_in().entries;
    if (all.empty()) sentence_item(lab, "Nothing yet. What you predict in a walkthrough comes here by itself.");
    for (std::size_t k = 0; k < all.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        if (ImGui::SmallButton("×")) gone = k;
        lab.note_control(fmt::format("hand-in remove {}", k + 1));
        tooltip("Take this out", lab.scale);
        ImGui::SameLine();
        fitted_text(entry_line(all[k]), ImGui::GetContentRegionAvail().x);
        ImGui::PopID();
    }
    ImGui::EndChild();
    if (gone) notebook.erase(*gone);
}

// One of the probes where the run stands.
void number_menu(PanelContext& lab) {
    if (flowing_button(lab, "Note a number ▾", "hand-in number",
                       "A number of the run as it stands; who gets the file can repeat it", true))
        ImGui::OpenPopup("numbers");
    if (!ImGui::BeginPopup("numbers")) return;
    Session& s = lab.session;
    for (const Probe& p : s.lesson().probes) {
        const auto value = s.hides(p.name) ? std::nullopt : p.value();  // before it is predicted
        if (!value) continue;
        const std::string label = fmt::format("{} = {}", words(p.name), format_quantity(*value, p.unit));
        if (ImGui::MenuItem(label.c_str())) s.note_number(p.name);
        lab.note_control(fmt::format("hand-in number {}", p.name));
    }
    ImGui::EndPopup();
}

void answer_field(PanelContext& lab, HandInPanelState& panel) {
    const auto typed = panel.answer;
    ImGui::InputTextMultiline("##answer", panel.answer.data(), panel.answer.size(), {-1, 3.4f * ImGui::GetTextLineHeight()});
    // Escape leaves the field, and takes nothing of what was typed.
    if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) panel.answer = typed;
    lab.note_control("hand-in answer");
    const bool any = panel.answer[0] != '\0';
    ImGui::BeginDisabled(!any);
    const bool add = ImGui::Button("Add this answer");
    ImGui::EndDisabled();
    lab.note_control("hand-in add answer");
    if (!add) return;
    lab.session.note_answer(panel.answer.data());
    panel.answer.fill('\0');
}

}  // namespace

void draw_hand_in(PanelContext& lab, HandInPanelState& panel) {
    panel.has_keys = false;
    if (!panel.shown || panel.wants_picture || panel.takes_picture) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(lab.px(560), display.x * 0.9f);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, display.y * 0.95f});
    ImGui::Begin("Hand in", &panel.shown,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse);
    panel.has_keys = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    // From within a field as well.
    const bool leaves = panel.has_keys && ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGuiKey_Escape, false);
    name_field(lab, panel);
    entries(lab, std::min(lab.px(150), 0.3f * display.y));
    number_menu(lab);
    if (flowing_button(lab, "Note the picture", "hand-in picture", "The picture of the scene as it stands, within the file"))
        panel.wants_picture = true;
    sentence_item(lab, lab.session.walkthrough ? "In your own words, to the question of this slide:" : "In your own words:");
    answer_field(lab, panel);
    ImGui::Separator();
    if (flowing_button(lab, "Save to hand in…", "hand-in save", "Writes the file; pliant handin FILE reads and checks it", true))
        panel.wants_save = true, panel.shown = false;
    if (flowing_button(lab, "Start anew", "hand-in clear", "Takes out all entries")) lab.session.notebook.clear();
    if (flowing_button(lab, "Close", "hand-in close", "Closes this (H or Escape); what is noted is kept until you start anew"))
        panel.shown = false;
    if (leaves) panel.shown = false;
    if (!panel.shown) panel.has_keys = false;
    ImGui::End();
}

}  // namespace pliant::viewer
