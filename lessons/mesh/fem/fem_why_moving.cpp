// Why a body moves as it does: damping, what acts from outside, the integrators, the ground.
#include "fem.h"

#include "kits/schemes/scheme_why.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::fem {

Input FemLesson::node_mass(Index node) const {
    return part("m = ρ V_a",
                {density, Input::constant("V_a", motion_->node_mass()[node] / density, "m³", "the node's share of the volume")});
}

// Of the load on the loaded face.
Input FemLesson::share_of_load(Index node, int component) const {
    const std::array<const Number*, 3> forces{&body.load_x, &body.load_y, &body.load_z};
    return part("f = F A_a / A",
                {Input::of(*forces[static_cast<std::size_t>(component)], "F"),
                 Input::constant("A_a", solid_->loaded_area()[node], "m²", "the node's share of the loaded face"),
                 Input::constant("A", solid_->loaded_area().sum(), "m²", "area of the loaded face")});
}

std::optional<Explanation> FemLesson::why_outer(const Question& q) const {
    if (q.field == "damping_force") return why_damping(q.index, q.component);
    return why_external(q.index, q.component);
}

// A row of a matrix times the velocities, as two families.
void FemLesson::add_row(std::vector<Input>& inputs, const SparseMatrix& matrix, Index row, const RowWords& words) const {
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
        if (entry.value() == 0) continue;
        const Index other = entry.row() / solid_->dim();
        const int c = static_cast<int>(entry.row() % solid_->dim());
        const std::string place = fmt::format("{}_{}", axis_name(c), other);
        inputs.push_back(
            Input::constant(words.letter + place, entry.value(), words.unit, "entry of the matrix").in(words.entries));
        inputs.push_back(Input::now("v" + words.letter + place, "velocity", other, c).in(words.speeds));
    }
}

Explanation FemLesson::why_damping(Index node, int component) const {
    const bool by_mass = alpha() > 0, by_stiffness = stiffness_damping > 0, simple = lumped();
    const Index row = solid_->dim() * node + component;
    Explanation e;
    std::string sum;
    if (by_mass) {
        sum += simple ? " − α m v" : " − α Σ_c M_ac v_c";
        e.inputs.push_back(mass_damping);
        if (simple)
            e.inputs.push_back(node_mass(node)), e.inputs.push_back(Input::now("v", "velocity", node, component));
        else
            add_row(e.inputs, *motion_->mass().matrix(), row, {"M", "kg", "M_ac", "v_c"});
    }
    if (by_stiffness) {
        sum += " − β Σ_b K_ab v_b";
        e.inputs.push_back(stiffness_damping);
        add_row(e.inputs, damping_stiffness(), row, {"K", "N/m", "K_ab", "v_b"});
    }
    e.formula = "fᵈ =" + sum;
    return e;
}

Explanation FemLesson::why_external(Index node, int component) const {
    std::vector<Input> inputs;
    std::string sum;
    const auto add = [&](std::string_view sign, std::string_view symbol, Input input) {
        sum += sum.empty() && sign == "+" ? std::string(symbol) : fmt::format(" {} {}", sign, symbol);
        inputs.push_back(std::move(input));
    };
    if (bent() && solid_->loaded_area()[node] > 0) add("+", "f", share_of_load(node, component));
    if (component == 1 && weight_acceleration() > 0) add("−", "w", part("w = m g", {node_mass(node), gravity}));
    if (pull_ && pull_->index == node)
        add("+", "p",
            part("p = kₕ (h − x)",
                 {Input::of(pull_stiffness, "kₕ"), Input::constant("h", pull_->to[component], "m", "where the hand is"),
                  Input::now("x", "position", node, component)}));
    if (inputs.empty()) return fixed_value("fᵉ = 0: nothing acts here from outside");
    return {"fᵉ =" + (sum.front() == ' ' ? sum : " " + sum), std::move(inputs)};
}

// The forces that push a node in a step of an explicit scheme: at its start.
std::vector<Input> FemLesson::forces_at_start(Index node, int component) const {
    std::vector<Input> forces{part("f = −fⁱ", {Input::now("fⁱ", "internal_force", node, component)})};
    if (damped()) forces.push_back(Input::now("fᵈ", "damping_force", node, component));
    forces.push_back(Input::now("fᵉ", "external_force", node, component));
    return forces;
}

std::optional<Explanation> FemLesson::why_integrated(const Question& q) const {
    const Input x = Input::before("x", "position", q.index, q.component),
                v = Input::before("v", "velocity", q.index, q.component);
    if (q.field == "displacement")
        return Explanation{"u = x − X", {Input::now("x", "position", q.index, q.component), place_at_rest(q.index, q.component)}};
    const bool of_velocity = q.field == "velocity";
    if (solid_->held(q.index)) {
        if (of_velocity) return Explanation{"v′ = v: the support holds the node", {v}};
        return stepping::drifted(dt, q.index, q.component, false);
    }
    if (!implicit() && of_velocity && !lumped()) return why_coupled(q.index, q.component, v);
    if (!implicit())
        return of_velocity ? stepping::pushed(v, dt, node_mass(q.index), forces_at_start(q.index, q.component))
                           : stepping::drifted(dt, q.index, q.component, scheme() == Scheme::semi_implicit_euler);
    if (of_velocity) return Explanation{"v′ = (x′ − x) / Δt", {Input::now("x′", "position", q.index, q.component), x, dt}};
    return why_newton(q.index, q.component);
}

// With a consistent mass the accelerations of the neighbours are in the row too.
Explanation FemLesson::why_coupled(Index node, int component, const Input& v) const {
    const Index row = solid_->dim() * node + component;
    const SparseMatrix& M = *motion_->mass().matrix();
    const VecX& a = motion_->integrator().acceleration(0);
    std::vector<Input> forces = forces_at_start(node, component);
    std::string sum = forces[0].symbol;
    for (std::size_t k = 1; k < forces.size(); ++k) sum += " + " + forces[k].symbol;
    Explanation e{fmt::format("v′ = v + Δt ({} − Σ_b M_ab a_b) / M_aa", sum), std::move(forces)};
    e.inputs.push_back(v), e.inputs.push_back(dt);
    e.inputs.push_back(Input::constant("M_aa", M.coeff(row, row), "kg", "diagonal of the mass matrix"));
    for (SparseMatrix::InnerIterator entry(M, row); entry; ++entry) {
        if (entry.row() == row || entry.value() == 0) continue;
        const std::string place = fmt::format("{}", entry.row());
        e.inputs.push_back(Input::constant("M_" + place, entry.value(), "kg", "entry of the mass matrix").in("M_ab"));
        e.inputs.push_back(Input::constant("a_" + place, a[entry.row()], "m/s²", "acceleration, from M a = f").in("a_b"));
    }
    return e;
}

// The latest iterate: the one before it, and the direction.
Explanation FemLesson::why_newton(Index node, int component) const {
    const ImplicitSolver& solver = motion_->integrator().solver();
    const Index dof = solid_->dim() * node + component;
    const VecX& lower = solver.form().lower_bound;
    std::optional<Input> bound;
    if (lower.size() > 0 && std::isfinite(lower[dof]))
        bound = Input::constant("b", lower[dof], "m", "the ground, or the node itself if below");
    const Input x = Input::before("x", "position", node, component), v = Input::before("v", "velocity", node, component);
    Input iterate = Input::earlier("x_k", "position", node, component);
    if (solver.iterations() == 1)
        iterate = !solver.began_at_prediction() ? part("x_k = x", {x})
                  : bound                       ? part("x_k = max(x + Δt v, b)", {x, dt, v, *bound})
                                                : part("x_k = x + Δt v", {x, dt, v});
    return stepping::newton_iterate("x′", "x", solver, dof, iterate, stepping::newton_direction(solver, dof), bound);
}

// Nothing, where the ground has left the number as it was.
std::optional<Explanation> FemLesson::why_contact(const Question& q) const {
    if (q.field == "displacement")
        return Explanation{"u = x − X", {Input::now("x", "position", q.index, q.component), place_at_rest(q.index, q.component)}};
    const Touch touch = motion_->touch(q.index);
    if (touch == Touch::none) return std::nullopt;
    if (q.field == "position") {
        if (q.component != 1 || touch != Touch::below) return std::nullopt;
        return Explanation{"y′ = max(y, 0)", {Input::before("y", "position", q.index, 1)}};
    }
    if (q.component == 1) return fixed_value("v_y′ = 0: it stays on the ground");
    const TimeIntegrator& integrator_used = motion_->integrator();
    const Input taken =
        part("u′ = Δt R / m − v_y", {dt,
                                     Input::constant("R", integrator_used.solver().reaction(solid_->dim() * q.index + 1), "N",
                                                     "force of the ground, from the solver"),
                                     node_mass(q.index), Input::before("v_y", "velocity", q.index, 1)});
    std::vector<Input> speeds{Input::before("v_x", "velocity", q.index, 0), Input::before("v_z", "velocity", q.index, 2)};
    return Explanation{"v′ = v (1 − min(1, μ_g max(u′, 0) / |v_t|))",
                       {Input::before("v", "velocity", q.index, q.component), friction, taken,
                        part("|v_t| = √(v_x² + v_z²)", std::move(speeds))}};
}

}  // namespace pliant::fem
