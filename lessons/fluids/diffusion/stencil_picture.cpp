// The stencil of the selected cell: its cells in the picture, the same magnified with weights and values, and what they exchange.
#include "diffusion.h"
#include "fluids/flow/face_samples.h"

#include <pliant/lesson/format.h>

#include <fmt/format.h>

namespace pliant::diffusion {
namespace {

std::string shown(Real x) { return format_quantity(std::abs(x) < 5e-7 ? 0 : x, "", 3); }

// Weights of a neighbour and of the cell itself, in words and numbers.
struct Weights {
    std::string beside, own;
};

Weights explicit_weights(Real r, int count) {
    return {fmt::format("r = {}", shown(r)), fmt::format("1 − {}r = {}", count, shown(1 - count * r))};
}

void outline(Scene& scene, const Vec<2>& middle, const Vec<2>& half, Ink ink, float width, bool dashed = false) {
    scene.box(position<2>(middle - half), position<2>(middle + half), ink, width, dashed);
}

}  // namespace

// middle: of the magnified cell; apart: distance of its neighbours along x and y; half: half a magnified cell [m].
void DiffusionLesson::draw_stencil(Scene& scene, const Vec<2>& middle, const Vec<2>& apart, const Vec<2>& half) const {
    const int count = 2 * dims();
    const Real r = rate(), literal_rate = r * dx() * dx();
    const Weights weights =
        literal()       ? Weights{fmt::format("νΔt = {}", shown(literal_rate)),
                            fmt::format("−{}νΔt = {}", count, shown(-count * literal_rate))}
        : is_explicit() ? explicit_weights(r, count)
                        : Weights{fmt::format("−r = {}", shown(-r)), fmt::format("1 + {}r = {}", count, shown(1 + count * r))};
    const auto cell = [&](const Vec<2>& at, const std::string& weight, Real u, Ink ink, bool beyond) {
        outline(scene, at, half, ink, 3, beyond);
        scene.label(position<2>(at), weight, ink, 0, -9);
        scene.label(position<2>(at), fmt::format("× {}{}", shown(u), beyond ? " (wall)" : ""), Ink::text, 0, 9);
    };
    const Counts<2> here = selected();
    const Real u = u_[selected_cell()];
    for (const Neighbour& n : neighbours()) {
        Counts<2> at = here;
        at[n.axis] += n.step;
        const flow::SampleBeyond sample = flow::sample_beyond(lattice_, at);
        const bool beyond = lattice_.neighbour(here, n.axis, n.step) < 0;
        const Real beside = sample.factor * u_[sample.index] + sample.offset;
        Vec<2> way = Vec<2>::Zero();
        way[n.axis] = n.step * apart[n.axis];
        cell(middle + way, weights.beside, beside, Ink::force, beyond);
        outline(scene, cell_middle(beyond ? at : lattice_.coordinates(sample.index)), cell_half(), Ink::force, 2, beyond);
        Vec<2> inner = way;
        inner[n.axis] -= n.step * half[n.axis];
        Vec<2> outer = way * (half[n.axis] / apart[n.axis]);
        draw_exchange(scene, middle + inner, middle + outer, r * (beside - u), n.axis == 1);
    }
    cell(middle, weights.own, u, Ink::accent, false);
    outline(scene, cell_middle(here), cell_half(), Ink::accent, 3);
    scene.points.push_back({.at = {position<2>(cell_middle(here))},
                            .ink = Ink::accent,
                            .radius = 6,
                            .pick = {.pickable = true, .on = On::handle, .first = 0}});
}

// From the larger to the smaller number. from: at the neighbour, to: at the cell; amount: what the cell gains [m/s].
void DiffusionLesson::draw_exchange(Scene& scene, const Vec<2>& from, const Vec<2>& to, Real amount, bool upright) const {
    if (!scene.show_arrows || literal()) return;
    if (std::abs(amount) > 1e-12 * scale()) {
        const bool gains = amount > 0;
        scene.arrows.push_back(
            {.from = {position<2>(gains ? from : to)}, .to = {position<2>(gains ? to : from)}, .ink = Ink::velocity, .width = 3});
    }
    const Vec<2> between = 0.5 * (from + to);
    scene.label(position<2>(between), fmt::format("{}{}", amount > 0 ? "+" : "", shown(amount)), Ink::velocity,
                upright ? 40.f : 0.f, upright ? 0.f : -18.f);
}

}  // namespace pliant::diffusion
