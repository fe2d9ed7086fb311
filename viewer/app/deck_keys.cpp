#include "app/deck_keys.h"

#include "panels/keys.h"

#include <imgui_internal.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr int frames_to_move = 4;

bool any_pressed(std::initializer_list<ImGuiKey> keys) {
    return std::ranges::any_of(keys, [](ImGuiKey k) { return ImGui::IsKeyPressed(k); });
}

// What ImGui has begun to do for a key in this frame.
void take_move_back(bool ring) {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    ImGui::NavMoveRequestCancel();
    g.NavInitRequest = false;
    g.NavDisableHighlight = !ring;
}

void take_press_back() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    g.NavActivateId = g.NavActivateDownId = g.NavActivatePressedId = 0;
}

void put_ring_out() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    ImGui::ClearActiveID();
    if (list_is_open()) ImGui::ClosePopupToLevel(0, true);
    g.NavId = 0;
    g.NavDisableHighlight = true;
    g.IO.NavVisible = false;
}

}  // namespace

void DeckKeys::begin_frame(bool deck, bool card) {
    if (ImGui::GetIO().WantTextInput) return;
    // Space plays, and never presses a button of the card that has just come up; Enter does.
    if (card && ImGui::IsKeyDown(ImGuiKey_Space)) take_press_back();
    if (!deck) {
        follow_ring();
        if (ImGui::IsKeyDown(ImGuiKey_Space) && !went_there_ && !list_is_open()) take_press_back();
        if (ImGui::IsAnyItemActive()) return;
        if (any_pressed({ImGuiKey_Tab})) ImGui::NavMoveRequestCancel();
        // Home frames the scene: it lights no ring, which would take Space.
        if (any_pressed({ImGuiKey_Home})) take_move_back(ring_);
        return;
    }
    if (any_pressed({ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_PageUp, ImGuiKey_PageDown, ImGuiKey_Home, ImGuiKey_End}))
        take_move_back(ring_);
    // Up and down choose in a list that is open, and do nothing else.
    if (!list_is_open() && any_pressed({ImGuiKey_UpArrow, ImGuiKey_DownArrow})) take_move_back(ring_);
    if (ImGui::IsKeyDown(ImGuiKey_Space)) take_press_back();
}

// A list leaves it as it was: the mouse may have opened it.
void DeckKeys::follow_ring() {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    going_ = any_pressed({ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow, ImGuiKey_DownArrow, ImGuiKey_F6,
                          ImGuiKey_F10, ImGuiKey_Tab})
                 ? frames_to_move
                 : std::max(0, going_ - 1);
    if (list_is_open()) return void(going_ = 0);
    const bool lit = g.NavId != 0 && !g.NavDisableHighlight, moved = std::exchange(at_, lit ? g.NavId : 0) != (lit ? g.NavId : 0);
    went_there_ = lit && (moved ? going_ > 0 : went_there_ || going_ > 0);
}

void DeckKeys::end_frame(bool deck) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    const bool was_typing = typing_;
    typing_ = g.WantTextInputNextFrame > 0 || g.IO.WantTextInput;
    // Who has typed a number goes on with the deck.
    if (deck && was_typing && !typing_) put_ring_out();
    ring_ = g.NavId != 0 && !g.NavDisableHighlight;
    held_ = typing_ || ring_ || list_is_open();
}

bool DeckKeys::let_go() {
    const bool held = held_;
    put_ring_out();
    held_ = ring_ = false;
    return held;
}

}  // namespace pliant::viewer
