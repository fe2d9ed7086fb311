// Why geometry, kernels and matrices have the numbers that they have.
#include "bem.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::bem {
namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};
const char* axis(int k) { return axes[static_cast<std::size_t>(k)]; }

// G and ν′ of the plane, or of space.
Input shear(const BemLesson& lesson) { return part("G = Y / (2 (1 + ν))", {lesson.youngs_modulus, lesson.poisson_ratio}); }
Input ratio(const BemLesson& lesson) {
    if (!lesson.in_space() && lesson.plane == Plane::stress) return part("ν′ = ν / (1 + ν)", {lesson.poisson_ratio});
    return part("ν′ = ν", {lesson.poisson_ratio});
}

}  // namespace

// x or y of the start (0) or the end (2) of an element, from the shape that the parameters give.
Input BemLesson::why_end(const char* symbol, Index element, int which, int axis) const {
    const BoundaryElement& e = body_->curve().elements()[static_cast<std::size_t>(element)];
    const Vec<2> X = e.shape[static_cast<std::size_t>(which)];
    const char* place = which == 0 ? "where the element begins" : "where it ends";
    if (is(Setting::outline)) {
        const auto from = static_cast<std::size_t>(e.arc), to = (from + 1) % static_cast<std::size_t>(Index(corners));
        const Vec<2> p = outline[from].place(), way = outline[to].place() - p;
        const auto input = [&](std::size_t corner, const char* as) {
            return Input::of(axis == 0 ? outline[corner].x : outline[corner].y, as);
        };
        return part(fmt::format("{} = (1 − s) a + s b", symbol),
                    {Input::constant("s", (X - p).dot(way) / way.squaredNorm(), "", place), input(from, "a"), input(to, "b")});
    }
    if (is(Setting::plate_with_hole) && !body_->on_inner(element)) {
        const Number& half = axis == 0 ? half_width : half_height;
        return part(fmt::format("{} = s {}", symbol, half.info.symbol), {Input::constant("s", X[axis] / half, "", place), half});
    }
    const bool ring = is(Setting::ring);
    const Number& along_x = !ring ? hole_a : body_->on_inner(element) ? inner_radius : outer_radius;
    const Number& along_y = !ring ? hole_b : along_x;
    const Input angle = Input::constant("θ", std::atan2(X.y() / along_y, X.x() / along_x), "rad", place);
    return axis == 0 ? part(fmt::format("{} = r cos(θ)", symbol), {Input::of(along_x, "r"), angle})
                     : part(fmt::format("{} = r sin(θ)", symbol), {Input::of(along_y, "r"), angle});
}

Explanation BemLesson::why_geometry(const Question& q) const {
    if (body_->in_space()) {
        const Vec<3> A = body_->space().area_vector(q.index);
        Explanation e{fmt::format("n_{0} = A_{0} / √(A_x² + A_y² + A_z²)", axis(q.component))};
        for (int k = 0; k < 3; ++k)
            e.inputs.push_back(
                Input::constant(fmt::format("A_{}", axis(k)), A[k], "m²", "of the parallelogram of the tangents in the middle"));
        return e;
    }
    const auto end = [&](const char* symbol, int which, int k) { return why_end(symbol, q.index, which, k); };
    std::vector<Input> ends{end("x_1", 0, 0), end("x_2", 2, 0), end("y_1", 0, 1), end("y_2", 2, 1)};
    if (q.field == "element_size") return {"l = √((x_2 − x_1)² + (y_2 − y_1)²)", ends};
    if (q.component == 2) return fixed_value("n_z = 0: in the plane");
    const Input length = part("l = √((x_2 − x_1)² + (y_2 − y_1)²)", ends);
    if (q.component == 0) return {"n_x = (y_2 − y_1) / l", {length, ends[2], ends[3]}};
    return {"n_y = (x_1 − x_2) / l", {length, ends[0], ends[1]}};
}

// A unit force along x: row x of Kelvin's solution.
std::optional<Explanation> BemLesson::why_kernel(const Question& q) const {
    const bool space = body_->in_space();
    if (q.component >= body_->dimension()) return fixed_value("U_z = 0: in the plane");
    if (at_source(q.index)) return fixed_value("U = 0: the source lies here, and the integral takes care of it");
    const Vec<3> way = body_->middles.col(q.index) - body_->nodes.col(static_cast<Index>(tally_[source]));
    std::vector<Input> legs;
    for (int k = 0; k < body_->dimension(); ++k)
        legs.push_back(
            Input::constant(fmt::format("r_{}", axis(k)), way[k], "m", "from the source to the middle of the element"));
    const Input r = part(space ? "r = √(r_x² + r_y² + r_z²)" : "r = √(r_x² + r_y²)", legs);
    const auto e = [&](int k) { return part(fmt::format("e_{0} = r_{0} / r", axis(k)), {legs[static_cast<std::size_t>(k)], r}); };
    const Input nu = ratio(*this);
    const int j = q.component;
    if (q.field.starts_with("kernel_displacement")) {
        const Input s = part(space ? "s = 1 / (16 π G (1 − ν′))" : "s = 1 / (8 π G (1 − ν′))", {shear(*this), nu});
        std::vector<Input> inputs{s, e(0)};
        if (j > 0) inputs.push_back(e(j));
        if (j == 0) inputs.push_back(nu);
        if (space) inputs.push_back(r);
        if (!space && j == 0)
            inputs.insert(inputs.end(), {r, Input::constant("d", body_->plane().kelvin().unit_distance(), "m",
                                                            "where the logarithm is 0, far beyond the body")});
        if (space)
            return Explanation{j == 0 ? "U_x = s (3 − 4 ν′ + e_x²) / r" : fmt::format("U_{0} = s e_x e_{0} / r", axis(j)),
                               inputs};
        return Explanation{j == 0 ? "U_x = s (e_x² − (3 − 4 ν′) ln(r / d))" : "U_y = s e_x e_y", inputs};
    }
    const Input c = part("c = 1 − 2 ν′", {nu});
    std::vector<Input> inputs{r, nu, c, e(0)}, along;
    std::string dot;
    for (int k = 0; k < body_->dimension(); ++k) {
        along.push_back(e(k)), along.push_back(Input::now(fmt::format("n_{}", axis(k)), "normal", q.index, k));
        dot += fmt::format("{}e_{} n_{}", k > 0 ? " + " : "", axis(k), axis(k));
    }
    inputs.push_back(part("e_n = " + dot, along));
    const std::string before = space ? "(8 π (1 − ν′) r²)" : "(4 π (1 − ν′) r)", times = space ? "3" : "2";
    if (j == 0) return Explanation{fmt::format("T_x = −e_n (c + {} e_x²) / {}", times, before), inputs};
    inputs.insert(inputs.end(), {e(j), Input::now("n_x", "normal", q.index, 0),
                                 Input::now(fmt::format("n_{}", axis(j)), "normal", q.index, j)});
    return Explanation{fmt::format("T_{0} = −(e_n {1} e_x e_{0} − c (e_x n_{0} − e_{0} n_x)) / {2}", axis(j), times, before),
                       inputs};
}

// An entry of H or G: the sum over the points of integration of the elements that have the node.
Explanation BemLesson::why_entry(const Question& q) const {
    const bool of_H = q.field == "H";
    const int dim = body_->dimension();
    const Index columns = dim * (of_H ? body_->node_count() : body_->slot_count());
    const Index row = q.index / columns, column = q.index % columns, node = row / dim;
    const int i = static_cast<int>(row % dim), j = static_cast<int>(column % dim);
    if (static_cast<Real>(node) >= tally_[source])
        return fixed_value(of_H ? "H = 0: this row is not filled yet" : "G = 0: this row is not filled yet");
    if (of_H && column / dim == node) return fixed_value("H = 0: the node's own block comes last, from a rigid translation");
    std::vector<Input> inputs;
    bool logarithm = false;
    int number = 0;
    const auto add = [&](const char* symbol, const char* family, Real value, const char* unit, const char* meaning) {
        inputs.push_back(Input::constant(fmt::format("{}_{}", symbol, number), value, unit, meaning).in(family));
    };
    body_->with([&](const auto& bem, const auto&) {
        for (Index k = 0; k < body_->element_count(); ++k)
            for (int a = 0; a < body_->nodes_per_element(); ++a) {
                const Index slot = bem.system().slot_of(k, a);
                if (of_H ? bem.system().node_of_slot(slot) != column / dim : slot != column / dim) continue;
                const auto points = bem.integration_points(k, node);
                for (const auto& p : points) logarithm |= p.log_part != 0;
                for (const auto& p : points) {
                    add("w", "w_q", p.weight, dim == 2 ? "m" : "m²",
                        "weight of a point of integration, with its share of the boundary");
                    add("N", "N_q", p.shape[a], "", "shape function of the node at the point");
                    if (of_H)
                        add("T", "T_q", p.T(i, j), dim == 2 ? "1/m" : "1/m²",
                            "Kelvin's traction across the boundary at the point");
                    else
                        add("U", "U_q", p.U(i, j), dim == 2 ? "1/Pa" : "1/(Pa m)",
                            "Kelvin's displacement at the point, without its logarithm where the element has the source");
                    if (!of_H && dim == 2)
                        add("v", "v_q", i == j ? p.log_part : 0, "m/Pa", "the logarithm's part, with weights of its own");
                    ++number;
                }
            }
    });
    if (of_H) return {"H = Σ_q w_q N_q T_q", inputs};
    if (logarithm && dim == 2) return {"G = Σ_q N_q (w_q U_q + v_q)", inputs};
    std::erase_if(inputs, [](const Input& in) { return in.family == "v_q"; });
    return {"G = Σ_q w_q N_q U_q", inputs};
}

// All but the node's own block is left as it was.
Explanation BemLesson::why_own_block(const Question& q) const {
    const int dim = body_->dimension();
    const Index columns = dim * body_->node_count(), row = q.index / columns, column = q.index % columns;
    if (row / dim != column / dim) return {"H_ij = h_ij", {Input::before("h_ij", "H", q.index)}};
    const bool around = (is(Setting::hole) || in_space()) && row == column;
    Explanation e{around ? "H_ii = 1 − Σ_j H_ij" : "H_ii = −Σ_j H_ij"};
    for (Index n = 0; n < body_->node_count(); ++n)
        if (n != row / dim) e.inputs.push_back(entry_of(fmt::format("H_{}", n), "H", row, dim * n + column % dim).in("H_ij"));
    return e;
}

// Of H or G: where it is kept, or as a number.
Input BemLesson::entry_of(std::string symbol, std::string_view matrix, Index row, Index column) const {
    const int dim = body_->dimension();
    const Index columns = dim * (matrix == "H" ? body_->node_count() : body_->slot_count());
    if (shows_matrices()) return Input::now(std::move(symbol), matrix, row * columns + column);
    return body_->with([&](const auto& bem, const auto&) {
        return matrix == "H" ? Input::constant(symbol, bem.system().H()(row, column), "", "entry of H")
                             : Input::constant(symbol, bem.system().G()(row, column), "m/Pa", "entry of G");
    });
}

}  // namespace pliant::bem
