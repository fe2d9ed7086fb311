// Notes, in a strip above the picture that they are about.
#include "panels/scene_view.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr float most_of_room = 1 / 3.f, most_in_normal_type = 0.2f;  // of the height of the panel

struct NoteLine {
    MathBox words;
    Ink ink;
    float space;  // below it, px
    float height() const { return words.height() + space; }
};

std::vector<NoteLine> note_lines(PanelContext& lab, const Notes& notes, bool small, float width) {
    std::vector<NoteLine> lines;
    const auto add = [&](const ImFont* font, Ink ink, std::string_view text) {
        const float type = font->FontSize;
        MathBox words = lab.fonts.mathematics.label(text, type, width - lab.px(20));
        words.above = std::max(words.above, 0.75f * type), words.below = std::max(words.below, 0.2f * type);
        lines.push_back({std::move(words), ink, 0.28f * type});
    };
    if (!notes.heading.empty()) add(small ? lab.fonts.normal : lab.fonts.medium, Ink::accent, notes.heading);
    for (const std::string& note : *notes.lines) add(small ? lab.fonts.small : lab.fonts.normal, Ink::text, note);
    return lines;
}

float strip_height(PanelContext& lab, std::initializer_list<Notes> all, bool small, float width) {
    float tallest = 0;
    for (const Notes& notes : all) {
        float height = 0;
        for (const NoteLine& line : note_lines(lab, notes, small, width)) height += line.height();
        if (height > 0) tallest = std::max(tallest, height + lab.px(12));
    }
    return std::ceil(tallest);
}

}  // namespace

float notes_height(PanelContext& lab, ScenePanelState& panel, std::initializer_list<Notes> notes, float width, float room) {
    if (lab.layout == Layout::deck) return 0;
    NotesStrip& strip = panel.notes_strip;
    const NotesStrip now{lab.session.run_count(), lab.layout, width, room, lab.scale};
    if (!strip.same_place(now)) strip = now;
    float height = strip_height(lab, notes, strip.small, width);
    if (!strip.small && height > most_in_normal_type * room) {
        strip.small = true;
        strip.height = 0;
        height = strip_height(lab, notes, true, width);
    }
    strip.height = std::min(std::max(strip.height, height), std::floor(most_of_room * room));
    return strip.height;
}

// A slide has no notes, but says which run is which.
void draw_heading_of_slide(PanelContext& lab, const View& view) {
    if (view.heading.empty()) return;
    ImGui::PushFont(lab.fonts.medium);
    // Its letter alone where the rest has no room: the words of the slide know it by that.
    const bool fits = ImGui::CalcTextSize(view.heading.c_str()).x <= view.size.x - lab.px(20);
    const std::string heading = fits ? view.heading : view.heading.substr(0, 1);
    haloed_text(lab, {view.origin.x + lab.px(10), view.origin.y + lab.px(8)}, lab.ink(Ink::text), heading);
    ImGui::PopFont();
}

// Notes tell of limits that a run keeps or breaks, so beside a question their room stays empty.
void draw_notes(PanelContext& lab, ScenePanelState& panel, const View& view) {
    if (lab.layout == Layout::deck) return draw_heading_of_slide(lab, view);
    const std::vector<NoteLine> lines =
        note_lines(lab, {view.heading, &view.picture->scene.notes}, panel.notes_strip.small, view.size.x);
    const bool covered = lab.session.hides("lights");  // the heading says which run it is
    float y = view.origin.y - view.above + lab.px(8);
    for (const NoteLine& line : lines) {
        if (y + line.words.height() > view.origin.y) return;
        if (covered && line.ink == Ink::text) return;
        lab.fonts.mathematics.draw(*ImGui::GetWindowDrawList(), line.words, {view.origin.x + lab.px(10), y + line.words.above},
                                   lab.ink(line.ink));
        y += line.height();
    }
}

}  // namespace pliant::viewer
