#include <pliant/math/error.h>
#include <pliant/time/integrators.h>

#include <cmath>

namespace pliant {

void require_time_step(Real dt) {
    if (!(dt > 0) || !std::isfinite(dt)) throw Refused("time_step", dt, "s", "a finite time > 0");
}

void implicit_euler(Real dt, ConstDofs x, ConstDofs v, ImplicitForm& form) {
    require_time_step(dt);
    form.velocity_rate = 1 / dt;
    form.acceleration_rate = 1 / (dt * dt);
    form.velocity_origin = x;
    form.acceleration_origin = x + dt * v;
    form.frozen_at = x;
}

void implicit_midpoint(Real dt, ConstDofs x, ConstDofs v, ImplicitForm& form) {
    implicit_euler(dt / 2, x, v, form);
    form.frozen_at = form.acceleration_origin;
}

void newmark(Real dt, ConstDofs x, ConstDofs v, const VecX& a, ImplicitForm& form) {
    require_time_step(dt);
    form.acceleration_rate = 4 / (dt * dt);
    form.acceleration_origin = x + dt * v + dt * dt / 4 * a;
    // v' = v + dt/2 (a + a') with a' = rate (x' - origin), written as a rate times x' less another origin.
    form.velocity_rate = 2 / dt;
    form.velocity_origin = x + dt / 2 * v;
    form.frozen_at = form.velocity_origin;
}

void bdf2(Real dt, Real dt_before, ConstDofs x, ConstDofs v, ConstDofs x_before, ConstDofs v_before, ImplicitForm& form) {
    require_time_step(dt);
    const Real r = dt / dt_before, now = (1 + r) * (1 + r) / (1 + 2 * r), before = r * r / (1 + 2 * r);
    const Real step = dt * (1 + r) / (1 + 2 * r);
    form.velocity_rate = 1 / step;
    form.velocity_origin = now * x - before * x_before;
    form.acceleration_rate = 1 / (step * step);
    form.acceleration_origin = form.velocity_origin + step * (now * v - before * v_before);
    form.frozen_at = x + dt * v;
}

}  // namespace pliant
