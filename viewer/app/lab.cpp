#include "app/lab.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>
#include <pliant/lesson/file.h>

#include "platform/gl.h"
#include "platform/image.h"
#include "platform/png_file.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {

namespace {
// "Kinetic energy" as the name of a file.
std::string file_name(std::string_view title, std::string_view ending) {
    std::string name;
    for (const char c : title) name += c == ' ' || c == '/' ? '_' : c;
    return name + std::string(ending);
}
}  // namespace

Lab::Lab(Context& context, std::string_view lesson)
    : context_(context),
      gui_(context),
      state_{.session = Session(lesson), .fonts = {}, .search = {}, .plots = {}, .hovered = {}, .pulling = {}, .controls = {}} {}

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
    Session& s = state_.session;
    switch (action) {
        case Action::play:
            s.toggle_play();
            break;
        case Action::step:
            s.step();
            break;
        case Action::step_back:
            s.step_back();
            break;
        case Action::stage:
            s.step_stage();
            break;
        case Action::stage_back:
            s.stage_back();
            break;
        case Action::pass:
            s.step_pass();
            break;
        case Action::reset:
            s.reset();
            break;
        case Action::previous_lesson:
            s.open_next(-1);
            break;
        case Action::next_lesson:
            s.open_next(1);
            break;
        case Action::find:
            state_.layout = Layout::lab, state_.focus_search = true;
            break;
        case Action::hide_panels:
            state_.layout = state_.layout == Layout::lab ? Layout::slide : Layout::lab, s.camera.reset();
            break;
        case Action::help:
            state_.help_shown = !state_.help_shown;
            break;
        case Action::undo:
            s.undo();
            break;
        case Action::extreme:
            s.extreme = !s.extreme;
            break;
        case Action::arrows:
            s.show_arrows = !s.show_arrows;
            break;
        case Action::theme:
            set_theme(state_.theme == Theme::dark ? Theme::projector : Theme::dark);
            break;
        case Action::larger:
            set_scale(state_.scale + 0.25f);
            break;
        case Action::smaller:
            set_scale(state_.scale - 0.25f);
            break;
        case Action::walkthrough_next:
            s.walkthrough ? s.walkthrough_next() : s.start_walkthrough();
            break;
        case Action::walkthrough_back:
            s.walkthrough_back();
            break;
        case Action::save:
            save_scene();
            break;
        case Action::frame:
            s.camera.reset();
            break;
    }
}

void Lab::write_and_tell(const std::string& file, const std::function<void()>& write) {
    Session& s = state_.session;
    try {
        write();
        s.say(Session::Message::Kind::info, "Saved as " + file + " in the folder where Pliant was started.");
    } catch (const Error& e) {
        s.say(Session::Message::Kind::refused, e.what());
    }
}

void Lab::save_scene() {
    const std::string_view id = state_.session.entry().info.id;
    const std::string name = file_name(id.substr(id.find('/') + 1), ".scene.json");
    write_and_tell(name, [&] { write_file(name, scene_text(state_.session.scene_file())); });
}

void Lab::save_plot(const PlotShot& shot) {
    const std::string name = file_name(shot.title, ".png");
    write_and_tell(name, [&] { write_png(crop(read_pixels(context_), shot.left, shot.top, shot.width, shot.height), name); });
}

void Lab::drop_file(const std::string& path) {
    try {
        state_.session.open_scene(read_scene(path));
    } catch (const Error& e) {
        state_.session.say(Session::Message::Kind::refused, e.what());
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
    state_.session.update(dt);
    handle_keys([this](Action a) { perform(a); });
    ImGui::PushFont(state_.fonts.normal);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    state_.layout == Layout::lab ? lab_layout(display.x, display.y) : slide_layout(display.x, display.y);
    if (state_.help_shown) draw_help(state_);
    ImGui::PopFont();
    gui_.end_frame();
    if (const auto shot = std::exchange(plot_to_save_, std::nullopt)) save_plot(*shot);
}

void Lab::lab_layout(float width, float height) {
    LabState& s = state_;
    const float status = ImGui::GetFrameHeight() + s.px(8), left = std::min(s.px(238), width * 0.28f);
    const float right = std::min(s.px(s.session.walkthrough ? 370 : 330), width * 0.32f), middle = width - left - right,
                body = height - status;
    const float list =
        std::min(body * 0.36f, s.px(40) + static_cast<float>(lessons().size() + 6) * ImGui::GetTextLineHeightWithSpacing());
    const float bars =
        ImGui::GetFrameHeight() + s.px(stage_height) + 2 * ImGui::GetStyle().WindowPadding.y + ImGui::GetStyle().ItemSpacing.y;
    {
        const FixedPanel panel("Lessons", {0, 0, left, list});
        draw_lesson_list(s);
    }
    {
        const FixedPanel panel("Parameters", {0, list, left, body - list});
        draw_parameters(s);
    }
    {
        const FixedPanel panel("Stages", {left, 0, middle, bars}, ImGuiWindowFlags_NoScrollbar);
        draw_transport(s);
        draw_stage_bar(s);
    }
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
        const FixedPanel panel("Scene", {left, bars, middle, body - bars},
                               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        draw_scene(s, renderer_);
    }
    if (s.session.walkthrough) {
        const float split = body * 0.58f;
        {
            const FixedPanel panel("Walkthrough", {width - right, 0, right, split});
            draw_walkthrough(s);
        }
        const FixedPanel panel("Plots", {width - right, split, right, body - split});
        draw_plots(s);
    } else {
        const FixedPanel panel("Plots", {width - right, 0, right, body});
        draw_plots(s);
    }
    const FixedPanel panel("Status", {0, body, width, status}, ImGuiWindowFlags_NoScrollbar);
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
