#include <pliant/math/error.h>
#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/elastica.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

// From θ'² = 2a (sin φ - sin θ) along the arc, φ the angle of the tip: integrals of dθ / sqrt(sin φ - sin θ) from 0 to φ, with
// θ = φ - t² so that nothing is infinite.
struct ArcIntegrals {
    Real length = 0, down = 0, along = 0;
};

ArcIntegrals integrate_arc(Real phi) {
    static const GaussRule rule = gauss_legendre(40);
    const Real end = std::sqrt(phi);
    ArcIntegrals sums;
    for (Index q = 0; q < rule.points.size(); ++q) {
        const Real t = end * rule.points[q], theta = phi - t * t;
        // sin φ - sin θ = 2 cos((φ + θ)/2) sin(t²/2)
        const Real under = 2 * std::cos((phi + theta) / 2) * std::sin(t * t / 2);
        const Real w = end * rule.weights[q] * 2 * t / std::sqrt(under);
        sums.length += w, sums.down += w * std::sin(theta), sums.along += w * std::cos(theta);
    }
    return sums;
}

}  // namespace

Elastica elastica(Real a) {
    if (!(a >= 0 && a <= 100)) throw Refused("P L²/(E I)", a, "", "[0, 100]");
    if (a == 0) return {};
    const Real wanted = std::sqrt(2 * a);
    Real low = 0, high = std::numbers::pi / 2;
    for (int k = 0; k < 60; ++k) {
        const Real middle = (low + high) / 2;
        (integrate_arc(middle).length < wanted ? low : high) = middle;
    }
    const Real phi = (low + high) / 2;
    const ArcIntegrals arc = integrate_arc(phi);
    return {arc.down / arc.length, arc.along / arc.length, phi};
}

}  // namespace pliant
