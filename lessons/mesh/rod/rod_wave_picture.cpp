// A rod that carries a wave: the rod itself, and above it its displacement, with that of the continuum.
#include "rod.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::rod {
namespace {

// In lengths of the rod: where the rod lies below its curve, and how tall a displacement of the amplitude is drawn.
constexpr Real rod_low = -0.33, tall = 0.11, map_top = -0.5, map_low = -1.0;

}  // namespace

void RodLesson::draw_waves(Scene& picture) const {
    draw_straight_rod(picture);
    draw_wave(picture);
    if (runs_a_pulse()) draw_pulse_place(picture);
    draw_history(picture);
    const Real L = length;
    picture.frame(position(-0.12 * L, (map_low - 0.06) * L), position(1.12 * L, 0.54 * L));
}

void RodLesson::draw_straight_rod(Scene& picture) const {
    const Real y = rod_low * length;
    const auto at = [&](Index i) { return position(position_(0, i), y + position_(1, i)); };
    LineMarks bar{.ends = {}, .ink = Ink::edge, .width = 8, .pick = {.pickable = true, .on = On::edge}};
    PointMarks nodes{
        .at = {}, .ink = Ink::body, .radius = segments > most_ticks ? 1.0f : 3.0f, .pick = {.pickable = true, .on = On::node}};
    bar.values = picture.values(*this, On::edge), nodes.values = picture.values(*this, On::node);
    for (Index i = 0; i <= segments; ++i) {
        nodes.at.push_back(at(i));
        if (i == segments) break;
        bar.ends.push_back(at(i));
        bar.ends.push_back(at(i + 1));
    }
    picture.lines.push_back(std::move(bar));
    picture.points.push_back(std::move(nodes));
    const Real wall = 0.07 * length;
    picture.line(position(0, y - wall), position(0, y + wall), Ink::ground, 6);
    picture.label(position(0, y - wall), "held", Ink::text, 0, 12);
    if (end() == RodEnd::fixed) picture.line(position(length, y - wall), position(length, y + wall), Ink::ground, 6);
    picture.label(position(length, y - wall), end() == RodEnd::fixed ? "held" : "free", Ink::text, 0, 12);
}

void RodLesson::draw_wave(Scene& picture) const {
    const Real up = amplitude > 0 ? tall * length / amplitude : Real{0};
    // What has blown up would leave the picture.
    const auto height = [&](Real u) { return std::clamp(up * u, -0.3 * length, 0.3 * length); };
    picture.line(position(0, 0), position(length, 0), Ink::rest, 1);
    picture.line(position(0, -0.25 * length), position(0, 0.25 * length), Ink::ground, 4);
    const bool fixed = end() == RodEnd::fixed;
    picture.line(position(length, -0.25 * length), position(length, 0.25 * length), fixed ? Ink::ground : Ink::rest,
                 fixed ? 4.0f : 1.5f, !fixed);
    for (const Real value : {-amplitude, Real{0}, Real{amplitude}})
        picture.label(position(0, up * value), format_quantity(value, "m", 3), Ink::text, -34, 0);
    picture.label(position(0, 0.25 * length), "u along the rod", Ink::text, 50, -10);

    Curve exact;
    sample_exact(exact, &RodLesson::exact_displacement);
    // Its pieces are shorter than a dash: some are left out.
    LineMarks continuum_curve{.ends = {}, .ink = Ink::accent, .width = 2};
    for (std::size_t k = 0; k + 1 < exact.position.size(); ++k)
        if (k / 3 % 2 == 0)
            for (const std::size_t e : {k, k + 1})
                continuum_curve.ends.push_back(position(exact.position[e], height(exact.value[e])));
    LineMarks curve{.ends = {}, .ink = Ink::velocity, .width = 2.5f};
    PointMarks points{.at = {}, .ink = Ink::velocity, .radius = segments > most_ticks ? 2.0f : 3.5f};
    for (Index i = 0; i <= segments; ++i) {
        const Position here = position(rest_place(i), height(displacement_of(i)));
        if (i > 0) curve.ends.push_back(points.at.back()), curve.ends.push_back(here);
        points.at.push_back(here);
    }
    picture.lines.push_back(std::move(curve));
    picture.points.push_back(std::move(points));
    picture.lines.push_back(std::move(continuum_curve));
}

// Where the energy of the pulse is, and which way it flows.
void RodLesson::draw_pulse_place(Scene& picture) const {
    if (!picture.show_arrows || amplitude == 0 || clock_[elapsed] == 0) return;
    Real flow = 0, energy = kinetic_energy_now() + elastic_energy();
    for (Index i = 0; i < segments; ++i)
        flow -= tension_[i] * segment() * along().dot(0.5 * (velocity_.col(i) + velocity_.col(i + 1)));
    if (std::abs(flow) < 0.3 * chain_speed() * energy) return;
    const Real at = pulse_position(), y = (rod_low + 0.12) * length, reach = flow > 0 ? 0.08 * length : -0.08 * length;
    picture.arrow(position(at - reach, y), position(at + reach, y), Ink::velocity, "");
    const auto speed = wave_speed();
    if (speed) picture.label(position(at, y), "c = " + format_quantity(*speed, "m/s", 4), Ink::velocity, 0, -14);
}

// Below the rod: the strain of every segment, time running down. A wave is a slanted band; the dashes are the path of the pulse
// in the continuum.
void RodLesson::draw_history(Scene& picture) const {
    if (picture.colour_by.field != "strain") return;
    const Real span = history_span(), spans = std::floor(clock_[elapsed] / span), part = clock_[elapsed] / span - spans;
    const auto down = [](Real share) { return map_top + share * (map_low - map_top); };
    GridMarks map{
        .nx = static_cast<int>(count()), .ny = static_cast<int>(history_rows), .values = {}, .smooth = false, .pick = {}};
    map.lower = position(0, map_low * length), map.upper = position(length, map_top * length);
    for (Index row = history_rows; row-- > 0;)
        for (Index i = 0; i < count(); ++i) map.values.push_back(static_cast<float>(history_(i, row)));
    picture.grids.push_back(std::move(map));
    picture.box(position(0, map_low * length), position(length, map_top * length), Ink::edge, 1);
    picture.line(position(-0.02 * length, down(part) * length), position(1.02 * length, down(part) * length), Ink::text, 2);
    for (const Real share : {0.0, 1.0})
        picture.label(position(0, down(share) * length), format_quantity((spans + share) * span, "s", 3), Ink::text, -36, 0);
    picture.label(position(0.5 * length, map_low * length), "strain along the rod, time running down", Ink::text, 0, 12);
    constexpr Real most_spans = 1e6;  // beyond, the path is rounding
    if (!runs_a_pulse() || !(spans < most_spans)) return;
    // It turns at the ends: s₀ + ct, in lengths, is whole there; t in spans of 3L/c.
    const Real start = pulse(1).start / length;
    const auto path = [&](Real t) {
        const Real turned = std::fmod(start + 3 * t, 2);
        return position((turned > 1 ? 2 - turned : turned) * length, down(t - spans) * length);
    };
    Real from = spans;
    while (from < spans + 1) {
        const Real to = std::min((std::floor(start + 3 * from + 1e-9) + 1 - start) / 3, spans + 1);
        picture.line(path(from), path(to), Ink::accent, 1.5f, true);
        from = to;
    }
}

}  // namespace pliant::rod
