// H u = G t of boundary elements, in the plane or in space: the two dense matrices, what is known on the boundary, and the
// solution for what is not [Brebbia1984 §5.5].
#pragma once
#include <pliant/solids/bem/kelvin.h>

#include <array>
#include <vector>

namespace pliant {

// What is known on the boundary: for each node of each element (a slot) and each component its traction [Pa], or its displacement
// [m]. Component k of slot s has number Dim s + k.
struct BoundaryConditions {
    std::vector<char> held;  // is the displacement given?
    VecX value;
    // Where the body goes on without end: the displacement of each node that there would be without this boundary, by what acts
    // far away [m]. Empty: nothing does.
    VecX remote{};
};

template <int Dim>
struct BoundarySolution {
    Points<Dim> displacement;    // of the nodes [m]
    Points<Dim> traction;        // of the slots [Pa]
    Index free_rigid_modes = 0;  // that the conditions leave, and that were taken out
    // The motions that were taken out, one a column, and what of them the equations leave unbalanced: H u = G t − modes × these.
    MatX modes{};
    VecX unbalanced{};  // m
    VecX right_side{};  // of A x = b, without the rows of the motions [m]
};

// What the integrals over an element are summed from, seen from a node: a point adds weight × N_a T to H, and N_a (weight × U +
// log_part I) to G, for each node a of the element. Where the element holds the node, log_part is the part of U that grows like
// a logarithm, integrated by weights of its own, and nothing is added to H for the node itself.
template <int Dim>
struct BoundaryIntegrationPoint {
    Eigen::Matrix<Real, 6, 1> shape;  // N
    Real weight;                      // m^(Dim-1)
    Mat<Dim> U, T;                    // Kelvin's
    Real log_part = 0;                // m/Pa
};

// Displacement [m] and stress [Pa] at a point are sums over the boundary: rows u_x, u_y, ..., then the stress row by row; what
// the tractions of the slots and the displacements of the nodes, component by component, are multiplied by.
template <int Dim>
struct InsideSums {
    MatX of_traction, of_displacement;

    VecX rows(const BoundarySolution<Dim>& s) const {
        return of_traction * flat(s.traction) + of_displacement * flat(s.displacement);
    }
    Vec<Dim> displacement(const BoundarySolution<Dim>& s) const { return rows(s).template head<Dim>(); }
    Mat<Dim> stress(const BoundarySolution<Dim>& s) const { return rows(s).template tail<Dim * Dim>().reshaped(Dim, Dim); }
};

template <int Dim>
class BoundarySystem {
public:
    static constexpr int most_nodes = 6;  // of a curved triangle
    // An element as the system sees it: its nodes, and the integrals of the products of their shape functions [m^(Dim-1)].
    struct Element {
        std::array<int, most_nodes> nodes{-1, -1, -1, -1, -1, -1};
        int count = 0;
        Mat<most_nodes> products = Mat<most_nodes>::Zero();
    };
    BoundarySystem(Points<Dim> nodes, std::vector<Element> elements, const Lame& material, bool unbounded);

    Index node_count() const { return nodes_.cols(); }
    const Points<Dim>& nodes() const { return nodes_; }  // m
    Index unknowns() const { return Dim * node_count(); }
    // Nodes of elements, of which neighbours share some: tractions may jump there.
    Index slot_count() const { return static_cast<Index>(node_of_slot_.size()); }
    Index slot_of(Index element, int node) const { return first_slot_[static_cast<std::size_t>(element)] + node; }

    const Element& element(Index k) const { return elements_[static_cast<std::size_t>(k)]; }
    Index node_of_slot(Index slot) const { return node_of_slot_[static_cast<std::size_t>(slot)]; }

    // --- filling: the rows of one node at a time ---
    void clear();
    void begin_rows(Index node);
    void add_traction(Index node, int at_node, const Mat<Dim>& T) { H_.template block<Dim, Dim>(Dim * node, Dim * at_node) += T; }
    void add_displacement(Index node, Index slot, const Mat<Dim>& U) { G_.template block<Dim, Dim>(Dim * node, Dim * slot) += U; }
    // c and the integral of T near the node follow from a rigid translation: the blocks of H in a row sum to 0, or to I where the
    // body goes on without end.
    void end_rows(Index node);

    const MatX& H() const { return H_; }  // unknowns × unknowns
    const MatX& G() const { return G_; }  // unknowns × (Dim slots), m/Pa

    // Free of traction everywhere, to be filled in.
    BoundaryConditions free_boundary() const;
    // Throws Refused for a value that is not finite, a node with two displacements, or tractions that do not balance where
    // nothing else holds the body: then with their resultant force and moment. What rigid motion the conditions leave to a body
    // is taken out: its nodes do not move on average, as far as they may. Throws Diverged when the matrix is singular. Tells its
    // progress, and can be called off.
    BoundarySolution<Dim> solve(const BoundaryConditions& conditions) const;

private:
    struct Held {
        std::vector<char> held;  // per unknown
        VecX displacement;       // where held [m]
    };
    Held find_held(const BoundaryConditions& conditions) const;
    MatX free_rigid_motions(const Held& held) const;
    void require_balance(const BoundaryConditions& conditions, const MatX& modes) const;

    Points<Dim> nodes_;
    std::vector<Element> elements_;
    Real shear_;
    bool unbounded_;
    std::vector<Index> first_slot_;
    std::vector<int> node_of_slot_;
    MatX H_, G_;
};

}  // namespace pliant
