// The lab: one frame of its window, whoever makes the GL context.
#pragma once
#include "app/keys.h"
#include "panels/lab_state.h"
#include "platform/context.h"
#include "platform/gui.h"

#include <functional>

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
    void drop_file(const std::string& path);

    // Builds and draws a frame. dt: wall time since the last one, s; with 0 nothing moves.
    void frame(Real dt);

private:
    void restyle();
    void draw_layout(float width, float height);
    void lab_layout(float width, float height);
    void slide_layout(float width, float height);
    void deck_layout(float width, float height);
    void save_scene();
    void save_plot(const PlotShot& shot);
    void write_and_tell(const std::string& file, const std::function<void()>& write);

    Context& context_;
    Gui gui_;
    SceneRenderer renderer_;
    LabState state_;
    std::optional<PlotShot> plot_to_save_;
    Rectangle deck_picture_;  // where the deck's picture was in the last frame
    bool restyle_ = true, fonts_loaded_ = false;
};

}  // namespace pliant::viewer
