#include <pliant/time/time_integrator.h>

namespace pliant {

TimeIntegrator::TimeIntegrator(SecondOrderSystem& system, const Mass& mass, Scheme scheme, NewtonOptions options)
    : system_(system), mass_(mass), options_(options), scheme_(scheme) {
    for (VecX* values : {&start_x_, &start_v_, &x_, &v_, &force_}) values->setZero(mass.size());
    scheme_ = scheme == Scheme::bdf2 ? Scheme::explicit_euler : Scheme::bdf2;  // any other
    set_scheme(scheme);
}

void TimeIntegrator::set_scheme(Scheme scheme) {
    if (scheme == scheme_) return;
    scheme_ = scheme;
    solver_.reset();
    if (is_implicit(scheme)) solver_.emplace(system_, mass_, options_);

    // One acceleration for each force evaluation, or that of the start.
    const std::size_t stages = is_implicit(scheme) ? std::size_t{scheme == Scheme::newmark} : nystrom_table(scheme).size() - 1;
    for (std::size_t i = 0; i < accelerations_.size(); ++i) accelerations_[i].setZero(i < stages ? mass_.size() : 0);
    const Index remembered = scheme == Scheme::bdf2 ? 2 : scheme == Scheme::velocity_verlet ? 1 : 0;
    memory_.setZero(remembered ? 1 + remembered * mass_.size() : 0);
}

void TimeIntegrator::set_options(NewtonOptions options) {
    options_ = options;
    if (solver_) solver_->set_options(options);
}

void TimeIntegrator::forget() {
    if (memory_.size() > 0) memory_[0] = 0;
}

void TimeIntegrator::begin(Real dt, ConstDofs x, ConstDofs v, const VecX* force) {
    require_time_step(dt);
    dt_ = dt;
    passes_ = 0;
    start_x_ = x;
    start_v_ = v;
    if (implicit())
        begin_implicit(force);
    else
        begin_explicit(force);
}

void TimeIntegrator::begin_explicit(const VecX* force) {
    x_ = start_x_;
    v_ = start_v_;
    first_known_ = force || remembers();
    if (force)
        mass_.accelerate(*force, accelerations_[0]);
    else if (remembers())
        accelerations_[0] = memory_.tail(mass_.size());
}

void TimeIntegrator::begin_implicit(const VecX* force) {
    ImplicitForm& form = solver_->form();
    const Index n = mass_.size();
    if (scheme_ == Scheme::implicit_midpoint) {
        implicit_midpoint(dt_, start_x_, start_v_, form);
    } else if (scheme_ == Scheme::newmark) {
        // A force that the step's frozen damping took part in: the average of both ends is then one of second order.
        x_ = start_x_;
        v_ = start_v_;
        if (force && !system_.damped()) {
            mass_.accelerate(*force, accelerations_[0]);
        } else {
            force_ = start_x_ + dt_ / 2 * start_v_;
            system_.begin_step(force_);
            evaluate(accelerations_[0]);
        }
        newmark(dt_, start_x_, start_v_, accelerations_[0], form);
    } else if (remembers()) {
        bdf2(dt_, memory_[0], start_x_, start_v_, memory_.segment(1, n), memory_.tail(n), form);
    } else {
        implicit_euler(dt_, start_x_, start_v_, form);
    }
    // The midpoint rule solves for the middle of the step.
    if (lower_bound_.size() > 0 && scheme_ == Scheme::implicit_midpoint)
        form.lower_bound = (lower_bound_ + start_x_) / 2;
    else
        form.lower_bound = lower_bound_;
    solver_->begin(start_x_);
}

Real TimeIntegrator::impulse_time() const {
    const ImplicitForm& form = solver_->form();
    return (scheme_ == Scheme::implicit_midpoint ? 2 : 1) * form.velocity_rate / form.acceleration_rate;
}

bool TimeIntegrator::again() const {
    if (implicit()) return solver_->again();
    return passes_ + 1 < static_cast<Index>(nystrom_table(scheme_).size());
}

void TimeIntegrator::pass() {
    if (implicit())
        solver_->iterate();
    else
        explicit_pass();
    ++passes_;
}

void TimeIntegrator::evaluate(VecX& acceleration) {
    system_.force(x_, v_, force_);
    mass_.accelerate(force_, acceleration);
    ++force_evaluations_;
}

void TimeIntegrator::explicit_pass() {
    if (passes_ > 0 || !first_known_) {
        system_.begin_step(x_);
        evaluate(accelerations_[static_cast<std::size_t>(passes_)]);
    }
    // The next row of the table: where the next force is evaluated, or the end of the step.
    const NystromRow& row = nystrom_table(scheme_)[static_cast<std::size_t>(passes_ + 1)];
    x_ = start_x_ + row.c * dt_ * start_v_;
    v_ = start_v_;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(passes_); ++j) {
        if (row.position[j] != 0) x_ += row.position[j] * dt_ * dt_ * accelerations_[j];
        if (row.velocity[j] != 0) v_ += row.velocity[j] * dt_ * accelerations_[j];
    }
}

void TimeIntegrator::finish(Dofs x, Dofs v) {
    if (implicit()) {
        x_ = start_x_;
        v_ = start_v_;
        solver_->finish(x_, v_);
        if (scheme_ == Scheme::implicit_midpoint) {
            x_ = 2 * x_ - start_x_;
            for (Index d = 0; d < v_.size(); ++d)
                if (!mass_.fixed(d)) v_[d] = 2 * v_[d] - start_v_[d];
        }
    }
    remember();
    x = x_;
    v = v_;
}

void TimeIntegrator::remember() {
    const Index n = mass_.size();
    if (scheme_ == Scheme::bdf2) {
        memory_[0] = dt_;
        memory_.segment(1, n) = start_x_;
        memory_.tail(n) = start_v_;
    } else if (scheme_ == Scheme::velocity_verlet) {
        // The last force was evaluated at the end's positions, and is that of the next start where velocities do not matter.
        memory_[0] = system_.damped() ? 0 : 1;
        memory_.tail(n) = accelerations_[1];
    }
}

void TimeIntegrator::step(Real dt, Dofs x, Dofs v) {
    begin(dt, x, v);
    while (again()) pass();
    finish(x, v);
}

}  // namespace pliant
