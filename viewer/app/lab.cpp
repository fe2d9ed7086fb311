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
            set_layout(Layout::lab), state_.focus_search = true;
            break;
        case Action::hide_panels:
            set_layout(state_.layout == Layout::lab ? Layout::slide : Layout::lab);
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
        case Action::deck:
            in_deck() ? set_layout(Layout::lab) : open_deck();
            break;
        case Action::leave_deck:
            set_layout(Layout::lab);
            break;
        case Action::reset_slide:
            s.reset_slide();
            break;
        case Action::first_slide:
            s.go_to_slide(0);
            break;
        case Action::last_slide:
            s.go_to_slide(s.walkthrough->walkthrough().slides.size() - 1);
            break;
        case Action::unlock:
            s.toggle_lock();
            break;
        case Action::notes:
            state_.notes_shown = !state_.notes_shown;
            break;
        case Action::save:
            save_scene();
            break;
        case Action::frame:
            s.camera.reset();
            break;
        case Action::pin:
            s.toggle_pin();
            break;
        case Action::beside:
            s.toggle_companion();
            break;
        case Action::address_a:
        case Action::address_b:
            s.address(action == Action::address_b);
            break;
        case Action::difference:
            s.show_difference(!s.shows_difference());
            break;
        case Action::cost:
            state_.cost_shown = !state_.cost_shown;
            break;
    }
}

void Lab::set_layout(Layout layout) {
    if (std::exchange(state_.layout, layout) != layout) state_.session.camera.reset();
}

void Lab::open_deck() {
    if (!state_.session.walkthrough) state_.session.start_walkthrough();
    if (state_.session.walkthrough) set_layout(Layout::deck);
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
// What a key of the lab does, it does not do to the focus as well: Tab hides the panels, and in the deck, where Tab goes through
// the sliders, the arrows turn the slides.
void release_keys(bool deck) {
    if (ImGui::GetIO().WantTextInput || ImGui::IsAnyItemActive()) return;
    const auto cancel_on = [](std::initializer_list<ImGuiKey> keys) {
        if (std::ranges::any_of(keys, [](ImGuiKey k) { return ImGui::IsKeyPressed(k); })) ImGui::NavMoveRequestCancel();
    };
    deck ? cancel_on({ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_PageUp, ImGuiKey_PageDown, ImGuiKey_Home, ImGuiKey_End})
         : cancel_on({ImGuiKey_Tab});
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
    if (state_.layout == Layout::deck && !state_.session.walkthrough) set_layout(Layout::lab);  // another scene was opened
    release_keys(in_deck());
    state_.session.update(dt);
    handle_keys({.walkthrough = state_.session.walkthrough.has_value(), .deck = in_deck()}, [this](Action a) { perform(a); });
    ImGui::PushFont(state_.fonts.normal);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    draw_layout(display.x, display.y);
    if (state_.help_shown) draw_help(state_);
    ImGui::PopFont();
    gui_.end_frame();
    if (const auto shot = std::exchange(plot_to_save_, std::nullopt)) save_plot(*shot);
}

}  // namespace pliant::viewer
