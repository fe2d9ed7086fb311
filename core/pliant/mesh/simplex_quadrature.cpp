#include <pliant/math/error.h>
#include <pliant/mesh/simplex_quadrature.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

struct ValueAndSlope {
    Real value, slope;
};

// Legendre polynomial of the given degree on (-1, 1), by its three-term recurrence.
ValueAndSlope legendre(int degree, Real x) {
    Real before = 1, value = x;
    for (int k = 2; k <= degree; ++k) {
        const Real next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, degree * (x * value - before) / (x * x - 1)};
}

}  // namespace

GaussRule gauss_legendre(int count) {
    if (count < 1 || count > 64) throw Refused("count of Gauss points", count, "", "a whole number in [1, 64]");
    GaussRule rule{VecX(count), VecX(count)};
    for (int i = 0; i < count; ++i) {
        // Newton's method on the roots, from an asymptotic guess that is good to a few digits.
        Real x = count == 1 ? 0 : std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        if (count > 1)
            for (int newton = 0; newton < 8; ++newton) {
                const auto [value, slope] = legendre(count, x);
                x -= value / slope;
            }
        const Real slope = legendre(count, x).slope;
        rule.points[count - 1 - i] = 0.5 * (1 + x);
        rule.weights[count - 1 - i] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

template <int Dim>
SimplexRule<Dim> simplex_rule(int degree) {
    if (degree < 0 || degree > 30) throw Refused("degree of the quadrature", degree, "", "a whole number in [0, 30]");
    // The collapse adds up to Dim - 1 degrees in one direction.
    const int n = (degree + Dim - 1) / 2 + 1;
    const GaussRule gauss = gauss_legendre(n);
    Index count = 1;
    for (int k = 0; k < Dim; ++k) count *= n;

    SimplexRule<Dim> rule{Points<Dim + 1>(Dim + 1, count), VecX(count)};
    for (Index q = 0; q < count; ++q) {
        // Coordinate k takes its share of what the coordinates before it have left over.
        Real left = 1, weight = 1;
        Index digits = q;
        for (int k = 0; k < Dim; ++k, digits /= n) {
            const Index i = digits % n;
            rule.barycentric(k + 1, q) = left * gauss.points[i];
            // The weight carries the Jacobian left^(Dim-1-k) of the collapse, and Dim! / (1 2 ... Dim) for the unit sum.
            weight *= gauss.weights[i] * (k + 1) * std::pow(1 - gauss.points[i], Dim - 1 - k);
            left -= rule.barycentric(k + 1, q);
        }
        rule.barycentric(0, q) = left;
        rule.weights[q] = weight;
    }
    return rule;
}

template SimplexRule<1> simplex_rule<1>(int);
template SimplexRule<2> simplex_rule<2>(int);
template SimplexRule<3> simplex_rule<3>(int);

}  // namespace pliant
