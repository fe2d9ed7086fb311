// How a run goes back: a stored state, run forward again to the wanted place.
#include <pliant/math/watch.h>
#include <pliant/run/runner.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {

std::string place_words(Place place) {
    if (place.passes == 0) return fmt::format("step {}", place.step);
    return fmt::format("step {}, {} {} done", step_number(place), place.passes, place.passes == 1 ? "pass" : "passes");
}

void Runner::store_snapshot() {
    Snapshot& s = history_.add(step_);
    s.base_step = base_step_, s.base_time = base_time_, s.base_dt = base_dt_;
    s.parameters.clear();
    for (const Parameter* p : lesson_->parameters) s.parameters.push_back(p->value());
    s.pull = pull_;
    s.law_starts = law_starts_;
    save_state(*lesson_, s.state);
    history_.added();
}

void Runner::restore(const Snapshot& s) {
    ++revision_;
    for (std::size_t i = 0; i < s.parameters.size(); ++i)
        if (!lesson_->parameters[i]->looks()) lesson_->parameters[i]->set(s.parameters[i]);
    if (s.step == 0) start_fresh();
    load_state(*lesson_, s.state);
    pull_ = s.pull;
    lesson_->pull(pull_);
    law_starts_ = s.law_starts;
    base_step_ = s.base_step, base_time_ = s.base_time, base_dt_ = s.base_dt;
    step_ = s.step;
    passes_ = stage_passes_ = 0;
    stage_ = 0;
    last_stage_.reset();
    executed_.clear();
    pending_.clear();
    failure_.reset();
    collect_active();
}

// To the start of a step. The fields are those that the step before it left, so that one is run again.
bool Runner::restore_start(Index step) {
    const Snapshot* wanted = history_.find(step);
    const Snapshot* before = history_.find(step - 1);
    if (step == 0) {
        if (wanted)
            restore(*wanted);
        else if (step_ > 0 || inside_step())
            return false;
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
    if (to.step < 0 || to.passes < 0 || to > reach_) return false;
    const Uncancelled replay;
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
    if (found) recording_.back_to(to.step);
    return found;
}

bool Runner::pass_back() {
    if (passes_ > 0) return go_to({step_, passes_ - 1});
    return !executed_before_.empty() && go_to({step_ - 1, executed_before_.back().end - 1});
}

bool Runner::stage_back() {
    const bool inside = inside_step();
    const std::vector<Execution>& done = inside ? executed_ : executed_before_;
    const Index now = inside ? passes_ : (done.empty() ? 0 : done.back().end);
    Index target = 0;
    for (const Execution& e : done)
        if (e.end < now) target = e.end;
    if (!inside && done.empty()) return false;
    return go_to({inside ? step_ : step_ - 1, target});
}

// Inside a step, to the same stage and pass of the step before, as far as that has as many.
bool Runner::step_back() {
    if (!inside_step()) return step_ > 0 && go_to({step_ - 1, 0});
    const std::vector<Execution>& before = executed_before_;
    if (step_ == 0 || before.empty()) return go_to({step_, 0});
    const std::size_t done = std::min(executed_.size(), before.size());
    const Index passes = (done > 0 ? before[done - 1].end : 0) + passes_in_stage();
    return go_to({step_ - 1, std::min(passes, before.back().end - 1)});
}

}  // namespace pliant
