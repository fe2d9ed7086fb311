// Where the panels of the lab stand, in each of its layouts.
#include "app/lab.h"

#include <algorithm>

namespace pliant::viewer {

void Lab::draw_layout(float width, float height) {
    switch (state_.layout) {
        case Layout::lab:
            return lab_layout(width, height);
        case Layout::slide:
            return slide_layout(width, height);
        case Layout::deck:
            return deck_layout(width, height);
    }
}

void Lab::lab_layout(float width, float height) {
    LabState& s = state_;
    draw_menu_bar(s);
    const float top = ImGui::GetFrameHeight();
    const float status = ImGui::GetFrameHeight() + s.px(8), left = std::min(s.px(238), width * 0.28f);
    const float right = std::min(s.px(s.session.walkthrough ? 370 : 330), width * 0.32f), middle = width - left - right,
                body = height - status - top;
    const float list =
        std::min(body * 0.42f, s.px(40) + static_cast<float>(lessons().size() + 6) * ImGui::GetTextLineHeightWithSpacing());
    const float bars = 2 * ImGui::GetFrameHeight() + s.px(stage_height) + 2 * ImGui::GetStyle().WindowPadding.y +
                       2 * ImGui::GetStyle().ItemSpacing.y;
    {
        const FixedPanel panel("Lessons", {0, top, left, list});
        draw_lesson_list(s);
    }
    {
        const FixedPanel panel("Parameters", {0, top + list, left, body - list});
        draw_parameters(s);
    }
    {
        const FixedPanel panel("Stages", {left, top, middle, bars}, ImGuiWindowFlags_NoScrollbar);
        draw_transport(s);
        draw_stage_bar(s);
        draw_timeline(s);
    }
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
        const FixedPanel panel("Scene", {left, top + bars, middle, body - bars},
                               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        draw_scene(s, renderer_);
    }
    if (s.session.walkthrough) {
        const float split = body * 0.58f;
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
    const float head = s.px(78), right = std::max(s.px(300), width * 0.32f), numbers = s.px(158);
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
        draw_scene(s, renderer_);
    }
    {
        const FixedPanel panel("Plots", {width - right, head, right, height - head - numbers}, flags);
        draw_plots(s);
    }
    {
        const FixedPanel panel("Numbers", {width - right, height - numbers, right, numbers}, flags);
        draw_key_numbers(s);
    }
    ImGui::PopStyleVar();
}

void Lab::deck_layout(float width, float height) {
    LabState& s = state_;
    const int flags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNavInputs;
    const float head = s.px(64), notes = s.notes_shown ? std::min(slide_notes_height(s, width), height / 4) : 0,
                body = height - head - notes, left = width * 0.36f, right = width * 0.23f, middle = width - left - right,
                numbers = s.px(172), sliders = std::clamp(slide_parameters_height(s), s.px(10), body * 0.45f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {s.px(20), s.px(10)});
    {
        const FixedPanel panel("Slide title", {0, 0, width, head}, flags);
        draw_slide_title(s);
    }
    {
        const FixedPanel panel("Slide words", {0, head, left, body}, flags);
        draw_slide_words(s);
    }
    if (slide_parameters_height(s) > 0) {
        // Tab goes to the sliders, whatever was clicked before.
        const bool busy =
            s.session.autopsy() || ImGui::IsAnyItemActive() || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
        if (!busy) ImGui::SetNextWindowFocus();
        const FixedPanel panel("Slide parameters", {left, head + body - sliders, middle, sliders}, ImGuiWindowFlags_NoBackground);
        draw_slide_parameters(s);
    }
    if (notes > 0) {
        const FixedPanel panel("Slide notes", {0, head + body, width, notes});
        draw_slide_notes(s);
    }
    ImGui::PopStyleVar();
    const Rectangle picture{left, head, middle, body - sliders};
    // A slide with other sliders leaves the picture another place: it is framed for that.
    if (picture.width != deck_picture_.width || picture.height != deck_picture_.height) s.session.camera.reset();
    deck_picture_ = picture;
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
        const FixedPanel panel("Scene", picture, flags | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        draw_scene(s, renderer_);
    }
    {
        const FixedPanel panel("Plots", {width - right, head, right, body - numbers}, flags);
        draw_plots(s);
    }
    {
        const FixedPanel panel("Numbers", {width - right, head + body - numbers, right, numbers}, flags);
        draw_key_numbers(s);
    }
    ImGui::PopStyleVar();
}

}  // namespace pliant::viewer
