#include <pliant/math/error.h>
#include <pliant/solids/bem/boundary_curve.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

// A corner, not a vertex of a polygon that stands for a smooth curve: the tangent turns by more than this within an arc's end.
constexpr Real corner_angle = 1 * one_degree;
// How far nodes keep off a corner, in [-1, 1].
constexpr Real off_corner = 2.0 / 3;

Real cross(const Vec<2>& a, const Vec<2>& b) { return a.x() * b.y() - a.y() * b.x(); }

// Do two straight pieces cross, or touch otherwise than at a common end?
bool cross_each_other(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
    const Real side_c = cross(b - a, c - a), side_d = cross(b - a, d - a), side_a = cross(d - c, a - c),
               side_b = cross(d - c, b - c);
    return side_c * side_d < 0 && side_a * side_b < 0;
}

// Direction of an arc near its start or end.
Vec<2> direction(const BoundaryArc& arc, bool at_end) {
    constexpr Real near = 1e-4;
    return (at_end ? arc.point(1) - arc.point(1 - near) : arc.point(near) - arc.point(0)).normalized();
}

}  // namespace

BoundaryArc straight_arc(const Vec<2>& from, const Vec<2>& to, int elements) {
    return {[from, to](Real s) { return Vec<2>((1 - s) * from + s * to); }, elements};
}

BoundaryArc elliptic_arc(const Vec<2>& centre, const Vec<2>& half_axes, Real from, Real to, int elements) {
    return {[=](Real s) {
                const Real angle = (1 - s) * from + s * to;
                return Vec<2>(centre + half_axes.cwiseProduct(Vec<2>(std::cos(angle), std::sin(angle))));
            },
            elements};
}

Vec<2> BoundaryElement::point(Real xi) const {
    return xi * (xi - 1) / 2 * shape[0] + (1 - xi * xi) * shape[1] + xi * (xi + 1) / 2 * shape[2];
}

Vec<2> BoundaryElement::tangent(Real xi) const { return (xi - 0.5) * shape[0] - 2 * xi * shape[1] + (xi + 0.5) * shape[2]; }

Vec<2> BoundaryElement::normal(Real xi) const {
    const Vec<2> t = tangent(xi).normalized();
    return {t.y(), -t.x()};
}

// Lagrange's polynomials through the nodes.
Vec<3> BoundaryElement::values(Real xi) const {
    Vec<3> N = Vec<3>::Zero();
    for (int a = 0; a < count; ++a) {
        N[a] = 1;
        for (int b = 0; b < count; ++b)
            if (b != a)
                N[a] *=
                    (xi - at[static_cast<std::size_t>(b)]) / (at[static_cast<std::size_t>(a)] - at[static_cast<std::size_t>(b)]);
    }
    return N;
}

Vec<3> BoundaryElement::slopes(Real xi) const {
    Vec<3> slope = Vec<3>::Zero();
    for (int a = 0; a < count; ++a)
        for (int c = 0; c < count; ++c) {
            if (c == a) continue;
            Real product = 1 / (at[static_cast<std::size_t>(a)] - at[static_cast<std::size_t>(c)]);
            for (int b = 0; b < count; ++b)
                if (b != a && b != c)
                    product *= (xi - at[static_cast<std::size_t>(b)]) /
                               (at[static_cast<std::size_t>(a)] - at[static_cast<std::size_t>(b)]);
            slope[a] += product;
        }
    return slope;
}

BoundaryCurve::BoundaryCurve(std::span<const BoundaryLoop> loops, BoundaryOrder order, bool unbounded)
    : order_(order), unbounded_(unbounded) {
    int arc = 0, number = 0;
    for (const BoundaryLoop& loop : loops) {
        const std::size_t first = elements_.size();
        add_loop(loop, number, arc);
        check_turn(first, elements_.size() - first, number++);
        arc += static_cast<int>(loop.size());
    }
    if (elements_.empty()) throw Refused("the boundary has no elements; draw at least three");
}

void BoundaryCurve::add_loop(const BoundaryLoop& loop, int loop_number, int first_arc) {
    const std::size_t first = elements_.size();
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const BoundaryArc &arc = loop[k], &next = loop[(k + 1) % loop.size()];
        const Vec<2> end = arc.point(1), start = next.point(0);
        const Real size = (arc.point(0.5) - end).norm();
        if (!((end - start).norm() <= 1e-9 * size))
            throw Refused(
                fmt::format("loop {} of the boundary is not closed: an arc ends at ({}, {}) m and the next begins at ({}, {}) m",
                            loop_number, end.x(), end.y(), start.x(), start.y()));
        for (int e = 0; e < arc.elements; ++e) {
            BoundaryElement element;
            element.shape[0] = arc.point(static_cast<Real>(e) / arc.elements);
            element.shape[2] = e + 1 < arc.elements ? arc.point(static_cast<Real>(e + 1) / arc.elements) : start;
            element.shape[1] = order_ == BoundaryOrder::quadratic ? arc.point((e + 0.5) / arc.elements)
                                                                  : Vec<2>((element.shape[0] + element.shape[2]) / 2);
            element.arc = first_arc + static_cast<int>(k);
            if (!(element.tangent(0).norm() > 0) || !std::isfinite(element.tangent(0).norm()))
                throw Refused(fmt::format("element {} of the boundary has no length", elements_.size()));
            elements_.push_back(element);
        }
    }
    const std::size_t count = elements_.size() - first;
    if (count < 3)
        throw Refused(fmt::format("loop {} of the boundary has {} elements; at least three make one", loop_number, count));

    // Which ends keep off a corner.
    std::vector<char> corner(count, 0);  // before element k
    std::size_t at = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const BoundaryArc& before = loop[(k + loop.size() - 1) % loop.size()];
        const Vec<2> in = direction(before, true), out = direction(loop[k], false);
        corner[at] = std::abs(std::atan2(cross(in, out), in.dot(out))) > corner_angle;
        at += static_cast<std::size_t>(loop[k].elements);
    }
    for (std::size_t k = 0; k < count; ++k) {
        BoundaryElement& e = elements_[first + k];
        e.count = nodes_of(order_);
        e.before = static_cast<int>(first + (k + count - 1) % count), e.after = static_cast<int>(first + (k + 1) % count);
        const Real start = corner[k] ? -off_corner : -1, end = corner[(k + 1) % count] ? off_corner : 1;
        if (order_ == BoundaryOrder::constant) e.at = {0, 0, 0};
        if (order_ == BoundaryOrder::linear) e.at = {start, end, 0};
        if (order_ == BoundaryOrder::quadratic) e.at = {start, 0, end};
    }
    number_nodes(first, count);
}

// Neighbours share the node at a smooth joint.
void BoundaryCurve::number_nodes(std::size_t first, std::size_t count) {
    std::vector<Vec<2>> places;
    const auto base = static_cast<int>(nodes_.cols());
    int first_node = -1;
    for (std::size_t k = 0; k < count; ++k) {
        BoundaryElement& e = elements_[first + k];
        for (int a = 0; a < e.count; ++a) {
            const auto i = static_cast<std::size_t>(a);
            const bool joins_before = e.count > 1 && e.at[i] == -1 && k > 0,
                       closes = e.count > 1 && e.at[i] == 1 && k + 1 == count;
            if (joins_before) {
                const BoundaryElement& before = elements_[first + k - 1];
                e.nodes[i] = before.nodes[static_cast<std::size_t>(before.count - 1)];
            } else if (closes) {
                e.nodes[i] = first_node;
            } else {
                e.nodes[i] = base + static_cast<int>(places.size());
                places.push_back(e.point(e.at[i]));
            }
            if (k == 0 && a == 0) first_node = e.nodes[i];
        }
    }
    nodes_.conservativeResize(2, base + static_cast<Index>(places.size()));
    for (std::size_t n = 0; n < places.size(); ++n) nodes_.col(base + static_cast<Index>(n)) = places[n];
}

void BoundaryCurve::check_turn(std::size_t first, std::size_t count, int loop) const {
    for (std::size_t k = first; k < first + count; ++k)
        for (std::size_t m = k + 1; m < first + count; ++m)
            if (cross_each_other(elements_[k].shape[0], elements_[k].shape[2], elements_[m].shape[0], elements_[m].shape[2]))
                throw Refused(fmt::format("elements {} and {} of the boundary cross each other", k, m));
    // Twice the area inside, by the corners alone.
    Real area = 0;
    for (std::size_t k = first; k < first + count; ++k) area += cross(elements_[k].shape[0], elements_[k].shape[2]);
    const bool outer = loop == 0 && !unbounded_;
    if (outer != (area > 0))
        throw Refused(fmt::format("loop {} of the boundary runs {}; the body must lie to its left: {}", loop,
                                  area > 0 ? "anticlockwise" : "clockwise",
                                  outer ? "draw the outline anticlockwise" : "draw the boundary of a hole clockwise"));
}

}  // namespace pliant
