// The stages of a step, with where we are in them.
#include "panels/stage_bar.h"

#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include "panels/companion_panel.h"
#include "panels/scene_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace pliant::viewer {
namespace {

// A ring, or a filled disc where the run is to stop before this stage. True when it was pressed.
bool break_dot(PanelContext& lab, const Stage& stage, std::size_t i, ImVec2 at, float size) {
    const auto& breaks = lab.session.inspector.breaks;
    const bool set = breaks.stages.contains(stage.name) || breaks.passes.contains(stage.name);
    const float line = ImGui::GetTextLineHeight();
    ImGui::SetCursorScreenPos({at.x - lab.px(3), at.y});
    const bool pressed = ImGui::InvisibleButton(fmt::format("break {}", i).c_str(), {size + lab.px(6), line});
    lab.note_control(fmt::format("dot {}", stage.name));
    tooltip(set ? "The run stops before this stage. Click: it does not" : "Click: stop before this stage", lab.scale);
    const ImVec2 middle{at.x + size / 2, at.y + line / 2};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (set)
        draw->AddCircleFilled(middle, size / 2, packed(bad_colour));
    else
        draw->AddCircle(middle, size / 2, lab.ink(Ink::text, ImGui::IsItemHovered() ? 0.9f : 0.35f), 0, std::max(1.f, lab.px(1)));
    if (pressed) lab.session.toggle_break(stage.name);
    return pressed;
}

float stage_pad(const PanelContext& lab) { return lab.px(6); }
// The room below the name of a stage.
float formula_height(const PanelContext& lab) {
    return lab.px(stage_height) - 1.4f * stage_pad(lab) - 1.25f * lab.fonts.small->FontSize;
}

constexpr float most_unbroken = 200;  // px at scale 1

// In which its formula can be read.
float stage_width(const PanelContext& lab, std::string_view formula) {
    const MathType& mathematics = lab.fonts.mathematics;
    const float type = 0.95f * lab.fonts.normal->FontSize;
    // One that is not too wide is not broken.
    const float whole = (mathematics.formula(formula, type).width + 2 * stage_pad(lab)) / lab.scale;
    float width = whole < most_unbroken ? std::max(least_stage_width, std::ceil(whole)) : most_unbroken;
    for (; width < most_stage_width; width += 24) {
        const float room = lab.px(width) - 2 * stage_pad(lab);
        const MathBox& box = mathematics.formula(formula, type, room);
        if (box.width <= room && box.height() <= formula_height(lab)) break;
    }
    return lab.px(width);
}

// Its number and name, in small type, behind the ring.
float name_width(const PanelContext& lab, const Stage& stage, std::size_t i) {
    const ImFont* font = lab.fonts.small;
    const std::string name = fmt::format("{} {}", i + 1, words(stage.name));
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, name.c_str()).x + 4 * stage_pad(lab) + 0.5f * font->FontSize;
}

// What each asks for where there is room for all, and a share of what is spare; narrower ones down to their names where that
// keeps all in sight.
std::vector<float> stage_widths(const PanelContext& lab, const std::vector<const Stage*>& stages, float room) {
    std::vector<float> widths, least;
    for (const Stage* stage : stages) {
        widths.push_back(stage_width(lab, stage->formula_now()));
        least.push_back(std::min(name_width(lab, *stage, least.size()), lab.px(most_stage_width)));
        widths.back() = std::max(widths.back(), least.back());
    }
    const auto sum = [](const std::vector<float>& all) { return std::accumulate(all.begin(), all.end(), 0.f); };
    const float spare = room - sum(widths), all_least = sum(least);
    if (spare >= 0 || all_least > room) {
        for (float& width : widths) width += std::max(spare, 0.f) / static_cast<float>(stages.size());
        return widths;
    }
    // All give up the same part of what they have beyond the least.
    const float part = (room - all_least) / (sum(widths) - all_least);
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = least[i] + part * (widths[i] - least[i]);
    return widths;
}

// In the largest type in which it fits; what does not even fit in the smallest ends with an ellipsis;
// the tooltip has it whole.
void draw_formula(PanelContext& lab, std::string_view formula, ImVec2 at, ImVec2 room) {
    const float type = lab.fonts.normal->FontSize;
    const MathBox& box = lab.fonts.mathematics.fitted(formula, 1.15f * type, 0.8f * type, room.x, room.y);
    const float spare = std::max(0.f, room.y - box.height());
    lab.fonts.mathematics.draw(*ImGui::GetWindowDrawList(), box, {at.x, at.y + box.above + 0.35f * spare},
                               ImGui::GetColorU32(ImGuiCol_Text));
    if (box.width <= room.x && box.height() <= room.y) return;
    const ImVec2 corner{at.x + room.x, at.y + room.y}, size = ImGui::CalcTextSize("…");
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled({corner.x - size.x - lab.px(4), corner.y - size.y}, {corner.x + stage_pad(lab), corner.y},
                        ImGui::GetColorU32(ImGuiCol_FrameBg));
    draw->AddText({corner.x - size.x, corner.y - size.y}, ImGui::GetColorU32(ImGuiCol_Text), "…");
}

// Of the last item: the whole formula, where it is from, what it took, and what a click does.
void stage_tooltip(PanelContext& lab, const Stage& stage, const StageCost& cost) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_DelayShort)) return;
    std::string more = fmt::format("Source: {}\nReads {}; writes {}.", stage.source, fmt::join(stage.reads, ", "),
                                   fmt::join(stage.writes, ", "));
    if (cost.runs)
        more +=
            fmt::format("\n{:.3f} ms last, {:.1f} ms in all, {} in {}.", cost.last_ms, cost.total_ms,
                        counted(static_cast<long long>(cost.passes), "pass"), counted(static_cast<long long>(cost.runs), "run"));
    more += "\nClick: run to the end of this stage. Right click: compare before and after.";
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(words(stage.name).c_str());
    formula_item(lab.fonts.mathematics, stage.formula, lab.fonts.medium->FontSize, lab.px(420));
    ImGui::PushTextWrapPos(lab.px(420));
    ImGui::TextUnformatted(more.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// The name with its milliseconds, where there is room for both, then the formula; the tooltip has it whole.
void stage_box(PanelContext& lab, const Stage& stage, const StageCost& cost, std::size_t i, float width, float height) {
    const Runner& runner = lab.session.runner();
    const bool done_last = runner.last_stage() == i;
    const bool inside = runner.inside_step() && !lab.session.shows_last_step(), next = inside && runner.next_stage() == i;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float line = std::max(2.f, lab.px(2));
    draw->AddRectFilled(at, {at.x + width, at.y + height},
                        ImGui::GetColorU32(done_last && inside ? ImGuiCol_Header : ImGuiCol_FrameBg), lab.px(4));
    if (next) draw->AddRect(at, {at.x + width, at.y + height}, lab.ink(Ink::accent), lab.px(4), 0, line);

    draw->PushClipRect(at, {at.x + width, at.y + height}, true);
    const float pad = stage_pad(lab);
    std::string name = fmt::format("{} {}", i + 1, words(stage.name));
    if (next && runner.passes_in_stage() > 0) name += fmt::format(" · pass {}", runner.passes_in_stage());
    const float dot = ImGui::GetTextLineHeight() * 0.5f;
    std::string ms = cost.runs ? format_quantity(cost.last_ms / 1000, "s", 3) : "";
    ImGui::PushFont(lab.fonts.small);
    const auto wide = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
    if (wide(name) + wide(ms) > width - 4 * pad - dot) ms.clear();
    const float ms_width = ms.empty() ? -pad : wide(ms);
    ImGui::SetCursorScreenPos({at.x + width - ms_width - pad, at.y + pad * 0.7f});
    ImGui::TextDisabled("%s", ms.c_str());
    const ImVec2 formula{at.x + pad, at.y + pad + ImGui::GetTextLineHeight() * 1.25f};
    draw_formula(lab, stage.formula_now(), formula, {width - 2 * pad, formula_height(lab)});
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({at.x + 2 * pad + dot, at.y + pad * 0.4f});
    const float room = width - ms_width - 4 * pad - dot;
    ImGui::PushFont(ImGui::CalcTextSize(name.c_str()).x <= room ? lab.fonts.normal : lab.fonts.small);
    fitted_text(name, room);
    ImGui::PopFont();
    draw->PopClipRect();

    ImGui::SetCursorScreenPos(at);
    ImGui::SetNextItemAllowOverlap();
    const bool clicked = ImGui::InvisibleButton(fmt::format("stage {}", i).c_str(), {width, height});
    lab.note_control(fmt::format("stage {}", stage.name));
    stage_tooltip(lab, stage, cost);
    const bool looked = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    const bool toggled = break_dot(lab, stage, i, {at.x + pad, at.y + pad * 0.4f}, dot);
    // The box is what the next one stands beside.
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({width, height});
    if (toggled) return;
    if (clicked) lab.session.run_to_stage(stage.name);
    if (!looked) return;
    lab.session.inspector.stage = stage.name;
    lab.session.compare(lab.session.inspector.compare == Compare::now ? Compare::difference : lab.session.inspector.compare);
}

}  // namespace

void draw_stage_bar(PanelContext& lab, StageBarState& panel) {
    const Runner& runner = lab.session.runner();
    const auto& stages = runner.stages();
    if (stages.empty()) return;
    const float gap = lab.px(5), room = ImGui::GetContentRegionAvail().x - gap * static_cast<float>(stages.size() - 1);
    const std::vector<float> widths = stage_widths(lab, stages, room);
    // Where they would be too narrow to read, they are looked through sideways, and the one that is done stays in sight.
    const bool scrolls = std::accumulate(widths.begin(), widths.end(), 0.f) > room + 1;
    panel.scrolls = scrolls;
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, lab.px(stage_scrollbar));
    ImGui::BeginChild("stages", {0, lab.px(stage_height + (scrolls ? stage_scrollbar : 0))}, ImGuiChildFlags_None,
                      ImGuiWindowFlags_NavFlattened | (scrolls ? ImGuiWindowFlags_AlwaysHorizontalScrollbar : 0));
    const auto seen = runner.inside_step() ? runner.last_stage() : std::optional<std::size_t>(0);
    if (scrolls && seen && seen != std::exchange(panel.in_sight, seen))
        ImGui::SetScrollX(std::accumulate(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(*seen), 0.f) +
                          gap * static_cast<float>(*seen) - lab.px(least_stage_width) / 2);
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (i) ImGui::SameLine(0, gap);
        stage_box(lab, *stages[i], runner.cost(*stages[i]), i, widths[i], lab.px(stage_height));
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace pliant::viewer
