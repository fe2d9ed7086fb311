// Why elements and nodes have the numbers that they have.
#include "fem.h"

#include "kits/linear_body/linear_body_why.h"

#include <pliant/solids/manufactured_solution.h>

#include <fmt/format.h>

namespace pliant::fem {

std::optional<Explanation> FemLesson::why_element(const Question& q) const {
    const solid_mesh::SolidWhy w = why();
    const int i = w.row(q.component), j = w.column(q.component);
    if (q.field == "rest_volume") return w.volume(q.index);
    if (q.field == "deformation_gradient") return w.deformation(q.index, i, j);
    if (q.field == "rotation") return w.rotation(q.index, i, j);
    if (q.field == "strain") return w.strain(q.index, i, j);
    if (q.field == "stress") return w.stress(q.index, i, j);
    return w.von_mises(q.index);
}

std::optional<Explanation> FemLesson::why_node(const Question& q) const {
    const solid_mesh::SolidWhy w = why();
    if (q.field == "internal_force") return w.internal_force(q.index, q.component);
    if (q.field == "element_stiffness") {
        if (q.index >= next_element_) return std::nullopt;
        return w.stiffness(q.index, 0, w.row(q.component), w.column(q.component));
    }
    if (q.field == "assembled") return why_assembled(q.index, q.component);
    if (q.field == "load") return why_load(q.index, q.component);
    if (q.field == "prescribed") return why_prescribed(q.index, q.component);
    const Input f = Input::now("f", "load", q.index, q.component),
                inner = Input::now("fⁱ", "internal_force", q.index, q.component);
    if (q.field == "residual") {
        if (solid_->held(q.index)) return fixed_value("r = 0: the support takes what is left");
        return Explanation{"r = f − fⁱ", {f, inner}};
    }
    if (!solid_->held(q.index)) return fixed_value("fʳ = 0: no support here");
    return Explanation{"fʳ = fⁱ − f", {f, inner}};
}

Explanation FemLesson::why_assembled(Index node, int component) const {
    std::vector<Input> terms;
    const int d = solid_->dim();
    for (const auto& [element, a] : solid_->elements_about(node)) {
        if (element >= next_element_) continue;
        const std::string symbol = fmt::format("K_{}", element);
        terms.push_back(a == 0 ? Input::now(symbol, "element_stiffness", element, d * component + component)
                               : Input::part(symbol, "N/m", why().stiffness(element, a, component, component)));
    }
    if (terms.empty()) return fixed_value("K_aa = 0: none of its elements is assembled yet");
    return sum_of("K_aa = Σ K_e", "K_e", std::move(terms));
}

Input FemLesson::share_so_far() const {
    return part("s = k / m", {Input::constant("k", level_, "", "load steps that are on"), Input::of(load_steps, "m")});
}

Explanation FemLesson::why_load(Index node, int component) const {
    if (is(Setting::manufactured)) {
        const auto integral = [&](const char* symbol, Solid::PlaneFunction part_of_force) {
            return Input::constant(symbol, solid_->plane_load(part_of_force)(component, node), "m²",
                                   "integral with the shape function");
        };
        return {
            "f = λ c + μ d",
            {why().lambda(), why().mu(), integral("c", manufactured::force_of_lambda), integral("d", manufactured::force_of_mu)}};
    }
    const bool pulled = bent() && solved_pull_ && solved_pull_->index == node;
    const Real area = bent() ? solid_->loaded_area()[node] : 0;
    if (area == 0 && !pulled) return fixed_value("f = 0: not on the loaded face");
    const std::array<const Number*, 3> forces{&body.load_x, &body.load_y, &body.load_z};
    std::vector<Input> inputs{share_so_far()};
    if (area != 0) {
        inputs.push_back(Input::of(*forces[static_cast<std::size_t>(component)], "F"));
        inputs.push_back(Input::constant("A_a", area, "m²", "the node's share of the loaded face"));
        inputs.push_back(Input::constant("A", solid_->loaded_area().sum(), "m²", "area of the loaded face"));
    }
    if (pulled) {
        inputs.push_back(Input::of(pull_stiffness, "kₕ"));
        inputs.push_back(
            Input::constant("h", (solved_pull_->to - solved_pull_->from)[component], "m", "by which the hand has drawn it"));
    }
    return {area == 0 ? "f = s kₕ h" : pulled ? "f = s (F A_a / A + kₕ h)" : "f = s F A_a / A", std::move(inputs)};
}

// The part of the turning that is on, of the arm of the node about the axis of the beam.
Explanation FemLesson::why_prescribed(Index node, int component) const {
    if (!solid_->held(node)) return fixed_value("ū = 0: the node is free");
    const bool of_loaded_face = solid_->rest()(0, node) > 0;
    if (!is(Setting::twist) || of_loaded_face != (turned == Turned::end)) return fixed_value("ū = 0: held where it is at rest");
    if (component == 0) return fixed_value("ū = 0: turned about the x axis");
    const Vec<3> arm = solid_->rest(node) - Vec<3>(0, body.height / 2, body.width / 2);
    std::vector<Input> inputs{part("φ = s φ₀ π / 180°", {share_so_far(), Input::of(twist_angle, "φ₀")}),
                              Input::constant("Y", arm[1], "m", "of the node from the axis"),
                              Input::constant("Z", arm[2], "m", "of the node from the axis")};
    return {component == 1 ? "ū = Y (cos(φ) − 1) − Z sin(φ)" : "ū = Y sin(φ) + Z (cos(φ) − 1)", std::move(inputs)};
}

std::optional<Explanation> FemLesson::why_solved(const Question& q) const {
    if (!advancing_) return std::nullopt;
    if (q.field == "newton_step")
        return solid_->dim() == 2 ? why_direction<2>(q.index, q.component) : why_direction<3>(q.index, q.component);
    return Explanation{"u′ = u + α d",
                       {Input::before("u", "displacement", q.index, q.component),
                        Input::constant("α", solid_->step_length(), "", "share of the step that the line search takes"),
                        Input::now("d", "newton_step", q.index, q.component)}};
}

template <int Dim>
Explanation FemLesson::why_direction(Index node, int component) const {
    if (solid_->held(node))
        return {"d = ū − u",
                {Input::now("ū", "prescribed", node, component), Input::before("u", "displacement", node, component)}};
    const SparseMatrix K = solid_->stiffness(before_, !solid_->tangent_was_definite());
    return linear_body::why_unknown<Dim>({.matrix = &K,
                                          .row = Dim * node + component,
                                          .unknown = "d",
                                          .field = "newton_step",
                                          .first_row = 0,
                                          .added_to_diagonal = solid_->diagonal_shift()},
                                         {Input::now("r_a", "residual", node, component)});
}

void FemLesson::explain_probes() {
    const auto mean = [this](int component) {
        return [this, component] {
            std::vector<Input> of_nodes;
            for (const Index n : solid_->loaded_nodes())
                of_nodes.push_back(Input::now(fmt::format("u_{}", n), "displacement", n, component));
            return Explanation{"ū = mean_n u_n, over the nodes of the loaded face", family_of("u_n", std::move(of_nodes))};
        };
    };
    explain_probe("tip_x", mean(0)), explain_probe("tip_y", mean(1)), explain_probe("tip_z", mean(2));
    explain_probe("largest_stress", [this] {
        Index e = 0;
        mises_.maxCoeff(&e);
        return Explanation{"σ_max = σ, of the element that is sheared hardest", {Input::now("σ", "von_mises", e)}};
    });
}

}  // namespace pliant::fem
