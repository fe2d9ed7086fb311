// The menus at the top of the lab. Each entry is an action of the table of keys, which says its key and what it does.
#include <imgui_internal.h>

#include "app/lab_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <utility>

namespace pliant::viewer {
namespace {

void item(LabState& lab, Action action, const char* name, bool enabled = true, bool ticked = false) {
    const KeyBinding& b = binding(action);
    const std::string keys(b.keys);
    if (ImGui::MenuItem(name, keys.empty() ? nullptr : keys.c_str(), ticked, enabled)) lab.wanted.push_back(action);
    lab.note_control(fmt::format("menu {}", name));
    std::string help(b.meaning);
    help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(help[0])));
    tooltip(help, lab.scale);
}

// `entries` draws what the menu holds while it is open.
template <class Entries>
void menu(LabState& lab, const char* name, Entries entries) {
    const bool open = ImGui::BeginMenu(name);
    lab.note_control(fmt::format("menu {}", name));
    if (!open) return;
    entries(lab);
    ImGui::EndMenu();
}

void recent_menu(LabState& lab) {
    const bool open = ImGui::BeginMenu("Open recent", !lab.recent.empty());
    lab.note_control("menu Open recent");
    if (!open) return;
    for (const std::string& path : lab.recent) {
        std::error_code ignored;
        const bool there = std::filesystem::exists(path, ignored);
        const std::string label = fmt::format("{}##{}", std::filesystem::path(path).filename().string(), path);
        if (ImGui::MenuItem(label.c_str(), nullptr, false, there)) lab.wanted_files.push_back(path);
        lab.note_control(fmt::format("menu recent {}", path));
        tooltip(there ? path : fmt::format("{} is no longer there", path), lab.scale);
    }
    ImGui::EndMenu();
}

void file_menu(LabState& lab) {
    const bool free = !lab.animation.progress;
    item(lab, Action::open, "Open…");
    recent_menu(lab);
    item(lab, Action::save, "Save");
    item(lab, Action::save_as, "Save as…");
    ImGui::Separator();
    item(lab, Action::copy_share, "Copy share string");
    item(lab, Action::paste_share, "Paste share string");
    ImGui::Separator();
    item(lab, Action::save_scene_picture, "Save the picture…", free);
    item(lab, Action::save_window_picture, "Save the window…", free);
    item(lab, Action::save_plots, "Save plots as SVG", !lab.plots.chosen.empty());
    item(lab, Action::save_probes, "Save probes as CSV…", !lab.session.recorder().empty());
    ImGui::Separator();
    item(lab, Action::hand_in, "Hand in…");
    ImGui::Separator();
    item(lab, Action::save_animation, "Save an animation…", free);
    ImGui::Separator();
    item(lab, Action::quit, "Quit");
}

void edit_menu(LabState& lab) {
    const Runner& r = lab.session.runner();
    const bool changed =
        std::ranges::any_of(r.lesson().parameters, [&](const Parameter* p) { return r.wanted(*p) != p->info.initial; });
    item(lab, Action::undo, "Undo", lab.session.can_undo());
    item(lab, Action::defaults, "Default values", changed);
}

void run_menu(LabState& lab) {
    const bool begun = lab.session.runner().place() != Place{};
    item(lab, Action::play, lab.session.playing ? "Pause" : "Play");
    item(lab, Action::step, "One step");
    item(lab, Action::stage, "One stage");
    item(lab, Action::pass, "One pass");
    ImGui::Separator();
    item(lab, Action::step_back, "One step back", begun);
    item(lab, Action::stage_back, "One stage back", begun);
    item(lab, Action::reset, "Reset");
}

// A press opens the scene of an extension, with its question.
void extensions_menu(LabState& lab) {
    Session& s = lab.session;
    if (s.extensions().empty()) return;
    ImGui::Separator();
    ImGui::TextDisabled("Go on from here");
    for (std::size_t k = 0; k < s.extensions().size(); ++k) {
        const std::string label = fmt::format("{}##extension {}", s.extensions()[k].slide().title, k);
        if (ImGui::MenuItem(label.c_str(), nullptr, s.extension() == k)) s.open_extension(k);
        lab.note_control(fmt::format("menu extension {}", k + 1));
    }
}

void lesson_menu(LabState& lab) {
    const bool told = !find_text(std::string(lab.session.entry().info.id) + "/walkthrough.md").empty();
    item(lab, Action::previous_lesson, "Previous lesson");
    item(lab, Action::next_lesson, "Next lesson");
    ImGui::Separator();
    item(lab, Action::walkthrough_next, lab.session.walkthrough ? "Next of the slide" : "Walkthrough", told);
    item(lab, Action::deck, "Deck", told);
    extensions_menu(lab);
}

void lecture_menu(LabState& lab) {
    const Session& s = lab.session;
    const bool walks = s.walkthrough && !s.lecture() && !s.extension();
    item(lab, Action::open_lecture, "Open a lecture…");
    for (const std::string& name : lecture_names()) {
        std::string title = words(name);
        title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
        if (ImGui::MenuItem(title.c_str())) lab.wanted_lecture = name;
        lab.note_control(fmt::format("menu lecture {}", name));
        tooltip("A lecture of 45 minutes that comes with Pliant", lab.scale);
    }
    ImGui::Separator();
    item(lab, Action::add_scene, "Add this scene");
    item(lab, Action::add_slide, "Add this slide", walks);
    item(lab, Action::add_claim, "Add this claim", lab.side == SideTab::claims && lab.claims.book.unfolded(s.entry().info.id));
    item(lab, Action::add_map, "Add this map", lab.side == SideTab::atlas && !lab.atlas.atlas.across.empty());
    ImGui::Separator();
    item(lab, Action::deck, "Show it", s.lecture() != nullptr);
    item(lab, Action::presenter, "Window of the lecturer", true, lab.presenter.wanted);
    item(lab, Action::end_lecture, "Leave the lecture", s.lecture() != nullptr);
}

// The panels that may, as they were in the last frame.
void fill_menu(LabState& lab) {
    std::vector<Fill> offered{{Filled::atlas, ""}};
    for (const auto& [place, what] : lab.fillable)
        if (std::ranges::find(offered, what) == offered.end()) offered.insert(offered.end() - 1, what);
    const bool open = ImGui::BeginMenu("Fill the screen with");
    lab.note_control("menu Fill the screen with");
    tooltip("The key X does it with what the mouse is over; X or Escape goes back", lab.scale);
    if (!open) return;
    for (const Fill& what : offered) {
        if (ImGui::MenuItem(label_of(what).c_str())) lab.fill = what;
        lab.note_control(fmt::format("menu fill {}", text_of(what)));
    }
    ImGui::EndMenu();
}

void view_menu(LabState& lab) {
    fill_menu(lab);
    item(lab, Action::full_screen, "Full screen", true, lab.full_screen);
    item(lab, Action::lens, "Large pointer that enlarges", true, lab.lens_shown);
    ImGui::Separator();
    item(lab, Action::theme, "Projector theme", true, lab.theme == Theme::projector);
    item(lab, Action::larger, "Larger", lab.scale < 3);
    item(lab, Action::smaller, "Smaller", lab.scale > 1);
    ImGui::Separator();
    item(lab, Action::arrows, "Arrows", true, lab.session.show_arrows);
    item(lab, Action::patterns, "Patterns", true, lab.session.patterns);
    item(lab, Action::summary, "Summary", true, !lab.summary.text.empty());
    item(lab, Action::claims, "Claims", true, lab.side == SideTab::claims);
    item(lab, Action::atlas, "Stability atlas", true, lab.side == SideTab::atlas);
    item(lab, Action::methods, "Compare all methods");
    item(lab, Action::frame, "Whole scene");
    item(lab, Action::hide_panels, "Hide the panels");
    item(lab, Action::extreme, "Extreme ranges", true, lab.session.extreme);
}

void help_menu(LabState& lab) { item(lab, Action::help, "Keys and mouse", true, lab.help_shown); }

// ImGui goes to a menu by keys only from the window that has it.
void focus_menus(LabState& lab) {
    if (!std::exchange(lab.focus_menu, false)) return;
    ImGuiWindow* bar = ImGui::GetCurrentWindow();
    ImGui::FocusWindow(bar);
    ImGui::GetCurrentContext()->NavLayer = ImGuiNavLayer_Menu;
    ImGui::NavInitWindow(bar, true);
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
}

// On the right: what is being made, or the file.
void note(LabState& lab) {
    std::string text;
    if (lab.animation.progress)
        text = fmt::format("{} {:.0f} %, Escape stops", lab.animation.writing ? "Writing" : "Recording",
                           100 * *lab.animation.progress);
    else if (!lab.file.empty())
        text = std::filesystem::path(lab.file).filename().string();
    const float x = ImGui::GetWindowWidth() - ImGui::CalcTextSize(text.c_str()).x - lab.px(12);
    if (text.empty() || x < ImGui::GetCursorPosX()) return;
    ImGui::SetCursorPosX(x);
    ImGui::TextDisabled("%s", text.c_str());
    if (!lab.animation.progress) tooltip(lab.file, lab.scale);
}

}  // namespace

void draw_menu_bar(LabState& lab) {
    if (!ImGui::BeginMainMenuBar()) return;
    focus_menus(lab);
    menu(lab, "File", file_menu);
    menu(lab, "Edit", edit_menu);
    menu(lab, "Lesson", lesson_menu);
    menu(lab, "Lecture", lecture_menu);
    menu(lab, "Run", run_menu);
    menu(lab, "View", view_menu);
    menu(lab, "Help", help_menu);
    note(lab);
    ImGui::EndMainMenuBar();
}

}  // namespace pliant::viewer
