// The picture: drawn into a texture, with labels, notes and read-out over it; turned, moved and pulled with the
// mouse.
#include <pliant/lesson/format.h>

#include "panels/colour_bar.h"
#include "panels/companion_panel.h"
#include "panels/scene_messages.h"
#include "render/ghost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

struct View {
    Scene scene;
    Projection projection;
    ImVec2 origin, size;
    const Lesson* lesson;
    std::string heading;  // the name of the run, where there are two
    bool first = true;    // the picture of A, or the only one

    int dimension() const { return lesson->dimension(); }
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
    if (!can_pull || !lab.hovered || lab.hovered->on != *can_pull) return;
    lab.turning = false;
    lab.pulling = Pull{lab.hovered->index, lab.hovered->at, lab.hovered->at};
    (void)view;
}

void go_on_dragging(LabState& lab, const View& view) {
    Session& s = lab.session;
    if (lab.pulling) {
        lab.pulling->to = view.projection.at_depth_of(pointer_in(view), lab.pulling->from);
        s.pull(lab.pulling);
        return;
    }
    const ImVec2 d = ImGui::GetIO().MouseDelta;
    if (!lab.turning || (d.x == 0 && d.y == 0)) return;
    view.dimension() == 3 ? orbit(*s.camera, d.x, d.y) : pan(*s.camera, 2, view.projection, d.x, d.y);
}

void end_drag(LabState& lab) {
    if (lab.pulling) lab.session.pull(std::nullopt);
    lab.pulling.reset();
    lab.turning = false;
}

void handle_mouse(LabState& lab, const View& view) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool inside = ImGui::IsItemHovered();
    if (!lab.pulling && !lab.turning && (inside || view.first))
        lab.hovered = inside ? pick(view.scene, view.projection, pointer_in(view), lab.px(9)) : std::nullopt;
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) begin_drag(lab, view);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) go_on_dragging(lab, view);
    if (ImGui::IsItemActive() && (ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle)))
        pan(*lab.session.camera, view.dimension(), view.projection, io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsItemDeactivated()) end_drag(lab);
    if (inside && io.MouseWheel != 0)
        zoom(*lab.session.camera, view.dimension(), view.projection, pointer_in(view), std::pow(0.88, io.MouseWheel));
    if (inside && lab.hovered && !lab.turning && !lab.pulling)
        mark_hovered(lab, view, *lab.hovered), read_out(lab, *view.lesson, *lab.hovered);
}

// A picture at a place of the window, under the mouse.
void draw_picture(LabState& lab, SceneRenderer& renderer, const View& view, float right_margin, const char* name) {
    const Size pixels{static_cast<int>(view.size.x), static_cast<int>(view.size.y)};
    const GLuint texture = renderer.render(view.scene, view.dimension(), *lab.session.camera, palette(lab.theme),
                                           lab.session.range.scale, pixels, lab.scale, right_margin);
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
    draw_labels(lab, view);
    if (!lab.session.message() && lab.layout != Layout::deck) draw_notes(lab, view);
}

// A on the left and B on the right, under one camera; the colour bar of both stands beside them.
void draw_two(LabState& lab, SceneRenderer& renderer, Scene of_a, const Rectangle& place, float right) {
    Session& s = lab.session;
    Scene of_b = s.scene_beside();
    const float gap = lab.px(2), width = std::floor((place.width - right - gap) / 2);
    if (width < 8) return;
    if (!s.camera) {
        Scene both;
        both.frame(of_a.lower, of_a.upper);
        for (std::size_t k = 0; k < 3; ++k)
            both.lower[k] = std::min(both.lower[k], of_b.lower[k]), both.upper[k] = std::max(both.upper[k], of_b.upper[k]);
        s.camera = framing(both, s.lesson().dimension(), width / place.height);
    }
    const int dimension = s.lesson().dimension();
    const Projection projection(*s.camera, dimension, width, place.height);
    const ImVec2 size{width, place.height};
    const View a{std::move(of_a), projection, {place.x, place.y}, size, &s.lesson(), run_name(s, false), true};
    const View b{std::move(of_b),   projection, {place.x + width + gap, place.y}, size, &s.companion()->lesson(),
                 run_name(s, true), false};
    if (!lab.renderer_beside) lab.renderer_beside = std::make_unique<SceneRenderer>();
    draw_picture(lab, renderer, a, 0, "scene");
    draw_picture(lab, *lab.renderer_beside, b, 0, "scene B");
    ImGui::GetWindowDrawList()->AddRectFilled({place.x + width, place.y}, {place.x + width + gap, place.y + place.height},
                                              lab.ink(Ink::rest));
    tell_stopped(lab, {b.origin.x, b.origin.y, size.x, size.y});
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
                    true};
    draw_picture(lab, renderer, view, right, "scene");
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
    if (s.pinned()) lay_under(scene, s.pinned()->ghost);
    const bool two = s.companion() && !s.shows_difference();
    if (two)
        draw_two(lab, renderer, std::move(scene), place, bar.right);
    else
        draw_alone(lab, renderer, std::move(scene), place, bar.right);
    draw_colour_bar(lab, {place.x, place.y, place.width, place.height + bar.below});
    name_pinned(lab, place);
    draw_hints(lab, place);
    draw_banner(lab, place);
}

}  // namespace pliant::viewer
