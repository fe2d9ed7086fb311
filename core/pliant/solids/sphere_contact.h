// Contact of nodes with a fixed sphere: planes to rest on during an implicit step, and what is left to set right after any step.
#pragma once
#include <pliant/solids/nodal_terms.h>
#include <pliant/time/mass.h>

#include <vector>

namespace pliant {

struct Sphere {
    Vec<3> centre = Vec<3>::Zero();  // m
    Real radius = 0;                 // m, >= 0
    Real friction = 0.3;             // Coulomb's coefficient, >= 0
};

// Throws Refused, naming the number.
void require_valid(const Sphere& sphere);

// Speed below which friction is drag instead, m/s: a node that Coulomb's law holds creeps at most as fast.
inline constexpr Real creep_speed = 1e-3;

// Adds to `terms` a tangent plane for every free node that rests on the sphere, or that would be inside it at the end of a step
// of dt with its velocity. pressed: force with which the sphere held each node in the step before, N, 0 where it did not;
// friction mu pressed acts against the motion along the plane, as a drag with the speed of the start, at least creep_speed.
// stiffness: of the planes, N/m; a node sinks in by its pressing force over that.
void rest_on_sphere(const Sphere& sphere, const DiagonalMass& mass, Real dt, PointsIn<3> x, PointsIn<3> v, const VecX& pressed,
                    Real stiffness, NodalTerms<3>& terms);

// What the stage after a step does with a node. held: a plane presses it; inside: it is inside, and is put onto the surface.
struct SphereTouch {
    bool held = false, inside = false;
    bool centred = false;  // it was in the very centre, where no direction leads out: it leaves upwards
    bool rubbed = false;   // friction took from its speed along the surface
    bool any() const { return held || inside; }
};

// Force with which its plane presses each node at x, N: 0 where there is none, or where it pulls, which a sphere cannot.
void plane_forces(const std::vector<NodePlane<3>>& planes, PointsIn<3> x, VecX& held);

// Puts nodes that are inside onto the surface, takes the inward speed from all that touch, and from those that met the sphere
// without a plane at most friction times as much along it [Bridson2002]. held: plane_forces() at the end of the integration.
// pressed becomes the force of this step, N, for the next: held, or the impulse of an impact over dt. Returns how many touch.
Index resolve_sphere_contact(const Sphere& sphere, const DiagonalMass& mass, Real dt, const VecX& held, PointsOut<3> x,
                             PointsOut<3> v, VecX& pressed, std::vector<SphereTouch>& touches);

}  // namespace pliant
