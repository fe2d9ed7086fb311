// The plane of λΔt with the roots of the motion, and what moves: springs or a pendulum, with the exact motion as a ghost.
#include "integration.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace pliant::integration {
namespace {

constexpr Real per_unit = 2 / (region_right - region_left);  // of z in the picture
constexpr Real strip = 1.4, block = 0.11;                    // height of the springs; half the size of a mass

Position in_plane(Real re, Real im) {
    return position(region_x + per_unit * (re - (region_left + region_right) / 2), per_unit * im);
}

// A root: both of a pair, or of two real ones the larger first.
std::array<std::complex<Real>, 2> roots(Real w, Real zeta) {
    if (zeta < 1) {
        const std::complex<Real> z(-zeta * w, w * std::sqrt((1 - zeta) * (1 + zeta)));
        return {z, std::conj(z)};
    }
    const Real fast = w * (zeta + std::sqrt((zeta - 1) * (zeta + 1)));
    return {-fast, fast > 0 ? -w * (w / fast) : 0};
}

void square(Scene& scene, const Position& middle, Ink ink, bool ghost) {
    const Position low = position(middle[0] - block, middle[1] - block), high = position(middle[0] + block, middle[1] + block);
    if (ghost) return scene.box(low, high, Ink::rest, 2, true);
    TriangleMarks body{.corners = {low, position(high[0], low[1]), high, position(low[0], high[1])},
                       .triangles = {{0, 1, 2}, {0, 2, 3}},
                       .ink = ink};
    scene.triangles.push_back(std::move(body));
}

// A zigzag between two places at one height.
void spring(Scene& scene, Real from, Real to, Real y, float width) {
    constexpr int teeth = 12;
    LineMarks zigzag{.ends = {}, .ink = Ink::edge, .width = width};
    zigzag.ink = Ink::body;
    const auto at = [&](int k) {
        const bool end = k == 0 || k == teeth;
        return position(from + (to - from) * k / teeth, y + (end ? 0 : k % 2 ? 0.06 : -0.06));
    };
    for (int k = 0; k < teeth; ++k) zigzag.ends.insert(zigzag.ends.end(), {at(k), at(k + 1)});
    scene.lines.push_back(std::move(zigzag));
}

// Over the portrait, at the same x; the inner mass of the pair stands to the left of the outer one.
void draw_springs(const IntegrationLesson& l, Scene& scene) {
    const Real reach = l.portrait_reach();
    const Index n = l.x_.size();
    const auto rest = [n](Index mass) { return mass + 1 == n ? Real{0} : Real{-0.5}; };
    const auto place = [&](Index mass, Real x) {
        return position(std::clamp(rest(mass) + x / reach, Real{-1.1}, Real{1.1}), strip);
    };
    scene.line(position(-1.2, strip - 0.2), position(-1.2, strip + 0.2), Ink::ground, 5);
    Real from = -1.2;
    for (Index mass = 0; mass < n; ++mass) {
        if (const auto exact = l.motion_->exact(mass, l.time())) square(scene, place(mass, exact->x), Ink::rest, true);
        const Position at = place(mass, l.x_[mass]);
        if (l.omega > 0) spring(scene, from, at[0] - block, strip, mass == 1 ? 4.0f : 2.0f);
        square(scene, at, Ink::velocity, false);
        from = at[0] + block;
    }
    // The force at the start, inside the step that it moves: as long as the stretch of the soft spring that it belongs to.
    if (l.inside(l.force_known) && scene.show_arrows)
        for (Index mass = 0; mass < n; ++mass) {
            const Real push = std::clamp(l.force_[mass] / (l.rate() * l.rate() * reach), Real{-1}, Real{1});
            if (std::abs(push) < 0.02) continue;
            const Position start = place(mass, l.x_[mass]);
            scene.arrow(start, position(start[0] + push, start[1]), Ink::force, "f");
        }
    const Position at = place(n - 1, l.x_[n - 1]);
    scene.line(at, l.in_portrait({l.x_[n - 1], l.v_[n - 1]}), Ink::accent, 1, true);
    PointMarks masses{.at = {}, .values = scene.values(l, On::node), .ink = Ink::accent, .radius = 5, .pick = {.pickable = true}};
    for (Index mass = 0; mass < n; ++mass) masses.at.push_back(place(mass, l.x_[mass]));
    scene.points.push_back(std::move(masses));
}

void draw_pendulum(const IntegrationLesson& l, Scene& scene) {
    // Room for the bob over the pivot, where it may get there.
    const Real pivot_y = l.turns() ? 1.64 : 1.75, rod = l.turns() ? 0.42 : 0.55;
    const Position pivot = position(0, pivot_y);
    const auto bob = [&](Real x) {
        const Real angle = l.omega > 0 ? x / l.motion_->length() : 0;
        return position(rod * std::sin(angle), pivot_y - rod * std::cos(angle));
    };
    scene.line(position(-0.3, pivot_y), position(0.3, pivot_y), Ink::ground, 4);
    if (const auto exact = l.motion_->exact(0, l.time())) {
        scene.line(pivot, bob(exact->x), Ink::rest, 2, true);
        scene.points.push_back({.at = {bob(exact->x)}, .ink = Ink::rest, .radius = 10});
    }
    scene.line(pivot, bob(l.x_[0]), Ink::body, 3);
    scene.points.push_back({.at = {bob(l.x_[0])},
                            .values = scene.values(l, On::node),
                            .ink = Ink::velocity,
                            .radius = 10,
                            .pick = {.pickable = true}});
}

void draw_roots(const IntegrationLesson& l, Scene& scene) {
    const auto shown = [](std::complex<Real> z) {
        return in_plane(std::clamp(z.real(), region_left, region_right), std::clamp(z.imag(), -region_high, region_high));
    };
    const auto both = roots(l.motion_->fast_rate() * l.dt, l.zeta);
    if (l.is(SwingingKind::stiff_pair))
        for (const auto z : roots(l.motion_->slow_rate() * l.dt, l.zeta))
            scene.points.push_back({.at = {shown(z)}, .ink = Ink::velocity, .radius = 4});
    scene.points.push_back({.at = {shown(both[1])}, .ink = Ink::accent, .radius = 4});
    scene.points.push_back({.at = {shown(both[0])},
                            .ink = Ink::accent,
                            .radius = 6,
                            .pick = {.pickable = true, .on = On::handle, .first = root_handle}});
    const bool outside = -both[0].real() > -region_left || both[0].imag() > region_high;
    if (outside)
        scene.label(shown(both[0]), fmt::format("|λΔt| = {}", format_quantity(std::abs(both[0]), "", 3)), Ink::accent,
                    both[0].imag() > region_high ? 0 : 44, both[0].imag() > region_high ? 14 : -14);
}

}  // namespace

// -------------------------------------------------------------------------------------------------------- what moves

void IntegrationLesson::draw_motion(Scene& scene) const {
    is(SwingingKind::pendulum) ? draw_pendulum(*this, scene) : draw_springs(*this, scene);
}

// ---------------------------------------------------------------------------------------------------- the plane of λΔt

void IntegrationLesson::draw_region(Scene& scene) const {
    auto& region = regions_[static_cast<std::size_t>(Scheme(scheme))];
    if (!region) region = stability_region(scheme);
    TriangleMarks inside{.corners = {}, .triangles = {}, .ink = Ink::ground};
    for (const auto& piece : region->pieces) {
        const int first = static_cast<int>(inside.corners.size());
        for (const auto& [re, im] : piece) inside.corners.push_back(in_plane(re, im));
        inside.triangles.push_back({first, first + 1, first + 2});
        inside.triangles.push_back({first, first + 2, first + 3});
    }
    scene.triangles.push_back(std::move(inside));
    LineMarks border{.ends = {}, .ink = Ink::body, .width = 2};
    for (const auto& [a, b] : region->border) border.ends.insert(border.ends.end(), {in_plane(a[0], a[1]), in_plane(b[0], b[1])});
    scene.lines.push_back(std::move(border));
    scene.box(position(region_x - 1, -1), position(region_x + 1, 1), Ink::rest, 1);
    scene.line(in_plane(region_left, 0), in_plane(region_right, 0), Ink::rest, 1);
    scene.line(in_plane(0, -region_high), in_plane(0, region_high), Ink::rest, 1);
    for (const int re : {-4, -2}) scene.label(in_plane(re, 0), fmt::format("{}", re), Ink::text, 0, 10);
    for (const int im : {-2, 2}) scene.label(in_plane(0, im), fmt::format("{}i", im), Ink::text, 14, 0);
    scene.label(position(region_x, 1), "λΔt: stable where grey", Ink::text, 0, -10);
    draw_roots(*this, scene);
}

// The start in the portrait, or the root: |λΔt| = ωΔt, and ζ = −Re λ/|λ|.
std::vector<std::pair<std::string, Real>> IntegrationLesson::dragged(const Pull& pull) const {
    if (pull.index == start_handle) {
        const Real reach = portrait_reach();
        return {{"x0", reach * std::clamp(pull.to[0], Real{-1}, Real{1})},
                {"v0", rate() * reach * std::clamp(pull.to[1], Real{-1}, Real{1})}};
    }
    if (pull.index != root_handle || motion_->fast_rate() == 0) return {};
    const std::complex<Real> z((pull.to[0] - region_x) / per_unit + (region_left + region_right) / 2, pull.to[1] / per_unit);
    const Real w = std::max(std::abs(z), Real{1e-3});
    return {{"time_step", w / motion_->fast_rate()}, {"damping_ratio", std::clamp(-z.real() / w, Real{0}, Real{1})}};
}

}  // namespace pliant::integration
