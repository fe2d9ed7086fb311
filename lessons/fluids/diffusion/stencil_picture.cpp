// The stencil of the selected cell: its cells in the picture, the same magnified with weights and values, and what they exchange.
#include "diffusion.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant::diffusion {
namespace {

std::string shown(Real x) { return format_quantity(std::abs(x) < 5e-7 ? 0 : x, "", 3); }

void outline(Scene& scene, const Vec<2>& middle, const Vec<2>& half, Ink ink, float width, bool dashed = false) {
    scene.box(position<2>(middle - half), position<2>(middle + half), ink, width, dashed);
}

// A magnified cell: its weight in symbols and as a number, and what is weighted.
void magnified(Scene& scene, const Vec<2>& middle, const Vec<2>& half, const std::string& symbols, Real weight, Real u, Ink ink) {
    scene.label(position<2>(middle), symbols, ink, 0, -17);
    scene.label(position<2>(middle), shown(weight), ink, 0, 0);
    scene.label(position<2>(middle), "× " + shown(u), Ink::text, 0, 17);
    outline(scene, middle, half, ink, 3);
}

// Below or beside the box of what a wall takes for a neighbour.
void name_wall(Scene& scene, const Vec<2>& middle, const Vec<2>& half, bool below) {
    const Position edge = below ? position(middle[0], middle[1] - half[1]) : position(middle[0] + half[0], middle[1]);
    scene.label(edge, "wall", Ink::text, below ? 0.f : 24.f, below ? 12.f : 0.f);
}

// An arrow from the larger number to the smaller one. gain: of the one at `to` [m/s].
void exchange(Scene& scene, const Vec<2>& from, const Vec<2>& to, Real gain) {
    scene.arrows.push_back({.from = {position<2>(gain > 0 ? from : to)},
                            .to = {position<2>(gain > 0 ? to : from)},
                            .ink = Ink::velocity,
                            .width = 3});
}

}  // namespace

// Of a neighbour and of the cell itself, in symbols and as numbers.
DiffusionLesson::Weights DiffusionLesson::weights() const {
    const int count = 2 * dims();
    const Real r = rate(), literal_rate = r * dx() * dx();
    if (literal()) return {"νΔt", fmt::format("−{}νΔt", count), literal_rate, -count * literal_rate};
    if (is_explicit()) return {"r", fmt::format("1 − {}r", count), r, 1 - count * r};
    return {"−r", fmt::format("1 + {}r", count), -r, 1 + count * r};
}

void DiffusionLesson::draw_stencil(Scene& scene, const Magnifier& large) const {
    for (const Neighbour& n : neighbours()) draw_neighbour(scene, large, n);
    const Counts<2> here = selected();
    const Weights w = weights();
    magnified(scene, large.middle, large.half, w.own_symbols, w.own, u_[selected_cell()], Ink::accent);
    outline(scene, cell_middle(here), cell_half(), Ink::accent, 3);
    scene.points.push_back({.at = {position<2>(cell_middle(here))},
                            .ink = Ink::accent,
                            .radius = 6,
                            .pick = {.pickable = true, .on = On::handle, .first = 0}});
}

void DiffusionLesson::draw_neighbour(Scene& scene, const Magnifier& large, const Neighbour& n) const {
    Counts<2> at = selected();
    const bool beyond = lattice_.neighbour(at, n.axis, n.step) < 0;
    at[n.axis] += n.step;
    const SampleBeyond sample = sample_beyond(lattice_, at);
    const Real beside = sample.factor * u_[sample.index] + sample.offset, gain = rate() * (beside - u_[selected_cell()]);
    const Vec<2> way = n.step * Vec<2>::Unit(n.axis), half = large.half[n.axis] * way, apart = large.apart[n.axis] * way;
    const Weights w = weights();
    magnified(scene, large.middle + apart, large.half, w.beside_symbols, w.beside, beside, beyond ? Ink::rest : Ink::force);
    if (beyond) name_wall(scene, large.middle + apart, large.half, n.axis == 0);
    outline(scene, cell_middle(beyond ? at : lattice_.coordinates(sample.index)), cell_half(), beyond ? Ink::rest : Ink::force, 2,
            beyond);
    if (!scene.show_arrows || literal()) return;

    if (std::abs(gain) > 1e-12 * scale()) exchange(scene, large.middle + apart - half, large.middle + half, gain);
    // What is gained stands clear of the boxes: above a row; around a cell of the square as the blades of a windmill.
    const auto turn = static_cast<float>(n.step);
    const float up = dims() == 2 ? turn : 1;
    Vec<2> words = large.middle + 0.5 * apart;
    if (n.axis == 0) words[1] += static_cast<Real>(up) * large.half[1];
    scene.label(position<2>(words), fmt::format("{}{}", gain > 0 ? "+" : "", shown(gain)), Ink::velocity,
                n.axis == 1 ? -44 * turn : 0, n.axis == 1 ? 0 : -12 * up);
}

}  // namespace pliant::diffusion
