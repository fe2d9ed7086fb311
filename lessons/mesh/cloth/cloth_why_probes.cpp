// Why the probes are what they are: sums over all nodes, computed again from their positions and velocities.
#include "cloth.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace pliant::cloth {
namespace {

// Every number of a nodal vector, node by node.
void append_all(std::vector<Input>& inputs, std::string_view symbol, std::string_view field, Index nodes) {
    for (Index n = 0; n < nodes; ++n)
        for (int c = 0; c < 3; ++c) inputs.push_back(Input::now(fmt::format("{}{}_{}", symbol, axis_name(c), n), field, n, c));
}

Eigen::Map<const Points<3>> points(std::span<const Real> x) { return {x.data(), 3, static_cast<Index>(x.size() / 3)}; }

}  // namespace

void ClothLesson::explain_probes() {
    const auto give = [this](std::string_view name, std::function<Explanation()> why) {
        std::ranges::find(probes, name, &Probe::name)->explain = std::move(why);
    };
    give("energy", [this] { return why_energy(); });
    give("kinetic_energy", [this] { return why_kinetic_energy(); });
    give("stretch_energy", [this] { return why_family_energy(structural); });
    give("shear_energy", [this] { return why_family_energy(shear); });
    give("bending_energy", [this] { return why_family_energy(bending); });
    give("elastic_energy", [] {
        return sum_of("U = Uₛ + U_d + U_b", {Input::now("Uₛ", "stretch_energy", 0), Input::now("U_d", "shear_energy", 0),
                                             Input::now("U_b", "bending_energy", 0)});
    });
    give("bending_share", [] {
        return Explanation{.formula = "U_b/U = U_b / U",
                           .inputs = {Input::now("U_b", "bending_energy", 0), Input::now("U", "elastic_energy", 0)}};
    });
    give("gravitational_energy", [this] { return why_gravitational_energy(); });
    give("largest_stretch", [this] { return why_largest_stretch(); });
    give("lowest", [this] { return why_lowest(); });
    give("drape_coefficient", [this] { return why_drape(); });
}

Explanation ClothLesson::why_hand_energy() const {
    Explanation hand{.formula = "H = ½ kₕ ((x_hand − x)² + (y_hand − y)² + (z_hand − z)²)",
                     .inputs = {Input::of(pull_stiffness)}};
    for (int c = 0; c < 3; ++c) {
        const char* letter = axis_name(c);
        hand.inputs.push_back(
            Input::constant(fmt::format("{}_hand", letter), load_.pull.target[c], "m", "where the hand pulls to"));
        hand.inputs.push_back(Input::now(letter, "position", load_.pull.node, c));
    }
    return hand;
}

Explanation ClothLesson::why_energy() const {
    std::vector<Input> parts{Input::now("K", "kinetic_energy", 0), Input::now("U", "elastic_energy", 0),
                             Input::now("V", "gravitational_energy", 0)};
    if (pulled()) parts.push_back(Input::part("H", "J", why_hand_energy()));
    return sum_of(pulled() ? "E = K + U + V + H" : "E = K + U + V", std::move(parts));
}

Explanation ClothLesson::why_kinetic_energy() const {
    Explanation e{.formula = "K = ½ m Σ (v_x² + v_y² + v_z²)", .inputs = {node_mass()}, .evaluate = {}};
    append_all(e.inputs, "v", "velocity", position_.cols());
    const auto squares = [](std::span<const Real> x) { return points(x.subspan(1)).squaredNorm(); };
    e.evaluate = [squares](std::span<const Real> x) { return 0.5 * x[0] * squares(x); };
    e.substitute = [squares](std::span<const Real> x) {
        return fmt::format("½ · {} · {}", as_factor(x[0]), as_factor(squares(x)));
    };
    return e;
}

Explanation ClothLesson::why_family_energy(Family family) const {
    constexpr std::array<const char*, family_count> symbols{"Uₛ", "U_d", "U_b"};
    Explanation e{.formula = fmt::format("{} = ½ k Σ (|x_ij| − l)²", symbols[family]),
                  .inputs = {stiffness_of_spring(sheet_->first(family))},
                  .evaluate = {}};
    if (sheet_->first(family) == sheet_->last(family)) return fixed_value(fmt::format("{} = 0: no springs", symbols[family]), 0);
    append_all(e.inputs, "", "position", position_.cols());
    const auto squares = [this, family](std::span<const Real> x) {
        const Springs& springs = sheet_->springs();
        const auto at = points(x.subspan(1));
        Real sum = 0;
        for (Index s = sheet_->first(family); s < sheet_->last(family); ++s) {
            const Real elongation = (at.col(springs.j(s)) - at.col(springs.i(s))).norm() - springs.rest_length()[s];
            sum += elongation * elongation;
        }
        return sum;
    };
    e.evaluate = [squares](std::span<const Real> x) { return 0.5 * x[0] * squares(x); };
    e.substitute = [squares](std::span<const Real> x) {
        return fmt::format("½ · {} · {}", as_factor(x[0]), as_factor(squares(x)));
    };
    return e;
}

Explanation ClothLesson::why_gravitational_energy() const {
    if (gravity == 0) return fixed_value("V = 0: there is no weight", 0);
    Explanation e{.formula = "V = m g Σ y", .inputs = {node_mass(), Input::of(gravity)}, .evaluate = {}};
    for (Index n = 0; n < position_.cols(); ++n) e.inputs.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    e.evaluate = [](std::span<const Real> x) {
        Real sum = 0;
        for (const Real y : x.subspan(2)) sum += y;
        return x[0] * x[1] * sum;
    };
    e.substitute = [](std::span<const Real> x) {
        return fmt::format("{} · {} · ({})", as_factor(x[0]), as_factor(x[1]), sum_text(x.subspan(2)));
    };
    return e;
}

// Of the spring where the strain is largest now.
Explanation ClothLesson::why_largest_stretch() const {
    const Springs& springs = sheet_->springs();
    VecX strain(springs.size());
    spring_strain<3>(springs, position_, strain);
    Index most = 0;
    strain.head(sheet_->last(structural)).maxCoeff(&most);
    const Index i = springs.i(most), j = springs.j(most);
    Explanation e{.formula = fmt::format(
                      "ε = max(0, |x_{0} − x_{1}| / l − 1), the largest: of spring {2} between nodes {1} and {0}", j, i, most),
                  .inputs = {Input::constant("l", springs.rest_length()[most], "m", "rest length of the spring")},
                  .evaluate = {}};
    for (const Index node : {j, i})
        for (int c = 0; c < 3; ++c) e.inputs.push_back(Input::now(fmt::format("{}_{}", axis_name(c), node), "position", node, c));
    const auto length = [](std::span<const Real> x) { return Vec<3>(x[1] - x[4], x[2] - x[5], x[3] - x[6]).norm(); };
    e.evaluate = [length](std::span<const Real> x) { return std::max(Real{0}, length(x) / x[0] - 1); };
    e.substitute = [length](std::span<const Real> x) {
        return fmt::format("max(0, {} / {} − 1)", format_quantity(length(x), "", 8), format_quantity(x[0], "", 8));
    };
    return e;
}

Explanation ClothLesson::why_lowest() const {
    Index node = 0;
    position_.row(1).minCoeff(&node);
    return {.formula = fmt::format("y = y_{0}: of node {0}, the lowest", node),
            .inputs = {Input::now(fmt::format("y_{}", node), "position", node, 1)},
            .evaluate = [](std::span<const Real> x) { return x[0]; }};
}

Explanation ClothLesson::why_drape() const {
    const bool disc = setting == Setting::pedestal;
    Explanation e{.formula = disc ? "D = (A − π R²) / (L² − π R²), A = |Σ A_y|"
                                  : "D = A / L², A = |Σ A_y|, of all triangles seen from above",
                  .inputs = {Input::of(size)},
                  .evaluate = {}};
    if (disc) e.inputs.push_back(Input::of(sphere_radius));
    append_all(e.inputs, "", "position", position_.cols());
    const auto parts = [this, disc](std::span<const Real> x) {
        const Real taken = disc ? std::numbers::pi * x[1] * x[1] : 0;
        return std::array{sheet_->shadow(points(x.subspan(disc ? 2 : 1))), taken, x[0] * x[0]};
    };
    e.evaluate = [parts](std::span<const Real> x) {
        const auto [area, taken, flat_area] = parts(x);
        return (area - taken) / (flat_area - taken);
    };
    e.substitute = [parts](std::span<const Real> x) {
        const auto [area, taken, flat_area] = parts(x);
        return fmt::format("({0:.6g} − {1:.6g}) / ({2:.6g} − {1:.6g})", area, taken, flat_area);
    };
    return e;
}

}  // namespace pliant::cloth
