#include "app/lab.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include "app/presenter_view.h"
#include "panels/animation_panel.h"
#include "panels/file_dialog.h"
#include "panels/focus.h"
#include "panels/held_numbers.h"
#include "panels/help_panel.h"
#include "platform/gl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pliant::viewer {

Lab::Lab(Context& context, std::string_view lesson) : context_(context), gui_(context), state_{{.session = Session(lesson)}} {
    state_.plots.hooks.save_png = [this](const PlotShot& shot) { plot_to_save_ = shot; };
    state_.plots.hooks.save_svg = [this](const std::string& title, const std::string& svg) { save_svg(title, svg); };
}

void Lab::set_theme(Theme theme) {
    state_.theme = theme;
    restyle_ = true;
}

void Lab::set_scale(float scale) {
    state_.ui_scale = std::clamp(scale, 1.f, 3.f);
    fit_scale();
}

// What is shown to a hall is read from the last row: its type follows the height of the picture, in steps of an eighth, lest the
// typefaces be made again for every pixel of a window that is dragged.
void Lab::fit_scale() {
    constexpr float height_at_1 = 720;  // px
    float wanted = state_.ui_scale;
    if (state_.layout == Layout::deck) wanted = std::max(wanted, std::floor(8 * gui_height() / height_at_1) / 8);
    wanted = std::clamp(wanted, 1.f, 3.f);
    if (std::exchange(state_.scale, wanted) == wanted && fonts_loaded_) return;
    fonts_loaded_ = false;
    restyle_ = true;
}

// Of the window, in the px that panels are laid out in.
float Lab::gui_height() const {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    return display.y > 0 ? display.y : static_cast<float>(context_.framebuffer_size().height);
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

void Lab::set_layout(Layout layout) { state_.layout = layout; }

void Lab::open_deck() {
    state_.session.later([this] {
        if (!state_.session.walkthrough) state_.session.start_walkthrough();
        if (!state_.session.walkthrough) return;
        state_.session.compare(Compare::now);  // what a stage changed was looked at in the lab
        set_layout(Layout::deck);
    });
}

void Lab::clear_window() {
    const Size size = context_.framebuffer_size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    const Rgba8 b = palette(state_.theme).background;
    glClearColor(b.r / 255.f, b.g / 255.f, b.b / 255.f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Lab::move_run(Real dt) {
    Session& s = state_.session;
    animation_ && !animation_->complete() ? animation_->advance(s) : s.update(dt, pace_.budget);
    prepare();
}

void Lab::prepare() {
    state_.session.prepare_pictures();
    measure_held_numbers(state_);
}

bool Lab::frame(Real dt) {
    constexpr int frames_to_settle = 3;
    lift_black_out();
    if (!finished()) return unsettled_ = frames_to_settle, draw_busy();
    if (!std::exchange(run_moved_, true)) {
        work([this, dt] { move_run(dt); });
        if (!finished()) return draw_busy();
    }
    run_moved_ = false;
    Session& s = state_.session;
    {
        const Session::Held held(s);
        build_frame(dt);
    }
    unsettled_ = std::max(0, unsettled_ - 1);
    if (s.anything_waits()) {
        unsettled_ = frames_to_settle;
        work([this] {
            state_.session.do_waiting();
            prepare();
        });
        finished();
    }
    return true;
}

void Lab::build_frame(Real dt) {
    fit_scale();
    if (restyle_) restyle();
    state_.seconds = dt;
    for (const std::string& path : context_.take_dropped_files()) drop_file(path);
    clear_window();

    gui_.begin_frame(dt > 0 ? dt : 1.0 / 60);
    state_.cut.clear();
    deck_keys_.begin_frame(in_deck(), state_.session.autopsy().has_value());
    state_.claims.book.update();
    state_.atlas.atlas.follow(state_.session);
    follow_lecture();
    state_.methods.table.follow(state_.session);
    const Session& s = state_.session;
    if (!state_.files.asking() && !state_.animation.asking) take_show_of_hands();
    if (!state_.files.asking() && !state_.animation.asking)
        handle_keys(
            {.walkthrough = state_.session.walkthrough.has_value(),
             .deck = in_deck(),
             .slide = state_.layout == Layout::slide,
             .message = s.message() || s.autopsy() || !state_.summary.text.empty() || state_.help_shown || state_.hand_in.shown,
             .filled = static_cast<bool>(state_.fill),
             .ring_has_space = deck_keys_.ring_has_space(),
             .window_over = state_.hand_in.has_keys},
            [this](Action a) { perform(a); });
    forget_file_of_another_scene();
    ImGui::PushFont(state_.fonts.normal);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    if (state_.layout == Layout::deck && !state_.session.walkthrough) set_layout(Layout::lab);  // another scene was opened
    draw_layout(display.x, display.y);
    state_.plots.memory.save_all_svg = false;
    draw_help(state_, state_.help, state_.help_shown);
    draw_summary(state_, state_.summary);
    draw_hand_in(state_, state_.hand_in);
    draw_file_dialog(state_, state_.file_dialog);
    draw_animation_panel(state_);
    draw_focus(state_);
    draw_over_all();
    if (state_.presenter.wanted) state_.presenter.view = presenter_view(state_);
    state_.full_screen = context_.full_screen();
    do_what_is_wanted();
    ImGui::PopFont();
    deck_keys_.end_frame(in_deck());
    gui_.end_frame();
    after_frame();
}

Real Lab::next_change() const {
    constexpr Real progress_seconds = 0.1;
    if (busy()) return card_shows() ? progress_seconds / 2 : 0;
    const LabState& l = state_;
    const bool moves = l.session.under_way() || (!l.session.camera && l.session.viewpoint.moving()) ||
                       (l.plots.cost_shown && l.live_error.catching_up(l.session.runner()));
    const bool ordered = unsettled_ > 0 || restyle_ || capture_ || plot_to_save_ || animation_ || !l.wanted.empty() ||
                         !l.wanted_scenes.empty() || !l.wanted_files.empty();
    if (moves || ordered) return 0;
    return std::min(gui_.next_blink(), l.claims.book.busy() || l.atlas.atlas.busy() || l.methods.table.busy()
                                           ? progress_seconds
                                           : std::numeric_limits<Real>::infinity());
}

void Lab::do_what_is_wanted() {
    for (const Action action : std::exchange(state_.wanted, {})) perform(action);
    for (const SceneFile& scene : std::exchange(state_.wanted_scenes, {})) open_scene(scene);
    for (const std::string& path : std::exchange(state_.wanted_files, {})) drop_file(path);
    if (const std::string lecture = std::exchange(state_.wanted_lecture, ""); !lecture.empty())
        open_lecture(read_lecture(lecture));
    if (!state_.animation.path.empty()) start_animation();
    do_for_hand_in();
}

// What needs the pixels of the frame.
void Lab::after_frame() {
    if (const auto shot = std::exchange(plot_to_save_, std::nullopt)) save_plot(*shot);
    if (capture_ && --capture_->frames < 0) capture();
    if (animation_) record_animation();
}

}  // namespace pliant::viewer
