#include "panels/prediction_panel.h"

#include <pliant/document/summary.h>
#include <pliant/text/format.h>
#include <pliant/text/quantity_text.h>

#include "panels/typeset_text.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

using PredictionKind = Prediction::Kind;

float sketch_height(const PanelContext& lab) { return lab.px(120); }

std::string option_words(const Prediction& p, std::size_t k) { return fmt::format("{}   {}", k + 1, p.options[k].words); }

// "Enter the frequency, in rad/s": what a number or a sketch is of.
std::string entry_words(const PanelContext& lab, const Prediction& p) {
    const Probe& probe = lab.session.lesson().probe(p.probe);
    const std::string unit = probe.unit.empty() ? "" : fmt::format(", in {}", probe.unit);
    if (p.kind == PredictionKind::number) return fmt::format("Your number for the {}{}:", spoken(p.probe), unit);
    return fmt::format("Draw the {}{}, with the mouse; or type its values at equal times, such as {}:", spoken(p.probe), unit,
                       "3, 5, 8");
}

const MathBox& boxed(const PanelContext& lab, ImFont* type, const std::string& text, float width) {
    return lab.fonts.mathematics.sentence(text, type->FontSize, width);
}

float option_height(const PanelContext& lab, ImFont* type, const Prediction& p, std::size_t k, float width) {
    return boxed(lab, type, option_words(p, k), width - lab.px(16)).height() + lab.px(6);
}

// A line across the panel that a press chooses.
void draw_option(PanelContext& lab, ImFont* type, const Prediction& p, std::size_t k) {
    const float width = ImGui::GetContentRegionAvail().x;
    const MathBox& words = boxed(lab, type, option_words(p, k), width - lab.px(16));
    const bool chosen = lab.session.walkthrough->guess().option == k;
    const float height = option_height(lab, type, p, k, width) - ImGui::GetStyle().ItemSpacing.y;
    ImGui::PushID(static_cast<int>(k));
    if (ImGui::Selectable("##option", chosen, 0, {0, std::max(height, words.height())})) lab.session.predict({.option = k});
    lab.note_control(fmt::format("predict {}", k + 1));
    const ImVec2 at = ImGui::GetItemRectMin();
    lab.fonts.mathematics.draw(*ImGui::GetWindowDrawList(), words, {at.x + lab.px(8), at.y + words.above},
                               ImGui::GetColorU32(ImGuiCol_Text));
    if (chosen)
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + lab.px(3), ImGui::GetItemRectMax().y}, lab.ink(Ink::accent));
    ImGui::PopID();
}

void number_entry(PanelContext& lab, const Prediction& p) {
    const std::string unit(lab.session.lesson().probe(p.probe).unit);
    const auto& given = lab.session.walkthrough->guess().number;
    ImGui::SetNextItemWidth(std::min(lab.px(160), ImGui::GetContentRegionAvail().x));
    const auto text = number_field(lab.typed, "##predict number", given ? format_quantity(*given, unit, 6) : "");
    lab.note_control("predict number");
    if (!text || text->empty()) return;
    lab.take_typed([&] {
        const QuantityText read = read_quantity(*text, unit);
        if (read.problem != QuantityText::Problem::none || !std::isfinite(read.value))
            throw Refused(fmt::format("'{}' is not accepted as a prediction: give a number{}{}", *text,
                                      unit.empty() ? "" : " in ", unit.empty() ? "" : units_accepted(unit)));
        lab.session.predict({.number = read.value});
    });
}

// The plot that a sketch is drawn into.
struct SketchPlot {
    ImVec2 from, to;
    Interval height;

    ImVec2 at(std::size_t k, Real value) const {
        const float x = static_cast<float>(k) / static_cast<float>(sketch_points - 1);
        const auto y = static_cast<float>((value - height.min) / (height.max - height.min));
        return {from.x + x * (to.x - from.x), to.y - std::clamp(y, 0.f, 1.f) * (to.y - from.y)};
    }
    std::size_t point(float x) const {
        // A little outside the first and the last point counts for them.
        constexpr float margin = 0.03f;
        const float part = std::clamp((x - from.x) / (to.x - from.x) * (1 + 2 * margin) - margin, 0.f, 1.f);
        return static_cast<std::size_t>(std::lround(part * static_cast<float>(sketch_points - 1)));
    }
    Real value(float y) const {
        return std::lerp(height.min, height.max, static_cast<Real>(std::clamp((to.y - y) / (to.y - from.y), 0.f, 1.f)));
    }
};

void draw_curve(const SketchPlot& plot, const Sketch& curve, unsigned colour, float line) {
    for (std::size_t k = 1; k < curve.size(); ++k)
        ImGui::GetWindowDrawList()->AddLine(plot.at(k - 1, curve[k - 1]), plot.at(k, curve[k]), colour, line);
}

void draw_axes(PanelContext& lab, const SketchPlot& plot, const Prediction& p) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const unsigned ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const std::string unit(lab.session.lesson().probe(p.probe).unit), x_unit = lab.session.runner().is_static() ? "" : "s";
    ImFont* font = lab.fonts.small;
    draw->AddRectFilled(plot.from, plot.to, ImGui::GetColorU32(ImGuiCol_FrameBg), lab.px(3));
    for (const Real part : {0.0, 0.5, 1.0}) {
        const Real value = std::lerp(p.height.min, p.height.max, part);
        const float y = plot.at(0, value).y;
        draw->AddLine({plot.from.x, y}, {plot.to.x, y}, ImGui::GetColorU32(ImGuiCol_Separator), std::max(1.f, lab.px(1)));
        const std::string text = format_quantity(value, unit, 3);
        const float below = part == 1 ? 0 : font->FontSize;
        draw->AddText(font, font->FontSize, {plot.from.x + lab.px(3), y - below}, ink, text.c_str());
    }
    const std::string end = lab.session.runner().is_static() ? fmt::format("{} steps", p.span) : format_quantity(p.span, x_unit);
    const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, end.c_str()).x;
    draw->AddText(font, font->FontSize, {plot.to.x - width - lab.px(3), plot.to.y - font->FontSize}, ink, end.c_str());
}

// A stroke of the mouse sets all points between the one before and this one.
void take_stroke(PanelContext& lab, const SketchPlot& plot, const Prediction& p) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::size_t now = plot.point(mouse.x);
    Guess guess{.sketch = lab.session.walkthrough->guess().sketch};
    if (guess.sketch.empty()) guess.sketch.assign(sketch_points, plot.value(mouse.y));
    const std::size_t before = lab.sketched.value_or(now);
    const Real value = plot.value(mouse.y), value_before = guess.sketch[before];
    for (std::size_t k = std::min(before, now); k <= std::max(before, now); ++k) {
        const Real part = before == now ? 1
                                        : (static_cast<Real>(k) - static_cast<Real>(before)) /
                                              (static_cast<Real>(now) - static_cast<Real>(before));
        guess.sketch[k] = std::clamp(std::lerp(value_before, value, part), p.height.min, p.height.max);
    }
    // What has not been drawn yet goes on level.
    const auto rest = guess.sketch.begin() + static_cast<std::ptrdiff_t>(now) + 1;
    if (now >= before && std::all_of(rest, guess.sketch.end(), [&](Real y) { return y == guess.sketch.back(); }))
        std::fill(rest, guess.sketch.end(), value);
    lab.sketched = now;
    lab.session.predict(guess);
}

// The curve that is drawn, and the one that was measured.
void sketch_plot(PanelContext& lab, const Prediction& p, bool takes_strokes) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const ImVec2 size{ImGui::GetContentRegionAvail().x, sketch_height(lab)};
    ImGui::InvisibleButton("##sketch", size);
    lab.note_control("predict sketch");
    const SketchPlot plot{ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), p.height};
    if (takes_strokes && ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left))
        take_stroke(lab, plot, p);
    else
        lab.sketched.reset();
    draw_axes(lab, plot, p);
    const float line = std::max(2.f, lab.px(2));
    draw_curve(plot, player.measured_curve(), lab.ink(Ink::velocity), 1.5f * line);
    draw_curve(plot, player.guess().sketch, lab.ink(Ink::accent), line);
}

void sketch_entry(PanelContext& lab, const Prediction& p) {
    ImGui::SetNextItemWidth(-1);
    const bool given = !lab.session.walkthrough->guess().sketch.empty();
    const auto text = number_field(lab.typed, "##predict curve", "");
    lab.note_control("predict curve");
    if (text && !text->empty()) lab.take_typed([&] { lab.session.predict({.sketch = sketch_typed(*text)}); });
    sketch_plot(lab, p, true);
    tooltip(given ? "Drag on to change it" : "Drag from left to right: that is your curve", lab.scale);
}

// Entered by Enter, or by going elsewhere.
void words_entry(PanelContext& lab) {
    const auto text = words_field(lab.typed, "##predict words", "Your answer, in words", lab.session.walkthrough->guess().words);
    lab.note_control("predict words");
    tooltip("Nobody judges it but you: beside the answer of the slide you say whether you were right. Enter takes it.",
            lab.scale);
    if (text) lab.session.predict({.words = *text});
}

const char* verdict_mark(const WalkthroughPlayer& player) {
    const Guess& g = player.guess();
    const bool right = g.words.empty() ? player.verdict()->right : g.was_right.value_or(false);
    return !g.given() || g.after_answer || (!g.words.empty() && !g.was_right) ? "–" : right ? "✓" : "✗";
}

std::string verdict_words(const WalkthroughPlayer& player) {
    return fmt::format("{}  {}", verdict_mark(player), player.verdict()->words);
}

void draw_verdict(PanelContext& lab, ImFont* type, const Prediction& p) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const bool judged = player.guess().given() && !player.guess().after_answer && p.kind != PredictionKind::words;
    const unsigned colour =
        !judged ? ImGui::GetColorU32(ImGuiCol_Text) : lab.ink(player.verdict()->right ? Ink::velocity : Ink::accent);
    draw_item(lab.fonts.mathematics, boxed(lab, type, verdict_words(player), ImGui::GetContentRegionAvail().x), colour);
    lab.note_control("verdict");
    if (p.kind == PredictionKind::sketch) sketch_plot(lab, p, false);
}

}  // namespace

float prediction_height(const PanelContext& lab, ImFont* type, float width, bool revealed) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const auto& p = player.prediction();
    if (!p) return 0;
    const float gap = ImGui::GetStyle().ItemSpacing.y, field = lab.fonts.normal->FontSize + 2 * ImGui::GetStyle().FramePadding.y;
    const float sketch = p->kind == PredictionKind::sketch ? sketch_height(lab) + gap : 0;
    if (p->kind == PredictionKind::words) return field + gap;
    if (revealed) {
        // Of a verdict that is still to come: two lines.
        const float words = player.verdict() ? boxed(lab, type, verdict_words(player), width).height() : 2.6f * type->FontSize;
        return words + gap + sketch;
    }
    if (p->kind != PredictionKind::choice)
        return boxed(lab, lab.fonts.normal, entry_words(lab, *p), width).height() + field + 3 * gap + sketch;
    float height = gap;
    for (std::size_t k = 0; k < p->options.size(); ++k) height += option_height(lab, type, *p, k, width) + gap;
    return height;
}

void draw_prediction(PanelContext& lab, ImFont* type) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const auto& p = player.prediction();
    if (!p) return;
    const bool nothing_said = p->kind == PredictionKind::words && !player.guess().given();
    if (player.revealed() && player.verdict() && !nothing_said) return draw_verdict(lab, type, *p);
    if (player.revealed()) return;
    if (p->kind == PredictionKind::words) return words_entry(lab);
    if (p->kind == PredictionKind::choice) {
        for (std::size_t k = 0; k < p->options.size(); ++k) draw_option(lab, type, *p, k);
        return;
    }
    ImGui::PushFont(lab.fonts.normal);
    sentence_item(lab, entry_words(lab, *p));
    p->kind == PredictionKind::number ? number_entry(lab, *p) : sketch_entry(lab, *p);
    ImGui::PopFont();
}

void draw_own_verdict(PanelContext& lab) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    if (!player.revealed() || player.guess().words.empty()) return;
    const auto& said = player.guess().was_right;
    const auto button = [&](const char* words, bool right, const char* control) {
        ImGui::BeginDisabled(said == right);
        if (ImGui::Button(words)) lab.session.say_right(right);
        ImGui::EndDisabled();
        lab.note_control(control);
        tooltip("You judge this yourself: no program reads your answer. What you say is handed in with it.", lab.scale);
    };
    button("I was right", true, "own verdict right");
    ImGui::SameLine();
    button("I was not", false, "own verdict not right");
    ImGui::Spacing();
}

}  // namespace pliant::viewer
