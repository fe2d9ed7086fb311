// Why forces and motion are what they are: each spring, damper, triangle and load of a node, and three integrators.
#include "cloth.h"
#include "kits/schemes/scheme_why.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::cloth {
namespace {

// ------------------------------------------------------------------------------------------------------------ springs

Explanation why_spring_force(const ClothLesson& l, Index node, int component) {
    const Springs& springs = l.sheet_->springs();
    return springs::sum_over_springs(
        springs, node, "f", "f_j = k (|x_ij| − l) (x_j − x_i) / |x_ij|", "f", [&](Index s, Index other) {
            const bool apart = l.position_.col(other) != l.position_.col(node);
            return springs::spring_on_node(l.stiffness_of_spring(s), springs::rest_length(springs, s), apart, other, node,
                                           component);
        });
}

Explanation why_largest_of_node(const ClothLesson& l, Index node, bool bent) {
    Explanation e{bent ? "β = max(0, max_s(− ε_s))" : "ε_s = farthest(ε_j), the one farthest from 0"};
    for (const Index s : l.sheet_->springs_of(node)) {
        if (l.sheet_->family_of(s) != (bent ? bending : structural)) continue;
        e.inputs.push_back(Input::now(fmt::format("ε_{}", springs::other_end(l.sheet_->springs(), s, node)), "strain", s)
                               .in(bent ? "ε_s" : "ε_j"));
    }
    if (e.inputs.empty()) return fixed_value(bent ? "β = 0: no spring bends here" : "ε_s = 0: no spring is stretched here");
    return std::move(e).by("farthest", "", [](Values x) {
        Real farthest = 0;
        for (const Real strain : x)
            if (std::abs(strain) > std::abs(farthest)) farthest = strain;
        return farthest;
    });
}

// direction_at: where the directions of projected dampers are taken from.
Explanation why_damping_force(const ClothLesson& l, Index node, int component, springs::Reading direction_at) {
    const bool projected = l.damping_mode == SpringDamping::projected;
    return springs::sum_over_springs(
        l.sheet_->springs(), node, "fᵈ", projected ? "fᵈ_j = kᵈ (v_ij · x_ij / |x_ij|²) (x_j − x_i)" : "fᵈ_j = kᵈ (v_j − v_i)",
        "fᵈ", [&](Index s, Index other) {
            const Input kd = l.sheet_->springs().stiffness()[s] > 0
                                 ? Input(l.damping)
                                 : Input::constant("kᵈ", 0, "N s/m", "a spring of stiffness 0 has no damper");
            return springs::damper_on_node({kd}, projected, other, node, component, direction_at);
        });
}

Explanation why_external_force(const ClothLesson& l, Index node, int component) {
    return springs::load_on_node(l.load_, l.node_mass(), l.gravity, l.pull_stiffness, node, component);
}

// ---------------------------------------------------------------------------------------------------------------- air

Input wind_component(const ClothLesson& l, int component) {
    const std::string symbol = fmt::format("w_{}", axis_name(component));
    if (component == (l.setting == Setting::flag ? 0 : 2)) return part(symbol + " = W", {l.wind});
    if (component == 1) return Input::part(symbol, "m/s", fixed_value(symbol + " = 0: the wind is level"));
    return part(symbol + " = W γ sin(2π f t)",
                {l.wind, l.gust, Input::constant("f", 1, "1/s", "how often the gust comes"),
                 Input::constant("t", l.gust_at_, "s", "since the wind began, at the start of the step")});
}

// One triangle at a time: its area vector, and how fast the air meets it.
Explanation why_drag(const ClothLesson& l, Index node, int row, int column) {
    std::vector<Input> terms;
    for (std::size_t t = 0; t < l.sheet_->triangles().size(); ++t) {
        const NodeTriple& corners = l.sheet_->triangles()[t];
        if (std::ranges::find(corners, node) == corners.end()) continue;
        Explanation e{fmt::format("C_{0} = drag(ρ, {1}, w_x, w_y, w_z, x_n, v_n), ρ {1} |u · A| A_{2} A_{3} / (6 |A|²) with "
                                  "A = ½ (b − a) × (c − a), u = w − (vᵃ + vᵇ + vᶜ) / 3",
                                  t, l.air_drag.info.symbol, axis_name(row), axis_name(column)),
                      {Input::constant("ρ", Air{}.density, "kg/m³", "density of the air"), l.air_drag}};
        for (int c = 0; c < 3; ++c) e.inputs.push_back(wind_component(l, c));
        for (const char* field : {"position", "velocity"})
            for (const Index corner : corners)
                for (int c = 0; c < 3; ++c)
                    e.inputs.push_back(
                        Input::now(fmt::format("{}{}_{}", field[0] == 'v' ? "v" : "", axis_name(c), corner), field, corner, c)
                            .in(field[0] == 'v' ? "v_n" : "x_n"));
        e = std::move(e).by("drag", "N s/m", [row, column](Values x) {
            const Air air{.velocity = {x[2], x[3], x[4]}, .density = x[0], .drag = x[1]};
            return triangle_drag(air, Eigen::Map<const Mat<3>>(x.data() + 5), Eigen::Map<const Mat<3>>(x.data() + 14))(row,
                                                                                                                       column);
        });
        terms.push_back(Input::part(fmt::format("C_{}", t), "N s/m", std::move(e)));
    }
    return sum_of("C = Σ_t C_t, over the triangles of the node", "C_t", std::move(terms));
}

// A row of C (w − v).
Explanation why_wind_force(const ClothLesson& l, Index node, int component) {
    Explanation e{"fʷ = "};
    for (int c = 0; c < 3; ++c) {
        const char* letter = axis_name(c);
        e.formula += fmt::format("{0}C_{1} (w_{1} − v_{1})", c ? " + " : "", letter);
        e.inputs.push_back(Input::now(fmt::format("C_{}", letter), "wind_drag", node, 3 * component + c));
        e.inputs.push_back(wind_component(l, c));
        e.inputs.push_back(Input::now(fmt::format("v_{}", letter), "velocity", node, c));
    }
    return e;
}

// ------------------------------------------------------------------------------------------------------------- motion

// Of the start of the step.
std::vector<Input> forces_on(const ClothLesson& l, Index node, int component) {
    std::vector<Input> forces{Input::now("f", "spring_force", node, component)};
    if (l.damped()) forces.push_back(Input::now("fᵈ", "damping_force", node, component));
    if (l.loaded()) forces.push_back(Input::now("fᵉ", "external_force", node, component));
    if (l.in_air()) forces.push_back(Input::now("fʷ", "wind_force", node, component));
    return forces;
}

// Of the end of the step, and what the solver has left unbalanced: much of it, after one Newton iteration.
std::vector<Input> balanced_forces_on(const ClothLesson& l, Index node, int component) {
    std::vector<Input> forces{Input::part("f(x′)", "N", why_spring_force(l, node, component))};
    if (l.damped()) forces.push_back(Input::part("fᵈ(v′)", "N", why_damping_force(l, node, component, Input::before)));
    if (l.loaded()) forces.push_back(Input::part("fᵉ(x′)", "N", why_external_force(l, node, component)));
    if (l.in_air()) forces.push_back(Input::part("fʷ(v′)", "N", why_wind_force(l, node, component)));
    for (Input& force : l.plane_forces_on(node, component)) forces.push_back(std::move(force));
    forces.push_back(stepping::imbalance_left(l.imbalance_[3 * node + component]));
    return forces;
}

// One Newton iteration: the iterate before it, and the direction.
Explanation why_newton_position(const ClothLesson& l, Index node, int component) {
    const ImplicitSolver& solver = *l.solver();
    const Index dof = 3 * node + component;
    const Input x = Input::before("x", "position", node, component), v = Input::before("v", "velocity", node, component);
    const Input start = solver.began_at_prediction() ? part("x_k = x + Δt v", {x, l.dt, v}) : part("x_k = x", {x});
    const Input direction =
        l.iterative() ? stepping::newton_direction(solver, dof, l.system_->tangent().diagonal(dof), l.system_->tangent().row(dof))
                      : stepping::newton_direction(solver, dof);
    return stepping::newton_iterate("x′", "x", solver, dof,
                                    solver.iterations() == 1 ? start : Input::earlier("x_k", "position", node, component),
                                    direction, std::nullopt);
}

}  // namespace

Input ClothLesson::stiffness_of_spring(Index s) const {
    const std::array<const Number*, spring_families> all{&k_structural, &k_shear, &k_bending};
    return Input::of(*all[sheet_->family_of(s)], "k");
}

Explanation ClothLesson::why_force(const Question& q) const {
    if (q.field == "strain") return springs::strain_of(sheet_->springs(), q.index, strain_[q.index]);
    if (q.field == "stretch" || q.field == "bending") return why_largest_of_node(*this, q.index, q.field == "bending");
    if (q.field == "damping_force") return why_damping_force(*this, q.index, q.component, Input::now);
    if (q.field == "external_force") return why_external_force(*this, q.index, q.component);
    if (q.field == "wind_drag") return why_drag(*this, q.index, q.component / 3, q.component % 3);
    if (q.field == "wind_force") return why_wind_force(*this, q.index, q.component);
    return why_spring_force(*this, q.index, q.component);
}

Explanation ClothLesson::why_integrated(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    const Input v = Input::before("v", "velocity", q.index, q.component);
    if (sheet_->inertia().fixed(3 * q.index)) {
        if (of_velocity) return {"v′ = v: the node is held", {v}};
        return stepping::drifted(dt, q.index, q.component, false);
    }
    if (!implicit())
        return of_velocity ? stepping::pushed(v, dt, node_mass(), forces_on(*this, q.index, q.component))
                           : stepping::drifted(dt, q.index, q.component, scheme == Scheme::semi_implicit_euler);
    if (!solver()->again())
        return of_velocity ? stepping::pushed(v, dt, node_mass(), balanced_forces_on(*this, q.index, q.component))
                           : stepping::drifted(dt, q.index, q.component, true);
    if (!of_velocity) return why_newton_position(*this, q.index, q.component);
    return {"v′ = (x′ − x) / Δt",
            {Input::now("x′", "position", q.index, q.component), Input::before("x", "position", q.index, q.component), dt}};
}

}  // namespace pliant::cloth
