// Rods that hang side by side: the rest, the continuum, and the chains of derived and of picked springs.
#include "rod.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::rod {
namespace {

constexpr int pieces = 48;  // of the continuum

}  // namespace

void RodLesson::draw(Scene& picture) const {
    hangs() ? draw_hanging(picture) : draw_waves(picture);
    write_notes(picture);
}

Real RodLesson::deepest() const {
    const Real most = std::max({static_tip(Rule::derived, segments), continuum().hanging_tip(weight_acceleration()),
                                hangs_still() || by_hand() ? static_tip(Rule::constant, segments) : Real{0}});
    return length + (hangs_still() ? 1 : 2) * most;
}

void RodLesson::draw_hanging(Scene& picture) const {
    const Real H = deepest(), rest = continuum().hanging_tip(weight_acceleration());
    const Real right = hangs_still() ? 1.32 * H : 0.92 * H;
    picture.line(position(-0.18 * H, 0), position(right - 0.1 * H, 0), Ink::ground, 5);
    // The rod at rest, without weight.
    picture.line(position(0, 0), position(0, -length), Ink::rest, 3, true);
    picture.dimension_line(position(-0.1 * H, 0), position(-0.1 * H, -length), "L = " + format_quantity(length, "m", 3), -44, 0);
    picture.line(position(-0.03 * H, -length), position(right - 0.1 * H, -length), Ink::rest, 1, true);
    if (rest > 0 && !unsolved())
        picture.line(position(0.2 * H, -length - rest), position(right, -length - rest), Ink::accent, 2, true);

    draw_continuum(picture, 0.3 * H);
    if (hangs_still()) {
        draw_hanging_rod(picture, Rule::derived, 0.68 * H);
        draw_hanging_rod(picture, Rule::constant, 1.06 * H);
    } else {
        draw_hanging_rod(picture, spring_rule, 0.68 * H);
    }
    picture.label(position(0, 0), "no load", Ink::text, 0, -14);
    picture.frame(position(-0.3 * H, -1.06 * H), position(right + 0.06 * H, 0.22 * H));
}

// How far a rod at x has come down, as a dimension beside it.
void RodLesson::draw_descent(Scene& picture, Real x, Real tip) const {
    if (unsolved()) return;
    const Real H = deepest(), beside = x + 0.07 * H;
    if (std::abs(tip) < 1e-3 * H)
        return picture.label(position(beside, -length), format_quantity(tip, "m", 3), Ink::text, 24, 14);
    // Clear of the dashed lines.
    const Real middle = -length - 0.5 * tip, rest = -length - continuum().hanging_tip(weight_acceleration());
    const float below = std::abs(middle - rest) < 0.04 * H || std::abs(tip) < 0.08 * H ? 16.0f : 0.0f;
    picture.dimension_line(position(beside, -length), position(beside, -length - tip), format_quantity(tip, "m", 3), 38, below);
}

void RodLesson::draw_continuum(Scene& picture, Real x) const {
    LineMarks bar{.ends = {}, .ink = Ink::rest, .width = 7};
    const bool moves = !hangs_still() && exact_displacement(0, 0);
    const auto u = [&](int piece) {
        const Real s = length * piece / pieces;
        if (unsolved()) return Real{0};
        return moves ? *exact_displacement(s, clock_[elapsed]) : continuum().hanging_displacement(s, weight_acceleration());
    };
    const bool strains = picture.colour_by.field == "strain";
    for (int p = 0; p < pieces; ++p) {
        bar.ends.push_back(position(x, -length * p / pieces - u(p)));
        bar.ends.push_back(position(x, -length * (p + 1) / pieces - u(p + 1)));
        if (strains) bar.values.push_back(static_cast<float>((u(p + 1) - u(p)) * pieces / length));
    }
    picture.lines.push_back(std::move(bar));
    picture.label(position(x, 0), "continuum", Ink::text, 0, -14);
    draw_descent(picture, x, u(pieces));
}

// The one that is computed, or the other, at rest.
void RodLesson::draw_hanging_rod(Scene& picture, Rule rule, Real x) const {
    const bool computed = rule == spring_rule;
    const Index n = segments;
    VecX u = VecX::Zero(n + 1);
    if (computed)
        for (Index i = 0; i <= n; ++i) u[i] = displacement_of(i);
    else if (!unsolved())
        u = hanging_displacements(rule);

    LineMarks bar{.ends = {}, .ink = computed ? Ink::edge : Ink::rest, .width = computed ? 6.0f : 4.0f};
    PointMarks nodes{.at = {}, .ink = computed ? Ink::body : Ink::rest, .radius = n > most_ticks ? 2.0f : 4.0f};
    if (computed) {
        bar.pick = {.pickable = true, .on = On::edge};
        nodes.pick = {.pickable = true, .on = On::node};
        bar.values = picture.values(*this, On::edge), nodes.values = picture.values(*this, On::node);
    }
    const bool strains = picture.colour_by.field == "strain" && !computed;
    const auto at = [&](Index i) { return position(x, -rest_place(i) - u[i]); };
    for (Index i = 0; i <= n; ++i) {
        nodes.at.push_back(at(i));
        if (i == n) break;
        bar.ends.push_back(at(i));
        bar.ends.push_back(at(i + 1));
        if (strains) bar.values.push_back(static_cast<float>((u[i + 1] - u[i]) / segment()));
    }
    picture.lines.push_back(std::move(bar));
    if (computed || n <= most_ticks) picture.points.push_back(std::move(nodes));
    const std::string name = rule == Rule::derived ? "k = EA/Δs" : "k₀ by hand";
    picture.label(position(x, 0), name, computed ? Ink::accent : Ink::text, 0, -14);
    draw_descent(picture, x, u[n]);
}

VecX RodLesson::hanging_displacements(Rule rule) const {
    VecX tension, move;
    balance_chain(VecX::Constant(count(), stiffness_of(rule, segments)), node_masses_ * weight_acceleration(), tension, move);
    return move;
}

// ----------------------------------------------------------------------------------------------------------------- words

void RodLesson::write_notes(Scene& picture) const {
    const auto text = [](Real x, const char* unit) { return format_quantity(x, unit, 4); };
    const Index n = segments;
    if (!by_hand() || hangs_still())
        picture.notes.push_back(fmt::format("N = {}, derived:  k = EA/Δs = {} / {} = {}", n, text(axial_stiffness, "N"),
                                            text(segment(), "m"), text(stiffness_of(Rule::derived, n), "N/m")));
    if (by_hand() || hangs_still())
        picture.notes.push_back(fmt::format("N = {}, by hand:  k₀ = {}, a rod of EA = k₀Δs = {}", n,
                                            text(picked_stiffness, "N/m"), text(picked_stiffness * segment(), "N")));
    if (hangs_still()) {
        const Real rest = continuum().hanging_tip(gravity), part = static_cast<Real>(n + 1) / static_cast<Real>(n);
        picture.notes.push_back(fmt::format("derived tip = (N + 1)/N · MgL/(2EA) = {} · {} = {}", text(part, ""), text(rest, "m"),
                                            text(part * rest, "m")));
        return;
    }
    if (setting == Setting::wave)
        picture.notes.push_back(fmt::format("mode {}:  ω = {} of the chain, {} of the rod", watched_mode(),
                                            text(chain().frequency(std::max<Index>(watched_mode(), 1), end()), "rad/s"),
                                            text(continuum().frequency(watched_mode(), end()), "rad/s")));
    if (runs_a_pulse()) picture.notes.push_back(fmt::format("c = √(EA L/M) = {}", text(continuum().wave_speed(), "m/s")));
    const Real limit = stable_time_step();
    if (!std::isfinite(limit))
        picture.notes.push_back(fmt::format("Δt = {}: no limit", text(dt, "s")));
    else if (limit == 0)
        picture.notes.push_back(fmt::format("Δt = {}: unstable at every Δt", text(dt, "s")));
    else
        picture.notes.push_back(
            fmt::format("Δt = {} {} {}, the stability limit", text(dt, "s"), dt <= limit ? "≤" : ">", text(limit, "s")));
}

}  // namespace pliant::rod
