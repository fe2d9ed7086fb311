// Words over the picture.
#include "panels/scene_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

// The sizes of type for labels, the largest first: what a lecture hall reads is larger.
std::vector<ImFont*> label_fonts(const PanelContext& lab) {
    if (lab.layout == Layout::lab) return {lab.fonts.normal, lab.fonts.small};
    return {lab.fonts.medium, lab.fonts.normal, lab.fonts.small};
}

ImFont* font_of(const PanelContext& lab, const LabelMark& label, ImFont* font) {
    if (!label.large) return font;
    return lab.layout == Layout::lab ? lab.fonts.large : lab.fonts.larger;
}

struct PlacedLabel {
    MathBox words;
    ImVec2 at, size;

    bool empty() const { return words.letters.empty(); }
};

// Where a label stands in the picture, in the present type.
PlacedLabel placed_label(const PanelContext& lab, const View& view, const LabelMark& l, const Eigen::Vector3f& p, float scale) {
    const float type = ImGui::GetFontSize();
    // One that is wider than the picture stands above its place, in lines.
    MathBox words = lab.fonts.mathematics.label(l.text, type, view.label_width - 8);
    words.above = std::max(words.above, 0.75f * type), words.below = std::max(words.below, 0.2f * type);
    const ImVec2 size{words.width, std::min(words.height(), ImGui::GetTextLineHeight())};
    const float more_lines = words.height() - size.y;
    Eigen::Vector2f beyond(0, 0);
    if (l.away_from) {
        const Eigen::Vector2f d = (p - view.projection.pixel(*l.away_from)).head<2>().normalized();
        beyond = d * (lab.px(6) + std::abs(d.x()) * size.x / 2 + std::abs(d.y()) * size.y / 2);
    }
    const float offset = lab.px(scale);
    const float x =
        std::clamp(p.x() + beyond.x() + offset * l.offset_x - size.x / 2, 4.f, std::max(4.f, view.label_width - size.x - 4));
    const float y = std::clamp(p.y() + beyond.y() + offset * l.offset_y - size.y / 2 - more_lines, 2.f,
                               std::max(2.f, view.size.y - size.y - 2));
    return {std::move(words), {x, y}, {size.x, size.y + more_lines}};
}

// Those that are in front of the eye; empty ones stand for the others.
std::vector<PlacedLabel> placed_labels(PanelContext& lab, const View& view, ImFont* font) {
    std::vector<PlacedLabel> placed;
    const float scale = font->FontSize / lab.fonts.normal->FontSize;
    for (const LabelMark& l : view.picture->scene.labels) {
        const Eigen::Vector3f p = view.projection.pixel(l.at);
        ImGui::PushFont(font_of(lab, l, font));
        placed.push_back(p.z() < 1 ? placed_label(lab, view, l, p, scale) : PlacedLabel{});
        ImGui::PopFont();
    }
    return placed;
}

std::size_t overlaps(const std::vector<PlacedLabel>& labels) {
    std::size_t count = 0;
    const auto apart = [](float a, float a_size, float b, float b_size) { return a + a_size <= b || b + b_size <= a; };
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const PlacedLabel &a = labels[i], &b = labels[j];
            // The space between lines may be shared.
            count += !a.empty() && !b.empty() && !apart(a.at.x, a.size.x, b.at.x, b.size.x) &&
                     !apart(a.at.y, 0.8f * a.size.y, b.at.y, 0.8f * b.size.y);
        }
    return count;
}

// The largest type in which no label lies on another, or as few as can be. It stays for the run, lest it change with every move,
// unless it has to be smaller.
ImFont* chosen_font(PanelContext& lab, ScenePanelState& panel, const View& view) {
    const std::vector<ImFont*> fonts = label_fonts(lab);
    const LabelType now{lab.session.run_count(), lab.layout, view.size.x, view.size.y, lab.scale, 0};
    if (!panel.label_type.same_picture(now)) panel.label_type = now;
    std::size_t best = panel.label_type.smaller, least = overlaps(placed_labels(lab, view, fonts[best]));
    for (std::size_t k = best + 1; k < fonts.size() && least > 0; ++k)
        if (const std::size_t count = overlaps(placed_labels(lab, view, fonts[k])); count < least) best = k, least = count;
    panel.label_type.smaller = best;
    return fonts[best];
}

// What lies behind words is dimmed, so that they can be read over any colour.
void draw_plates(PanelContext& lab, const View& view, const std::vector<PlacedLabel>& labels) {
    const unsigned plate = packed(palette(lab.theme).background, 0.68f);
    const float pad = lab.px(3);
    for (const PlacedLabel& l : labels) {
        if (l.empty()) continue;
        const ImVec2 from{view.origin.x + l.at.x, view.origin.y + l.at.y};
        ImGui::GetWindowDrawList()->AddRectFilled({from.x - pad, from.y}, {from.x + l.size.x + pad, from.y + l.size.y}, plate,
                                                  pad);
    }
}

}  // namespace

float mark_scale(const PanelContext& lab) {
    return lab.layout == Layout::lab ? 1 : lab.fonts.medium->FontSize / lab.fonts.normal->FontSize;
}

std::vector<Rectangle> draw_labels(PanelContext& lab, ScenePanelState& panel, const View& view) {
    if (!view.picture->scene.show_labels || view.picture->scene.labels.empty()) return {};
    ImFont* const font = chosen_font(lab, panel, view);
    const std::vector<PlacedLabel> placed = placed_labels(lab, view, font);
    draw_plates(lab, view, placed);
    std::vector<Rectangle> places;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const LabelMark& label = view.picture->scene.labels[i];
        const PlacedLabel& l = placed[i];
        lab.fonts.mathematics.draw(*ImGui::GetWindowDrawList(), l.words,
                                   {view.origin.x + l.at.x, view.origin.y + l.at.y + l.words.above}, lab.ink(label.ink));
        if (!l.empty()) places.push_back({view.origin.x + l.at.x, view.origin.y + l.at.y, l.size.x, l.size.y});
    }
    return places;
}

}  // namespace pliant::viewer
