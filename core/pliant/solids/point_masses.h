// Energies and momenta of point masses. mass: kg, one per node; x: m and v: m/s, one column per node.
#pragma once
#include <pliant/solids/springs.h>

namespace pliant {

// Angular momentum has one component in 2D and three in 3D.
template <int Dim>
using AngularVec = Vec<Dim*(Dim - 1) / 2>;

template <int Dim>
Real kinetic_energy(const VecX& mass, PointsIn<Dim> v);  // J

// -sum m g . x, J: zero at the origin.
template <int Dim>
Real gravitational_energy(const VecX& mass, const Vec<Dim>& gravity, PointsIn<Dim> x);

template <int Dim>
Vec<Dim> momentum(const VecX& mass, PointsIn<Dim> v);  // kg m/s

// m; the zero vector when there is no mass.
template <int Dim>
Vec<Dim> centre_of_mass(const VecX& mass, PointsIn<Dim> x);

// About the centre of mass, with velocities relative to its own, kg m^2/s.
template <int Dim>
AngularVec<Dim> angular_momentum(const VecX& mass, PointsIn<Dim> x, PointsIn<Dim> v);

// Throws Refused, naming the array and the index, when a number is not finite.
void require_finite(const char* name, const char* unit, const Eigen::Ref<const MatX>& columns);

}  // namespace pliant
