// The picture: the liquid up to its surface, its velocity, the tank with what stands in it, and a gauge of the volume.
#include "free_surface.h"
#include "kits/grid2d/grid_picture.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::free_surface {
namespace {

using std::numbers::pi;

constexpr float wall_width = 5;     // px
constexpr Real gauge_width = 0.03;  // of the tank's width
constexpr Real gauge_at = 1.07;     // of the tank's width
constexpr Index most_arrows = 26;   // along the longer side

}  // namespace

void FreeSurface::draw(Scene& picture) const {
    draw_liquid(picture);
    if (picture.show_arrows) {
        const VecX& phi = liquid_->distance();
        const auto wet = [&](const Vec<2>& x) {
            const Index i = std::clamp<Index>(static_cast<Index>(x[0] / dx()), 0, resolution - 1),
                        j = std::clamp<Index>(static_cast<Index>(x[1] / dx()), 0, rows() - 1);
            return phi[i + resolution * j] < 0;
        };
        grid2d::draw_velocity(picture, liquid_->grid(), fields_of_flow_.flow(), arrow_speed(), most_arrows, wet);
    }
    draw_start(picture);
    draw_tank(picture);
    draw_gauge(picture);
    write_notes(picture);
    const Real W = tank_width, H = tank_top(), margin = 0.06 * std::max(W, H);
    picture.frame(position(-margin, -margin), position((gauge_at + gauge_width) * W + margin, H + 1.6 * margin));
}

// The speed whose arrow is as long as the arrows are apart. It does not follow the flow, so that arrows compare over time.
Real FreeSurface::arrow_speed() const {
    const Real falling = 0.5 * std::sqrt(2 * gravity * tank_top());
    const Real waving = scene == Pouring::wave ? std::abs(wave_height) * wave_frequency() : pi * paddle_stroke / paddle_period;
    const Real speed = scene == Pouring::wave || scene == Pouring::paddle ? waving : falling;
    return speed > 0 ? speed : 1;
}

void FreeSurface::draw_liquid(Scene& picture) const {
    const Field* field = find_field(picture.colour_by.field);
    if (field && (field->on == On::x_face || field->on == On::y_face)) grid2d::draw_field(picture, *this, liquid_->grid());
    const bool over_field = !picture.grids.empty();
    grid2d::draw_liquid(picture, liquid_->grid(), liquid_->distance(),
                        over_field ? std::vector<float>() : picture.values(*this, On::cell));
    // Where numbers on faces fill the tank, of the liquid only its surface is drawn.
    if (over_field) picture.triangles.pop_back();
}

void FreeSurface::draw_tank(Scene& picture) const {
    const Real W = tank_width, H = tank_top();
    picture.box(position(0, 0), position(W, H), Ink::ground, wall_width);
    if (!has_paddle()) return;
    const Real left = paddle_place(time()) - 0.5 * paddle_width(), right = left + paddle_width();
    // In front of the liquid.
    const Real z = 0.01 * tank_width;
    TriangleMarks plate{.corners = {position(left, 0, z), position(right, 0, z), position(right, H, z), position(left, H, z)},
                        .triangles = {{0, 1, 2}, {0, 2, 3}},
                        .ink = Ink::ground};
    picture.triangles.push_back(std::move(plate));
    const Real U = paddle_speed(time()), fastest = pi * paddle_stroke / paddle_period;
    if (fastest > 0 && std::abs(U) > 0.05 * fastest) {
        const Real middle = 0.5 * (left + right);
        picture.arrow(position(middle, 1.08 * H), position(middle + 0.08 * W * U / fastest, 1.08 * H), Ink::accent, "paddle");
    }
}

// The outline of the liquid at the start, and what can be dragged.
void FreeSurface::draw_start(Scene& picture) const {
    const auto handle = [&](const Vec<2>& at) {
        picture.points.push_back(
            {.at = {position<2>(at)}, .ink = Ink::accent, .radius = 7, .pick = {.pickable = true, .on = On::handle}});
    };
    const Real a = column_width, h = column_height;
    if (scene == Pouring::column) {
        picture.line(position(0, h), position(a, h), Ink::rest, 2, true);
        picture.line(position(a, 0), position(a, h), Ink::rest, 2, true);
        handle({a, h});
        const Crossing at = front();
        if (picture.show_labels && at.fluid >= 0) {
            const Real x = at.place, tick = 0.025 * tank_top();
            picture.line(position(x, -tick), position(x, 0.5 * tick), Ink::accent, 3);
            picture.label(position(x, -tick), "x_f = " + format_quantity(x, "m", 3), Ink::accent, 0, 12);
        }
        return;
    }
    picture.line(position(0, depth), position(tank_width, depth), Ink::rest, 1.5f, true);
    if (scene != Pouring::wave) return;
    handle({0, depth + wave_height});
    if (!linear_wave(0, time())) return;
    LineMarks theory{.ends = {}, .ink = Ink::accent, .width = 2, .dashed = true};
    constexpr int pieces = 48;
    for (int k = 0; k < pieces; ++k)
        for (const int end : {k, k + 1}) {
            const Real x = tank_width * end / pieces;
            theory.ends.push_back(position(x, *linear_wave(x, time())));
        }
    picture.lines.push_back(std::move(theory));
    if (picture.show_labels)
        picture.label(position(tank_width, *linear_wave(tank_width, time())), "linear wave", Ink::accent, -50, -14);
}

// A tube beside the tank, filled to the part of the first volume that is there.
void FreeSurface::draw_gauge(Scene& picture) const {
    if (!(first_volume_ > 0)) return;
    const Real part = liquid_->volume() / first_volume_, W = tank_width, H = tank_top();
    const Real left = gauge_at * W, right = (gauge_at + gauge_width) * W, full = 0.75 * H;
    const Real level = std::min(full * part, H);
    TriangleMarks tube{.corners = {position(left, 0), position(right, 0), position(right, level), position(left, level)},
                       .triangles = {{0, 1, 2}, {0, 2, 3}},
                       .ink = Ink::body};
    picture.triangles.push_back(std::move(tube));
    picture.box(position(left, 0), position(right, H), Ink::ground, 2);
    picture.line(position(left - 0.01 * W, full), position(right + 0.01 * W, full), Ink::accent, 2);
    if (picture.show_labels)
        picture.label(position(0.5 * (left + right), H), fmt::format("V = {:.2f} %", 100 * part), Ink::text, -8, -12);
}

void FreeSurface::write_notes(Scene& picture) const {
    picture.notes.push_back(fmt::format("{} × {} cells, Δx = {}", Index(resolution), rows(), format_quantity(dx(), "m", 3)));
    if (scene == Pouring::column && column_width > 0) {
        const Real T = time() * std::sqrt(2 * gravity / column_width), Z = front().place / column_width;
        picture.notes.push_back(fmt::format("x_f / a = {:.2f} at t √(2g/a) = {:.2f}", Z, T));
    }
    if (scene == Pouring::wave && gravity > 0)
        picture.notes.push_back("linear theory: T = 2π / √(g k tanh k d) = " +
                                format_quantity(2 * pi / wave_frequency(), "s", 4));
    if (!keep_volume) picture.notes.push_back("nothing keeps the volume");
}

std::optional<UnstructuredGrid> FreeSurface::unstructured_grid() const { return grid2d::grid_of_cells(liquid_->grid()); }

}  // namespace pliant::free_surface
