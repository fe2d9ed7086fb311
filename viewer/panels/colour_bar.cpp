#include "panels/colour_bar.h"

#include "panels/typeset_text.h"

#include <pliant/run/awaited.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pliant::viewer {
namespace {

constexpr int bands = 64;

const Field* shown_field(const PanelContext& lab) {
    const Field* field = lab.session.lesson().find_field(lab.session.colours.field);
    return field && field->in_use() ? field : nullptr;
}

std::string title_of(const Session& s, const Field& field) {
    const std::string symbol(field.symbol);
    std::string title = words(field.name);
    if (s.colours.component >= 0)
        title += " " + component_names(field)[static_cast<std::size_t>(s.colours.component)];
    else if (field.rank == Rank::scalar)
        title = named_with_symbol(field.name, symbol);
    else if (symbol.empty())
        title = "|" + title + "|";
    else
        title += " " + as_formula("|" + symbol + "|");
    if (s.hides(field.name)) return title;
    const bool one_number = s.colour_scale().min == s.colour_scale().max;
    if (s.shows_difference()) return fmt::format("A − B of {}{}", title, one_number ? ": none beyond rounding" : "");
    if (s.shows_change()) {
        const Stage* stage = s.inspector.shown_stage(s.runner());
        if (one_number) return fmt::format("{}: unchanged{}", title, stage ? " by " + words(stage->name) : "");
        return stage ? fmt::format("Change of {} by {}", title, words(stage->name)) : fmt::format("Change of {}", title);
    }
    if (awaited_stage(s.runner(), field)) return title;
    if (!s.range.automatic) return title + " (fixed)";
    return !one_number ? title : s.colour_scale().max == 0 ? title + ", 0 everywhere" : title + ", the same everywhere";
}

// The colour of a part of the bar, 0 to 1: while the numbers are none yet, that of the picture.
Rgba8 colour_of_part(const Session& s, const Field& field, Real part) {
    const bool awaited = !s.shows_change() && awaited_stage(s.runner(), field);
    return awaited ? undefined_colour : colour_at(s.colour_scale().map, part);
}

// With as many digits as it takes for all to differ; one alone where the whole scale is one number.
std::vector<std::string> tick_texts(const PanelContext& lab, int intervals, const Field& field) {
    const ColourScale& scale = lab.session.colour_scale();
    std::vector<std::string> texts;
    if (lab.session.hides(field.name)) return {"?"};
    if (!lab.session.shows_change() && awaited_stage(lab.session.runner(), field)) return {"—"};
    for (const int digits : {3, 4, 5}) {
        texts.clear();
        for (int i = 0; i <= intervals; ++i) {
            const Real value = scale.min + (scale.max - scale.min) * i / intervals;
            const bool zero = std::abs(value) < 1e-12 * std::max(std::abs(scale.min), std::abs(scale.max));
            texts.push_back(format_quantity(zero ? 0 : value, field.unit, digits));
        }
        if (std::ranges::adjacent_find(texts) == texts.end()) return texts;
    }
    if (texts.front() == texts.back()) return {format_quantity((scale.min + scale.max) / 2, field.unit, 3)};
    return texts;
}

// Where tick i stands, as a part of the bar.
float tick_part(const std::vector<std::string>& ticks, std::size_t i) {
    return ticks.size() == 1 ? 0.5f : static_cast<float>(i) / static_cast<float>(ticks.size() - 1);
}

// Where the words of tick i of a bar that lies begin, from its left end: the first begins and the last ends with the bar.
float tick_begin(const std::vector<std::string>& ticks, std::size_t i, float width) {
    const float size = ImGui::CalcTextSize(ticks[i].c_str()).x, middle = width * tick_part(ticks, i);
    return std::clamp(middle - size / 2, 0.f, std::max(width - size, 0.f));
}

// Five ticks, or three or two where the words of more would touch.
std::vector<std::string> bar_ticks_that_fit(const PanelContext& lab, const Field& field, float width) {
    for (const int intervals : {4, 2}) {
        const auto ticks = tick_texts(lab, intervals, field);
        bool apart = true;
        for (std::size_t i = 1; i < ticks.size(); ++i)
            apart = apart && tick_begin(ticks, i - 1, width) + ImGui::CalcTextSize(ticks[i - 1].c_str()).x + lab.px(14) <=
                                 tick_begin(ticks, i, width);
        if (apart) return ticks;
    }
    return tick_texts(lab, 1, field);
}

// Hatches the part of the bar that stands for negative numbers, as the picture does. `from` and `to` are where the least and the
// greatest number are.
void hatch(PanelContext& lab, ImVec2 from, ImVec2 to, bool upright) {
    const ColourScale& scale = lab.session.colour_scale();
    if (!lab.session.patterns || scale.min >= 0 || scale.max <= scale.min) return;
    const float part = static_cast<float>(std::min(Real{1}, -scale.min / (scale.max - scale.min)));
    const ImVec2 a{from.x, upright ? from.y - part * (from.y - to.y) : to.y},
        b{upright ? to.x : from.x + part * (to.x - from.x), from.y};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(a, b, true);
    const float height = b.y - a.y;
    for (float x = a.x - height; x < b.x; x += lab.px(7))
        draw->AddLine({x, a.y}, {x + height, b.y}, IM_COL32(0, 0, 0, 170), std::max(1.5f, lab.px(2)));
    draw->PopClipRect();
}

void upright_bar(PanelContext& lab, const Rectangle& picture, const Field& field) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float height = std::min(picture.height * 0.45f, lab.px(240)), width = lab.px(14);
    const ImVec2 low{picture.x + picture.width - width - lab.px(12), picture.y + picture.height - lab.px(16)};
    const float top = low.y - height;
    for (int i = 0; i < bands; ++i) {
        const float y0 = low.y - height * static_cast<float>(i + 1) / bands, y1 = low.y - height * static_cast<float>(i) / bands;
        draw->AddRectFilled({low.x, y0}, {low.x + width, y1 + 0.5f},
                            packed(colour_of_part(lab.session, field, (i + 0.5) / bands)));
    }
    hatch(lab, low, {low.x + width, top}, true);
    draw->AddRect({low.x, top}, {low.x + width, low.y}, lab.ink(Ink::text, 0.6f));
    ImGui::PushFont(lab.fonts.small);
    const float line = ImGui::GetTextLineHeight();
    const auto ticks = tick_texts(lab, 4, field);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const std::string& text = ticks[i];
        const float y = low.y - height * tick_part(ticks, i);
        draw->AddLine({low.x - lab.px(4), y}, {low.x, y}, lab.ink(Ink::text), std::max(1.f, lab.px(1)));
        haloed_text(lab, {low.x - lab.px(7) - ImGui::CalcTextSize(text.c_str()).x, y - line / 2}, lab.ink(Ink::text), text);
    }
    const std::string title = cut_sentence(lab, title_of(lab.session, field), picture.width - lab.px(20));
    const float left = std::max(low.x + width - sentence_width(lab, title), picture.x + lab.px(8));
    haloed_sentence(lab, {left, top - 1.6f * line}, lab.ink(Ink::text), title);
    ImGui::PopFont();
}

void lying_bar(PanelContext& lab, const Rectangle& picture, const Field& field) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    ImGui::PushFont(lab.fonts.normal);
    const float line = ImGui::GetTextLineHeight(), height = lab.px(14), left = picture.x + lab.px(20),
                width = picture.width - lab.px(40), bottom = picture.y + picture.height - line - lab.px(9), top = bottom - height;
    for (int i = 0; i < bands; ++i) {
        const float x0 = left + width * static_cast<float>(i) / bands, x1 = left + width * static_cast<float>(i + 1) / bands;
        draw->AddRectFilled({x0, top}, {x1 + 0.5f, bottom}, packed(colour_of_part(lab.session, field, (i + 0.5) / bands)));
    }
    hatch(lab, {left, bottom}, {left + width, top}, false);
    draw->AddRect({left, top}, {left + width, bottom}, lab.ink(Ink::text, 0.6f));
    const auto ticks = bar_ticks_that_fit(lab, field, width);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const std::string& text = ticks[i];
        const float x = left + width * tick_part(ticks, i);
        draw->AddLine({x, bottom}, {x, bottom + lab.px(4)}, lab.ink(Ink::text), std::max(1.f, lab.px(1)));
        haloed_text(lab, {left + tick_begin(ticks, i, width), bottom + lab.px(5)}, lab.ink(Ink::text), text);
    }
    haloed_sentence(lab, {left, top - line - lab.px(3)}, lab.ink(Ink::text),
                    cut_sentence(lab, title_of(lab.session, field), width));
    ImGui::PopFont();
}

}  // namespace

ColourBarPlace colour_bar_place(const PanelContext& lab, float width) {
    if (!shown_field(lab)) return {};
    // Labels beside a body need some room.
    const float right = lab.session.lesson().dimension() == 3 ? lab.px(60) : 0;
    if (lab.layout == Layout::deck) return {.right = right, .below = 2 * lab.fonts.normal->FontSize + lab.px(30)};
    return {.right = std::min(lab.px(96), width / 3)};
}

void draw_colour_bar(PanelContext& lab, const Rectangle& picture) {
    const Field* field = shown_field(lab);
    if (!field) return;
    lab.layout == Layout::deck ? lying_bar(lab, picture, *field) : upright_bar(lab, picture, *field);
}

}  // namespace pliant::viewer
