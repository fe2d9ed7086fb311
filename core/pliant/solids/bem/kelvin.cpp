#include <pliant/solids/bem/kelvin.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

constexpr Real pi = std::numbers::pi;

// |r|^(Dim - 1)
template <int Dim>
Real area_of(Real distance) {
    return Dim == 2 ? distance : distance * distance;
}

}  // namespace

template <int Dim>
KelvinSolution<Dim>::KelvinSolution(const Lame& material, Real unit_distance)
    : shear_(material.mu),
      ratio_(material.lambda / (2 * (material.lambda + material.mu))),
      unit_distance_(unit_distance),
      scale_(1 / ((Dim == 2 ? 8 : 16) * pi * shear_ * (1 - ratio_))) {}

// Plane: s ((3 - 4 nu) ln(d/r) I + e e^T), space: s/r ((3 - 4 nu) I + e e^T), with e = r/|r|, d the unit distance.
template <int Dim>
Mat<Dim> KelvinSolution<Dim>::displacement(const Vec<Dim>& r) const {
    const Real distance = r.norm();
    const Vec<Dim> e = r / distance;
    if constexpr (Dim == 2)
        return scale_ * (-(3 - 4 * ratio_) * std::log(distance / unit_distance_) * Mat<2>::Identity() + e * e.transpose());
    else
        return scale_ / distance * ((3 - 4 * ratio_) * Mat<3>::Identity() + e * e.transpose());
}

template <int Dim>
Mat<Dim> KelvinSolution<Dim>::traction(const Vec<Dim>& r, const Vec<Dim>& n) const {
    const Real distance = r.norm(), c = 1 - 2 * ratio_;
    const Vec<Dim> e = r / distance;
    const Mat<Dim> turned = e * n.transpose();
    const Mat<Dim> along = c * Mat<Dim>::Identity() + Dim * e * e.transpose();
    return -1 / (4 * (Dim - 1) * pi * (1 - ratio_) * area_of<Dim>(distance)) *
           (e.dot(n) * along - c * (turned - turned.transpose()));
}

template <int Dim>
Mat<Dim> KelvinSolution<Dim>::stress_of_traction(const Vec<Dim>& r, const Vec<Dim>& t) const {
    const Real distance = r.norm(), c = 1 - 2 * ratio_, et = r.dot(t) / distance;
    const Vec<Dim> e = r / distance;
    const Mat<Dim> mixed = t * e.transpose();
    return 1 / (4 * (Dim - 1) * pi * (1 - ratio_) * area_of<Dim>(distance)) *
           (c * (mixed + mixed.transpose() - et * Mat<Dim>::Identity()) + Dim * et * e * e.transpose());
}

template <int Dim>
Mat<Dim> KelvinSolution<Dim>::stress_of_displacement(const Vec<Dim>& r, const Vec<Dim>& n, const Vec<Dim>& u) const {
    const Real distance = r.norm(), c = 1 - 2 * ratio_, nu = ratio_;
    const Vec<Dim> e = r / distance;
    const Real en = e.dot(n), eu = e.dot(u), nu_dot = n.dot(u);
    const Mat<Dim> I = Mat<Dim>::Identity(), ue = u * e.transpose(), ne = n * e.transpose(), nu_mixed = n * u.transpose();
    const Mat<Dim> inner = Dim * en * (c * eu * I + nu * (ue + ue.transpose()) - (Dim + 2) * eu * e * e.transpose()) +
                           Dim * nu * eu * (ne + ne.transpose()) +
                           c * (Dim * nu_dot * e * e.transpose() + nu_mixed + nu_mixed.transpose()) - (1 - 4 * nu) * nu_dot * I;
    return shear_ / (2 * (Dim - 1) * pi * (1 - nu) * area_of<Dim>(distance) * distance) * inner;
}

template class KelvinSolution<2>;
template class KelvinSolution<3>;

}  // namespace pliant
