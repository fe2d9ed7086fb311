// The stiffness of an element of the neo-Hookean energy at one of its points, in closed form.
#pragma once
#include <pliant/continuum/deformation.h>
#include <pliant/continuum/energy_density.h>
#include <pliant/math/closed_form_eigen.h>

#include <cmath>

namespace pliant {

// With h = F^-T g, the gradients of the shape functions in the deformed body, and c = mu - lambda ln J, block (a, b) is
//   w (mu (g_a . g_b) I + c h_b h_a^T + lambda h_a h_b^T).
// All negative curvature for c >= 0 is that of the twists R [v_k]x / sqrt 2 about the principal axes v_k, R the rotation of F and
// sigma its stretches: mu - c sigma_k / J [Smith2019 §4]. For c < 0, in a body that is blown up, others may be negative too.
template <int Dim, int Nodes>
class NeoHookeanElement {
public:
    using Gradients = Eigen::Matrix<Real, Dim, Nodes>;
    using Matrix = Mat<Dim * Nodes>;

    // det F > 0. The gradients g: 1/m, one column per node.
    NeoHookeanElement(const Lame& material, const Mat<Dim>& F, const Gradients& g)
        : material_(material), F_(F), g_(g), J_(volume_ratio<Dim>(F)), c_(material.mu - material.lambda * std::log(J_)) {
        h_.noalias() = cofactor<Dim>(F) / J_ * g;
    }

    // Is all that is negative a twist?
    bool only_twists() const { return c_ >= 0; }

    // Adds it, weight: m^Dim; symmetric to the bit.
    void add(Real weight, Matrix& K) const {
        const Real mu = weight * material_.mu, lambda = weight * material_.lambda, c = weight * c_;
        for (int a = 0; a < Nodes; ++a)
            for (int b = 0; b <= a; ++b) {
                Mat<Dim> block = c * h_.col(b) * h_.col(a).transpose() + lambda * h_.col(a) * h_.col(b).transpose();
                block.diagonal().array() += mu * g_.col(a).dot(g_.col(b));
                K.template block<Dim, Dim>(Dim * a, Dim * b) += block;
                if (a != b) K.template block<Dim, Dim>(Dim * b, Dim * a) += block.transpose();
            }
    }

    // Lifts the negative curvature of the twists to 0.
    void lift_twists(Real weight, Matrix& K) const {
        if (!(c_ * F_.norm() > material_.mu * J_)) return;  // no stretch is longer than |F|
        const auto [R, S] = polar_decomposition<Dim>(F_);
        if constexpr (Dim == 2) {
            const Real lack = weight * (c_ / J_ - material_.mu);
            Gradients twisted;
            twisted.row(0) = -g_.row(1);
            twisted.row(1) = g_.row(0);
            if (lack > 0) add_square(lack / 2, R * twisted, K);
        } else {
            // None is longer than what leaves mu I - c/J S positive: its leading minors tell without the axes.
            const Mat<3> left = material_.mu * Mat<3>::Identity() - c_ / J_ * S;
            if (left(0, 0) > 0 && left(0, 0) * left(1, 1) > left(0, 1) * left(0, 1) && left.determinant() > 0) return;
            const SymmetricEigen<3> axes = symmetric_eigen_closed_form(S);
            for (int k = 0; k < 3; ++k) {
                const Real lack = weight * (c_ * axes.values[k] / J_ - material_.mu);
                if (lack <= 0) continue;
                Gradients twisted;
                for (int a = 0; a < Nodes; ++a) twisted.col(a) = axes.vectors.col(k).cross(g_.col(a));
                add_square(lack / 2, R * twisted, K);
            }
        }
    }

private:
    // K += factor q q^T
    static void add_square(Real factor, const Gradients& columns, Matrix& K) {
        const Eigen::Map<const Vec<Dim * Nodes>> q(columns.data());
        for (int n = 0; n < Dim * Nodes; ++n) {
            const Real scaled = factor * q[n];
            for (int m = 0; m < n; ++m) {
                K(m, n) += scaled * q[m];
                K(n, m) += scaled * q[m];
            }
            K(n, n) += scaled * q[n];
        }
    }

    Lame material_;
    Mat<Dim> F_;
    Gradients g_, h_;
    Real J_, c_;
};

}  // namespace pliant
