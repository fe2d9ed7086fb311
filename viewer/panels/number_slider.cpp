#include "panels/number_slider.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr Real fine_part = 0.1;  // of the way of the hand, with Shift

// Where on the screen the middle of the grip goes, px.
struct Track {
    ImRect frame;
    float grip, from, length;
    explicit Track(const ImRect& r) : frame(r), grip(std::min(ImGui::GetStyle().GrabMinSize, r.GetWidth() / 2)) {
        const float margin = 2 + grip / 2;
        from = r.Min.x + margin, length = std::max(r.GetWidth() - 2 * margin, 1.f);
    }
    Real pixel() const { return 1 / Real(length); }
    Real place_of(float x) const { return (Real(x) - Real(from)) / Real(length); }
    ImRect grip_at(Real place) const {
        const float x = from + length * static_cast<float>(place);
        return {{x - grip / 2, frame.Min.y + 2}, {x + grip / 2, frame.Max.y - 2}};
    }
};

void take_hold(ImGuiID id, ImGuiWindow* window) {
    ImGui::SetKeyOwner(ImGuiKey_MouseLeft, id);
    ImGui::SetActiveID(id, window);
    ImGui::SetFocusID(id, window);
    ImGui::FocusWindow(window);
}

// A press beside the grip brings it there; one on it takes it along from where it is.
void begin_drag(SliderDrag& drag, ImGuiID id, const Track& track, const SliderScale& scale, Real value) {
    const float x = ImGui::GetIO().MousePos.x;
    const Real place = scale.place(value);
    const ImRect grip = track.grip_at(place);
    const bool on_grip = x >= grip.Min.x - 1 && x <= grip.Max.x + 1;
    drag = {.slider = id, .began_with = value, .place = on_grip ? place : track.place_of(x), .moves = !on_grip};
}

std::optional<Real> dragged(SliderDrag& drag, const Track& track, const SliderScale& scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool fine = io.KeyShift;
    if (!ImGui::GetCurrentContext()->ActiveIdIsJustActivated && io.MouseDelta.x != 0) {
        drag.moves = true;
        // A hand that moves plainly is where the pointer is, save for how it took the grip; finely it goes a part of the way.
        drag.place += Real(io.MouseDelta.x) * track.pixel() * (fine ? fine_part : 1);
    }
    if (!drag.moves) return std::nullopt;
    return scale.snapped(std::clamp(drag.place, Real{0}, Real{1}), track.pixel() * (fine ? fine_part : 1));
}

// How many steps the arrows ask for in this frame; they go through the controls no longer.
int arrow_steps(SliderDrag& drag) {
    int steps = 0;
    for (const auto& [key, direction] : {std::pair{ImGuiKey_LeftArrow, -1}, {ImGuiKey_RightArrow, 1}}) {
        if (!ImGui::IsKeyPressed(key)) continue;
        ImGui::NavMoveRequestCancel();
        if (ImGui::IsKeyPressed(key, false)) drag.joins = false;
        steps += direction;
    }
    return steps;
}

int wheel_steps(ImGuiID id, bool hovered, bool has_keys, SliderDrag& drag) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!hovered || !(io.KeyAlt || has_keys)) return 0;
    ImGui::SetKeyOwner(ImGuiKey_MouseWheelY, id);
    if (io.KeyAlt) ImGui::SetKeyOwner(ImGuiMod_Alt, id);  // to let go of it opens no menu
    if (io.MouseWheel == 0) return 0;
    if (std::exchange(drag.slider, id) != id) drag.joins = false;
    return io.MouseWheel > 0 ? 1 : -1;
}

}  // namespace

std::optional<Real> number_slider(const char* label, const Parameter& parameter, bool extreme, Real value, SliderDrag& drag,
                                  bool with_arrows) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return std::nullopt;
    ImGuiContext& g = *ImGui::GetCurrentContext();
    const ImGuiID id = window->GetID(label);
    const ImVec2 at = window->DC.CursorPos;
    const ImRect frame(at, {at.x + ImGui::CalcItemWidth(), at.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(frame, g.Style.FramePadding.y);
    if (!ImGui::ItemAdd(frame, id, &frame)) return std::nullopt;

    const Track track(frame);
    const bool hovered = ImGui::ItemHoverable(frame, id, g.LastItemData.InFlags);
    const bool disabled = (g.LastItemData.InFlags & ImGuiItemFlags_Disabled) != 0;
    std::optional<Real> set;
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left, id)) {
        take_hold(id, window);
        begin_drag(drag, id, track, SliderScale(parameter, extreme, value), value);
    }
    const bool active = g.ActiveId == id;
    const SliderScale scale(parameter, extreme, active && drag.slider == id ? drag.began_with : value);
    if (active && !g.IO.MouseDown[ImGuiMouseButton_Left]) {
        ImGui::ClearActiveID();
    } else if (active) {
        set = dragged(drag, track, scale);
    } else if (!disabled) {
        const bool has_keys = g.NavId == id && g.NavWindow && g.NavWindow->RootWindowForNav == window->RootWindowForNav;
        const int steps =
            (with_arrows && has_keys && !g.IO.WantTextInput && !g.IO.KeyCtrl && !g.IO.KeyAlt ? arrow_steps(drag) : 0) +
            wheel_steps(id, hovered, has_keys && !g.NavDisableHighlight, drag);
        if (steps != 0) set = scale.stepped(value, steps, g.IO.KeyShift);
    }
    if (set == value) set.reset();
    if (set) ImGui::MarkItemEdited(id);

    ImGui::RenderNavHighlight(frame, id);
    ImGui::RenderFrame(frame.Min, frame.Max,
                       ImGui::GetColorU32(active    ? ImGuiCol_FrameBgActive
                                          : hovered ? ImGuiCol_FrameBgHovered
                                                    : ImGuiCol_FrameBg),
                       true, g.Style.FrameRounding);
    const ImRect grip = track.grip_at(scale.place(set.value_or(value)));
    window->DrawList->AddRectFilled(
        grip.Min, grip.Max, ImGui::GetColorU32(active ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab), g.Style.GrabRounding);
    return set;
}

}  // namespace pliant::viewer
