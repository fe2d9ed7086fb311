#include "app/lab.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include "panels/file_dialog.h"
#include "platform/gl.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {

Lab::Lab(Context& context, std::string_view lesson)
    : context_(context),
      gui_(context),
      state_{.session = Session(lesson), .fonts = {}, .search = {}, .plots = {}, .hovered = {}, .pulling = {}, .controls = {}} {
    state_.plots.hooks.save_png = [this](const PlotShot& shot) { plot_to_save_ = shot; };
    state_.plots.hooks.save_svg = [this](const std::string& title, const std::string& svg) { save_svg(title, svg); };
}

void Lab::set_theme(Theme theme) {
    state_.theme = theme;
    restyle_ = true;
}

void Lab::set_scale(float scale) {
    state_.scale = std::clamp(scale, 1.f, 3.f);
    fonts_loaded_ = false;
    restyle_ = true;
}

void Lab::restyle() {
    if (!fonts_loaded_) {
        state_.fonts = load_fonts(state_.scale);
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
        fonts_loaded_ = true;
    }
    apply_theme(state_.theme, state_.scale);
    restyle_ = false;
}

void Lab::perform(Action action) {
    if (!perform_on_run(action) && !perform_on_view(action)) perform_on_files(action);
}

// True when the action was one of these.
bool Lab::perform_on_run(Action action) {
    Session& s = state_.session;
    switch (action) {
        case Action::play:
            return s.toggle_play(), true;
        case Action::step:
            return s.step(), true;
        case Action::step_back:
            return s.step_back(), true;
        case Action::stage:
            return s.step_stage(), true;
        case Action::stage_back:
            return s.stage_back(), true;
        case Action::pass:
            return s.step_pass(), true;
        case Action::reset:
            return s.reset(), true;
        case Action::previous_lesson:
            return s.open_next(-1), true;
        case Action::next_lesson:
            return s.open_next(1), true;
        case Action::undo:
            return s.undo(), true;
        case Action::defaults:
            return s.restore_defaults(), true;
        case Action::walkthrough_next:
            return s.walkthrough ? s.walkthrough_next() : s.start_walkthrough(), true;
        case Action::walkthrough_back:
            return s.walkthrough_back(), true;
        default:
            return false;
    }
}

bool Lab::perform_on_view(Action action) {
    Session& s = state_.session;
    switch (action) {
        case Action::find:
            state_.layout = Layout::lab, state_.focus_search = true;
            return true;
        case Action::hide_panels:
            state_.layout = state_.layout == Layout::lab ? Layout::slide : Layout::lab, s.camera.reset();
            return true;
        case Action::menu:
            if (state_.layout == Layout::slide) state_.layout = Layout::lab, s.camera.reset();
            return state_.focus_menu = true;
        case Action::help:
            state_.help_shown = !state_.help_shown;
            return true;
        case Action::extreme:
            s.extreme = !s.extreme;
            return true;
        case Action::arrows:
            s.show_arrows = !s.show_arrows;
            return true;
        case Action::theme:
            return set_theme(state_.theme == Theme::dark ? Theme::projector : Theme::dark), true;
        case Action::larger:
            return set_scale(state_.scale + 0.25f), true;
        case Action::smaller:
            return set_scale(state_.scale - 0.25f), true;
        case Action::frame:
            return s.camera.reset(), true;
        default:
            return false;
    }
}

namespace {
// Tab hides the panels here, so it does not move the focus as well.
void release_tab() {
    if (ImGui::IsKeyPressed(ImGuiKey_Tab) && !ImGui::GetIO().WantTextInput) ImGui::NavMoveRequestCancel();
}
}  // namespace

void Lab::frame(Real dt) {
    if (restyle_) restyle();
    for (const std::string& path : context_.take_dropped_files()) drop_file(path);
    const Size size = context_.framebuffer_size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    const Rgba8 b = palette(state_.theme).background;
    glClearColor(b.r / 255.f, b.g / 255.f, b.b / 255.f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    gui_.begin_frame(dt > 0 ? dt : 1.0 / 60);
    release_tab();
    animation_ && !animation_->complete() ? animation_->advance(state_.session) : state_.session.update(dt);
    if (!state_.files.asking() && !state_.animation.asking) handle_keys([this](Action a) { perform(a); });
    forget_file_of_another_scene();
    ImGui::PushFont(state_.fonts.normal);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    state_.layout == Layout::lab ? lab_layout(display.x, display.y) : slide_layout(display.x, display.y);
    state_.plots.memory.save_all_svg = false;
    if (state_.help_shown) draw_help(state_);
    draw_file_dialog(state_);
    draw_animation_panel(state_);
    do_what_is_wanted();
    ImGui::PopFont();
    gui_.end_frame();
    after_frame();
}

void Lab::do_what_is_wanted() {
    for (const Action action : std::exchange(state_.wanted, {})) perform(action);
    for (const std::string& path : std::exchange(state_.wanted_files, {})) drop_file(path);
    if (!state_.animation.path.empty()) start_animation();
}

// What needs the pixels of the frame.
void Lab::after_frame() {
    if (const auto shot = std::exchange(plot_to_save_, std::nullopt)) save_plot(*shot);
    if (capture_ && --capture_->frames < 0) capture();
    if (animation_) record_animation();
}

void Lab::lab_layout(float width, float height) {
    LabState& s = state_;
    draw_menu_bar(s);
    const float top = ImGui::GetFrameHeight();
    const float status = ImGui::GetFrameHeight() + s.px(8), left = std::min(s.px(238), width * 0.28f);
    const float right = std::min(s.px(s.session.walkthrough ? 370 : 330), width * 0.32f), middle = width - left - right,
                body = height - status - top;
    const float list =
        std::min(body * 0.36f, s.px(40) + static_cast<float>(lessons().size() + 6) * ImGui::GetTextLineHeightWithSpacing());
    const float bars =
        ImGui::GetFrameHeight() + s.px(stage_height) + 2 * ImGui::GetStyle().WindowPadding.y + ImGui::GetStyle().ItemSpacing.y;
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
        draw_plots(s);
    } else {
        const FixedPanel panel("Plots", {width - right, top, right, body});
        draw_plots(s);
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

}  // namespace pliant::viewer
