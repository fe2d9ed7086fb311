// Why the probes are what they are.
#include "rod.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::rod {
namespace {

Explanation why_elastic_energy(const RodLesson& l) {
    Explanation e{"U = ½ EA Δs Σ_i (√((x_j − x_i)² + (y_j − y_i)²) / Δs − 1)², j = i + 1",
                  {l.why_axial_stiffness(), l.why_segment()}};
    for (Index i = 0; i < l.segments; ++i)
        for (int c = 0; c < 2; ++c)
            for (const Index n : {i, i + 1})
                e.inputs.push_back(Input::now(fmt::format("{}_{}", axis_name(c), n), "position", n, c)
                                       .in(fmt::format("{}_{}", axis_name(c), n == i ? "i" : "j")));
    return e;
}

Explanation why_force_difference(const RodLesson& l) {
    Index row = 0, node = 0;
    (l.gradient_force_ - l.spring_force_).cwiseAbs().maxCoeff(&row, &node);
    const int c = static_cast<int>(row);
    return {fmt::format("Δf = |g − f|, the largest: {} of node {}", c ? "y" : "x", node),
            {Input::now("g", "gradient_force", node, c), Input::now("f", "spring_force", node, c)}};
}

Explanation why_imbalance(const RodLesson& l) {
    Points<2> force = l.spring_force_;
    if (l.loaded()) force += l.external_force_;
    Index node = 0;
    (force.rightCols(l.count()).transpose() * l.along()).cwiseAbs().maxCoeff(&node);
    ++node;
    Explanation e{fmt::format("|f| = |f_y|, the largest: of node {}", node), {Input::now("f_y", "spring_force", node, 1)}};
    if (l.loaded()) {
        e.formula = fmt::format("|f| = |f_y + fᵉ|, the largest: of node {}", node);
        e.inputs.push_back(Input::now("fᵉ", "external_force", node, 1));
    }
    return e;
}

Explanation why_mode_amplitude(const RodLesson& l) {
    const VecX shape = l.mode_shape();
    std::vector<std::pair<Input, Input>> terms;
    for (Index n = 1; n <= l.segments; ++n)
        terms.emplace_back(Input::constant(fmt::format("w{}", n), shape[n] / shape.squaredNorm(), "", "φ/Σφ² of this node"),
                           Input::now(fmt::format("u{}", n), "displacement", n));
    return weighted_sum("q = Σ_n w_n u_n, w = φ/Σφ²", "w_n", "u_n", terms);
}

// The mean of s, weighted by the elastic energy of the l.segments and the kinetic energy of the nodes.
Explanation why_pulse_position(const RodLesson& l) {
    Explanation e{
        "s_p = M(EA, Δs, m, x_n, v_n) / E(EA, Δs, m, x_n, v_n), M = Σ s E, E = ½ EA ε² Δs of segments and ½ m v² of nodes",
        {l.why_axial_stiffness(), l.why_segment(), l.why_node_mass()}};
    const Index nodes = l.segments + 1;
    springs::append_points(e.inputs, "x_n", "", "position", nodes, 2);
    springs::append_points(e.inputs, "v_n", "v", "velocity", nodes, 2);
    // Σ s^power E
    const auto summed = [nodes](int power) {
        return [nodes, power](Values x) {
            const auto all = springs::points<2>(x.subspan(3));
            const auto at = all.leftCols(nodes), moving = all.rightCols(nodes);
            Real sum = 0;
            for (Index i = 0; i + 1 < nodes; ++i) {
                const Real strain = ((at.col(i + 1) - at.col(i)) / x[1]).norm() - 1, s = static_cast<Real>(i) * x[1];
                const Real elastic = 0.5 * x[0] * x[1] * strain * strain, kinetic = 0.5 * x[2] * moving.col(i + 1).squaredNorm();
                sum += power == 0 ? elastic + kinetic : elastic * (s + 0.5 * x[1]) + kinetic * (s + x[1]);
            }
            return sum;
        };
    };
    return std::move(e).by("M", "J m", summed(1)).by("E", "J", summed(0));
}

}  // namespace

void RodLesson::explain_probes() {
    explain_probe("tip_displacement", [this] {
        return Explanation{"u_L = u: of the last node", {Input::now("u", "displacement", segments)}};
    });
    explain_probe("stiffness", [this] { return why_field({"spring_stiffness", 0}); });
    explain_probe("elastic_energy", [this] { return why_elastic_energy(*this); });
    explain_probe("kinetic_energy", [this] {
        return hangs_still() ? fixed_value("K = 0: the rod hangs still")
                             : springs::kinetic_energy_of(why_node_mass(), segments + 1, 2);
    });
    explain_probe("gravitational_energy", [this] {
        return loaded() ? springs::gravitational_energy_of(why_node_mass(), gravity, segments + 1)
                        : fixed_value("V = 0: there is no weight");
    });
    explain_probe("force_difference", [this] { return why_force_difference(*this); });
    explain_probe("imbalance", [this] { return why_imbalance(*this); });
    explain_probe("mode_amplitude", [this] { return why_mode_amplitude(*this); });
    explain_probe("frequency", [this]() -> Explanation {
        return {
            "ω = 2 π / T_q",
            {Input::constant("T_q", rhythm_.period().value_or(0), "s", "mean time from one rise of q through 0 to the next")}};
    });
    explain_probe("frequency_chain", [this]() -> Explanation {
        return {"ω_j = 2 √(k / m) sin(θ / 2)",
                {why_stiffness(), why_node_mass(),
                 Input::constant("θ", chain().phase(watched_mode(), end()), "rad", "(2j − 1)π/(2N + 1)")}};
    });
    explain_probe("frequency_continuum", [this]() -> Explanation {
        return {"ω_c = κ √(EA L / M)",
                {Input::constant("κ", continuum().wave_number(watched_mode(), end()), "1/m", "(2j − 1)π/(2L)"), axial_stiffness,
                 length, total_mass}};
    });
    explain_probe("pulse_position", [this] { return why_pulse_position(*this); });
    explain_probe("wave_speed", [this]() -> Explanation {
        const Index turned = turns().value_or(0), even = turned + turned % 2;
        return {
            "c = (d + q s_p − s_start) / t",
            {Input::constant("d", static_cast<Real>(even) * length, "m", "whole lengths of the rod that it has run"),
             Input::constant("q", turned % 2 == 0 ? 1 : -1, "", "1 on its way out, −1 on its way back"),
             Input::now("s_p", "pulse_position", 0), Input::constant("s_start", start_position_, "m", "the same at the start"),
             Input::constant("t", clock_[elapsed], "s", "time since")}};
    });
}

}  // namespace pliant::rod
