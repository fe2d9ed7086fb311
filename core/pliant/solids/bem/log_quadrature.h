// Gauss points with further weights for integrands with a logarithm.
#pragma once
#include <pliant/mesh/simplex_quadrature.h>

namespace pliant {

// On [0, 1]: the integral of f is the sum of weights × f(point), that of f ln(1/t) the sum of log_weights × f(point); both for
// smooth f, the second exact for polynomials of degree below the count of points.
struct LogRule {
    VecX points, weights, log_weights;
};
LogRule log_rule(int count);

}  // namespace pliant
