// Why the probes are what they are: sums over all nodes, computed again from their positions and velocities.
#include "cloth.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace pliant::cloth {
namespace {

using Values = std::span<const Real>;

Explanation why_family_energy(const ClothLesson& l, SpringFamily family) {
    constexpr std::array<const char*, spring_families> symbols{"Uₛ", "U_d", "U_b"};
    const Index first = l.sheet_->first(family), last = l.sheet_->last(family);
    if (first == last) return fixed_value(fmt::format("{} = 0: no springs", symbols[family]), 0);
    std::vector<Input> positions;
    springs::append_all(positions, "", "position", l.position_.cols());
    return springs::times_total(fmt::format("{} = ½ k Σ (|x_ij| − l)²", symbols[family]), true, {l.stiffness_of_spring(first)},
                                std::move(positions), [&l, first, last](Values, Values x) {
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
    Explanation e{
        fmt::format("ε = max(0, |x_{0} − x_{1}| / l − 1), the largest: of spring {2} between nodes {1} and {0}", j, i, most),
        {springs::rest_length(springs, most)}};
    for (const Index node : {j, i})
        for (int c = 0; c < 3; ++c) e.inputs.push_back(Input::now(fmt::format("{}_{}", axis_name(c), node), "position", node, c));
    const auto length = [](Values x) { return Vec<3>(x[1] - x[4], x[2] - x[5], x[3] - x[6]).norm(); };
    e.evaluate = [length](Values x) { return std::max(Real{0}, length(x) / x[0] - 1); };
    e.substitute = [length](Values x) {
        return fmt::format("max(0, {} / {} − 1)", format_quantity(length(x), "", 8), format_quantity(x[0], "", 8));
    };
    return e;
}

Explanation why_drape(const ClothLesson& l) {
    const bool disc = l.setting == Setting::pedestal;
    Explanation e{
        disc ? "D = (A − π R²) / (L² − π R²), A = |Σ A_y|" : "D = A / L², A = |Σ A_y|, of all triangles seen from above",
        {l.size}};
    if (disc) e.inputs.push_back(l.sphere_radius);
    springs::append_all(e.inputs, "", "position", l.position_.cols());
    const auto parts = [&l, disc](Values x) {
        const Real taken = disc ? std::numbers::pi * x[1] * x[1] : 0;
        return std::array{l.sheet_->shadow(springs::points(x.subspan(disc ? 2 : 1))), taken, x[0] * x[0]};
    };
    e.evaluate = [parts](Values x) {
        const auto [area, taken, flat_area] = parts(x);
        return (area - taken) / (flat_area - taken);
    };
    e.substitute = [parts](Values x) {
        const auto [area, taken, flat_area] = parts(x);
        return fmt::format("({0:.6g} − {1:.6g}) / ({2:.6g} − {1:.6g})", area, taken, flat_area);
    };
    return e;
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
    give("elastic_energy", [](L) {
        return sum_of("U = Uₛ + U_d + U_b", {Input::now("Uₛ", "stretch_energy", 0), Input::now("U_d", "shear_energy", 0),
                                             Input::now("U_b", "bending_energy", 0)});
    });
    give("bending_share", [](L) -> Explanation {
        return {"U_b/U = U_b / U", {Input::now("U_b", "bending_energy", 0), Input::now("U", "elastic_energy", 0)}};
    });
    give("gravitational_energy", [](L l) {
        return l.gravity == 0 ? fixed_value("V = 0: there is no weight", 0)
                              : springs::gravitational_energy_of(l.node_mass(), l.gravity, l.position_.cols());
    });
    give("largest_stretch", why_largest_stretch);
    give("lowest", [](L l) -> Explanation {
        Index node = 0;
        l.position_.row(1).minCoeff(&node);
        return {fmt::format("y = y_{0}: of node {0}, the lowest", node),
                {Input::now(fmt::format("y_{}", node), "position", node, 1)}};
    });
    give("drape_coefficient", why_drape);
}

}  // namespace pliant::cloth
