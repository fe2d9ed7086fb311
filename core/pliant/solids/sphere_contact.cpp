#include <pliant/math/error.h>
#include <pliant/solids/sphere_contact.h>

#include <algorithm>
#include <cmath>

namespace pliant {

void require_valid(const Sphere& sphere) {
    if (!sphere.centre.allFinite()) throw Refused("sphere centre: give a finite place in m");
    if (!(sphere.radius >= 0) || !std::isfinite(sphere.radius))
        throw Refused("sphere radius", sphere.radius, "m", "a finite number >= 0");
    if (!(sphere.friction >= 0) || !std::isfinite(sphere.friction))
        throw Refused("friction", sphere.friction, "", "a finite number >= 0");
}

void rest_on_sphere(const Sphere& sphere, const DiagonalMass& mass, Real dt, PointsIn<3> x, PointsIn<3> v, const VecX& pressed,
                    Real stiffness, NodalTerms<3>& terms) {
    for (Index n = 0; n < x.cols(); ++n) {
        if (mass.fixed(3 * n)) continue;
        const Vec<3> from_centre = x.col(n) - sphere.centre;
        const Real distance = from_centre.norm();
        const bool enters = (from_centre + dt * v.col(n)).norm() < sphere.radius;
        if (distance == 0 || !(pressed[n] > 0 || enters)) continue;
        const Vec<3> normal = from_centre / distance;
        terms.planes.push_back({n, normal, normal.dot(sphere.centre) + sphere.radius, stiffness});
        const Vec<3> along = v.col(n) - normal.dot(v.col(n)) * normal;
        const Real drag = sphere.friction * pressed[n] / std::max(along.norm(), creep_speed);
        if (drag == 0) continue;
        if (terms.drag.empty()) terms.drag.assign(static_cast<std::size_t>(x.cols()), Mat<3>::Zero());
        terms.drag[static_cast<std::size_t>(n)] += drag * (Mat<3>::Identity() - normal * normal.transpose());
    }
}

void plane_forces(const std::vector<NodePlane<3>>& planes, PointsIn<3> x, VecX& held) {
    held.setZero(x.cols());
    for (const NodePlane<3>& plane : planes) held[plane.node] = std::max(plane.force(x.col(plane.node)), Real(0));
}

Index resolve_sphere_contact(const Sphere& sphere, const DiagonalMass& mass, Real dt, const VecX& held, PointsOut<3> x,
                             PointsOut<3> v, VecX& pressed, std::vector<SphereTouch>& touches) {
    touches.assign(static_cast<std::size_t>(x.cols()), {});
    pressed = held;
    Index touching = 0;
    for (Index n = 0; n < x.cols(); ++n) {
        SphereTouch& touch = touches[static_cast<std::size_t>(n)];
        const Vec<3> from_centre = x.col(n) - sphere.centre;
        const Real distance = from_centre.norm();
        touch.held = held[n] > 0;
        touch.inside = distance < sphere.radius && !mass.fixed(3 * n);
        if (!touch.any()) continue;
        ++touching;
        touch.centred = distance == 0;
        const Vec<3> normal = touch.centred ? Vec<3>::UnitY() : Vec<3>(from_centre / distance);
        if (touch.inside) x.col(n) = sphere.centre + sphere.radius * normal;
        const Real impact = std::max(-normal.dot(v.col(n)), Real(0));
        v.col(n) += impact * normal;
        if (touch.held || impact == 0) continue;
        pressed[n] = mass.mass()[3 * n] * impact / dt;
        const Vec<3> along = v.col(n) - normal.dot(v.col(n)) * normal;
        const Real speed = along.norm();
        touch.rubbed = speed > 0;
        if (touch.rubbed) v.col(n) -= std::min(Real(1), sphere.friction * impact / speed) * along;
    }
    return touching;
}

}  // namespace pliant
