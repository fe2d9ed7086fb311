// The picture: drawn into a texture, with labels, notes and read-out over it; turned, moved and pulled with the
// mouse.
#include <pliant/lesson/format.h>

#include "panels/colour_bar.h"
#include "panels/lab_state.h"
#include "render/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

struct View {
    Scene scene;
    Projection projection;
    ImVec2 origin, size;
    int dimension;
};

void draw_labels(LabState& lab, const View& view) {
    if (!view.scene.show_labels) return;
    for (const LabelMark& l : view.scene.labels) {
        const Eigen::Vector3f p = view.projection.pixel(l.at);
        if (p.z() >= 1) continue;
        ImGui::PushFont(l.large ? lab.fonts.large : lab.fonts.normal);
        const ImVec2 size = ImGui::CalcTextSize(l.text.c_str());
        Eigen::Vector2f beyond(0, 0);
        if (l.away_from) {
            const Eigen::Vector2f d = (p - view.projection.pixel(*l.away_from)).head<2>().normalized();
            beyond = d * (lab.px(6) + std::abs(d.x()) * size.x / 2 + std::abs(d.y()) * size.y / 2);
        }
        const float x =
            std::clamp(p.x() + beyond.x() + lab.px(l.offset_x) - size.x / 2, 4.f, std::max(4.f, view.size.x - size.x - 4));
        const float y =
            std::clamp(p.y() + beyond.y() + lab.px(l.offset_y) - size.y / 2, 2.f, std::max(2.f, view.size.y - size.y - 2));
        haloed_text(lab, {view.origin.x + x, view.origin.y + y}, lab.ink(l.ink), l.text);
        ImGui::PopFont();
    }
}

void draw_notes(LabState& lab, const View& view) {
    float y = view.origin.y + lab.px(8);
    for (const std::string& note : view.scene.notes) {
        haloed_text(lab, {view.origin.x + lab.px(10), y}, lab.ink(Ink::text), note);
        y += ImGui::GetTextLineHeightWithSpacing();
    }
}

// The thing under the pointer, with all that is known of it.
void read_out(LabState& lab, const Picked& picked) {
    std::string text = fmt::format("{} {}\n", name_of(picked.on), picked.index);
    for (const Field& f : lab.session.lesson().fields) {
        if (!f.in_use() || f.on != picked.on || picked.index >= f.size()) continue;
        text += fmt::format("{}{}{} = {}\n", words(f.name), f.symbol.empty() ? "" : " ", f.symbol,
                            format_quantity(row_value(f, picked.index, -1), f.unit));
        if (f.rank == Rank::scalar) continue;
        const auto names = component_names(f);
        text += "   ";
        for (int c = 0; c < f.components; ++c) {
            text +=
                fmt::format("{} {}  ", names[static_cast<std::size_t>(c)], format_quantity(row_value(f, picked.index, c), "", 3));
            if (f.rank == Rank::tensor && f.components == 9 && c % 3 == 2 && c < 8) text += "\n   ";
        }
        text += "\n";
    }
    text.pop_back();
    ImGui::PushFont(lab.fonts.small);
    ImGui::SetTooltip("%s", text.c_str());
    ImGui::PopFont();
}

// A ring around the thing that is inspected, or where the run broke down.
void mark_thing(LabState& lab, const View& view) {
    const auto& autopsy = lab.session.autopsy();
    const auto& thing = autopsy && autopsy->thing ? autopsy->thing : lab.session.inspector.thing;
    if (!thing || (thing == lab.session.inspector.thing && !lab.show_inspector)) return;
    if (const auto at = place_of(view.scene, thing->on, thing->index)) {
        const Eigen::Vector3f p = view.projection.pixel(*at);
        ImGui::GetWindowDrawList()->AddCircle({view.origin.x + p.x(), view.origin.y + p.y()}, lab.px(11), lab.ink(Ink::accent), 0,
                                              std::max(2.f, lab.px(3)));
    }
}

void mark_hovered(LabState& lab, const View& view, const Picked& picked) {
    const Eigen::Vector3f p = view.projection.pixel(position<3>(picked.at));
    ImGui::GetWindowDrawList()->AddCircle({view.origin.x + p.x(), view.origin.y + p.y()}, lab.px(9), lab.ink(Ink::accent), 0,
                                          std::max(2.f, lab.px(2)));
}

Eigen::Vector2f pointer_in(const View& view) {
    const ImVec2 m = ImGui::GetIO().MousePos;
    return {m.x - view.origin.x, m.y - view.origin.y};
}

void begin_drag(LabState& lab, const View& view) {
    const auto can_pull = lab.session.lesson().can_pull();
    lab.turning = true;
    lab.clicked_only = true;
    if (!can_pull || !lab.hovered || lab.hovered->on != *can_pull) return;
    lab.turning = false;
    lab.pulling = Pull{lab.hovered->index, lab.hovered->at, lab.hovered->at};
    (void)view;
}

void go_on_dragging(LabState& lab, const View& view) {
    Session& s = lab.session;
    if (lab.clicked_only && !ImGui::IsMouseDragging(ImGuiMouseButton_Left, lab.px(4))) return;
    lab.clicked_only = false;
    if (lab.pulling) {
        lab.pulling->to = view.projection.at_depth_of(pointer_in(view), lab.pulling->from);
        s.pull(lab.pulling);
        return;
    }
    const ImVec2 d = ImGui::GetIO().MouseDelta;
    if (!lab.turning || (d.x == 0 && d.y == 0)) return;
    view.dimension == 3 ? orbit(*s.camera, d.x, d.y) : pan(*s.camera, 2, view.projection, d.x, d.y);
}

// A press that did not move picks what lies there.
void end_drag(LabState& lab) {
    if (lab.clicked_only && lab.hovered && lab.layout == Layout::lab) {
        lab.session.inspector.thing = Thing{lab.hovered->on, lab.hovered->index};
        lab.choose_inspector = true;
    }
    if (lab.pulling && !lab.clicked_only) lab.session.pull(std::nullopt);
    lab.clicked_only = false;
    lab.pulling.reset();
    lab.turning = false;
}

void handle_mouse(LabState& lab, const View& view) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool inside = ImGui::IsItemHovered();
    if (!lab.pulling && !lab.turning)
        lab.hovered = inside ? pick(view.scene, view.projection, pointer_in(view), lab.px(9)) : std::nullopt;
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) begin_drag(lab, view);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) go_on_dragging(lab, view);
    if (ImGui::IsItemActive() && (ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle)))
        pan(*lab.session.camera, view.dimension, view.projection, io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsItemDeactivated()) end_drag(lab);
    if (inside && io.MouseWheel != 0)
        zoom(*lab.session.camera, view.dimension, view.projection, pointer_in(view), std::pow(0.88, io.MouseWheel));
    if (inside && lab.hovered && !lab.turning && !lab.pulling) mark_hovered(lab, view, *lab.hovered), read_out(lab, *lab.hovered);
}

void banner(LabState& lab, const View& view) {
    const auto& message = lab.session.message();
    if (!message || lab.session.autopsy()) return;
    using Kind = Session::Message::Kind;
    const Rgba8 colour = message->kind == Kind::info ? quiet_colour : bad_colour;
    ImGui::SetCursorScreenPos({view.origin.x + lab.px(10), view.origin.y + lab.px(10)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, packed(colour, 0.94f));
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_WHITE);
    const float width = view.size.x - lab.px(20), wrap = width - lab.px(20);
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

void hints(LabState& lab, const View& view) {
    if (!lab.hints_shown || lab.layout != Layout::lab || lab.animation.progress) return;
    const bool can_pull = lab.session.lesson().can_pull().has_value();
    const std::string text = fmt::format(
        "{}\nSpace pauses; . goes one step, / one stage, , back\nMove a slider on the left; F1 shows all keys",
        can_pull ? "Pull it with the mouse; drag beside it to turn" : "Drag to move the picture, turn the wheel to zoom");
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = lab.px(8), button = ImGui::GetFrameHeight();
    const ImVec2 at{view.origin.x + lab.px(10), view.origin.y + view.size.y - size.y - 2 * pad - lab.px(10)};
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x + button + 3 * pad, at.y + size.y + 2 * pad},
                                              ImGui::GetColorU32(ImGuiCol_PopupBg, 0.88f), lab.px(5));
    ImGui::GetWindowDrawList()->AddText({at.x + pad, at.y + pad}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    ImGui::SetCursorScreenPos({at.x + size.x + 2 * pad, at.y + pad});
    if (ImGui::Button("×", {button, button})) lab.hints_shown = false;
    lab.note_control("hide hints");
}

}  // namespace

void draw_scene(LabState& lab, SceneRenderer& renderer) {
    Session& s = lab.session;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImVec2 size = ImGui::GetContentRegionAvail();
    const ColourBarPlace bar = colour_bar_place(lab, size.x);
    size.y -= bar.below;
    if (size.x < 8 || size.y < 8) return;
    const int dimension = s.lesson().dimension();
    Scene scene = s.scene();
    lab.scene_has_grid = !scene.grids.empty();
    if (!s.camera) s.camera = framing(scene, dimension, (size.x - bar.right) / size.y);
    const View view{std::move(scene), Projection(*s.camera, dimension, size.x, size.y, bar.right), origin, size, dimension};

    const Size pixels{static_cast<int>(size.x), static_cast<int>(size.y)};
    const GLuint texture = renderer.render(view.scene, dimension, *s.camera, palette(lab.theme), s.colour_scale(), pixels,
                                           lab.scale, bar.right, s.patterns);
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), origin,
                                         {origin.x + size.x, origin.y + size.y}, {0, 1}, {1, 0});

    ImGui::SetNextItemAllowOverlap();
    ImGui::InvisibleButton(
        "scene", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    lab.note_control("scene");
    handle_mouse(lab, view);
    mark_thing(lab, view);
    draw_labels(lab, view);
    if (!s.message() && !s.autopsy() && lab.layout != Layout::deck) draw_notes(lab, view);
    draw_colour_bar(lab, {origin.x, origin.y, size.x, size.y + bar.below});
    hints(lab, view);
    banner(lab, view);
    draw_autopsy(lab, {origin.x, origin.y, size.x, size.y});
}

}  // namespace pliant::viewer
