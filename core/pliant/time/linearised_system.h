// The matrix of one Newton iteration, known by its products with vectors.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// A symmetric positive semidefinite matrix H, N/m, over the degrees of freedom of a system.
class LinearisedSystem {
public:
    virtual ~LinearisedSystem() = default;

    virtual void multiply(const VecX& d, VecX& Hd) const = 0;
    // z approximates H^-1 r, by a symmetric positive definite map. Throws Diverged where H has no positive diagonal.
    virtual void precondition(const VecX& r, VecX& z) const = 0;
    virtual Real diagonal(Index dof) const = 0;
};

}  // namespace pliant
