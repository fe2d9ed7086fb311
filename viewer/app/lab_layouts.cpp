// Where the panels of the lab stand, in each of its layouts.
#include "app/lab.h"
#include "panels/headline.h"
#include "panels/status_line.h"
#include "panels/walkthrough_panel.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {

void Lab::draw_layout(float width, float height) {
    if (!std::exchange(borders_made_, true)) make_borders();
    if (state_.fill.what == Filled::plot && !has_plot(state_, state_.fill.plot)) state_.fill = {};
    if (state_.fill) return filled_layout(width, height);
    state_.fillable.clear();
    switch (state_.layout) {
        case Layout::lab:
            return lab_layout(width, height);
        case Layout::slide:
            return slide_layout(width, height);
        case Layout::deck:
            return deck_layout(width, height);
        case Layout::presenter:
            return presenter_layout(width, height);
    }
}

void Lab::lab_layout(float width, float height) {
    LabState& s = state_;
    draw_menu_bar(s);
    const float top = ImGui::GetFrameHeight();
    const float status = ImGui::GetFrameHeight() + s.px(8), body = height - status - top,
                least_middle = std::min(s.px(360), 0.34f * width);
    const float left =
        size_at_border(s, {.name = "border left", .edge = 0, .from = top, .length = body, .unit = s.scale},
                       {std::min(s.px(238), width * 0.28f), std::min(s.px(180), width * 0.28f), 0.4f * width}, s.sizes.left);
    const float right =
        size_at_border(s, {.name = "border right", .edge = width, .direction = -1, .from = top, .length = body, .unit = s.scale},
                       {std::min(s.px(s.session.walkthrough ? 370 : 330), width * 0.32f), std::min(s.px(220), width * 0.32f),
                        width - left - least_middle},
                       s.sizes.right);
    const float middle = width - left - right;
    const float list = size_at_border(
        s, {.name = "border lessons", .sideways = false, .edge = top, .from = 0, .length = left, .unit = body},
        {std::min(body * 0.42f, s.px(40) + static_cast<float>(lessons().size() + 6) * ImGui::GetTextLineHeightWithSpacing()),
         std::min(s.px(150), 0.4f * body), 0.75f * body},
        s.sizes.lessons);
    const auto rows = static_cast<float>(1 + s.stages.transport_rows);
    const float bars = rows * ImGui::GetFrameHeight() + s.px(stage_height + (s.stages.scrolls ? stage_scrollbar : 0)) +
                       2 * ImGui::GetStyle().WindowPadding.y + rows * ImGui::GetStyle().ItemSpacing.y;
    {
        const FixedPanel panel("Lessons", {0, top, left, list});
        draw_lesson_list(s, s.lesson_list);
    }
    {
        const FixedPanel panel("Parameters", {0, top + list, left, body - list});
        draw_parameters(s, s.parameters);
    }
    {
        const FixedPanel panel("Stages", {left, top, middle, bars}, ImGuiWindowFlags_NoScrollbar);
        draw_transport(s, s.stages);
        draw_stage_bar(s, s.stages);
        draw_timeline(s, s.timeline);
    }
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
        const FixedPanel panel("Scene", {left, top + bars, middle, body - bars},
                               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        draw_scene(s, s.scene, renderer_);
    }
    if (s.session.walkthrough) {
        const float split = size_at_border(
            s,
            {.name = "border walkthrough", .sideways = false, .edge = top, .from = width - right, .length = right, .unit = body},
            {body * 0.58f, 0.25f * body, 0.8f * body}, s.sizes.walkthrough);
        {
            const FixedPanel panel("Walkthrough", {width - right, top, right, split});
            draw_walkthrough(s);
        }
        const FixedPanel panel("Plots", {width - right, top + split, right, body - split});
        draw_side(s);
    } else {
        const FixedPanel panel("Plots", {width - right, top, right, body});
        draw_side(s);
    }
    const FixedPanel panel("Status", {0, top + body, width, status}, ImGuiWindowFlags_NoScrollbar);
    draw_status_line(s);
}

void Lab::slide_layout(float width, float height) {
    LabState& s = state_;
    const float head = s.px(78), numbers = s.px(158);
    const float right = size_at_border(
        s, {.name = "border plots", .edge = width, .direction = -1, .from = head, .length = height - head, .unit = s.scale},
        {std::max(s.px(300), width * 0.32f), std::min(s.px(240), 0.3f * width), 0.65f * width}, s.sizes.plots);
    const int flags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {s.px(18), s.px(10)});
        const FixedPanel panel("Headline", {0, 0, width, head}, flags);
        ImGui::PopStyleVar();
        draw_headline(s);
    }
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
        const FixedPanel panel("Scene", {0, head, width - right, height - head}, flags | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        draw_scene(s, s.scene, renderer_);
    }
    {
        const FixedPanel panel("Plots", {width - right, head, right, height - head - numbers}, flags);
        draw_plots(s, s.plots);
    }
    {
        const FixedPanel panel("Numbers", {width - right, height - numbers, right, numbers}, flags);
        draw_key_numbers(s);
    }
    ImGui::PopStyleVar();
}

}  // namespace pliant::viewer
