// Rods that hang side by side: the rest, the continuum, and the chains of derived and of picked springs; and a rod that carries a
// wave: the rod itself, and above it its displacement, with that of the continuum.
#include "rod.h"

#include <pliant/lesson/unstructured_grid.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::rod {
namespace {

constexpr int pieces = 48;  // of the continuum

Real deepest(const RodLesson& l) {
    const Real most = std::max({l.static_tip(Rule::derived, l.segments), l.continuum().hanging_tip(l.weight_acceleration()),
                                l.hangs_still() || l.by_hand() ? l.static_tip(Rule::constant, l.segments) : Real{0}});
    return l.length + (l.hangs_still() ? 1 : 2) * most;
}

// How far a rod at x has come down, as a dimension beside it.
void draw_descent(const RodLesson& l, Scene& picture, Real x, Real tip) {
    if (l.unsolved()) return;
    const Real H = deepest(l), beside = x + 0.07 * H;
    if (std::abs(tip) < 1e-3 * H)
        return picture.label(position(beside, -l.length), format_quantity(tip, "m", 3), Ink::text, 24, 14);
    // Clear of the dashed lines.
    const Real middle = -l.length - 0.5 * tip, rest = -l.length - l.continuum().hanging_tip(l.weight_acceleration());
    const float below = std::abs(middle - rest) < 0.04 * H || std::abs(tip) < 0.08 * H ? 16.0f : 0.0f;
    picture.dimension_line(position(beside, -l.length), position(beside, -l.length - tip), format_quantity(tip, "m", 3), 38,
                           below);
}

void draw_continuum(const RodLesson& l, Scene& picture, Real x) {
    LineMarks bar{.ends = {}, .ink = Ink::rest, .width = 7};
    const bool moves = !l.hangs_still() && l.exact_displacement(0, 0);
    const auto u = [&](int piece) {
        const Real s = l.length * piece / pieces;
        if (l.unsolved()) return Real{0};
        return moves ? *l.exact_displacement(s, l.clock_[RodLesson::elapsed])
                     : l.continuum().hanging_displacement(s, l.weight_acceleration());
    };
    const bool strains = picture.colour_by.field == "strain";
    for (int p = 0; p < pieces; ++p) {
        bar.ends.push_back(position(x, -l.length * p / pieces - u(p)));
        bar.ends.push_back(position(x, -l.length * (p + 1) / pieces - u(p + 1)));
        if (strains) bar.values.push_back(static_cast<float>((u(p + 1) - u(p)) * pieces / l.length));
    }
    picture.lines.push_back(std::move(bar));
    picture.label(position(x, 0), "continuum", Ink::text, 0, -14);
    draw_descent(l, picture, x, u(pieces));
}

VecX hanging_displacements(const RodLesson& l, Rule rule) {
    VecX tension, move;
    balance_chain(VecX::Constant(l.count(), l.stiffness_of(rule, l.segments)), l.node_masses_ * l.weight_acceleration(), tension,
                  move);
    return move;
}

// The one that is computed, or the other, at rest.
void draw_hanging_rod(const RodLesson& l, Scene& picture, Rule rule, Real x) {
    const bool computed = rule == l.spring_rule;
    const Index n = l.segments;
    VecX u = VecX::Zero(n + 1);
    if (computed)
        for (Index i = 0; i <= n; ++i) u[i] = l.displacement_of(i);
    else if (!l.unsolved())
        u = hanging_displacements(l, rule);

    LineMarks bar{.ends = {}, .ink = computed ? Ink::edge : Ink::rest, .width = computed ? 6.0f : 4.0f};
    PointMarks nodes{.at = {}, .ink = computed ? Ink::body : Ink::rest, .radius = n > most_ticks ? 2.0f : 4.0f};
    if (computed) {
        bar.pick = {.pickable = true, .on = On::edge};
        nodes.pick = {.pickable = true, .on = On::node};
        bar.values = picture.values(l, On::edge), nodes.values = picture.values(l, On::node);
    }
    const bool strains = picture.colour_by.field == "strain" && !computed;
    const auto at = [&](Index i) { return position(x, -l.rest_place(i) - u[i]); };
    for (Index i = 0; i <= n; ++i) {
        nodes.at.push_back(at(i));
        if (i == n) break;
        bar.ends.push_back(at(i));
        bar.ends.push_back(at(i + 1));
        if (strains) bar.values.push_back(static_cast<float>((u[i + 1] - u[i]) / l.segment()));
    }
    picture.lines.push_back(std::move(bar));
    if (computed || n <= most_ticks) picture.points.push_back(std::move(nodes));
    const std::string name = rule == Rule::derived ? "derived" : "by hand";
    picture.label(position(x, 0), name, computed ? Ink::accent : Ink::text, 0, -14);
    draw_descent(l, picture, x, u[n]);
}

void draw_hanging(const RodLesson& l, Scene& picture) {
    const Real H = deepest(l), rest = l.continuum().hanging_tip(l.weight_acceleration());
    const Real right = l.hangs_still() ? 1.32 * H : 0.92 * H;
    picture.line(position(-0.18 * H, 0), position(right - 0.1 * H, 0), Ink::ground, 5);
    // The rod at rest, without weight.
    picture.line(position(0, 0), position(0, -l.length), Ink::rest, 3, true);
    picture.dimension_line(position(-0.1 * H, 0), position(-0.1 * H, -l.length), "L = " + format_quantity(l.length, "m", 3), -44,
                           0);
    picture.line(position(-0.03 * H, -l.length), position(right - 0.1 * H, -l.length), Ink::rest, 1, true);
    if (rest > 0 && !l.unsolved())
        picture.line(position(0.2 * H, -l.length - rest), position(right, -l.length - rest), Ink::accent, 2, true);

    draw_continuum(l, picture, 0.3 * H);
    if (l.hangs_still()) {
        draw_hanging_rod(l, picture, Rule::derived, 0.68 * H);
        draw_hanging_rod(l, picture, Rule::constant, 1.06 * H);
    } else {
        draw_hanging_rod(l, picture, l.spring_rule, 0.68 * H);
    }
    picture.label(position(0, 0), "no load", Ink::text, 0, -14);
    picture.frame(position(-0.3 * H, -1.06 * H), position(right + 0.06 * H, 0.22 * H));
}

void write_notes(const RodLesson& l, Scene& picture) {
    const auto text = [](Real x, const char* unit) { return format_quantity(x, unit, 4); };
    const Index n = l.segments;
    if (!l.by_hand() || l.hangs_still())
        picture.notes.push_back(fmt::format("N = {}, derived:  k = EA/Δs = {} / {} = {}", n, text(l.axial_stiffness, "N"),
                                            text(l.segment(), "m"), text(l.stiffness_of(Rule::derived, n), "N/m")));
    if (l.by_hand() || l.hangs_still())
        picture.notes.push_back(fmt::format("N = {}, by hand:  k₀ = {}, a rod of EA = k₀Δs = {}", n,
                                            text(l.picked_stiffness, "N/m"), text(l.picked_stiffness * l.segment(), "N")));
    if (l.hangs_still()) {
        const Real rest = l.continuum().hanging_tip(l.gravity), part = static_cast<Real>(n + 1) / static_cast<Real>(n);
        picture.notes.push_back(fmt::format("derived tip = (N + 1)/N · MgL/(2EA) = {} · {} = {}", text(part, ""), text(rest, "m"),
                                            text(part * rest, "m")));
        return;
    }
    if (l.setting == Setting::wave)
        picture.notes.push_back(fmt::format("mode {}:  ω = {} of the chain, {} of the rod", l.watched_mode(),
                                            text(l.chain().frequency(std::max<Index>(l.watched_mode(), 1), l.end()), "rad/s"),
                                            text(l.continuum().frequency(l.watched_mode(), l.end()), "rad/s")));
    if (l.runs_a_pulse()) picture.notes.push_back(fmt::format("c = √(EA L/M) = {}", text(l.continuum().wave_speed(), "m/s")));
    const Real limit = l.stable_time_step();
    if (!std::isfinite(limit))
        picture.notes.push_back(fmt::format("Δt = {}: no limit", text(l.dt, "s")));
    else if (limit == 0)
        picture.notes.push_back(fmt::format("Δt = {}: unstable at every Δt", text(l.dt, "s")));
    else
        picture.notes.push_back(
            fmt::format("Δt = {} {} {}, the stability limit", text(l.dt, "s"), l.dt <= limit ? "≤" : ">", text(limit, "s")));
}

}  // namespace

void RodLesson::draw(Scene& picture) const {
    hangs() ? draw_hanging(*this, picture) : draw_waves(picture);
    write_notes(*this, picture);
}

// ----------------------------------------------------------------------------------------------------------------- words

namespace {

// In lengths of the rod: where the rod lies below its curve, and how tall a displacement of the amplitude is drawn.
constexpr Real rod_low = -0.33, tall = 0.11, map_top = -0.5, map_low = -1.0;

void draw_straight_rod(const RodLesson& l, Scene& picture) {
    const Real y = rod_low * l.length;
    const auto at = [&](Index i) { return position(l.position_(0, i), y + l.position_(1, i)); };
    LineMarks bar{.ends = {}, .ink = Ink::edge, .width = 8, .pick = {.pickable = true, .on = On::edge}};
    PointMarks nodes{
        .at = {}, .ink = Ink::body, .radius = l.segments > most_ticks ? 1.0f : 3.0f, .pick = {.pickable = true, .on = On::node}};
    bar.values = picture.values(l, On::edge), nodes.values = picture.values(l, On::node);
    for (Index i = 0; i <= l.segments; ++i) {
        nodes.at.push_back(at(i));
        if (i == l.segments) break;
        bar.ends.push_back(at(i));
        bar.ends.push_back(at(i + 1));
    }
    picture.lines.push_back(std::move(bar));
    picture.points.push_back(std::move(nodes));
    const Real wall = 0.07 * l.length;
    picture.line(position(0, y - wall), position(0, y + wall), Ink::ground, 6);
    picture.label(position(0, y - wall), "held", Ink::text, 0, 12);
    if (l.end() == RodEnd::fixed) picture.line(position(l.length, y - wall), position(l.length, y + wall), Ink::ground, 6);
    picture.label(position(l.length, y - wall), l.end() == RodEnd::fixed ? "held" : "free", Ink::text, 0, 12);
}

void draw_wave(const RodLesson& l, Scene& picture) {
    const Real up = l.amplitude > 0 ? tall * l.length / l.amplitude : Real{0};
    // What has blown up would leave the picture.
    const auto height = [&](Real u) { return std::clamp(up * u, -0.3 * l.length, 0.3 * l.length); };
    picture.line(position(0, 0), position(l.length, 0), Ink::rest, 1);
    picture.line(position(0, -0.25 * l.length), position(0, 0.25 * l.length), Ink::ground, 4);
    const bool fixed = l.end() == RodEnd::fixed;
    picture.line(position(l.length, -0.25 * l.length), position(l.length, 0.25 * l.length), fixed ? Ink::ground : Ink::rest,
                 fixed ? 4.0f : 1.5f, !fixed);
    for (const Real value : {-l.amplitude, Real{0}, Real{l.amplitude}})
        picture.label(position(0, up * value), format_quantity(value, "m", 3), Ink::text, -34, 0);
    picture.label(position(0, 0.25 * l.length), "u along the rod", Ink::text, 50, -10);

    Curve exact;
    l.sample_exact(exact, &RodLesson::exact_displacement);
    // Its pieces are shorter than a dash: some are left out.
    LineMarks continuum_curve{.ends = {}, .ink = Ink::accent, .width = 2};
    for (std::size_t k = 0; k + 1 < exact.position.size(); ++k)
        if (k / 3 % 2 == 0)
            for (const std::size_t e : {k, k + 1})
                continuum_curve.ends.push_back(position(exact.position[e], height(exact.value[e])));
    LineMarks curve{.ends = {}, .ink = Ink::velocity, .width = 2.5f};
    PointMarks points{.at = {}, .ink = Ink::velocity, .radius = l.segments > most_ticks ? 2.0f : 3.5f};
    for (Index i = 0; i <= l.segments; ++i) {
        const Position here = position(l.rest_place(i), height(l.displacement_of(i)));
        if (i > 0) curve.ends.push_back(points.at.back()), curve.ends.push_back(here);
        points.at.push_back(here);
    }
    picture.lines.push_back(std::move(curve));
    picture.points.push_back(std::move(points));
    picture.lines.push_back(std::move(continuum_curve));
}

// Where the energy of the pulse is, and which way it flows.
void draw_pulse_place(const RodLesson& l, Scene& picture) {
    if (!picture.show_arrows || l.amplitude == 0 || l.clock_[RodLesson::elapsed] == 0) return;
    Real flow = 0, energy = l.kinetic_energy_now() + l.elastic_energy();
    for (Index i = 0; i < l.segments; ++i)
        flow -= l.tension_[i] * l.segment() * l.along().dot(0.5 * (l.velocity_.col(i) + l.velocity_.col(i + 1)));
    if (std::abs(flow) < 0.3 * l.chain_speed() * energy) return;
    const Real at = l.pulse_position(), y = (rod_low + 0.12) * l.length, reach = flow > 0 ? 0.08 * l.length : -0.08 * l.length;
    picture.arrow(position(at - reach, y), position(at + reach, y), Ink::velocity, "");
    const auto speed = l.wave_speed();
    if (speed) picture.label(position(at, y), "c = " + format_quantity(*speed, "m/s", 4), Ink::velocity, 0, -14);
}

// Below the rod: the strain of every segment, time running down. A wave is a slanted band; the dashes are the path of the pulse
// in the continuum.
void draw_history(const RodLesson& l, Scene& picture) {
    if (picture.colour_by.field != "strain") return;
    const Real span = l.history_span(), spans = std::floor(l.clock_[RodLesson::elapsed] / span),
               part = l.clock_[RodLesson::elapsed] / span - spans;
    const auto down = [](Real share) { return map_top + share * (map_low - map_top); };
    GridMarks map{
        .nx = static_cast<int>(l.count()), .ny = static_cast<int>(l.history_rows), .values = {}, .smooth = false, .pick = {}};
    map.lower = position(0, map_low * l.length), map.upper = position(l.length, map_top * l.length);
    for (Index row = l.history_rows; row-- > 0;)
        for (Index i = 0; i < l.count(); ++i) map.values.push_back(static_cast<float>(l.history_(i, row)));
    picture.grids.push_back(std::move(map));
    picture.box(position(0, map_low * l.length), position(l.length, map_top * l.length), Ink::edge, 1);
    picture.line(position(-0.02 * l.length, down(part) * l.length), position(1.02 * l.length, down(part) * l.length), Ink::text,
                 2);
    for (const Real share : {0.0, 1.0})
        picture.label(position(0, down(share) * l.length), format_quantity((spans + share) * span, "s", 3), Ink::text, -36, 0);
    picture.label(position(0.5 * l.length, map_low * l.length), "strain along the rod, time running down", Ink::text, 0, 12);
    constexpr Real most_spans = 1e6;  // beyond, the path is rounding
    if (!l.runs_a_pulse() || !(spans < most_spans)) return;
    // It turns at the ends: s₀ + ct, in lengths, is whole there; t in spans of 3L/c.
    const Real start = l.pulse(1).start / l.length;
    const auto path = [&](Real t) {
        const Real turned = std::fmod(start + 3 * t, 2);
        return position((turned > 1 ? 2 - turned : turned) * l.length, down(t - spans) * l.length);
    };
    Real from = spans;
    while (from < spans + 1) {
        const Real to = std::min((std::floor(start + 3 * from + 1e-9) + 1 - start) / 3, spans + 1);
        picture.line(path(from), path(to), Ink::accent, 1.5f, true);
        from = to;
    }
}

}  // namespace

void RodLesson::draw_waves(Scene& picture) const {
    draw_straight_rod(*this, picture);
    draw_wave(*this, picture);
    if (runs_a_pulse()) draw_pulse_place(*this, picture);
    draw_history(*this, picture);
    const Real L = length;
    picture.frame(position(-0.12 * L, (map_low - 0.06) * L), position(1.12 * L, 0.54 * L));
}

std::optional<UnstructuredGrid> RodLesson::unstructured_grid() const {
    Eigen::MatrixXi ends(2, Index(segments));
    for (Index s = 0; s < segments; ++s) ends.col(s) << static_cast<int>(s), static_cast<int>(s + 1);
    return grid_of(in_space(position_), CellKind::line, std::move(ends), {On::edge});
}

}  // namespace pliant::rod
