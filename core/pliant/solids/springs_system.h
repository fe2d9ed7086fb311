// A spring net under gravity, pulled at a node, as the implicit solver sees it.
#pragma once
#include <pliant/solids/nodal_terms.h>
#include <pliant/solids/springs_matrix.h>
#include <pliant/solids/springs_tangent.h>
#include <pliant/time/implicit.h>

#include <memory>
#include <optional>

namespace pliant {

// A spring of rest length 0 from a node to a point in space, as a hand pulls.
template <int Dim>
struct PullSpring {
    Index node = -1;                     // none when negative
    Vec<Dim> target = Vec<Dim>::Zero();  // m
    Real stiffness = 0;                  // N/m

    bool active() const { return node >= 0 && stiffness > 0; }
    Vec<Dim> force(const Vec<Dim>& x) const { return stiffness * (target - x); }                   // N
    Real energy(const Vec<Dim>& x) const { return 0.5 * stiffness * (target - x).squaredNorm(); }  // J
};

// Loads on the nodes from outside of the net.
template <int Dim>
struct ExternalLoad {
    Vec<Dim> gravity = Vec<Dim>::Zero();  // m/s^2
    PullSpring<Dim> pull;
};

// f_i += m_i g, and the pull on its node, N. mass: kg, one per node.
template <int Dim>
void add_external_forces(const ExternalLoad<Dim>& load, const VecX& mass, PointsIn<Dim> x, PointsOut<Dim> f);

// Potential of those forces, J.
template <int Dim>
Real external_energy(const ExternalLoad<Dim>& load, const VecX& mass, PointsIn<Dim> x);

// Spring, damping and external forces together. The directions of projected damping are those of begin_step(). In 3D linearise()
// gives the net as a SpringTangent.
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
    const LinearisedSystem* linearise(ConstDofs x, Real velocity_rate, const VecX& added) override;
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
