// The atlas: where the open lesson is stable, over two of its parameters.
#include "panels/atlas_panel.h"

#include <pliant/study/stability_report.h>
#include <pliant/text/format.h>

#include "panels/companion_panel.h"
#include "panels/flowing_text.h"
#include "panels/plot_panel.h"
#include "plot/imgui_canvas.h"
#include "session/worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

void flowing_words(const std::string& text, bool quiet = false) {
    if (quiet) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(flowing_text(text, ImGui::GetFont(), ImGui::GetContentRegionAvail().x).c_str());
    if (quiet) ImGui::PopStyleColor();
}

void choose_knob(PanelContext& lab, const char* label, std::string& key, std::optional<Atlas::Span>& span,
                 const std::string& other, const char* help) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize("across").x - lab.px(10));
    const bool open = ImGui::BeginCombo(label, words(key).c_str());
    lab.note_control(fmt::format("atlas {}", label));
    if (!open) return tooltip(help, lab.scale);
    for (const Parameter* p : lab.session.lesson().parameters) {
        if (!can_be_knob(*p) || p->info.key == other) continue;
        const bool chosen = p->info.key == key;
        if (ImGui::Selectable(words(p->info.key).c_str(), chosen) && !chosen) key = p->info.key, span.reset();
        lab.note_control(fmt::format("atlas knob {}", p->info.key));
        tooltip(std::string(p->info.help), lab.scale);
    }
    ImGui::EndCombo();
}

// What the map spans of a knob: from, to, and whether its values are spaced by factors. Options have no range.
void range_row(PanelContext& lab, const char* label, const std::string& key, std::optional<Atlas::Span>& span, Index cells) {
    const Parameter* p = key.empty() ? nullptr : &lab.session.lesson().parameter(key);
    if (!p || !p->info.is_number()) return;
    const Atlas::Span now = span.value_or(Atlas::Span{p->info.useful, p->info.scale == Scale::log});
    const auto set = [&](const Atlas::Span& wanted) {
        lab.take_typed([&] {
            knob_of(*p, wanted.range.min, wanted.range.max, cells, wanted.log ? Spacing::log : Spacing::linear);
            span = wanted;
        });
    };
    ImGui::PushID(label);
    const float words_width = ImGui::CalcTextSize("to").x + ImGui::CalcTextSize("log").x + ImGui::GetFrameHeight(),
                gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::max(lab.px(48), (ImGui::GetContentRegionAvail().x - words_width - 5 * gap) / 2);
    const auto field = [&](const char* name, Real Interval::*end) {
        ImGui::SetNextItemWidth(width);
        const auto text =
            number_field(lab.typed, fmt::format("##{}", name).c_str(), format_quantity(now.range.*end, p->info.unit, 4));
        lab.note_control(fmt::format("atlas {} {}", label, name));
        tooltip(fmt::format("The {} value of {} in the map; accepted {}", end == &Interval::min ? "least" : "largest",
                            words(p->info.key), p->accepted().text()),
                lab.scale);
        if (!text) return;
        lab.take_typed([&] {
            Atlas::Span wanted = now;
            wanted.range.*end = p->parse(*text);
            set(wanted);
        });
    };
    field("from", &Interval::min);
    ImGui::SameLine(0, gap);
    ImGui::TextDisabled("to");
    ImGui::SameLine(0, gap);
    field("to", &Interval::max);
    ImGui::SameLine(0, gap);
    bool log = now.log;
    if (ImGui::Checkbox("log", &log)) set({now.range, log});
    lab.note_control(fmt::format("atlas {} log", label));
    tooltip("The values of the knob are spaced by equal factors rather than by equal steps", lab.scale);
    ImGui::PopID();
}

void whole_slider(PanelContext& lab, const char* label, float width, Index& value, int least, int most, const char* help) {
    int shown = static_cast<int>(value);
    ImGui::SetNextItemWidth(width - ImGui::CalcTextSize(label).x - lab.px(10));
    const auto text = slider_or_text(lab.typed, label, fmt::format("{}", shown), [&] {
        if (ImGui::SliderInt(label, &shown, least, most, "%d", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
            value = shown;
    });
    if (text) lab.take_typed([&] { value = whole_typed(label, *text, least, most); });
    lab.note_control(fmt::format("atlas {}", label));
    tooltip(help, lab.scale);
}

// A refusal is told in the panel, where it was asked for.
void make_or_cancel(PanelContext& lab, AtlasPanelState& panel) {
    Atlas& atlas = panel.atlas;
    if (!atlas.busy()) {
        if (flowing_button(lab, atlas.map() ? "Map again" : "Map it", "atlas make",
                           "Runs the lesson in every cell, beside the lab, and classes each run by its energy", true))
            start_atlas(lab, panel);
        return;
    }
    if (flowing_button(lab, "Cancel", "atlas cancel", "Stops making the map", true)) atlas.cancel();
    ImGui::SameLine();
    const Watch::Progress progress = atlas.progress();
    ImGui::ProgressBar(static_cast<float>(progress.share().value_or(0)), {-1, 0});
    lab.note_control("atlas progress");
    tooltip("The cells that are done", lab.scale);
    flowing_words(busy_words(progress, progress.seconds).line, true);
}

std::string theory_text(const MapCell& c) {
    if (!c.theory) return "";
    if (*c.theory == 0) return "theory: every time step is stable";
    if (std::isinf(*c.theory)) return "theory: no time step is stable";
    return fmt::format("time step / limit of theory: {:.3g}", *c.theory);
}

std::string cell_text(const Lesson& lesson, const StabilityMap& map, Index i, Index j, bool with_theory) {
    const MapCell& c = map.at(i, j);
    const auto value = [&](const Knob& knob, Index k) {
        return setting_text(lesson.parameter(knob.key), knob.values[static_cast<std::size_t>(k)]);
    };
    std::string text = fmt::format("{}, {}\n{}", value(map.order.across, i), value(map.order.up, j), words_of(c.verdict.kind));
    if (c.verdict.growth)
        text += fmt::format("\ngrowth of the amplitude, in each step: × {:.7g}\nwhich is the root of that of the energy",
                            *c.verdict.growth);
    if (const std::string theory = with_theory ? theory_text(c) : ""; !theory.empty()) text += "\n" + theory;
    return text + "\nin the whole run: " + c.verdict.reason;
}

// Beside the map with its axes, at the height of the pointer: on the left where there is room, else on the right, else above or
// below; over a map that fills the screen, beside the pointer, on the side where there is more room.
void tip_beside(const PanelContext& lab, const Box& map, const std::string& text) {
    const float gap = lab.px(10), wrap = lab.px(300);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap), screen = ImGui::GetIO().DisplaySize,
                 pad = ImGui::GetStyle().WindowPadding, mouse = ImGui::GetMousePos();
    const ImVec2 whole{size.x + 2 * pad.x, size.y + 2 * pad.y};
    ImVec2 at{map.min.x - gap - whole.x, std::clamp(mouse.y - whole.y / 2, 0.f, std::max(0.f, screen.y - whole.y))};
    if (at.x < 0) at.x = map.max.x + gap;
    if (at.x + whole.x > screen.x) {
        at.x = std::clamp(mouse.x - whole.x / 2, 0.f, std::max(0.f, screen.x - whole.x));
        at.y = map.min.y - gap - whole.y >= 0 ? map.min.y - gap - whole.y : map.max.y + gap;
    }
    if (at.y + whole.y > screen.y) {
        at.x = mouse.x > screen.x / 2 ? mouse.x - 2 * gap - whole.x : mouse.x + 2 * gap;
        at = {std::clamp(at.x, 0.f, std::max(0.f, screen.x - whole.x)),
              std::clamp(mouse.y - whole.y / 2, 0.f, std::max(0.f, screen.y - whole.y))};
    }
    ImGui::SetNextWindowPos(at);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(wrap);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// legend_beside: where the map has the whole screen.
void draw_picture(PanelContext& lab, AtlasPanelState& panel, float height, bool legend_beside) {
    const StabilityMap& map = *panel.atlas.map();
    MapPicture picture = panel.atlas.picture();
    picture.present = panel.atlas.present(lab.session);
    const bool theory = !lab.session.hides("theory");
    if (!theory) picture.bound.clear(), picture.wrong.assign(picture.wrong.size(), 0);
    const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const bool pressed = ImGui::InvisibleButton("map", {room.x, height});
    lab.note_control("atlas map");
    const PlotStyle style = style_of_plots(lab);
    ImguiCanvas canvas(*ImGui::GetWindowDrawList(), style.mathematics);
    const Box whole{{at.x, at.y}, {at.x + room.x, at.y + height}};
    const MapPlaces places = draw_map(canvas, whole, picture, style, legend_beside);
    lab.controls["atlas area"] = {places.area.min.x, places.area.min.y, places.area.width(), places.area.height()};
    panel.cell.reset();
    const ImVec2 mouse = ImGui::GetMousePos();
    const auto cell = ImGui::IsItemHovered() ? places.cell(map, {mouse.x, mouse.y}) : std::nullopt;
    if (!cell) return;
    const auto [i, j] = *cell;
    panel.cell = cell;
    tip_beside(lab, whole, cell_text(lab.session.lesson(), map, i, j, theory) + "\nClick to open this scene.");
    if (pressed) open_cell(lab.session, map, cell->first, cell->second);
}

// For those who cannot point: what holds where the sliders stand.
void tell_present(PanelContext& lab, AtlasPanelState& panel) {
    const StabilityMap& map = *panel.atlas.map();
    if (panel.atlas.outdated(lab.session)) return flowing_words("Other parameters than the knobs have changed since: map again.");
    const auto place = panel.atlas.present(lab.session);
    if (!place) return flowing_words("The present scene lies outside of the map.", true);
    const auto nearest = [](Real x, Index count) { return std::clamp<Index>(std::lround(x), 0, count - 1); };
    const MapCell& c = map.at(nearest(place->across, map.columns()), nearest(place->up, map.rows()));
    flowing_words(fmt::format("The present scene: {}.", words_of(c.verdict.kind)));
}

}  // namespace

void start_atlas(PanelContext& lab, AtlasPanelState& panel) {
    try {
        panel.atlas.start(lab.session);
    } catch (const Refused& e) {
        lab.session.say(Session::Message::Kind::refused, e.what());
    }
}

namespace {

void draw_knobs(PanelContext& lab, AtlasPanelState& panel) {
    Atlas& atlas = panel.atlas;
    choose_knob(lab, "across", atlas.across, atlas.across_span, atlas.up, "The knob along the map");
    if (std::exchange(panel.focus, false)) focus_last_item();
    range_row(lab, "across", atlas.across, atlas.across_span, atlas.cells);
    choose_knob(lab, "up", atlas.up, atlas.up_span, atlas.across, "The knob up the map");
    range_row(lab, "up", atlas.up, atlas.up_span, atlas.cells);
    const float half = 0.5f * ImGui::GetContentRegionAvail().x;
    whole_slider(lab, "cells", half, atlas.cells, 8, 48, "Values of each knob");
    ImGui::SameLine();
    whole_slider(lab, "steps", half, atlas.steps, 50, 1000,
                 "Steps of each cell; one that is in doubt makes up to 16 times as many");
    make_or_cancel(lab, panel);
    if (!atlas.trouble().empty()) flowing_words(atlas.trouble());
    if (!atlas.map() && !atlas.busy() && atlas.trouble().empty())
        flowing_words(
            "A map shows for which values of two parameters this lesson is stable: every cell is a run, classed by its energy, "
            "and the line is the limit of theory.",
            true);
}

void draw_words(PanelContext& lab, AtlasPanelState& panel) {
    const Atlas& atlas = panel.atlas;
    const StabilityMap& map = *atlas.map();
    ImGui::PushFont(lab.fonts.small);
    const bool compared = !lab.session.hides("theory");
    if (map.complete && compared)
        flowing_words(agreement_text(map), true);
    else if (!map.complete)
        flowing_words(fmt::format("{} of {} cells so far; each stands for those around it that are not run yet.",
                                  atlas.cells_done(), map.cells.size()),
                      true);
    ImGui::PopFont();
    tell_present(lab, panel);
}

}  // namespace

void draw_atlas(PanelContext& lab, AtlasPanelState& panel) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool wide = room.x > 1.2f * room.y && room.x > lab.px(560);
    const bool mapped = panel.atlas.map() != nullptr;
    if (wide) ImGui::BeginChild("knobs", {lab.px(250), 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NavFlattened);
    draw_knobs(lab, panel);
    if (wide && mapped) draw_words(lab, panel);
    if (wide) {
        ImGui::EndChild();
        ImGui::SameLine(0, lab.px(16));
    }
    if (!mapped) return;
    ImGui::BeginChild("atlas", {0, 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NavFlattened);
    const ImVec2 left = ImGui::GetContentRegionAvail();
    draw_picture(lab, panel,
                 wide ? left.y : std::clamp(left.y - 4 * ImGui::GetTextLineHeightWithSpacing(), lab.px(310), 1.5f * left.x),
                 wide);
    if (!wide) draw_words(lab, panel);
    ImGui::EndChild();
}

namespace {

void draw_unmade(PanelContext& lab, const AtlasPanelState& panel, float height) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const PlotStyle style = style_of_plots(lab);
    ImguiCanvas canvas(*ImGui::GetWindowDrawList(), style.mathematics);
    const MapPicture picture(*panel.unmade);
    const MapPlaces places = draw_map(canvas, {{at.x, at.y}, {at.x + room.x, at.y + height}}, picture, style, true);
    ImGui::Dummy({room.x, height});
    lab.note_control("atlas unmade");
    const char* const words = panel.atlas.busy() ? "The map is being made" : "Next: the map is made";
    const ImVec2 size = ImGui::CalcTextSize(words);
    ImGui::GetWindowDrawList()->AddText(
        {(places.area.min.x + places.area.max.x - size.x) / 2, (places.area.min.y + places.area.max.y - size.y) / 2},
        ImGui::GetColorU32(ImGuiCol_TextDisabled), words);
}

}  // namespace

void draw_atlas_of_slide(PanelContext& lab, AtlasPanelState& panel, bool made) {
    const Atlas& atlas = panel.atlas;
    ImGui::PushFont(lab.fonts.medium);
    const float height = ImGui::GetContentRegionAvail().y - 2 * ImGui::GetTextLineHeightWithSpacing();
    const bool mapped = atlas.map() && (made || atlas.busy());
    if (mapped)
        draw_picture(lab, panel, height, true);
    else if (panel.unmade)
        draw_unmade(lab, panel, height);
    if (!atlas.trouble().empty())
        flowing_words(atlas.trouble());
    else if (mapped && !atlas.map()->complete)
        flowing_words(fmt::format("{} of {} cells so far", atlas.cells_done(), atlas.map()->cells.size()), true);
    else if (mapped && !lab.session.hides("theory"))
        flowing_words(agreement_text(*atlas.map()), true);
    ImGui::PopFont();
}

}  // namespace pliant::viewer
