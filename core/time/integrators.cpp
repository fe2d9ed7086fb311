#include <pliant/math/error.h>
#include <pliant/time/integrators.h>

#include <cmath>

namespace pliant {

void require_time_step(Real dt) {
    if (!(dt > 0) || !std::isfinite(dt)) throw Refused("time_step", dt, "s", "a finite time > 0");
}

void explicit_euler(Real dt, const DiagonalMass& mass, ConstDofs f, Dofs x, Dofs v) {
    require_time_step(dt);
    x += dt * v;
    v += dt * mass.inverse().cwiseProduct(f);
}

void semi_implicit_euler(Real dt, const DiagonalMass& mass, ConstDofs f, Dofs x, Dofs v) {
    require_time_step(dt);
    v += dt * mass.inverse().cwiseProduct(f);
    x += dt * v;
}

void implicit_euler(Real dt, ConstDofs x, ConstDofs v, ImplicitForm& form) {
    require_time_step(dt);
    form.velocity_rate = 1 / dt;
    form.acceleration_rate = 1 / (dt * dt);
    form.velocity_origin = x;
    form.acceleration_origin = x + dt * v;
}

}  // namespace pliant
