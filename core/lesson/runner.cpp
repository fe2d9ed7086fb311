#include <pliant/lesson/format.h>
#include <pliant/lesson/runner.h>

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
    reset();
}

// ---------------------------------------------------------------------------------------------- parameters and the hand

Runner::Values Runner::parse(const Assignments& assignments) const {
    Values values;
    for (const auto& [key, text] : assignments) {
        Parameter& p = lesson_->parameter(key);
        values.emplace_back(&p, p.parse(text));
    }
    return values;
}

void Runner::write(const Values& values) {
    std::vector<Real> before;
    for (const Parameter* p : lesson_->parameters) before.push_back(p->value());
    try {
        for (const auto& [parameter, value] : values) parameter->set(value);
        lesson_->check();
    } catch (...) {
        for (std::size_t i = 0; i < before.size(); ++i) lesson_->parameters[i]->set(before[i]);
        throw;
    }
}

void Runner::assign(const Assignments& assignments) { write_or_reset(parse(assignments)); }

void Runner::assign(std::string_view key, Real value) { write_or_reset({{&lesson_->parameter(key), value}}); }

void Runner::write_or_reset(const Values& values) {
    const bool rebuild = std::ranges::any_of(values, [](const auto& v) { return v.first->info.effect == Effect::rebuild && v.first->value() != v.second; });
    if (!rebuild && inside_step()) {
        for (const auto& [parameter, value] : values) parameter->check(value);
        pending_.insert(pending_.end(), values.begin(), values.end());
        return;
    }
    std::vector<Real> before;
    for (const Parameter* p : lesson_->parameters) before.push_back(p->value());
    write(values);
    if (!rebuild) return renew_references();
    try {
        reset();
    } catch (const Error&) {
        for (std::size_t i = 0; i < before.size(); ++i) lesson_->parameters[i]->set(before[i]);
        reset();
        throw;
    }
}

void Runner::load(const Assignments& assignments) {
    Values values;
    for (Parameter* p : lesson_->parameters) values.emplace_back(p, p->info.initial);
    for (const auto& value : parse(assignments)) values.push_back(value);
    pending_.clear();
    write(values);
    reset();
}

Real Runner::wanted(const Parameter& parameter) const {
    for (auto it = pending_.rbegin(); it != pending_.rend(); ++it)
        if (it->first == &parameter) return it->second;
    return parameter.value();
}

void Runner::pull(const std::optional<Pull>& pull) { pull_ = pull; }

void Runner::set_events(std::vector<Event> events) {
    std::ranges::stable_sort(events, {}, &Event::step);
    for (const Event& e : events) parse(e.assign);
    events_ = std::move(events);
}

void Runner::apply_events() {
    for (const Event& e : events_) {
        if (e.step != step_) continue;
        if (!e.assign.empty()) write(parse(e.assign));
        if (e.pull) pull_ = e.pull;
        if (e.release) pull_.reset();
    }
}

void Runner::reset() {
    lesson_->check();
    pending_.clear();
    pull_.reset();
    history_.clear();
    std::ranges::fill(costs_, StageCost{});
    step_ms_ = 0;
    start_fresh();
}

// The initial state, without touching the stored past.
void Runner::start_fresh() {
    lesson_->pull(std::nullopt);
    lesson_->reset();
    failure_.reset();
    step_ = passes_ = stage_passes_ = base_step_ = 0;
    base_time_ = 0, base_dt_ = lesson_->time_step();
    stage_ = 0;
    last_stage_.reset();
    stage_ends_.clear(), previous_ends_.clear();
    collect_active();
    renew_references();
}

void Runner::collect_active() {
    active_.clear();
    for (const Stage& s : lesson_->stages)
        if (s.in_use()) active_.push_back(&s);
}

// ------------------------------------------------------------------------------------------------------------- forward

void Runner::begin_step() {
    failure_.reset();
    if (!pending_.empty()) write(std::exchange(pending_, {})), renew_references();
    apply_events();
    lesson_->pull(pull_);
    collect_active();
    // The clock counts steps, so that 10⁵ steps of 1 µs make 0.1 s to rounding.
    if (const Real dt = lesson_->time_step(); dt != base_dt_) base_time_ = time(), base_step_ = step_, base_dt_ = dt;
    if (!replaying_) store_snapshot();
    stage_ = 0;
    stage_ends_.clear();
    running_ms_ = 0;
}

void Runner::step_pass() {
    if (!inside_step()) begin_step();
    if (active_.empty()) return end_step();
    const Stage& stage = *active_[stage_];
    try {
        run_pass(stage);
        const bool more = stage.again && stage.again();
        if (!more || !stage.loop_from.empty()) finish_stage(stage, more);
    } catch (const Diverged& d) {
        Failure failure = d.failure;
        failure.stage = stage.name;
        fail(std::move(failure));
    }
    if (stage_ == active_.size()) end_step();
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
    stage_ends_.push_back(passes_);
    stage_passes_ = 0;
    ++stage_;
    if (loop) stage_ = static_cast<std::size_t>(std::ranges::find(active_, stage.loop_from, [](const Stage* s) { return s->name; }) - active_.begin());
}

void Runner::end_step() {
    ++step_;
    passes_ = stage_passes_ = 0;
    stage_ = 0;
    previous_ends_ = stage_ends_;
    stage_ends_.clear();
    if (!replaying_) step_ms_ = running_ms_;
    update_references();
}

void Runner::step_stage() {
    const Index step = step_;
    const std::size_t ends = inside_step() ? stage_ends_.size() : 0;
    do step_pass();
    while (step_ == step && stage_ends_.size() == ends);
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
        const std::string what = !std::isfinite(value) ? "a number that is not finite"
                                                       : fmt::format("{} is beyond the bound {}", format_quantity(value, field->unit), format_quantity(bound, field->unit));
        throw Diverged({.stage = {}, .field = std::string(name), .index = at / field->components, .what = what, .limit = {}});
    }
}

void Runner::fail(Failure failure) {
    failure.step = step_ + 1;
    failure.time = time() + base_dt_;
    if (failure.limit.empty()) failure.limit = lesson_->blow_up_hint();
    if (!go_to({step_, 0}) && history_.last()) restore(*history_.last());
    failure_ = failure;
    throw Diverged(std::move(failure));
}

// ---------------------------------------------------------------------------------------------------------------- back

void Runner::store_snapshot() {
    Snapshot& s = history_.add(step_);
    s.base_step = base_step_, s.base_time = base_time_, s.base_dt = base_dt_;
    s.parameters.clear();
    for (const Parameter* p : lesson_->parameters) s.parameters.push_back(p->value());
    s.pull = pull_;
    s.references = references_;
    save_state(*lesson_, s.state);
    history_.added();
}

void Runner::restore(const Snapshot& s) {
    for (std::size_t i = 0; i < s.parameters.size(); ++i) lesson_->parameters[i]->set(s.parameters[i]);
    if (s.step == 0) start_fresh();
    load_state(*lesson_, s.state);
    pull_ = s.pull;
    lesson_->pull(pull_);
    references_ = s.references;
    base_step_ = s.base_step, base_time_ = s.base_time, base_dt_ = s.base_dt;
    step_ = s.step;
    passes_ = stage_passes_ = 0;
    stage_ = 0;
    last_stage_.reset();
    stage_ends_.clear();
    pending_.clear();
    failure_.reset();
    collect_active();
}

// To the start of a step. The fields are those that the step before it left, so that one is run again.
bool Runner::restore_start(Index step) {
    const Snapshot* wanted = history_.find(step);
    const Snapshot* before = history_.find(step - 1);
    if (step == 0) {
        if (wanted) restore(*wanted);
        else if (step_ > 0 || inside_step()) return false;
        return true;
    }
    if (!before) return false;
    restore(*before);
    Runner::step();
    if (wanted) {
        const auto last = last_stage_;
        restore(*wanted);
        last_stage_ = last;
    }
    return true;
}

bool Runner::go_to(Place to) {
    if (to.step < 0 || to.passes < 0 || to > place()) return false;
    replaying_ = true;
    bool found = false;
    try {
        found = restore_start(to.step);
        for (Index p = 0; found && p < to.passes; ++p) step_pass();
    } catch (...) {
        replaying_ = false;
        throw;
    }
    replaying_ = false;
    return found;
}

bool Runner::pass_back() {
    if (passes_ > 0) return go_to({step_, passes_ - 1});
    return !previous_ends_.empty() && go_to({step_ - 1, previous_ends_.back() - 1});
}

bool Runner::stage_back() {
    const bool inside = inside_step();
    const std::vector<Index>& ends = inside ? stage_ends_ : previous_ends_;
    const Index now = inside ? passes_ : (ends.empty() ? 0 : ends.back());
    Index target = 0;
    for (const Index end : ends)
        if (end < now) target = end;
    if (!inside && ends.empty()) return false;
    return go_to({inside ? step_ : step_ - 1, target});
}

bool Runner::step_back() { return inside_step() ? go_to({step_, 0}) : step_ > 0 && go_to({step_ - 1, 0}); }

// ------------------------------------------------------------------------------------------------ measures and laws

Real Runner::time() const { return base_time_ + static_cast<Real>(step_ - base_step_) * base_dt_; }

namespace {
std::optional<Real> finite(std::optional<Real> value, const Probe& probe, Index step, Real time) {
    if (value && !std::isfinite(*value))
        throw Diverged({.stage = {}, .field = std::string(probe.name), .index = -1, .step = step, .time = time, .what = "the probe is not finite", .limit = {}});
    return value;
}
}  // namespace

std::optional<Real> Runner::value(const Probe& probe) const { return finite(probe.value(), probe, step_, time()); }

std::optional<Real> Runner::exact(const Probe& probe) const {
    return probe.exact ? finite(probe.exact(time()), probe, step_, time()) : std::nullopt;
}

void Runner::renew_references() {
    references_.assign(lesson_->conserved.size(), std::nullopt);
    update_references();
}

void Runner::update_references() {
    for (std::size_t i = 0; i < references_.size(); ++i) {
        const Conserved& c = lesson_->conserved[i];
        if (c.expected && !c.expected()) references_[i].reset();
        else if (!references_[i]) references_[i] = lesson_->probe(c.probe).value();
    }
}

Real Runner::drift(std::size_t i) const {
    const Conserved& c = lesson_->conserved[i];
    const std::optional<Real> now = value(lesson_->probe(c.probe));
    if (!now || !references_[i]) return 0;
    switch (c.law) {
        case Law::constant: return std::abs(*now - *references_[i]);
        case Law::never_grows: return std::max(Real{0}, *now - *references_[i]);
        case Law::zero: return std::abs(*now);
    }
    return 0;
}

std::vector<std::size_t> Runner::shown_laws() const {
    const auto& laws = lesson_->conserved;
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < laws.size(); ++i) {
        const auto of_same_probe = [&](std::size_t j) { return laws[j].probe == laws[i].probe; };
        const auto rival = std::ranges::find_if(shown, of_same_probe);
        if (rival == shown.end()) shown.push_back(i);
        else if (holds(*rival) == Holds::not_expected && holds(i) != Holds::not_expected) *rival = i;
    }
    return shown;
}

Holds Runner::holds(std::size_t i) const {
    const Conserved& c = lesson_->conserved[i];
    if (!references_[i] || (c.expected && !c.expected())) return Holds::not_expected;
    return drift(i) <= c.tolerance() ? Holds::yes : Holds::no;
}

}  // namespace pliant
