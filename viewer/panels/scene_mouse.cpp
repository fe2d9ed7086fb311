// The picture under the mouse: turned, moved and pulled.
#include "panels/scene_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

Eigen::Vector2f pointer_in(const View& view) {
    const ImVec2 m = ImGui::GetIO().MousePos;
    return {m.x - view.origin.x, m.y - view.origin.y};
}

void begin_drag(PanelContext& lab, ScenePanelState& panel) {
    const auto can_pull = lab.session.lesson().can_pull();
    panel.turning = true;
    panel.clicked_only = true;
    if (!can_pull || !panel.hovered || panel.hovered->on != *can_pull) return;
    panel.turning = false;
    panel.pulling = Pull{panel.hovered->index, panel.hovered->at, panel.hovered->at};
}

void go_on_dragging(PanelContext& lab, ScenePanelState& panel, const View& view) {
    Session& s = lab.session;
    if (panel.clicked_only && !ImGui::IsMouseDragging(ImGuiMouseButton_Left, lab.px(4))) return;
    panel.clicked_only = false;
    if (panel.pulling) {
        panel.pulling->to = view.projection.at_depth_of(pointer_in(view), panel.pulling->from);
        s.pull(panel.pulling);
        return;
    }
    const ImVec2 d = ImGui::GetIO().MouseDelta;
    if (!panel.turning || (d.x == 0 && d.y == 0)) return;
    if (view.dimension == 2)
        pan(s.own_camera(), 2, view.projection, d.x, d.y);
    else
        s.camera ? orbit(s.own_camera(), d.x, d.y) : s.viewpoint.turn(d.x, d.y);
}

// A lesson that looks at one cell, with a handle on it, looks at the one that is clicked.
void look_at_cell(PanelContext& lab, ScenePanelState& panel) {
    const Lesson& lesson = lab.session.lesson();
    if (panel.hovered->on != On::cell || lesson.can_pull() != On::handle) return;
    const Pull there{0, panel.hovered->at, panel.hovered->at};
    const auto chosen = lesson.dragged(there);
    const auto only_looks = [&](const auto& assignment) { return lesson.parameter(assignment.first).looks(); };
    if (chosen.empty() || !std::ranges::all_of(chosen, only_looks)) return;
    lab.session.pull(there);
    lab.session.pull(std::nullopt);
}

// A press that did not move picks what lies there.
void end_drag(PanelContext& lab, ScenePanelState& panel) {
    if (panel.clicked_only && panel.hovered && panel.hovered->on != On::handle && lab.layout == Layout::lab) {
        lab.session.inspector.thing = Thing{panel.hovered->on, panel.hovered->index};
        lab.side_wanted = SideTab::inspect;
        look_at_cell(lab, panel);
    }
    if (panel.pulling && !panel.clicked_only) lab.session.pull(std::nullopt);
    panel.clicked_only = false;
    panel.pulling.reset();
    panel.turning = false;
}

}  // namespace

void handle_mouse(PanelContext& lab, ScenePanelState& panel, const View& view) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool inside = ImGui::IsItemHovered();
    if (!panel.pulling && !panel.turning && (inside || view.first))
        panel.hovered =
            inside && view.lesson ? pick(view.picture->scene, view.projection, pointer_in(view), lab.px(9)) : std::nullopt;
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) begin_drag(lab, panel);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) go_on_dragging(lab, panel, view);
    const bool drags = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle);
    if (ImGui::IsItemActive() && drags && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
        pan(lab.session.own_camera(), view.dimension, view.projection, io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsItemDeactivated()) end_drag(lab, panel);
    if (inside && io.MouseWheel != 0)
        zoom(lab.session.own_camera(), view.dimension, view.projection, pointer_in(view), std::pow(0.88, io.MouseWheel));
    // Numbers of whatever the pointer rests on would cover a slide.
    const bool tells = lab.layout != Layout::deck;
    if (tells && inside && view.lesson && panel.hovered && !panel.turning && !panel.pulling) read_out(lab, view, *panel.hovered);
}

void note_handles(PanelContext& lab, const View& view) {
    constexpr std::size_t most = 16;  // a lattice of nodes needs no names
    const auto pulled = lab.session.lesson().can_pull();
    for (const PointMarks& marks : view.picture->scene.points) {
        if (!marks.pick.pickable || marks.pick.on != pulled || marks.at.size() > most) continue;
        const float reach = lab.px(marks.radius);
        for (std::size_t i = 0; i < marks.at.size(); ++i) {
            const Eigen::Vector3f p = view.projection.pixel(marks.at[i]);
            lab.controls[fmt::format("handle {}", marks.pick.id(i))] = {view.origin.x + p.x() - reach,
                                                                        view.origin.y + p.y() - reach, 2 * reach, 2 * reach};
        }
    }
}

}  // namespace pliant::viewer
