// Why the probes are what they are: sums over all nodes, computed again from their positions and velocities.
#include "cloth.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace pliant::cloth {
namespace {

Explanation why_family_energy(const ClothLesson& l, SpringFamily family) {
    constexpr std::array<const char*, spring_families> symbols{"Uₛ", "U_d", "U_b"};
    const Index first = l.sheet_->first(family), last = l.sheet_->last(family);
    if (first == last) return fixed_value(fmt::format("{} = 0: no springs", symbols[family]));
    Explanation e{fmt::format("{} = ½ k L(x_n), L = Σ (|x_ij| − l)² over the springs", symbols[family]),
                  {l.stiffness_of_spring(first)}};
    springs::append_points(e.inputs, "x_n", "", "position", l.position_.cols());
    return std::move(e).by("L", "m²", [&l, first, last](Values x) {
        return springs::elongation_squares(l.sheet_->springs(), first, last, springs::points(x));
    });
}

// Of the spring where the strain is largest now.
Explanation why_largest_stretch(const ClothLesson& l) {
    const Springs& springs = l.sheet_->springs();
    VecX strain(springs.size());
    spring_strain<3>(springs, l.position_, strain);
    Index most = 0;
    strain.head(l.sheet_->last(structural)).maxCoeff(&most);
    const Index i = springs.i(most), j = springs.j(most);
    return {fmt::format("ε = max(0, |x_ij| / l − 1), the largest: of spring {} between nodes i = {} and j = {}", most, i, j),
            {springs::rest_length(springs, most), springs::length_between(Input::now, j, i)}};
}

Explanation why_drape(const ClothLesson& l) {
    const bool disc = l.setting == Setting::pedestal;
    Explanation e{disc ? "D = (A(x_n) − π R²) / (L² − π R²), A = |Σ A_y| of all triangles"
                       : "D = A(x_n) / L², A = |Σ A_y|, of all triangles seen from above",
                  {l.size}};
    if (disc) e.inputs.push_back(l.sphere_radius);
    springs::append_points(e.inputs, "x_n", "", "position", l.position_.cols());
    return std::move(e).by("A", "m²", [&l](Values x) { return l.sheet_->shadow(springs::points(x)); });
}

}  // namespace

void ClothLesson::explain_probes() {
    const auto give = [this](std::string_view name, std::function<Explanation(const ClothLesson&)> why) {
        explain_probe(name, [this, why] { return why(*this); });
    };
    using L = const ClothLesson&;
    give("energy", [](L l) { return springs::energy_in_all(l.load_, l.pull_stiffness); });
    give("kinetic_energy", [](L l) { return springs::kinetic_energy_of(l.node_mass(), l.position_.cols()); });
    give("stretch_energy", [](L l) { return why_family_energy(l, structural); });
    give("shear_energy", [](L l) { return why_family_energy(l, shear); });
    give("bending_energy", [](L l) { return why_family_energy(l, bending); });
    give("bending_share", [](L) -> Explanation {
        return {"U_b/U = U_b / U", {Input::now("U_b", "bending_energy", 0), Input::now("U", "elastic_energy", 0)}};
    });
    give("gravitational_energy", [](L l) {
        return l.gravity == 0 ? fixed_value("V = 0: there is no weight")
                              : springs::gravitational_energy_of(l.node_mass(), l.gravity, l.position_.cols());
    });
    give("largest_strain", why_largest_stretch);
    give("lowest", [](L l) -> Explanation {
        Index node = 0;
        l.position_.row(1).minCoeff(&node);
        return {fmt::format("y = y_{0}: of node {0}, the lowest", node),
                {Input::now(fmt::format("y_{}", node), "position", node, 1)}};
    });
    give("drape_coefficient", why_drape);
}

}  // namespace pliant::cloth
