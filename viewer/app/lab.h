// The lab: one frame of its window, whoever makes the GL context.
#pragma once
#include "app/deck_keys.h"
#include "app/lab_state.h"
#include "app/lens.h"
#include "panels/keys.h"
#include "platform/context.h"
#include "platform/gui.h"
#include "session/animation.h"
#include "session/worker.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pliant::viewer {

// How the lab shares a frame between the run and the window.
struct Pace {
    Budget budget = 10;      // of the run
    Real patience_ms = 30;   // that the window waits for the run before it goes on without it
    Real card_after = 0.25;  // s of work, until a card tells of it
};

class Lab {
public:
    // The context is current and outlives the lab.
    explicit Lab(Context& context, std::string_view lesson = "mesh/mass_spring");

    LabState& state() { return state_; }
    const LabState& state() const { return state_; }
    Session& session() { return state_.session; }

    // Takes effect with the next frame.
    void set_theme(Theme theme);
    void set_scale(float scale);  // clamped to 1 to 3
    void set_layout(Layout layout);
    // The walkthrough of the lesson in the deck, from its first slide unless it plays already. Stays where it is, with a message,
    // when the lesson has none.
    void open_deck();
    // Shows a lecture in the deck, from this slide on, counted from 0.
    void open_lecture(Lecture lecture, std::size_t slide = 0);
    bool in_deck() const { return state_.layout == Layout::deck && state_.session.walkthrough; }
    void perform(Action action);
    // As a file dropped on the window: a scene, a lecture, or what a parameter of the lesson takes. What is wrong with it becomes
    // a message.
    void drop_file(const std::string& path);
    // All that is shown as a scene, and a scene that is opened in its place. What is wrong with a scene throws Refused; while a
    // frame is drawn the scene is opened behind it, and an error becomes a message.
    SceneFile scene_file() const;
    void open_scene(const SceneFile& scene);
    // Opens a scene file and remembers it, or a lecture. Throws Refused.
    void open_file(const std::string& path);
    // What is noted to be handed in is kept in this file from now on, and what it holds is gone on with.
    void keep_hand_in(const std::string& path);
    // Writes the scene to a file and remembers it. Throws Refused.
    void save_file(const std::string& path);

    // Has something come from outside that no frame has seen?
    bool has_input() const { return gui_.has_input(); }
    // s from the last frame until the lab shows something else by itself; infinity when it does not.
    Real next_change() const;

    // From now on no frame moves the run by more than the budget.
    void keep_pace(const Pace& pace);
    // The same, and the run is moved in a thread of its own, so that no frame waits for it.
    void work_beside(const Pace& pace);
    // The worker has the run: nothing of the session, nor of what its work touches, may be looked at.
    bool busy() const { return worker_ && worker_->busy(); }
    const Worker* worker() const { return worker_.get(); }
    bool card_shows() const;
    // Of the card, px; empty while the work cannot be cancelled.
    std::optional<Rectangle> cancel_button() const;
    long busy_frames() const { return busy_frames_; }  // drawn with the card
    // Ends what is under way.
    void call_off();

    // Moves the run, and builds and draws a frame. dt: wall time since the last one, s; with 0 nothing moves. While the worker
    // has the run the last frame is drawn again, with its card; false when nothing was drawn.
    bool frame(Real dt);

private:
    // A part of the framebuffer to be saved once no dialog covers it.
    struct Capture {
        bool whole = false;
        std::string path;
        int frames = 2;            // to wait
        bool to_notebook = false;  // in place of a file
    };

    void fit_scale();
    float gui_height() const;
    void restyle();
    void clear_window();
    void work(std::function<void()> job);
    bool finished() { return !worker_ || worker_->finished(pace_.patience_ms); }
    void move_run(Real dt);
    void prepare();  // what a frame shows
    void build_frame(Real dt);
    // --- while the worker has the run: lab_busy.cpp ---
    bool draw_busy();
    void take_inputs_of_card();
    void lay_out_card(ImDrawList& draw, const ImVec2& display);
    void draw_layout(float width, float height);
    void filled_layout(float width, float height);
    void show_lab();        // with all its panels
    void lift_black_out();  // where a key or a button was pressed: it does nothing else
    void draw_over_all();   // lens and black-out
    void lab_layout(float width, float height);
    void slide_layout(float width, float height);
    void deck_layout(float width, float height);
    bool digits_choose() const;
    void take_show_of_hands();
    void compare_all_methods();
    bool perform_on_deck(Action action);
    void presenter_layout(float width, float height);
    bool perform_on_run(Action action);
    bool perform_on_walkthrough(Action action);
    bool perform_on_view(Action action);
    bool perform_for_ear_and_hand(Action action);
    void perform_on_files(Action action);
    void do_what_is_wanted();
    void after_frame();

    // --- lectures: lab_lecture.cpp ---
    void follow_lecture();
    bool perform_on_lecture(Action action);
    void ask_for_lecture();
    void open_lecture_file(const std::string& path);
    LectureSlide slide_to_add(Action action) const;
    void add_to_lecture(const LectureSlide& slide);

    // --- scenes: lab_scene.cpp ---
    void show_scene(const SceneFile& scene);
    void show_plots(const SceneFile& scene);
    void show_atlas_of(const SceneAtlas& atlas);
    ScenePlots scene_plots() const;
    std::optional<SceneAtlas> scene_atlas() const;

    // --- files: lab_files.cpp ---
    void ask_to_open();
    void ask_to_save();
    void ask_for_picture(bool whole);
    void ask_for_probes();
    void do_for_hand_in();
    void note_claims();
    std::string name_to_hand_in() const;
    void save_hand_in(const std::string& path);
    void quick_save();
    void tell_notes(const SceneFile& scene);
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
    NextSlide next_slide_;  // of the page of the lecturer, where it is drawn alone
    std::unique_ptr<SceneRenderer> next_renderer_;
    DeckKeys deck_keys_;
    Lens lens_;
    std::optional<Capture> capture_;
    std::string hand_in_path_;  // "" where nothing is kept
    long hand_in_kept_ = 0;     // the changes of the notebook that it holds
    std::optional<Animation> animation_;
    std::string animation_path_;
    std::pair<int, std::size_t> lecture_slide_{-1, 0};  // that has come up: the session's count of openings, and its number
    int file_opening_ = 0;                              // the session's count of openings that state_.file belongs to
    bool restyle_ = true, fonts_loaded_ = false, borders_made_ = false;
    bool run_moved_ = false;  // for the frame that comes
    int unsettled_ = 0;       // frames until ImGui shows all of what has changed
    Pace pace_{.budget = {}};
    struct BusyCard {
        Rectangle card, button;
    } busy_card_;
    long busy_frames_ = 0;
    std::unique_ptr<Worker> worker_;  // last: it ends before what it works on
};

}  // namespace pliant::viewer
