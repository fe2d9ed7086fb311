#include "rod.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant::rod {
namespace {

constexpr Real widest_pulse = 2;  // in lengths of the rod: the images behind its ends take off what reaches further

const Registration<RodLesson> registration{
    {.id = "mesh/rod",
     .title = "Elastic rod",
     .summary = "A rod's energy turns into springs that agree at every N; springs picked by hand do not.",
     .demo_steps = 150}};

}  // namespace

// ------------------------------------------------------------------------------------------------- the rod and its chains

Real RodLesson::stiffness_of(Rule rule, Index n) const {
    return rule == Rule::constant ? Real{picked_stiffness} : axial_stiffness * static_cast<Real>(n) / length;
}

// ------------------------------------------------------------------------------------------------------ the start

VecX RodLesson::start_displacements() const {
    if (setting == Setting::wave) return amplitude * mode_shape();
    VecX u = VecX::Zero(count() + 1);
    if (!runs_a_pulse()) return u;
    for (Index i = 1; i <= count(); ++i) u[i] = pulse(chain_speed()).displacement(rest_place(i), 0);
    if (end() == RodEnd::fixed) u[count()] = 0;
    return u;
}

// A segment that is turned over when it starts has no strain that |∂x/∂s| could tell, and no wave runs along it.
void RodLesson::check() const {
    if (runs_a_pulse() && pulse_width > widest_pulse * length)
        throw Refused(
            fmt::format("pulse_width = {} is not accepted: give at most twice the length of the rod, {}; a wider pulse is "
                        "none",
                        format_quantity(pulse_width, "m"), format_quantity(widest_pulse * length, "m")));
    const VecX u = start_displacements();
    Index at = 0;
    const Real slope = (u.tail(count()) - u.head(count())).minCoeff(&at) / segment();
    if (slope > -1) return;
    throw Refused(
        fmt::format("amplitude = {} is not accepted: segment {} would be turned over at the start, with ∂u/∂s = {}, and "
                    "must stay above −1; give at most {}",
                    format_quantity(amplitude, "m"), at, format_quantity(slope, "", 3),
                    format_quantity(rounded_down(-0.99 * amplitude / slope, 2), "m")));
}

void RodLesson::reset() {
    integrator_.reset();
    system_.reset();
    const Index n = segments;
    springs_ = rod_springs(n, segment(), stiffness(), damped() ? damping * stiffness() : Real{0});
    node_masses_ = VecX::Constant(n + 1, node_mass());
    std::vector<Index> held{0};
    if (end() == RodEnd::fixed) held.push_back(n);
    inertia_ = DiagonalMass(node_masses_, 2, held);
    clock_.setZero();
    rhythm_.reset();
    history_.setZero(n, hangs() ? 0 : history_rows);

    position_.resize(2, n + 1);
    velocity_.setZero(2, n + 1);
    const VecX u = start_displacements();
    for (Index i = 0; i <= n; ++i) {
        position_.col(i) = (rest_place(i) + u[i]) * along();
        if (runs_a_pulse() && !inertia_.fixed(2 * i))
            velocity_.col(i) = pulse(chain_speed()).velocity(rest_place(i), 0) * along();
    }
    for (Points<2>* field : {&gradient_force_, &spring_force_}) field->setZero(2, n + 1);
    damping_force_.setZero(2, damped() ? n + 1 : 0);
    external_force_.setZero(2, loaded() ? n + 1 : 0);
    slope_.resize(2, n);
    for (VecX* values : {&strain_, &energy_density_, &segment_energy_, &stiffness_, &tension_}) values->setZero(n);
    for (VecX* values : {&added_tension_, &move_}) values->setZero(n + 1);
    slope_stage();
    if (history_.size() > 0) rod_strains(slope_, history_.col(0));
    follow_positions();
    start_energy_ = total_energy();
    start_motion_ = motion_energy();
    start_position_ = runs_a_pulse() ? pulse_position() : Real{0};
    if (hangs_still()) return;

    system_ = std::make_unique<SpringSystem<2>>(springs_, node_masses_);
    system_->damping = damped() ? SpringDamping::projected : SpringDamping::none;
    system_->load.gravity = weight_acceleration() * along();
    integrator_ = std::make_unique<TimeIntegrator>(*system_, inertia_, scheme);
}

}  // namespace pliant::rod
