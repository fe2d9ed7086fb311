#include <pliant/solids/bem/log_quadrature.h>

namespace pliant {

// f is developed in Legendre polynomials P_k(2t - 1), whose integrals with ln(1/t) are 1 for k = 0 and (-1)^k / (k (k + 1))
// beyond.
LogRule log_rule(int count) {
    const GaussRule gauss = gauss_legendre(count);
    LogRule rule{gauss.points, gauss.weights, VecX::Zero(count)};
    for (Index q = 0; q < count; ++q) {
        const Real x = 2 * gauss.points[q] - 1;
        Real before = 1, value = x, sum = 1;
        for (int k = 1; k < count; ++k) {
            const Real moment = (k % 2 ? -1.0 : 1.0) / (k * (k + 1.0));
            sum += (2 * k + 1) * moment * value;
            const Real next = ((2 * k + 1) * x * value - k * before) / (k + 1);
            before = value, value = next;
        }
        rule.log_weights[q] = gauss.weights[q] * sum;
    }
    return rule;
}

}  // namespace pliant
