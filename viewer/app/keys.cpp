#include "app/keys.h"

#include <imgui.h>

#include <array>

namespace pliant::viewer {
namespace {

constexpr std::array bindings{
    KeyBinding{Action::play, ImGuiKey_Space, false, false, "Space", "play or pause"},
    KeyBinding{Action::step, ImGuiKey_Period, false, true, ".", "one step"},
    KeyBinding{Action::step_back, ImGuiKey_Comma, false, true, ",", "one step back"},
    KeyBinding{Action::stage, ImGuiKey_Slash, false, true, "/", "one stage"},
    KeyBinding{Action::stage_back, ImGuiKey_M, false, true, "M", "one stage back"},
    KeyBinding{Action::pass, ImGuiKey_Semicolon, false, true, ";", "one pass of an inner loop"},
    KeyBinding{Action::reset, ImGuiKey_R, false, false, "R", "reset"},
    KeyBinding{Action::previous_lesson, ImGuiKey_LeftBracket, false, false, "[", "lesson before"},
    KeyBinding{Action::next_lesson, ImGuiKey_RightBracket, false, false, "]", "next lesson"},
    KeyBinding{Action::find, ImGuiKey_F, false, false, "F", "find a lesson"},
    KeyBinding{Action::walkthrough_next, ImGuiKey_N, false, false, "N", "walkthrough: next"},
    KeyBinding{Action::walkthrough_back, ImGuiKey_B, false, false, "B", "walkthrough: back"},
    KeyBinding{Action::hide_panels, ImGuiKey_Tab, false, false, "Tab", "hide or show the panels"},
    KeyBinding{Action::arrows, ImGuiKey_A, false, false, "A", "arrows on or off"},
    KeyBinding{Action::frame, ImGuiKey_Home, false, false, "Home", "frame the whole scene"},
    KeyBinding{Action::extreme, ImGuiKey_E, false, false, "E", "extreme ranges of the sliders"},
    KeyBinding{Action::theme, ImGuiKey_T, false, false, "T", "dark or projector theme"},
    KeyBinding{Action::larger, ImGuiKey_Equal, true, false, "Ctrl +", "larger type and lines"},
    KeyBinding{Action::smaller, ImGuiKey_Minus, true, false, "Ctrl -", "smaller type and lines"},
    KeyBinding{Action::undo, ImGuiKey_Z, true, true, "Ctrl Z", "undo a change of a parameter"},
    KeyBinding{Action::save, ImGuiKey_S, true, false, "Ctrl S", "save the scene as a file"},
    KeyBinding{Action::help, ImGuiKey_F1, false, false, "F1", "this table"},
};

}  // namespace

std::span<const KeyBinding> key_bindings() { return bindings; }

bool pressed(const KeyBinding& b) {
    const ImGuiIO& io = ImGui::GetIO();
    // In a slow frame Ctrl may be up again when the key that it went with is looked at.
    const bool ctrl = io.KeyCtrl || ImGui::IsKeyReleased(ImGuiKey_LeftCtrl) || ImGui::IsKeyReleased(ImGuiKey_RightCtrl);
    if (io.WantTextInput || ctrl != b.ctrl) return false;
    // Space acts on the control that has the visible focus, if one has.
    if (b.key == ImGuiKey_Space && io.NavVisible) return false;
    return ImGui::IsKeyPressed(static_cast<ImGuiKey>(b.key), b.repeats);
}

}  // namespace pliant::viewer
