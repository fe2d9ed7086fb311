// The picture: drawn into a texture, alone or two beside each other, with labels, notes and read-out over it.
#include "panels/colour_bar.h"
#include "panels/companion_panel.h"
#include "panels/deck_panel.h"
#include "panels/scene_matrices.h"
#include "panels/scene_messages.h"
#include "panels/scene_view.h"
#include "panels/status_line.h"
#include "render/ghost.h"
#include "render/moving_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pliant::viewer {
namespace {

// The run that shows this lesson; null for a picture of the past.
const Runner* runner_of(const Session& s, const Lesson* lesson) {
    if (!lesson) return nullptr;
    return lesson == &s.lesson() ? &s.runner() : &s.companion()->runner();
}

// A picture at a place of the window, under the mouse.
void draw_picture(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer, const View& view, float right_margin,
                  const char* name) {
    const Size pixels{static_cast<int>(view.size.x), static_cast<int>(view.size.y)};
    const GLuint texture =
        renderer.render(*view.picture, view.dimension, lab.session.seen_by(), palette(lab.theme), lab.session.colour_scale(),
                        pixels, lab.px(mark_scale(lab)), right_margin, lab.session.patterns);
    const ImVec2 end{view.origin.x + view.size.x, view.origin.y + view.size.y};
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), view.origin, end,
                                         {0, 1}, {1, 0});
    ImGui::SetCursorScreenPos(view.origin);
    ImGui::SetNextItemAllowOverlap();
    ImGui::InvisibleButton(
        name, view.size,
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    lab.note_control(name);
    handle_mouse(lab, panel, view);
    lab.note_fillable({view.origin.x, view.origin.y, view.size.x, view.size.y}, {Filled::picture, ""});
    fill_menu_of_last_item(lab, {Filled::picture, ""}, [&] {
        if (ImGui::MenuItem("Whole scene", "Home")) lab.wanted.push_back(Action::frame);
    });
    if (view.first) mark_thing(lab, view), note_handles(lab, view);
    const std::vector<Rectangle> labels = draw_labels(lab, panel, view);
    tell_awaited(lab, view.picture->scene, runner_of(lab.session, view.lesson),
                 {view.origin.x, view.origin.y, view.size.x - right_margin, view.size.y}, labels);
    if (view.lesson && !lab.session.hides("matrices")) {
        // Above the hints, where they are shown.
        const bool hinted = panel.hints_shown && lab.layout == Layout::lab;
        const float low = hinted ? 3 * ImGui::GetTextLineHeight() + lab.px(32) : 0;
        draw_matrices(lab, view.picture->scene.matrices,
                      {view.origin.x, view.origin.y, view.size.x - right_margin, view.size.y - low});
    }
    if (!lab.session.autopsy() && (view.above > 0 || lab.layout == Layout::deck)) draw_notes(lab, panel, view);
}

// The viewpoint of this frame; the ghost of a pinned run, in the ink of guides, is not followed.
void look_at(PanelContext& lab, ScenePanelState& panel, const Frame& frame, std::span<const Position> moving, float aspect) {
    Session& s = lab.session;
    s.see_in(std::max(aspect, 0.05f));
    s.viewpoint.look({.frame = frame,
                      .moving = moving,
                      .aspect = std::max(aspect, 0.05f),
                      .run = s.run_count(),
                      .seconds = lab.seconds,
                      .held = panel.pulling || panel.turning});
}

struct Side {
    KeptPicture picture;
    const Lesson* lesson;
    std::string heading;
    bool first;
};

Rectangle below(const Rectangle& room, float strip) { return {room.x, room.y + strip, room.width, room.height - strip}; }

// Where words of the picture may stand: in the deck beside a colour bar that lies below it.
float label_width(const PanelContext& lab, float width, float right) {
    return lab.layout == Layout::deck ? width : width - right;
}

// Two pictures side by side under one camera; the colour bar of both stands beside them. Gives the place of the second.
Rectangle draw_pair(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer, Side a, Side b, const Rectangle& room,
                    float right) {
    Session& s = lab.session;
    const float gap = lab.px(2), width = std::floor((room.width - right - gap) / 2);
    if (width < 8) return {};
    const float above = notes_height(lab, panel, {{a.heading, &a.picture->scene.notes}, {b.heading, &b.picture->scene.notes}},
                                     width, room.height);
    const Rectangle place = below(room, above);
    // A run that broke down is not followed to where it flew.
    std::vector<Position> moving;
    for (const Side* side : {&a, &b})
        if (!(side->first && s.autopsy())) std::ranges::copy(moving_parts(side->picture->scene), std::back_inserter(moving));
    const int dimension = s.lesson().dimension();
    look_at(lab, panel, about(frame_of(a.picture->scene, dimension), frame_of(b.picture->scene, dimension)), moving,
            width / place.height);
    const Projection projection(s.seen_by(), dimension, width, place.height);
    const ImVec2 size{width, place.height};
    const auto view = [&](Side& side, float x) {
        return View{std::move(side.picture),
                    projection,
                    {x, place.y},
                    size,
                    side.lesson,
                    side.heading,
                    side.first,
                    dimension,
                    above,
                    width};
    };
    if (!panel.renderer_beside) panel.renderer_beside = std::make_unique<SceneRenderer>();
    const float second = place.x + width + gap;
    draw_picture(lab, panel, renderer, view(a, place.x), 0, a.first ? "scene" : "scene B");
    draw_picture(lab, panel, *panel.renderer_beside, view(b, second), 0, b.first ? "scene" : "scene B");
    ImGui::GetWindowDrawList()->AddRectFilled({second - gap, place.y}, {second, place.y + place.height}, lab.ink(Ink::rest));
    return {second, place.y, width, place.height};
}

// A on the left and B on the right.
void draw_two(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer, KeptPicture of_a, const Rectangle& place,
              float right) {
    Session& s = lab.session;
    Side a{std::move(of_a), &s.lesson(), run_name(s, false), true},
        b{s.picture_beside(), &s.companion()->lesson(), run_name(s, true), false};
    tell_of_beside(lab, draw_pair(lab, panel, renderer, std::move(a), std::move(b), place, right));
}

std::string heading_of(const Session& s, std::string_view moment) {
    const Stage* stage = s.inspector.shown_stage(s.runner());
    return fmt::format("{} {}", moment, stage ? words(stage->name) : "");
}

// What a stage found on the left, and what it left on the right.
void draw_before_and_after(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer, KeptPicture before,
                           KeptPicture after, const Rectangle& place, float right) {
    Session& s = lab.session;
    Side left{std::move(before), nullptr, heading_of(s, "before"), false},
        now{std::move(after), &s.lesson(), heading_of(s, "after"), true};
    draw_pair(lab, panel, renderer, std::move(left), std::move(now), place, right);
}

// Gives the place of the picture, below its notes.
Rectangle draw_alone(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer, KeptPicture picture,
                     const Rectangle& room, float right) {
    Session& s = lab.session;
    const int dimension = s.lesson().dimension();
    const std::string of_a = differing_text(s, false);
    const std::string heading = !s.shows_difference() ? ""
                                : of_a.empty()        ? "A − B, of the same parameters"
                                                      : fmt::format("A − B:  {}  −  {}", of_a, differing_text(s, true));
    const float above = notes_height(lab, panel, {{heading, &picture->scene.notes}}, room.width, room.height);
    const Rectangle place = below(room, above);
    look_at(lab, panel, frame_of(picture->scene, dimension), moving_parts(picture->scene), (place.width - right) / place.height);
    const View view{std::move(picture),
                    Projection(s.seen_by(), dimension, place.width, place.height, right),
                    {place.x, place.y},
                    {place.width, place.height},
                    &s.lesson(),
                    heading,
                    true,
                    dimension,
                    above,
                    label_width(lab, place.width, right)};
    draw_picture(lab, panel, renderer, view, right, "scene");
    return place;
}

// What a stage found, drawn over what it left up to a line that can be moved.
void draw_swipe(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer, const Picture& before, KeptPicture after,
                const Rectangle& room, float right) {
    Session& s = lab.session;
    float& swipe = s.inspector.swipe;
    const Rectangle place = draw_alone(lab, panel, renderer, std::move(after), room, right);
    if (!panel.renderer_beside) panel.renderer_beside = std::make_unique<SceneRenderer>();
    const Size pixels{static_cast<int>(place.width), static_cast<int>(place.height)};
    const GLuint texture = panel.renderer_beside->render(before, s.lesson().dimension(), s.seen_by(), palette(lab.theme),
                                                         s.colour_scale(), pixels, lab.px(mark_scale(lab)), right, s.patterns);
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

void draw_scene(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer) {
    Session& s = lab.session;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ColourBarPlace bar = colour_bar_place(lab, room.x);
    const Rectangle place{origin.x, origin.y, room.x, room.y - bar.below};
    if (place.width < 8 || place.height < 8) return;
    ImGui::GetWindowDrawList()->AddRectFilled(origin, {origin.x + room.x, origin.y + room.y},
                                              packed(palette(lab.theme).background));
    KeptPicture picture = s.picture();
    lab.scene_has_grid = !picture->scene.grids.empty();
    const bool two = s.companion() && !s.shows_difference();
    KeptPicture before = two || s.inspector.compare == Compare::before ? nullptr : s.other_picture();
    if (two)
        draw_two(lab, panel, renderer, std::move(picture), place, bar.right);
    else if (before && s.inspector.compare == Compare::side_by_side)
        draw_before_and_after(lab, panel, renderer, std::move(before), std::move(picture), place, bar.right);
    else if (before)
        draw_swipe(lab, panel, renderer, *before, std::move(picture), place, bar.right);
    else
        draw_alone(lab, panel, renderer, std::move(picture), place, bar.right);
    if (lab.layout == Layout::deck && slide_speaks_of_lights(lab)) draw_lights_at(lab, place);
    draw_colour_bar(lab, {place.x, place.y, place.width, place.height + bar.below});
    name_pinned(lab, panel, place);
    draw_unsolved(lab, panel, {place.x, place.y, place.width - bar.right, place.height});
    draw_hints(lab, panel, {place.x, place.y, place.width - bar.right, place.height});
    // Below the names of the pictures and what is said of them.
    draw_banner(lab, lab.layout == Layout::deck ? place : below(place, panel.notes_strip.height));
    draw_autopsy(lab, panel, place);
}

}  // namespace pliant::viewer
