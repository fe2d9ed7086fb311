// The figure of the lecture: the body at rest and deformed, P and Q, p and q, the vectors between them, and what becomes of a
// small sphere about P.
#include "deformation_gradient.h"

#include <pliant/lesson/unstructured_grid.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::deformation {
namespace {

constexpr Real sphere_radius = 0.13;  // m
// Shorter vectors are not told apart in the picture, m.
constexpr Real seen = 0.01;

Position at(const Vec<3>& x) { return position<3>(x); }

// A dashed arrow: the head is that of a short one at its end.
void dashed_arrow(Scene& scene, const Vec<3>& from, const Vec<3>& to, Ink ink) {
    scene.line(at(from), at(to), ink, 3, true);
    scene.arrows.push_back({.from = {at(to - 0.02 * (to - from))}, .to = {at(to)}, .ink = ink, .width = 3});
}

// The images of three great circles of the sphere about `middle` under the linear map A.
LineMarks rings(const Vec<3>& middle, const Mat<3>& A, Ink ink) {
    constexpr int pieces = 48;
    LineMarks marks{.ends = {}, .ink = ink, .width = 2};
    for (int axis = 0; axis < 3; ++axis) {
        const auto on_ring = [&](int k) {
            const Real angle = 2 * std::numbers::pi * k / pieces;
            Vec<3> n = Vec<3>::Zero();
            n[(axis + 1) % 3] = std::cos(angle), n[(axis + 2) % 3] = std::sin(angle);
            return at(middle + sphere_radius * (A * n));
        };
        for (int k = 0; k < pieces; ++k) marks.ends.push_back(on_ring(k)), marks.ends.push_back(on_ring(k + 1));
    }
    return marks;
}

}  // namespace

void DeformationGradientLesson::draw(Scene& scene) const {
    draw_body(scene);
    draw_ellipsoid(scene);
    draw_vectors(scene);
    draw_points(scene);
    write_numbers(scene);
    frame(scene);
}

// The body at rest as an outline; the deformed one can be looked through.
void DeformationGradientLesson::draw_body(Scene& scene) const {
    scene.box(at(-body_.half()), at(body_.half()), Ink::rest, 2, true);
    TriangleMarks surface{.corners = {}, .triangles = {}, .ink = Ink::body, .opacity = 0.8f};
    LineMarks mesh{.ends = {}, .ink = Ink::edge, .width = 1};
    const std::vector<float> values = scene.values(*this, On::node);
    for (const auto& face : body_.faces()) {
        const int first = static_cast<int>(surface.corners.size());
        for (std::size_t k = 0; k < 4; ++k) {
            surface.corners.push_back(at(position_.col(face[k])));
            if (!values.empty()) surface.values.push_back(values[static_cast<std::size_t>(face[k])]);
            mesh.ends.push_back(at(position_.col(face[k])));
            mesh.ends.push_back(at(position_.col(face[(k + 1) % 4])));
        }
        for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            surface.triangles.push_back({first + a, first + b, first + c});
            surface.pick.ids.push_back(face[a == 0 && b == 1 ? 0 : 2]);
        }
    }
    surface.pick.pickable = true;
    surface.pick.on = On::node;
    scene.triangles.push_back(std::move(surface));
    scene.lines.push_back(std::move(mesh));
}

// P and Q can be dragged; p and q follow.
void DeformationGradientLesson::draw_points(Scene& scene) const {
    PointMarks rest{.at = {at(material(0)), at(material(1))}, .ink = Ink::accent, .radius = 7};
    rest.values = scene.values(*this, On::particle);
    rest.pick = {true, On::particle, 0, {}};
    scene.points.push_back(std::move(rest));
    scene.points.push_back({.at = {at(point_position_.col(0)), at(point_position_.col(1))}, .ink = Ink::text, .radius = 5});
    const bool apart = rest_vector_.norm() > 5 * seen;
    scene.label(at(material(0)), "P", Ink::accent, -12, 14);
    if (apart) scene.label(at(material(1)), "Q", Ink::accent, 12, -14);
    if (point_displacement_.norm() < seen) return;
    scene.label(at(point_position_.col(0)), "p", Ink::text, -12, 14);
    if (apart)
        scene.labels.push_back(
            {.at = at(point_position_.col(1)), .text = "q", .ink = Ink::text, .away_from = at(point_position_.col(0))});
}

void DeformationGradientLesson::draw_vectors(Scene& scene) const {
    if (!scene.show_arrows) return;
    const Vec<3> from = material(0), to = material(1), p = point_position_.col(0), q = point_position_.col(1),
                 dX = rest_vector_.col(0), dx = deformed_vector_.col(0), mapped = mapped_vector_.col(0),
                 du = relative_displacement_.col(0);
    const auto named = [&](const Vec<3>& a, const Vec<3>& b, Ink ink, const char* name, float x, float y, Real share = 0.5) {
        scene.arrows.push_back({.from = {at(a)}, .to = {at(b)}, .ink = ink, .width = 3});
        scene.label(at(a + share * (b - a)), name, ink, x, y);
    };
    // The vector from P to Q, pickable with its numbers.
    LineMarks edge{.ends = {at(from), at(to)}, .values = scene.values(*this, On::edge), .ink = Ink::text, .width = 2};
    edge.pick = {true, On::edge, 0, {}};
    scene.lines.push_back(std::move(edge));
    if (dX.norm() > seen) named(from, to, Ink::text, "dX", 6, 18);
    if (point_displacement_.norm() < seen) return;
    scene.arrows.push_back({.from = {at(from), at(to)}, .to = {at(p), at(q)}, .ink = Ink::velocity, .width = 1.5f});
    scene.label(at(0.55 * from + 0.45 * p), "u(P)", Ink::velocity, 0, 16);
    scene.label(at(0.55 * to + 0.45 * q), "u(Q)", Ink::velocity, 0, -16);
    if (dx.norm() < seen) return;
    if (du.norm() > 3 * seen) {
        scene.line(at(p), at(p + dX), Ink::text, 2, true);
        scene.label(at(p + 0.6 * dX), "dX", Ink::text, 14, 14);
        scene.arrows.push_back({.from = {at(p + dX)}, .to = {at(q)}, .ink = Ink::velocity, .width = 3});
        scene.labels.push_back({.at = at(p + dX), .text = "du", .ink = Ink::velocity, .away_from = at(q)});
    }
    const bool one = gap_.norm() < seen;
    named(p, q, Ink::force, one ? "dx = F dX" : "dx", one ? -48.f : -16.f, -14, one ? 0.75 : 0.5);
    if (one) return;
    dashed_arrow(scene, p, p + mapped, Ink::accent);
    scene.label(at(p + 0.65 * mapped), "F dX", Ink::accent, 0, 16);
    scene.line(at(p + mapped), at(q), Ink::accent, 4);
}

// A small sphere about P becomes an ellipsoid about p, whose radii are the principal stretches.
void DeformationGradientLesson::draw_ellipsoid(Scene& scene) const {
    const Mat<3> F = at_P(point_deformation_), R = at_P(point_rotation_);
    const Vec<3> p = point_position_.col(0);
    scene.lines.push_back(rings(material(0), Mat<3>::Identity(), Ink::rest));
    if (point_displacement_.norm() < seen) return;
    const PrincipalStretches<3> principal = principal_stretches<3>(at_P(point_rotation_) * at_P(point_stretch_));
    scene.lines.push_back(rings(p, F * principal.directions, Ink::fixed));
    if (!scene.show_arrows) return;
    ArrowMarks radii{.from = {}, .to = {}, .ink = Ink::fixed, .width = 2};
    for (int k = 0; k < 3; ++k) {
        const Vec<3> radius = sphere_radius * principal.stretches[k] * (R * principal.directions.col(k));
        for (const Real side : {-1.0, 1.0}) radii.from.push_back(at(p)), radii.to.push_back(at(p + side * radius));
    }
    scene.arrows.push_back(std::move(radii));
}

void DeformationGradientLesson::write_numbers(Scene& scene) const {
    scene.matrix("∇u", at_P(point_slope_));
    scene.matrix("F", at_P(point_deformation_), "", Ink::force);
    scene.matrix("R", at_P(point_rotation_));
    scene.matrix("S", at_P(point_stretch_), "", Ink::fixed);
    if (done_[0] == 0) return;
    const auto text = [](Real x, const char* unit) { return format_quantity(x, unit, 3); };
    scene.notes.push_back(fmt::format("|dx − F dX| = {}  for  |dX| = {}", text(gap_.norm() < 1e-12 ? 0 : gap_.norm(), "m"),
                                      text(rest_vector_.norm(), "m")));
    const Vec<3> s = principal_stretches<3>(at_P(point_deformation_)).stretches;
    scene.notes.push_back(fmt::format("at P:  det F = {},  R turns by {:.1f}°,  S stretches by {:.3g}, {:.3g}, {:.3g}",
                                      text(pliant::volume_ratio<3>(at_P(point_deformation_)), ""),
                                      rotation_angle() * 180 / std::numbers::pi, s[0], s[1], s[2]));
}

// Both bodies as the map leaves them, so that no stage moves the picture.
void DeformationGradientLesson::frame(Scene& scene) const {
    Vec<3> low = -body_.half(), high = body_.half();
    for (const auto& face : body_.faces())
        for (const Index n : face) {
            const Vec<3> x = map_.position(body_.points().col(n));
            low = low.cwiseMin(x), high = high.cwiseMax(x);
        }
    // Room for the matrices below.
    low[1] -= 0.3 * (high[1] - low[1]);
    scene.frame(at(low), at(high));
}

std::optional<UnstructuredGrid> DeformationGradientLesson::unstructured_grid() const {
    Eigen::MatrixXi faces(4, static_cast<Index>(body_.faces().size()));
    for (Index f = 0; f < faces.cols(); ++f)
        for (std::size_t k = 0; k < 4; ++k)
            faces(static_cast<Index>(k), f) = static_cast<int>(body_.faces()[static_cast<std::size_t>(f)][k]);
    return grid_of(position_, CellKind::quadrangle, std::move(faces), {});
}

}  // namespace pliant::deformation
