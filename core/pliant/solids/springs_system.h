// A spring net under gravity, pulled at a node, as the implicit solver sees it.
#pragma once
#include <pliant/solids/external_load.h>
#include <pliant/solids/nodal_terms.h>
#include <pliant/solids/springs_matrix.h>
#include <pliant/solids/springs_tangent.h>
#include <pliant/time/implicit.h>

#include <memory>
#include <optional>

namespace pliant {

// Spring, damping and external forces together. The directions of projected damping are those of begin_step(). In 3D linearise()
// gives the net as a SpringTangent, with a diagonal mass.
template <int Dim>
class SpringSystem final : public SecondOrderSystem {
public:
    // mass: kg, one per node. Springs and masses must outlive the system; their values may change, the springs' nodes not.
    SpringSystem(const Springs& springs, const VecX& mass);

    SpringDamping damping = SpringDamping::none;
    ExternalLoad<Dim> load;
    NodalTerms<Dim> terms;

    // Tells linearise() that the nodes are a sheet; see SpringTangent.
    void set_sheet(Index nodes_x, Index nodes_y) { tangent().set_sheet(nodes_x, nodes_y); }
    SpringTangent& tangent();

    void begin_step(ConstDofs x) override { start_ = x; }
    bool damped() const override { return damping != SpringDamping::none || !terms.drag.empty(); }
    Real potential(ConstDofs x) const override;
    Real dissipation(ConstDofs v) const override;
    void force(ConstDofs x, ConstDofs v, Dofs f) const override;
    const SparseMatrix& stiffness(ConstDofs x, Real velocity_rate, Curvature curvature) override;
    const LinearisedSystem* linearise(ConstDofs x, Real velocity_rate, Real acceleration_rate, const Mass& mass) override;
    Real length_scale(ConstDofs x) const override;  // the mean rest length; the extent of x when that is 0

private:
    const Springs& springs_;
    const VecX& mass_;
    // Each is made when it is asked for.
    std::optional<SpringMatrix<Dim>> matrix_;
    std::unique_ptr<SpringTangent> tangent_;
    VecX start_;  // where begin_step() took the directions of damping, m
};

}  // namespace pliant
