// The stiffness of one linear simplex under Hooke's law.
#pragma once
#include <pliant/continuum/moduli.h>

namespace pliant {

// Block (a, b) is V (lambda g_a g_b^T + mu g_b g_a^T + mu (g_a . g_b) I) [N/m] with the gradients g of the shape functions, 1/m,
// one column per corner; V the volume [m^Dim]. Symmetric to the bit. With gradients R g that a rotation R has turned it is R K
// R^T.
template <int Dim>
Mat<Dim*(Dim + 1)> linear_element_stiffness(const Eigen::Matrix<Real, Dim, Dim + 1>& g, Real volume, const Lame& material) {
    const Real lambda = material.lambda * volume, mu = material.mu * volume;
    Mat<Dim*(Dim + 1)> K;
    for (int a = 0; a <= Dim; ++a)
        for (int b = 0; b <= a; ++b) {
            Mat<Dim> block = lambda * g.col(a) * g.col(b).transpose() + mu * g.col(b) * g.col(a).transpose();
            block.diagonal().array() += mu * g.col(a).dot(g.col(b));
            if (a == b)
                K.template block<Dim, Dim>(Dim * a, Dim * a) = block.template selfadjointView<Eigen::Lower>();
            else
                K.template block<Dim, Dim>(Dim * a, Dim * b) = block,
                                                          K.template block<Dim, Dim>(Dim * b, Dim * a) = block.transpose();
        }
    return K;
}

}  // namespace pliant
