// Boundary elements in the plane: rigid motions, Kirsch's hole, Lamé's ring, a hole under pressure, orders, and what is refused.
#include <pliant/continuum/moduli.h>
#include <pliant/math/error.h>
#include <pliant/solids/bem/exact_bodies.h>
#include <pliant/solids/bem/log_quadrature.h>
#include <pliant/solids/bem/plane_boundary_elements.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr Real pi = std::numbers::pi;
const Lame plane_strain = IsotropicModuli::from_young_poisson(1e4, 0.3).lame();

BoundaryLoop circle(Real radius, bool anticlockwise, int elements) {
    const Real turn = anticlockwise ? pi / 2 : -pi / 2;
    BoundaryLoop loop;
    for (int k = 0; k < 4; ++k) loop.push_back(elliptic_arc({0, 0}, {radius, radius}, k * turn, (k + 1) * turn, elements / 4));
    return loop;
}
BoundaryLoop box(Real half_width, Real half_height, int elements) {
    const Vec<2> a(-half_width, -half_height), b(half_width, -half_height), c(half_width, half_height),
        d(-half_width, half_height);
    return {straight_arc(a, b, elements), straight_arc(b, c, elements), straight_arc(c, d, elements),
            straight_arc(d, a, elements)};
}

// A uniform stress pulls at some loops.
void pull(const PlaneBoundaryElements& bem, BoundaryConditions& conditions, const Mat<2>& stress) {
    const auto& elements = bem.curve().elements();
    for (Index k = 0; k < static_cast<Index>(elements.size()); ++k)
        for (int a = 0; a < elements[static_cast<std::size_t>(k)].count; ++a) {
            const BoundaryElement& e = elements[static_cast<std::size_t>(k)];
            conditions.value.segment<2>(2 * bem.system().slot_of(k, a)) += stress * e.normal(e.at[static_cast<std::size_t>(a)]);
        }
}

// A hole in a body without end that is pulled along y: the hole's surface carries nothing, so the hole alone carries the
// opposite.
struct Kirsch {
    BoundaryCurve curve;
    PlaneBoundaryElements bem;
    PlaneBoundaryElements::Solution hole;
    Mat<2> far = Vec<2>(0, 1).asDiagonal();
    Kirsch(BoundaryOrder order, int elements)
        : curve(std::vector<BoundaryLoop>{circle(1, false, elements)}, order, true), bem(curve, plane_strain) {
        bem.assemble();
        BoundaryConditions conditions = bem.system().free_boundary();
        pull(bem, conditions, -far);
        hole = bem.system().solve(conditions);
    }
    // Largest error of the hoop stress over the nodes, against 1 + 2 cos 2θ with θ from the x axis.
    Real hoop_error() const {
        Real worst = 0;
        for (Index k = 0; k < static_cast<Index>(curve.elements().size()); ++k) {
            const BoundaryElement& e = curve.elements()[static_cast<std::size_t>(k)];
            const Mat<2> sigma = bem.boundary_stress(hole, k, 0) + far;
            const Vec<2> t = e.tangent(0).normalized();
            const Real angle = std::atan2(e.point(0).y(), e.point(0).x());
            worst = std::max(worst, std::abs(t.dot(sigma * t) - (1 + 2 * std::cos(2 * angle))));
        }
        return worst;
    }
    // Largest error of the displacement of a node: in a frame that goes along with the far field's the hole's own is known.
    Real displacement_error() const {
        const Real ratio = 0.3, E = 1e4, plane = 1 - ratio * ratio;
        Real worst = 0;
        for (Index n = 0; n < curve.node_count(); ++n) {
            const Vec<2> X = curve.nodes().col(n);
            // Total: 3 S a/E along the load and -S a/E across it; of the far field strain × X.
            const Vec<2> total(-X.x() * plane / E, 3 * X.y() * plane / E);
            const Vec<2> of_far(-ratio * (1 + ratio) / E * X.x(), plane / E * X.y());
            worst = std::max(worst, (hole.displacement.col(n) - (total - of_far)).norm());
        }
        return worst * E;
    }
};

}  // namespace

TEST_CASE("a rule for logarithms is exact for polynomials", "[bem]") {
    const LogRule rule = log_rule(8);
    for (int p = 0; p < 8; ++p) {
        Real sum = 0;
        for (Index q = 0; q < 8; ++q) sum += rule.log_weights[q] * std::pow(rule.points[q], p);
        CHECK(std::abs(sum - 1 / std::pow(p + 1.0, 2)) < 1e-14);
    }
}

TEST_CASE("a rigid motion of the whole boundary needs no traction", "[bem]") {
    const auto order = GENERATE(BoundaryOrder::constant, BoundaryOrder::linear, BoundaryOrder::quadratic);
    INFO("order " << static_cast<int>(order));
    const BoundaryCurve curve(std::vector<BoundaryLoop>{box(1, 0.7, 4), circle(0.3, false, 16)}, order);
    PlaneBoundaryElements bem(curve, plane_strain);
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    std::ranges::fill(conditions.held, 1);
    for (Index slot = 0; slot < bem.system().slot_count(); ++slot)
        conditions.value[2 * slot] = 0.5, conditions.value[2 * slot + 1] = -0.2;
    const auto s = bem.system().solve(conditions);
    CHECK(s.traction.cwiseAbs().maxCoeff() < 1e-10 * 1e4);
    // A small turn, which rests on the symmetry of T, and is exact where the elements hold linear displacements.
    if (order == BoundaryOrder::constant) return;
    Points<2> turn(2, curve.node_count());
    for (Index n = 0; n < curve.node_count(); ++n) turn.col(n) = Vec<2>(-curve.nodes()(1, n), curve.nodes()(0, n));
    CHECK((bem.system().H() * flat(turn)).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("Kirsch's hole: three times the stress beside it, and the order of each element", "[bem]") {
    // Errors of displacements, halved elements: order 1 of constant elements, 2 of linear ones, 3 or more of quadratic ones.
    const auto [order, expected] = GENERATE(table<BoundaryOrder, Real>(
        {{BoundaryOrder::constant, 1.0}, {BoundaryOrder::linear, 2.0}, {BoundaryOrder::quadratic, 3.0}}));
    const Kirsch coarse(order, 16), fine(order, 32), finer(order, 64);
    const Real first = std::log2(coarse.displacement_error() / fine.displacement_error()),
               second = std::log2(fine.displacement_error() / finer.displacement_error());
    INFO("order " << static_cast<int>(order) << ": " << first << ", " << second << "; errors " << coarse.displacement_error()
                  << " " << finer.displacement_error() << ", hoop " << coarse.hoop_error() << " " << finer.hoop_error());
    CHECK(second > expected - 0.2);
    CHECK(finer.hoop_error() < (order == BoundaryOrder::quadratic ? 0.005 : 0.05));
}

TEST_CASE("stress and displacement inside go with Kirsch's solution", "[bem]") {
    const Kirsch k(BoundaryOrder::quadratic, 32);
    for (const Real x : {1.02, 1.2, 2.0, 5.0}) {
        const Mat<2> sigma = k.bem.stress(k.hole, {x, 0}) + k.far;
        const Real exact = 1 + 0.5 / (x * x) + 1.5 / (x * x * x * x);
        INFO("x = " << x << ", distance " << k.bem.distance({x, 0}));
        CHECK(std::abs(sigma(1, 1) - exact) < 0.01 * exact);
    }
}

TEST_CASE("Lamé's ring under pressure from inside, with its rigid motions taken out", "[bem]") {
    const Lame steel = IsotropicModuli::from_young_poisson(2e11, 0.3).lame();
    const BoundaryCurve curve(std::vector<BoundaryLoop>{circle(2, true, 48), circle(1, false, 32)}, BoundaryOrder::quadratic);
    PlaneBoundaryElements bem(curve, steel);
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    for (Index k = 48; k < 80; ++k)
        for (int a = 0; a < 3; ++a) {
            const BoundaryElement& e = curve.elements()[static_cast<std::size_t>(k)];
            conditions.value.segment<2>(2 * bem.system().slot_of(k, a)) = -1e6 * e.normal(e.at[static_cast<std::size_t>(a)]);
        }
    const auto s = bem.system().solve(conditions);
    CHECK(s.free_rigid_modes == 3);
    const auto hoop = [&](Index element) {
        const Vec<2> t = curve.elements()[static_cast<std::size_t>(element)].tangent(0).normalized();
        return t.dot(bem.boundary_stress(s, element, 0) * t);
    };
    CHECK(std::abs(hoop(48) / 1.6666667e6 - 1) < 1e-3);
    CHECK(std::abs(hoop(0) / 6.6666667e5 - 1) < 1e-3);
    for (Index n = 0; n < curve.node_count(); ++n) {
        const Real radius = curve.nodes().col(n).norm(), outward = s.displacement.col(n).dot(curve.nodes().col(n)) / radius;
        CHECK(std::abs(outward / (radius > 1.5 ? 6.0666667e-6 : 9.5333333e-6) - 1) < 1e-3);
    }
}

TEST_CASE("a hole under pressure in a body without end widens by p a/(2 G), whatever lambda", "[bem]") {
    for (const Real ratio : {0.0, 0.3, 0.49}) {
        const auto material = IsotropicModuli::from_young_poisson(1e4, ratio);
        const BoundaryCurve curve(std::vector<BoundaryLoop>{circle(1, false, 32)}, BoundaryOrder::quadratic, true);
        PlaneBoundaryElements bem(curve, material.lame());
        bem.assemble();
        BoundaryConditions conditions = bem.system().free_boundary();
        pull(bem, conditions, -Mat<2>::Identity());
        const auto s = bem.system().solve(conditions);
        for (Index n = 0; n < curve.node_count(); ++n)
            CHECK(std::abs(s.displacement.col(n).norm() * 2 * material.shear_modulus() - 1) < 1e-4);
    }
}

TEST_CASE("a block that is held at one side and pulled at the other has a uniform strain", "[bem]") {
    const auto order = GENERATE(BoundaryOrder::linear, BoundaryOrder::quadratic);
    const BoundaryCurve curve(std::vector<BoundaryLoop>{box(1, 0.5, 6)}, order);
    PlaneBoundaryElements bem(curve, IsotropicModuli::from_young_poisson(1e4, 0.3).plane_stress_lame());
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    for (Index k = 0; k < 24; ++k)
        for (int a = 0; a < nodes_of(order); ++a) {
            const Index slot = bem.system().slot_of(k, a);
            const int arc = curve.elements()[static_cast<std::size_t>(k)].arc;
            if (arc == 3) conditions.held[static_cast<std::size_t>(2 * slot)] = 1;      // left: x held
            if (arc == 0) conditions.held[static_cast<std::size_t>(2 * slot + 1)] = 1;  // below: y held
            if (arc == 1) conditions.value[2 * slot] = 100;
        }
    const auto s = bem.system().solve(conditions);
    CHECK(s.free_rigid_modes == 0);
    for (Index n = 0; n < curve.node_count(); ++n) {
        const Vec<2> X = curve.nodes().col(n), exact(0.01 * (X.x() + 1), -0.003 * (X.y() + 0.5));
        CHECK((s.displacement.col(n) - exact).norm() < 1e-10);
    }
    CHECK((bem.stress(s, {0.2, 0.1}) - Mat<2>(Vec<2>(100, 0).asDiagonal())).norm() < 1e-6);
    CHECK((bem.displacement(s, {0.2, 0.1}) - Vec<2>(0.012, -0.0018)).norm() < 1e-10);
}

TEST_CASE("a hole is pulled at from far away: the remote displacement on the right side of H u = G t + u∞", "[bem]") {
    const auto order = GENERATE(BoundaryOrder::linear, BoundaryOrder::quadratic);
    const EllipticHole exact{{1, 0.5}, 2, 0.7, plane_strain};
    const BoundaryCurve curve(std::vector<BoundaryLoop>{{elliptic_arc({0, 0}, exact.half_axes, 0, -2 * pi, 64)}}, order, true);
    PlaneBoundaryElements bem(curve, plane_strain);
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    pull(bem, conditions, -exact.pressure * Mat<2>::Identity());
    const Points<2> remote = exact.remote_strain() * curve.nodes();
    conditions.remote = flat(remote);
    const auto s = bem.system().solve(conditions);
    const Vec<2> ends = exact.boundary_displacement();
    for (Index n = 0; n < curve.node_count(); ++n) {
        const Vec<2> u(ends[0] * curve.nodes()(0, n), ends[1] * curve.nodes()(1, n) / 0.5);
        CHECK((s.displacement.col(n) - u).norm() < (order == BoundaryOrder::linear ? 5e-3 : 1e-4) * ends.norm());
    }
    for (Index k = 0; k < 64; ++k) {
        const BoundaryElement& e = curve.elements()[static_cast<std::size_t>(k)];
        const Vec<2> t = e.tangent(0).normalized(), X = e.point(0);
        const Real hoop = t.dot(bem.boundary_stress(s, k, 0) * t);
        CHECK(std::abs(hoop - exact.hoop_stress(std::atan2(X.y() / 0.5, X.x()))) < 0.015 * exact.hoop_stress(0));
    }
    CHECK(std::abs(exact.hoop_stress(0) - (2 * 5 + 0.7 * 3)) < 1e-12);
    CHECK(std::abs(exact.hoop_stress(pi / 2) + 2) < 1e-12);
}

TEST_CASE("the points of integration add up to the matrices", "[bem]") {
    const auto order = GENERATE(BoundaryOrder::constant, BoundaryOrder::linear, BoundaryOrder::quadratic);
    const BoundaryCurve curve(std::vector<BoundaryLoop>{circle(1, false, 8)}, order, true);
    PlaneBoundaryElements bem(curve, plane_strain);
    bem.assemble();
    for (const Index element : {0, 3}) {
        const auto points = bem.integration_points(element, 0);
        for (int a = 0; a < nodes_of(order); ++a) {
            Mat<2> G = Mat<2>::Zero();
            for (const auto& p : points) G += p.shape[a] * (p.weight * p.U + p.log_part * Mat<2>::Identity());
            CHECK((bem.system().G().block<2, 2>(0, 2 * bem.system().slot_of(element, a)) - G).norm() < 1e-14 * G.norm());
        }
    }
}

TEST_CASE("a body of another size, or in another unit of length, has the same solution", "[bem]") {
    // Held at one side, so that the logarithm of Kelvin's solution could matter.
    const auto tip = [](Real scale) {
        const BoundaryCurve curve(std::vector<BoundaryLoop>{box(scale, 0.25 * scale, 5)}, BoundaryOrder::quadratic);
        PlaneBoundaryElements bem(curve, plane_strain);
        bem.assemble();
        BoundaryConditions conditions = bem.system().free_boundary();
        for (Index k = 0; k < 20; ++k)
            for (int a = 0; a < 3; ++a) {
                const Index slot = bem.system().slot_of(k, a);
                if (curve.elements()[static_cast<std::size_t>(k)].arc == 3)
                    conditions.held[static_cast<std::size_t>(2 * slot)] =
                        conditions.held[static_cast<std::size_t>(2 * slot + 1)] = 1;
                if (curve.elements()[static_cast<std::size_t>(k)].arc == 1) conditions.value[2 * slot + 1] = 1;
            }
        return bem.system().solve(conditions).displacement.row(1).maxCoeff() / scale;
    };
    const Real metre = tip(1);
    for (const Real scale : {1e-6, 1e6, 0.37}) CHECK(std::abs(tip(scale) / metre - 1) < 1e-9);
}

TEST_CASE("boundaries and loads that make no problem are refused", "[bem]") {
    const auto refusal = [](const auto& act) -> std::string {
        try {
            act();
        } catch (const Refused& e) {
            return e.what();
        }
        return "";
    };
    using Loops = std::vector<BoundaryLoop>;
    CHECK_THAT(refusal([] { BoundaryCurve(Loops{circle(1, false, 16)}, BoundaryOrder::linear); }),
               ContainsSubstring("loop 0 of the boundary runs clockwise") && ContainsSubstring("draw the outline anticlockwise"));
    CHECK_THAT(refusal([] {
                   BoundaryCurve(Loops{circle(1, true, 16), circle(0.5, true, 16)}, BoundaryOrder::linear);
               }),
               ContainsSubstring("loop 1") && ContainsSubstring("a hole clockwise"));
    CHECK_THAT(refusal([] { BoundaryCurve(Loops{}, BoundaryOrder::linear); }), ContainsSubstring("no elements"));
    CHECK_THAT(refusal([] {
                   BoundaryCurve(Loops{{straight_arc({0, 0}, {1, 0}, 2), straight_arc({1, 0}, {1, 1}, 2),
                                        straight_arc({1, 1}, {0, 0.5}, 2)}},
                                 BoundaryOrder::linear);
               }),
               ContainsSubstring("not closed"));
    CHECK_THAT(refusal([] {
                   BoundaryCurve(Loops{{straight_arc({0, 0}, {1, 0}, 1), straight_arc({1, 0}, {1, 0}, 1),
                                        straight_arc({1, 0}, {0, 1}, 1), straight_arc({0, 1}, {0, 0}, 1)}},
                                 BoundaryOrder::linear);
               }),
               ContainsSubstring("has no length"));
    CHECK_THAT(refusal([] {
                   BoundaryCurve(Loops{{straight_arc({0, 0}, {2, 0}, 1), straight_arc({2, 0}, {2, 2}, 1),
                                        straight_arc({2, 2}, {1, -1}, 1), straight_arc({1, -1}, {0, 0}, 1)}},
                                 BoundaryOrder::linear);
               }),
               ContainsSubstring("cross each other"));
    const BoundaryCurve curve(Loops{box(1, 1, 3)}, BoundaryOrder::linear);
    PlaneBoundaryElements bem(curve, plane_strain);
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    conditions.value[0] = conditions.value[2] = 10;
    CHECK_THAT(refusal([&] { bem.system().solve(conditions); }),
               ContainsSubstring("do not balance") && ContainsSubstring("resultant is ("));
    conditions.value[5] = NAN;
    CHECK_THAT(refusal([&] { bem.system().solve(conditions); }), ContainsSubstring("no finite number"));
}
