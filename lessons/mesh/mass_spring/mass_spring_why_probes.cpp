// Why the probes are what they are, sums over all nodes computed again from their positions and velocities; and the static test.
#include "mass_spring.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::mass_spring {
namespace {

// ------------------------------------------------------------------------------------------------------------- motion

Explanation why_elastic_energy(const MassSpringLesson& l) {
    Explanation e{"U = ½ kₛ Lₛ(x_n) + ½ k_d L_d(x_n) + ½ k_b L_b(x_n), L = Σ (|x_ij| − l)² over the springs of a family",
                  {l.k_structural, l.k_shear, l.k_bending}};
    springs::append_points(e.inputs, "x_n", "", "position", l.position_.cols());
    const auto squares = [&l](SpringFamily family) {
        return [&l, family](Values x) {
            return springs::elongation_squares(l.block_->springs(), l.block_->first(family), l.block_->last(family),
                                               springs::points(x));
        };
    };
    return std::move(e).by("Lₛ", "m²", squares(structural)).by("L_d", "m²", squares(shear)).by("L_b", "m²", squares(bending));
}

// The length of a vector of which every component is a part.
Explanation length_of(std::string_view symbol, std::string_view unit, const std::function<Explanation(int)>& component) {
    Explanation e{fmt::format("{0} = √({0}_x² + {0}_y² + {0}_z²)", symbol)};
    for (int c = 0; c < 3; ++c)
        e.inputs.push_back(Input::part(fmt::format("{}_{}", symbol, axis_name(c)), std::string(unit), component(c)));
    return e;
}

Explanation why_momentum(const MassSpringLesson& l, int c) {
    Explanation e{fmt::format("p_{0} = m Σ_n v_n", axis_name(c)), {l.node_mass()}};
    for (Index n = 0; n < l.velocity_.cols(); ++n)
        e.inputs.push_back(Input::now(fmt::format("v{}_{}", axis_name(c), n), "velocity", n, c).in("v_n"));
    return e;
}

// About the middle of mass, across the plane of two axes.
Explanation why_angular_momentum(const MassSpringLesson& l, int c) {
    Explanation e{fmt::format("J_{2} = m Σ_n (({0} − mean {0}) (v_{1} − mean v_{1}) − ({1} − mean {1}) (v_{0} − mean v_{0}))",
                              axis_name((c + 1) % 3), axis_name((c + 2) % 3), axis_name(c)),
                  {l.node_mass()}};
    springs::append_all(e.inputs, "", "position", l.position_.cols());
    springs::append_all(e.inputs, "v", "velocity", l.position_.cols());
    std::erase_if(e.inputs, [&](const Input& in) { return in.family.ends_with(axis_name(c)); });
    return e;
}

Explanation why_height(const MassSpringLesson& l) {
    std::vector<Input> heights;
    for (Index n = 0; n < l.position_.cols(); ++n) heights.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    return {"h = mean_n y_n", family_of("y_n", std::move(heights))};
}

// Of the spring where the strain is largest now.
Explanation why_stretch(const MassSpringLesson& l) {
    const Springs& springs = l.block_->springs();
    if (springs.size() == 0) return {"ε = 0: no springs"};
    VecX strain(springs.size());
    spring_strain<3>(springs, l.position_, strain);
    Index most = 0;
    strain.cwiseAbs().maxCoeff(&most);
    if (springs.rest_length()[most] == 0) return fixed_value("ε = 0: springs of rest length 0 have no strain");
    const Index i = springs.i(most), j = springs.j(most);
    return {fmt::format("ε = |(|x_ij| − l) / l|, the largest: of spring {} between nodes i = {} and j = {}", most, i, j),
            {springs::rest_length(springs, most), springs::length_between(Input::now, j, i)}};
}

Explanation why_sag(const MassSpringLesson& l) {
    Explanation e{"s = mean_n (Y_n − y_n)"};
    for (const Index n : l.support != Support::side ? l.block_->layer(1, false) : l.block_->layer(0, true)) {
        e.inputs.push_back(
            Input::constant(fmt::format("Y_{}", n), l.block_->rest()(1, n) + l.drop_height, "m", "height of the node at rest")
                .in("Y_n"));
        e.inputs.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1).in("y_n"));
    }
    return e;
}

// -------------------------------------------------------------------------------------------------------- static test

Input why_plates(const MassSpringLesson& l) {
    return Input::constant("δ", l.test_amount(), l.bends() ? "rad" : "m", "by how much the plates move");
}

Input why_stiffness(const MassSpringLesson& l) { return Input::now("K", l.bends() ? "bending_stiffness" : "test_stiffness", 0); }

// "Σₛ wₛ (lₛ εₛ)²" of a family, weighted as the test weights them, whose numbers join the inputs; "" of one without springs.
std::string weighted_squares(const MassSpringLesson& l, SpringFamily family, std::vector<Input>& inputs) {
    constexpr std::array<const char*, 3> marks{"ₛ", "_d", "_b"};
    const std::string mark = marks[family];
    const Springs& springs = l.block_->springs();
    for (Index s = l.block_->first(family); s < l.block_->last(family); ++s) {
        if (l.shared_edges)
            inputs.push_back(Input::constant(fmt::format("w_{}", s),
                                             l.block_->lattice().share({springs.i(s), springs.j(s)}, family), "",
                                             "part of the spring that belongs to the test")
                                 .in("w" + mark));
        inputs.push_back(
            Input::constant(fmt::format("l_{}", s), springs.rest_length()[s], "m", "rest length of the spring").in("l" + mark));
        inputs.push_back(Input::now(fmt::format("ε_{}", s), "strain", s).in("ε" + mark));
    }
    if (l.block_->first(family) == l.block_->last(family)) return "";
    return fmt::format("Σ{0} {1}(l{0} ε{0})²", mark, l.shared_edges ? fmt::format("w{} ", mark) : "");
}

// From the energy of all springs, K = 2 U/δ².
Explanation why_test_stiffness(const MassSpringLesson& l) {
    const std::array<const Number*, 3> stiffness{&l.k_structural, &l.k_shear, &l.k_bending};
    Explanation e{"K = 0: no springs", {}};
    std::string sum;
    for (const SpringFamily family : {structural, shear, bending}) {
        const std::string squares = weighted_squares(l, family, e.inputs);
        if (squares.empty()) continue;
        sum += fmt::format("{}{} {}", sum.empty() ? "" : " + ", stiffness[family]->info.symbol, squares);
        e.inputs.push_back(*stiffness[family]);
    }
    if (sum.empty()) return e;
    e.inputs.push_back(why_plates(l));
    e.formula = fmt::format("K = ({}) / δ²", sum);
    return e;
}

Explanation why_coupling(const MassSpringLesson& l, SpringFamily family) {
    const std::array<const Number*, 3> stiffness{&l.k_structural, &l.k_shear, &l.k_bending};
    std::vector<Input> inputs{Input::of(*stiffness[family], "k"), why_stiffness(l), why_plates(l)};
    const std::string squares = weighted_squares(l, family, inputs);
    if (squares.empty()) return fixed_value("c = 0: no such springs");
    return {fmt::format("c = k {} / (K δ²)", squares), std::move(inputs)};
}

Explanation why_youngs_modulus(const MassSpringLesson& l) {
    const Vec<3> lengths = l.block_->lengths();
    return {"E = K L / (b d)",
            {Input::now("K", "test_stiffness", 0), Input::constant("L", lengths[1], "m", "distance of the plates at rest"),
             Input::constant("b", lengths[0], "m", "width of the net"),
             Input::constant("d", l.block_->dimension() == 3 ? lengths[2] : l.edge(), "m", "its depth")}};
}

}  // namespace

Explanation MassSpringLesson::why_static(const Question& q) const {
    const Springs& springs = block_->springs();
    if (q.field == "position")
        return {"x = X + δ u",
                {Input::constant("X", block_->rest()(q.component, q.index), "m", "at rest"), why_plates(*this),
                 Input::constant("u", tests_.response().displacement(q.component, q.index), bends() ? "m/rad" : "",
                                 "of the node for δ = 1, from K u = 0 and the plates")}};
    const Input l = springs::rest_length(springs, q.index);
    if (q.field == "tension") return {"T = k l ε", {stiffness_of_spring(q.index), l, Input::now("ε", "strain", q.index)}};
    const Index i = springs.i(q.index), j = springs.j(q.index);
    const Vec<3> n = (block_->rest().col(j) - block_->rest().col(i)) / springs.rest_length()[q.index];
    Explanation e{"ε = (n_x (x_j − x_i) + n_y (y_j − y_i) + n_z (z_j − z_i) − l) / l", {l}};
    for (int c = 0; c < 3; ++c)
        e.inputs.push_back(Input::constant(fmt::format("n_{}", axis_name(c)), n[c], "", "direction of the spring at rest"));
    springs::append_ends(e.inputs, Input::now, "position", "", j, i);
    return e;
}

void MassSpringLesson::explain_probes() {
    const auto give = [this](std::string_view name, std::function<Explanation(const MassSpringLesson&)> why) {
        explain_probe(name, [this, why] { return why(*this); });
    };
    using L = const MassSpringLesson&;
    give("energy", [](L l) { return springs::energy_in_all(l.load_, l.pull_stiffness); });
    give("kinetic_energy", [](L l) { return springs::kinetic_energy_of(l.node_mass(), l.position_.cols()); });
    give("elastic_energy", why_elastic_energy);
    give("gravitational_energy", [](L l) -> Explanation {
        if (l.weight_acceleration() == 0) return {"V = 0: there is no weight"};
        return {"V = M g h", {l.total_mass, l.gravity, Input::now("h", "height", 0)}};
    });
    give("momentum", [](L l) { return length_of("p", "kg m/s", [&l](int c) { return why_momentum(l, c); }); });
    give("angular_momentum", [](L l) { return length_of("J", "kg m²/s", [&l](int c) { return why_angular_momentum(l, c); }); });
    give("height", why_height);
    give("largest_strain", why_stretch);
    give("sag", why_sag);
    give("frequency", [](L l) -> Explanation {
        return {"ω = 2 π / T",
                {Input::constant("T", l.rhythm_.period().value_or(0), "s",
                                 "mean time from one passage upwards to the next, of the latest four at most")}};
    });
    give("youngs_modulus", why_youngs_modulus);
    give("poisson_ratio", [](L l) -> Explanation {
        return {"ν = − ε_x / ε",
                {Input::constant("ε_x", -l.tests_.response().poisson_ratio * l.test_strain, "",
                                 "strain across: slope of the plane that fits the displacements x − X of all nodes best"),
                 l.test_strain}};
    });
    give("test_stiffness", why_test_stiffness);
    give("bending_stiffness", why_test_stiffness);
    give("stiffness_ratio", [](L l) -> Explanation {
        return {"K/K* = K / K*",
                {why_stiffness(l),
                 Input::constant("K*", l.tests_.continuum()->stiffness, l.bends() ? "N m/rad" : "N/m",
                                 "of the solid: linear finite elements on the same cells, between the same plates")}};
    });
    give("coupling_structural", [](L l) { return why_coupling(l, structural); });
    give("coupling_shear", [](L l) { return why_coupling(l, shear); });
    give("coupling_bending", [](L l) { return why_coupling(l, bending); });
}

}  // namespace pliant::mass_spring
