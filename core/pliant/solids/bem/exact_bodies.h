// Closed solutions that boundary elements are measured by: a hole in a plane without end, a ring, a cavity in a space without
// end. Material: the constants of the plane, or of space.
#pragma once
#include <pliant/continuum/moduli.h>

namespace pliant {

// An elliptic hole about the origin, pulled at along y from far away and pressed from inside [Kirsch1898; Inglis1913].
struct EllipticHole {
    Vec<2> half_axes;               // along x and y, m
    Real stress = 0, pressure = 0;  // Pa
    Lame material;

    // Along the boundary at (a cos, b sin) of the angle [Pa].
    Real hoop_stress(Real angle) const;
    // Of the boundary at (a, 0) along x and at (0, b) along y [m]; u = (U_x cos, U_y sin) between.
    Vec<2> boundary_displacement() const;
    // Of a round hole: stress along y at (x, 0), x ≥ a [Pa].
    Real stress_beside(Real x) const;
    // What there would be without the hole, and without the pressure.
    Mat<2> remote_stress() const { return Vec<2>(0, stress).asDiagonal(); }  // Pa
    Mat<2> remote_strain() const;
};

// Pressed from inside [Lamé 1852; TimoshenkoGoodier1970 §28].
struct PressedRing {
    Real inner, outer;  // m
    Real pressure;      // Pa
    Lame material;

    Real hoop_stress(Real r) const;    // Pa
    Real radial_stress(Real r) const;  // Pa
    Real displacement(Real r) const;   // outward, m
};

// A sphere, pressed from inside.
struct PressedCavity {
    Real radius, pressure, shear_modulus;  // m, Pa, Pa

    Real hoop_stress(Real r) const;   // Pa
    Real displacement(Real r) const;  // outward, m
};

}  // namespace pliant
