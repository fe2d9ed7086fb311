// What is known of the thing under the pointer, and the ring around it.
#include <pliant/text/format.h>

#include "panels/scene_view.h"
#include "panels/typeset_text.h"
#include "plot/free_place.h"
#include "render/moving_parts.h"
#include "render/places.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

std::string known_of(const Session& s, const Lesson& lesson, const Scene& scene, const Picked& picked) {
    std::string text = fmt::format("{} {}\n", name_of(picked.on), picked.index);
    for (const Field& f : lesson.fields) {
        if (!f.in_use() || s.hides(f.name) || f.on != picked.on || picked.index >= f.size()) continue;
        const bool scalar = f.rank == Rank::scalar || f.symbol.empty(), awaited = scene.awaits(f.name);
        text += fmt::format("{} {}\n",
                            scalar ? named_with_symbol(f.name, f.symbol)
                                   : fmt::format("{} {}", words(f.name), as_formula(fmt::format("|{}|", f.symbol))),
                            awaited ? "—" : as_formula("= " + format_quantity(row_value(f, picked.index, -1), f.unit)));
        if (f.rank == Rank::scalar || awaited) continue;
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
    return text;
}

Point pixel_of(const View& view, const Position& place) {
    const Eigen::Vector3f p = view.projection.pixel(place);
    return {view.origin.x + p.x(), view.origin.y + p.y()};
}

// Where what moves is in the window, thinned out.
std::vector<Point> seen_parts(const View& view) {
    constexpr std::size_t most = 400;
    const std::vector<Position> parts = moving_parts(view.picture->scene);
    std::vector<Point> seen;
    for (std::size_t i = 0; i < parts.size(); i += 1 + parts.size() / most) seen.push_back(pixel_of(view, parts[i]));
    return seen;
}

void mark(PanelContext& lab, const View& view, const Position& place, float radius, float width) {
    const Point at = pixel_of(view, place);
    ImGui::GetWindowDrawList()->AddCircle({at.x, at.y}, lab.px(radius), lab.ink(Ink::accent), 0, std::max(2.f, lab.px(width)));
}

}  // namespace

void mark_thing(PanelContext& lab, const View& view) {
    const auto& autopsy = lab.session.autopsy();
    const auto& thing = autopsy && autopsy->thing ? autopsy->thing : lab.session.inspector.thing;
    const bool inspected = thing == lab.session.inspector.thing;
    if (!thing || (inspected && (lab.side != SideTab::inspect || lab.layout == Layout::deck))) return;
    if (const auto at = place_of(view.picture->scene, thing->on, thing->index)) mark(lab, view, *at, 11, 3);
}

void read_out(PanelContext& lab, const View& view, const Picked& picked) {
    const Position place = position<3>(picked.at);
    mark(lab, view, place, 9, 2);
    const std::string text =
        picked.on == On::handle ? "Drag me" : known_of(lab.session, *view.lesson, view.picture->scene, picked);
    ImGui::PushFont(lab.fonts.small);
    const MathBox& words = sentence_box(lab, text);
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const Point size{words.width + 2 * padding.x, words.height() + 2 * padding.y};
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const Box picture{{view.origin.x, view.origin.y}, {view.origin.x + view.size.x, view.origin.y + view.size.y}};
    const bool roomy = size.x < picture.width() && size.y < picture.height();
    const Point at = free_place(pixel_of(view, place), size, lab.px(22), roomy ? picture : Box{{0, 0}, {screen.x, screen.y}},
                                seen_parts(view));
    ImGui::SetNextWindowPos({at.x, at.y});
    ImGui::BeginTooltip();
    draw_item(lab.fonts.mathematics, words, ImGui::GetColorU32(ImGuiCol_Text));
    ImGui::EndTooltip();
    ImGui::PopFont();
    lab.controls["read-out"] = {at.x, at.y, size.x, size.y};
}

}  // namespace pliant::viewer
