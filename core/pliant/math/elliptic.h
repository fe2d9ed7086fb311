// Elliptic integrals of the first kind and Jacobi's functions for every modulus in [0, 1), given by the complementary modulus
// k' = sqrt(1 - k^2): near k = 1, where k itself no longer tells how near, they keep their digits.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// K(k), the quarter period, for k' in (0, 1]; infinite for k' = 0. By the arithmetic-geometric mean [Abramowitz1964 §17.6].
Real complete_elliptic_integral(Real complement);

// F(phi, k) for phi in [-pi/2, pi/2], given by sin(phi), cos(phi) and dn = sqrt(1 - k^2 sin^2(phi)): the three may come from
// where they do not cancel [Carlson1995].
Real elliptic_integral(Real sine, Real cosine, Real dn);

// sn(u, k), cn(u, k), dn(u, k) and the amplitude am(u, k), whose sine and cosine sn and cn are, for k' in (0, 1]. By the
// descending Landen transformation [Abramowitz1964 §16.4].
struct EllipticFunctions {
    Real am, sn, cn, dn;
};
EllipticFunctions elliptic_functions(Real u, Real complement);

}  // namespace pliant
