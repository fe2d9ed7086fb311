// Fields and probes, and what is measured.
#include "bem.h"

#include <pliant/math/dense_lu.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::bem {

void BemLesson::declare_fields() {
    state = {state_array("tally", "", tally_)};  // each solve begins anew from the parameters
    const auto in_plane = [this] { return !in_space(); };
    const auto spatial = [this] { return in_space(); };
    const auto small = [this] { return body_ && shows_matrices(); };
    fields = {
        vector_field("normal", "n", "", On::element, normal_, "out of the body, in the middle of each element"),
        scalar_field("element_size", "l", "m", On::element, size_, "between the ends of each element").when(in_plane),
        vector_field("kernel_displacement", "U", "1/Pa", On::element, kernel_displacement_,
                     "Kelvin's: of the middle of each element, by a unit force along x at the source")
            .when(in_plane),
        vector_field("kernel_traction", "T", "1/m", On::element, kernel_traction_,
                     "Kelvin's: across each element, by a unit force along x at the source")
            .when(in_plane),
        vector_field("kernel_displacement_in_space", "U", "1/(Pa m)", On::element, kernel_displacement_,
                     "Kelvin's: of the middle of each element, by a unit force along x at the source")
            .when(spatial),
        vector_field("kernel_traction_in_space", "T", "1/m²", On::element, kernel_traction_,
                     "Kelvin's: across each element, by a unit force along x at the source")
            .when(spatial),
        scalar_field("H", "H", "", On::cell, H_,
                     "what the displacement of one node does to another's equation, entry by entry, row by row")
            .of_both_signs()
            .when(small),
        scalar_field("G", "G", "m/Pa", On::face, G_,
                     "what the traction at a node of an element does to a node's equation, row by row")
            .of_both_signs()
            .when(small),
        vector_field("given_traction", "t̄", "Pa", On::edge, given_traction_, "what is known, at the nodes of each element"),
        vector_field("right_side", "b", "m", On::node, right_side_, "of A x = b: what the known tractions come to"),
        vector_field("displacement", "u", "m", On::node, displacement_, "of the nodes of the boundary"),
        vector_field("traction", "t", "Pa", On::edge, traction_, "at the nodes of each element: known, or found at the support"),
        tensor_field("boundary_stress", "σ", "Pa", On::element, boundary_stress_, "in the middle of each element"),
        vector_field("inside_displacement", "u", "m", On::particle, inside_displacement_,
                     "at the points inside; the last is the one that is asked about"),
        tensor_field("inside_stress", "σ", "Pa", On::particle, inside_stress_,
                     "at the points inside; the last is the one that is asked about")};
}

// ------------------------------------------------------------------------------------------------------------ measured

Real BemLesson::size() const { return (body_->nodes.rowwise().maxCoeff() - body_->nodes.rowwise().minCoeff()).maxCoeff(); }

Vec<3> BemLesson::exact_displacement(const Vec<3>& X) const {
    if (is(Setting::hole)) {
        const Vec<2> u = exact_hole().boundary_displacement();
        return {u.x() * X.x() / hole_a, u.y() * X.y() / hole_b, 0};
    }
    const Real r = X.norm();
    // Nodes of straight elements lie a little off the circle that they stand for.
    return (in_space() ? exact_cavity().displacement(inner_radius)
                       : exact_ring().displacement(r < std::sqrt(inner_radius * outer_radius) ? inner_radius : outer_radius)) *
           X / r;
}

std::optional<Real> BemLesson::worst_error() const {
    if (!has_exact() || tally_[solved] == 0) return std::nullopt;
    Real worst = 0, largest = 0;
    for (Index n = 0; n < body_->node_count(); ++n) {
        const Vec<3> exact = exact_displacement(body_->nodes.col(n));
        worst = std::max(worst, (displacement_.col(n) - exact).norm()), largest = std::max(largest, exact.norm());
    }
    return largest > 0 ? std::optional(worst / largest) : std::nullopt;
}

Real BemLesson::largest_displacement() const { return displacement_.colwise().norm().maxCoeff(); }

// Along the boundary: what is left of the trace without the normal stress, halved where two directions lie in the boundary.
Real BemLesson::hoop_at(Index element) const {
    const Mat<3> s = tensor<3>(boundary_stress_, element);
    const Vec<3> n = normal_.col(element);
    return (s.trace() - n.dot(s * n)) / (in_space() ? 2 : 1);
}

// Over the inner wall (0) or the outer one (1).
Real BemLesson::mean_hoop(int loop) const {
    Real sum = 0, weight = 0;
    for (Index k = 0; k < body_->element_count(); ++k)
        if (body_->on_inner(k) == (loop == 0)) sum += size_[k] * hoop_at(k), weight += size_[k];
    return sum / weight;
}

Real BemLesson::mean_outward(int loop) const {
    Real sum = 0, weight = 0;
    for (Index k = 0; k < body_->element_count(); ++k)
        if (body_->on_inner(k) == (loop == 0))
            for (int a = 0; a < body_->nodes_per_element(); ++a) {
                const Index n = body_->node_of(k, a);
                sum += displacement_.col(n).dot(body_->nodes.col(n).normalized()), weight += 1;
            }
    return sum / weight;
}

std::optional<Real> BemLesson::point_stress(int i, int j) const {
    if (tally_[found_inside] == 0 || !body_->contains(point())) return std::nullopt;
    return inside_stress_(3 * i + j, body_->point());
}

// -------------------------------------------------------------------------------------------------------------- probes

void BemLesson::declare_probes() {
    const auto when_solved = [this] { return tally_[done] != 0; };
    const auto with_hole = [this] { return has_hole() && tally_[done] != 0; };
    const auto of_hole = [this](auto of) {
        return [this, of]() -> std::optional<Real> {
            return is(Setting::hole) ? std::optional<Real>(of(exact_hole())) : std::nullopt;
        };
    };
    const auto with_ring = [this] { return is(Setting::ring) && tally_[done] != 0; };
    const auto with_wall = [this] { return (is(Setting::ring) || in_space()) && tally_[done] != 0; };
    const auto at_a = [this] { return body_->inner_at(0); };
    const auto at_b = [this] { return body_->inner_at(std::numbers::pi / 2); };
    const auto compared = [this] { return comparison_.has_value() && tally_[done] != 0; };
    probes = {
        probe_of("stress_at_a", "σ_yy(a, 0)", "Pa",
                 "along the wall of the hole, beside it; exact: S (1 + 2a/b) + p (2a/b − 1) of a plane without end",
                 [this, at_a] { return body_->stress(at_a())(1, 1); })
            .exactly(of_hole([](const EllipticHole& h) { return h.hoop_stress(0); }))
            .when(with_hole),
        probe_of("stress_at_b", "σ_xx(0, b)", "Pa",
                 "along the wall of the hole, above it; exact: −S + p (2b/a − 1) of a plane without end",
                 [this, at_b] { return body_->stress(at_b())(0, 0); })
            .exactly(of_hole([](const EllipticHole& h) { return h.hoop_stress(std::numbers::pi / 2); }))
            .when(with_hole),
        probe_of("u_x_at_a", "u_x(a, 0)", "m", "of the wall of the hole, beside it",
                 [this, at_a] { return body_->displacement(at_a()).x(); })
            .exactly(of_hole([](const EllipticHole& h) { return h.boundary_displacement().x(); }))
            .when(with_hole),
        probe_of("u_y_at_b", "u_y(0, b)", "m", "of the wall of the hole, above it",
                 [this, at_b] { return body_->displacement(at_b()).y(); })
            .exactly(of_hole([](const EllipticHole& h) { return h.boundary_displacement().y(); }))
            .when(with_hole),
        probe_of("stress_concentration", "σ_yy(a, 0)/S", "",
                 "how many times larger the stress beside the hole is than far away; exact: 1 + 2a/b")
            .formula(*this, "K_t = σ_a / S", {Input::now("σ_a", "stress_at_a", 0), Input::of(remote_stress, "S")})
            .exactly(of_hole([this](const EllipticHole&) { return 1 + 2 * hole_a / hole_b; }))
            .when([this, with_hole] { return with_hole() && remote_stress != 0 && pressure == 0; }),
        probe_of("hoop_inner", "σ_θ(r_i)", "Pa", "along the inner wall, its mean", [this] { return mean_hoop(0); })
            .exactly([this]() -> std::optional<Real> {
                return in_space() ? exact_cavity().hoop_stress(inner_radius) : exact_ring().hoop_stress(inner_radius);
            })
            .when(with_wall),
        probe_of("hoop_outer", "σ_θ(r_o)", "Pa", "along the outer wall, its mean", [this] { return mean_hoop(1); })
            .exactly([this]() -> std::optional<Real> { return exact_ring().hoop_stress(outer_radius); })
            .when(with_ring),
        probe_of("u_inner", "u_r(r_i)", "m", "of the inner wall, outward, its mean; exact of a cavity: p r_i / (4 G)",
                 [this] { return mean_outward(0); })
            .exactly([this]() -> std::optional<Real> {
                return in_space() ? exact_cavity().displacement(inner_radius) : exact_ring().displacement(inner_radius);
            })
            .when(with_wall),
        probe_of("u_outer", "u_r(r_o)", "m", "of the outer wall, outward, its mean", [this] { return mean_outward(1); })
            .exactly([this]() -> std::optional<Real> { return exact_ring().displacement(outer_radius); })
            .when(with_ring),
        probe_of("largest_displacement", "|u|", "m", "of a node of the boundary", [this] { return largest_displacement(); })
            .when(when_solved),
        probe_of("error", "|u − exact|", "", "of the node that is worst off, over the largest exact displacement",
                 [this] { return worst_error(); }),
        probe_of("unbalanced", "|∫ t dS| / ∫ |t| dS", "",
                 "what the support holds less than the load: boundary elements balance no more than they are fine",
                 [this] { return unbalanced(); })
            .when([this, when_solved] { return is(Setting::outline) && when_solved(); }),
        probe_of("point_stress_xx", "σ_xx(P)", "Pa", "at the point that is asked about", [this] { return point_stress(0, 0); }),
        probe_of("point_stress_yy", "σ_yy(P)", "Pa", "at the point that is asked about", [this] { return point_stress(1, 1); }),
        probe_of("point_stress_xy", "σ_xy(P)", "Pa", "at the point that is asked about", [this] { return point_stress(0, 1); }),
        probe_of("point_distance", "d_P", "", "of the point that is asked about from the nearest element, in its lengths",
                 [this]() -> std::optional<Real> {
                     return body_->contains(point()) ? std::optional(body_->distance(point())) : std::nullopt;
                 }),
        probe_of("unknowns", "n", "", "a displacement or a traction for each direction of each node",
                 [this] { return static_cast<Real>(body_->unknowns()); }),
        probe_of("matrix_entries", "n²", "", "of the matrix that is solved; none of them is 0")
            .formula(*this, "N = n²", {Input::now("n", "unknowns", 0)}),
        probe_of("solve_operations", "⅔ n³", "", "multiplications and additions to factorise the matrix")
            .formula(*this, "N = 2 n³ / 3", {Input::now("n", "unknowns", 0)}),
        probe_of("finite_element_unknowns", "n_fem", "",
                 "of linear triangles on the same ring with the same error; beyond the finest mesh by its order",
                 [this] { return comparison_->equal.unknowns; })
            .when(compared),
        probe_of("finite_element_entries", "", "", "of the sparse matrix of those triangles, without its zeros",
                 [this] { return comparison_->equal.entries; })
            .when(compared),
        probe_of("finite_element_operations", "", "", "to factorise that matrix, in an order that keeps it sparse", [this] {
            return comparison_->equal.operations;
        }).when(compared)};
}

Real BemLesson::unbalanced() const {
    Vec<3> sum = Vec<3>::Zero();
    Real size = 0;
    body_->with([&](const auto& bem, const auto&) {
        for (Index k = 0; k < body_->element_count(); ++k) {
            const VecX share = bem.system().element(k).products.rowwise().sum();
            for (int a = 0; a < body_->nodes_per_element(); ++a) {
                const Vec<3> f = share[a] * traction_.col(bem.system().slot_of(k, a));
                sum += f, size += f.norm();
            }
        }
    });
    return size > 0 ? sum.norm() / size : 0;
}

// Of a ring alone: what there is to compare with.
void BemLesson::compare() {
    comparison_.reset();
    const auto error = worst_error();
    if (!is(Setting::ring) || !error || !(*error > 0)) return;
    const auto n = static_cast<Real>(body_->unknowns());
    comparison_ = compare_efforts({exact_ring(), order, static_cast<int>(Index(elements))},
                                  {n, n * n, DenseLu::operations(body_->unknowns()), *error});
}

}  // namespace pliant::bem
