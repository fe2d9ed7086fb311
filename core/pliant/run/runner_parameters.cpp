// How parameters, scenes and events reach a lesson; how a run starts.
#include <pliant/math/watch.h>
#include <pliant/run/runner.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace pliant {

Runner::Writes Runner::parse(const Assignments& assignments) const {
    Writes values;
    for (const auto& [key, text] : assignments) {
        Parameter& p = lesson_->parameter(key);
        values.emplace_back(&p, p.parse(text));
    }
    return values;
}

void Runner::check(const LessonEntry& entry, const Assignments& assignments, const std::vector<Event>& events) {
    const auto lesson = entry.make();
    for (const auto& [key, text] : assignments) {
        Parameter& p = lesson->parameter(key);
        p.set(p.parse(text));
    }
    lesson->check();
    for (const Event& e : events)
        for (const auto& [key, text] : e.assign) lesson->parameter(key).parse(text);
}

Runner::Writes Runner::own(const Values& values) const {
    Writes writes;
    for (const auto& [parameter, value] : values) {
        const auto found = std::ranges::find(lesson_->parameters, parameter);
        if (found == lesson_->parameters.end()) throw std::logic_error("a parameter of another lesson is assigned");
        writes.emplace_back(*found, value);
    }
    return writes;
}

void Runner::write(const Writes& values) {
    ++revision_;
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

namespace {
bool looks(const std::pair<Parameter*, Real>& write) { return write.first->looks(); }
}  // namespace

// The run stays where it is, and what it has been.
void Runner::look(const Writes& values) {
    write(values);
    lesson_->looked();
    note_assigned(values);
}

void Runner::write_or_reset(const Writes& values) {
    if (std::ranges::all_of(values, looks)) return look(values);
    // What was run before after this place is another future now.
    reach_ = place();
    const bool rebuild = std::ranges::any_of(
        values, [](const auto& v) { return v.first->info.effect == Effect::rebuild && v.first->value() != v.second; });
    if (!rebuild && inside_step()) {
        for (const auto& [parameter, value] : values) parameter->check(value);
        Writes at_once, later = values;
        std::ranges::copy_if(values, std::back_inserter(at_once), looks);
        std::erase_if(later, looks);
        look(at_once);
        note_assigned(later);
        pending_.insert(pending_.end(), later.begin(), later.end());
        return;
    }
    std::vector<Real> before;
    for (const Parameter* p : lesson_->parameters) before.push_back(p->value());
    write(std::exchange(pending_, {}));  // what waited for the next step counts in the run that begins
    write(values);
    if (!rebuild) return note_assigned(values), renew_laws();
    try {
        reset_or_leave();
    } catch (const Error&) {
        for (std::size_t i = 0; i < before.size(); ++i) lesson_->parameters[i]->set(before[i]);
        reset();
        throw;
    }
}

// Inside a step they take effect with the next one; before anything has run they are what the run begins with.
void Runner::note_assigned(const Writes& values) {
    for (const auto& [parameter, value] : values)
        if (parameter->looks())
            recording_.look_at(*parameter, value);
        else if (parameter->info.effect == Effect::live)
            recording_.assign(*parameter, value, inside_step() ? step_ + 1 : step_, place() == Place{});
}

void Runner::load(const Assignments& assignments) {
    Writes values;
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

namespace {
bool same(const std::optional<Pull>& a, const std::optional<Pull>& b) {
    return a.has_value() == b.has_value() && (!a || (a->index == b->index && a->from == b->from && a->to == b->to));
}
}  // namespace

void Runner::pull(const std::optional<Pull>& pull) {
    if (same(pull, pull_)) return;
    pull_ = pull;
    reach_ = place();
    recording_.pull(pull, inside_step() ? step_ + 1 : step_);
}

void Runner::set_events(std::vector<Event> events) {
    std::ranges::stable_sort(events, {}, &Event::step);
    for (const Event& e : events) parse(e.assign);
    events_ = std::move(events);
}

void Runner::apply_events() {
    for (const std::vector<Event>* list : {&std::as_const(events_), &recording_.events()})
        for (auto e = std::ranges::lower_bound(*list, step_, {}, &Event::step); e != list->end() && e->step == step_; ++e)
            apply(*e);
}

void Runner::apply(const Event& e) {
    Writes values = parse(e.assign);
    // Going back, one looks at the same thing as before.
    if (replaying_) std::erase_if(values, looks);
    if (!values.empty()) write(values), renew_laws();
    if (e.pull) pull_ = e.pull;
    if (e.release) pull_.reset();
}

void Runner::reset() {
    const Uncancelled begun;             // there is nothing to go back to
    write(std::exchange(pending_, {}));  // as it stands on the sliders
    reset_or_leave();
}

// Called off, it leaves the lesson half made.
void Runner::reset_or_leave() {
    lesson_->check();
    pending_.clear();
    pull_.reset();
    history_.clear();
    std::ranges::fill(costs_, StageCost{});
    step_ms_ = 0;
    recording_.begin(*lesson_);
    start_fresh();
    reach_ = place();
}

// The initial state, without touching the stored past.
void Runner::start_fresh() {
    ++revision_;
    lesson_->pull(std::nullopt);
    lesson_->reset();
    failure_.reset();
    step_ = passes_ = stage_passes_ = base_step_ = 0;
    base_time_ = 0, base_dt_ = lesson_->time_step();
    stage_ = 0;
    last_stage_.reset();
    executed_.clear(), executed_before_.clear();
    collect_active();
    renew_laws();
}

// In place: whoever goes through the stages may have the run go back and forth meanwhile.
void Runner::collect_active() {
    const auto used = lesson_->stages_in_use();
    active_.assign(used.begin(), used.end());
}

}  // namespace pliant
