// The boundary of a plane body in elements: closed loops of arcs, the body to the left of each. Every element has the shape
// functions of its order for displacements and tractions; where the boundary turns a corner, the nodes of the elements beside it
// keep off the corner, since the traction has two values there [Brebbia1984 §5.4].
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace pliant {

enum class BoundaryOrder { constant, linear, quadratic };
constexpr int nodes_of(BoundaryOrder order) { return static_cast<int>(order) + 1; }

// Part of a loop, from s = 0 to 1 [m]; it begins where the arc before it ends.
struct BoundaryArc {
    std::function<Vec<2>(Real)> point;
    int elements = 1;
};
BoundaryArc straight_arc(const Vec<2>& from, const Vec<2>& to, int elements);
// Of an ellipse about `centre` with half axes along x and y, between two angles [rad]: clockwise where the second is smaller.
BoundaryArc elliptic_arc(const Vec<2>& centre, const Vec<2>& half_axes, Real from, Real to, int elements);

using BoundaryLoop = std::vector<BoundaryArc>;

struct BoundaryElement {
    std::array<Vec<2>, 3> shape;  // start, middle and end [m]; the middle of a straight one lies half way
    std::array<int, 3> nodes{-1, -1, -1};
    std::array<Real, 3> at{};   // where its nodes lie, in [-1, 1]
    int count = 0;              // of nodes
    int arc = 0;                // counted over all loops
    int before = 0, after = 0;  // its neighbours in the loop

    Vec<2> point(Real xi) const;    // m
    Vec<2> tangent(Real xi) const;  // d point / d xi [m]
    Vec<2> normal(Real xi) const;   // unit vector out of the body
    Vec<3> values(Real xi) const;   // shape functions of its nodes; 0 beyond their count
    Vec<3> slopes(Real xi) const;   // their derivatives
};

class BoundaryCurve {
public:
    // Straight elements for the constant and the linear order, curved ones for the quadratic. Throws Refused, naming loop or
    // element, for a loop that is not closed, an element without length, fewer than three elements, or a loop that crosses
    // itself; and where the loops do not run round one body: the first one anticlockwise about it and the others clockwise about
    // its holes, or all of them clockwise where the body goes on without end.
    BoundaryCurve(std::span<const BoundaryLoop> loops, BoundaryOrder order, bool unbounded = false);

    BoundaryOrder order() const { return order_; }
    bool unbounded() const { return unbounded_; }
    const std::vector<BoundaryElement>& elements() const { return elements_; }
    Index node_count() const { return nodes_.cols(); }
    const Points<2>& nodes() const { return nodes_; }  // m, where the integral equation is asked to hold

private:
    void add_loop(const BoundaryLoop& loop, int loop_number, int first_arc);
    void number_nodes(std::size_t first, std::size_t count);
    void check_turn(std::size_t first, std::size_t count, int loop) const;

    BoundaryOrder order_;
    bool unbounded_;
    std::vector<BoundaryElement> elements_;
    Points<2> nodes_;
};

}  // namespace pliant
