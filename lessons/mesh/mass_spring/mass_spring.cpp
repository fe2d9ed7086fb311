#include "mass_spring.h"

#include <pliant/solids/point_masses.h>
#include <pliant/time/stability.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::mass_spring {
namespace {

using std::numbers::pi;

constexpr Real slow_part = 1e-4;  // of what counts as fast, at rest

}  // namespace

std::vector<std::string_view> MassSpringLesson::first_plots() const {
    if (tested() && lattice() == LatticeKind::chain) return {"test_stiffness"};
    if (tested()) return {"modulus_by_cells", "coupling", "stiffness_ratio"};
    if (setting == Setting::swing) return {"mode", "frequency", "energy"};
    if (setting == Setting::spin && damped()) return {"rotation", "energy", telling_probe()};
    if (setting == Setting::spin) return {"energy", telling_probe(), "rotation"};
    return {"energy", telling_probe(), "largest_strain"};
}

std::vector<std::string_view> MassSpringLesson::key_numbers() const {
    if (tested() && lattice() == LatticeKind::chain) return {"test_stiffness"};
    if (tested() && block_test() == BlockTest::stretch) return {"youngs_modulus", "poisson_ratio", "stiffness_ratio"};
    if (tested()) return {"stiffness_ratio", "coupling_structural", "coupling_shear"};
    return {"energy", telling_probe(), "largest_strain"};
}

std::string_view MassSpringLesson::telling_probe() const {
    switch (setting) {
        case Setting::spin:
            return "angular_momentum";
        case Setting::hang:
            return "sag";
        case Setting::swing:
            return "frequency";
        case Setting::stretch_test:
            return "youngs_modulus";
        default:
            return "height";
    }
}

void MassSpringLesson::check() const {
    const int dimension = dimension_of(lattice());
    const Index nodes = (dimension > 1 ? cells_x + 1 : 1) * (cells_y + 1) * (dimension > 2 ? cells_z + 1 : 1);
    if ((implicit() || tested()) && nodes > most_implicit_nodes)
        throw Refused(
            fmt::format("{} with {} nodes (cells_x = {}, cells_y = {}, cells_z = {}) is not accepted: its matrix is "
                        "factorised in every step; give cells that make at most {} nodes",
                        tested() ? "scene = stretch_test" : fmt::format("integrator = {}", integrator.option_key()), nodes,
                        Index(cells_x), Index(cells_y), Index(cells_z), most_implicit_nodes));
    if (tested() && std::ranges::all_of(stiffnesses(), [](Real k) { return k == 0; }))
        throw Refused(
            fmt::format("scene = stretch_test with no springs at all is not accepted: {} = 0 N/m; give one of them a "
                        "stiffness above 0 N/m",
                        has_diagonals() ? "k_structural = k_shear = k_bending" : "k_structural = k_bending"));
    if (setting == Setting::swing) {
        if (mode_number > free_masses())
            throw Refused("mode", Real(Index(mode_number)), "",
                          fmt::format("1 to {}, one for each mass that is free (cells_y = {})", free_masses(), Index(cells_y)));
    }
}

// ------------------------------------------------------------------------------------------------------ the start

std::vector<Index> MassSpringLesson::held_nodes() const {
    if (!held()) return {};
    if (support == Support::side && setting != Setting::swing) return block_->layer(0, false);
    std::vector<Index> nodes = block_->layer(1, true);
    if (support == Support::both)
        for (const Index n : block_->layer(1, false)) nodes.push_back(n);
    return nodes;
}

Points<3> MassSpringLesson::start_positions() const {
    Points<3> x = block_->rest();
    if (setting == Setting::swing)
        for (Index n = 0; n < x.cols(); ++n) x(1, n) += swing_amplitude * edge() * mode_shape(n);
    if (!falls()) return x;
    if (setting == Setting::drop) x = Eigen::AngleAxisd(tilt * std::numbers::pi / 180, Vec<3>::UnitZ()).toRotationMatrix() * x;
    const Vec<3> lowest(0.5 * (x.row(0).minCoeff() + x.row(0).maxCoeff()), x.row(1).minCoeff(), 0);
    x.colwise() += Vec<3>(0, drop_height, 0) - lowest;
    return x;
}

Points<3> MassSpringLesson::start_velocities() const {
    Points<3> v = Points<3>::Zero(3, position_.cols());
    if (setting != Setting::spin) return v;
    const Vec<3> centre = centre_of_mass<3>(block_->mass(), position_);
    for (Index n = 0; n < v.cols(); ++n) v.col(n) = Vec<3>(0, spin_rate, 0).cross(Vec<3>(position_.col(n) - centre));
    return v;
}

void MassSpringLesson::reset() {
    integrator_.reset();
    system_.reset();
    rates_.forget();
    clock_.setZero();
    rhythm_.reset();
    test_done_ = false;
    block_ = std::make_unique<SpringBlock>(SpringLattice(lattice(), {cells_x, cells_y, cells_z}, edge()));
    follow_parameters();
    position_ = start_positions();
    velocity_ = start_velocities();
    spring_force_.setZero(3, position_.cols());
    total_force_.setZero(position_.size());
    memory_.setZero(2 + 2 * position_.size());
    for (Points<3>* force : {&damping_force_, &external_force_}) force->setZero();
    for (VecX* values : {&tension_, &strain_}) values->setZero(block_->springs().size());
    touching_ = 0;
    start_gravity_ = gravity;
    start_mass_ = total_mass;
    interfered_ = false;
    start_motion_ = kinetic_energy<3>(block_->mass(), velocity_) + elastic_energy();
    start_height_ = centre_of_mass<3>(block_->mass(), position_)[1];
    start_angular_momentum_ = angular_momentum<3>(block_->mass(), position_, velocity_).norm();
}

// ------------------------------------------------------------------------------------------------------ at rest

// Slow against a fall through one cell; where nothing falls, against the motion that the start can come to.
Real MassSpringLesson::rest_speed() const {
    if (const Real g = weight_acceleration(); g > 0) return slow_part * std::sqrt(g * edge());
    return slow_part * std::sqrt(2 * start_motion_ / total_mass) + strain_rounding * rates().omega * edge();
}

// Force that a node at rest may be left with, N.
Real MassSpringLesson::rest_force(Index node) const {
    const Real m = block_->mass()[node], g = weight_acceleration();
    return g > 0 ? 1e-2 * m * g : 0.1 * m * rates().omega * rest_speed();
}

bool MassSpringLesson::at_rest() const {
    if (tested()) return test_done_ && tests_.knows(static_key());
    if (velocity_.cwiseAbs().maxCoeff() > rest_speed()) return false;
    Points<3> force = Points<3>::Zero(3, position_.cols());
    add_spring_forces<3>(block_->springs(), position_, force);
    add_external_forces<3>({{0, -weight_acceleration(), 0}, load_.pull}, block_->mass(), position_, force);
    for (Index n = 0; n < force.cols(); ++n) {
        if (block_->inertia().fixed(3 * n)) continue;
        Vec<3> balance = force.col(n);
        if (grounded() && position_(1, n) <= 0 && balance[1] < 0) {
            const Real grip = -friction * balance[1], along = std::hypot(balance[0], balance[2]);
            balance *= along > 0 ? std::max(Real(0), 1 - grip / along) : 0;
            balance[1] = 0;
        }
        if (balance.norm() > rest_force(n)) return false;
    }
    return true;
}

std::string MassSpringLesson::unrest() const {
    if (tested() || at_rest()) return "";
    if (setting == Setting::drop && !ground && gravity > 0) return "nothing stops its fall (ground = off)";
    if (dissipates(integrator)) return "";
    if (setting == Setting::spin && spin_rate != 0 && !(has_dampers() && damping_mode == SpringDamping::naive))
        return "nothing stops its rotation: of the dampers only naive ones do (damping mode)";
    if (has_dampers()) return "";
    const bool loose = block_->springs().size() == 0;
    if (loose && grounded() && restitution < 1) return "";
    if (loose) return "it bounces without end (restitution = 1)";
    return "nothing takes the energy of its springs out (damping mode, damping)";
}

// --------------------------------------------------------------- a chain that swings in one of its modes, in closed form

// Angle from one mass of mode j to the next [BornHuang1954 §5]: pi j/(N + 1) between two supports, pi (2j - 1)/(2N + 1) below
// one.
Real MassSpringLesson::mode_shape(Index node) const {
    const Real masses = Real(free_masses()), j = Real(Index(mode_number)), from_top = Real(cells_y - node);
    return std::sin(from_top * pi * (support == Support::both ? j / (masses + 1) : (2 * j - 1) / (2 * masses + 1)));
}

Real MassSpringLesson::mode_frequency() const {
    const Real masses = Real(free_masses()), j = Real(Index(mode_number));
    const Real angle = pi * (support == Support::both ? j / (masses + 1) : (2 * j - 1) / (2 * masses + 1));
    return 2 * std::sqrt(k_structural / block_->mass()[0]) * std::sin(angle / 2);
}

// Part of the mode in the displacement now, in lengths of its start.
Real MassSpringLesson::mode_displacement() const {
    Real product = 0, norm = 0;
    for (Index n = 0; n < position_.cols(); ++n) {
        product += mode_shape(n) * (position_(1, n) - block_->rest()(1, n));
        norm += mode_shape(n) * mode_shape(n);
    }
    return norm > 0 ? product / (norm * swing_amplitude * edge()) : 0;
}

void MassSpringLesson::note_swing() {
    if (setting == Setting::swing) rhythm_.note(clock_[0], mode_displacement(), 1e-3);
}

std::optional<Real> MassSpringLesson::measured_frequency() const {
    if (setting != Setting::swing) return std::nullopt;
    const std::optional<Real> period = rhythm_.period();
    return period ? std::optional(2 * pi / *period) : std::nullopt;
}

const Registration<MassSpringLesson> registration{{.id = "mesh/mass_spring",
                                                   .title = "Mass–spring lattice",
                                                   .summary = "A net of masses and springs falls, hangs, spins, swings or is "
                                                              "tested as a material; damping and integrators show their cost.",
                                                   .demo_steps = 420}};

}  // namespace pliant::mass_spring
