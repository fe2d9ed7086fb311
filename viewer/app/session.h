// What the lab holds: the lesson being run, what the person looks at, and everything that a button, a key or a walkthrough may do
// to it. It draws nothing, so a test can drive it as the window does.
#pragma once
#include <pliant/lesson/recorder.h>
#include <pliant/lesson/runner.h>
#include <pliant/lesson/scene_file.h>
#include <pliant/lesson/texts.h>
#include <pliant/lesson/until.h>
#include <pliant/lesson/walkthrough.h>

#include "app/companion.h"
#include "render/palette.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

// The colours of the picture: a range that stays, and is widened only when the numbers leave it by much.
struct ColourRange {
    bool automatic = true;
    ColourScale scale;
    void update(const std::vector<Real>& values);
    void forget() { fresh_ = true; }

private:
    bool fresh_ = true;  // the next numbers set the range, whatever it was
};

// What is kept of a run to see another one against.
struct Pinned {
    Scene ghost;
    Recorder recorder;
    std::vector<Real> settings;  // in the order of the parameters
    Index step;
    Real time;  // s
};

class Session {
public:
    // Opens a lesson, by default the one that moves most. Throws Refused.
    explicit Session(std::string_view lesson = "mesh/mass_spring");

    // --- lessons and scenes ---
    void open(const LessonEntry& entry, const Runner::Assignments& assignments = {}, std::vector<Event> events = {});
    void open_next(int direction);
    void open_scene(const SceneFile& scene);
    SceneFile scene_file() const;
    const LessonEntry& entry() const { return *entry_; }
    Runner& runner() { return *runner_; }
    const Runner& runner() const { return *runner_; }
    const Lesson& lesson() const { return runner_->lesson(); }
    const Recorder& recorder() const { return recorder_; }
    const CostHistory& costs() const { return costs_; }

    // Counts the runs that began here: a lesson opened, a reset. What was measured before belongs to another run.
    int run_count() const { return run_count_; }

    // --- time ---
    bool playing = false;
    Real speed = 1;  // simulated seconds asked for per second
    // Advances by what `seconds` of wall time ask for, in whole steps, within a budget of `budget_ms`. A slow machine falls
    // behind; Δt never changes.
    void update(Real seconds, Real budget_ms = 12);
    void toggle_play() { playing = !playing; }
    void step();
    void step_stage();
    void run_to_stage(std::string_view name);
    void step_pass();
    void step_back();
    void stage_back();
    void reset();
    // Runs headless, recording every step. Throws Diverged.
    void run(const Until& until);
    // Simulated seconds per second that were reached lately; 0 when paused.
    Real reached_speed() const { return playing ? reached_speed_ : 0; }

    // --- parameters ---
    bool extreme = false;  // sliders span all that the solver accepts
    // A refusal, also of a parameter that the slide locks, becomes a message. Values that follow each other on one parameter
    // within a drag are one undo step.
    void assign(const Parameter& parameter, Real value, bool same_drag = false);
    void restore_default(const Parameter& parameter);
    void undo();
    bool can_undo() const { return !undo_.empty(); }

    // --- the hand ---
    void pull(const std::optional<Pull>& pull);

    // --- view ---
    ColourBy colours;
    ColourRange range;
    bool show_arrows = true, show_labels = true, smooth = true;
    std::optional<Camera> camera;  // framed afresh when empty
    void view_changed();           // after a change of the colours: their range is found again
    // The picture of now.
    Scene scene() const;

    // --- two at once ---
    // Keeps the picture and the recorded numbers of this run, or lets them go.
    void toggle_pin();
    const std::optional<Pinned>& pinned() const { return pinned_; }
    // A second run, B, beside this one, A. Both start again when it is made, and when a change rebuilds one of them.
    void toggle_companion();
    void open_companion(const Runner::Assignments& changes = {});  // throws Refused
    void close_companion();
    const Companion* companion() const { return companion_.get(); }
    // The run whose parameters the sliders set.
    void address(bool b);
    bool addresses_b() const { return addresses_b_; }
    const Runner& addressed() const { return addresses_b_ ? companion_->runner() : *runner_; }
    Scene scene_beside() const;  // of B
    // A − B in place of A, where the field that is shown has as many numbers in both.
    bool has_difference() const;
    void show_difference(bool on);
    bool shows_difference() const { return difference_ && has_difference(); }

    // --- walkthrough ---
    std::optional<WalkthroughPlayer> walkthrough;
    bool unlocked = false;  // whatever the slide locks, until the walkthrough ends
    bool locked(const Parameter& parameter) const;
    void toggle_lock();
    void start_walkthrough();  // from its first slide
    void walkthrough_next();
    void walkthrough_back();
    void go_to_slide(std::size_t n);  // from 0
    void reset_slide();
    void end_walkthrough();  // the run stays as it is

    // --- messages ---
    struct Message {
        enum class Kind { info, refused, diverged } kind;
        std::string text;
    };
    const std::optional<Message>& message() const { return message_; }
    void say(Message::Kind kind, std::string text) { message_ = {kind, std::move(text)}; }
    void dismiss() { message_.reset(); }

private:
    struct Undo {
        std::string key;
        Real value;
        bool beside;  // of B
    };
    bool guarded(const std::function<void()>& action);  // an error becomes a message and a pause
    bool set(const Parameter& parameter, Real value);
    bool set_beside(const Parameter& parameter, Real value);
    void start_both();
    std::vector<Real> difference() const;
    Scene picture_of(const Lesson& of) const;
    void begin_run();  // nothing of the run before is shown any longer
    void moved();      // records, and keeps the view up to date
    void record_of_walkthrough();
    void move_walkthrough(const std::function<void()>& move);
    void show_field_of_slide();
    void after_walkthrough();
    void keep_hand();  // after a move back: the hand is where it is now, not where it was then
    bool advance_one();

    const LessonEntry* entry_ = nullptr;
    std::unique_ptr<Runner> runner_;
    Recorder recorder_;
    CostHistory costs_;
    std::optional<Pinned> pinned_;
    std::unique_ptr<Companion> companion_;
    bool addresses_b_ = false, difference_ = false;
    std::vector<Undo> undo_;
    std::optional<Message> message_;
    int run_count_ = 0;
    std::optional<Pull> hand_;
    bool hand_used_ = false;
    Real owed_ = 0;  // simulated seconds asked for and not yet run
    Real reached_speed_ = 0;
};

}  // namespace pliant::viewer
