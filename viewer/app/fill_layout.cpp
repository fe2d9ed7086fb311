// One panel in the place of the layout, under a line that says what is open.
#include "app/lab.h"
#include "app/presenter_view.h"
#include "panels/scene_matrices.h"
#include "panels/scene_messages.h"
#include "panels/typeset_text.h"

#include <utility>

namespace pliant::viewer {
namespace {

// What is drawn for a lecture hall is drawn as on a slide.
class AsOnSlide {
public:
    explicit AsOnSlide(PanelContext& lab) : lab_(lab), layout_(lab.layout) {
        if (layout_ == Layout::lab) lab.layout = Layout::slide;
    }
    ~AsOnSlide() { lab_.layout = layout_; }
    AsOnSlide(const AsOnSlide&) = delete;
    AsOnSlide& operator=(const AsOnSlide&) = delete;

private:
    PanelContext& lab_;
    Layout layout_;
};

void draw_line_of_filled(LabState& lab) {
    const auto& player = lab.session.walkthrough;
    const std::string title =
        lab.layout == Layout::deck && player ? player->slide().title : std::string(lab.session.entry().info.title);
    const float button = ImGui::GetFrameHeight(), right = ImGui::GetContentRegionMax().x - button;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    fitted_sentence(lab, title, right - ImGui::GetCursorPosX() - lab.px(20));
    ImGui::PopStyleColor();
    ImGui::SameLine(right);
    if (ImGui::Button("×", {button, button})) lab.fill = {};
    lab.note_control("fill back");
    tooltip("Back (X or Escape)", lab.scale);
}

}  // namespace

void Lab::filled_layout(float width, float height) {
    LabState& s = state_;
    const float head = ImGui::GetFrameHeight() + s.px(8);
    const int flags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground;
    const Filled what = s.fill.what;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {s.px(10), s.px(4)});
        const FixedPanel panel("Filled line", {0, 0, width, head}, flags | ImGuiWindowFlags_NoNavInputs);
        ImGui::PopStyleVar();
        draw_line_of_filled(s);
    }
    const Rectangle place{0, head, width, height - head};
    const bool whole = what == Filled::picture || what == Filled::matrix;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, whole ? ImVec2{0, 0} : ImVec2{s.px(14), s.px(6)});
    {
        const FixedPanel panel("Filled", place, what == Filled::atlas ? 0 : flags | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        if (what == Filled::picture) {
            const AsOnSlide as(s);
            draw_scene(s, s.scene, renderer_);
        }
        if (what == Filled::matrix) draw_filled_matrices(s);
        if (what == Filled::plot) draw_filled_plot(s, s.plots);
        if (what == Filled::atlas) draw_atlas(s, s.atlas);
        s.controls["filled"] = place;
        if (what != Filled::picture) draw_banner(s, place), draw_autopsy(s, s.scene, place);
    }
    ImGui::PopStyleVar();
}

// Without the clock, so that one picture of it is like another.
void Lab::presenter_layout(float width, float height) {
    const FixedPanel panel("Presenter", {0, 0, width, height}, ImGuiWindowFlags_NoScrollbar);
    next_slide_.make_now(state_.session);
    if (!next_renderer_) next_renderer_ = std::make_unique<SceneRenderer>();
    const PresenterPage page{state_.fonts,    state_.theme,           state_.scale,
                             state_.controls, &next_slide_.preview(), next_renderer_.get()};
    draw_presenter(page, presenter_view(state_), {}, "");
}

}  // namespace pliant::viewer
