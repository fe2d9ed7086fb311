// Elastostatics in space by flat triangles with linear displacements and tractions on the surface of a body, direct formulation
// [Brebbia1984 §5]: H u = G t at the corners of the triangles.
#pragma once
#include <pliant/solids/bem/boundary_system.h>

namespace pliant {

class SpaceBoundaryElements {
public:
    using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;  // node numbers, anticlockwise seen from outside the body

    // Closed surfaces; unbounded: the body goes on without end around them, as rock around a cavity. Throws Refused, naming the
    // triangle, for one without area, a node out of range, or an edge that does not belong to two triangles that run along it in
    // opposite directions.
    SpaceBoundaryElements(Points<3> nodes, Triangles triangles, const Lame& material, bool unbounded);

    const BoundarySystem<3>& system() const { return system_; }
    const Triangles& triangles() const { return triangles_; }
    Vec<3> normal(Index triangle) const { return areas_.col(triangle).normalized(); }  // out of the body
    Real area(Index triangle) const { return areas_.col(triangle).norm(); }            // m^2

    // Fills the three rows of one node in both matrices; all of them must be filled before the system is solved.
    void assemble(Index node);
    void assemble();

    // Inside the body [m, Pa].
    Vec<3> displacement(const BoundarySolution<3>& s, const Vec<3>& X) const;
    Mat<3> stress(const BoundarySolution<3>& s, const Vec<3>& X) const;

private:
    using Corners = Mat<3>;  // a column each
    Corners corners(Index triangle) const;
    template <class Visit>
    void integrate(const Corners& whole, const Corners& part, Real area, const Vec<3>& X, int depth, Visit visit) const;
    void integrate_beside(Index triangle, Index node);
    void integrate_own(Index triangle, int own, Index node);

    Triangles triangles_;
    Points<3> areas_;  // outward, m^2
    KelvinSolution<3> kelvin_;
    BoundarySystem<3> system_;
};

}  // namespace pliant
