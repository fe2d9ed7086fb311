#include "body.h"

#include <pliant/math/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::bem {
namespace {

constexpr Real full_turn = 2 * std::numbers::pi;

// Elements have their middles on the axes. turn: +1 anticlockwise, as an outer boundary, −1 clockwise.
BoundaryLoop round_loop(const Vec<2>& half_axes, int elements, int turn) {
    const Real start = -turn * full_turn / (2 * elements);
    return {elliptic_arc({0, 0}, half_axes, start, start + turn * full_turn, elements)};
}

BoundaryLoop polygon_loop(const std::vector<Vec<2>>& corners, const std::vector<int>& elements) {
    BoundaryLoop loop;
    for (std::size_t k = 0; k < corners.size(); ++k)
        loop.push_back(straight_arc(corners[k], corners[(k + 1) % corners.size()], elements[k]));
    return loop;
}

// As many on each side as go with its length.
std::vector<int> shared_out(const std::vector<Vec<2>>& corners, Real per_metre, int least, int most) {
    std::vector<int> counts;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Real length = (corners[(k + 1) % corners.size()] - corners[k]).norm();
        counts.push_back(static_cast<int>(std::clamp<Real>(std::round(length * per_metre), least, most)));
    }
    return counts;
}

std::vector<Vec<2>> rectangle(const Vec<2>& half) {
    return {{-half[0], -half[1]}, {half[0], -half[1]}, {half[0], half[1]}, {-half[0], half[1]}};
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const BodyPlan& plan) {
    const int n = plan.elements;
    switch (plan.setting) {
        case Setting::plate_with_hole: {
            const auto corners = rectangle(plan.half_sizes);
            // Four times as long as those of the hole; the field is smooth there.
            const Real per_metre = n / (4 * std::numbers::pi * (plan.hole[0] + plan.hole[1]));
            return {polygon_loop(corners, shared_out(corners, per_metre, 4, 24)), round_loop(plan.hole, n, -1)};
        }
        case Setting::ring:
            return {round_loop(Vec<2>::Constant(plan.outer), n, 1), round_loop(Vec<2>::Constant(plan.inner), n, -1)};
        case Setting::outline: {
            Real around = 0;
            for (std::size_t k = 0; k < plan.corners.size(); ++k)
                around += (plan.corners[(k + 1) % plan.corners.size()] - plan.corners[k]).norm();
            return {polygon_loop(plan.corners, shared_out(plan.corners, n / around, 1, n))};
        }
        default:
            return {round_loop(plan.hole, n, -1)};
    }
}

BoundaryCurve boundary_curve(const BodyPlan& plan) {
    return BoundaryCurve(boundary_loops(plan), plan.order, plan.setting == Setting::hole);
}

int cavity_cuts(const BodyPlan& plan) {
    return static_cast<int>(std::max<long>(1, std::lround(std::sqrt(plan.elements / 20.0))));
}

Index unknowns_of(const BodyPlan& plan) {
    if (plan.setting != Setting::cavity_3d) return 2 * boundary_curve(plan).node_count();
    const Index squared = static_cast<Index>(cavity_cuts(plan)) * cavity_cuts(plan);
    return 3 * (10 * squared + 2);
}

Body::Body(const BodyPlan& plan) : plan_(plan) {
    if (plan.setting == Setting::cavity_3d) {
        plan_.order = BoundaryOrder::linear;
        const SphereSurface sphere = sphere_surface(cavity_cuts(plan), true);
        const Real radius = plan.inner;
        space_ = std::make_unique<SpaceBoundaryElements>(radius * sphere.corners, sphere.triangles, plan.material, true,
                                                         BoundaryOrder::linear,
                                                         [radius](const Vec<3>& X) -> Vec<3> { return radius * X.normalized(); });
        measure_space();
    } else {
        curve_ = std::make_unique<BoundaryCurve>(boundary_curve(plan));
        plane_ = std::make_unique<PlaneBoundaryElements>(*curve_, plan.material);
        measure_plane();
    }
    inside_ = inside_mesh(*this);
}

void Body::measure_plane() {
    const auto& list = curve_->elements();
    const auto count = static_cast<Index>(list.size());
    middles.resize(3, count), normals.resize(3, count), sizes.resize(count);
    slot_normals.resize(3, plane_->system().slot_count());
    nodes = Points<3>::Zero(3, curve_->node_count());
    nodes.topRows<2>() = curve_->nodes();
    for (Index k = 0; k < count; ++k) {
        const BoundaryElement& e = list[static_cast<std::size_t>(k)];
        middles.col(k) = in_three(e.point(0)), normals.col(k) = in_three(e.normal(0));
        sizes[k] = (e.shape[2] - e.shape[0]).norm();
        for (int a = 0; a < e.count; ++a)
            slot_normals.col(plane_->system().slot_of(k, a)) = in_three(e.normal(e.at[static_cast<std::size_t>(a)]));
    }
    const bool two_loops = plan_.setting == Setting::plate_with_hole || plan_.setting == Setting::ring;
    inner_first_ = two_loops ? count - plan_.elements : plan_.setting == Setting::outline ? count : 0;
}

void Body::measure_space() {
    const Index count = space_->triangle_count();
    middles.resize(3, count), normals.resize(3, count), sizes.resize(count);
    slot_normals.resize(3, space_->system().slot_count());
    nodes = space_->system().nodes();
    for (Index k = 0; k < count; ++k) {
        middles.col(k) = space_->middle(k), normals.col(k) = space_->normal(k), sizes[k] = space_->area(k);
        for (int a = 0; a < space_->nodes_per_triangle(); ++a)
            slot_normals.col(space_->system().slot_of(k, a)) = space_->normal_at_node(k, a);
    }
}

int Body::arc(Index element) const { return in_space() ? 0 : curve_->elements()[static_cast<std::size_t>(element)].arc; }

OnBoundary Body::inner_at(Real angle) const {
    const Real turns = -angle / full_turn, at = (turns - std::floor(turns)) * plan_.elements + 0.5;
    const Real element = std::floor(at + 1e-12);
    const Real xi = 2 * (at - element) - 1;
    return {inner_first_ + static_cast<Index>(element) % plan_.elements, std::abs(xi) < 1e-9 ? 0 : xi};
}

Vec<3> Body::place(const OnBoundary& at) const {
    return in_three(curve_->elements()[static_cast<std::size_t>(at.element)].point(at.xi));
}
Vec<3> Body::displacement(const OnBoundary& at) const {
    return in_three(plane_->boundary_displacement(plane_solution_, at.element, at.xi));
}
Mat<3> Body::stress(const OnBoundary& at) const { return in_three(plane_->boundary_stress(plane_solution_, at.element, at.xi)); }

// By how often a way along x crosses the boundary.
bool Body::contains(const Vec<3>& X) const {
    if (in_space()) return X.norm() > plan_.inner;
    bool inside = plan_.setting == Setting::hole;
    for (const BoundaryElement& e : curve_->elements())
        for (const Real half : {-1.0, 0.0}) {
            const Vec<2> p = e.point(half), q = e.point(half + 1);
            if ((p.y() > X.y()) != (q.y() > X.y()) && X.x() < p.x() + (X.y() - p.y()) / (q.y() - p.y()) * (q.x() - p.x()))
                inside = !inside;
        }
    return inside;
}

Real Body::distance(const Vec<3>& X) const {
    if (!in_space()) return plane_->distance(X.head<2>());
    return (X.norm() - plan_.inner) / std::sqrt(2 * sizes.mean());
}

}  // namespace pliant::bem
