// The picture: drawn into a texture, with labels, notes and read-out over it; turned, moved and pulled with the
// mouse.
#include <pliant/lesson/format.h>

#include "panels/colour_bar.h"
#include "panels/companion_panel.h"
#include "panels/scene_matrices.h"
#include "panels/scene_messages.h"
#include "render/ghost.h"
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
    const Lesson* lesson;  // whose numbers are read out; none in a picture of the past
    std::string heading;   // the name of the run or moment, where there are two
    bool first = true;     // the picture of A or of now, or the only one
    int dimension = 3;
};

// Broken between words where it is wider than `width` px.
std::vector<std::string> lines_of(const std::string& text, float width) {
    std::vector<std::string> lines;
    const char* at = text.c_str();
    const char* const end = at + text.size();
    while (at < end) {
        const char* stop = ImGui::GetFont()->CalcWordWrapPositionA(1, at, end, std::max(width, 1.f));
        lines.emplace_back(at, std::max(stop, at + 1));
        for (at = std::max(stop, at + 1); at < end && *at == ' ';) ++at;
    }
    return lines;
}

void draw_labels(LabState& lab, const View& view) {
    if (!view.scene.show_labels) return;
    for (const LabelMark& l : view.scene.labels) {
        const Eigen::Vector3f p = view.projection.pixel(l.at);
        if (p.z() >= 1) continue;
        ImGui::PushFont(l.large ? lab.fonts.large : lab.fonts.normal);
        const ImVec2 size = ImGui::CalcTextSize(l.text.c_str());
        // One that is wider than the picture stands above its place, in lines.
        const float more_lines = size.x > view.size.x - 8 ? std::floor(size.x / (view.size.x - 8)) * size.y : 0;
        Eigen::Vector2f beyond(0, 0);
        if (l.away_from) {
            const Eigen::Vector2f d = (p - view.projection.pixel(*l.away_from)).head<2>().normalized();
            beyond = d * (lab.px(6) + std::abs(d.x()) * size.x / 2 + std::abs(d.y()) * size.y / 2);
        }
        const float x =
            std::clamp(p.x() + beyond.x() + lab.px(l.offset_x) - size.x / 2, 4.f, std::max(4.f, view.size.x - size.x - 4));
        const float y = std::clamp(p.y() + beyond.y() + lab.px(l.offset_y) - size.y / 2 - more_lines, 2.f,
                                   std::max(2.f, view.size.y - size.y - 2));
        float line_y = y;
        for (const std::string& line : lines_of(l.text, view.size.x - 8)) {
            haloed_text(lab, {view.origin.x + x, view.origin.y + line_y}, lab.ink(l.ink), line);
            line_y += size.y;
        }
        ImGui::PopFont();
    }
}

void draw_notes(LabState& lab, const View& view) {
    float y = view.origin.y + lab.px(8);
    const auto write = [&](ImFont* font, Ink ink, const std::string& text) {
        ImGui::PushFont(font);
        for (const std::string& line : lines_of(text, view.size.x - lab.px(20))) {
            haloed_text(lab, {view.origin.x + lab.px(10), y}, lab.ink(ink), line);
            y += ImGui::GetTextLineHeightWithSpacing();
        }
        ImGui::PopFont();
    };
    if (!view.heading.empty()) write(lab.fonts.medium, Ink::accent, view.heading);
    for (const std::string& note : view.scene.notes) write(lab.fonts.normal, Ink::text, note);
}

// The thing under the pointer, with all that is known of it.
void read_out(LabState& lab, const Lesson& lesson, const Picked& picked) {
    if (picked.on == On::handle) return ImGui::SetTooltip("Drag me");
    std::string text = fmt::format("{} {}\n", name_of(picked.on), picked.index);
    for (const Field& f : lesson.fields) {
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

// A lesson that looks at one cell, with a handle on it, looks at the one that is clicked.
void look_at_cell(LabState& lab) {
    const Lesson& lesson = lab.session.lesson();
    if (lab.hovered->on != On::cell || lesson.can_pull() != On::handle) return;
    const Pull there{0, lab.hovered->at, lab.hovered->at};
    const auto chosen = lesson.dragged(there);
    const auto of_cell = [](const auto& assignment) { return assignment.first == "cell_x" || assignment.first == "cell_y"; };
    if (chosen.empty() || !std::ranges::all_of(chosen, of_cell)) return;
    lab.session.pull(there);
    lab.session.pull(std::nullopt);
}

// A press that did not move picks what lies there.
void end_drag(LabState& lab) {
    if (lab.clicked_only && lab.hovered && lab.hovered->on != On::handle && lab.layout == Layout::lab) {
        lab.session.inspector.thing = Thing{lab.hovered->on, lab.hovered->index};
        lab.choose_inspector = true;
        look_at_cell(lab);
    }
    if (lab.pulling && !lab.clicked_only) lab.session.pull(std::nullopt);
    lab.clicked_only = false;
    lab.pulling.reset();
    lab.turning = false;
}

void handle_mouse(LabState& lab, const View& view) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool inside = ImGui::IsItemHovered();
    if (!lab.pulling && !lab.turning && (inside || view.first))
        lab.hovered = inside && view.lesson ? pick(view.scene, view.projection, pointer_in(view), lab.px(9)) : std::nullopt;
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) begin_drag(lab, view);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) go_on_dragging(lab, view);
    if (ImGui::IsItemActive() && (ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle)))
        pan(*lab.session.camera, view.dimension, view.projection, io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsItemDeactivated()) end_drag(lab);
    if (inside && io.MouseWheel != 0)
        zoom(*lab.session.camera, view.dimension, view.projection, pointer_in(view), std::pow(0.88, io.MouseWheel));
    if (inside && view.lesson && lab.hovered && !lab.turning && !lab.pulling)
        mark_hovered(lab, view, *lab.hovered), read_out(lab, *view.lesson, *lab.hovered);
}

// Where the things to drag are, by name.
void note_handles(LabState& lab, const View& view) {
    constexpr std::size_t most = 16;  // a lattice of nodes needs no names
    const auto pulled = lab.session.lesson().can_pull();
    for (const PointMarks& marks : view.scene.points) {
        if (!marks.pick.pickable || marks.pick.on != pulled || marks.at.size() > most) continue;
        const float reach = lab.px(marks.radius);
        for (std::size_t i = 0; i < marks.at.size(); ++i) {
            const Eigen::Vector3f p = view.projection.pixel(marks.at[i]);
            lab.controls[fmt::format("handle {}", marks.pick.id(i))] = {view.origin.x + p.x() - reach,
                                                                        view.origin.y + p.y() - reach, 2 * reach, 2 * reach};
        }
    }
}

// A picture at a place of the window, under the mouse.
void draw_picture(LabState& lab, SceneRenderer& renderer, const View& view, float right_margin, const char* name) {
    const Size pixels{static_cast<int>(view.size.x), static_cast<int>(view.size.y)};
    const GLuint texture = renderer.render(view.scene, view.dimension, *lab.session.camera, palette(lab.theme),
                                           lab.session.colour_scale(), pixels, lab.scale, right_margin, lab.session.patterns);
    const ImVec2 end{view.origin.x + view.size.x, view.origin.y + view.size.y};
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), view.origin, end,
                                         {0, 1}, {1, 0});
    ImGui::SetCursorScreenPos(view.origin);
    ImGui::SetNextItemAllowOverlap();
    ImGui::InvisibleButton(
        name, view.size,
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    lab.note_control(name);
    handle_mouse(lab, view);
    if (view.first) mark_thing(lab, view), note_handles(lab, view);
    draw_labels(lab, view);
    if (view.lesson) {
        // Above the hints, where they are shown.
        const bool hinted = lab.hints_shown && lab.layout == Layout::lab;
        const float low = hinted ? 3 * ImGui::GetTextLineHeight() + lab.px(32) : 0;
        draw_matrices(lab, view.scene.matrices, {view.origin.x, view.origin.y, view.size.x - right_margin, view.size.y - low});
    }
    if (!lab.session.message() && !lab.session.autopsy() && lab.layout != Layout::deck) draw_notes(lab, view);
}

struct Side {
    Scene scene;
    const Lesson* lesson;
    std::string heading;
    bool first;
};

// Two pictures side by side under one camera; the colour bar of both stands beside them. Gives the place of the second.
Rectangle draw_pair(LabState& lab, SceneRenderer& renderer, Side a, Side b, const Rectangle& place, float right) {
    Session& s = lab.session;
    const float gap = lab.px(2), width = std::floor((place.width - right - gap) / 2);
    if (width < 8) return {};
    if (!s.camera) {
        Scene both;
        both.frame(a.scene.lower, a.scene.upper);
        for (std::size_t k = 0; k < 3; ++k)
            both.lower[k] = std::min(both.lower[k], b.scene.lower[k]), both.upper[k] = std::max(both.upper[k], b.scene.upper[k]);
        s.camera = framing(both, s.lesson().dimension(), width / place.height);
    }
    const Projection projection(*s.camera, s.lesson().dimension(), width, place.height);
    const ImVec2 size{width, place.height};
    const auto view = [&](Side& side, float x) {
        return View{std::move(side.scene), projection,   {x, place.y}, size,
                    side.lesson,           side.heading, side.first,   s.lesson().dimension()};
    };
    if (!lab.renderer_beside) lab.renderer_beside = std::make_unique<SceneRenderer>();
    const float second = place.x + width + gap;
    draw_picture(lab, renderer, view(a, place.x), 0, a.first ? "scene" : "scene B");
    draw_picture(lab, *lab.renderer_beside, view(b, second), 0, b.first ? "scene" : "scene B");
    ImGui::GetWindowDrawList()->AddRectFilled({second - gap, place.y}, {second, place.y + place.height}, lab.ink(Ink::rest));
    return {second, place.y, width, place.height};
}

// A on the left and B on the right.
void draw_two(LabState& lab, SceneRenderer& renderer, Scene of_a, const Rectangle& place, float right) {
    Session& s = lab.session;
    Side a{std::move(of_a), &s.lesson(), run_name(s, false), true},
        b{s.scene_beside(), &s.companion()->lesson(), run_name(s, true), false};
    tell_stopped(lab, draw_pair(lab, renderer, std::move(a), std::move(b), place, right));
}

std::string heading_of(const Session& s, std::string_view moment) {
    const Stage* stage = s.inspector.shown_stage(s.runner());
    return fmt::format("{} {}", moment, stage ? words(stage->name) : "");
}

// What a stage found on the left, and what it left on the right.
void draw_before_and_after(LabState& lab, SceneRenderer& renderer, Scene before, Scene after, const Rectangle& place,
                           float right) {
    Session& s = lab.session;
    Side left{std::move(before), nullptr, heading_of(s, "before"), false},
        now{std::move(after), &s.lesson(), heading_of(s, "after"), true};
    draw_pair(lab, renderer, std::move(left), std::move(now), place, right);
}

void draw_alone(LabState& lab, SceneRenderer& renderer, Scene scene, const Rectangle& place, float right) {
    Session& s = lab.session;
    const int dimension = s.lesson().dimension();
    if (!s.camera) s.camera = framing(scene, dimension, (place.width - right) / place.height);
    const std::string of_a = differing_text(s, false);
    const std::string heading = !s.shows_difference() ? ""
                                : of_a.empty()        ? "A − B, of the same parameters"
                                                      : fmt::format("A − B:  {}  −  {}", of_a, differing_text(s, true));
    const View view{std::move(scene),
                    Projection(*s.camera, dimension, place.width, place.height, right),
                    {place.x, place.y},
                    {place.width, place.height},
                    &s.lesson(),
                    heading,
                    true,
                    dimension};
    draw_picture(lab, renderer, view, right, "scene");
}

// What a stage found, drawn over what it left up to a line that can be moved.
void draw_swipe(LabState& lab, SceneRenderer& renderer, Scene before, Scene after, const Rectangle& place, float right) {
    Session& s = lab.session;
    float& swipe = s.inspector.swipe;
    draw_alone(lab, renderer, std::move(after), place, right);
    if (!lab.renderer_beside) lab.renderer_beside = std::make_unique<SceneRenderer>();
    const Size pixels{static_cast<int>(place.width), static_cast<int>(place.height)};
    const GLuint texture = lab.renderer_beside->render(before, s.lesson().dimension(), *s.camera, palette(lab.theme),
                                                       s.colour_scale(), pixels, lab.scale, right, s.patterns);
    const float x = place.x + swipe * place.width, line = std::max(2.f, lab.px(2)), grip = lab.px(14);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), {place.x, place.y},
                   {x, place.y + place.height}, {0, 1}, {swipe, 0});
    draw->AddLine({x, place.y}, {x, place.y + place.height}, lab.ink(Ink::accent), line);
    const float y = place.y + place.height - lab.px(26);
    const std::string found = heading_of(s, "before"), left = heading_of(s, "after");
    haloed_text(lab, {x - lab.px(10) - ImGui::CalcTextSize(found.c_str()).x, y}, lab.ink(Ink::accent), found);
    haloed_text(lab, {x + lab.px(10), y}, lab.ink(Ink::accent), left);
    ImGui::SetCursorScreenPos({x - grip / 2, place.y});
    ImGui::InvisibleButton("swipe", {grip, place.height});
    lab.note_control("swipe");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive()) swipe = std::clamp((ImGui::GetIO().MousePos.x - place.x) / place.width, 0.02f, 0.98f);
    tooltip("Drag: before on the left, after on the right", lab.scale);
}

}  // namespace

void draw_scene(LabState& lab, SceneRenderer& renderer) {
    Session& s = lab.session;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ColourBarPlace bar = colour_bar_place(lab, room.x);
    const Rectangle place{origin.x, origin.y, room.x, room.y - bar.below};
    if (place.width < 8 || place.height < 8) return;
    Scene scene = s.scene();
    lab.scene_has_grid = !scene.grids.empty();
    if (s.pinned()) lay_under(scene, s.pinned()->ghost);
    const bool two = s.companion() && !s.shows_difference();
    std::optional<Scene> before = two || s.inspector.compare == Compare::before ? std::nullopt : s.other_scene();
    if (two)
        draw_two(lab, renderer, std::move(scene), place, bar.right);
    else if (before && s.inspector.compare == Compare::side_by_side)
        draw_before_and_after(lab, renderer, *std::move(before), std::move(scene), place, bar.right);
    else if (before)
        draw_swipe(lab, renderer, *std::move(before), std::move(scene), place, bar.right);
    else
        draw_alone(lab, renderer, std::move(scene), place, bar.right);
    draw_colour_bar(lab, {place.x, place.y, place.width, place.height + bar.below});
    name_pinned(lab, place);
    draw_hints(lab, place);
    draw_banner(lab, place);
    draw_autopsy(lab, place);
}

}  // namespace pliant::viewer
