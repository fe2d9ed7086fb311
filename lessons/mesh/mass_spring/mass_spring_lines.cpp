// Curves: a rotation that dampers brake, moduli and couplings of a static test, the mode of a chain.
#include "mass_spring.h"

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {

// What naive damping leaves of the angular momentum of a rigid body that turns about the vertical: exp(-lambda t), with
// lambda = k_d sum of the squared distances between the ends of the springs, seen from above, over the moment of inertia.
std::optional<Real> MassSpringLesson::rotation_after(Real t) const {
    const Points<3>& rest = block_->rest();
    const auto level = [](const Vec<3>& r) { return r[0] * r[0] + r[2] * r[2]; };
    Real spread = 0, inertia = 0;
    const Vec<3> centre = rest.rowwise().mean();
    for (Index s = 0; s < block_->springs().size(); ++s)
        spread += level(rest.col(block_->springs().j(s)) - rest.col(block_->springs().i(s)));
    for (Index n = 0; n < rest.cols(); ++n) inertia += block_->mass()[n] * level(rest.col(n) - centre);
    return start_angular_momentum_ * std::exp(inertia > 0 ? -damping * spread / inertia * t : 0);
}

void MassSpringLesson::declare_lines() {
    const auto to_now = [this](Curve& curve, const std::function<Real(Real)>& value) {
        const Real end = std::max(clock_[0], Real{1});
        for (int n = 0; n <= 60; ++n) {
            const Real t = end * n / 60;
            curve.position.push_back(t);
            curve.value.push_back(value(t));
        }
    };
    const auto spins = [this] { return setting == Setting::spin && start_angular_momentum_ > 0; };
    const auto coupling = [this](Curve& curve, BlockTest row) {
        if (!test_done_) return;
        curve.position = {1, 2, 3};
        for (int family = 0; family < spring_families; ++family)
            curve.value.push_back(tests_.coupling()(static_cast<int>(row), family));
    };
    lines = {
        {.name = "rotation",
         .unit = "kg m²/s",
         .position_name = "t",
         .position_unit = "s",
         .help = "angular momentum of a rigid body that turns: what naive dampers leave, what projected ones do, and this run",
         .sample = [this, to_now](Curve& c) { to_now(c, [this](Real t) { return *rotation_after(t); }); },
         .reference = [this, to_now](Curve& c) { to_now(c, [this](Real) { return start_angular_momentum_; }); },
         .reference_name = "projected dampers",
         .value_name = "naive dampers",
         .used = spins,
         .others = {{.name = "this run",
                     .sample =
                         [this](Curve& c) {
                             c.position.push_back(clock_[0]);
                             c.value.push_back(*probe("angular_momentum").value());
                         },
                     .points = true}}},
        {.name = "modulus_by_cells",
         .unit = "",
         .position_name = "cells along each axis",
         .help = "Young's modulus of pieces of this lattice over that of the endless one: what more cells change",
         .sample =
             [this](Curve& c) {
                 for (const Real ratio : tests_.modulus_by_cells()) {
                     c.position.push_back(Real(c.position.size() + 1));
                     c.value.push_back(ratio);
                 }
             },
         .reference =
             [](Curve& c) {
                 c.position = {1, Real(StaticTests::most_cells)};
                 c.value = {1, 1};
             },
         .reference_name = "endless lattice",
         .value_name = "E/E of the endless lattice",
         .used = [this] { return tested() && lattice() != LatticeKind::chain; }},
        {.name = "coupling",
         .unit = "",
         .position_name = "1 structural, 2 shear, 3 bending",
         .help = "∂ ln K/∂ ln k: what one per cent more of a family's stiffness changes, in per cent, of each test",
         .sample = [coupling](Curve& c) { coupling(c, BlockTest::stretch); },
         .reference = [coupling](Curve& c) { coupling(c, BlockTest::shear); },
         .reference_name = "shear",
         .value_name = "stretch",
         .reference_points = true,
         .used = [this] { return tested() && lattice() != LatticeKind::chain; },
         .others = {{.name = "bend", .sample = [coupling](Curve& c) { coupling(c, BlockTest::bend); }, .points = true}}},
        {.name = "mode",
         .unit = "m",
         .position_name = "mass",
         .help = "displacement of each mass of a swinging chain, from the top, and where it began",
         .sample =
             [this](Curve& c) {
                 for (Index n = position_.cols() - 1; n >= 0; --n) {
                     c.position.push_back(Real(cells_y - n));
                     c.value.push_back(position_(1, n) - block_->rest()(1, n));
                 }
             },
         .reference =
             [this](Curve& c) {
                 for (Index n = position_.cols() - 1; n >= 0; --n) {
                     c.position.push_back(Real(cells_y - n));
                     c.value.push_back(swing_amplitude * edge() * mode_shape(n));
                 }
             },
         .reference_name = "start",
         .value_name = "displacement",
         .used = [this] { return setting == Setting::swing; }}};
}

}  // namespace pliant::mass_spring
