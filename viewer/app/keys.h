// The keys of the lab, in one table that feeds both the handler and the help.
#pragma once
#include <span>
#include <string_view>

namespace pliant::viewer {

enum class Action {
    play,
    step,
    step_back,
    stage,
    stage_back,
    pass,
    reset,
    previous_lesson,
    next_lesson,
    find,
    hide_panels,
    help,
    undo,
    extreme,
    arrows,
    theme,
    larger,
    smaller,
    walkthrough_next,
    walkthrough_back,
    save,
    frame,
    open,
    save_as,
    copy_share,
    paste_share,
    save_scene_picture,
    save_window_picture,
    save_plots,
    save_probes,
    save_animation,
    defaults,
    menu
};

struct KeyBinding {
    Action action;
    int key;  // ImGuiKey
    bool ctrl;
    bool repeats;                    // while the key is held
    std::string_view keys, meaning;  // no keys: in the menus only
    bool shift = false;
};

std::span<const KeyBinding> key_bindings();
const KeyBinding& binding(Action action);

// Calls `perform` for each action whose key was pressed in this frame, unless a text is being typed.
void handle_keys(const auto& perform);
bool pressed(const KeyBinding& binding);

void handle_keys(const auto& perform) {
    for (const KeyBinding& b : key_bindings())
        if (pressed(b)) perform(b.action);
}

}  // namespace pliant::viewer
