#include <pliant/time/scheme_runs.h>

#include <pliant/math/line_fit.h>

#include <algorithm>
#include <cmath>

namespace pliant {

SchemeRun::SchemeRun(const SwingingOptions& options, const SchemeMethod& method)
    : system_(options),
      mass_(VecX::Ones(system_.size()), 1),
      integrator_(system_, mass_, method.scheme, method.newton),
      x_(system_.start_position()),
      v_(system_.start_velocity()) {}

bool SchemeRun::step(Real dt) {
    const Index before = integrator_.force_evaluations();
    try {
        integrator_.step(dt, x_, v_);
    } catch (const Diverged&) {
        return false;
    }
    cost_ += is_implicit(integrator_.scheme()) ? integrator_.passes() : integrator_.force_evaluations() - before;
    return v_.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= blown_up * system_.top_speed();
}

void SchemePaths::follow(const SwingingOptions& options, NewtonOptions newton, Real dt, Index mass) {
    if (options == options_ && dt == dt_ && mass == mass_ && newton.relative_step == newton_.relative_step &&
        newton.max_iterations == newton_.max_iterations)
        return;
    options_ = options, newton_ = newton, dt_ = dt, mass_ = mass;
    runs_ = {};
}

const SchemePath& SchemePaths::of(Scheme scheme, Index steps) {
    auto& [run, path] = runs_[static_cast<std::size_t>(scheme)];
    const auto note = [this, &run = run, &path = path] {
        path.motion.push_back({run->position()[mass_], run->velocity()[mass_]});
        path.energy.push_back(run->system().energy(run->position(), run->velocity()));
    };
    if (!run) {
        run = std::make_unique<SchemeRun>(options_, SchemeMethod{scheme, newton_});
        note();
    }
    const auto wanted = static_cast<std::size_t>(std::min(steps, longest)) + 1;
    while (!path.ended && path.motion.size() < wanted) {
        if (run->step(dt_))
            note();
        else
            path.ended = true;
    }
    return path;
}

ErrorCurve error_curve(const SwingingOptions& options, const SchemeMethod& method, int halvings) {
    ErrorCurve curve;
    const Swinging system(options);
    if (options.omega == 0 || !system.exact(0, 0)) return curve;
    // Four radians of the slow motion, but no more than twelve of the fast one: no whole number of half periods, where errors of
    // symplectic schemes happen to cancel.
    const Real rate = system.fast_rate() * std::max(Real{1}, options.zeta);
    const Real end = std::min(4 / system.slow_rate(), 12 / rate);
    const auto coarsest = static_cast<Index>(std::ceil(1.25 * end * rate));
    for (int k = 0; k < halvings; ++k) {
        const Index steps = coarsest << k;
        const Real dt = end / static_cast<Real>(steps);
        SchemeRun run(options, method);
        bool sound = true;
        for (Index n = 0; sound && n < steps; ++n) sound = run.step(dt);
        if (!sound) continue;
        Real error = 0;
        for (Index mass = 0; mass < system.size(); ++mass) {
            const Motion exact = *system.exact(mass, end);
            error = std::max(error,
                             std::hypot(run.position()[mass] - exact.x, (run.velocity()[mass] - exact.v) / system.slow_rate()) /
                                 system.scale());
        }
        curve.dt.push_back(dt);
        curve.error.push_back(error);
        curve.cost.push_back(static_cast<Real>(run.cost()));
    }
    return curve;
}

std::optional<Real> measured_order(const ErrorCurve& curve) {
    constexpr Real rounding = 1e-11, small = 0.1;
    std::vector<Real> log_dt, log_error;
    for (std::size_t k = 0; k < curve.dt.size(); ++k) {
        if (curve.error[k] < rounding || curve.error[k] > small) continue;
        log_dt.push_back(std::log(curve.dt[k]));
        log_error.push_back(std::log(curve.error[k]));
    }
    const std::size_t use = std::min<std::size_t>(3, log_dt.size());
    const auto fit = fit_line(std::span(log_dt).last(use), std::span(log_error).last(use));
    return fit ? std::optional(fit->slope) : std::nullopt;
}

}  // namespace pliant
