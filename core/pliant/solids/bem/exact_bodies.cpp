#include <pliant/solids/bem/exact_bodies.h>

#include <cmath>
#include <complex>

namespace pliant {
namespace {

using Complex = std::complex<Real>;

// E of a pull along one axis of the plane.
Real plane_modulus(const Lame& m) { return 4 * m.mu * (m.lambda + m.mu) / (m.lambda + 2 * m.mu); }

}  // namespace

// Muskhelishvili's potential on the unit circle that ω(ζ) = R (ζ + m/ζ) maps to the boundary: hoop + normal stress = 4 Re φ'/ω'.
Real EllipticHole::hoop_stress(Real angle) const {
    const Real m = (half_axes[0] - half_axes[1]) / (half_axes[0] + half_axes[1]);
    const Complex square = std::polar(Real{1}, 2 * angle);
    const Real pulled = ((square + (2 + m)) / (square - m)).real(), pressed = (Real{2} * (square + m) / (square - m)).real() - 1;
    return stress * pulled + pressure * pressed;
}

Vec<2> EllipticHole::boundary_displacement() const {
    const Real a = half_axes[0], b = half_axes[1], E = plane_modulus(material);
    const Real squeezed = pressure / (2 * (material.lambda + material.mu));
    return {(-stress * a + 2 * pressure * b) / E - squeezed * a, (stress * (2 * a + b) + 2 * pressure * a) / E - squeezed * b};
}

Real EllipticHole::stress_beside(Real x) const {
    const Real q = half_axes[0] * half_axes[0] / (x * x);
    return stress * (1 + q / 2 + 1.5 * q * q) + pressure * q;
}

Mat<2> EllipticHole::remote_strain() const {
    const Real E = plane_modulus(material), ratio = material.lambda / (material.lambda + 2 * material.mu);
    return Vec<2>(-ratio * stress / E, stress / E).asDiagonal();
}

Real PressedRing::hoop_stress(Real r) const {
    const Real a = inner * inner, b = outer * outer;
    return pressure * a / (b - a) * (1 + b / (r * r));
}

Real PressedRing::radial_stress(Real r) const {
    const Real a = inner * inner, b = outer * outer;
    return pressure * a / (b - a) * (1 - b / (r * r));
}

Real PressedRing::displacement(Real r) const {
    const Real a = inner * inner, b = outer * outer;
    return pressure * a * r / (b - a) * (1 / (2 * (material.lambda + material.mu)) + b / (2 * material.mu * r * r));
}

Real PressedCavity::hoop_stress(Real r) const { return pressure * std::pow(radius / r, 3) / 2; }
Real PressedCavity::displacement(Real r) const { return pressure * std::pow(radius, 3) / (4 * shear_modulus * r * r); }

}  // namespace pliant
