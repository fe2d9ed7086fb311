// Curves of all schemes: energy over time, growth over the step, error over the step and over the work.
#include "integration.h"

#include <algorithm>
#include <cmath>

namespace pliant::integration {
namespace {

constexpr Real most_beside = 4;  // E/E₀
constexpr int halvings = 8, samples = 97;
constexpr std::size_t most_points = 600;  // of a curve over time

using Sample = std::function<void(const IntegrationLesson&, Scheme, Curve&)>;

// The run's own curve, the exact one where there is one, and those of the schemes beside it.
Line of_all_schemes(const IntegrationLesson& l, Line line, const Sample& sample) {
    line.sample = [&l, sample](Curve& c) { sample(l, l.scheme, c); };
    for (const SchemeInfo& info : schemes())
        line.others.push_back({.name = info.name, .sample = [&l, sample, one = info.scheme](Curve& c) {
                                   if (l.compared(one) && one != l.scheme) sample(l, one, c);
                               }});
    return line;
}

void energy_curve(const IntegrationLesson& l, Scheme one, Curve& curve) {
    const SchemePath& path = l.path_of(one);
    const auto steps = std::min(path.energy.size(), static_cast<std::size_t>(l.counts_[0]) + 1);
    const std::size_t stride = (steps + most_points - 1) / most_points;
    if (path.energy[0] == 0) return;
    for (std::size_t n = 0; n < steps; n += stride) {
        // A l.scheme that blows up beside the run must not squeeze it.
        const Real share = path.energy[n] / path.energy[0];
        if (one != l.scheme && share > most_beside) break;
        curve.add(static_cast<Real>(n) * l.dt, share);
    }
}

// As far as it does not squeeze the other curves.
void growth_curve(const IntegrationLesson& l, Scheme one, Curve& curve) {
    constexpr Real outside = 2.5;
    for (int k = 0; k < samples; ++k) {
        const Real step = 3.2 / l.motion_->fast_rate() * k / (samples - 1);
        const Real rho = amplification(one, l.motion_->fast_rate(), l.zeta, step);
        if (rho > outside) break;
        curve.add(step, rho);
    }
}

}  // namespace

const SchemePath& IntegrationLesson::path_of(Scheme one) const {
    paths_.follow(motion_->options(), newton(), dt, watched());
    return paths_.of(one, static_cast<Index>(counts_[0]));
}

const ErrorCurve& IntegrationLesson::errors_of(Scheme one) const {
    Errors& known = errors_[static_cast<std::size_t>(one)];
    const NewtonOptions options = newton();
    const bool same = known.curve && known.options == motion_->options() && known.newton.relative_step == options.relative_step &&
                      known.newton.max_iterations == options.max_iterations;
    if (!same) known = {motion_->options(), options, error_curve(motion_->options(), method(one), halvings)};
    return *known.curve;
}

void IntegrationLesson::declare_lines() {
    Line energies{.name = "energy_of_all",
                  .position_name = "t",
                  .position_unit = "s",
                  .help = "energy of the run and of the schemes beside it, as a multiple of that at the start",
                  .sample = {},
                  .reference =
                      [this](Curve& c) {
                          const auto start = motion_->exact_energy(0);
                          if (!start || *start == 0) return;
                          for (int k = 0; k < samples; ++k) {
                              const Real t = time() * k / (samples - 1);
                              if (const auto e = motion_->exact_energy(t)) c.add(t, *e / *start);
                          }
                      },
                  .value_name = "E/E₀"};
    Line growth{.name = "growth_over_step",
                .position_name = "Δt",
                .position_unit = "s",
                .help = "by which each scheme multiplies the motion in a step, over Δt; the exact motion keeps or loses",
                .sample = {},
                .reference =
                    [this](Curve& c) {
                        const Real w = motion_->fast_rate(),
                                   slow = zeta > 1 ? 1 / (zeta + std::sqrt(zeta * zeta - 1)) : Real(zeta);
                        c.add_range(0, 3.2 / w, samples, [=](Real step) { return std::exp(-slow * w * step); });
                    },
                .value_name = "factor ρ of a step",
                .used = [this] { return omega > 0; }};
    Line over_step{
        .name = "error_over_step",
        .position_name = "Δt",
        .position_unit = "s",
        .help = "error at a fixed time, as a part of the swing, in runs with ever smaller steps: the slope is the order",
        .sample = {},
        .value_name = "error",
        .log_log = true,
        .used = [this] { return omega > 0; }};
    Line over_cost = over_step;
    over_cost.name = "error_over_cost";
    over_cost.position_name = "force evaluations";
    over_cost.position_unit = "";
    over_cost.help = "the same errors over the work: force evaluations, and Newton iterations of implicit schemes";
    lines = {of_all_schemes(*this, std::move(energies), energy_curve), of_all_schemes(*this, std::move(growth), growth_curve),
             of_all_schemes(*this, std::move(over_step),
                            [](const IntegrationLesson& l, Scheme one, Curve& c) {
                                c = {l.errors_of(one).dt, l.errors_of(one).error};
                            }),
             of_all_schemes(*this, std::move(over_cost), [](const IntegrationLesson& l, Scheme one, Curve& c) {
                 c = {l.errors_of(one).cost, l.errors_of(one).error};
             })};
    lines[1].others.push_back({"measured now",
                               [this](Curve& c) {
                                   if (const auto rho = measured_growth()) c = {{Real(dt)}, {*rho}};
                               },
                               true});
    lines[2].others.push_back({"error now",
                               [this](Curve& c) {
                                   if (const auto e = error(); e && *e > 0) c = {{Real(dt)}, {*e}};
                               },
                               true});
}

}  // namespace pliant::integration
