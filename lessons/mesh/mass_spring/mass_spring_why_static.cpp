// Why the static test gives what it gives.
#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant::mass_spring {
namespace {}  // namespace

Explanation MassSpringLesson::why_static(const Question& q) const {
    const Springs& springs = block_->springs();
    if (q.field == "position")
        return {.formula = "x = X + δ u",
                .inputs = {Input::constant("X", block_->rest()(q.component, q.index), "m", "at rest"),
                           Input::constant("δ", test_amount(), block_test() == BlockTest::bend ? "rad" : "m",
                                           "by how much the plates move"),
                           Input::constant("u", tests_.response().displacement(q.component, q.index),
                                           block_test() == BlockTest::bend ? "m/rad" : "",
                                           "of the node for δ = 1, from K u = 0 and the plates")}};
    if (q.field == "tension")
        return {.formula = "T = k l ε",
                .inputs = {stiffness_of_spring(q.index),
                           Input::constant("l", springs.rest_length()[q.index], "m", "rest length of the spring"),
                           Input::now("ε", "strain", q.index)}};
    const Index i = springs.i(q.index), j = springs.j(q.index);
    const Vec<3> n = (block_->rest().col(j) - block_->rest().col(i)) / springs.rest_length()[q.index];
    Explanation e{.formula = "ε = (n_x (x_j − x_i) + n_y (y_j − y_i) + n_z (z_j − z_i) − l) / l",
                  .inputs = {Input::constant("l", springs.rest_length()[q.index], "m", "rest length of the spring")}};
    for (int c = 0; c < 3; ++c) {
        const char* letter = axis_name(c);
        e.inputs.push_back(Input::constant(fmt::format("n_{}", letter), n[c], "", "direction of the spring at rest"));
        e.inputs.push_back(Input::now(fmt::format("{}_j", letter), "position", j, c));
        e.inputs.push_back(Input::now(fmt::format("{}_i", letter), "position", i, c));
    }
    return e;
}

// From the energy of all springs, K = 2 U/δ².
Explanation MassSpringLesson::why_test_stiffness() const {
    Explanation e{.formula = "K = (kₛ Σₛ w (l ε)² + k_d Σ_d w (l ε)² + k_b Σ_b w (l ε)²) / δ²",
                  .inputs = {Input::of(k_structural), Input::of(k_shear), Input::of(k_bending),
                             Input::constant("δ", test_amount(), block_test() == BlockTest::bend ? "rad" : "m",
                                             "by how much the plates move")},
                  .evaluate = {}};
    for (Index s = 0; s < block_->springs().size(); ++s) e.inputs.push_back(Input::now(fmt::format("ε_{}", s), "strain", s));
    const auto sum = [this](std::span<const Real> x, SpringFamily family) { return elongation_squares(x.subspan(4), family); };
    e.evaluate = [sum](std::span<const Real> x) {
        return (x[0] * sum(x, structural) + x[1] * sum(x, shear) + x[2] * sum(x, bending)) / (x[3] * x[3]);
    };
    e.substitute = [sum](std::span<const Real> x) {
        return fmt::format("({} · {} + {} · {} + {} · {}) / {}²", as_factor(x[0]), as_factor(sum(x, structural)), as_factor(x[1]),
                           as_factor(sum(x, shear)), as_factor(x[2]), as_factor(sum(x, bending)), as_factor(x[3], true));
    };
    return e;
}

// Of a family, weighted as the test weights them. strains: of all springs.
Real MassSpringLesson::elongation_squares(std::span<const Real> strains, SpringFamily family) const {
    const Springs& springs = block_->springs();
    Real sum = 0;
    for (Index s = block_->first(family); s < block_->last(family); ++s) {
        const Real weight = shared_edges ? block_->lattice().share({springs.i(s), springs.j(s)}, family) : Real{1};
        const Real elongation = springs.rest_length()[s] * strains[static_cast<std::size_t>(s)];
        sum += weight * elongation * elongation;
    }
    return sum;
}

Explanation MassSpringLesson::why_youngs_modulus() const {
    const Vec<3> lengths = block_->lengths();
    const Real depth = block_->dimension() == 3 ? lengths[2] : edge();
    return {
        .formula = "E = K L / (b d)",
        .inputs = {Input::now("K", "test_stiffness", 0), Input::constant("L", lengths[1], "m", "distance of the plates at rest"),
                   Input::constant("b", lengths[0], "m", "width of the net"), Input::constant("d", depth, "m", "its depth")}};
}

Explanation MassSpringLesson::why_poisson_ratio() const {
    const Real along = test_strain;
    return {.formula = "ν = − ε_x / ε",
            .inputs = {Input::constant("ε_x", -tests_.response().poisson_ratio * along, "",
                                       "strain across: slope of the plane that fits the displacements x − X of all nodes best"),
                       Input::of(test_strain)}};
}

Explanation MassSpringLesson::why_stiffness_ratio() const {
    return {.formula = "K/K* = K / K*",
            .inputs = {Input::now("K", block_test() == BlockTest::bend ? "bending_stiffness" : "test_stiffness", 0),
                       Input::constant("K*", tests_.continuum()->stiffness, block_test() == BlockTest::bend ? "N m/rad" : "N/m",
                                       "of the solid: linear finite elements on the same cells, between the same plates")}};
}

Explanation MassSpringLesson::why_coupling(SpringFamily family) const {
    const std::array<const Number*, 3> stiffness{&k_structural, &k_shear, &k_bending};
    constexpr std::array<const char*, 3> letter{"s", "d", "b"};
    Explanation e{.formula = fmt::format("c = k Σ_{} w (l ε)² / (K δ²)", letter[family]),
                  .inputs = {Input::of(*stiffness[family], "k"),
                             Input::now("K", block_test() == BlockTest::bend ? "bending_stiffness" : "test_stiffness", 0),
                             Input::constant("δ", test_amount(), block_test() == BlockTest::bend ? "rad" : "m",
                                             "by how much the plates move")},
                  .evaluate = {}};
    for (Index s = 0; s < block_->springs().size(); ++s) e.inputs.push_back(Input::now(fmt::format("ε_{}", s), "strain", s));
    const auto sum = [this, family](std::span<const Real> x) { return elongation_squares(x.subspan(3), family); };
    e.evaluate = [sum](std::span<const Real> x) { return x[0] * sum(x) / (x[1] * x[2] * x[2]); };
    e.substitute = [sum](std::span<const Real> x) {
        return fmt::format("{} · {} / ({} · {}²)", as_factor(x[0]), as_factor(sum(x)), as_factor(x[1]), as_factor(x[2], true));
    };
    return e;
}

}  // namespace pliant::mass_spring
