#include <pliant/math/watch.h>
#include <pliant/run/runner.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace pliant {
namespace {

using Clock = std::chrono::steady_clock;

Real milliseconds_since(Clock::time_point start) { return std::chrono::duration<Real, std::milli>(Clock::now() - start).count(); }

// The first entry that is not finite or is beyond the bound; -1 when all are well.
Index first_bad(std::span<const Real> numbers, Real bound) {
    if (numbers.empty()) return -1;
    const Eigen::Map<const VecX> all(numbers.data(), static_cast<Index>(numbers.size()));
    if (all.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= bound) return -1;
    return std::ranges::find_if(numbers, [&](Real x) { return !(std::abs(x) <= bound); }) - numbers.begin();
}

}  // namespace

Runner::Runner(const LessonEntry& entry, const Assignments& assignments, std::size_t history_bytes)
    : entry_(&entry), lesson_(entry.make()), history_(history_bytes) {
    costs_.resize(lesson_->stages.size());
    write(parse(assignments));
    reset_or_leave();
}

void Runner::begin_step() {
    failure_.reset();
    if (!pending_.empty()) write(std::exchange(pending_, {})), renew_laws();
    apply_events();
    lesson_->pull(pull_);
    collect_active();
    // The clock counts steps, so that 10⁵ steps of 1 µs make 0.1 s to rounding.
    if (const Real dt = lesson_->time_step(); dt != base_dt_) base_time_ = time(), base_step_ = step_, base_dt_ = dt;
    if (!replaying_) store_snapshot();
    stage_ = 0;
    executed_.clear();
    running_ms_ = 0;
    if (trace_) trace_->start(*lesson_, step_);
}

void Runner::step_pass() {
    if (!replaying_) cancel_point();
    ++revision_;
    if (!inside_step()) begin_step();
    if (active_.empty()) {
        end_step();
        if (!replaying_) reach_ = place();
        return;
    }
    const Stage& stage = *active_[stage_];
    if (!replaying_) tell_progress(stage.name, stage_passes_);
    try {
        run_pass(stage);
        const bool more = stage.again && stage.again();
        if (!more || !stage.loop_from.empty()) finish_stage(stage, more);
    } catch (const Diverged& d) {
        Failure failure = d.failure;
        failure.stage = stage.name;
        fail(std::move(failure));
    } catch (const Cancelled&) {
        // Without running the step before again, which may take as long.
        const Uncancelled back;
        if (const Snapshot* start = history_.find(step_))
            restore(*start), reach_ = place();
        else
            leave_step();
        throw;
    }
    if (stage_ == active_.size()) end_step();
    if (!replaying_) reach_ = place();
}

void Runner::run_pass(const Stage& stage) {
    const auto start = Clock::now();
    if (stage_passes_ == 0 && stage.begin) stage.begin();
    stage.run();
    if (stage_passes_ == 0) stage_ms_ = 0;
    stage_ms_ += milliseconds_since(start);
    ++passes_, ++stage_passes_;
    last_stage_ = stage_;
}

void Runner::finish_stage(const Stage& stage, bool loop) {
    const auto start = Clock::now();
    if (stage.end) stage.end();
    stage_ms_ += milliseconds_since(start);
    guard(stage);
    if (!replaying_) {
        StageCost& cost = costs_[number(stage)];
        cost.total_ms += stage_ms_, cost.last_ms = stage_ms_;
        ++cost.runs, cost.passes += stage_passes_;
    }
    running_ms_ += stage_ms_;
    executed_.push_back({&stage, passes_ - stage_passes_, passes_});
    if (trace_) trace_->finished(*lesson_, stage, passes_);
    stage_passes_ = 0;
    ++stage_;
    if (loop)
        stage_ = static_cast<std::size_t>(std::ranges::find(active_, stage.loop_from, [](const Stage* s) { return s->name; }) -
                                          active_.begin());
}

void Runner::end_step() {
    ++step_;
    passes_ = stage_passes_ = 0;
    stage_ = 0;
    executed_before_.swap(executed_);
    executed_.clear();
    if (!replaying_) step_ms_ = running_ms_;
    update_laws();
}

void Runner::step_stage() {
    const Index step = step_;
    const std::size_t ends = inside_step() ? executed_.size() : 0;
    do step_pass();
    while (step_ == step && executed_.size() == ends);
}

void Runner::step() {
    const Index before = step_;
    do step_pass();
    while (step_ == before);
}

void Runner::run_to_stage(std::string_view name) {
    const auto is_wanted = [&](const Stage* s) { return s->name == name; };
    if (std::ranges::none_of(active_, is_wanted)) {
        std::vector<std::string_view> known;
        for (const Stage* s : active_) known.push_back(s->name);
        throw Refused(fmt::format("no stage '{}' runs with these parameters; there are: {}", name, fmt::join(known, ", ")));
    }
    do step_stage();
    while (!is_wanted(active_[*last_stage_]));
}

// Looks at what a stage wrote: the first number that is not finite, or beyond the bound of its field, ends the run.
void Runner::guard(const Stage& stage) const {
    for (const std::string_view name : stage.writes) {
        const Field* field = lesson_->find_field(name);
        if (!field || !field->in_use()) continue;
        const Real bound = field->bound ? field->bound() : std::numeric_limits<Real>::max();
        const Index at = first_bad(field->view(), bound);
        if (at < 0) continue;
        const Real value = field->view()[static_cast<std::size_t>(at)];
        const std::string what = !std::isfinite(value)
                                     ? "a number that is not finite"
                                     : fmt::format("{} is beyond the bound {}", format_quantity(value, field->unit),
                                                   format_quantity(bound, field->unit));
        Failure failure{.stage = {}, .field = std::string(name), .index = at / field->components, .what = what, .limit = {}};
        if (std::isfinite(value)) failure.value = value;
        if (field->bound) failure.bound = bound;
        throw Diverged(std::move(failure));
    }
}

// Back to the start of the present step.
void Runner::leave_step() {
    if (!go_to({step_, 0}) && history_.last()) restore(*history_.last());
    reach_ = place();
}

void Runner::fail(Failure failure) {
    failure.step = step_ + 1;
    failure.time = time() + base_dt_;
    if (failure.limit.empty()) failure.limit = lesson_->blow_up_hint();
    leave_step();
    failure_ = failure;
    throw Diverged(std::move(failure));
}

}  // namespace pliant
