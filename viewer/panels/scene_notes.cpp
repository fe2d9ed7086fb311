// Notes, in a strip above the picture that they are about.
#include "panels/flowing_text.h"
#include "panels/scene_view.h"
#include "platform/index_letters.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <sstream>

namespace pliant::viewer {
namespace {

constexpr float most_of_room = 1 / 3.f, most_in_normal_type = 0.2f;  // of the height of the panel

struct NoteLine {
    ImFont* font;
    Ink ink;
    std::string text;
    float height() const { return 1.25f * font->FontSize; }
};

std::vector<NoteLine> note_lines(LabState& lab, const Notes& notes, bool small, float width) {
    std::vector<NoteLine> lines;
    const auto add = [&](ImFont* font, Ink ink, const std::string& text) {
        const std::string words = with_index_letters(text);
        const float room = width - lab.px(20);
        const bool fits = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, words.c_str()).x <= room;
        std::istringstream parts(fits ? words : flowing_text(words, font, room));
        for (std::string line; std::getline(parts, line);) lines.push_back({font, ink, line});
    };
    if (!notes.heading.empty()) add(small ? lab.fonts.normal : lab.fonts.medium, Ink::accent, std::string(notes.heading));
    for (const std::string& note : *notes.lines) add(small ? lab.fonts.small : lab.fonts.normal, Ink::text, note);
    return lines;
}

float strip_height(LabState& lab, std::initializer_list<Notes> all, bool small, float width) {
    float tallest = 0;
    for (const Notes& notes : all) {
        float height = 0;
        for (const NoteLine& line : note_lines(lab, notes, small, width)) height += line.height();
        if (height > 0) tallest = std::max(tallest, height + lab.px(12));
    }
    return std::ceil(tallest);
}

}  // namespace

std::vector<std::string> broken_lines(const std::string& text, float width) {
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

float notes_height(LabState& lab, std::initializer_list<Notes> notes, float width, float room) {
    if (lab.layout == Layout::deck) return 0;
    NotesStrip& strip = lab.notes_strip;
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

void draw_notes(LabState& lab, const View& view) {
    const std::vector<NoteLine> lines =
        note_lines(lab, {view.heading, &view.picture->scene.notes}, lab.notes_strip.small, view.size.x);
    float y = view.origin.y - view.above + lab.px(8);
    for (const NoteLine& line : lines) {
        if (y + line.font->FontSize > view.origin.y) return;
        ImGui::GetWindowDrawList()->AddText(line.font, line.font->FontSize, {view.origin.x + lab.px(10), y}, lab.ink(line.ink),
                                            line.text.c_str());
        y += line.height();
    }
}

}  // namespace pliant::viewer
