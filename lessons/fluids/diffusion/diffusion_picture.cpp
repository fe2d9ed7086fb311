// The figure: the curve over its row of cells, or the heat map of the square, and below or beside it the stencil of one cell.
#include "diffusion.h"

#include <pliant/lesson/unstructured_grid.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::diffusion {

// The stencil of the selected cell: its cells in the picture, the same magnified with weights and values, and what they exchange.

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

namespace {

// In lengths of the row.
constexpr Real curve_height = 0.19, strip_low = -0.32, strip_high = -0.26;
constexpr Index most_points = 64;

// The next of 1, 2, 5, 10, 20, …: for an axis that has to hold what has grown.
Real rounded_up(Real x) {
    const Real decade = std::pow(10, std::floor(std::log10(x)));
    for (const Real step : {1, 2, 5})
        if (x <= step * decade * (1 + 1e-12)) return step * decade;
    return 10 * decade;
}

}  // namespace

Vec<2> DiffusionLesson::cell_middle(const Counts<2>& at) const {
    const Real x = (static_cast<Real>(at[0]) + 0.5) * dx();
    return {x, dims() == 1 ? 0.5 * (strip_low + strip_high) * length : (static_cast<Real>(at[1]) + 0.5) * dx()};
}

Vec<2> DiffusionLesson::cell_half() const { return {dx() / 2, dims() == 1 ? 0.5 * (strip_high - strip_low) * length : dx() / 2}; }

void DiffusionLesson::draw_cells(Scene& scene, const Position& lower, const Position& upper) const {
    GridMarks map;
    map.nx = static_cast<int>(lattice_.count[0]);
    map.ny = static_cast<int>(lattice_.count[1]);
    map.lower = lower, map.upper = upper;
    map.smooth = false;
    map.values = scene.values(*this, On::cell);
    if (map.values.empty()) map.values.assign(static_cast<std::size_t>(lattice_.size()), 0.0f);
    scene.grids.push_back(std::move(map));
}

// ------------------------------------------------------------------------------------------------------------- one row

void DiffusionLesson::draw_row(Scene& scene) const {
    const Real L = length;
    draw_cells(scene, position(0, strip_low * L), position(L, strip_high * L));
    if (lattice_.count[0] <= most_points)
        for (Index i = 0; i <= lattice_.count[0]; ++i)
            scene.line(position(static_cast<Real>(i) * dx(), strip_low * L),
                       position(static_cast<Real>(i) * dx(), strip_high * L), Ink::edge, 1);
    draw_exchanges(scene);
    draw_curve(scene);
    // As on the slide nothing passes between the boxes, and their numbers are long.
    const Real apart = literal() ? 0.42 : 0.43, half = literal() ? 0.2 : 0.125;
    draw_stencil(scene, {{0.5 * L, -0.52 * L}, {apart * L, 0}, {half * L, 0.09 * L}});
    scene.frame(position(-0.1 * L, -0.65 * L), position((literal() ? 1.13 : 1.06) * L, 0.3 * L));
}

// What passes between the cells of the row, as arrows over the faces between them: a whole cell long from a difference
// of a fifth of the scale on.
void DiffusionLesson::draw_exchanges(Scene& scene) const {
    if (!scene.show_arrows || literal() || lattice_.count[0] > most_points) return;
    ArrowMarks arrows{.from = {}, .to = {}, .ink = Ink::velocity, .width = 2};
    const Real y = (strip_high + 0.022) * length;
    for (Index i = 1; i < lattice_.count[0]; ++i) {
        const Real reach = 0.5 * dx() * std::clamp(5 * (u_[i - 1] - u_[i]) / scale(), Real(-1), Real(1));
        if (std::abs(reach) < 0.2 * dx()) continue;
        const Real face = static_cast<Real>(i) * dx();
        arrows.from.push_back(position(face - reach, y));
        arrows.to.push_back(position(face + reach, y));
    }
    scene.arrows.push_back(std::move(arrows));
}

void DiffusionLesson::draw_curve(Scene& scene) const {
    const Real top = rounded_up(std::max(u_.lpNorm<Eigen::Infinity>() / 1.2, scale()) / scale()) * scale();
    const Real L = length, up = curve_height * L / top;
    const auto at = [&](Index i) { return position((static_cast<Real>(i) + 0.5) * dx(), up * u_[i]); };
    scene.line(position(0, 0), position(L, 0), Ink::rest, 1);
    for (const Real end : {Real{0}, L}) {
        const bool wall = boundary != Boundary::periodic;
        scene.line(position(end, -0.23 * L), position(end, 0.23 * L), wall ? Ink::ground : Ink::rest, wall ? 4.0f : 1.5f, !wall);
    }
    for (const Real value : {-top, Real{0}, top})
        scene.label(position(0, up * value), format_quantity(value, "m/s"), Ink::text, -34, 0);
    Curve exact;
    exact_profile(exact);
    // Its pieces are shorter than a dash: some are left out.
    LineMarks solution{.ends = {}, .ink = Ink::rest, .width = 2};
    for (std::size_t k = 0; k + 1 < exact.position.size(); ++k)
        if (k / 3 % 2 == 0)
            for (const std::size_t e : {k, k + 1}) solution.ends.push_back(position(exact.position[e], up * exact.value[e]));
    scene.lines.push_back(std::move(solution));

    LineMarks curve{.ends = {}, .ink = Ink::velocity, .width = 2.5f};
    PointMarks points{.at = {}, .ink = Ink::velocity, .radius = 3};
    for (Index i = 0; i < lattice_.count[0]; ++i) {
        if (i > 0) curve.ends.push_back(at(i - 1)), curve.ends.push_back(at(i));
        if (lattice_.count[0] <= most_points || i == selected()[0]) points.at.push_back(at(i));
    }
    scene.lines.push_back(std::move(curve));
    scene.points.push_back(std::move(points));
    const Index i = selected()[0];
    scene.line(at(i), position(cell_middle({i, 0})[0], strip_high * L), Ink::accent, 1, true);
    scene.points.push_back({.at = {at(i)}, .ink = Ink::accent, .radius = 5});
}

// ----------------------------------------------------------------------------------------------------------- a square

void DiffusionLesson::draw_square(Scene& scene) const {
    const Real L = length;
    draw_cells(scene, position(0, 0), position(L, L));
    const bool wall = boundary != Boundary::periodic;
    scene.box(position(0, 0), position(L, L), wall ? Ink::ground : Ink::rest, wall ? 4.0f : 2.0f, !wall);
    draw_stencil(scene, {{1.95 * L, 0.5 * L}, {0.58 * L, 0.61 * L}, {0.24 * L, 0.22 * L}});
    scene.frame(position(-0.06 * L, -0.36 * L), position(2.83 * L, 1.36 * L));
}

// --------------------------------------------------------------------------------------------------------------- words

void DiffusionLesson::write_notes(Scene& scene) const {
    const auto text = [](Real x, const char* unit = "") { return format_quantity(x, unit, 3); };
    const char* limit_text = dims() == 1 ? "1/2" : "1/4";
    scene.notes.push_back(fmt::format("r = νΔt/Δx² = {},  {},  Δt = {}", text(rate()),
                                      !is_explicit()                    ? "no limit"
                                      : rate() <= limit() * (1 + 1e-12) ? fmt::format("within the limit {}", limit_text)
                                                                        : fmt::format("beyond the limit {}", limit_text),
                                      text(time_step(), "s")));
    scene.notes.push_back(formula_at_cell());
    if (modes_.vanishes(mode)) return scene.notes.push_back(fmt::format("mode {} is 0 in every cell", Index(mode)));
    const auto G = measured_factor();
    scene.notes.push_back(fmt::format("mode {}:  × {} in a step,  by theory {},  by the equation {}", Index(mode),
                                      G ? text(*G) : "–", text(theory(mode)), text(exact_factor(mode))));
}

// The step of the selected cell with its numbers: what the next one will make of it, or how the latest implicit one was met.
std::string DiffusionLesson::formula_at_cell() const {
    const Index c = selected_cell();
    const auto text = [](Real x) { return as_factor(std::round(x * 1e4) / 1e4 + Real{0}); };
    const auto plain = [&](Real x) { return fmt::format("{}", std::round(x * 1e4) / 1e4 + Real{0}); };
    VecX sums;
    diffusion_->stencil(u_, sums);
    const int count = 2 * dims();
    const Real beside = sums[c] + count * u_[c], r = rate();
    if (literal())
        return fmt::format("next:  u′ = νΔt (Σ − {}u) = {} ({} − {} · {}) = {}", count, format_quantity(r * dx() * dx(), "m²", 3),
                           text(beside), count, text(u_[c]), format_quantity(r * dx() * dx() * sums[c], "", 3));
    if (is_explicit())
        return fmt::format("next:  u′ = u + r (Σ − {}u) = {} + {} ({} − {} · {}) = {}", count, text(u_[c]),
                           format_quantity(r, "", 3), text(beside), count, text(u_[c]), plain(u_[c] + r * sums[c]));
    if (elapsed_[0] == 0) return fmt::format("to solve in every cell:  (1 + {}r) u′ − r Σ′ = u", count);
    return fmt::format("(1 + {}r) u′ − r Σ′ = {} · {} − {} · {} = {},  u was {}", count, format_quantity(1 + count * r, "", 3),
                       text(u_[c]), format_quantity(r, "", 3), text(beside), plain(u_[c] - r * sums[c]), plain(previous_[c]));
}

std::optional<UnstructuredGrid> DiffusionLesson::unstructured_grid() const {
    return regular_grid(Vec<3>::Zero(), Vec<3>::Constant(dx()), lattice_.count[0], lattice_.count[1], 0, {On::cell});
}

}  // namespace pliant::diffusion
