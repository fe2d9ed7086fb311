// Why elements, faces and nodes have the numbers that they have.
#include "fvm.h"

#include "kits/schemes/scheme_why.h"
#include "kits/tensors/tensor_why.h"

#include <fmt/format.h>
#include <Eigen/LU>

#include <array>
#include <cmath>

namespace pliant::fvm {
namespace {

// b − a as a part.
Input step_between(const std::string& symbol, Input to, Input from) {
    const std::string formula = fmt::format("{} = {} − {}", symbol, to.symbol, from.symbol);
    return Input::part(symbol, "m", {formula, {std::move(to), std::move(from)}});
}

// Σ_j T_ij n_j, of a tensor of the element and a vector of its face.
Explanation tensor_times(const std::string& left, const FvmLesson& l, Index face, int i, std::string_view T,
                         std::string_view tensors, std::string_view n, std::string_view vectors) {
    Explanation e;
    std::string sum;
    const int d = l.solid_->dim();
    for (int j = 0; j < d; ++j) {
        const std::string row = fmt::format("{}_{}", n, axis_name(j));
        sum += fmt::format("{}{} {}", j ? " + " : "", why::entry(T, i, j), row);
        e.inputs.push_back(Input::now(why::entry(T, i, j), tensors, face / l.corners(), d * i + j));
        e.inputs.push_back(Input::now(row, vectors, face, j));
    }
    e.formula = fmt::format("{} = {}", left, sum);
    return e;
}

}  // namespace

std::optional<Explanation> FvmLesson::why_element(const Question& q) const {
    const solid_mesh::SolidWhy w = why();
    const int i = w.row(q.component), j = w.column(q.component);
    if (q.field == "deformation_gradient") return w.deformation(q.index, i, j);
    if (q.field == "rotation") return w.rotation(q.index, i, j);
    if (q.field == "strain") return w.strain(q.index, i, j);
    if (q.field == "stress") return w.stress(q.index, i, j);
    if (q.field == "cauchy_stress") return why_cauchy(q.index, i, j);
    return why_deformed_area(q.index, q.component);
}

Explanation FvmLesson::why_cauchy(Index element, int i, int j) const {
    if (cauchy_.col(element).isZero(0) && !stress_.col(element).isZero(0)) return fixed_value("σ = 0: the element has no volume");
    const int d = solid_->dim();
    std::vector<Input> entries;
    for (int r = 0; r < d; ++r)
        for (int c = 0; c < d; ++c) entries.push_back(why().entry_now("F", "deformation_gradient", element, r, c));
    Explanation e;
    std::string sum;
    for (int k = 0; k < d; ++k) {
        sum += fmt::format("{}{} {}", k ? " + " : "", why::entry("P", i, k), why::entry("F", j, k));
        e.inputs.push_back(why().entry_now("P", "stress", element, i, k));
        e.inputs.push_back(why().entry_now("F", "deformation_gradient", element, j, k));
    }
    e.inputs.push_back(Input::part(
        "J", "",
        d == 2 ? Explanation{"J = F_11 F_22 − F_12 F_21", std::move(entries)} : why::determinant("J", std::move(entries))));
    e.formula = fmt::format("{} = ({}) / J", why::entry("σ", i, j), sum);
    return e;
}

// From the places of its corners: an edge turned by a quarter, or half the product of two edges.
Explanation FvmLesson::why_rest_area(Index face, int component) const {
    const std::vector<Index> nodes = face_nodes(face / corners(), static_cast<int>(face % corners()));
    const auto edge = [&](const std::string& name, std::size_t to, int axis) {
        return step_between(fmt::format("{}_{}", name, axis_name(axis)), why().place_at_rest(nodes[to], axis),
                            why().place_at_rest(nodes[0], axis));
    };
    if (solid_->dim() == 2) {
        const Input thickness = Input::constant("b", 1, "m", "thickness of a body in the plane");
        if (component == 0) return {"N_x = b D_y, D along the edge", {thickness, edge("D", 1, 1)}};
        return {"N_y = − b D_x, D along the edge", {thickness, edge("D", 1, 0)}};
    }
    const int j = (component + 1) % 3, k = (component + 2) % 3;
    return {fmt::format("N_{0} = ½ (D_{1} E_{2} − D_{2} E_{1}), D and E along two edges", axis_name(component), axis_name(j),
                        axis_name(k)),
            {edge("D", 1, j), edge("E", 2, k), edge("D", 1, k), edge("E", 2, j)}};
}

// The matrix of cofactors of F times N.
Explanation FvmLesson::why_deformed_area(Index face, int component) const {
    const Index element = face / corners();
    const auto F = [&](int i, int j) { return why().entry_now("F", "deformation_gradient", element, i, j); };
    const auto N = [&](int j) { return Input::now(fmt::format("N_{}", axis_name(j)), "rest_area", face, j); };
    if (solid_->dim() == 2) {
        if (component == 0) return {"a_x = F_22 N_x − F_21 N_y, J F⁻ᵀ N", {F(1, 1), N(0), F(1, 0), N(1)}};
        return {"a_y = F_11 N_y − F_12 N_x, J F⁻ᵀ N", {F(0, 0), N(1), F(0, 1), N(0)}};
    }
    Explanation e;
    std::string sum;
    for (int c = 0; c < 3; ++c) {
        const int i = (component + 1) % 3, k = (component + 2) % 3, p = (c + 1) % 3, r = (c + 2) % 3;
        const std::string name = why::entry("C", component, c);
        e.inputs.push_back(part(fmt::format("{} = {} {} − {} {}", name, why::entry("F", i, p), why::entry("F", k, r),
                                            why::entry("F", i, r), why::entry("F", k, p)),
                                {F(i, p), F(k, r), F(i, r), F(k, p)}));
        e.inputs.push_back(N(c));
        sum += fmt::format("{}{} N_{}", c ? " + " : "", name, axis_name(c));
    }
    e.formula = fmt::format("a_{} = {}, with the cofactors C of F", axis_name(component), sum);
    return e;
}

std::optional<Explanation> FvmLesson::why_face(const Question& q) const {
    if (q.field == "rest_volume") return why().volume(q.index);
    if (q.field == "rest_area") return why_rest_area(q.index, q.component);
    if (q.index / corners() >= next_element_) return fixed_value("f = 0: the loop has not come to this element yet");
    if (q.field == "face_force")
        return tensor_times(fmt::format("f_{}", axis_name(q.component)), *this, q.index, q.component, "P", "stress", "N",
                            "rest_area");
    return tensor_times(fmt::format("f_{}", axis_name(q.component)), *this, q.index, q.component, "σ", "cauchy_stress", "a",
                        "deformed_area");
}

std::optional<Explanation> FvmLesson::why_shared(const Question& q) const {
    if (q.field == "finite_element_force")
        return Explanation{"f_FEM = − g", {Input::part("g", "N", why().internal_force(q.index, q.component))}};
    std::vector<Input> faces;
    for (const auto& [element, a] : solid_->elements_about(q.index)) {
        if (element >= next_element_) continue;
        for (int k = 0; k < corners(); ++k)
            if (k != a)
                faces.push_back(Input::now(fmt::format("f_{}", face(element, k)), "face_force", face(element, k), q.component));
    }
    if (faces.empty()) return fixed_value("f = 0: the loop has not come to its elements yet");
    faces = family_of("f_A", std::move(faces));
    faces.push_back(Input::constant("s", Real{1} / solid_->dim(), "", "share of each node of a face"));
    return Explanation{"f = − s Σ f_A, over the faces that meet in the node", std::move(faces)};
}

// ---------------------------------------------------------------------------------------------------------- what acts outside

Input FvmLesson::node_mass(Index node) const {
    std::vector<Input> volumes;
    for (const auto& [element, a] : solid_->elements_about(node))
        volumes.push_back(Input::now(fmt::format("V_{}", element), "rest_volume", element));
    volumes = family_of("V_e", std::move(volumes));
    volumes.push_back(density);
    volumes.push_back(Input::constant("s", Real{1} / corners(), "", "share of each corner of an element"));
    return part("m = ρ s Σ V_e", std::move(volumes));
}

Explanation FvmLesson::why_load(Index node, int component) const {
    std::vector<Input> inputs;
    std::string sum;
    const auto add = [&](const std::string& term, std::vector<Input> of_term) {
        sum += sum.empty() ? term : " + " + term;
        for (Input& input : of_term) inputs.push_back(std::move(input));
    };
    const Real area = held() ? solid_->loaded_area()[node] : 0;
    const std::array<const Number*, 3> forces{&body.load_x, &body.load_y, &body.load_z};
    if (area > 0)
        add("F A_a / A", {Input::of(*forces[static_cast<std::size_t>(component)], "F"),
                          Input::constant("A_a", area, "m²", "the node's share of the loaded face"),
                          Input::constant("A", solid_->loaded_area().sum(), "m²", "area of the loaded face")});
    if (component == 1 && weight_acceleration() > 0) add("m (− g)", {node_mass(node), gravity});
    if (pulled() && pull_->index == node)
        add("kₕ (h − x)", {pull_stiffness, Input::constant("h", pull_->to[component], "m", "where the hand pulls to"),
                           Input::now("x", "position", node, component)});
    if (sum.empty()) return fixed_value("fᵉ = 0: nothing acts here along this axis");
    return {"fᵉ = " + sum, std::move(inputs)};
}

std::optional<Explanation> FvmLesson::why_outer(const Question& q) const {
    if (q.field == "external_force") return why_load(q.index, q.component);
    return Explanation{"fᵈ = − α m v", {damping, node_mass(q.index), Input::now("v", "velocity", q.index, q.component)}};
}

// ------------------------------------------------------------------------------------------------------------- integration

// Of the start of the step.
std::vector<Input> FvmLesson::forces_on(Index node, int component) const {
    std::vector<Input> forces{Input::now("f", "force", node, component)};
    if (loaded()) forces.push_back(Input::now("fᵉ", "external_force", node, component));
    if (damped()) forces.push_back(Input::now("fᵈ", "damping_force", node, component));
    return forces;
}

// Of the end of the step, and what Newton's method has left unbalanced.
std::vector<Input> FvmLesson::balanced_forces_on(Index node, int component) const {
    std::vector<Input> forces{
        Input::part("f(x′)", "N", {"f(x′) = − g", {Input::part("g", "N", why().force_of_patch(node, component))}})};
    if (loaded()) forces.push_back(Input::part("fᵉ(x′)", "N", why_load(node, component)));
    if (damped())
        forces.push_back(Input::part(
            "fᵈ(v′)", "N", {"fᵈ(v′) = − α m v′", {damping, node_mass(node), Input::now("v′", "velocity", node, component)}}));
    VecX left;
    motion_->integrator().solver().imbalance(left);
    forces.push_back(stepping::imbalance_left(left[solid_->dim() * node + component]));
    return forces;
}

// Where Newton's method started in this step.
Input FvmLesson::newton_start(Index node, int component) const {
    const Input x = Input::before("x", "position", node, component), v = Input::before("v", "velocity", node, component);
    if (!motion_->integrator().solver().began_at_prediction()) return part("x_k = x", {x});
    return part("x_k = x + Δt v", {x, dt, v});
}

std::optional<Explanation> FvmLesson::why_integrated(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    const Index dof = solid_->dim() * q.index + q.component;
    const Input x = Input::before("x", "position", q.index, q.component),
                v = Input::before("v", "velocity", q.index, q.component);
    if (motion_->mass().fixed(dof)) {
        if (of_velocity) return fixed_value("v′ = 0: the support holds the node");
        return Explanation{"x′ = x: the support holds the node", {x}};
    }
    if (!implicit())
        return of_velocity ? stepping::pushed(v, dt, node_mass(q.index), forces_on(q.index, q.component))
                           : stepping::drifted(dt, q.index, q.component, Scheme(scheme) == Scheme::semi_implicit_euler);
    const ImplicitSolver& solver = motion_->integrator().solver();
    if (solver.converged())
        return of_velocity ? stepping::pushed(v, dt, node_mass(q.index), balanced_forces_on(q.index, q.component))
                           : stepping::drifted(dt, q.index, q.component, true);
    if (of_velocity) return Explanation{"v′ = (x′ − x) / Δt", {Input::now("x′", "position", q.index, q.component), x, dt}};
    const Input iterate =
        solver.iterations() == 1 ? newton_start(q.index, q.component) : Input::earlier("x_k", "position", q.index, q.component);
    return stepping::newton_iterate("x′", "x", solver, dof, iterate, stepping::newton_direction(solver, dof, solid_->dim()),
                                    std::nullopt);
}

// ------------------------------------------------------------------------------------------------------------------ probes

namespace {

// All numbers of a nodal field as one family.
void add_all(std::vector<Input>& inputs, const std::string& family, std::string_view field, const MatX& numbers) {
    for (Index n = 0; n < numbers.cols(); ++n)
        for (int c = 0; c < static_cast<int>(numbers.rows()); ++c)
            inputs.push_back(Input::now(fmt::format("{}{}_{}", family.substr(0, 1), axis_name(c), n), field, n, c).in(family));
}

MatX as_columns(Values x, Index first, const MatX& like) {
    return Eigen::Map<const MatX>(x.data() + first, like.rows(), like.cols());
}

}  // namespace

void FvmLesson::explain_probes() {
    for (const int c : {0, 1, 2})
        explain_probe(fmt::format("tip_{}", axis_name(c)), [this, c] {
            std::vector<Input> of_nodes;
            for (const Index n : solid_->loaded_nodes())
                of_nodes.push_back(Input::now(fmt::format("u_{}", n), "displacement", n, c));
            return Explanation{"ū = mean_n u_n, over the nodes of the loaded face", family_of("u_n", std::move(of_nodes))};
        });
    explain_probe("difference_from_fem", [this] {
        Explanation e{"δ = max_n |f_n − g_n| / f_max", {Input::now("f_max", "largest_face_force", 0)}};
        add_all(e.inputs, "f_n", "force", force_), add_all(e.inputs, "g_n", "finite_element_force", fem_force_);
        return e;
    });
    explain_probe("largest_face_force", [this] {
        Index most = 0;
        face_force_.colwise().norm().maxCoeff(&most);
        Explanation e;
        std::string sum;
        for (int c = 0; c < solid_->dim(); ++c) {
            const std::string name = fmt::format("f_{}", axis_name(c));
            e.inputs.push_back(Input::now(name, "face_force", most, c));
            sum += (c ? " + " : "") + name + "²";
        }
        e.formula = fmt::format("f_max = √({}), of face {} of element {}", sum, most % corners(), most / corners());
        return e;
    });
    explain_probe("energy", [] {
        return Explanation{
            "E = K + U + V",
            {Input::now("K", "kinetic_energy", 0), Input::now("U", "elastic_energy", 0), Input::now("V", "load_energy", 0)}};
    });
    explain_probe("kinetic_energy", [this] {
        Explanation e{"K = motion(v_n), ½ Σ m v²"};
        add_all(e.inputs, "v_n", "velocity", velocity_);
        return std::move(e).by("motion", "J",
                               [this](Values x) { return 0.5 * mass_.dot(as_columns(x, 0, velocity_).colwise().squaredNorm()); });
    });
    explain_probe("elastic_energy", [this] {
        Explanation e{"U = strained(u_n), Σ V ψ(F)"};
        add_all(e.inputs, "u_n", "displacement", displacement_);
        return std::move(e).by("strained", "J", [this](Values x) { return solid_->energy(as_columns(x, 0, position_)); });
    });
}

}  // namespace pliant::fvm
