#include <pliant/math/error.h>
#include <pliant/solids/point_masses.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <cmath>

namespace pliant {
namespace {

Vec<1> moment(const Vec<2>& arm, const Vec<2>& vector) { return Vec<1>(arm[0] * vector[1] - arm[1] * vector[0]); }
Vec<3> moment(const Vec<3>& arm, const Vec<3>& vector) { return arm.cross(vector); }

}  // namespace

template <int Dim>
Real kinetic_energy(const VecX& mass, PointsIn<Dim> v) {
    Real energy = 0;
    for (Index n = 0; n < v.cols(); ++n) energy += 0.5 * mass[n] * v.col(n).squaredNorm();
    return energy;
}

template <int Dim>
Real gravitational_energy(const VecX& mass, const Vec<Dim>& gravity, PointsIn<Dim> x) {
    Real energy = 0;
    for (Index n = 0; n < x.cols(); ++n) energy -= mass[n] * gravity.dot(x.col(n));
    return energy;
}

template <int Dim>
Vec<Dim> momentum(const VecX& mass, PointsIn<Dim> v) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (Index n = 0; n < v.cols(); ++n) sum += mass[n] * v.col(n);
    return sum;
}

template <int Dim>
Vec<Dim> centre_of_mass(const VecX& mass, PointsIn<Dim> x) {
    const Real total = mass.sum();
    return total > 0 ? Vec<Dim>(momentum<Dim>(mass, x) / total) : Vec<Dim>::Zero();
}

template <int Dim>
AngularVec<Dim> angular_momentum(const VecX& mass, PointsIn<Dim> x, PointsIn<Dim> v) {
    const Vec<Dim> centre = centre_of_mass<Dim>(mass, x), drift = centre_of_mass<Dim>(mass, v);
    AngularVec<Dim> sum = AngularVec<Dim>::Zero();
    for (Index n = 0; n < x.cols(); ++n) sum += mass[n] * moment(Vec<Dim>(x.col(n) - centre), Vec<Dim>(v.col(n) - drift));
    return sum;
}

void require_finite(const char* name, const char* unit, const Eigen::Ref<const MatX>& columns) {
    for (Index n = 0; n < columns.cols(); ++n)
        for (Index c = 0; c < columns.rows(); ++c)
            if (!std::isfinite(columns(c, n)))
                throw Refused(fmt::format("{}[{}]", name, n), columns(c, n), unit, "finite numbers");
}

#define PLIANT_INSTANTIATE(Dim)                                                           \
    template Real kinetic_energy<Dim>(const VecX&, PointsIn<Dim>);                        \
    template Real gravitational_energy<Dim>(const VecX&, const Vec<Dim>&, PointsIn<Dim>); \
    template Vec<Dim> momentum<Dim>(const VecX&, PointsIn<Dim>);                          \
    template Vec<Dim> centre_of_mass<Dim>(const VecX&, PointsIn<Dim>);                    \
    template AngularVec<Dim> angular_momentum<Dim>(const VecX&, PointsIn<Dim>, PointsIn<Dim>);

PLIANT_INSTANTIATE(2)
PLIANT_INSTANTIATE(3)
#undef PLIANT_INSTANTIATE

}  // namespace pliant
