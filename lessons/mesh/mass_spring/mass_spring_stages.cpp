#include "kits/springs/net_picture.h"
#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {

// Brings springs, masses and loads up to the parameters of this step. What the scene does not use has no memory.
void MassSpringLesson::follow_parameters() {
    const bool new_springs = block_->set_springs(stiffnesses(), damping, tested() ? Real{1} : Real{rest_length_scale});
    block_->set_mass(total_mass, held_nodes());
    load_.gravity = Vec<3>(0, -weight_acceleration(), 0);
    load_.pull.stiffness = pull_stiffness;
    interfered_ = interfered_ || gravity != start_gravity_ || total_mass != start_mass_;
    if (new_springs) {
        integrator_.reset();
        system_.reset();
    }
    const Index nodes = block_->rest().cols(), springs = block_->springs().size();
    const auto keep = [nodes](Points<3>& force, bool used) {
        if (force.cols() != (used ? nodes : 0)) force.setZero(3, used ? nodes : 0);
    };
    keep(damping_force_, damped());
    keep(external_force_, loaded());
    for (VecX* values : {&tension_, &strain_})
        if (values->size() != springs) values->setZero(springs);
}

void MassSpringLesson::pull(const std::optional<Pull>& hand) {
    if (springs::take_hold(load_, hand, position_.cols())) interfered_ = true;
}

void MassSpringLesson::spring_stage() {
    follow_parameters();
    spring_force_.setZero();
    add_spring_forces<3>(block_->springs(), position_, spring_force_);
    spring_tension<3>(block_->springs(), position_, tension_);
    spring_strain<3>(block_->springs(), position_, strain_);
    // Lengths are known to their rounding, which would be all there is to see in free fall.
    for (Index s = 0; s < strain_.size(); ++s)
        if (block_->springs().rest_length()[s] > 0 && std::abs(strain_[s]) < strain_rounding) tension_[s] = strain_[s] = 0;
}

void MassSpringLesson::begin_integration() {
    total_force_ = flat(spring_force_);
    if (damped()) total_force_ += flat(damping_force_);
    if (loaded()) total_force_ += flat(external_force_);

    const NewtonOptions options{newton_tolerance, static_cast<int>(Index(newton_cap))};
    if (!integrator_) {
        system_ = std::make_unique<SpringSystem<3>>(block_->springs(), block_->mass());
        integrator_ = std::make_unique<TimeIntegrator>(*system_, block_->inertia(), integrator, options);
    }
    integrator_->set_scheme(integrator);
    integrator_->set_options(options);
    recall_memory();
    system_->damping = damping_mode;
    system_->load = load_;
    if (grounded())
        set_ground_bounds<3>(ground_plane(), position_, integrator_->lower_bound());
    else
        integrator_->lower_bound().resize(0);
    contact_.begin(dt, position_, velocity_);
    integrator_->begin(dt, flat(position_), flat(velocity_), &total_force_);
}

// What lives between steps is part of the state, of one size for all schemes, since a run may go back: the number of the scheme
// from 1 on, 0 where nothing is remembered, then its memory.
void MassSpringLesson::store_memory() {
    memory_.setZero();
    const VecX& memory = integrator_->memory();
    if (memory.size() == 0) return;
    memory_[0] = integrator.value() + 1;
    memory_.segment(1, memory.size()) = memory;
}

void MassSpringLesson::recall_memory() {
    VecX& memory = integrator_->memory();
    if (memory_[0] == integrator.value() + 1)
        memory = memory_.segment(1, memory.size());
    else
        integrator_->forget();
}

// One Newton iteration, or one evaluation of the forces; where it has led to can be looked at.
void MassSpringLesson::integrate() {
    integrator_->pass();
    flat(position_) = integrator_->position();
    flat(velocity_) = integrator_->velocity();
    for (Index d = 0; d < velocity_.size(); ++d)
        if (block_->inertia().fixed(d)) velocity_.data()[d] = 0;
}

void MassSpringLesson::end_integration() {
    integrator_->finish(flat(position_), flat(velocity_));
    store_memory();
    clock_[0] += dt;
    note_swing();
}

void MassSpringLesson::contact_stage() {
    if (implicit()) contact_.arrest(*integrator_, block_->inertia());
    const auto force = [this](ConstDofs x, ConstDofs v, Dofs f) {
        system_->begin_step(x);
        system_->force(x, v, f);
    };
    touching_ = contact_.resolve(ground_plane(), block_->inertia(), integrator, force, position_, velocity_);
    // A step that starts from what the ground has changed does not follow from the one before.
    if (touching_ > 0) memory_[0] = 0;
}

}  // namespace pliant::mass_spring
