// The lab: one frame of its window, whoever makes the GL context.
#pragma once
#include "app/animation.h"
#include "app/keys.h"
#include "panels/lab_state.h"
#include "platform/context.h"
#include "platform/gui.h"

#include <functional>
#include <optional>
#include <string>

namespace pliant::viewer {

class Lab {
public:
    // The context is current and outlives the lab.
    explicit Lab(Context& context, std::string_view lesson = "mesh/mass_spring");

    LabState& state() { return state_; }
    Session& session() { return state_.session; }

    // Takes effect with the next frame.
    void set_theme(Theme theme);
    void set_scale(float scale);  // clamped to 1 to 3
    void set_layout(Layout layout);
    // The walkthrough of the lesson in the deck, from its first slide unless it plays already. Stays where it is, with a message,
    // when the lesson has none.
    void open_deck();
    bool in_deck() const { return state_.layout == Layout::deck && state_.session.walkthrough; }
    void perform(Action action);
    // As a scene file dropped on the window: what is wrong with it becomes a message.
    void drop_file(const std::string& path);
    // Opens a scene file and remembers it. Throws Refused.
    void open_file(const std::string& path);
    // Writes the scene to a file and remembers it. Throws Refused.
    void save_file(const std::string& path);

    // Builds and draws a frame. dt: wall time since the last one, s; with 0 nothing moves.
    void frame(Real dt);

private:
    // A part of the framebuffer to be saved once no dialog covers it.
    struct Capture {
        bool whole = false;
        std::string path;
        int frames = 2;  // to wait
    };

    void restyle();
    void draw_layout(float width, float height);
    void lab_layout(float width, float height);
    void slide_layout(float width, float height);
    void deck_layout(float width, float height);
    bool perform_on_run(Action action);
    bool perform_on_walkthrough(Action action);
    bool perform_on_view(Action action);
    bool perform_for_ear_and_hand(Action action);
    void perform_on_files(Action action);
    void do_what_is_wanted();
    void after_frame();

    // --- files: lab_files.cpp ---
    void ask_to_open();
    void ask_to_save();
    void ask_for_picture(bool whole);
    void ask_for_probes();
    void quick_save();
    void remember(const std::string& path);
    void forget_file_of_another_scene();
    void copy_share();
    void paste_share();
    void save_plot(const PlotShot& shot);
    void save_svg(const std::string& title, const std::string& svg);
    void capture();
    Image scene_pixels();
    void start_animation();
    void record_animation();
    void tell_written(const std::string& file);
    void write_and_tell(const std::string& file, const std::function<void()>& write);

    Context& context_;
    Gui gui_;
    SceneRenderer renderer_;
    LabState state_;
    std::optional<PlotShot> plot_to_save_;
    Rectangle deck_picture_;  // where the deck's picture was in the last frame
    std::optional<Capture> capture_;
    std::optional<Animation> animation_;
    std::string animation_path_;
    int file_opening_ = 0;  // the session's count of openings that state_.file belongs to
    bool restyle_ = true, fonts_loaded_ = false;
};

}  // namespace pliant::viewer
