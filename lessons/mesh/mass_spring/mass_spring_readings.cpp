// Probes and conserved quantities; and the static scene: the net between two plates, measured as a material, with a solid of the
// same modulus beside it.
#include "mass_spring.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {

void MassSpringLesson::declare_probes() {
    const auto joules = [](std::string_view name, std::string_view symbol, std::string_view help, std::function<Real()> value) {
        return probe_of(name, symbol, "J", help, std::move(value));
    };
    probes = {
        joules("energy", "E", "kinetic, elastic and gravitational, and of the hand's spring", [this] { return total_energy(); }),
        joules("kinetic_energy", "K", "½ Σ m v²", [this] { return kinetic_energy<3>(block_->mass(), velocity_); }),
        joules("elastic_energy", "U", "½ Σ k (|xᵢⱼ| − l)²", [this] { return elastic_energy(); }),
        joules("gravitational_energy", "V", "Σ m g y",
               [this] {
                   return gravitational_energy<3>(block_->mass(), {0, -weight_acceleration(), 0}, position_);
               }),
        probe_of("shadow_energy", "Ẽ", "J", "E + Δt/2 v·f, which semi-implicit Euler conserves in place of the energy",
                 [this] { return shadow_energy(); }),
        probe_of(
            "damping_power", "P", "W", "that the dampers take out of the motion; 0 for a rigid rotation if they are projected",
            [this] {
                return damped() ? std::optional<Real>(damping_power<3>(block_->springs(), damping_mode, position_, velocity_))
                                : std::nullopt;
            }),
        probe_of("frequency", "ω", "rad/s",
                 "of a chain that swings, from its passages through the middle; exact: of its mode, without damping",
                 [this] { return measured_frequency(); })
            .exactly([this](Real) {
                return setting != Setting::swing || interfered_ || k_bending > 0 || damped() || rest_length_scale != 1 ||
                               k_structural == 0
                           ? std::nullopt
                           : std::optional<Real>(mode_frequency());
            }),
        probe_of("momentum", "p", "kg m/s", "magnitude of Σ m v",
                 [this] { return momentum<3>(block_->mass(), velocity_).norm(); }),
        probe_of("angular_momentum", "J", "kg m²/s", "magnitude, about the centre of mass",
                 [this] { return angular_momentum<3>(block_->mass(), position_, velocity_).norm(); })
            .exactly([this](Real) {
                return setting != Setting::spin || interfered_ ? std::nullopt : std::optional<Real>(start_angular_momentum_);
            }),
        probe_of("height", "h", "m", "of the centre of mass", [this] { return centre_of_mass<3>(block_->mass(), position_)[1]; })
            .exactly([this](Real t) { return falling_height(t); }),
        probe_of("largest_strain", "ε", "", "largest |strain| of a spring", [this] { return stretch(); }).once("stretch"),
        probe_of("sag", "s", "m", "by how much the face opposite to the held one (the lower one) hangs lower than at rest",
                 [this] { return sag(); }),
        probe_of("touching_nodes", "", "", "nodes on the ground",
                 [this] { return grounded() ? std::optional<Real>(touching_) : std::nullopt; }),
        probe_of("newton_iterations_used", "", "", "of the latest time step",
                 [this] {
                     return !implicit() || !integrator_ || tested() || integrator_->scheme() != integrator
                                ? std::nullopt
                                : std::optional<Real>(integrator_->solver().iterations());
                 }),
    };
    // A static test has small displacements, drawn larger: these are not its numbers.
    for (Probe& probe : probes)
        probe.value = [this, value = std::move(probe.value)] { return tested() ? std::nullopt : value(); };
    for (Probe& probe : static_probes()) probes.push_back(std::move(probe));
}

void MassSpringLesson::declare_checks() {
    conserved = {
        // A body that nothing outside acts on.
        {.probe = "momentum",
         .tolerance = [this] { return momentum_tolerance(); },
         .expected = [this] { return setting == Setting::spin && !pulled(); },
         .cancels = [this] { return momentum_terms(); }},
        // Semi-implicit Euler keeps it exactly, for forces along the springs; the other two gain or lose Δt² Σ v × f per step.
        {.probe = "angular_momentum",
         .tolerance = [this] { return momentum_tolerance() * block_->lengths().norm(); },
         .expected =
             [this] { return setting == Setting::spin && !pulled() && semi_implicit() && damping_mode != SpringDamping::naive; },
         .cancels = [this] { return momentum_terms() * block_->lengths().norm(); }},
        {.probe = "energy",
         .law = Law::never_grows,
         .tolerance = [this] { return energy_tolerance(); },
         .expected = [this] { return !tested() && !pulled(); },
         .cancels = [this] { return energy_terms(); }},
        {.probe = "shadow_energy",
         .tolerance = [this] { return shadow_tolerance(); },
         .expected =
             [this] {
                 return !tested() && semi_implicit() && !damped() && !pulled() && touching_ == 0 && dt <= stable_time_step();
             },
         .cancels = [this] { return energy_terms(); }},
    };
}

Real MassSpringLesson::total_energy() const {
    return kinetic_energy<3>(block_->mass(), velocity_) + elastic_energy() +
           external_energy<3>({{0, -weight_acceleration(), 0}, load_.pull}, block_->mass(), position_);
}

// What semi-implicit Euler conserves: exactly for linear forces, else up to the order of Δt² [Hairer2006 §IX.3].
std::optional<Real> MassSpringLesson::shadow_energy() const {
    if (!semi_implicit()) return std::nullopt;
    Points<3> force = Points<3>::Zero(3, position_.cols());
    add_spring_forces<3>(block_->springs(), position_, force);
    add_external_forces<3>({{0, -weight_acceleration(), 0}, load_.pull}, block_->mass(), position_, force);
    return total_energy() + 0.5 * dt * flat(force).dot(flat(velocity_));
}

// All that motion can come to: kinetic and elastic, and that of a fall to the ground, or by the size of the net.
Real MassSpringLesson::motion_energy() const {
    const Real height = grounded() ? std::max(centre_of_mass<3>(block_->mass(), position_)[1], Real{0}) : Real{size};
    return kinetic_energy<3>(block_->mass(), velocity_) + elastic_energy() + total_mass * weight_acceleration() * height;
}

Real MassSpringLesson::energy_terms() const {
    return kinetic_energy<3>(block_->mass(), velocity_) + elastic_energy() +
           std::abs(external_energy<3>({{0, -weight_acceleration(), 0}, load_.pull}, block_->mass(), position_));
}

// By how much the energy of a sound run may exceed that of the start; beyond the limit of stability nothing is allowed.
Real MassSpringLesson::energy_tolerance() const {
    const Real solved = implicit() ? 1e-6 : 1e-9;
    const Real excess = dt <= stable_time_step() ? energy_excess(integrator, rates().omega * dt, false, damped()) : 0;
    return (solved + excess) * motion_energy() + rounding_energy();
}

// What it adds to the energy, Δt/2 v·f, is at most ω Δt/2 of it; the next order is smaller by ω Δt.
Real MassSpringLesson::shadow_tolerance() const {
    const Real w = rates().omega * dt;
    return motion_energy() * (w * w / 2 + 1e-9) + rounding_energy();
}

Real MassSpringLesson::stretch() const {
    Real largest = 0;
    const Springs& springs = block_->springs();
    for (Index s = 0; s < springs.size(); ++s) {
        const Real rest = springs.rest_length()[s];
        if (rest == 0) continue;
        const Real strain = (position_.col(springs.j(s)) - position_.col(springs.i(s))).norm() / rest - 1;
        largest = std::max(largest, std::abs(strain));
    }
    return largest < strain_rounding ? 0 : largest;
}

std::optional<Real> MassSpringLesson::sag() const {
    if (setting != Setting::hang) return std::nullopt;
    const std::vector<Index> face = support == Support::side ? block_->layer(0, true) : block_->layer(1, false);
    Real sum = 0;
    for (const Index n : face) sum += block_->rest()(1, n) + drop_height - position_(1, n);
    return sum / Real(face.size());
}

// Free fall, until the lowest point meets the ground.
std::optional<Real> MassSpringLesson::falling_height(Real t) const {
    // A block that draws out or together as it falls meets the ground at a time of its own.
    if (setting != Setting::drop || interfered_ || (ground && rest_length_scale != 1)) return std::nullopt;
    const Real fallen = 0.5 * gravity * t * t;
    if (ground && fallen > drop_height) return std::nullopt;
    return start_height_ - fallen;
}

StaticTests::Key MassSpringLesson::static_key() const {
    return {lattice(), {cells_x, cells_y, cells_z}, edge(), stiffnesses(), shared_edges, target_poisson, block_test()};
}

// By how much the plates move, m; of bending by which angle they turn, rad.
Real MassSpringLesson::test_amount() const {
    if (bends()) return 4 * test_strain;
    return test_strain * block_->lengths()[1];
}

void MassSpringLesson::static_stage() {
    follow_parameters();
    tests_.run(block_->lattice(), static_key());
    const Springs& springs = block_->springs();
    const Points<3>& rest = block_->rest();
    position_ = rest + test_amount() * tests_.response().displacement;
    for (Index s = 0; s < springs.size(); ++s) {
        const Vec<3> along = (rest.col(springs.j(s)) - rest.col(springs.i(s))) / springs.rest_length()[s];
        const Real elongation = along.dot(position_.col(springs.j(s)) - position_.col(springs.i(s))) - springs.rest_length()[s];
        strain_[s] = elongation / springs.rest_length()[s];
        if (std::abs(strain_[s]) < strain_rounding) strain_[s] = 0;
        tension_[s] = springs.stiffness()[s] * springs.rest_length()[s] * strain_[s];
    }
    test_done_ = true;
}

std::vector<Probe> MassSpringLesson::static_probes() {
    using Number = std::function<Real()>;
    const auto once_known = [this](std::function<bool()> uses, Number value) {
        return [this, uses, value] { return test_known() && uses() ? std::optional<Real>(value()) : std::nullopt; };
    };
    const auto as_material = [this] { return block_test() == BlockTest::stretch && block_->dimension() > 1; };
    const auto endless = [this, as_material](Real (*constant)(const MassSpringLesson&)) {
        return [this, as_material, constant](Real) {
            return tested() && as_material() ? std::optional<Real>(constant(*this)) : std::nullopt;
        };
    };
    const auto stiffness = [this] { return tests_.response().stiffness; };
    std::vector<Probe> declared{
        probe_of("youngs_modulus", "E", "Pa",
                 "of the net as a material, pulled along y; a sheet is taken to be as thick as its edges are long",
                 once_known(as_material,
                            [this] { return tests_.modulus_in_pascal(tests_.response().youngs_modulus, block_->lattice()); }))
            .exactly(endless([](const MassSpringLesson& l) {
                return l.tests_.modulus_in_pascal(l.endless_lattice().youngs_modulus(), l.block_->lattice());
            })),
        probe_of("poisson_ratio", "ν", "", "mean strain across over that along; exact: of the endless lattice",
                 once_known(as_material, [this] { return tests_.response().poisson_ratio; }))
            .exactly(endless([](const MassSpringLesson& l) { return l.endless_lattice().poisson_ratio(); })),
        probe_of("test_stiffness", "K", "N/m", "force on a plate per displacement",
                 once_known([this] { return !bends(); }, stiffness)),
        probe_of("bending_stiffness", "K", "N m/rad", "moment on a plate per angle",
                 once_known([this] { return bends(); }, stiffness)),
        probe_of("stiffness_ratio", "K/K*", "",
                 "stiffness of the net over that of the solid of modulus E of the endless lattice and Poisson's ratio ν*",
                 once_known([this] { return tests_.continuum().has_value(); },
                            [this] { return tests_.response().stiffness / tests_.continuum()->stiffness; })),
    };
    constexpr std::array<std::string_view, 3> names{"coupling_structural", "coupling_shear", "coupling_bending"},
        symbols{"cₛ", "c_d", "c_b"},
        help{"∂ ln K/∂ ln kₛ: part of the energy that the structural springs store",
             "∂ ln K/∂ ln k_d: part of the energy that the diagonals store",
             "∂ ln K/∂ ln k_b: part of the energy that the bending springs store"};
    for (const SpringFamily family : {structural, shear, bending})
        declared.push_back(
            probe_of(names[family], symbols[family], "", help[family],
                     once_known([] { return true; }, [this, family] { return tests_.response().coupling[family]; })));
    return declared;
}

}  // namespace pliant::mass_spring
