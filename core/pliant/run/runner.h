// The only code that advances a lesson: the window, the headless picture, the command line, the tests and the studies all go
// through it.
#pragma once
#include <pliant/lesson/lesson.h>
#include <pliant/lesson/registry.h>
#include <pliant/math/error.h>
#include <pliant/run/history.h>
#include <pliant/run/recording.h>
#include <pliant/run/step_trace.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pliant {

// Where a run stands: `step` whole steps done, and `passes` passes into the next one. passes = 0: between two steps.
struct Place {
    Index step = 0;
    Index passes = 0;
    auto operator<=>(const Place&) const = default;
};
// For people, who count steps from 1: "step 7" is the seventh, that under way or, between two steps, the one that has ended.
// Every text that names a step means it so.
std::string place_words(Place place);
// The number of the step alone.
inline Index step_number(Place place) { return place.passes > 0 ? place.step + 1 : place.step; }

// Wall time and counted work of a stage since the last reset.
struct StageCost {
    Real total_ms = 0, last_ms = 0;  // last: of its latest whole execution
    Index runs = 0, passes = 0;
};

// A stage that ran from one number of passes of its step to another.
struct Execution {
    const Stage* stage = nullptr;
    Index begin = 0, end = 0;
};

enum class Holds { yes, no, not_expected };

class Runner {
public:
    using Assignments = std::vector<std::pair<std::string, std::string>>;  // key, value as text

    // Makes the lesson, applies the assignments and resets it. history_bytes caps what is stored for stepping back; the starts of
    // this step and of the one before are always kept. Throws Refused.
    explicit Runner(const LessonEntry& entry, const Assignments& assignments = {}, std::size_t history_bytes = 64u << 20);

    // Refuses what could not begin, without making it: a lesson of its own tells. Throws Refused.
    static void check(const LessonEntry& entry, const Assignments& assignments, const std::vector<Event>& events = {});

    const LessonInfo& info() const { return entry_->info; }
    const Lesson& lesson() const { return *lesson_; }

    // --- parameters and the hand ---
    // Inside a step a live parameter takes effect when the next step starts; a rebuild one resets; one that looks takes effect at
    // once and is no part of the past: going back leaves it as it is. Throws Refused, and then
    // nothing has changed.
    void assign(const Assignments& assignments);
    void assign(std::string_view key, Real value);
    // By the parameters themselves, which have to be those of this lesson: else it throws std::logic_error.
    using Values = std::vector<std::pair<const Parameter*, Real>>;
    void assign_values(const Values& values) { write_or_reset(own(values)); }
    // As a scene does: these values, every other parameter at its initial one, then a reset.
    void load(const Assignments& assignments);
    // The value that the parameter has, or will have from the next step on.
    Real wanted(const Parameter& parameter) const;
    // Does a change of it, made inside a step, wait for the next one?
    bool waits(const Parameter& parameter) const { return wanted(parameter) != parameter.value(); }
    void pull(const std::optional<Pull>& pull);
    const std::optional<Pull>& pulled() const { return pull_; }
    // The script of a run: it happens in every run until others are set.
    void set_events(std::vector<Event> events);
    const std::vector<Event>& events() const { return events_; }
    // What was assigned and pulled in this run. A rebuild or a reset begins another one; going back forgets what came later.
    const Recording& recording() const { return recording_; }

    // Initial state from the parameters alone.
    void reset();

    // --- forward ---
    // Each throws Diverged when a stage fails or writes a number that is not finite or beyond its bound. The state is then that
    // of the start of the step, and `failure` tells what happened. Each tells a Watch which stage it runs, and throws Cancelled:
    // between two passes it then stands where it was, within one at the start of the step.
    void step_pass();
    void step_stage();
    void step();
    // To the end of the next execution of this stage. Throws Refused for a stage that the scene does not run.
    void run_to_stage(std::string_view name);

    // --- back ---
    // Restores a stored state and replays to the wanted place; false when it is no longer stored.
    bool pass_back();
    bool stage_back();
    bool step_back();  // inside a step, to the same stage of the step before
    // Also forward again to what was run before, until something is changed.
    bool go_to(Place place);
    // The furthest place that go_to() can reach.
    Place reach() const { return reach_; }
    const History& history() const { return history_; }

    // --- looking into a step ---
    // From the next step on what each stage finds and leaves is copied into `trace`, which must outlive the runner or be taken
    // away with nullptr.
    void trace_to(StepTrace* trace) { trace_ = trace; }
    // The stages that have ended in the present step, and in the latest whole one, in the order in which they ran.
    const std::vector<Execution>& executed() const { return executed_; }
    const std::vector<Execution>& executed_before() const { return executed_before_; }

    // --- where we are ---
    // Another number whenever something may have changed that a picture or a panel shows.
    long revision() const { return revision_; }
    Place place() const { return {step_, passes_}; }
    bool inside_step() const { return passes_ > 0; }
    // The stages that the present scene uses, in order.
    const std::vector<const Stage*>& stages() const { return active_; }
    // Index in stages() of the stage that runs next, and the passes of it done so far.
    std::size_t next_stage() const { return stage_; }
    Index passes_in_stage() const { return stage_passes_; }
    // Index in stages() of the stage that ran last, if any has.
    std::optional<std::size_t> last_stage() const { return last_stage_; }
    Real time() const;  // s, of the last whole step
    Real time_step() const { return lesson_->time_step(); }
    bool is_static() const { return lesson_->time_step() == 0; }
    const std::optional<Failure>& failure() const { return failure_; }
    // For what is found to be wrong outside a stage: a probe that is not finite, a rest that is never reached.
    void note_failure(const Failure& failure) { failure_ = failure; }

    // --- what it costs, and whether it holds ---
    const StageCost& cost(const Stage& stage) const { return costs_[number(stage)]; }  // of lesson().stages
    Real step_ms() const { return step_ms_; }                                          // of the latest whole step
    // Empty where undefined. Throws Diverged when it is not finite.
    std::optional<Real> value(const Probe& probe) const;
    // Of the probe of this name. Throws Refused when there is none, or it has no value now.
    Real value(std::string_view probe) const;
    std::optional<Real> exact(const Probe& probe) const;
    // Throws Diverged for the first probe, or closed form, that is not finite.
    void check_probes() const;
    Holds holds(std::size_t conserved) const;  // index in lesson().conserved
    // Distance from what the law demands, infinite where the probe is not finite, and how much of it is tolerated, in the unit of
    // the probe.
    Real drift(std::size_t conserved) const;
    Real tolerance(std::size_t conserved) const;
    // The laws to show: of several laws for one probe those that are expected to hold now, or else the first.
    std::vector<std::size_t> shown_laws() const;

private:
    friend class Revisit;

    using Writes = std::vector<std::pair<Parameter*, Real>>;
    Writes parse(const Assignments& assignments) const;
    Writes own(const Values& values) const;
    void write(const Writes& values);  // all or, when the lesson refuses them, none
    void write_or_reset(const Writes& values);
    void look(const Writes& values);
    void apply_events();
    void apply(const Event& event);
    void note_assigned(const Writes& values);
    void reset_or_leave();
    void start_fresh();
    void collect_active();
    void renew_laws();
    void update_laws();
    std::optional<LawStart> start_of(const Conserved& law) const;

    void begin_step();
    void end_step();
    void run_pass(const Stage& stage);
    void finish_stage(const Stage& stage, bool loop);
    void guard(const Stage& stage) const;
    void leave_step();
    [[noreturn]] void fail(Failure failure);

    void store_snapshot();
    void restore(const Snapshot& snapshot);
    bool restore_start(Index step);
    std::size_t number(const Stage& stage) const { return static_cast<std::size_t>(&stage - lesson_->stages.data()); }

    const LessonEntry* entry_;
    std::unique_ptr<Lesson> lesson_;
    std::vector<const Stage*> active_;
    std::vector<StageCost> costs_;
    Writes pending_;
    std::vector<Event> events_;
    Recording recording_;
    std::optional<Pull> pull_;
    std::optional<Failure> failure_;
    History history_;
    bool replaying_ = false;
    long revision_ = 0;

    Index step_ = 0, passes_ = 0, stage_passes_ = 0;
    std::size_t stage_ = 0;
    std::optional<std::size_t> last_stage_;
    std::vector<Execution> executed_, executed_before_;
    Place reach_;
    StepTrace* trace_ = nullptr;
    Index base_step_ = 0;               // the time step has been base_dt_ since this step,
    Real base_time_ = 0, base_dt_ = 0;  // which began at base_time_
    Real step_ms_ = 0, running_ms_ = 0, stage_ms_ = 0;
    std::vector<std::optional<LawStart>> law_starts_;  // of each conserved quantity whose law holds now
};

}  // namespace pliant
