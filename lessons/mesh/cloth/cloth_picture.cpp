#include "cloth.h"
#include "kits/springs/net_picture.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::cloth {
namespace {

// The same corners from step to step.
void set_frame(const ClothLesson& l, Scene& picture) {
    const Real half = l.size / 2, radius = l.drapes() ? Real{l.sphere_radius} : Real{0};
    if (l.setting == Setting::flag)
        picture.frame(position(-0.8 * l.size, -0.75 * l.size, -0.3 * half), position(half, 0.9 * l.size, 0.3 * half));
    else if (l.drapes())
        picture.frame(position(-0.7 * half, -std::max(2 * radius, 0.62 * l.size), -0.7 * half),
                      position(0.7 * half, 0.25 * l.size, 0.7 * half));
    else
        picture.frame(position(-0.8 * half, -1.02 * l.size, -0.5 * half), position(0.8 * half, 0.33 * l.size, 0.5 * half));
}

void draw_sheet(const ClothLesson& l, Scene& picture) {
    springs::draw_surface(picture, l, l.position_, l.sheet_->triangles());
    // The threads, so that folds can be seen: about 24 each way.
    const Index n = l.sheet_->nodes(), every = std::max<Index>(1, n / 24);
    std::vector<NodePair> threads;
    for (Index k = 0; k < n; ++k) {
        if (k % every != 0 && k != n - 1) continue;
        for (Index i = 0; i + 1 < n; ++i)
            threads.insert(threads.end(), {NodePair{l.sheet_->node(i, k), l.sheet_->node(i + 1, k)},
                                           NodePair{l.sheet_->node(k, i), l.sheet_->node(k, i + 1)}});
    }
    springs::draw_pairs(picture, l.position_, threads, 1);
}

// The sphere, a little smaller so that the sheet is in front of it; or the disc with its stand.
void draw_sphere(const ClothLesson& l, Scene& picture) {
    if (l.setting == Setting::flag)
        picture.line(position(-l.size / 2, -0.8 * l.size, 0), position(-l.size / 2, 0.55 * l.size, 0), Ink::fixed, 4);
    if (!l.drapes() || !(l.sphere_radius > 0)) return;
    constexpr int around = 32, down = 16;
    const bool disc = l.setting == Setting::pedestal;
    // By as much as the middle of a cell on the sphere lies inside of it.
    const Real sagitta = l.sheet_->cell() * l.sheet_->cell() / (4 * l.sphere_radius);
    const Real radius = disc ? Real{l.sphere_radius} : l.sphere_radius - 0.004 * l.size - sagitta;
    if (!(radius > 0)) return;
    TriangleMarks ball{.corners = {}, .triangles = {}, .ink = Ink::ground};
    const Real pi = std::numbers::pi;
    for (int j = 0; j <= down; ++j)
        for (int i = 0; i < around; ++i) {
            const Real phi = 2 * pi * i / around, theta = pi * j / down;
            // A flat cylinder in the drape test, a tenth as thick as wide.
            const Vec<3> at = disc ? Vec<3>(std::min<Real>(1, 2 * std::sin(theta)) * radius * std::cos(phi),
                                            -0.01 * l.size - 0.05 * radius * (1 - std::cos(theta)),
                                            std::min<Real>(1, 2 * std::sin(theta)) * radius * std::sin(phi))
                                   : Vec<3>(l.sphere().centre + radius * Vec<3>(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                                                std::sin(theta) * std::sin(phi)));
            ball.corners.push_back(position<3>(at));
            if (j == down) continue;
            const int a = j * around + i, b = j * around + (i + 1) % around;
            ball.triangles.push_back({a, a + around, b});
            ball.triangles.push_back({b, a + around, b + around});
        }
    picture.triangles.push_back(std::move(ball));
    if (disc) picture.line(position(0, -0.05 * l.size, 0), position(0, -0.55 * l.size, 0), Ink::ground, 5);
}

void draw_arrows(const ClothLesson& l, Scene& picture) {
    if (picture.show_arrows && l.in_air() && l.wind != 0) {
        const Vec<3> w = l.wind_at(l.gust_time_[0]);
        const Vec<3> along = w.norm() > 0 ? Vec<3>(0.3 * l.size * w / w.norm()) : Vec<3>(Vec<3>::Zero());
        for (const Real height : {0.35, 0.0, -0.35}) {
            const Vec<3> at = l.setting == Setting::flag ? Vec<3>(-0.85 * l.size, height * l.size, 0)
                                                         : Vec<3>(0, (height - 0.5) * l.size, -0.75 * l.size);
            picture.arrow(position<3>(at), position<3>(at + along), Ink::velocity);
            if (height == -0.35)
                picture.label(position<3>(at), "w = " + format_quantity(w.norm(), "m/s", 3), Ink::velocity, -24, 16);
        }
    }
    springs::draw_pull(picture, l.load_.pull, l.pull_stiffness, l.position_);
}

void write_notes(const ClothLesson& l, Scene& picture) {
    picture.notes.push_back(fmt::format("{0} × {0} nodes, {1} springs", l.sheet_->nodes(), l.sheet_->springs().size()));
    picture.notes.push_back(fmt::format("kₛ : k_d : k_b = {} : {} : {} N/m", format_quantity(l.k_structural, "", 3),
                                        format_quantity(l.k_shear, "", 3), format_quantity(l.k_bending, "", 3)));
    const Real stretched = largest_stretch(l.sheet_->springs(), l.sheet_->last(structural), l.position_);
    picture.notes.push_back(fmt::format("largest stretch {:.1f} %", 100 * std::max(stretched, Real{0})));
    if (const auto coefficient = l.drape_coefficient())
        picture.notes.push_back(fmt::format("area seen from above {:.0f} %", 100 * *coefficient));
    const std::string step = fmt::format("Δt = {}", format_quantity(l.dt, "s", 3));
    if (!l.implicit()) {
        picture.notes.push_back(fmt::format("{} {} {}, the stability limit", step, l.dt <= l.stable_time_step() ? "≤" : ">",
                                            format_quantity(l.stable_time_step(), "s", 3)));
    } else if (l.solver() && !l.solver()->converged()) {
        picture.notes.push_back(
            fmt::format("{}, unbalanced ≤ {}", step, format_quantity(l.imbalance_.cwiseAbs().maxCoeff(), "N", 3)));
    } else {
        picture.notes.push_back(step + (l.solver() ? ", solved" : ", implicit"));
    }
}

}  // namespace

void ClothLesson::draw(Scene& picture) const {
    set_frame(*this, picture);
    draw_sphere(*this, picture);
    const Field* shown = find_field(picture.colour_by.field);
    draw_sheet(*this, picture);
    if (shown && shown->on == On::edge) springs::draw_springs(picture, *this, sheet_->springs(), position_, sheet_->families());
    springs::draw_nodes(picture, *this, sheet_->inertia(), position_, sheet_->nodes() > 40 ? 1.0f : 1.8f,
                        setting == Setting::pedestal ? 0 : 5);
    draw_arrows(*this, picture);
    write_notes(*this, picture);
}

std::optional<UnstructuredGrid> ClothLesson::unstructured_grid() const {
    return springs::grid_of_springs(sheet_->springs(), position_);
}

}  // namespace pliant::cloth
