#include "cloth.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::cloth {
namespace {

// Height of a sheet above the sphere at the start, in sides of the sheet.
constexpr Real gap = 0.02;
// Amplitude of the wave in a flag at the start, in sides of the sheet.
constexpr Real start_wave = 0.01;

}  // namespace

void ClothLesson::check() const {
    const Index count = nodes * nodes;
    if (implicit() && !iterative() && count > most_direct_nodes)
        throw Refused(
            fmt::format("linear_solver = direct with nodes = {} is not accepted: {} nodes make a matrix that takes too long "
                        "to factorise in every step; give at most {} nodes along a side, or conjugate_gradients",
                        Index(nodes), count, Index(std::sqrt(Real(most_direct_nodes)))));
}

// ------------------------------------------------------------------------------------------------------ the start

std::vector<Index> ClothLesson::held_nodes() const {
    const Index n = nodes;
    std::vector<Index> held;
    for (Index k = 0; k < n * n; ++k) {
        const Index i = k % n, j = k / n;
        const bool at_edge = j == n - 1;
        const bool hold = setting == Setting::hanging_corners ? at_edge && (i == 0 || i == n - 1)
                          : setting == Setting::hanging_edge  ? at_edge
                          : setting == Setting::flag          ? i == 0
                          : setting == Setting::pedestal      ? sheet_->rest().col(k).norm() <= sphere_radius
                                                              : false;
        if (hold) held.push_back(k);
    }
    return held;
}

// A flag stands upright at a pole, with a small wave in it so that it can fall out of its plane; all other sheets start level,
// and those that hang swing down about the line that is held.
Points<3> ClothLesson::start_positions() const {
    Points<3> x = sheet_->rest();
    if (setting == Setting::flag) {
        for (Index n = 0; n < x.cols(); ++n)
            x(2, n) = start_wave * size * std::sin(2 * std::numbers::pi * (x(0, n) / size + 0.5));
        return x;
    }
    x.row(2) = -x.row(1);
    x.row(1).setZero();
    return x;
}

Sphere ClothLesson::sphere() const {
    return {.centre = {0, -sphere_radius - gap * size, 0}, .radius = sphere_radius, .friction = friction};
}

Vec<3> ClothLesson::wind_at(Real t) const {
    const Real across = wind * gust * std::sin(2 * std::numbers::pi * t);
    return setting == Setting::flag ? Vec<3>(wind, 0, across) : Vec<3>(across, 0, wind);
}

void ClothLesson::reset() {
    integrator_.reset();
    system_.reset();
    limiter_.reset();
    rates_.forget();
    sheet_ = std::make_unique<ClothSheet>(nodes, size);
    const Index count = sheet_->rest().cols();
    for (Points<3>* values : {&position_, &velocity_, &spring_force_}) values->setZero(3, count);
    follow_parameters();
    position_ = start_positions();
    for (Points<3>* force : {&damping_force_, &external_force_, &wind_force_}) force->setZero();
    contact_force_.setZero(setting == Setting::drape ? count : 0);
    strain_.setZero(sheet_->springs().size());
    for (VecX* values : {&stretch_, &bending_, &held_, &imbalance_}) values->setZero(count);
    std::ranges::fill(drag_numbers_, Real{0});
    gust_time_[0] = gust_at_ = pace_[0] = pace_[1] = 0;
    touches_.assign(static_cast<std::size_t>(count), {});
    touching_ = 0;
    stretch_before_limiting_ = limiter_excess_ = 0;
}

const Registration<ClothLesson> registration{{.id = "mesh/cloth",
                                              .title = "Cloth",
                                              .summary = "A sheet of masses and springs hangs, flies as a flag or drapes over a "
                                                         "sphere, at sixty steps a second.",
                                              .demo_steps = 240}};

}  // namespace pliant::cloth
