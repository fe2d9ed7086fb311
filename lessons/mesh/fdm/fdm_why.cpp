// Why strain, stress, forces and motion are what they are: sample by sample, a row of the difference formula at a time.
#include "fdm.h"
#include "kits/linear_body/linear_body_why.h"
#include "kits/schemes/scheme_why.h"

#include <fmt/format.h>

#include <array>

namespace pliant::fdm {
namespace {

std::string entry_name(std::string_view name, int row, int column) {
    return fmt::format("{}_{}{}", name, axis_name(row), axis_name(column));
}

// An entry of a tensor of the samples as it is now.
Input tensor_entry(std::string_view name, std::string_view field, Index sample, int row, int column) {
    return Input::now(entry_name(name, row, column), field, sample, 2 * row + column);
}

// F_ij = δ_ij + H_ij.
Input stretched_entry(Index sample, int row, int column) {
    const std::string F = entry_name("F", row, column), H = entry_name("H", row, column);
    return part(fmt::format("{} = {}{}", F, row == column ? "1 + " : "", H),
                {tensor_entry("H", "gradient", sample, row, column)});
}

Input coordinate(const char* symbol, Real value, const char* meaning) { return Input::constant(symbol, value, "m", meaning); }

}  // namespace

// ------------------------------------------------------------------------------------------------------------- samples

Explanation FdmLesson::why_sample(const Question& q) const {
    const int i = q.component / 2, j = q.component % 2;
    const Index s = q.index;
    if (q.field == "gradient") {
        const Index here = grid().node_of(s), there = grid().neighbour_of(s, j);
        const bool onwards = grid().step_of(s, j) > 0;
        return {fmt::format("{} = (u_j − u_i) / Δx", entry_name("H", i, j)),
                {Input::now("u_j", "displacement", onwards ? there : here, i),
                 Input::now("u_i", "displacement", onwards ? here : there, i), why_spacing()}};
    }
    if (q.field == "metric") {
        const auto F = [](int row, int column) { return entry_name("F", row, column); };
        if (i == j)
            return {fmt::format("{} = {}² + {}²", entry_name("G", i, i), F(0, i), F(1, i)),
                    {stretched_entry(s, 0, i), stretched_entry(s, 1, i)}};
        return {fmt::format("{} = {} {} + {} {}", entry_name("G", i, j), F(0, i), F(0, j), F(1, i), F(1, j)),
                {stretched_entry(s, 0, i), stretched_entry(s, 0, j), stretched_entry(s, 1, i), stretched_entry(s, 1, j)}};
    }
    if (linear()) {
        if (i == j)
            return {fmt::format("{} = {}", entry_name("ε", i, i), entry_name("H", i, i)),
                    {tensor_entry("H", "gradient", s, i, i)}};
        return {fmt::format("{} = ½ ({} + {})", entry_name("ε", i, j), entry_name("H", i, j), entry_name("H", j, i)),
                {tensor_entry("H", "gradient", s, i, j), tensor_entry("H", "gradient", s, j, i)}};
    }
    const std::string G = entry_name("G", i, j);
    return {fmt::format("{} = ½ {}", entry_name("E", i, j), i == j ? fmt::format("({} − 1)", G) : G),
            {tensor_entry("G", "metric", s, i, j)}};
}

Explanation FdmLesson::why_stress(const Question& q) const {
    const int row = q.component / 2, column = q.component % 2;
    const Index s = q.index;
    const char* strain = linear() ? "ε" : "E";
    // Hooke's law: the stress itself when linear, before F turns it otherwise.
    const auto hooke = [&](int i, int j) -> Explanation {
        const std::string left = entry_name(linear() ? "P" : "S", i, j), own = entry_name(strain, i, j);
        if (is(GridShape::rod)) {
            if (i + j > 0) return fixed_value(fmt::format("{} = 0: a rod has a stress along it alone", left));
            return {fmt::format("{} = Y {}", left, own), {youngs_modulus, tensor_entry(strain, "strain", s, 0, 0)}};
        }
        if (i != j) return {fmt::format("{} = 2 μ {}", left, own), {why_mu(), tensor_entry(strain, "strain", s, i, j)}};
        return {fmt::format("{0} = 2 μ {1} + λ ({2}_xx + {2}_yy)", left, own, strain),
                {why_mu(), why_lambda(), tensor_entry(strain, "strain", s, 0, 0), tensor_entry(strain, "strain", s, 1, 1)}};
    };
    if (linear()) return hooke(row, column);
    if (is(GridShape::rod) && column == 1)
        return fixed_value(fmt::format("{} = 0: a rod has a stress along it alone", entry_name("P", row, column)));
    Explanation e{fmt::format("{} = ", entry_name("P", row, column)), {}};
    for (int k = 0; k < (is(GridShape::rod) ? 1 : 2); ++k) {
        e.formula += fmt::format("{}{} {}", k == 0 ? "" : " + ", entry_name("F", row, k), entry_name("S", k, column));
        e.inputs.push_back(stretched_entry(s, row, k));
        e.inputs.push_back(Input::part(entry_name("S", k, column), "Pa", hooke(k, column)));
    }
    return e;
}

// --------------------------------------------------------------------------------------------------------------- forces

// Of the samples at the node and those beside it along the axis, each as far as it pulls.
Explanation FdmLesson::why_divergence(const Question& q) const {
    const int axis = static_cast<int>(divergence_passes_) - 1;
    const char* c = axis_name(q.component);
    std::vector<Input> inputs;
    Index corners = 0;
    for (Index s = 0; s < grid().sample_count(); ++s) corners += grid().node_of(s) == q.index;
    for (Index s = 0; s < grid().sample_count(); ++s) {
        const bool here = grid().node_of(s) == q.index, beside = grid().neighbour_of(s, axis) == q.index;
        if (!here && !beside) continue;
        const Real sign = (grid().step_of(s, axis) > 0) == here ? 1 : -1;
        inputs.push_back(Input::constant(fmt::format("s_{}", s), sign, "", "on which side of the node").in("s_q"));
        inputs.push_back(Input::now(fmt::format("P_{}", s), "stress", s, 2 * q.component + axis).in("P_q"));
    }
    Explanation e{fmt::format("f_{0} = {1}(Σ_q s_q P_q) / (m Δx), P_{0}{2} of the quarters around", c, axis == 0 ? "" : "f + ",
                              axis_name(axis)),
                  std::move(inputs)};
    e.inputs.push_back(Input::constant("m", static_cast<Real>(corners), "", "quarters of cells that the node stands for"));
    e.inputs.push_back(why_spacing());
    if (axis > 0) e.inputs.push_back(Input::earlier("f", "force_density", q.index, q.component));
    return e;
}

Explanation FdmLesson::why_stencil(const Question& q) const {
    const int c = q.component;
    const Index k = q.index;
    if (!problem_->has_stencil(k) || (is(GridShape::rod) && c == 1))
        return {"fˢ = f, where neighbours are missing or held", {Input::now("f", "force_density", k, c)}};
    const auto [i, j] = grid().place_of(k);
    const auto at = [&, i = i, j = j](const char* symbol, int right, int up, int of) {
        return Input::now(symbol, "displacement", grid().node_at({i + right, j + up}), of);
    };
    const Index pass = stencil_passes_ - 1;
    const std::string left = fmt::format("fˢ_{}", axis_name(c));
    if (pass < 2) {
        const int right = pass == 0 ? 1 : 0, up = 1 - right;
        const bool along = c == pass;
        const char* stiff = is(GridShape::rod) ? "Y" : along ? "(λ + 2 μ)" : "μ";
        Explanation e{fmt::format("{} = {}{} (u_j − 2 u_i + u_k) / Δx²", left, pass == 0 ? "" : "f + ", stiff),
                      {at("u_j", right, up, c), at("u_i", 0, 0, c), at("u_k", -right, -up, c), why_spacing()}};
        if (is(GridShape::rod)) {
            e.inputs.push_back(youngs_modulus);
        } else {
            e.inputs.push_back(why_mu());
            if (along) e.inputs.push_back(why_lambda());
        }
        if (pass > 0) e.inputs.push_back(Input::earlier("f", "stencil_force", k, c));
        return e;
    }
    const int other = 1 - c;
    return {fmt::format("{} = f + (λ + μ) (u_pp − u_pm − u_mp + u_mm) / (4 Δx²), of the four nodes across the corners", left),
            {Input::earlier("f", "stencil_force", k, c), why_lambda(), why_mu(), at("u_pp", 1, 1, other),
             at("u_pm", 1, -1, other), at("u_mp", -1, 1, other), at("u_mm", -1, -1, other), why_spacing()}};
}

Explanation FdmLesson::why_load(const Question& q) const {
    const Vec<2> X = grid().positions().col(q.index);
    const char* c = axis_name(q.component);
    if (is(GridShape::block)) {
        if (q.component == 0) return fixed_value("b_x = 0: the weight acts along y");
        return {"b_y = − b₀", {body_force}};
    }
    if (is(GridShape::disc))
        return {fmt::format("b_{} = b₀ X / L, outwards", c),
                {body_force, coordinate("X", X[q.component], "place from the centre"), length}};
    return Explanation{fmt::format("b_{} = pull(x, y, L, A, λ, μ), −∇·P of the known field", c),
                       {coordinate("x", X.x(), "place at rest"), coordinate("y", X.y(), "place at rest"), length, amplitude,
                        why_lambda(), why_mu()}}
        .by("pull", "N/m³", [component = q.component, energy = body().energy](Values v) {
            return SinesInSquare{v[2], v[3]}.force_density({v[0], v[1]}, {energy, Lame{.lambda = v[4], .mu = v[5]}})[component];
        });
}

// --------------------------------------------------------------------------------------------------------------- motion

std::optional<Explanation> FdmLesson::why_motion(const Question& q) const {
    const Index dof = 2 * q.index + q.component;
    if (q.field == "acceleration") {
        if (inertia_.fixed(dof)) return fixed_value("a = 0: held by the support");
        Explanation e{"a = r / ρ", {Input::now("r", "unbalanced", q.index, q.component), density}};
        if (damped()) {
            e.formula += " − α v";
            e.inputs.push_back(damping);
            e.inputs.push_back(Input::now("v", "velocity", q.index, q.component));
        }
        if (pulled() && hand_.node == q.index) {
            e.formula += " + kₕ (h − u) / m";
            e.inputs.push_back(pull_stiffness);
            e.inputs.push_back(Input::constant("h", hand_.target[q.component], "m", "where the hand draws the node to"));
            e.inputs.push_back(Input::now("u", "displacement", q.index, q.component));
            e.inputs.push_back(Input::constant("m", inertia_.mass()[dof], "kg/m", "mass of the node, for 1 m of depth"));
        }
        return e;
    }
    const bool of_velocity = q.field == "velocity";
    const Input before = Input::before(of_velocity ? "v" : "u", q.field, q.index, q.component);
    if (inertia_.fixed(dof))
        return Explanation{of_velocity ? "v′ = v: held by the support" : "u′ = u: held by the support", {before}};
    return stepping::table_row(of_velocity ? "v′" : "u′", *integrator_, of_velocity, dof, before,
                               Input::before("v", "velocity", q.index, q.component), dt,
                               Input::now("a_1", "acceleration", q.index, q.component));
}

// A row of Newton's equations, by the tangent where its latest iteration began.
std::optional<Explanation> FdmLesson::why_solved(const Question& q) const {
    const bool held = problem_->supports().prescribed(q.index, q.component);
    if (q.field == "displacement") {
        if (held) return fixed_value("u = 0: held by the support");
        const Input before = Input::earlier("u", "displacement", q.index, q.component);
        if (solved()) return Explanation{"u′ = u: all forces balance", {before}};
        return Explanation{
            "u′ = u + s d",
            {before, Input::constant("s", newton_->step_length(), "", "share of the step that the line search takes"),
             Input::now("d", "newton_step", q.index, q.component)}};
    }
    if (held) return fixed_value("d = 0: held by the support");
    if (solved()) return Explanation{"d′ = d: nothing is left to do", {Input::earlier("d", "newton_step", q.index, q.component)}};
    const SparseMatrix& K = tangent_.of(static_cast<Index>(clock_[iterations]), [this] {
        SparseMatrix matrix = grid().pattern();
        grid().stiffness(before_newton_, !newton_->tangent_was_definite(), matrix);
        return matrix;
    });
    const Input force =
        part("f_a = V r", {Input::constant("V", grid().volumes()[q.index], "m³", "that the node stands for, 1 m deep"),
                           Input::now("r", "unbalanced", q.index, q.component)});
    return linear_body::why_unknown<2>({.matrix = &K,
                                        .row = 2 * q.index + q.component,
                                        .unknown = "d",
                                        .field = "newton_step",
                                        .added_to_diagonal = newton_->diagonal_shift()},
                                       {force});
}

std::optional<Explanation> FdmLesson::why(const Question& q) const {
    const bool held =
        q.field == "unbalanced" || q.field == "reaction" ? problem_->supports().prescribed(q.index, q.component) : false;
    if (q.field == "gradient" || q.field == "metric" || q.field == "strain") return why_sample(q);
    if (q.field == "stress") return why_stress(q);
    if (q.field == "force_density") return why_divergence(q);
    if (q.field == "stencil_force") return why_stencil(q);
    if (q.field == "load") return why_load(q);
    const Input f = Input::now("f", "force_density", q.index, q.component);
    std::vector<Input> forces{f};
    if (loaded()) forces.push_back(Input::now("b", "load", q.index, q.component));
    const char* sum = loaded() ? "f + b" : "f";
    if (q.field == "reaction") {
        if (!held) return fixed_value("R = 0: nothing holds the node");
        forces.push_back(Input::constant("V", grid().volumes()[q.index], "m²", "area that the node stands for"));
        return Explanation{fmt::format("R = − V ({})", sum), std::move(forces)};
    }
    if (q.field == "unbalanced") {
        if (held && unbalanced_(q.component, q.index) == 0) return fixed_value("r = 0: the support takes it");
        return Explanation{fmt::format("r = {}", sum), std::move(forces)};
    }
    return moves() ? why_motion(q) : why_solved(q);
}

}  // namespace pliant::fdm
