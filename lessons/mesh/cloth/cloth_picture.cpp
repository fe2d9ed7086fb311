#include "cloth.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::cloth {

void ClothLesson::draw(Scene& picture) const {
    set_frame(picture);
    draw_sphere(picture);
    const Field* shown = find_field(picture.colour_by.field);
    draw_sheet(picture);
    if (shown && shown->on == On::edge) draw_springs(picture);
    draw_nodes(picture);
    draw_arrows(picture);
    write_notes(picture);
}

// The same corners from step to step.
void ClothLesson::set_frame(Scene& picture) const {
    const Real half = size / 2, radius = drapes() ? Real{sphere_radius} : Real{0};
    if (setting == Setting::flag)
        picture.frame(position(-0.8 * size, -0.75 * size, -0.3 * half), position(half, 0.9 * size, 0.3 * half));
    else if (drapes())
        picture.frame(position(-0.7 * half, -std::max(2 * radius, 0.62 * size), -0.7 * half),
                      position(0.7 * half, 0.25 * size, 0.7 * half));
    else
        picture.frame(position(-0.8 * half, -1.02 * size, -0.5 * half), position(0.8 * half, 0.33 * size, 0.5 * half));
}

void ClothLesson::draw_sheet(Scene& picture) const {
    TriangleMarks sheet{.corners = {}, .triangles = {}, .values = picture.values(*this, On::node), .ink = Ink::body};
    for (Index n = 0; n < position_.cols(); ++n) sheet.corners.push_back(position<3>(position_.col(n)));
    for (const auto& [a, b, c] : sheet_->triangles()) sheet.triangles.push_back({int(a), int(b), int(c)});
    picture.triangles.push_back(std::move(sheet));

    // The threads, so that folds can be seen: about 24 each way.
    const Index n = sheet_->nodes(), every = std::max<Index>(1, n / 24);
    LineMarks threads{.ends = {}, .ink = Ink::edge, .width = 1};
    for (Index k = 0; k < n; ++k) {
        if (k % every != 0 && k != n - 1) continue;
        for (Index i = 0; i + 1 < n; ++i) {
            for (const auto& [a, b] :
                 {std::pair{sheet_->node(i, k), sheet_->node(i + 1, k)}, std::pair{sheet_->node(k, i), sheet_->node(k, i + 1)}}) {
                threads.ends.push_back(position<3>(position_.col(a)));
                threads.ends.push_back(position<3>(position_.col(b)));
            }
        }
    }
    picture.lines.push_back(std::move(threads));
}

// Springs to the next node but one lie on the structural ones, and so are drawn below them.
void ClothLesson::draw_springs(Scene& picture) const {
    const std::vector<float> values = picture.values(*this, On::edge);
    const Springs& springs = sheet_->springs();
    constexpr std::array<float, family_count> widths{3, 1.5f, 1};
    for (const Family family : {bending, shear, structural}) {
        LineMarks marks{.ends = {}, .ink = Ink::edge, .width = widths[family], .pick = {.pickable = true, .on = On::edge}};
        marks.pick.first = sheet_->first(family);
        for (Index s = sheet_->first(family); s < sheet_->last(family); ++s) {
            marks.ends.push_back(position<3>(position_.col(springs.i(s))));
            marks.ends.push_back(position<3>(position_.col(springs.j(s))));
        }
        if (!values.empty()) marks.values.assign(values.begin() + sheet_->first(family), values.begin() + sheet_->last(family));
        picture.lines.push_back(std::move(marks));
    }
}

void ClothLesson::draw_nodes(Scene& picture) const {
    PointMarks all{.at = {},
                   .values = picture.values(*this, On::node),
                   .ink = Ink::body,
                   .radius = sheet_->nodes() > 40 ? 1.0f : 1.8f,
                   .pick = {.pickable = true, .on = On::node}};
    PointMarks fixed{.at = {}, .ink = Ink::fixed, .radius = 5};
    for (Index n = 0; n < position_.cols(); ++n) {
        all.at.push_back(position<3>(position_.col(n)));
        if (sheet_->inertia().fixed(3 * n) && setting != Setting::pedestal) fixed.at.push_back(all.at.back());
    }
    picture.points.push_back(std::move(all));
    if (!fixed.at.empty()) picture.points.push_back(std::move(fixed));
}

// The sphere, a little smaller so that the sheet is in front of it; or the disc with its stand.
void ClothLesson::draw_sphere(Scene& picture) const {
    if (setting == Setting::flag)
        picture.line(position(-size / 2, -0.8 * size, 0), position(-size / 2, 0.55 * size, 0), Ink::fixed, 4);
    if (!drapes() || !(sphere_radius > 0)) return;
    constexpr int around = 32, down = 16;
    const bool disc = setting == Setting::pedestal;
    // By as much as the middle of a cell on the sphere lies inside of it.
    const Real sagitta = sheet_->cell() * sheet_->cell() / (4 * sphere_radius);
    const Real radius = disc ? Real{sphere_radius} : sphere_radius - 0.004 * size - sagitta;
    if (!(radius > 0)) return;
    TriangleMarks ball{.corners = {}, .triangles = {}, .ink = Ink::ground};
    const Real pi = std::numbers::pi;
    for (int j = 0; j <= down; ++j)
        for (int i = 0; i < around; ++i) {
            const Real phi = 2 * pi * i / around, theta = pi * j / down;
            // A flat cylinder in the drape test, a tenth as thick as wide.
            const Vec<3> at = disc ? Vec<3>(std::min<Real>(1, 2 * std::sin(theta)) * radius * std::cos(phi),
                                            -0.01 * size - 0.05 * radius * (1 - std::cos(theta)),
                                            std::min<Real>(1, 2 * std::sin(theta)) * radius * std::sin(phi))
                                   : Vec<3>(sphere().centre + radius * Vec<3>(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                                              std::sin(theta) * std::sin(phi)));
            ball.corners.push_back(position<3>(at));
            if (j == down) continue;
            const int a = j * around + i, b = j * around + (i + 1) % around;
            ball.triangles.push_back({a, a + around, b});
            ball.triangles.push_back({b, a + around, b + around});
        }
    picture.triangles.push_back(std::move(ball));
    if (disc) picture.line(position(0, -0.05 * size, 0), position(0, -0.55 * size, 0), Ink::ground, 5);
}

void ClothLesson::draw_arrows(Scene& picture) const {
    if (picture.show_arrows && in_air() && wind != 0) {
        const Vec<3> w = wind_at(gust_time_[0]);
        const Vec<3> along = w.norm() > 0 ? Vec<3>(0.3 * size * w / w.norm()) : Vec<3>(Vec<3>::Zero());
        for (const Real height : {0.35, 0.0, -0.35}) {
            const Vec<3> at = setting == Setting::flag ? Vec<3>(-0.85 * size, height * size, 0)
                                                       : Vec<3>(0, (height - 0.5) * size, -0.75 * size);
            picture.arrow(position<3>(at), position<3>(at + along), Ink::velocity);
            if (height == -0.35)
                picture.label(position<3>(at), "w = " + format_quantity(w.norm(), "m/s", 3), Ink::velocity, -24, 16);
        }
    }
    if (!pulled()) return;
    const Vec<3> from = position_.col(load_.pull.node), to = load_.pull.target;
    picture.arrow(position<3>(from), position<3>(to), Ink::force, format_quantity(pull_stiffness * (to - from).norm(), "N", 3));
}

void ClothLesson::write_notes(Scene& picture) const {
    picture.notes.push_back(fmt::format("{0} × {0} nodes, {1} springs", sheet_->nodes(), sheet_->springs().size()));
    picture.notes.push_back(fmt::format("kₛ : k_d : k_b = {} : {} : {} N/m", format_quantity(k_structural, "", 3),
                                        format_quantity(k_shear, "", 3), format_quantity(k_bending, "", 3)));
    const Real stretched = largest_stretch(sheet_->springs(), sheet_->last(structural), position_);
    picture.notes.push_back(fmt::format("largest stretch {:.1f} %", 100 * std::max(stretched, Real{0})));
    if (const auto coefficient = drape_coefficient())
        picture.notes.push_back(fmt::format("area seen from above {:.0f} %", 100 * *coefficient));
    const std::string step = fmt::format("Δt = {}", format_quantity(dt, "s", 3));
    if (!implicit()) {
        picture.notes.push_back(fmt::format("{} {} {}, the stability limit", step, dt <= stable_time_step() ? "≤" : ">",
                                            format_quantity(stable_time_step(), "s", 3)));
    } else if (solver() && !solver()->converged()) {
        picture.notes.push_back(
            fmt::format("{}, unbalanced ≤ {}", step, format_quantity(imbalance_.cwiseAbs().maxCoeff(), "N", 3)));
    } else {
        picture.notes.push_back(step + (solver() ? ", solved" : ", implicit"));
    }
}

}  // namespace pliant::cloth
