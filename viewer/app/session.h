// What the lab holds: the lesson being run, what the person looks at, and everything that a button, a key or a walkthrough may do
// to it. It draws nothing, so a test can drive it as the window does.
#pragma once
#include <pliant/lesson/recorder.h>
#include <pliant/lesson/runner.h>
#include <pliant/lesson/scene_file.h>
#include <pliant/lesson/texts.h>
#include <pliant/lesson/until.h>
#include <pliant/lesson/walkthrough.h>

#include "app/autopsy.h"
#include "app/companion.h"
#include "app/inspector.h"
#include "app/viewpoint.h"
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
    // The part of a probe's plot that is on the screen: it is thinned out last.
    void watch(std::size_t probe, const std::optional<Interval>& part);
    // Memory of all that is recorded for plots, of this run, the one beside it and the pinned one: held, and that may be held.
    std::size_t recorded_bytes() const;
    std::size_t recorded_cap() const;
    const CostHistory& costs() const { return costs_; }

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
    void pass_back();
    // To a place over which the run has gone already: the past that is stored, and forward again.
    void go_to(Place place);
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
    // What was typed for a parameter, read as the command line reads it. A refusal becomes a message; nothing is clamped.
    void enter(const Parameter& parameter, std::string_view text);
    // Several values at once, by key, as one step of undo; the run begins anew. False when refused.
    bool assign_together(const std::vector<std::pair<std::string, Real>>& values);
    void restore_default(const Parameter& parameter);
    void restore_defaults();  // of every parameter, as one step of undo
    void undo();
    bool can_undo() const { return !undo_.empty(); }

    // --- the hand ---
    // A handle of the lesson sets its parameters, within the reach of their sliders; anything else is pulled.
    void pull(const std::optional<Pull>& pull);

    // --- view ---
    ColourBy colours;
    ColourRange range;
    bool show_arrows = true, show_labels = true, smooth = true;
    bool patterns = false;         // the sign shows by hatching, dashes and shapes as well as by colours
    std::optional<Camera> camera;  // where the person moved it; when empty, the viewpoint's
    Viewpoint viewpoint;
    // The camera is no longer the person's.
    void frame_afresh() { camera.reset(), viewpoint.turn_back(); }
    // As the picture is seen.
    const Camera& seen_by() const { return camera ? *camera : viewpoint.camera(); }
    void view_changed();  // after a change of the colours: their range is found again
    // The picture, as the inspector asks for it: of now, of before the stage that is looked at, or of what that changed.
    Scene scene();
    // The one as the stage found it, beside or under that of now; empty when only one is to be seen.
    std::optional<Scene> other_scene();
    // The colours of the picture: the range of the field, or of its change.
    const ColourScale& colour_scale() const { return shows_change_ ? change_range_.scale : range.scale; }
    bool shows_change() const { return shows_change_; }

    // --- looking inside ---
    Inspector inspector;
    void compare(Compare what);
    void ask(Inspector::Asked question);
    void ask_back();  // to the question before
    // A stop before this stage is set or taken away.
    void toggle_break(std::string_view stage);

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
    void say(Message::Kind kind, std::string text) { message_ = {kind, std::move(text)}, autopsy_.reset(); }
    void dismiss() { message_.reset(), autopsy_.reset(); }

    // --- when a run breaks down ---
    // Of the divergence that the message tells, or of the assumption that stopped the run; gone with the message.
    const std::optional<Autopsy>& autopsy() const { return autopsy_; }
    void tell(const Diverged& divergence);
    // The parameter of the fix that the slide locks; null when all may be changed.
    const Parameter* locked_of_fix() const;
    // Applies the fix, as one step of undo, and plays: on from the last good state, or from the start where it rebuilds.
    void mend();
    // The element goes to the inspector.
    void pick_failed();

private:
    using Values = std::vector<std::pair<std::string, Real>>;  // by key
    struct Undo {
        Values values;
        bool beside = false;  // of B
    };
    bool guarded(const std::function<void()>& action);  // an error becomes a message and a pause
    bool set(const Values& values);
    bool set_beside(const Parameter& parameter, Real value);
    void start_both();
    void settle(bool all_was_done);
    void move_handle(const Values& values);
    std::vector<Real> difference() const;
    void tell_failed_assumption();
    void begin_run();  // nothing of the run before is shown any longer
    void moved();      // records, and keeps the view up to date
    void record_of_walkthrough();
    void move_walkthrough(const std::function<void()>& move);
    void show_field_of_slide();
    void after_walkthrough();
    void keep_hand();  // after a move back: the hand is where it is now, not where it was then
    bool advance_one();
    void trace();         // copies what the stages do, while someone looks
    Scene drawn() const;  // empty, with what the person wants to see
    void show_cells(Scene& picture) const;

    const LessonEntry* entry_ = nullptr;
    std::unique_ptr<Runner> runner_;
    Recorder recorder_;
    CostHistory costs_;
    std::optional<Pinned> pinned_;
    std::unique_ptr<Companion> companion_;
    bool addresses_b_ = false, difference_ = false;
    std::vector<Undo> undo_;
    std::optional<Message> message_;
    std::optional<Autopsy> autopsy_;
    int run_count_ = 0, open_count_ = 0;
    std::optional<Pull> hand_;
    bool hand_used_ = false, moves_handle_ = false;
    Real owed_ = 0;  // simulated seconds asked for and not yet run
    Real reached_speed_ = 0;
    bool armed_ = false;  // have the breakpoints seen where the run stood when it was let go?
    bool shows_change_ = false;
    ColourRange change_range_;
    std::optional<Scene> before_;  // as the shown stage found it, at before_place_
    Place before_place_;
    std::string before_key_;
};

}  // namespace pliant::viewer
