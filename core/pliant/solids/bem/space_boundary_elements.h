// Elastostatics in space by triangles on the surface of a body, direct formulation [Brebbia1984 §5]: H u = G t at the nodes of
// the triangles. Constant: flat, one node in the middle; linear: flat, nodes at the corners; quadratic: six nodes, curved.
#pragma once
#include <pliant/solids/bem/boundary_curve.h>
#include <pliant/solids/bem/boundary_system.h>
#include <pliant/solids/bem/triangle_surface.h>

#include <functional>

namespace pliant {

class SpaceBoundaryElements {
public:
    static constexpr int dimension = 3;
    using Triangles = SurfaceTriangles;

    // Closed surfaces; unbounded: the body goes on without end around them, as rock around a cavity. onto_surface moves the
    // middle of an edge of curved triangles onto the surface that is meant; without it edges are straight. Throws Refused, naming
    // the triangle, for one without area, a corner out of range, or an edge that does not belong to two triangles that run along
    // it in opposite directions.
    SpaceBoundaryElements(Points<3> corners, Triangles triangles, const Lame& material, bool unbounded,
                          BoundaryOrder order = BoundaryOrder::linear,
                          const std::function<Vec<3>(const Vec<3>&)>& onto_surface = {});

    const BoundarySystem<3>& system() const { return system_; }
    const KelvinSolution<3>& kelvin() const { return kelvin_; }
    const Triangles& triangles() const { return triangles_; }
    Index triangle_count() const { return triangles_.cols(); }
    int nodes_per_triangle() const { return order_ == BoundaryOrder::constant ? 1 : order_ == BoundaryOrder::linear ? 3 : 6; }
    // Of the system; node a of a triangle: corners, then the middles of the edges (0, 1), (1, 2), (0, 2).
    int node(Index triangle, int a) const { return nodes_(a, triangle); }
    Vec<3> normal(Index triangle) const;  // out of the body, in the middle
    Vec<3> area_vector(Index triangle) const {
        return place(triangle, Vec<3>::Constant(1.0 / 3)).area;
    }                                                             // of the parallelogram of its tangents there, m^2
    Vec<3> normal_at_node(Index triangle, int a) const;           // of a triangle that the node belongs to
    Real area(Index triangle) const { return areas_[triangle]; }  // m^2
    Vec<3> middle(Index triangle) const;                          // m
    Vec<3> corner(Index triangle, int a) const { return shape_points_.col(shape_(a, triangle)); }  // m
    // Middle of the edge between corners a and a + 1 [m].
    Vec<3> edge_middle(Index triangle, int a) const { return shape_points_.col(shape_(a < 2 ? 3 + a : 5, triangle)); }

    // Fills the three rows of one node in both matrices; all of them must be filled before the system is solved.
    void assemble(Index node) { integrate(node), close(node); }
    void assemble();
    // In two parts, as PlaneBoundaryElements has it.
    void integrate(Index node);
    void close(Index node) { system_.end_rows(node); }
    void clear() { system_.clear(); }

    std::vector<BoundaryIntegrationPoint<3>> integration_points(Index triangle, Index node) const;
    InsideSums<3> inside_sums(const Vec<3>& X) const;

    // Stress in the middle of a triangle [Pa], from its traction and from how its displacements stretch it. Not of constant ones.
    Mat<3> boundary_stress(const BoundarySolution<3>& s, Index triangle) const;
    // Inside the body [m, Pa].
    Vec<3> displacement(const BoundarySolution<3>& s, const Vec<3>& X) const;
    Mat<3> stress(const BoundarySolution<3>& s, const Vec<3>& X) const;

private:
    using Shape = Eigen::Matrix<Real, 6, 1>;
    using Barycentric = Mat<3>;  // of the corners of a part of a triangle, a column each
    struct Place {
        Vec<3> point, area;  // m; outward, as large as the parallelogram of the tangents [m^2]
    };
    BoundarySystem<3> make_system(const Lame& material, bool unbounded, const std::function<Vec<3>(const Vec<3>&)>& onto_surface);
    void bend(const std::function<Vec<3>(const Vec<3>&)>& onto_surface);
    void number_nodes();
    Place place(Index triangle, const Vec<3>& barycentric) const;
    Mat<3> tangents(Index triangle, const Vec<3>& barycentric) const;
    Shape shape(const Vec<3>& barycentric) const;
    Vec<3> barycentric_of_node(int a) const;
    std::vector<BoundarySystem<3>::Element> elements();
    template <class Visit>
    void integrate(Index triangle, const Barycentric& part, Real share, const Vec<3>& X, int depth, Visit visit) const;
    template <class Visit>
    void integrate_own(Index triangle, const Vec<3>& source, const Vec<3>& X, Visit visit) const;
    void integrate_beside(Index triangle, Index node);
    int own_of(Index triangle, Index node) const;  // which of its nodes it is; -1 for none

    BoundaryOrder order_;
    bool curved_;
    Triangles triangles_;
    Points<3> shape_points_, node_points_;
    Eigen::Matrix<int, 6, Eigen::Dynamic> shape_, nodes_;  // what bends a triangle; its nodes
    VecX areas_;
    KelvinSolution<3> kelvin_;
    BoundarySystem<3> system_;
};

}  // namespace pliant
