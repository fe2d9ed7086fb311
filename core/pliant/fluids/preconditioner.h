// Approximate inverses of the pressure equation, for conjugate gradients [Shewchuk1994 §B3].
#pragma once
#include <pliant/fluids/poisson_operator.h>

namespace pliant {

enum class PressurePreconditioner {
    none,                 // z = r
    jacobi,               // z = r over the diagonal
    incomplete_cholesky,  // modified, of level 0
    multigrid             // one V-cycle
};

// z ≈ A⁻¹ r for the A of PoissonOperator's finest level; symmetric and positive, apart from what A does not see: the constant of
// each region. Cells without an open face get 0, or keep what r has there, which is 0.
template <int Dim>
class Preconditioner {
public:
    virtual ~Preconditioner() = default;
    virtual void precondition(const VecX& r, VecX& z) = 0;
};

// z = r: plain conjugate gradients.
template <int Dim>
class NoPreconditioner final : public Preconditioner<Dim> {
public:
    void precondition(const VecX& r, VecX& z) override { z = r; }
};

}  // namespace pliant
