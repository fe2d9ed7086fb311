#include <pliant/continuum/deformation.h>
#include <pliant/continuum/energy_density.h>
#include <pliant/math/error.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pliant {
namespace {

template <int Dim>
Real admitted_volume_ratio(const Mat<Dim>& F) {
    const Real J = volume_ratio<Dim>(F);
    if (J > 0) return J;
    throw Diverged(
        Failure{.stage = "",
                .field = "det_F",
                .what = fmt::format("det F = {:.6g}: the neo-Hookean energy is infinite where a body is flat or turned "
                                    "inside out",
                                    J),
                .limit = "det F > 0",
                .value = J,
                .bound = 0});
}

template <int Dim>
Mat<Dim> symmetric(const Mat<Dim>& A) {
    return 0.5 * (A + A.transpose());
}

// P about one F: what all directions share is computed once.
template <int Dim>
class Linearised {
public:
    Linearised(Energy energy, const Lame& material, const Mat<Dim>& F) : energy_(energy), material_(material), F_(F) {
        const Mat<Dim> I = Mat<Dim>::Identity();
        if (energy == Energy::stvk) S_ = hooke_stress<Dim>(material, green_strain<Dim>(F - I));
        if (energy == Energy::corotated) polar_ = polar_decomposition<Dim>(F), number_ = (polar_.S - I).trace();
        if (energy != Energy::neo_hookean) return;
        const Real J = admitted_volume_ratio<Dim>(F);
        number_ = std::log(J), S_ = cofactor<Dim>(F) / J;
    }

    Mat<Dim> operator()(const Mat<Dim>& dF) const {
        const auto [lambda, mu] = material_;
        switch (energy_) {
            case Energy::linear:
                return hooke_stress<Dim>(material_, symmetric<Dim>(dF));
            case Energy::stvk:
                return dF * S_ + F_ * hooke_stress<Dim>(material_, symmetric<Dim>(F_.transpose() * dF));
            case Energy::corotated: {
                // tr(S) changes by R : dF, since R is its derivative.
                const Mat<Dim> dR = rotation_differential<Dim>(polar_, dF);
                return 2 * mu * (dF - dR) + lambda * (polar_.R.cwiseProduct(dF).sum() * polar_.R + number_ * dR);
            }
            case Energy::neo_hookean:
                return mu * dF + (mu - lambda * number_) * S_ * dF.transpose() * S_ + lambda * S_.cwiseProduct(dF).sum() * S_;
        }
        return dF;
    }

private:
    Energy energy_;
    Lame material_;
    Mat<Dim> F_;
    PolarDecomposition<Dim> polar_;
    Mat<Dim> S_;       // StVK: second Piola-Kirchhoff stress; neo-Hookean: F^-T
    Real number_ = 0;  // corotated: tr(S - I); neo-Hookean: ln J
};

}  // namespace

template <int Dim>
bool EnergyDensity<Dim>::admits(const Mat<Dim>& F) const {
    return energy_ != Energy::neo_hookean || volume_ratio<Dim>(F) > 0;
}

template <int Dim>
Real EnergyDensity<Dim>::psi(const Mat<Dim>& F) const {
    const auto [lambda, mu] = material_;
    const Mat<Dim> H = F - Mat<Dim>::Identity();
    switch (energy_) {
        case Energy::linear:
            return hooke_energy_density<Dim>(material_, cauchy_strain<Dim>(H));
        case Energy::stvk:
            return hooke_energy_density<Dim>(material_, green_strain<Dim>(H));
        case Energy::corotated: {
            // |F - R| = |S - I|, since R turns both alike.
            const auto [R, S] = polar_decomposition<Dim>(F);
            return hooke_energy_density<Dim>(material_, S - Mat<Dim>::Identity());
        }
        case Energy::neo_hookean: {
            const Real J = volume_ratio<Dim>(F);
            if (!(J > 0)) return std::numeric_limits<Real>::infinity();
            // tr(F^T F) - Dim = 2 tr(E), which does not cancel near rest.
            const Real ln_J = std::log(J);
            return mu * (green_strain<Dim>(H).trace() - ln_J) + 0.5 * lambda * ln_J * ln_J;
        }
    }
    return 0;
}

template <int Dim>
Mat<Dim> EnergyDensity<Dim>::P(const Mat<Dim>& F) const {
    const auto [lambda, mu] = material_;
    const Mat<Dim> I = Mat<Dim>::Identity();
    switch (energy_) {
        case Energy::linear:
            return hooke_stress<Dim>(material_, cauchy_strain<Dim>(F - I));
        case Energy::stvk:
            return F * hooke_stress<Dim>(material_, green_strain<Dim>(F - I));
        case Energy::corotated: {
            const auto [R, S] = polar_decomposition<Dim>(F);
            return R * hooke_stress<Dim>(material_, S - I);
        }
        case Energy::neo_hookean: {
            const Real J = admitted_volume_ratio<Dim>(F);
            const Mat<Dim> inverse_transposed = cofactor<Dim>(F) / J;
            return mu * (F - inverse_transposed) + lambda * std::log(J) * inverse_transposed;
        }
    }
    return I;
}

template <int Dim>
Mat<Dim> EnergyDensity<Dim>::differential(const Mat<Dim>& F, const Mat<Dim>& dF) const {
    return Linearised<Dim>(energy_, material_, F)(dF);
}

template <int Dim>
Mat<Dim * Dim> EnergyDensity<Dim>::tangent(const Mat<Dim>& F) const {
    const Linearised<Dim> at_F(energy_, material_, F);
    Mat<Dim * Dim> T;
    for (int l = 0; l < Dim; ++l)
        for (int k = 0; k < Dim; ++k) {
            Mat<Dim> dF = Mat<Dim>::Zero();
            dF(k, l) = 1;
            T.col(k + Dim * l) = at_F(dF).reshaped();
        }
    return T;
}

template class EnergyDensity<2>;
template class EnergyDensity<3>;

}  // namespace pliant
