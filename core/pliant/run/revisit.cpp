#include <pliant/run/revisit.h>

namespace pliant {

Revisit::Revisit(Runner& runner)
    : runner_(runner),
      here_(runner.place()),
      outer_(runner.trace_),
      pending_(runner.pending_),
      failure_(runner.failure_),
      pull_(runner.pull_),
      law_starts_(runner.law_starts_),
      base_time_(runner.base_time_),
      base_dt_(runner.base_dt_),
      base_step_(runner.base_step_),
      revision_(runner.revision_) {
    if (runner.replaying_) throw Refused("the run is already being looked back at");
    for (const Parameter* p : runner.lesson_->parameters) parameters_.push_back(p->value());
    runner_.replaying_ = true;
    runner_.trace_ = &trace_;
}

Revisit::~Revisit() {
    try {
        come_back();
    } catch (const std::exception&) {
        // The passes have run before and give the same bits, so there is nothing that could fail now.
    }
    runner_.replaying_ = false;
    runner_.trace_ = outer_;
}

bool Revisit::start_of(Index step) {
    if (step > here_.step || step < 0) return false;
    if (!runner_.history_.find(step) && Place{step, 0} != here_) return false;
    if (!runner_.restore_start(step)) return false;
    moved_ = true;
    if (!runner_.inside_step()) trace_.start(*runner_.lesson_, step);
    return true;
}

void Revisit::pass() {
    moved_ = true;
    runner_.step_pass();
}

void Revisit::come_back() {
    if (!moved_) return;
    moved_ = false;
    runner_.restore_start(here_.step);
    for (Index p = 0; p < here_.passes; ++p) runner_.step_pass();
    // What was set since this step ended is not in the stored states.
    if (here_.passes == 0)
        for (std::size_t i = 0; i < parameters_.size(); ++i) runner_.lesson_->parameters[i]->set(parameters_[i]);
    runner_.pending_ = pending_;
    runner_.failure_ = failure_;
    runner_.pull_ = pull_;
    runner_.law_starts_ = law_starts_;
    runner_.base_time_ = base_time_, runner_.base_dt_ = base_dt_, runner_.base_step_ = base_step_;
    if (here_.passes == 0) runner_.collect_active();
    runner_.revision_ = revision_;  // the same bits
}

}  // namespace pliant
