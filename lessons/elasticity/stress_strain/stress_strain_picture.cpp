// The figures: a weight on a disc, a rod between two hands, a block with a cut through it; and the handles in them.
#include "kits/linear_body/linear_body_picture.h"
#include "stress_strain.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pliant::stress_strain {
namespace {

enum Handle : Index { first_handle, second_handle };

Position at(const Vec<3>& x) { return position<3>(x); }

void handle(Scene& scene, const Vec<3>& place, Index which) {
    scene.points.push_back(
        {.at = {at(place)}, .ink = Ink::accent, .radius = 7, .pick = {.pickable = true, .on = On::handle, .first = which}});
}

// A circle about the vertical axis.
void circle(Scene& scene, Real radius, Real height, Ink ink) {
    LineMarks marks{.ends = {}, .ink = ink, .width = 2, .dashed = true};
    constexpr int segments = 48;
    for (int k = 0; k < segments; ++k)
        for (const int end : {k, k + 1}) {
            const Real a = 2 * std::numbers::pi * end / segments;
            marks.ends.push_back(position(radius * std::cos(a), height, radius * std::sin(a)));
        }
    scene.lines.push_back(std::move(marks));
}

// Length of an arrow for a value of a slider, of the reach that its end has.
Real share_of(const Parameter& p) { return std::clamp<Real>(p.value() / p.info.useful.max, -1.2, 1.2); }

// Where the line through the middle along d leaves a rectangle of these half sizes.
Real reach_in(const Vec<2>& half, const Vec<2>& d) {
    const Real x = d[0] == 0 ? std::numeric_limits<Real>::infinity() : half[0] / std::abs(d[0]);
    const Real y = d[1] == 0 ? std::numeric_limits<Real>::infinity() : half[1] / std::abs(d[1]);
    return std::min(x, y);
}

std::string number(Real value, std::string_view unit) { return format_quantity(value, unit); }

}  // namespace

// The same for all loads that the slider reaches, so that more load shows as more deformation.
Real StressStrainLesson::magnification() const {
    const Parameter& slider = loading == Load::disc ? static_cast<const Parameter&>(mass) : force;
    const Real most =
        loading == Load::cut || slider.value() == 0 ? 1 : std::max<Real>(1, slider.info.useful.max / std::abs(slider.value()));
    return linear_body::magnification_for(most * exact_strain().cwiseAbs().maxCoeff());
}

// Where the arrow of the weight begins, and its length at the end of the slider.
StressStrainLesson::WeightArrow StressStrainLesson::weight_arrow() const {
    const Real size = std::max(2 * radius, Real{length});
    return {Vec<3>(0.45 * size, length + 0.6 * size, 0), 0.55 * size};
}

Vec<3> StressStrainLesson::drawn(Index node) const {
    return body_->mesh().points().col(node) + magnification() * displacement_.col(node);
}

void StressStrainLesson::draw(Scene& picture) const {
    linear_body::draw_surface(
        picture, *this, body_->mesh(), [this](Index n) { return drawn(n); }, loading == Load::cut ? 0.35f : 1.f);
    switch (Load(loading)) {
        case Load::disc:
            return draw_disc(picture);
        case Load::rod:
            return draw_rod(picture);
        case Load::cut:
            return draw_cut(picture);
    }
}

// ---------------------------------------------------------------------------------------------------------------- disc

void StressStrainLesson::draw_disc(Scene& picture) const {
    const Real r = radius, h = length, size = std::max(2 * r, h), top = h * (1 + magnification() * strain_(4, 0));
    circle(picture, r, h, Ink::rest);
    circle(picture, r, 0, Ink::rest);
    TriangleMarks floor{.corners = {}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .ink = Ink::fixed, .opacity = 0.45f};
    for (const auto& [x, z] : {std::pair{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}})
        floor.corners.push_back(position(x * r, -0.004 * size, z * r));
    picture.triangles.push_back(std::move(floor));

    // The body that weighs on it, a box whose volume grows with its mass.
    const Real side = 0.5 * size * std::cbrt(std::min<Real>(mass / mass.info.useful.max, 2)), gap = 0.01 * size;
    const Real high = top + gap + side;
    if (side > 0) picture.box(at({-side / 2, top + gap, -side / 2}), at({side / 2, high, side / 2}), Ink::ground, 2.5f);
    const auto [foot, reach] = weight_arrow();
    const Vec<3> head = foot - Vec<3>(0, reach * share_of(mass), 0);
    if (mass > 0) {
        picture.arrow(at(foot), at(head), Ink::force);
        picture.label(at(foot), fmt::format("m g = {}", number(weight(), "N")), Ink::force, 62, -4);
        picture.label(at({0, high, 0}), fmt::format("m = {}", number(mass, "kg")), Ink::text, 0, -14);
    }
    handle(picture, head, first_handle);
    handle(picture, {r, h, 0}, second_handle);

    picture.dimension_line(at({0, -0.06 * size, 1.25 * r}), at({r, -0.06 * size, 1.25 * r}),
                           fmt::format("r = {}", number(r, "m")), 0, 16);
    picture.dimension_line(at({-1.3 * r, 0, 0}), at({-1.3 * r, h, 0}), fmt::format("L = {}", number(h, "m")), -46, 0);
    if (at_rest()) {
        picture.notes.push_back(fmt::format("σ = m g / (π r²) = {} / ({}) = {}", number(weight(), "N"),
                                            number(loaded_area(), "m²"), number(-body_->mean(stress_)(1, 1), "Pa")));
        picture.notes.push_back(fmt::format("ε = ΔL/L = {} / {} = {}: negative, it is pressed",
                                            number(body_->lengthening(displacement_), "m"), number(h, "m"),
                                            number(body_->lengthening(displacement_) / h, "")));
    }
    picture.notes.push_back(fmt::format("deformation drawn ×{}", number(magnification(), "")));
    picture.frame(at({-1.6 * r, -0.15 * size, -r}), at({1.6 * r, h + 0.8 * size, r}));
}

// ----------------------------------------------------------------------------------------------------------------- rod

void StressStrainLesson::draw_rod(Scene& picture) const {
    const Real L = length, w = width, change = body_->lengthening(displacement_), end = L + magnification() * change;
    const Vec<3> middle(0, 0.5 * w, 0.5 * w);
    picture.box(at({0, 0, 0}), at({L, w, w}), Ink::rest, 2, true);
    TriangleMarks wall{.corners = {}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .ink = Ink::fixed, .opacity = 0.45f};
    for (const auto& [y, z] : {std::pair{-0.2, -0.2}, {1.2, -0.2}, {1.2, 1.2}, {-0.2, 1.2}})
        wall.corners.push_back(position(-0.004 * w, y * w, z * w));
    picture.triangles.push_back(std::move(wall));

    // A pull starts at the end of the rod, a push ends there.
    const Real reach = 0.6 * std::max(L, w) * share_of(force);
    const Vec<3> face = middle + Vec<3>(end, 0, 0), tip = face + Vec<3>(reach, 0, 0);
    if (force != 0) {
        picture.arrow(at(force > 0 ? face : face - Vec<3>(reach, 0, 0)), at(force > 0 ? tip : face), Ink::force);
        picture.label(at(face + Vec<3>(std::abs(reach), 0, 0)), fmt::format("F = {}", number(force, "N")), Ink::force, 0, -18);
    }
    handle(picture, face, first_handle);

    picture.dimension_line(at({0, -0.15 * w, w}), at({L, -0.15 * w, w}), fmt::format("L = {}", number(L, "m")), 0, 16);
    if (at_rest() && change != 0) {
        // Along the far edge, so that its words stand clear of the rod.
        picture.line(at({L, 1.08 * w, 0}), at({end, 1.08 * w, 0}), Ink::accent, 4);
        picture.label(at({(L + end) / 2, 1.08 * w, 0}), fmt::format("ΔL = {}", number(change, "m")), Ink::accent, 0, -16);
    }
    if (at_rest()) {
        picture.notes.push_back(fmt::format("σ = F/A = {} / {} = {}", number(force, "N"), number(w * w, "m²"),
                                            number(body_->mean(stress_)(0, 0), "Pa")));
        const char* words = change > 0 ? "positive, it is pulled" : change < 0 ? "negative, it is pressed" : "nothing pulls";
        picture.notes.push_back(
            fmt::format("ε = ΔL/L = {} / {} = {}: {}", number(change, "m"), number(L, "m"), number(change / L, ""), words));
    }
    picture.notes.push_back(fmt::format("deformation drawn ×{}", number(magnification(), "")));
    picture.frame(at({-0.2 * w, -0.3 * w, -0.2 * w}), at({L + 0.75 * std::max(L, w), 1.3 * w, 1.2 * w}));
}

// ----------------------------------------------------------------------------------------------------------------- cut

void StressStrainLesson::draw_cut(Scene& picture) const {
    const Real L = length, w = width;
    const Vec<3> n = normal(), along(-n[1], n[0], 0), front(L / 2, w / 2, w);
    picture.box(at({0, 0, 0}), at({L, w, w}), Ink::rest, 2, true);

    // The plane, as far as it lies in the block at rest.
    const Real half = reach_in({L / 2, w / 2}, along.head<2>());
    TriangleMarks plane{.corners = {}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .ink = Ink::accent, .opacity = 0.6f};
    for (const auto& [side, z] : {std::pair{-1.0, 0.0}, {1.0, 0.0}, {1.0, w}, {-1.0, w}})
        plane.corners.push_back(at(Vec<3>(L / 2, w / 2, z) + side * half * along));
    picture.triangles.push_back(std::move(plane));

    const Real unit = 0.75 * std::max(w, 0.6 * L);
    picture.arrow(at(front), at(front + unit * n), Ink::text, "n");
    handle(picture, front + unit * n, first_handle);
    if (at_rest()) {
        const Mat<3> stress = body_->mean(stress_);
        const Vec<3> t = stress * n, normal_part = t.dot(n) * n, shear = t - normal_part;
        const Real largest = principal_stresses(applied_stress()).cwiseAbs().maxCoeff();
        if (largest > 0) {
            const Real scale = 0.8 * unit / largest;  // the normal stays the longest
            picture.arrow(at(front), at(front + scale * t), Ink::force, "t = σ·n");
            if (normal_part.norm() > 1e-3 * largest)
                picture.arrow(at(front), at(front + scale * normal_part), Ink::velocity, "σ_n");
            if (shear.norm() > 1e-3 * largest) {
                picture.arrow(at(front + scale * normal_part), at(front + scale * t), Ink::accent);
                picture.label(at(front + scale * (normal_part + 0.5 * shear)), "τ", Ink::accent, 14, 0);
            }
        }
        picture.notes.push_back(fmt::format("θ = {}°:  σ_n = n·σ·n = {}  ({}),  τ = {}", number(angle, ""),
                                            number(t.dot(n), "Pa"), t.dot(n) < 0 ? "pressed together" : "pulled apart",
                                            number(t.dot(along), "Pa")));
        picture.matrix("σ", stress.topLeftCorner<2, 2>(), "Pa");
        picture.matrix("n", n.head<2>(), "", Ink::text);
        picture.matrix("t", t.head<2>(), "Pa", Ink::force);
    }
    picture.notes.push_back(fmt::format("deformation drawn ×{}", number(magnification(), "")));
    const Real out = 1.15 * unit;
    picture.frame(at({std::min(0.0, L / 2 - out), w / 2 - out, 0}), at({std::max(L, L / 2 + out), w / 2 + out, w}));
}

// ------------------------------------------------------------------------------------------------------------- handles

std::vector<std::pair<std::string, Real>> StressStrainLesson::dragged(const Pull& pull) const {
    switch (Load(loading)) {
        case Load::disc: {
            if (pull.index == second_handle) return {{"radius", std::hypot(pull.to[0], pull.to[2])}};
            const auto [foot, reach] = weight_arrow();
            return {{"mass", (foot[1] - pull.to[1]) / reach * mass.info.useful.max}};
        }
        case Load::rod: {
            // The end of the rod, as it is drawn: F = Y A ΔL/L.
            const Real change = (pull.to[0] - length) / magnification();
            return {{"force", youngs_modulus * width * width * change / length}};
        }
        case Load::cut: {
            const Real degrees = std::atan2(pull.to[1] - width / 2, pull.to[0] - length / 2) * 180 / std::numbers::pi;
            // A plane is the same from both sides.
            return {{"angle", degrees > 90 ? degrees - 180 : degrees < -90 ? degrees + 180 : degrees}};
        }
    }
    return {};
}

std::optional<UnstructuredGrid> StressStrainLesson::unstructured_grid() const {
    return linear_body::grid_of_body(body_->mesh(), displacement_);
}

}  // namespace pliant::stress_strain
