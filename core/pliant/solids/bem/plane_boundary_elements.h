// Elastostatics in the plane by boundary elements, direct formulation [Brebbia1984 §5]: at every node of the boundary
//   c u + ∫ T u = ∫ U t,     in matrices  H u = G t,
// with Kelvin's displacements U and tractions T. Per metre of thickness.
#pragma once
#include <pliant/solids/bem/boundary_curve.h>
#include <pliant/solids/bem/boundary_system.h>

namespace pliant {

class PlaneBoundaryElements {
public:
    static constexpr int dimension = 2;

    // The curve outlives this. material: the constants of the plane (KelvinSolution). Kelvin's logarithm is 0 far beyond the
    // curve, so that no size of the body makes the matrix singular, and every length unit gives the same numbers.
    PlaneBoundaryElements(const BoundaryCurve& curve, const Lame& material);

    const BoundaryCurve& curve() const { return *curve_; }
    const KelvinSolution<2>& kelvin() const { return kelvin_; }
    const BoundarySystem<2>& system() const { return system_; }

    // Fills the two rows of one node in both matrices; all of them must be filled before the system is solved.
    void assemble(Index node) { integrate(node), close(node); }
    void assemble();
    // In two parts: the integrals, and the node's own block of H, which a rigid translation gives (BoundarySystem::end_rows).
    void integrate(Index node);
    void close(Index node) { system_.end_rows(node); }
    void clear() { system_.clear(); }

    std::vector<BoundaryIntegrationPoint<2>> integration_points(Index element, Index node) const;
    InsideSums<2> inside_sums(const Vec<2>& X) const;

    using Solution = BoundarySolution<2>;
    // Where the conditions have a remote part, the sums inside lack it: add it. Stress on the boundary [Pa], in x and y: from the
    // traction, and from how the displacements stretch the boundary.
    Mat<2> boundary_stress(const Solution& s, Index element, Real xi) const;
    Vec<2> boundary_displacement(const Solution& s, Index element, Real xi) const;  // m
    // Inside the body [m, Pa]. Nearer to an element than a tenth of its length the error grows: distance() tells.
    Vec<2> displacement(const Solution& s, const Vec<2>& X) const;
    Mat<2> stress(const Solution& s, const Vec<2>& X) const;
    // From the nearest element, in its lengths.
    Real distance(const Vec<2>& X) const;

private:
    template <class Visit>
    void integrate(const BoundaryElement& e, const Vec<2>& X, Real from, Real to, int depth, Visit visit) const;
    template <class Visit>
    void integrate_own(const BoundaryElement& e, int own, const Vec<2>& X, Visit visit) const;
    void integrate_beside(Index element, Index node);
    Vec<2> traction_at(const Solution& s, Index element, Real xi) const;

    const BoundaryCurve* curve_;
    Lame material_;
    KelvinSolution<2> kelvin_;
    BoundarySystem<2> system_;
};

}  // namespace pliant
