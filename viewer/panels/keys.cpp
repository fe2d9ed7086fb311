#include "panels/keys.h"

#include <imgui_internal.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pliant::viewer {
namespace {

// By what a key types, wherever a keyboard has it.
constexpr KeyBinding typed(Action action, char character, bool repeats, std::string_view keys, std::string_view meaning,
                           Where where = Where::everywhere) {
    KeyBinding b{action, ImGuiKey_None, false, repeats, keys, meaning, where};
    b.character = character;
    return b;
}

// A function key in the place of another one, which takes more than one key on some keyboards; with Shift the other way.
constexpr KeyBinding twin(Action action, ImGuiKey key, bool shift, bool repeats, std::string_view keys,
                          std::string_view meaning) {
    return {action, key, false, repeats, keys, meaning, Where::everywhere, shift};
}

// Letters and digits are those of the keyboard's language, or, where it has none, of their place on a US keyboard.
constexpr std::array bindings{
    KeyBinding{Action::play, ImGuiKey_Space, false, false, "Space", "play or pause"},
    typed(Action::step, '.', true, ".", "one step", Where::outside_deck),
    typed(Action::stage_back, ',', true, ",", "one stage back"),
    typed(Action::step_back, '<', true, "<", "one step back; inside a step, to the same stage of the step before"),
    typed(Action::stage, '/', true, "/", "one stage"),
    KeyBinding{Action::stage_back, ImGuiKey_M, false, true, "M", "one stage back"},
    typed(Action::pass, ';', true, ";", "one pass of an inner loop"),
    typed(Action::pass_back, '\'', true, "'", "one pass back"),
    KeyBinding{Action::stops, ImGuiKey_F9, false, false, "F9", "where the run stops by itself"},
    KeyBinding{Action::compare, ImGuiKey_V, false, false, "V", "stage: now, before, difference, side by side, swipe"},
    KeyBinding{Action::inspect, ImGuiKey_I, false, false, "I", "inspect a node, cell, ...: its numbers and why"},
    KeyBinding{Action::claims, ImGuiKey_K, false, false, "K", "what the lectures claim: predict, then measure"},
    KeyBinding{Action::atlas, ImGuiKey_W, false, false, "W", "where it is stable: a map of two parameters"},
    KeyBinding{Action::methods, ImGuiKey_Y, false, false, "Y", "compare all methods in this scene"},
    KeyBinding{Action::why_back, ImGuiKey_Backspace, false, false, "Backspace", "back to the question before",
               Where::outside_deck},
    KeyBinding{Action::reset, ImGuiKey_R, false, false, "R", "reset"},
    typed(Action::previous_lesson, '[', false, "[", "lesson before"),
    typed(Action::next_lesson, ']', false, "]", "next lesson"),
    KeyBinding{Action::find, ImGuiKey_F, false, false, "F", "find a lesson"},
    KeyBinding{Action::walkthrough_next, ImGuiKey_N, false, false, "N", "walkthrough: next"},
    KeyBinding{Action::walkthrough_back, ImGuiKey_B, false, false, "B", "walkthrough: back", Where::outside_deck},
    KeyBinding{Action::unlock, ImGuiKey_L, false, false, "L", "walkthrough: unlock or lock the parameters",
               Where::in_walkthrough},
    KeyBinding{Action::deck, ImGuiKey_D, false, false, "D", "walkthrough as a deck for a lecture"},
    KeyBinding{Action::walkthrough_next, ImGuiKey_RightArrow, false, false, "→", "deck: next", Where::in_deck},
    KeyBinding{Action::walkthrough_next, ImGuiKey_PageDown, false, false, "Page Down", "deck: next", Where::in_deck},
    KeyBinding{Action::walkthrough_back, ImGuiKey_LeftArrow, false, false, "←", "deck: back", Where::in_deck},
    KeyBinding{Action::walkthrough_back, ImGuiKey_PageUp, false, false, "Page Up", "deck: back", Where::in_deck},
    KeyBinding{Action::reset_slide, ImGuiKey_Backspace, false, false, "Backspace", "deck: start of this slide", Where::in_deck},
    KeyBinding{Action::first_slide, ImGuiKey_Home, false, false, "Home", "deck: first slide", Where::in_deck},
    KeyBinding{Action::last_slide, ImGuiKey_End, false, false, "End", "deck: last slide", Where::in_deck},
    KeyBinding{Action::notes, ImGuiKey_O, false, false, "O", "deck: the lecturer's notes", Where::in_deck},
    KeyBinding{Action::dismiss, ImGuiKey_Escape, false, false, "Escape", "close a message, the summary or this table",
               Where::over_a_message},
    KeyBinding{Action::fill_back, ImGuiKey_Escape, false, false, "Escape", "back from what fills the screen", Where::filled},
    KeyBinding{Action::black_out, ImGuiKey_B, false, false, "B", "deck: black screen, until the next key or click",
               Where::in_deck},
    typed(Action::black_out, '.', false, ".", "deck: black screen, until the next key or click", Where::in_deck),
    KeyBinding{Action::presenter, ImGuiKey_F12, false, false, "F12", "deck: a window for the lecturer, with notes and clock"},
    KeyBinding{Action::leave_deck, ImGuiKey_Escape, false, false, "Escape", "deck: to the lab, with this run", Where::in_deck},
    KeyBinding{Action::leave_deck, ImGuiKey_Escape, false, false, "Escape", "slide: to the lab", Where::on_slide},
    KeyBinding{Action::pin, ImGuiKey_G, false, false, "G", "pin this run behind the present one, or let it go"},
    KeyBinding{Action::beside, ImGuiKey_2, false, false, "2", "two runs, A and B, side by side"},
    KeyBinding{Action::difference, ImGuiKey_3, false, false, "3", "two runs: their difference, or side by side"},
    KeyBinding{Action::address_a, ImGuiKey_1, true, false, "Ctrl 1", "two runs: the sliders set A"},
    KeyBinding{Action::address_b, ImGuiKey_2, true, false, "Ctrl 2", "two runs: the sliders set B"},
    KeyBinding{Action::cost, ImGuiKey_C, false, false, "C", "cost and error in the place of the plots", Where::outside_deck},
    KeyBinding{Action::hide_panels, ImGuiKey_Tab, false, false, "Tab", "hide or show the panels", Where::outside_deck},
    KeyBinding{Action::next_panel, ImGuiKey_F6, false, false, "F6", "next panel; arrow keys go through its controls"},
    KeyBinding{Action::previous_panel, ImGuiKey_F6, false, false, "Shift F6", "panel before", Where::everywhere, true},
    KeyBinding{Action::hand_in, ImGuiKey_H, false, false, "H", "note numbers, answers and pictures, and hand them in"},
    KeyBinding{Action::summary, ImGuiKey_S, false, false, "S", "how things stand, in sentences; also printed"},
    KeyBinding{Action::patterns, ImGuiKey_P, false, false, "P", "patterns as well as colours show the sign"},
    KeyBinding{Action::arrows, ImGuiKey_A, false, false, "A", "arrows on or off"},
    KeyBinding{Action::fill, ImGuiKey_X, false, false, "X", "what the mouse is over fills the screen, and back"},
    KeyBinding{Action::full_screen, ImGuiKey_F11, false, false, "F11", "the window fills the screen, and back"},
    KeyBinding{Action::lens, ImGuiKey_Z, false, false, "Z", "a large pointer that enlarges, on or off"},
    KeyBinding{Action::frame, ImGuiKey_Home, false, false, "Home", "frame the whole scene", Where::outside_deck},
    KeyBinding{Action::extreme, ImGuiKey_E, false, false, "E", "extreme ranges of the sliders"},
    KeyBinding{Action::theme, ImGuiKey_T, false, false, "T", "dark or projector theme"},
    KeyBinding{Action::larger, ImGuiKey_Equal, true, false, "Ctrl +", "larger type and lines"},
    KeyBinding{Action::smaller, ImGuiKey_Minus, true, false, "Ctrl -", "smaller type and lines"},
    KeyBinding{Action::undo, ImGuiKey_Z, true, true, "Ctrl Z", "undo a change of a parameter"},
    KeyBinding{Action::open, ImGuiKey_O, true, false, "Ctrl O", "open a scene file"},
    KeyBinding{Action::save, ImGuiKey_S, true, false, "Ctrl S", "save the scene in its file"},
    KeyBinding{Action::save_as, ImGuiKey_S, true, false, "Ctrl Shift S", "save the scene under another name", Where::everywhere,
               true},
    KeyBinding{Action::copy_share, ImGuiKey_C, true, false, "Ctrl Shift C", "copy the scene as one line of text",
               Where::everywhere, true},
    KeyBinding{Action::paste_share, ImGuiKey_V, true, false, "Ctrl Shift V", "open the scene of a copied line", Where::everywhere,
               true},
    KeyBinding{Action::save_scene_picture, ImGuiKey_None, false, false, "", "save the picture of the scene as PNG"},
    KeyBinding{Action::save_window_picture, ImGuiKey_None, false, false, "", "save the picture of the whole window as PNG"},
    KeyBinding{Action::save_plots, ImGuiKey_None, false, false, "", "save each plot in sight as SVG, where Pliant was started"},
    KeyBinding{Action::save_probes, ImGuiKey_None, false, false, "", "save what was measured, step by step, as CSV with units"},
    KeyBinding{Action::save_animation, ImGuiKey_None, false, false, "", "play on and save the picture of the scene as a GIF"},
    KeyBinding{Action::add_scene, ImGuiKey_L, true, false, "Ctrl L", "add this scene to the lecture"},
    KeyBinding{Action::add_slide, ImGuiKey_None, false, false, "", "add this slide of the walkthrough to the lecture"},
    KeyBinding{Action::add_claim, ImGuiKey_None, false, false, "", "add the claim that is unfolded to the lecture"},
    KeyBinding{Action::add_map, ImGuiKey_None, false, false, "", "add the stability map to the lecture"},
    KeyBinding{Action::open_lecture, ImGuiKey_None, false, false, "", "open a lecture, and show it from its first slide"},
    KeyBinding{Action::end_lecture, ImGuiKey_None, false, false, "", "leave the lecture; this run stays"},
    KeyBinding{Action::defaults, ImGuiKey_None, false, false, "", "set every parameter to its default value"},
    KeyBinding{Action::quit, ImGuiKey_Q, true, false, "Ctrl Q", "quit; settings, notes and the place in a lecture are kept"},
    twin(Action::step, ImGuiKey_F2, false, true, "F2", "one step"),
    twin(Action::step_back, ImGuiKey_F2, true, true, "Shift F2",
         "one step back; inside a step, to the same stage of the step before"),
    twin(Action::stage, ImGuiKey_F3, false, true, "F3", "one stage"),
    twin(Action::stage_back, ImGuiKey_F3, true, true, "Shift F3", "one stage back"),
    twin(Action::pass, ImGuiKey_F4, false, true, "F4", "one pass of an inner loop"),
    twin(Action::pass_back, ImGuiKey_F4, true, true, "Shift F4", "one pass back"),
    twin(Action::next_lesson, ImGuiKey_F7, false, false, "F7", "next lesson"),
    twin(Action::previous_lesson, ImGuiKey_F7, true, false, "Shift F7", "lesson before"),
    twin(Action::larger, ImGuiKey_F8, false, false, "F8", "larger type and lines"),
    twin(Action::smaller, ImGuiKey_F8, true, false, "Shift F8", "smaller type and lines"),
    KeyBinding{Action::menu, ImGuiKey_F10, false, false, "F10", "the menus; arrow keys go through them"},
    KeyBinding{Action::help, ImGuiKey_F1, false, false, "F1", "this table"},
};

}  // namespace

std::span<const KeyBinding> key_bindings() { return bindings; }

bool KeyContext::suits(Where where) const {
    switch (where) {
        case Where::everywhere:
            return true;
        case Where::outside_deck:
            return !deck;
        case Where::in_deck:
            return deck;
        case Where::on_slide:
            return slide;
        case Where::in_walkthrough:
            return walkthrough;
        case Where::filled:
            return filled;
        case Where::over_a_message:
            return message && !list_is_open();
    }
    return false;
}
const KeyBinding& binding(Action action) { return *std::ranges::find(bindings, action, &KeyBinding::action); }

namespace {
// In a slow frame a key may be up again when the one that it went with is looked at.
bool held(bool down, ImGuiKey left, ImGuiKey right) { return down || ImGui::IsKeyReleased(left) || ImGui::IsKeyReleased(right); }

// + needs Shift on many keyboards, so Shift counts only where it tells two actions apart.
bool shift_tells(const KeyBinding& b) {
    return std::ranges::any_of(bindings, [&](const KeyBinding& o) { return o.shift && o.key == b.key && o.ctrl == b.ctrl; });
}
}  // namespace

namespace {
bool is_modifier(ImGuiKey key) { return key >= ImGuiKey_LeftCtrl && key <= ImGuiKey_RightSuper; }

// Keys are held, all of them for so long that what they type is a repetition.
bool typing_repeats() {
    bool any = false;
    for (int k = ImGuiKey_NamedKey_BEGIN; k < ImGuiKey_GamepadStart; ++k) {
        const auto key = static_cast<ImGuiKey>(k);
        if (is_modifier(key) || !ImGui::IsKeyDown(key)) continue;
        if (ImGui::GetKeyData(key)->DownDuration < ImGui::GetIO().KeyRepeatDelay) return false;
        any = true;
    }
    return any;
}

int times_typed(const KeyBinding& b) {
    if (!b.repeats && typing_repeats()) return 0;
    const auto& characters = ImGui::GetIO().InputQueueCharacters;
    return static_cast<int>(std::count(characters.begin(), characters.end(), static_cast<ImWchar>(b.character)));
}

// Keys that play and turn the slides of a deck, whatever control was clicked before; only a text that is typed has them first.
bool presents(const KeyBinding& b, const KeyContext& context) {
    return context.deck && (b.where == Where::in_deck || b.action == Action::play);
}

bool key_pressed(const KeyBinding& b, const KeyContext& context) {
    const ImGuiIO& io = ImGui::GetIO();
    if (b.key == ImGuiKey_None || io.KeyAlt) return false;
    if (held(io.KeyCtrl, ImGuiKey_LeftCtrl, ImGuiKey_RightCtrl) != b.ctrl) return false;
    if (shift_tells(b) && held(io.KeyShift, ImGuiKey_LeftShift, ImGuiKey_RightShift) != b.shift) return false;
    // Space acts on the control that keys went to, if they went to one.
    if (b.key == ImGuiKey_Space && context.ring_has_space && !context.deck) return false;
    // A control that was taken hold of by keys has the arrows, and Escape lets go of it.
    if (is_alone(b.where) && ImGui::IsAnyItemActive() && !presents(b, context)) return false;
    return ImGui::IsKeyPressed(static_cast<ImGuiKey>(b.key), b.repeats);
}

// A letter, a digit, a sign or a blank.
bool is_typed(const KeyBinding& b) {
    if (b.ctrl) return false;
    return b.character != 0 || b.key == ImGuiKey_Space || (b.key >= ImGuiKey_0 && b.key <= ImGuiKey_Z);
}

// It is for what lies over the lab.
bool belongs_above(const KeyBinding& b, const KeyContext& context) {
    if (!is_typed(b)) return false;
    return (list_is_open() && !presents(b, context)) || (context.window_over && b.action != Action::hand_in);
}
}  // namespace

bool list_is_open() { return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup); }

int presses(const KeyBinding& b, const KeyContext& context) {
    // Where a text is typed, letters are its own; from panel to panel one goes all the same.
    const bool between_panels = b.action == Action::next_panel || b.action == Action::previous_panel;
    if (ImGui::GetIO().WantTextInput && !between_panels) return 0;
    if (belongs_above(b, context)) return 0;
    return b.character ? times_typed(b) : static_cast<int>(key_pressed(b, context));
}

}  // namespace pliant::viewer
