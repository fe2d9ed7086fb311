// The figure: the field that is chosen as a heat map with its arrows, walls and solids, the handles, and the notes.
#include "kits/grid2d/grid_picture.h"
#include "projection.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::projection {
namespace {

constexpr Index most_arrows = 24;  // along each side

std::string number(Real value, std::string_view unit = "") { return format_quantity(value, unit, 3); }

}  // namespace

void Projection::draw(Scene& scene) const {
    grid2d::draw_field(scene, *this, *grid_);
    draw_walls(scene);
    if (scene.show_arrows) draw_arrows(scene);
    draw_handles(scene);
    draw_zoom(scene);
    write_notes(scene);
    scene.frame(position(-0.03, -0.12), position(1.83, 1.08));
}

// The pressure pushes along −∇p; a part has its own arrows; every other field is seen with the velocity as it is now.
Projection::Arrows Projection::arrows_for(std::string_view field) const {
    if (field == "pressure") return {pressure_gradient(), -1, Ink::force, "−Δt ∇p"};
    if (field == "gradient_part") return {gradient_, 1, Ink::force, "Δt ∇p"};
    if (field == "solenoidal_part") return {solenoidal_, 1, Ink::velocity, "s"};
    return {centre_, 1, Ink::velocity, tally_[projected] != 0 ? "u" : "ũ"};
}

// In every so many-th cell, an odd number, so that a checkerboard is seen as one; the longest arrow is a little longer than they
// are apart.
void Projection::draw_arrows(Scene& scene) const {
    const Arrows what = arrows_for(scene.colour_by.field);
    const Index n = resolution, every = (n + most_arrows - 1) / most_arrows / 2 * 2 + 1;
    const Real longest = what.vectors.colwise().norm().maxCoeff();
    if (!(longest > 1e-9 * std::sqrt(2 * tally_[energy_given]))) return;
    const Real scale = what.sign * 1.15 * static_cast<Real>(every) * dx() / longest;
    ArrowMarks marks{.from = {}, .to = {}, .ink = what.ink, .width = 1.8f};
    for (Index j = every / 2; j < n; j += every) {
        for (Index i = every / 2; i < n; i += every) {
            const Vec<2> middle = dx() * Vec<2>(static_cast<Real>(i) + 0.5, static_cast<Real>(j) + 0.5);
            const Vec<2> arrow = scale * what.vectors.col(grid_->cells().index({i, j}));
            if (arrow.norm() < 0.06 * static_cast<Real>(every) * dx()) continue;
            marks.from.push_back(position<2>(middle - 0.5 * arrow));
            marks.to.push_back(position<2>(middle + 0.5 * arrow));
        }
    }
    scene.arrows.push_back(std::move(marks));
    if (scene.show_labels)
        scene.label(position(0.5, 0), fmt::format("arrows: {}, the longest {}", what.name, number(longest, "m/s")), what.ink, 0,
                    20);
}

void Projection::draw_walls(Scene& scene) const {
    if (grid_->has_gaps()) grid2d::draw_solids(scene, *grid_);
    if (periodic()) {
        scene.box(position(0, 0), position(1, 1), Ink::rest, 2, true);
        if (scene.show_labels) scene.label(position(0.5, 1), "periodic: opposite sides are one", Ink::text, 0, -14);
        return;
    }
    scene.box(position(0, 0), position(1, 1), Ink::ground, 4);
    if (!walls_move()) return;
    const auto crossing = [&](Real x, Real rate, const char* name) {
        const Real length = 0.09 * std::clamp<Real>(rate, -1.5, 1.5);
        ArrowMarks marks{.from = {}, .to = {}, .ink = Ink::accent, .width = 3};
        for (const Real y : {0.2, 0.4, 0.6, 0.8}) {
            if (length == 0) break;
            marks.from.push_back(position(x - length / 2, y)), marks.to.push_back(position(x + length / 2, y));
        }
        scene.arrows.push_back(std::move(marks));
        if (scene.show_labels) scene.label(position(x, 1), fmt::format("{} {}", name, number(rate, "m/s")), Ink::accent, 0, -14);
    };
    crossing(0, speed, "in");
    crossing(1, speed * outflow, "out");
}

// The cell that is drawn large, and the arrows that are drawn by hand.
void Projection::draw_handles(Scene& scene) const {
    const auto handle = [&](const Vec<2>& at, Index which, Ink ink) {
        scene.points.push_back(
            {.at = {position<2>(at)}, .ink = ink, .radius = 5, .pick = {.pickable = true, .on = On::handle, .first = which}});
    };
    const Counts<2> at = grid_->cells().coordinates(selected_cell());
    const Vec<2> low = dx() * Vec<2>(static_cast<Real>(at[0]), static_cast<Real>(at[1]));
    scene.box(position<2>(low), position<2>(low + Vec<2>::Constant(dx())), Ink::accent, 3);
    handle(low + Vec<2>::Constant(dx() / 2), cell_handle, Ink::accent);
    if (given != Given::drawn) return;
    for (std::size_t k = 0; k < arrow_count; ++k) {
        const Vec<2> from = drawn[k].place(), to = from + drawn_scale * drawn[k].velocity();
        scene.arrow(position<2>(from), position<2>(to), Ink::text, fmt::format("{}", k + 1));
        handle(from, first_place + static_cast<Index>(k), Ink::text);
        handle(to, first_tip + static_cast<Index>(k), Ink::text);
    }
}

void Projection::write_notes(Scene& scene) const {
    scene.notes.push_back(selected_sum());
    const std::string cells =
        fmt::format("{0} × {0} cells, Δx = {1}, Δt = {2}", Index(resolution), number(dx(), "m"), number(dt, "s"));
    if (tally_[done] == 0) {
        const Real largest = before_.lpNorm<Eigen::Infinity>();
        scene.notes.push_back(
            fmt::format("given: max|∇·ũ| = {};  {}", scene.awaits("divergence_before") ? "—" : number(largest, "1/s"), cells));
        return;
    }
    scene.notes.push_back(fmt::format("max|∇·u|: {} → {} in {:g} passes;  {}", number(tally_[initial], "1/s"),
                                      number(after_.lpNorm<Eigen::Infinity>(), "1/s"), tally_[passes], cells));
    if (!walls_move() && disturbance == 0)
        scene.notes.push_back(fmt::format("½⟨ũ²⟩ = {} = {} taken out + {} left", number(tally_[energy_given], "J/kg"),
                                          number(tally_[energy_given] - specific_energy(), "J/kg"),
                                          number(specific_energy(), "J/kg")));
}

std::optional<UnstructuredGrid> Projection::unstructured_grid() const { return grid2d::grid_of_cells(*grid_); }

}  // namespace pliant::projection
