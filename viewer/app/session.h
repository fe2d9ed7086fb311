// What the lab holds: the lesson being run, what the person looks at, and everything that a button, a key or a walkthrough may do
// to it. It draws nothing, so a test can drive it as the window does.
#pragma once
#include <pliant/lesson/recorder.h>
#include <pliant/lesson/runner.h>
#include <pliant/lesson/scene_file.h>
#include <pliant/lesson/texts.h>
#include <pliant/lesson/until.h>
#include <pliant/lesson/walkthrough.h>

#include "render/palette.h"

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

    // Counts the runs that began here: a lesson opened, a reset. What was measured before belongs to another run.
    int run_count() const { return run_count_; }

    // Counts the lessons and scenes opened.
    int open_count() const { return open_count_; }

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
    // A refusal becomes a message. Values that follow each other on one parameter within a drag are one undo step.
    void assign(const Parameter& parameter, Real value, bool same_drag = false);
    void restore_default(const Parameter& parameter);
    void restore_defaults();  // of every parameter, as one step of undo
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

    // --- walkthrough ---
    std::optional<WalkthroughPlayer> walkthrough;
    void start_walkthrough();
    void walkthrough_next();
    void walkthrough_back();

    // --- messages ---
    struct Message {
        enum class Kind { info, refused, diverged } kind;
        std::string text;
    };
    const std::optional<Message>& message() const { return message_; }
    void say(Message::Kind kind, std::string text) { message_ = {kind, std::move(text)}; }
    void dismiss() { message_.reset(); }

private:
    using Values = std::vector<std::pair<std::string, Real>>;  // by key
    template <class Action>
    bool guarded(Action action);  // an error becomes a message and a pause
    bool set(const Values& values);
    void begin_run();  // nothing of the run before is shown any longer
    void moved();      // records, and keeps the view up to date
    void record_of_walkthrough();
    void after_walkthrough();
    void keep_hand();  // after a move back: the hand is where it is now, not where it was then
    bool advance_one();

    const LessonEntry* entry_ = nullptr;
    std::unique_ptr<Runner> runner_;
    Recorder recorder_;
    std::vector<Values> undo_;
    std::optional<Message> message_;
    int run_count_ = 0, open_count_ = 0;
    std::optional<Pull> hand_;
    bool hand_used_ = false;
    Real owed_ = 0;  // simulated seconds asked for and not yet run
    Real reached_speed_ = 0;
};

}  // namespace pliant::viewer
