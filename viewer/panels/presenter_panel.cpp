#include "panels/presenter_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pliant::viewer {
namespace {

unsigned text_colour() { return ImGui::GetColorU32(ImGuiCol_Text); }
unsigned quiet_text() { return ImGui::GetColorU32(ImGuiCol_TextDisabled); }

void words_in(const PresenterPage& page, const std::string& text, ImFont* font, unsigned colour) {
    if (text.empty()) return;
    const float width = std::max(ImGui::GetContentRegionAvail().x, 1.f);
    draw_item(page.fonts.mathematics, page.fonts.mathematics.sentence(text, font->FontSize, width), colour);
}

void plain_words(const std::string& text, ImFont* font, unsigned colour) {
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void note_last(const PresenterPage& page, const char* name) {
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    page.controls[name] = {a.x, a.y, b.x - a.x, b.y - a.y};
}

// The largest type in which the words fit; the smallest, and a bar to scroll, when they fit in none.
ImFont* fitting_type(const PresenterPage& page, const std::string& text, ImVec2 room) {
    for (ImFont* font : {page.fonts.larger, page.fonts.large, page.fonts.medium})
        if (page.fonts.mathematics.sentence(text, font->FontSize, room.x).height() <= room.y) return font;
    return page.fonts.medium;
}

std::string minutes_text(Real minutes) {
    const std::string number = fmt::format("{:.3g}", minutes);
    return fmt::format("{} {}", number, number == "1" ? "minute" : "minutes");
}

void draw_clock(const PresenterPage& page, const PresenterView& v, const PresenterClock& clock, PresenterWishes& wishes) {
    if (!clock.time_of_day.empty()) {
        plain_words(clock.time_of_day, page.fonts.huge, text_colour());
        ImGui::SameLine(0, page.px(28));
    }
    plain_words(elapsed_text(clock.elapsed), page.fonts.huge, clock.paused ? quiet_text() : text_colour());
    note_last(page, "clock");
    ImGui::SameLine(0, page.px(12));
    if (ImGui::Button(clock.paused ? "Go on" : "Pause")) wishes.pause_clock = true;
    note_last(page, "pause clock");
    ImGui::SameLine();
    if (ImGui::Button("From 0")) wishes.restart_clock = true;
    note_last(page, "restart clock");
    if (v.minutes_so_far && v.minutes_in_all) {
        ImGui::SameLine(0, page.px(20));
        const bool late = clock.elapsed > 60 * *v.minutes_so_far;
        plain_words(
            fmt::format("planned: {:.3g} of {} at the end of this slide", *v.minutes_so_far, minutes_text(*v.minutes_in_all)),
            page.fonts.normal, late ? packed(bad_colour) : quiet_text());
    }
}

// At the right of the first line: the number of the slide, and that the screen of the audience is black.
void draw_place(const PresenterPage& page, const PresenterView& v) {
    const std::string place = v.count > 0 ? fmt::format("{} / {}", v.number, v.count) : "";
    const std::string mark = v.black ? "■ screen is black" : "";
    ImGui::PushFont(page.fonts.large);
    const float width = ImGui::CalcTextSize(place.c_str()).x, black = ImGui::CalcTextSize(mark.c_str()).x,
                right = ImGui::GetContentRegionMax().x;
    ImGui::PopFont();
    ImGui::SetCursorPos({right - width, ImGui::GetStyle().WindowPadding.y});
    plain_words(place, page.fonts.large, quiet_text());
    if (!v.black) return;
    ImGui::SetCursorPos({right - std::max(width, black), 2 * page.fonts.large->FontSize});
    plain_words(mark, page.fonts.large, packed(bad_colour));
    note_last(page, "black mark");
}

void draw_readings(const PresenterPage& page, const PresenterView& v, const std::string& busy) {
    words_in(page, busy.empty() ? v.now : busy, page.fonts.normal, busy.empty() ? quiet_text() : packed(bad_colour));
    if (!v.message.empty()) words_in(page, v.message, page.fonts.normal, packed(bad_colour));
    const int columns = static_cast<int>(v.readings.size());
    if (columns == 0 || !ImGui::BeginTable("readings", columns)) return;
    for (const PresenterView::Reading& r : v.readings) {
        ImGui::TableNextColumn();
        words_in(page, r.name, page.fonts.small, quiet_text());
        plain_words(r.number, page.fonts.large, text_colour());
        if (!r.exact.empty()) plain_words(r.exact, page.fonts.small, quiet_text());
    }
    ImGui::EndTable();
}

void headed(const PresenterPage& page, const char* heading, const std::string& text, ImFont* font, unsigned colour) {
    if (text.empty()) return;
    plain_words(heading, page.fonts.small, ink(page.theme, Ink::accent));
    words_in(page, text, font, colour);
    ImGui::Dummy({0, page.px(4)});
}

// As wide as the column, and no higher than what the words leave.
void draw_next_picture(const PresenterPage& page, float room) {
    if (!page.next || !page.next->picture || !page.renderer) return;
    const SlidePreview& next = *page.next;
    const float width = std::min(ImGui::GetContentRegionAvail().x, room * preview_aspect), height = width / preview_aspect;
    if (height < page.px(60)) return;
    const Size pixels{static_cast<int>(width), static_cast<int>(height)};
    const GLuint texture =
        page.renderer->render(*next.picture, next.dimension, next.camera, palette(page.theme), next.scale, pixels, page.scale, 0);
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), {width, height}, {0, 1}, {1, 0});
    note_last(page, "next picture");
}

void draw_next(const PresenterPage& page, const PresenterView& v) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const auto height = [&](const std::string& text) {
        return page.fonts.mathematics.sentence(text, page.fonts.medium->FontSize, room.x).height();
    };
    const bool roomy = height(v.question) + height(v.answer) + height(v.next_words) < 0.55f * room.y;
    ImFont* const font = roomy ? page.fonts.medium : page.fonts.normal;
    headed(page, "Next", v.next_press, page.fonts.medium, text_colour());
    headed(page, "Question", v.question, font, text_colour());
    headed(page, "Answer", v.answer, font, text_colour());
    if (v.next_title.empty()) return;
    ImGui::Separator();
    headed(page, "The slide after this one", v.next_title, page.fonts.medium, text_colour());
    const float words = page.fonts.mathematics.sentence(v.next_words, font->FontSize, room.x).height() + page.px(8);
    draw_next_picture(page, ImGui::GetContentRegionAvail().y - std::min(words, 0.4f * room.y));
    words_in(page, v.next_words, font, quiet_text());
}

float readings_height(const PresenterPage& page, const PresenterView& v) {
    const float lines = page.fonts.normal->FontSize * (v.message.empty() ? 1.6f : 4);
    return lines + page.fonts.large->FontSize + 3.2f * page.fonts.small->FontSize + page.px(12);
}

}  // namespace

std::string elapsed_text(Real seconds) {
    const long s = std::lround(std::floor(std::max(seconds, Real{0})));
    return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60) : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

PresenterWishes draw_presenter(const PresenterPage& page, const PresenterView& v, const PresenterClock& clock,
                               const std::string& busy) {
    PresenterWishes wishes;
    const float line = ImGui::GetCursorPosY() + page.fonts.huge->FontSize + page.px(10);
    draw_clock(page, v, clock, wishes);
    draw_place(page, v);
    ImGui::SetCursorPosY(line);
    ImGui::Separator();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float left = 0.6f * room.x, readings = readings_height(page, v);
    const int flags = ImGuiWindowFlags_NoBackground;
    ImGui::BeginChild("of this slide", {left, room.y}, ImGuiChildFlags_None, flags | ImGuiWindowFlags_NoScrollbar);
    words_in(page, v.title, page.fonts.large, text_colour());
    ImGui::BeginChild("notes", {left - page.px(16), std::max(ImGui::GetContentRegionAvail().y - readings, page.px(60))},
                      ImGuiChildFlags_None, flags);
    if (v.count == 0)
        words_in(page, fmt::format("No slides are open. D opens the deck of “{}”.", v.lesson), page.fonts.medium, quiet_text());
    if (v.count > 0 && !v.in_deck) plain_words("The audience sees the lab; D shows the deck.", page.fonts.normal, quiet_text());
    if (v.minutes) plain_words(fmt::format("{} for this slide", minutes_text(*v.minutes)), page.fonts.small, quiet_text());
    words_in(page, v.notes, fitting_type(page, v.notes, ImGui::GetContentRegionAvail()), text_colour());
    ImGui::EndChild();
    note_last(page, "notes");
    ImGui::Separator();
    draw_readings(page, v, busy);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("what comes", {0, room.y}, ImGuiChildFlags_None, flags);
    draw_next(page, v);
    ImGui::EndChild();
    note_last(page, "next");
    return wishes;
}

}  // namespace pliant::viewer
