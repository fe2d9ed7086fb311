// Why the probes are what they are.
#include "rod.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::rod {
namespace {

using Values = std::span<const Real>;
using std::numbers::pi;

void append_all(std::vector<Input>& inputs, std::string_view mark, std::string_view field, Index nodes) {
    for (Index n = 0; n < nodes; ++n)
        for (int c = 0; c < 2; ++c) inputs.push_back(Input::now(fmt::format("{}{}_{}", mark, c ? "y" : "x", n), field, n, c));
}

Eigen::Map<const Points<2>> points(Values x) { return {x.data(), 2, static_cast<Index>(x.size() / 2)}; }

Explanation same(std::string formula, Input input) {
    return {std::move(formula), {std::move(input)}, [](Values x) { return x[0]; }};
}

}  // namespace

void RodLesson::explain_probes() {
    const auto give = [this](std::string_view name, auto why) { std::ranges::find(probes, name, &Probe::name)->explain = why; };
    give("tip_displacement", [this] { return same("u_L = u of the last node", Input::now("u", "displacement", segments)); });
    give("tip_over_continuum", [this]() -> Explanation {
        return {"u_L / u_c", {Input::now("u_L", "tip_displacement", 0), why_continuum_tip()}};
    });
    give("tip_of_chain", [this]() -> Explanation {
        return {"u_N = M g (N + 1) / (2 k)", {Input::of(total_mass), Input::of(gravity), Input::of(segments), why_stiffness()}};
    });
    give("stiffness", [this] { return why_spring({"spring_stiffness", 0}); });
    give("chain_axial_stiffness", [this]() -> Explanation { return {"k Δs", {why_stiffness(), why_segment()}}; });
    give("energy", [] {
        return sum_of("E = K + U + V", {Input::now("K", "kinetic_energy", 0), Input::now("U", "elastic_energy", 0),
                                        Input::now("V", "gravitational_energy", 0)});
    });
    give("elastic_energy", [this] { return why_elastic_energy(); });
    give("kinetic_energy", [this] { return why_kinetic_energy(); });
    give("gravitational_energy", [this] { return why_gravitational_energy(); });
    give("force_difference", [this] { return why_force_difference(); });
    give("imbalance", [this] { return why_imbalance(); });
    give("mode_amplitude", [this] { return why_mode_amplitude(); });
    give("frequency", [this]() -> Explanation {
        return {
            "ω = 2 π / T_q",
            {Input::constant("T_q", rhythm_.period().value_or(0), "s", "mean time from one rise of q through 0 to the next")}};
    });
    give("frequency_chain", [this]() -> Explanation {
        return {"ω_j = 2 √(k / m) sin(θ / 2)",
                {why_stiffness(), why_node_mass(),
                 Input::constant("θ", chain().phase(watched_mode(), end()), "rad", "(2j − 1)π/(2N + 1)")}};
    });
    give("frequency_continuum", [this]() -> Explanation {
        return {"ω_c = κ √(EA L / M)",
                {Input::constant("κ", continuum().wave_number(watched_mode(), end()), "1/m", "(2j − 1)π/(2L)"),
                 Input::of(axial_stiffness), Input::of(length), Input::of(total_mass)}};
    });
    give("pulse_position", [this] { return why_pulse_position(); });
    give("wave_speed", [this]() -> Explanation {
        const Index turned = turns().value_or(0), even = turned + turned % 2;
        return {
            "c = (d + q s_p − s_start) / t",
            {Input::constant("d", static_cast<Real>(even) * length, "m", "whole lengths of the rod that it has run"),
             Input::constant("q", turned % 2 == 0 ? 1 : -1, "", "1 on its way out, −1 on its way back"),
             Input::now("s_p", "pulse_position", 0), Input::constant("s_start", start_position_, "m", "the same at the start"),
             Input::constant("t", clock_[elapsed], "s", "time since")}};
    });
}

Input RodLesson::why_continuum_tip() const {
    return Input::part(
        "u_c", "m",
        {"u_c = M g L / (2 EA)", {Input::of(total_mass), Input::of(gravity), Input::of(length), Input::of(axial_stiffness)}});
}

Explanation RodLesson::why_elastic_energy() const {
    Explanation e{"U = ½ EA Δs Σ (|x_j − x_i| / Δs − 1)²", {why_axial_stiffness(), why_segment()}, {}};
    append_all(e.inputs, "", "position", segments + 1);
    const auto squares = [](Values x) {
        const auto at = points(x.subspan(2));
        Real sum = 0;
        for (Index i = 0; i + 1 < at.cols(); ++i) {
            const Real strain = ((at.col(i + 1) - at.col(i)) / x[1]).norm() - 1;
            sum += strain * strain;
        }
        return sum;
    };
    e.evaluate = [squares](Values x) { return 0.5 * x[0] * x[1] * squares(x); };
    e.substitute = [squares](Values x) {
        return fmt::format("½ · {} · {} · {}", as_factor(x[0]), as_factor(x[1]), as_factor(squares(x)));
    };
    return e;
}

Explanation RodLesson::why_kinetic_energy() const {
    if (hangs_still()) return fixed_value("K = 0: the rod hangs still", 0);
    Explanation e{"K = ½ m Σ (vx² + vy²)", {why_node_mass()}, {}};
    append_all(e.inputs, "v", "velocity", segments + 1);
    const auto squares = [](Values x) { return points(x.subspan(1)).squaredNorm(); };
    e.evaluate = [squares](Values x) { return 0.5 * x[0] * squares(x); };
    e.substitute = [squares](Values x) { return fmt::format("½ · {} · {}", as_factor(x[0]), as_factor(squares(x))); };
    return e;
}

Explanation RodLesson::why_gravitational_energy() const {
    if (!loaded()) return fixed_value("V = 0: there is no weight", 0);
    Explanation e{"V = m g Σ y", {why_node_mass(), Input::of(gravity)}, {}};
    for (Index n = 0; n <= segments; ++n) e.inputs.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    const auto sum = [](Values x) {
        Real total = 0;
        for (const Real y : x.subspan(2)) total += y;
        return total;
    };
    e.evaluate = [sum](Values x) { return x[0] * x[1] * sum(x); };
    e.substitute = [](Values x) {
        return fmt::format("{} · {} · ({})", as_factor(x[0]), as_factor(x[1]), sum_text(x.subspan(2)));
    };
    return e;
}

Explanation RodLesson::why_force_difference() const {
    Index row = 0, node = 0;
    (gradient_force_ - spring_force_).cwiseAbs().maxCoeff(&row, &node);
    const int c = static_cast<int>(row);
    return {fmt::format("Δf = |g − f|, the largest: {} of node {}", c ? "y" : "x", node),
            {Input::now("g", "gradient_force", node, c), Input::now("f", "spring_force", node, c)}};
}

Explanation RodLesson::why_imbalance() const {
    Points<2> force = spring_force_;
    if (loaded()) force += external_force_;
    Index node = 0;
    (force.rightCols(count()).transpose() * along()).cwiseAbs().maxCoeff(&node);
    ++node;
    Explanation e{fmt::format("|f| = |f_y|, the largest: of node {}", node), {Input::now("f_y", "spring_force", node, 1)}, {}};
    if (loaded()) {
        e.formula = fmt::format("|f| = |f_y + fᵉ|, the largest: of node {}", node);
        e.inputs.push_back(Input::now("fᵉ", "external_force", node, 1));
    }
    e.evaluate = [](Values x) { return std::abs(x[0] + (x.size() > 1 ? x[1] : Real{0})); };
    return e;
}

Explanation RodLesson::why_mode_amplitude() const {
    const VecX shape = mode_shape();
    std::vector<std::pair<Input, Input>> terms;
    for (Index n = 1; n <= segments; ++n)
        terms.emplace_back(Input::constant(fmt::format("w{}", n), shape[n] / shape.squaredNorm(), "", "φ/Σφ² of this node"),
                           Input::now(fmt::format("u{}", n), "displacement", n));
    return weighted_sum("q = Σ w u over the nodes, w = φ/Σφ²", terms);
}

// The mean of s, weighted by the elastic energy of the segments and the kinetic energy of the nodes.
Explanation RodLesson::why_pulse_position() const {
    Explanation e{"s_p = Σ s E / Σ E over segments and nodes, from ½ EA ε² Δs and ½ m v²",
                  {why_axial_stiffness(), why_segment(), why_node_mass()},
                  {}};
    const Index nodes = segments + 1;
    append_all(e.inputs, "", "position", nodes);
    append_all(e.inputs, "v", "velocity", nodes);
    const auto sums = [nodes](Values x) {
        const auto all = points(x.subspan(3));
        const auto at = all.leftCols(nodes), moving = all.rightCols(nodes);
        Vec<2> moment_and_energy = Vec<2>::Zero();
        for (Index i = 0; i + 1 < nodes; ++i) {
            const Real strain = ((at.col(i + 1) - at.col(i)) / x[1]).norm() - 1, s = static_cast<Real>(i) * x[1];
            const Real elastic = 0.5 * x[0] * x[1] * strain * strain, kinetic = 0.5 * x[2] * moving.col(i + 1).squaredNorm();
            moment_and_energy += Vec<2>(elastic * (s + 0.5 * x[1]) + kinetic * (s + x[1]), elastic + kinetic);
        }
        return moment_and_energy;
    };
    e.evaluate = [sums](Values x) { return sums(x)[0] / sums(x)[1]; };
    e.substitute = [sums](Values x) { return fmt::format("{} / {}", as_factor(sums(x)[0]), as_factor(sums(x)[1])); };
    return e;
}

}  // namespace pliant::rod
