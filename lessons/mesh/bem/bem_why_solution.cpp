// Why conditions, solution, and what is read off it have the numbers that they have.
#include "bem.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace pliant::bem {
namespace {

const char* axis_of(int k) { return k == 0 ? "x" : k == 1 ? "y" : "z"; }

// Two families that are multiplied, without terms that are nothing.
struct Products {
    std::vector<Input> inputs{};
    std::string sum{};  // " + Σ_s D_s t_s"; "" without any
    void add(const char* sign, const std::string& weights, const std::string& numbers,
             std::vector<std::pair<Input, Input>> terms) {
        std::erase_if(terms, [](const auto& term) { return term.first.from == Input::From::constant && term.first.value == 0; });
        if (terms.empty()) return;
        for (auto& [w, x] : terms) inputs.push_back(w.in(weights)), inputs.push_back(x.in(numbers));
        sum += fmt::format(" {} Σ_{} {} {}", sign, weights.back(), weights, numbers);
    }
};

}  // namespace

Explanation BemLesson::why_traction(const Question& q) const {
    const int c = q.component;
    const Real n = body_->slot_normals(c, q.index);
    const Input normal = Input::constant("n", n, "", "normal of the boundary there");
    Index element = 0;
    while (element + 1 < body_->element_count() && body_->slot_of(element + 1, 0) <= q.index) ++element;
    if (body_->on_inner(element)) return {fmt::format("t_{} = −p n", axis_of(c)), {pressure, normal}};
    if (pulled_edge(element) && c == 1) return {"t_y = S n", {remote_stress, normal}};
    if (is(Setting::outline) && body_->arc(element) == Index(loaded_side) - 1 && c < 2)
        return {c == 0 ? "t_x = q_x" : "t_y = q_y", {c == 0 ? load_x : load_y}};
    return fixed_value("t = 0: nothing pulls here, or the support does, which is not known yet");
}

Explanation BemLesson::why_right_side(const Question& q) const {
    const int dim = body_->dimension();
    if (q.component >= dim) return fixed_value("b = 0: in the plane");
    Products sums;
    std::vector<std::pair<Input, Input>> terms;
    const Index row = dim * q.index + q.component;
    for (Index s = 0; s < body_->slot_count(); ++s)
        for (int c = 0; c < dim; ++c)
            if (given_traction_(c, s) != 0)
                terms.emplace_back(entry_of(fmt::format("G{}_{}", axis_of(c), s), "G", row, dim * s + c),
                                   Input::now(fmt::format("t{}_{}", axis_of(c), s), "given_traction", s, c));
    sums.add("+", "G_s", "t_s", terms);
    if (!is(Setting::hole))
        return sums.sum.empty() ? fixed_value("b = 0: nothing pulls") : Explanation{"b = " + sums.sum.substr(3), sums.inputs};
    sums.inputs.push_back(part("u∞ = ε∞ x", {Input::constant("ε∞", exact_hole().remote_strain()(q.component, q.component), "",
                                                             "strain far away, by Hooke's law from S"),
                                             Input::constant("x", body_->nodes(q.component, q.index), "m", "of the node")}));
    return {"b = u∞" + sums.sum, sums.inputs};
}

Explanation BemLesson::why_unknown(const Question& q) const {
    const int dim = body_->dimension();
    if (q.component >= dim) return fixed_value("u = 0: in the plane");
    const bool asks_traction = q.field == "traction";
    std::vector<char> is_held(static_cast<std::size_t>(body_->slot_count()), 0),
        node_held(static_cast<std::size_t>(body_->node_count()), 0);
    for (Index k = 0; k < body_->element_count(); ++k)
        for (int a = 0; a < body_->nodes_per_element(); ++a)
            if (held(k))
                is_held[static_cast<std::size_t>(body_->slot_of(k, a))] = 1,
                                                                   node_held[static_cast<std::size_t>(body_->node_of(k, a))] = 1;
    const auto node_at = [&](Index slot) {
        return body_->with([&](const auto& bem, const auto&) { return bem.system().node_of_slot(slot); });
    };
    if (asks_traction && !is_held[static_cast<std::size_t>(q.index)])
        return {"t = t̄", {Input::now("t̄", "given_traction", q.index, q.component)}};
    const Index node = asks_traction ? node_at(q.index) : q.index;
    if (!asks_traction && node_held[static_cast<std::size_t>(node)]) return fixed_value("u = 0: held by the support");
    const Index row = dim * node + q.component;
    std::vector<std::pair<Input, Input>> moved, pulled;
    for (Index n = 0; n < body_->node_count(); ++n)
        for (int c = 0; c < dim; ++c)
            if (!node_held[static_cast<std::size_t>(n)] && dim * n + c != row)
                moved.emplace_back(entry_of(fmt::format("H{}_{}", axis_of(c), n), "H", row, dim * n + c),
                                   Input::now(fmt::format("u{}_{}", axis_of(c), n), "displacement", n, c));
    Real own = 0;  // of the unknown traction, in all elements of the node
    for (Index s = 0; s < body_->slot_count(); ++s)
        for (int c = 0; c < dim; ++c) {
            if (!is_held[static_cast<std::size_t>(s)]) continue;
            if (asks_traction && node_at(s) == node && c == q.component) {
                own += body_->with([&](const auto& bem, const auto&) { return bem.system().G()(row, dim * s + c); });
                continue;
            }
            pulled.emplace_back(entry_of(fmt::format("G{}_{}", axis_of(c), s), "G", row, dim * s + c),
                                Input::now(fmt::format("t{}_{}", axis_of(c), s), "traction", s, c));
        }
    const Real left = body_->with([&](const auto&, const auto& solution) {
        return solution.modes.cols() > 0 ? Real(solution.modes.row(row).dot(solution.unbalanced)) : Real{0};
    });
    Products sums;
    sums.add(asks_traction ? "+" : "−", "H_j", "u_j", moved);
    sums.add(asks_traction ? "−" : "+", "G_s", "t_s", pulled);
    sums.inputs.push_back(Input::now("b", "right_side", node, q.component));
    const std::string rest = left == 0 ? "" : asks_traction ? " + m" : " − m";
    if (left != 0)
        sums.inputs.push_back(Input::constant("m", left, "m", "what the rigid motions that were taken out leave in the row"));
    if (asks_traction) {
        sums.inputs.push_back(Input::constant("g", own, "m/Pa", "entries of G of the traction itself"));
        return {fmt::format("t = (−b{}{}) / g", sums.sum, rest), sums.inputs};
    }
    sums.inputs.push_back(entry_of("h", "H", row, row));
    return {fmt::format("u = (b{}{}) / h", sums.sum, rest), sums.inputs};
}

// It is linear in displacements and tractions of the element, and of its neighbours where displacements are constant.
Explanation BemLesson::why_boundary_stress(const Question& q) const {
    const int dim = body_->dimension(), i = q.component / 3, j = q.component % 3;
    if (i >= dim || j >= dim) return fixed_value("σ = 0: only stresses in the plane are shown");
    Products sums;
    body_->with([&](const auto& bem, const auto& solution) {
        auto unit = solution;
        unit.displacement.setZero(), unit.traction.setZero();
        const auto effect = [&](Real& number) {
            number = 1;
            Real stress = 0;
            if constexpr (std::remove_cvref_t<decltype(bem)>::dimension == 2)
                stress = bem.boundary_stress(unit, q.index, 0)(i, j);
            else
                stress = bem.boundary_stress(unit, q.index)(i, j);
            number = 0;
            return stress;
        };
        std::vector<Index> nodes;
        std::vector<std::pair<Input, Input>> pulled, moved;
        for (int a = 0; a < body_->nodes_per_element(); ++a) {
            nodes.push_back(body_->node_of(q.index, a));
            const Index s = body_->slot_of(q.index, a);
            for (int c = 0; c < dim; ++c)
                pulled.emplace_back(
                    Input::constant(fmt::format("A{}_{}", axis_of(c), s), effect(unit.traction(c, s)), "", "from the traction"),
                    Input::now(fmt::format("t{}_{}", axis_of(c), s), "traction", s, c));
        }
        if (body_->nodes_per_element() == 1) {
            const BoundaryElement& e = body_->curve().elements()[static_cast<std::size_t>(q.index)];
            nodes = {body_->node_of(e.before, 0), body_->node_of(e.after, 0)};
        }
        for (const Index n : nodes)
            for (int c = 0; c < dim; ++c)
                moved.emplace_back(Input::constant(fmt::format("B{}_{}", axis_of(c), n), effect(unit.displacement(c, n)), "Pa/m",
                                                   "from how the boundary stretches"),
                                   Input::now(fmt::format("u{}_{}", axis_of(c), n), "displacement", n, c));
        sums.add("+", "A_a", "t_a", pulled);
        sums.add("+", "B_b", "u_b", moved);
    });
    if (sums.sum.empty()) return fixed_value("σ = 0: nothing of it lies along the boundary");
    return {fmt::format("σ_{}{} = {}", axis_of(i), axis_of(j), sums.sum.substr(3)), sums.inputs};
}

Explanation BemLesson::why_inside(const Question& q) const {
    const int dim = body_->dimension();
    const bool stress = q.field == "inside_stress";
    const int i = stress ? q.component / 3 : q.component, j = stress ? q.component % 3 : 0;
    if (i >= dim || j >= dim) return fixed_value(stress ? "σ = 0: only stresses in the plane are shown" : "u = 0: in the plane");
    const Vec<3> X = body_->inside().particles[static_cast<std::size_t>(q.index)];
    if (!body_->contains(X)) return fixed_value(stress ? "σ = 0: outside the body" : "u = 0: outside the body");
    Products sums;
    body_->with([&](const auto& bem, const auto&) {
        constexpr int D = std::remove_cvref_t<decltype(bem)>::dimension;
        const auto all = bem.inside_sums(X.head<D>());
        const Index row = stress ? D + D * i + j : i;
        std::vector<std::pair<Input, Input>> pulled, moved;
        for (Index s = 0; s < body_->slot_count(); ++s)
            for (int c = 0; c < D; ++c)
                if (traction_(c, s) != 0)
                    pulled.emplace_back(Input::constant(fmt::format("D{}_{}", axis_of(c), s), all.of_traction(row, D * s + c),
                                                        stress ? "" : "m/Pa", "integral over the element"),
                                        Input::now(fmt::format("t{}_{}", axis_of(c), s), "traction", s, c));
        for (Index n = 0; n < body_->node_count(); ++n)
            for (int c = 0; c < D; ++c)
                moved.emplace_back(Input::constant(fmt::format("B{}_{}", axis_of(c), n), all.of_displacement(row, D * n + c),
                                                   stress ? "Pa/m" : "", "integral over the elements of the node"),
                                   Input::now(fmt::format("u{}_{}", axis_of(c), n), "displacement", n, c));
        sums.add("+", "D_s", "t_s", pulled);
        sums.add("+", "B_n", "u_n", moved);
    });
    const std::string name = stress ? fmt::format("σ_{}{}", axis_of(i), axis_of(j)) : fmt::format("u_{}", axis_of(i));
    if (is(Setting::hole) && i == j && stress && exact_hole().remote_stress()(i, i) != 0) {
        sums.inputs.push_back(Input::of(remote_stress, "S"));
        return {fmt::format("{} = S{}", name, sums.sum), sums.inputs};
    }
    if (is(Setting::hole) && !stress) {
        sums.inputs.push_back(part(
            "u∞ = ε∞ x", {Input::constant("ε∞", exact_hole().remote_strain()(i, i), "", "strain far away, by Hooke's law from S"),
                          Input::constant("x", X[i], "m", "of the point")}));
        return {fmt::format("{} = u∞{}", name, sums.sum), sums.inputs};
    }
    if (sums.sum.empty()) return fixed_value(name + " = 0: the boundary does nothing here");
    return {fmt::format("{} = {}", name, sums.sum.substr(3)), sums.inputs};
}

// Along the lines that the two finest meshes make on logarithmic axes.
std::optional<Explanation> BemLesson::why_effort(const Question& q) const {
    if (!comparison_) return fixed_value("n_fem = 0: nothing to compare");
    const Effort &coarse = comparison_->finite[1], &fine = comparison_->finite[2];
    const auto of = [&](Real Effort::*which) {
        const Real slope = std::log(fine.*which / coarse.*which) / std::log(fine.unknowns / coarse.unknowns);
        return Explanation{"n_fem = n (e_fem / e)^(k / q)",
                           {Input::constant("n", fine.*which, "", "of the finest mesh that was computed"),
                            Input::constant("e_fem", fine.error, "", "its error"),
                            Input::constant("e", comparison_->own.error, "", "error of the boundary elements"),
                            Input::constant("k", slope, "", "power of the unknowns by which it grows"),
                            Input::constant("q", comparison_->order, "", "power of the unknowns by which the error falls")}};
    };
    if (q.field == "finite_element_unknowns") return of(&Effort::unknowns);
    return of(q.field == "finite_element_entries" ? &Effort::entries : &Effort::operations);
}

}  // namespace pliant::bem
