#include "mass_spring.h"

#include <pliant/solids/point_masses.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::mass_spring {
namespace {

ParameterInfo cells_along(std::string_view key, std::string_view symbol, Real initial) {
    return {.key = key,
            .symbol = symbol,
            .help = "cells of the lattice along this axis",
            .initial = initial,
            .useful = {1, 10},
            .accepted = Interval{1, 40},
            .effect = Effect::rebuild};
}

ParameterInfo stiffness_of(std::string_view key, std::string_view symbol, std::string_view help, Real initial) {
    return {.key = key,
            .symbol = symbol,
            .unit = "N/m",
            .help = help,
            .initial = initial,
            .useful = {1, 1e5},
            .accepted = Interval{0, 1e15},
            .scale = Scale::log};
}

}  // namespace

MassSpringLesson::MassSpringLesson()
    : setting(*this, {.key = "scene", .help = "what happens to the block", .effect = Effect::rebuild},
              {{"drop", "dropped on the ground"}, {"hang", "held at one face"}, {"spin", "spinning freely, no gravity"}}),
      support(*this,
              {.key = "support", .help = "the face that is held", .effect = Effect::rebuild, .used = [this] { return held(); }},
              {{"top", "top: it hangs"}, {"side", "side: it is a beam"}}),
      cells_x(*this, cells_along("cells_x", "nₓ", 4)),
      cells_y(*this, cells_along("cells_y", "n_y", 4)),
      cells_z(*this, cells_along("cells_z", "n_z", 4)),
      size(*this, {.key = "size",
                   .symbol = "L",
                   .unit = "m",
                   .help = "length of the block along x; its cells are cubes of edge L / nₓ",
                   .initial = 0.5,
                   .useful = {0.05, 5},
                   .accepted = Interval{1e-6, 1e6},
                   .scale = Scale::log,
                   .effect = Effect::rebuild}),
      total_mass(*this, {.key = "mass",
                         .symbol = "M",
                         .unit = "kg",
                         .help = "of the whole block, shared equally by its nodes",
                         .initial = 1,
                         .useful = {0.01, 100},
                         .accepted = Interval{1e-9, 1e9},
                         .scale = Scale::log}),
      k_structural(*this,
                   stiffness_of("k_structural", "kₛ", "of the springs along the edges of the cells; 0 leaves them out", 200)),
      k_shear(*this, stiffness_of("k_shear", "k_d", "of the springs along the diagonals of the faces; 0 leaves them out", 100)),
      k_bending(*this, stiffness_of("k_bending", "k_b", "of the springs to the next node but one; 0 leaves them out", 20)),
      damping_mode(*this, {.key = "damping_mode", .help = "which relative velocity of a spring's ends is damped", .initial = 2},
                   {{"none", "none"}, {"naive", "naive: k_d (vⱼ − vᵢ)"}, {"projected", "projected: along the spring"}}),
      damping(*this, {.key = "damping",
                      .symbol = "kᵈ",
                      .unit = "N s/m",
                      .help = "of every spring",
                      .initial = 0.05,
                      .useful = {1e-3, 10},
                      .accepted = Interval{0, 1e12},
                      .scale = Scale::log,
                      .used = [this] { return damped(); }}),
      gravity(*this, {.key = "gravity",
                      .symbol = "g",
                      .unit = "m/s²",
                      .help = "acceleration of gravity, downwards",
                      .initial = 9.81,
                      .useful = {0, 20},
                      .accepted = Interval{0, 1e6},
                      .used = [this] { return setting != Setting::spin; }}),
      integrator(*this, {.key = "integrator", .help = "how forces become motion", .initial = 1},
                 {{"explicit_euler", "explicit Euler"},
                  {"semi_implicit_euler", "semi-implicit Euler"},
                  {"implicit_euler", "implicit Euler"}}),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "fixed",
                 .initial = 1e-3,
                 .useful = {1e-5, 0.1},
                 .accepted = Interval{0, 10, true},
                 .scale = Scale::log}),
      drop_height(*this, {.key = "drop_height",
                          .symbol = "h₀",
                          .unit = "m",
                          .help = "of the block's lowest point above the ground at the start",
                          .initial = 0.5,
                          .useful = {0, 2},
                          .accepted = Interval{0, 1e6},
                          .effect = Effect::rebuild,
                          .used = [this] { return setting != Setting::spin; }}),
      tilt(*this, {.key = "tilt",
                   .symbol = "φ",
                   .unit = "°",
                   .help = "of the block about the z axis at the start",
                   .initial = 25,
                   .useful = {-45, 45},
                   .accepted = Interval{-360, 360},
                   .effect = Effect::rebuild,
                   .used = [this] { return setting == Setting::drop; }}),
      spin_rate(*this, {.key = "spin",
                        .symbol = "Ω",
                        .unit = "rad/s",
                        .help = "angular velocity at the start, about the vertical axis",
                        .initial = 10,
                        .useful = {0, 30},
                        .accepted = Interval{-1e6, 1e6},
                        .effect = Effect::rebuild,
                        .used = [this] { return setting == Setting::spin; }}),
      ground(*this, {.key = "ground",
                     .help = "is there a floor at y = 0?",
                     .initial = 1,
                     .used = [this] { return setting != Setting::spin; }}),
      restitution(*this, {.key = "restitution",
                          .symbol = "e",
                          .help = "rebound speed of a node over its impact speed",
                          .initial = 0,
                          .useful = {0, 1},
                          .used = [this] { return grounded(); }}),
      friction(*this, {.key = "friction",
                       .symbol = "μ",
                       .help = "Coulomb's coefficient of the ground",
                       .initial = 0.5,
                       .useful = {0, 1.5},
                       .accepted = Interval{0, 1e6},
                       .used = [this] { return grounded(); }}),
      pull_stiffness(*this, {.key = "pull_stiffness",
                             .symbol = "kₕ",
                             .unit = "N/m",
                             .help = "of the spring of length 0 from a node to the pointer that pulls it",
                             .initial = 50,
                             .useful = {1, 1e4},
                             .accepted = Interval{0, 1e12},
                             .scale = Scale::log}),
      newton_tolerance(*this, {.key = "newton_tolerance",
                               .symbol = "τ",
                               .help = "Newton's method stops when its step is shorter than this fraction of a spring",
                               .initial = 1e-9,
                               .useful = {1e-12, 1e-2},
                               .accepted = Interval{1e-14, 1, false, true},
                               .scale = Scale::log,
                               .used = [this] { return implicit(); }}),
      newton_cap(*this, {.key = "newton_iterations",
                         .help = "most iterations of a time step; a step that needs more is reported, not accepted",
                         .initial = 100,
                         .useful = {1, 100},
                         .accepted = Interval{1, 10000},
                         .used = [this] { return implicit(); }}) {
    declare_fields();
    declare_stages();
    declare_probes();
    explain_probes();
    declare_checks();
}

void MassSpringLesson::check() const {
    const Index nodes = (cells_x + 1) * (cells_y + 1) * (cells_z + 1);
    if (implicit() && nodes > most_implicit_nodes)
        throw Refused(
            fmt::format("integrator = implicit_euler with {} nodes (cells_x = {}, cells_y = {}, cells_z = {}) is not "
                        "accepted: its matrix is factorised in every step; give cells that make at most {} nodes",
                        nodes, Index(cells_x), Index(cells_y), Index(cells_z), most_implicit_nodes));
}

// ------------------------------------------------------------------------------------------------------ the start

std::vector<Index> MassSpringLesson::held_nodes() const {
    if (!held()) return {};
    return support == Support::top ? block_->layer(1, true) : block_->layer(0, false);
}

Points<3> MassSpringLesson::start_positions() const {
    Points<3> x = block_->rest();
    if (setting == Setting::spin) return x;
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
    solver_.reset();
    system_.reset();
    rates_key_.reset();
    block_ = std::make_unique<SpringBlock>(NodeLattice<3>::Cells{cells_x, cells_y, cells_z}, size / Real(Index(cells_x)));
    follow_parameters();
    position_ = start_positions();
    velocity_ = start_velocities();
    for (Points<3>* force : {&spring_force_, &total_force_}) force->setZero(3, position_.cols());
    for (Points<3>* force : {&damping_force_, &external_force_}) force->setZero();
    for (VecX* values : {&tension_, &strain_}) values->setZero(block_->springs().size());
    touching_ = 0;
    energy_wobble_ = 0;
    start_gravity_ = gravity;
    start_mass_ = total_mass;
    interfered_ = false;
    start_height_ = centre_of_mass<3>(block_->mass(), position_)[1];
    start_angular_momentum_ = angular_momentum<3>(block_->mass(), position_, velocity_).norm();
}

const Registration<MassSpringLesson> registration{{.id = "mesh/mass_spring",
                                                   .title = "Mass–spring lattice",
                                                   .summary = "A soft block of masses and springs falls, hangs or spins; damping "
                                                              "and three integrators show what they cost.",
                                                   .demo_steps = 420}};

}  // namespace pliant::mass_spring
