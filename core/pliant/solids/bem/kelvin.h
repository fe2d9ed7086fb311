// Kelvin's solution: what a unit force at one point of an infinite elastic body does at another [Brebbia1984 §5.3]. In the plane
// per metre of thickness.
#pragma once
#include <pliant/continuum/moduli.h>

namespace pliant {

template <int Dim>
class KelvinSolution {
public:
    // The constants of the plane in 2D: IsotropicModuli::lame() is plane strain, plane_stress_lame() plane stress. unit_distance
    // [m]: at which the logarithm of the plane's displacement is 0, an arbitrary choice that moves the whole plane alike.
    explicit KelvinSolution(const Lame& material, Real unit_distance = 1);

    Real shear_modulus() const { return shear_; }  // Pa
    // lambda / (2 (lambda + mu)): Poisson's ratio in space and in plane strain.
    Real poisson_ratio() const { return ratio_; }

    // r: from the force to the point [m], not 0; n: a unit normal there.
    // U(i, j): displacement j that a unit force i causes [m/N].
    Mat<Dim> displacement(const Vec<Dim>& r) const;
    // T(i, j): traction j on a cut with the normal n [1/m^(Dim-1)].
    Mat<Dim> traction(const Vec<Dim>& r, const Vec<Dim>& n) const;
    Real unit_distance() const { return unit_distance_; }  // m
    // In 2D displacement() is - log_factor() ln(|r| / unit_distance()) I and what is bounded [m/N].
    Real log_factor() const { return (3 - 4 * ratio_) * scale_; }

    // Stress at the source of r [Pa] that a traction t [Pa], or a displacement u [m] of a boundary with the normal n, at the
    // point causes per area of boundary: the integrands of Somigliana's identity for stresses [Brebbia1984 §5.6].
    Mat<Dim> stress_of_traction(const Vec<Dim>& r, const Vec<Dim>& t) const;
    Mat<Dim> stress_of_displacement(const Vec<Dim>& r, const Vec<Dim>& n, const Vec<Dim>& u) const;

private:
    Real shear_, ratio_, unit_distance_;
    Real scale_;  // 1/(8 pi G (1 - nu)) in the plane, half of it in space
};

// What a traction and a displacement at a boundary point give to displacement and stress at the source of r: rows u, then the
// stress row by row, columns the components of t or u. add(of_traction, of_displacement)
template <int Dim, class Add>
void add_inside_terms(const KelvinSolution<Dim>& kelvin, Real weight, const Vec<Dim>& r, const Vec<Dim>& n, Add add) {
    Eigen::Matrix<Real, Dim + Dim * Dim, Dim> t, u;
    t.template topRows<Dim>() = weight * kelvin.displacement(r);
    u.template topRows<Dim>() = -weight * kelvin.traction(r, n);
    for (int c = 0; c < Dim; ++c) {
        const Vec<Dim> unit = Vec<Dim>::Unit(c);
        t.col(c).template tail<Dim * Dim>() = weight * kelvin.stress_of_traction(r, unit).reshaped();
        u.col(c).template tail<Dim * Dim>() = -weight * kelvin.stress_of_displacement(r, n, unit).reshaped();
    }
    add(t, u);
}

}  // namespace pliant
