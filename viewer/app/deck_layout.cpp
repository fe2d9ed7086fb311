#include "app/deck_layout.h"

#include "app/lab.h"
#include "app/lecture_slide.h"
#include "panels/colour_bar.h"
#include "panels/deck_panel.h"
#include "panels/headline.h"
#include "render/framing.h"

#include <algorithm>
#include <vector>

namespace pliant::viewer {
namespace {

constexpr float words_part = 0.36f, plots_part = 0.23f;  // of the width
constexpr float row_part = 0.36f;                        // of the height below the title, for plots in a row
constexpr float most_for_sliders = 0.45f;                // likewise
constexpr float rows_gain = 1.08f;                       // a scene this much larger is worth the other arrangement

// How large the scene is in the picture: px per metre, in 3D up to a factor.
Real size_of_scene(const LabState& lab, const Rectangle& picture) {
    const ColourBarPlace bar = colour_bar_place(lab, picture.width);
    const float width = picture.width - bar.right, height = picture.height - bar.below;
    if (width < 1 || height < 1) return 0;
    return height / framing(lab.session.viewpoint.frame(), width / height).distance;
}

// The sliders below the words, which keep the size of their type.
bool sliders_fit_below_words(const LabState& lab, const Rectangle& words, float sliders) {
    const float x = 2 * lab.px(20), y = 2 * lab.px(10);
    const auto type = slide_words_type(lab, {words.width - x, words.height - sliders - y});
    return type && type == slide_words_type(lab, {words.width - x, words.height - y});
}

DeckPlaces with_plots_beside(DeckPlaces p, const LabState& lab, const Rectangle& room, float width) {
    const float right = width * plots_part, numbers = slide_has_plots(lab) ? lab.px(172) : room.height;
    p.picture = {room.x, room.y, room.width - right, room.height};
    p.plots = {room.x + p.picture.width, room.y, right, room.height - numbers};
    p.numbers = {p.plots.x, room.y + p.plots.height, right, numbers};
    return p;
}

DeckPlaces with_plots_below(DeckPlaces p, const LabState& lab, const Rectangle& room, float width) {
    const float row = std::max(row_part * room.height, lab.px(190)), numbers = std::max(lab.px(200), 0.16f * width);
    p.plots_in_row = true;
    p.picture = {room.x, room.y, room.width, room.height - row};
    p.plots = {room.x, room.y + p.picture.height, room.width - numbers, row};
    p.numbers = {room.x + p.plots.width, p.plots.y, numbers, row};
    return p;
}

}  // namespace

DeckPlaces deck_places(const LabState& lab, float width, float height) {
    DeckPlaces p;
    // The audience never sees the notes while the lecturer has a window for them.
    const bool notes_here = lab.notes_shown && !lab.presenter.wanted;
    const float head = lab.px(64), notes = notes_here ? std::min(slide_notes_height(lab, width), height / 4) : 0,
                body = height - head - notes, left = slide_has_words(lab) ? width * words_part : 0;
    p.title = {0, 0, width, head};
    p.notes = {0, head + body, width, notes};
    p.words = {0, head, left, body};
    if (shown_by_slide(lab) != ShownBySlide::run) {
        place_without_run(lab, p, {0, head, width, body});
        return p;
    }
    const float sliders = std::min(slide_parameters_height(lab), body * most_for_sliders);
    const Rectangle room{left, head, width - left, body};
    if (sliders > 0 && sliders_fit_below_words(lab, p.words, sliders)) {
        p.words.height -= sliders;
        p.parameters = {0, head + p.words.height, left, sliders};
    }
    DeckPlaces beside = with_plots_beside(p, lab, room, width), below = with_plots_below(p, lab, room, width);
    if (sliders > 0 && p.parameters.height == 0)
        for (DeckPlaces* places : {&beside, &below}) {
            places->picture.height -= sliders;
            places->parameters = {left, places->picture.y + places->picture.height, places->picture.width, sliders};
        }
    return slide_has_plots(lab) && size_of_scene(lab, below.picture) > rows_gain * size_of_scene(lab, beside.picture) ? below
                                                                                                                      : beside;
}

void Lab::deck_layout(float width, float height) {
    LabState& s = state_;
    const DeckPlaces places = deck_places(s, width, height);
    const int flags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNavInputs;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {s.px(20), s.px(10)});
    {
        const FixedPanel panel("Slide title", places.title, flags);
        draw_slide_title(s);
    }
    if (places.words.width > 0) {
        const FixedPanel panel("Slide words", places.words, flags);
        draw_slide_words(s);
    }
    if (places.parameters.height > 0) {
        // Tab goes to the sliders, whatever was clicked before.
        const bool busy =
            s.session.autopsy() || ImGui::IsAnyItemActive() || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
        if (!busy) ImGui::SetNextWindowFocus();
        const FixedPanel panel("Slide parameters", places.parameters, ImGuiWindowFlags_NoBackground);
        draw_slide_parameters(s, s.parameters);
    }
    if (places.notes.height > 0) {
        const FixedPanel panel("Slide notes", places.notes);
        draw_slide_notes(s);
    }
    ImGui::PopStyleVar();
    if (shown_by_slide(s) != ShownBySlide::run) {
        if (places.other.height > 0) {
            ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {s.px(20), s.px(10)});
            const FixedPanel panel("Shown by slide", places.other, ImGuiWindowFlags_NoBackground);
            ImGui::PopStyleVar();
            draw_shown_by_slide(s);
        }
        return ImGui::PopStyleVar();
    }
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
        const FixedPanel panel("Scene", places.picture, flags | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        draw_scene(s, s.scene, renderer_);
    }
    if (slide_has_plots(s)) {
        const FixedPanel panel("Plots", places.plots, flags);
        places.plots_in_row ? draw_plots_in_row(s, s.plots) : draw_plots(s, s.plots);
    }
    {
        const FixedPanel panel("Numbers", places.numbers, flags);
        draw_key_numbers(s);
    }
    ImGui::PopStyleVar();
}

}  // namespace pliant::viewer
