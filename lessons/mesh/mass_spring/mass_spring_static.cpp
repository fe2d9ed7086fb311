// The static scene: the net between two plates, measured as a material, with a solid of the same modulus beside it.
#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::mass_spring {

StaticTests::Key MassSpringLesson::static_key() const {
    return {lattice(), {cells_x, cells_y, cells_z}, edge(), stiffnesses(), shared_edges, target_poisson, block_test()};
}

// By how much the plates move, m; of bending by which angle they turn, rad.
Real MassSpringLesson::test_amount() const {
    if (block_test() == BlockTest::bend) return 4 * test_strain;
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
    const auto measured = [this](auto value) {
        return [this, value]() -> std::optional<Real> {
            if (!tested() || !test_done_ || !tests_.knows(static_key())) return std::nullopt;
            return value();
        };
    };
    const auto in_stretch = [this](auto value) {
        return [this, value]() -> std::optional<Real> {
            if (!tested() || !test_done_ || !tests_.knows(static_key()) || block_test() != BlockTest::stretch ||
                block_->dimension() == 1)
                return std::nullopt;
            return value();
        };
    };
    const auto constants = [this] { return lattice_constants(lattice(), stiffnesses(), edge()); };
    const auto in_material = [this] { return tested() && block_test() == BlockTest::stretch && block_->dimension() > 1; };
    std::vector<Probe> declared{
        {.name = "youngs_modulus",
         .symbol = "E",
         .unit = "Pa",
         .help = "of the net as a material, pulled along y; a sheet is taken to be as thick as its edges are long",
         .value = in_stretch([this] { return tests_.modulus_in_pascal(tests_.response().youngs_modulus, block_->lattice()); }),
         .exact = [this, constants, in_material](Real) -> std::optional<Real> {
             if (!in_material()) return std::nullopt;
             return tests_.modulus_in_pascal(constants().youngs_modulus(), block_->lattice());
         }},
        {.name = "poisson_ratio",
         .symbol = "ν",
         .help = "mean strain across over that along; exact: of the endless lattice",
         .value = in_stretch([this] { return tests_.response().poisson_ratio; }),
         .exact = [constants, in_material](Real) -> std::optional<Real> {
             if (!in_material()) return std::nullopt;
             return constants().poisson_ratio();
         }},
        {.name = "test_stiffness",
         .symbol = "K",
         .unit = "N/m",
         .help = "force on a plate per displacement",
         .value = [this]() -> std::optional<Real> {
             if (!tested() || !test_done_ || !tests_.knows(static_key()) || block_test() == BlockTest::bend) return std::nullopt;
             return tests_.response().stiffness;
         }},
        {.name = "bending_stiffness",
         .symbol = "K",
         .unit = "N m/rad",
         .help = "moment on a plate per angle",
         .value = [this]() -> std::optional<Real> {
             if (!tested() || !test_done_ || !tests_.knows(static_key()) || block_test() != BlockTest::bend) return std::nullopt;
             return tests_.response().stiffness;
         }},
        {.name = "stiffness_ratio",
         .symbol = "K/K*",
         .help = "stiffness of the net over that of the solid of modulus E of the endless lattice and Poisson's ratio ν*",
         .value = [this]() -> std::optional<Real> {
             if (!tested() || !test_done_ || !tests_.knows(static_key()) || !tests_.continuum()) return std::nullopt;
             return tests_.response().stiffness / tests_.continuum()->stiffness;
         }},
    };
    constexpr std::array<std::string_view, 3> names{"coupling_structural", "coupling_shear", "coupling_bending"},
        symbols{"cₛ", "c_d", "c_b"},
        help{"∂ ln K/∂ ln kₛ: part of the energy that the structural springs store",
             "∂ ln K/∂ ln k_d: part of the energy that the diagonals store",
             "∂ ln K/∂ ln k_b: part of the energy that the bending springs store"};
    for (const SpringFamily family : {structural, shear, bending})
        declared.push_back({.name = names[family],
                            .symbol = symbols[family],
                            .help = help[family],
                            .value = measured([this, family] { return tests_.response().coupling[family]; })});
    return declared;
}

}  // namespace pliant::mass_spring
