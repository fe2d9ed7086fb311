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

using Values = std::span<const Real>;

// ------------------------------------------------------------------------------------------------------------- motion

Explanation why_elastic_energy(const MassSpringLesson& l) {
    Explanation e{"U = ½ kₛ Σₛ (|x_ij| − l)² + ½ k_d Σ_d (|x_ij| − l)² + ½ k_b Σ_b (|x_ij| − l)²",
                  {l.k_structural, l.k_shear, l.k_bending}};
    springs::append_all(e.inputs, "", "position", l.position_.cols());
    // Of each family, the sum of its springs' squared elongations.
    const auto squares = [&l](Values x, SpringFamily family) {
        return springs::elongation_squares(l.block_->springs(), l.block_->first(family), l.block_->last(family),
                                           springs::points(x.subspan(3)));
    };
    e.evaluate = [squares](Values x) {
        return 0.5 * (x[0] * squares(x, structural) + x[1] * squares(x, shear) + x[2] * squares(x, bending));
    };
    e.substitute = [squares](Values x) {
        return fmt::format("½ · {} · {} + ½ · {} · {} + ½ · {} · {}", as_factor(x[0]), as_factor(squares(x, structural)),
                           as_factor(x[1]), as_factor(squares(x, shear)), as_factor(x[2]), as_factor(squares(x, bending)));
    };
    return e;
}

// The length of a vector of which every component is a part.
Explanation length_of(std::string_view symbol, std::string_view unit, const std::function<Explanation(int)>& component) {
    Explanation e{fmt::format("{0} = √({0}_x² + {0}_y² + {0}_z²)", symbol)};
    for (int c = 0; c < 3; ++c)
        e.inputs.push_back(Input::part(fmt::format("{}_{}", symbol, axis_name(c)), std::string(unit), component(c)));
    return e;
}

Explanation why_momentum(const MassSpringLesson& l, int c) {
    std::vector<Input> velocities;
    for (Index n = 0; n < l.velocity_.cols(); ++n)
        velocities.push_back(Input::now(fmt::format("v{}_{}", axis_name(c), n), "velocity", n, c));
    return springs::times_sum(fmt::format("p_{0} = m Σ v_{0}", axis_name(c)), {l.node_mass()}, std::move(velocities));
}

Explanation why_angular_momentum(const MassSpringLesson& l, int c) {
    const Index nodes = l.position_.cols();
    std::vector<Input> motion;
    springs::append_all(motion, "", "position", nodes);
    springs::append_all(motion, "v", "velocity", nodes);
    return springs::times_total(fmt::format("J_{0} = m Σ ((x − x_c) × (v − v_c))_{0}", axis_name(c)), false, {l.node_mass()},
                                std::move(motion), [c, nodes](Values, Values x) {
                                    const auto count = static_cast<std::size_t>(3 * nodes);
                                    return angular_momentum<3>(VecX::Ones(nodes), springs::points(x.first(count)),
                                                               springs::points(x.subspan(count)))[c];
                                });
}

Explanation why_height(const MassSpringLesson& l) {
    std::vector<Input> heights;
    for (Index n = 0; n < l.position_.cols(); ++n) heights.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    Explanation e = sum_of("h = Σ y / N", std::move(heights));
    e.evaluate = [making = e.making](Values x) { return sum_of_terms(making, x) / Real(x.size()); };
    e.substitute = [](Values x) { return fmt::format("({}) / {}", sum_text(x), x.size()); };
    return e;
}

// Of the spring where the strain is largest now.
Explanation why_stretch(const MassSpringLesson& l) {
    const Springs& springs = l.block_->springs();
    if (springs.size() == 0) return {"ε = 0: no springs"};
    VecX strain(springs.size());
    spring_strain<3>(springs, l.position_, strain);
    Index most = 0;
    strain.cwiseAbs().maxCoeff(&most);
    if (springs.rest_length()[most] == 0) return fixed_value("ε = 0: springs of rest length 0 have no strain", 0);
    const Index i = springs.i(most), j = springs.j(most);
    Explanation e{
        fmt::format("ε = |(|x_{0} − x_{1}| − l) / l|, the largest: of spring {2} between nodes {1} and {0}", j, i, most),
        {springs::rest_length(springs, most)}};
    for (const Index node : {j, i})
        for (int c = 0; c < 3; ++c) e.inputs.push_back(Input::now(fmt::format("{}_{}", axis_name(c), node), "position", node, c));
    const auto length = [](Values x) { return Vec<3>(x[1] - x[4], x[2] - x[5], x[3] - x[6]).norm(); };
    e.evaluate = [length](Values x) {
        const Real strain_now = std::abs(length(x) / x[0] - 1);
        return strain_now < strain_rounding ? 0 : strain_now;
    };
    e.substitute = [length](Values x) {
        return fmt::format("|({0} − {1}) / {1}|", format_quantity(length(x), "", 8), format_quantity(x[0], "", 8));
    };
    return e;
}

Explanation why_sag(const MassSpringLesson& l) {
    Explanation e{"s = Σ (Y − y) / n"};
    for (const Index n : l.support != Support::side ? l.block_->layer(1, false) : l.block_->layer(0, true)) {
        e.inputs.push_back(
            Input::constant(fmt::format("Y_{}", n), l.block_->rest()(1, n) + l.drop_height, "m", "height of the node at rest"));
        e.inputs.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    }
    const auto fallen = [](Values x) {
        std::vector<Real> each;
        for (std::size_t k = 0; k + 1 < x.size(); k += 2) each.push_back(x[k] - x[k + 1]);
        return each;
    };
    e.evaluate = [fallen](Values x) { return 2 * sum_of_terms(Making::sum, fallen(x)) / Real(x.size()); };
    e.substitute = [fallen](Values x) { return fmt::format("({}) / {}", sum_text(fallen(x)), x.size() / 2); };
    return e;
}

// -------------------------------------------------------------------------------------------------------- static test

Input why_plates(const MassSpringLesson& l) {
    return Input::constant("δ", l.test_amount(), l.bends() ? "rad" : "m", "by how much the plates move");
}

Input why_stiffness(const MassSpringLesson& l) { return Input::now("K", l.bends() ? "bending_stiffness" : "test_stiffness", 0); }

// Of a family, weighted as the test weights them. strains: of all springs.
Real weighted_squares(const MassSpringLesson& l, Values strains, SpringFamily family) {
    const Springs& springs = l.block_->springs();
    Real sum = 0;
    for (Index s = l.block_->first(family); s < l.block_->last(family); ++s) {
        const Real weight = l.shared_edges ? l.block_->lattice().share({springs.i(s), springs.j(s)}, family) : Real{1};
        const Real elongation = springs.rest_length()[s] * strains[static_cast<std::size_t>(s)];
        sum += weight * elongation * elongation;
    }
    return sum;
}

void append_strains(const MassSpringLesson& l, std::vector<Input>& inputs) {
    for (Index s = 0; s < l.block_->springs().size(); ++s) inputs.push_back(Input::now(fmt::format("ε_{}", s), "strain", s));
}

// From the energy of all springs, K = 2 U/δ².
Explanation why_test_stiffness(const MassSpringLesson& l) {
    Explanation e{"K = (kₛ Σₛ w (l ε)² + k_d Σ_d w (l ε)² + k_b Σ_b w (l ε)²) / δ²",
                  {l.k_structural, l.k_shear, l.k_bending, why_plates(l)}};
    append_strains(l, e.inputs);
    const auto sum = [&l](Values x, SpringFamily family) { return weighted_squares(l, x.subspan(4), family); };
    e.evaluate = [sum](Values x) {
        return (x[0] * sum(x, structural) + x[1] * sum(x, shear) + x[2] * sum(x, bending)) / (x[3] * x[3]);
    };
    e.substitute = [sum](Values x) {
        return fmt::format("({} · {} + {} · {} + {} · {}) / {}²", as_factor(x[0]), as_factor(sum(x, structural)), as_factor(x[1]),
                           as_factor(sum(x, shear)), as_factor(x[2]), as_factor(sum(x, bending)), as_factor(x[3], true));
    };
    return e;
}

Explanation why_coupling(const MassSpringLesson& l, SpringFamily family) {
    const std::array<const Number*, 3> stiffness{&l.k_structural, &l.k_shear, &l.k_bending};
    constexpr std::array<const char*, 3> letter{"s", "d", "b"};
    Explanation e{fmt::format("c = k Σ_{} w (l ε)² / (K δ²)", letter[family]),
                  {Input::of(*stiffness[family], "k"), why_stiffness(l), why_plates(l)}};
    append_strains(l, e.inputs);
    const auto sum = [&l, family](Values x) { return weighted_squares(l, x.subspan(3), family); };
    e.evaluate = [sum](Values x) { return x[0] * sum(x) / (x[1] * x[2] * x[2]); };
    e.substitute = [sum](Values x) {
        return fmt::format("{} · {} / ({} · {}²)", as_factor(x[0]), as_factor(sum(x)), as_factor(x[1]), as_factor(x[2], true));
    };
    return e;
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
    give("stretch", why_stretch);
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
