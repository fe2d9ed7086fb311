#include "panels/file_dialog.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr const char* chooser = "Choose a file";

void put_text(ImGuiInputTextCallbackData& data, const std::string& text) {
    data.DeleteChars(0, data.BufTextLen);
    data.InsertChars(0, text.c_str());
}

struct Asked {
    FileChoice& files;
    FileDialogState& panel;
};

// The arrows go through the list while a name is typed.
int on_history(ImGuiInputTextCallbackData* data) {
    const auto& asked = *static_cast<Asked*>(data->UserData);
    FileChoice& files = asked.files;
    asked.panel.scroll = true;
    files.name.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    files.move(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
    put_text(*data, files.name);
    return 0;
}

void name_field(PanelContext& lab, FileDialogState& panel, bool focus) {
    FileChoice& files = lab.files;
    char buffer[1024] = {};
    files.name.copy(buffer, sizeof buffer - 1);
    if (focus) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    Asked asked{files, panel};
    const bool entered = ImGui::InputTextWithHint(
        "##name", "name or path", buffer, sizeof buffer,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_AutoSelectAll,
        on_history, &asked);
    lab.note_control("file name");
    tooltip("Type a name or a path; ~ is your own folder. Up and Down go through the list, Enter takes it.", lab.scale);
    if (buffer != files.name) files.name = buffer, files.keep();
    if (entered) files.accept(), panel.focus = true;
}

void folder_row(PanelContext& lab, FileDialogState& panel) {
    FileChoice& files = lab.files;
    if (ImGui::Button("Up")) files.go_up(), panel.focus = true;
    lab.note_control("file up");
    tooltip("To the folder that holds this one", lab.scale);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    fitted_text(files.folder().string(), ImGui::GetContentRegionAvail().x);
}

void list_of_files(PanelContext& lab, FileDialogState& panel, float height) {
    FileChoice& files = lab.files;
    ImGui::BeginChild("list", {0, height}, ImGuiChildFlags_Border);
    if (files.entries().empty()) ImGui::TextDisabled("No folders and no %s files here.", files.ending_words().c_str());
    std::string taken;
    for (const FileChoice::Entry& e : files.entries()) {
        const bool named = e.name == files.name;
        const std::string label = e.folder ? e.name + "/" : e.name;
        if (ImGui::Selectable(label.c_str(), named, ImGuiSelectableFlags_AllowDoubleClick)) taken = e.name;
        lab.note_control("file entry " + e.name);
        if (named && std::exchange(panel.scroll, false) && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    if (taken.empty()) return;
    files.name = taken;
    files.keep();
    panel.focus = true;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) files.accept();
}

bool button(PanelContext& lab, const std::string& name, const char* control, const char* help) {
    const bool used = ImGui::Button(name.c_str());
    lab.note_control(control);
    tooltip(help, lab.scale);
    ImGui::SameLine();
    return used;
}

void answers(PanelContext& lab, FileDialogState& panel) {
    FileChoice& files = lab.files;
    const bool open = files.purpose() == FileChoice::Purpose::open;
    if (files.asks_to_replace()) {
        if (button(lab, "Replace it", "file replace", "Write over the file that is there (Enter)")) files.replace();
        if (button(lab, "Keep it", "file keep", "Choose another name")) files.keep(), panel.focus = true;
    } else {
        if (button(lab, open ? "Open" : "Save", "file accept", "Take this file, or go to this folder (Enter)")) files.accept();
    }
    if (button(lab, "Cancel", "file cancel", "Leave everything as it is (Escape)")) files.cancel();
    bool all = files.all_files();
    if (ImGui::Checkbox("all files", &all)) files.show_all_files(all);
    lab.note_control("file all");
    tooltip(fmt::format("Show every file, not only those that end in {}", files.ending_words()), lab.scale);
}

void words_of(PanelContext& lab) {
    const FileChoice& files = lab.files;
    std::string text = files.complaint();
    if (files.asks_to_replace()) text = fmt::format("{} is there already. Replace it?", files.name);
    ImGui::PushStyleColor(ImGuiCol_Text, packed(bad_colour));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0);
    ImGui::BeginChild("words", {0, 2 * ImGui::GetTextLineHeightWithSpacing()});
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::EndChild();
    ImGui::PopStyleColor(2);
}

}  // namespace

void draw_file_dialog(PanelContext& lab, FileDialogState& panel) {
    FileChoice& files = lab.files;
    if (!files.asking()) return;
    const bool fresh = files.questions() != panel.question;
    panel.question = files.questions();
    if (!ImGui::IsPopupOpen(chooser)) ImGui::OpenPopup(chooser);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 size{std::min(lab.px(560), 0.9f * display.x), std::min(lab.px(430), 0.9f * display.y)};
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal(
            chooser, nullptr,
            ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
        return;
    // Looked at first: the field of the name would give up the key to itself.
    const bool escape = ImGui::IsKeyPressed(ImGuiKey_Escape, false), replacing = files.asks_to_replace();
    ImGui::TextUnformatted(files.title().c_str());
    folder_row(lab, panel);
    const float below =
        2 * ImGui::GetFrameHeightWithSpacing() + 2 * ImGui::GetTextLineHeightWithSpacing() + 2 * ImGui::GetStyle().ItemSpacing.y;
    list_of_files(lab, panel, std::max(lab.px(60), ImGui::GetContentRegionAvail().y - below));
    const bool focus = fresh || std::exchange(panel.focus, false);
    name_field(lab, panel, focus);
    words_of(lab);
    answers(lab, panel);
    if (escape) replacing ? files.keep() : files.cancel(), panel.focus = true;
    if (!files.asking()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pliant::viewer
