// Words over the picture.
#include "panels/scene_view.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

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

// In the type of the layout: what a lecture hall reads is larger.
ImFont* font_of(const LabState& lab, const LabelMark& label) {
    if (lab.layout == Layout::lab) return label.large ? lab.fonts.large : lab.fonts.normal;
    return label.large ? lab.fonts.larger : lab.fonts.medium;
}

void draw_label(LabState& lab, const View& view, const LabelMark& l) {
    const Eigen::Vector3f p = view.projection.pixel(l.at);
    if (p.z() >= 1) return;
    const ImVec2 size = ImGui::CalcTextSize(l.text.c_str());
    // One that is wider than the picture stands above its place, in lines.
    const float more_lines = size.x > view.size.x - 8 ? std::floor(size.x / (view.size.x - 8)) * size.y : 0;
    Eigen::Vector2f beyond(0, 0);
    if (l.away_from) {
        const Eigen::Vector2f d = (p - view.projection.pixel(*l.away_from)).head<2>().normalized();
        beyond = d * (lab.px(6) + std::abs(d.x()) * size.x / 2 + std::abs(d.y()) * size.y / 2);
    }
    const float offset = lab.px(mark_scale(lab));
    const float x =
        std::clamp(p.x() + beyond.x() + offset * l.offset_x - size.x / 2, 4.f, std::max(4.f, view.size.x - size.x - 4));
    float y = std::clamp(p.y() + beyond.y() + offset * l.offset_y - size.y / 2 - more_lines, 2.f,
                         std::max(2.f, view.size.y - size.y - 2));
    for (const std::string& line : lines_of(l.text, view.size.x - 8)) {
        haloed_text(lab, {view.origin.x + x, view.origin.y + y}, lab.ink(l.ink), line);
        y += size.y;
    }
}

}  // namespace

float mark_scale(const LabState& lab) {
    return lab.layout == Layout::lab ? 1 : lab.fonts.medium->FontSize / lab.fonts.normal->FontSize;
}

void draw_labels(LabState& lab, const View& view) {
    if (!view.scene.show_labels) return;
    for (const LabelMark& label : view.scene.labels) {
        ImGui::PushFont(font_of(lab, label));
        draw_label(lab, view, label);
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

}  // namespace pliant::viewer
