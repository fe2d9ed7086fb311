// What the stages of a motion do.
#include "fem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pliant::fem {

// Where it starts, and how fast.
void FemLesson::start_moving() {
    position_ = solid_->rest();
    if (is(Setting::drop)) {
        const Small R = Eigen::AngleAxisd(tilt * one_degree, Vec<3>::UnitZ()).toRotationMatrix();
        position_ = R * solid_->rest();
        position_.row(1).array() += drop_height - position_.row(1).minCoeff();
    }
    start_position_ = position_;
    motion_ = make_motion(*solid_, solid_->mass(density, lumped()));
    if (is(Setting::spin)) {
        const Vec<3> middle = centre();
        for (Index n = 0; n < position_.cols(); ++n)
            velocity_.col(n) = Vec<3>(0, 0, spin_rate).cross(Vec<3>(position_.col(n) - middle));
    }
    follow_positions();
    volume_ = solid_->volumes();
    full_load(load_);
}

void FemLesson::damp() {
    VecX inertia;
    motion_->mass().multiply(flat(velocity_), inertia);
    flat(damping_force_) = -alpha() * inertia;
    if (stiffness_damping > 0) flat(damping_force_) -= stiffness_damping * (damping_stiffness() * flat(velocity_));
}

// K of the damping: that of rest of a linear body, else that of the start of the step without negative eigenvalues.
SparseMatrix FemLesson::damping_stiffness() const {
    if (law() == Law::linear) return solid_->stiffness(MatX::Zero(displacement_.rows(), displacement_.cols()), false);
    return solid_->stiffness(displacement_, true);
}

void FemLesson::act_from_outside() {
    full_load(load_);
    external_force_ = load_;
    external_force_.row(1) -= weight_acceleration() * motion_->node_mass().transpose();
    if (pull_)
        external_force_.col(pull_->index) += pull_stiffness * (pull_->to.head(solid_->dim()) - position_.col(pull_->index));
}

void FemLesson::begin_integration() {
    pulled_ever_ = pulled_ever_ || pull_;
    Acting acting{.load = load_,
                  .gravity = weight_acceleration(),
                  .mass_damping = alpha(),
                  .stiffness_damping = stiffness_damping,
                  .ground = is(Setting::drop),
                  .friction = is(Setting::drop) ? Real{friction} : Real{0}};
    if (pull_) acting.pulled = pull_->index, acting.target = pull_->to, acting.pull_stiffness = pull_stiffness;
    motion_->follow(acting);
    MatX force = external_force_ - internal_;
    if (damped()) force += damping_force_;
    motion_->begin(scheme(), dt, position_, velocity_, force, NewtonOptions{});
}

// One evaluation of the forces, or one iteration of Newton's method.
void FemLesson::integrate() {
    motion_->pass(position_, velocity_);
    follow_positions();
}

void FemLesson::end_integration() {
    motion_->finish(position_, velocity_);
    follow_positions();
    clock_[0] += dt;
}

void FemLesson::meet_ground() {
    motion_->meet_ground(position_, velocity_);
    follow_positions();
}

// ------------------------------------------------------------------------------------------------------- what comes to rest

Vec<3> FemLesson::centre() const {
    Vec<3> sum = Vec<3>::Zero();
    const VecX& mass = motion_->node_mass();
    for (Index n = 0; n < position_.cols(); ++n) sum.head(solid_->dim()) += mass[n] * position_.col(n);
    return sum / mass.sum();
}

Vec<3> FemLesson::momentum() const {
    Vec<3> sum = Vec<3>::Zero();
    sum.head(solid_->dim()) = velocity_ * motion_->node_mass();
    return sum;
}

Vec<3> FemLesson::angular_momentum() const {
    Vec<3> sum = Vec<3>::Zero();
    const VecX& mass = motion_->node_mass();
    const Vec<3> middle = centre();
    for (Index n = 0; n < position_.cols(); ++n) {
        Vec<3> arm = -middle, v = Vec<3>::Zero();
        arm.head(solid_->dim()) += position_.col(n), v.head(solid_->dim()) = velocity_.col(n);
        sum += mass[n] * arm.cross(v);
    }
    return sum;
}

Real FemLesson::kinetic_energy() const { return 0.5 * motion_->mass().square(flat(velocity_)); }

// With that of weight and load, but not of the hand.
Real FemLesson::total_energy() const {
    const Real weight = weight_acceleration() * motion_->node_mass().dot(position_.row(1));
    return kinetic_energy() + solid_->energy(displacement_) + weight - load_.cwiseProduct(displacement_).sum();
}

// Slow against a fall through the body, and what moves it small against its weight or load.
bool FemLesson::at_rest() const {
    if (!moving()) return done_[0] != 0 && pull_ == solved_pull_;
    const Real size = solid_mesh::size_at_rest(*solid_), mass = motion_->node_mass().sum();
    const Real acting = mass * weight_acceleration() + force().norm() + (pull_ ? pull_stiffness * size : 0);
    if (!(acting > 0)) return velocity_.cwiseAbs().maxCoeff() == 0;
    return velocity_.cwiseAbs().maxCoeff() < 1e-4 * std::sqrt(acting / mass * size);
}

std::string FemLesson::unrest() const {
    if (!moving() || at_rest()) return "";
    if (is(Setting::spin)) return spin_rate != 0 ? "nothing stops its rotation (spin)" : "";
    if (is(Setting::drop) || implicit() || damped()) return "";
    return "nothing takes the energy of its vibrations out (mass damping, stiffness damping)";
}

}  // namespace pliant::fem
