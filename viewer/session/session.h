// What the lab holds: the lesson being run, what the person looks at, and everything that a button, a key or a walkthrough may do
// to it. It draws nothing, so a test can drive it as the window does.
#pragma once
#include <pliant/document/extensions.h>
#include <pliant/document/scene_file.h>
#include <pliant/document/walkthrough.h>
#include <pliant/lecture/lecture.h>
#include <pliant/run/recorder.h>
#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/text/texts.h>

#include "render/picture.h"
#include "session/autopsy.h"
#include "session/budget.h"
#include "session/colour_range.h"
#include "session/companion.h"
#include "session/inspector.h"
#include "session/notebook.h"
#include "session/picture_key.h"
#include "session/pinned.h"
#include "session/viewpoint.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace pliant::viewer {

class Session {
public:
    // --- what has to wait ---
    // While a frame is drawn nothing moves: whatever would change the run waits until do_waiting().
    class Held {
    public:
        explicit Held(Session& session) : session_(session) { session.holding_ = true; }
        ~Held() { session_.holding_ = false; }
        Held(const Held&) = delete;
        Held& operator=(const Held&) = delete;

    private:
        Session& session_;
    };
    // Does it now or, while held, later; what it throws becomes a message.
    void later(std::function<void()> act);
    bool anything_waits() const { return !waiting_.empty(); }
    void do_waiting();
    // Makes the pictures that are to be shown, where they are not those that are kept.
    void prepare_pictures();

    // Opens a lesson, by default the one that moves most. Throws Refused.
    explicit Session(std::string_view lesson = "mesh/mass_spring");

    // --- lessons and scenes ---
    void open(const LessonEntry& entry, const Runner::Assignments& assignments = {}, std::vector<Event> events = {});
    void open_next(int direction);
    // Runs again to its place, with B and the pinned run. Throws Refused for runs that cannot begin; the rest becomes a message.
    void open_scene(const SceneFile& scene);
    static void check(const SceneFile& scene);  // throws Refused for runs that cannot begin
    SceneFile scene_file() const;
    bool holding() const { return holding_; }
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
    // Advances by what `seconds` of wall time ask for, pass by pass, as far as the budget goes; a step that it does not suffice
    // for goes on in the next update. A slow machine falls behind; neither Δt nor a bit of the result changes.
    void update(Real seconds, Budget budget = {});
    // Moves forward by a step, a stage or a pass then go on from update to update as well; else each runs to its end at once.
    bool sliced = false;
    // Does another update go on with what is begun?
    bool under_way() const;
    // A move that was asked for, or the rest of a step that was paused, is not at its end.
    bool moving() const { return goal_ != nullptr; }
    // A step that plays goes on in the next update, and will soon be over: what is shown is still the last whole one, so that
    // numbers which are only of use inside a step do not flash up.
    bool shows_last_step() const;
    // Forward passes of this run and all before it.
    long passes_run() const { return passes_run_; }
    // Pauses between two steps; asked once more, at once.
    void toggle_play();
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
    bool extreme = false;                   // sliders span all that the solver accepts
    static constexpr int value_digits = 5;  // of the value beside a slider
    // A refusal, also of a parameter that the slide locks, becomes a message. Values that follow each other on one parameter
    // within a drag are one undo step.
    void assign(const Parameter& parameter, Real value, bool same_drag = false);
    // What was typed for a parameter, read as the command line reads it, save that a number without a unit is in the one that is
    // shown: beside "4 ms" 20 is 20 ms. A refusal becomes a message; nothing is clamped.
    void enter(const Parameter& parameter, std::string_view text);
    // The file parameter of the run that the sliders set which takes a file of this name; null where there is none.
    const Parameter* taker_of(const std::string& path) const;
    // A file for it, read anew, with what its declaration sets beside it, as one step of undo. Throws Refused for what is no such
    // file; what the lesson refuses in it becomes a message, and the run stays as it was.
    void choose_file(const Parameter& parameter, const std::string& path);
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
    // As the picture is seen: in a narrower one than it was chosen in, the person's camera stands farther away.
    Camera seen_by() const;
    void see_in(float aspect);  // width over height of the free part of the picture
    // From now on the person moves it, from where it is: it no longer goes along with what moves.
    Camera& own_camera();
    void view_changed();  // after a change of the colours: their range is found again
    // The picture, as the inspector asks for it: of now, of before the stage that is looked at, or of what that changed. It is
    // drawn by the lesson only when something that it depends on has changed.
    KeptPicture picture();
    const Scene& scene() { return picture()->scene; }  // until the next change
    // The one as the stage found it, beside or under that of now; null when only one is to be seen.
    KeptPicture other_picture();
    KeptPicture picture_beside();  // of B; null without one
    long pictures_drawn() const { return pictures_drawn_; }
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
    // A second run, B, beside this one, A, as beside_to_now makes it; no more where there is one. Both start again when a change
    // rebuilds one of them.
    void toggle_companion();
    void open_companion(const Runner::Assignments& changes = {});  // throws Refused
    // B with these changes, run to where A stands. A keeps its place, unless something was done to it on the way: then both run
    // there again, side by side, under what the sliders say now.
    void beside_to_now(const Runner::Assignments& changes);
    // How far B has come to where A is, 0 to 1; empty when their numbers are of one time.
    std::optional<Real> catching_up() const;
    void close_companion();
    const Companion* companion() const { return companion_.get(); }
    // The run whose parameters the sliders set.
    void address(bool b);
    bool addresses_b() const { return addresses_b_; }
    const Runner& addressed() const { return addresses_b_ ? companion_->runner() : *runner_; }
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
    // What is said on the slide before its answer; a refusal becomes a message.
    void predict(const Guess& guess);
    // What a person says of their own answer in words, beside that of the slide.
    void say_right(bool right);
    // Is this probe, curve, field or parameter hidden until the answer of the slide, or a part of what is shown (Slide::hides)?
    bool hides(std::string_view name) const { return walkthrough && walkthrough->hides(name); }
    // What the lesson offers to go on from. One that is opened is a walkthrough of one slide, its question in sight, in the scene
    // of its share string; the next press plays its actions and shows the answer.
    const std::vector<Extension>& extensions() const;
    void open_extension(std::size_t n);                                                               // from 0
    std::optional<std::size_t> extension() const { return walkthrough ? extension_ : std::nullopt; }  // that is open

    // --- lecture ---
    // Each slide of a lecture is a walkthrough of that slide alone, in the scene that it brings. Opening anything else ends it.
    void open_lecture(Lecture lecture, std::size_t slide = 0);
    void end_lecture();
    // The same lecture, after its file was written again; nothing when another one, or none, is shown.
    void renew_lecture(const Lecture& lecture);
    const Lecture* lecture() const { return lecture_ ? &lecture_->lecture : nullptr; }
    // Where it stands, so that a scene of it goes on there.
    std::optional<SceneSlide> lecture_place() const;
    const LectureSlide* lecture_slide() const;  // that is shown; null without a lecture
    // Of the lecture or else of the walkthrough; without any 0.
    std::size_t slide_number() const;  // from 0
    std::size_t slide_count() const;
    const Slide* slide_after() const;  // null behind the last one

    // --- what is to be handed in ---
    Notebook notebook;
    // Where the run stands; a refusal becomes a message.
    void note_number(std::string_view probe);
    void note_answer(std::string text);

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
    const Parameter* locked_of_fix(std::size_t which = 0) const;
    // Applies a fix, as one step of undo, and plays: on from the last good state, or from the start where it rebuilds.
    void mend(std::size_t which = 0);
    // The element goes to the inspector.
    void pick_failed();

private:
    friend class SceneOpening;
    friend class SceneTaking;
    // While held: puts it off, and true.
    bool put_off(std::function<void()> act);
    using Values = Runner::Values;
    struct Undo {
        Values values;
        bool beside = false;  // of B
    };
    bool guarded(const std::function<void()>& action);  // an error becomes a message and a pause
    bool set(const Values& values);
    void look(const std::vector<std::pair<std::string, Real>>& values);
    bool set_beside(const Parameter& parameter, Real value);
    void make_companion(const Runner::Assignments& changes);
    void run_beside_to_a(const Runner::Assignments& changes);
    void start_both();
    void settle(bool all_was_done);
    // True, and a message, when the slide locks it.
    bool refuse_locked(const Parameter& parameter);
    void move_handle(const std::vector<std::pair<std::string, Real>>& values);
    std::vector<Real> difference() const;
    void tell_failed_assumption();
    void begin_run();  // nothing of the run before is shown any longer
    void moved();      // records, and keeps the view up to date
    void record_step();
    void seen();
    std::function<bool()> end_of_step() const;
    void begin_to(std::function<bool()> reached);
    void move_to(std::function<bool()> reached);
    void work_towards_goal(Spending& spending);
    void play(Real seconds, Spending& spending);
    bool beside_is_behind() const;
    void go_back(bool (Runner::*move)(), const std::string& nothing_there);
    void record_of_walkthrough();
    void note_slide();
    void move_walkthrough(const std::function<void()>& move);
    void show_field_of_slide();
    void after_walkthrough();
    void keep_hand();  // after a move back: the hand is where it is now, not where it was then
    bool advance_pass(bool obeys_stops);
    std::vector<Real> shown_values() const;  // that give the colours their range
    void trace();                            // copies what the stages do, while someone looks
    Scene drawn() const;                     // empty, with what the person wants to see
    PictureKey picture_key() const;
    struct Keeping {
        std::optional<PictureKey> key{};
        KeptPicture picture{};
    };
    struct LectureShow {
        Lecture lecture;
        std::size_t slide;
        bool shown = false;                      // has a slide of it been shown?
        std::map<std::size_t, Guess> guesses{};  // of the slides that have been left
    };
    void show_lecture_slide(std::size_t n);
    void enter(const Lecture& lecture, const LectureSlide& slide);
    void present(Walkthrough words);
    void lecture_next();
    void lecture_back();
    const KeptPicture& kept(Keeping& keeping, const std::function<bool(Scene&)>& draw);

    bool holding_ = false;
    std::vector<std::function<void()>> waiting_;
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
    std::function<bool()> goal_;  // of a move forward: asked behind every pass; null when none is under way
    long passes_run_ = 0;
    int updates_in_step_ = 0;  // in which the present step did not end
    Real owed_ = 0;            // simulated seconds asked for and not yet run
    Real reached_speed_ = 0;
    bool armed_ = false;  // have the breakpoints seen where the run stood when it was let go?
    bool shows_change_ = false;
    ColourRange change_range_;
    std::tuple<std::string, int, bool> ranged_{};  // the field, the component, and is it a difference: that the ranges are of
    float aspect_ = 0, own_aspect_ = 0;  // of the picture, and of that in which the camera was chosen; 0 until it is drawn
    Keeping now_, before_, beside_;
    long pictures_drawn_ = 0;
    int pin_count_ = 0, companion_count_ = 0;
    std::optional<LectureShow> lecture_{};
    std::set<std::pair<std::string, std::string>> answers_seen_{};  // file and title of the slides
    std::optional<std::size_t> extension_{};
    mutable std::string_view extensions_of_{};  // the lesson of those that are kept
    mutable std::vector<Extension> extensions_{};
};

}  // namespace pliant::viewer
