// Why the probes are what they are: sums over all nodes, computed again from their positions and velocities.
#include "mass_spring.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

// Every number of a nodal vector, node by node.
void append_all(std::vector<Input>& inputs, std::string_view symbol, std::string_view field, Index nodes) {
    for (Index n = 0; n < nodes; ++n)
        for (int c = 0; c < 3; ++c) inputs.push_back(Input::now(fmt::format("{}{}_{}", symbol, axis_name(c), n), field, n, c));
}

Eigen::Map<const Points<3>> points(std::span<const Real> x) { return {x.data(), 3, static_cast<Index>(x.size() / 3)}; }

// The length of a vector of which every component is a part.
Explanation length_of(std::string_view symbol, std::string_view unit, const std::function<Explanation(int)>& component) {
    Explanation e{.formula = fmt::format("{0} = √({0}_x² + {0}_y² + {0}_z²)", symbol),
                  .inputs = {},
                  .evaluate = [](std::span<const Real> x) { return Vec<3>(x[0], x[1], x[2]).norm(); }};
    for (int c = 0; c < 3; ++c)
        e.inputs.push_back(Input::part(fmt::format("{}_{}", symbol, axis_name(c)), std::string(unit), component(c)));
    return e;
}

}  // namespace

void MassSpringLesson::explain_probes() {
    const auto give = [this](std::string_view name, auto why) {
        const auto probe = std::ranges::find(probes, name, &Probe::name);
        probe->explain = [this, why] { return (this->*why)(); };
    };
    give("energy", &MassSpringLesson::why_energy);
    give("kinetic_energy", &MassSpringLesson::why_kinetic_energy);
    give("elastic_energy", &MassSpringLesson::why_elastic_energy);
    give("gravitational_energy", &MassSpringLesson::why_gravitational_energy);
    give("momentum", &MassSpringLesson::why_momentum);
    give("angular_momentum", &MassSpringLesson::why_angular_momentum);
    give("height", &MassSpringLesson::why_height);
    give("stretch", &MassSpringLesson::why_stretch);
    give("sag", &MassSpringLesson::why_sag);
    give("frequency", &MassSpringLesson::why_frequency);
    give("youngs_modulus", &MassSpringLesson::why_youngs_modulus);
    give("poisson_ratio", &MassSpringLesson::why_poisson_ratio);
    give("test_stiffness", &MassSpringLesson::why_test_stiffness);
    give("bending_stiffness", &MassSpringLesson::why_test_stiffness);
    give("stiffness_ratio", &MassSpringLesson::why_stiffness_ratio);
    for (const auto& [name, family] :
         {std::pair{"coupling_structural", structural}, {"coupling_shear", shear}, {"coupling_bending", bending}})
        std::ranges::find(probes, std::string_view(name), &Probe::name)->explain = [this, of = family] {
            return why_coupling(of);
        };
}

Explanation MassSpringLesson::why_energy() const {
    Explanation e = sum_of("E = K + U + V", {Input::now("K", "kinetic_energy", 0), Input::now("U", "elastic_energy", 0),
                                             Input::now("V", "gravitational_energy", 0)});
    if (!load_.pull.active()) return e;
    Explanation hand{.formula = "H = ½ kₕ ((x_hand − x)² + (y_hand − y)² + (z_hand − z)²)",
                     .inputs = {Input::of(pull_stiffness)}};
    for (int c = 0; c < 3; ++c) {
        const char* letter = axis_name(c);
        hand.inputs.push_back(
            Input::constant(fmt::format("{}_hand", letter), load_.pull.target[c], "m", "where the hand pulls to"));
        hand.inputs.push_back(Input::now(letter, "position", load_.pull.node, c));
    }
    e.formula += " + H";
    e.inputs.push_back(Input::part("H", "J", std::move(hand)));
    return e;
}

Explanation MassSpringLesson::why_kinetic_energy() const {
    Explanation e{.formula = "K = ½ m Σ (v_x² + v_y² + v_z²)", .inputs = {node_mass()}, .evaluate = {}};
    append_all(e.inputs, "v", "velocity", position_.cols());
    const auto squares = [](std::span<const Real> x) { return points(x.subspan(1)).squaredNorm(); };
    e.evaluate = [squares](std::span<const Real> x) { return 0.5 * x[0] * squares(x); };
    e.substitute = [squares](std::span<const Real> x) {
        return fmt::format("½ · {} · {}", as_factor(x[0]), as_factor(squares(x)));
    };
    return e;
}

Explanation MassSpringLesson::why_elastic_energy() const {
    const std::array<std::string_view, 3> symbols{"½ kₛ Σₛ", "½ k_d Σ_d", "½ k_b Σ_b"};
    Explanation e{
        .formula = "U = ", .inputs = {Input::of(k_structural), Input::of(k_shear), Input::of(k_bending)}, .evaluate = {}};
    for (const std::string_view symbol : symbols)
        e.formula += fmt::format("{}{} (|x_ij| − l)²", e.inputs.empty() || symbol == symbols[0] ? "" : " + ", symbol);
    append_all(e.inputs, "", "position", position_.cols());
    // Of each family, the sum of its springs' squared elongations.
    const auto squares = [this](std::span<const Real> x, SpringFamily family) {
        const Springs& springs = block_->springs();
        const auto at = points(x.subspan(3));
        Real sum = 0;
        for (Index s = block_->first(family); s < block_->last(family); ++s) {
            const Real elongation = (at.col(springs.j(s)) - at.col(springs.i(s))).norm() - springs.rest_length()[s];
            sum += elongation * elongation;
        }
        return sum;
    };
    e.evaluate = [squares](std::span<const Real> x) {
        return 0.5 * (x[0] * squares(x, structural) + x[1] * squares(x, shear) + x[2] * squares(x, bending));
    };
    e.substitute = [squares](std::span<const Real> x) {
        return fmt::format("½ · {} · {} + ½ · {} · {} + ½ · {} · {}", as_factor(x[0]), as_factor(squares(x, structural)),
                           as_factor(x[1]), as_factor(squares(x, shear)), as_factor(x[2]), as_factor(squares(x, bending)));
    };
    return e;
}

Explanation MassSpringLesson::why_gravitational_energy() const {
    if (weight_acceleration() == 0) return {.formula = "V = 0: there is no weight", .inputs = {}};
    return {.formula = "V = M g h", .inputs = {Input::of(total_mass), Input::of(gravity), Input::now("h", "height", 0)}};
}

Explanation MassSpringLesson::why_momentum() const {
    return length_of("p", "kg m/s", [this](int c) {
        const char* letter = axis_name(c);
        Explanation e{.formula = fmt::format("p_{0} = m Σ v_{0}", letter), .inputs = {node_mass()}, .evaluate = {}};
        for (Index n = 0; n < velocity_.cols(); ++n)
            e.inputs.push_back(Input::now(fmt::format("v{}_{}", letter, n), "velocity", n, c));
        e.evaluate = [](std::span<const Real> x) {
            Real sum = 0;
            for (const Real v : x.subspan(1)) sum += v;
            return x[0] * sum;
        };
        e.substitute = [](std::span<const Real> x) { return fmt::format("{} · ({})", as_factor(x[0]), sum_text(x.subspan(1))); };
        return e;
    });
}

Explanation MassSpringLesson::why_angular_momentum() const {
    return length_of("J", "kg m²/s", [this](int c) {
        const Index nodes = position_.cols();
        Explanation e{.formula = fmt::format("J_{} = m Σ ((x − x_c) × (v − v_c))_{}", axis_name(c), axis_name(c)),
                      .inputs = {node_mass()},
                      .evaluate = {}};
        append_all(e.inputs, "", "position", nodes);
        append_all(e.inputs, "v", "velocity", nodes);
        const auto turning = [c, nodes](std::span<const Real> x) {
            const auto count = static_cast<std::size_t>(3 * nodes);
            return angular_momentum<3>(VecX::Ones(nodes), points(x.subspan(1, count)), points(x.subspan(1 + count)))[c];
        };
        e.evaluate = [turning](std::span<const Real> x) { return x[0] * turning(x); };
        e.substitute = [turning](std::span<const Real> x) {
            return fmt::format("{} · {}", as_factor(x[0]), as_factor(turning(x)));
        };
        return e;
    });
}

Explanation MassSpringLesson::why_height() const {
    std::vector<Input> heights;
    for (Index n = 0; n < position_.cols(); ++n) heights.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    Explanation e = sum_of("h = Σ y / N", std::move(heights));
    e.evaluate = [making = e.making](std::span<const Real> x) { return sum_of_terms(making, x) / Real(x.size()); };
    e.substitute = [](std::span<const Real> x) { return fmt::format("({}) / {}", sum_text(x), x.size()); };
    return e;
}

// Of the spring where the strain is largest now.
Explanation MassSpringLesson::why_stretch() const {
    const Springs& springs = block_->springs();
    if (springs.size() == 0) return {.formula = "ε = 0: no springs", .inputs = {}};
    VecX strain(springs.size());
    spring_strain<3>(springs, position_, strain);
    Index most = 0;
    strain.cwiseAbs().maxCoeff(&most);
    if (springs.rest_length()[most] == 0) return fixed_value("ε = 0: springs of rest length 0 have no strain", 0);
    const Index i = springs.i(most), j = springs.j(most);
    Explanation e{.formula = fmt::format("ε = |(|x_{0} − x_{1}| − l) / l|, the largest: of spring {2} between nodes {1} and {0}",
                                         j, i, most),
                  .inputs = {Input::constant("l", springs.rest_length()[most], "m", "rest length of the spring")},
                  .evaluate = {}};
    for (const Index node : {j, i})
        for (int c = 0; c < 3; ++c) e.inputs.push_back(Input::now(fmt::format("{}_{}", axis_name(c), node), "position", node, c));
    const auto length = [](std::span<const Real> x) { return Vec<3>(x[1] - x[4], x[2] - x[5], x[3] - x[6]).norm(); };
    e.evaluate = [length](std::span<const Real> x) {
        const Real strain_now = std::abs(length(x) / x[0] - 1);
        return strain_now < strain_rounding ? 0 : strain_now;
    };
    e.substitute = [length](std::span<const Real> x) {
        return fmt::format("|({0} − {1}) / {1}|", format_quantity(length(x), "", 8), format_quantity(x[0], "", 8));
    };
    return e;
}

Explanation MassSpringLesson::why_sag() const {
    Explanation e{.formula = "s = Σ (Y − y) / n", .inputs = {}, .evaluate = {}};
    const bool hangs = support != Support::side;
    for (const Index n : hangs ? block_->layer(1, false) : block_->layer(0, true)) {
        e.inputs.push_back(
            Input::constant(fmt::format("Y_{}", n), block_->rest()(1, n) + drop_height, "m", "height of the node at rest"));
        e.inputs.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    }
    const auto fallen = [](std::span<const Real> x) {
        std::vector<Real> each;
        for (std::size_t k = 0; k + 1 < x.size(); k += 2) each.push_back(x[k] - x[k + 1]);
        return each;
    };
    e.evaluate = [fallen](std::span<const Real> x) {
        Real sum = 0;
        for (const Real d : fallen(x)) sum += d;
        return 2 * sum / Real(x.size());
    };
    e.substitute = [fallen](std::span<const Real> x) { return fmt::format("({}) / {}", sum_text(fallen(x)), x.size() / 2); };
    return e;
}

}  // namespace pliant::mass_spring
