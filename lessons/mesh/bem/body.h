// The bodies of the lesson: their boundary in elements, in the plane or in space, and the places inside that are looked at.
// Vectors have three numbers in both; the third is 0 in the plane.
#pragma once
#include <pliant/solids/bem/exact_bodies.h>
#include <pliant/solids/bem/plane_boundary_elements.h>
#include <pliant/solids/bem/space_boundary_elements.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace pliant::bem {

enum class Setting { hole, plate_with_hole, ring, outline, cavity_3d };

// All that a body follows from. In space displacements and tractions are linear over triangles that bend onto the sphere.
struct BodyPlan {
    Setting setting = Setting::hole;
    BoundaryOrder order = BoundaryOrder::quadratic;
    int elements = 0;               // on the hole, on each circle, on the outline; of a cavity triangles
    Vec<2> hole, half_sizes;        // m
    Real inner = 0, outer = 0;      // m
    std::vector<Vec<2>> corners{};  // of the outline, m
    Lame material;                  // of the plane, or of space
    bool inside = true;
};
// What the plan comes to, without the matrices. Throws Refused as BoundaryCurve does.
std::vector<BoundaryLoop> boundary_loops(const BodyPlan& plan);
BoundaryCurve boundary_curve(const BodyPlan& plan);
int cavity_cuts(const BodyPlan& plan);  // 20 of their square is the number of triangles
Index unknowns_of(const BodyPlan& plan);

// A place on a plane boundary.
struct OnBoundary {
    Index element = -1;
    Real xi = 0;
};

// Places inside, and the triangles between them and the boundary that a picture is made of.
struct InsideMesh {
    struct Corner {
        Index particle;     // whose numbers it shows
        OnBoundary edge{};  // where it lies, if on the boundary
    };
    std::vector<Vec<3>> particles;  // m
    std::vector<Corner> corners;
    std::vector<std::array<int, 3>> triangles;
    Index section_first = 0, section_count = 0;  // of the particles: along the x axis, from the wall outward
};

class Body {
public:
    explicit Body(const BodyPlan& plan);
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

    const BodyPlan& plan() const { return plan_; }
    bool in_space() const { return space_ != nullptr; }
    int dimension() const { return in_space() ? 3 : 2; }
    const BoundaryCurve& curve() const { return *curve_; }

    // f(the elements, their solution), in the plane or in space.
    template <class F>
    auto with(F f) const {
        return space_ ? f(std::as_const(*space_), space_solution_) : f(std::as_const(*plane_), plane_solution_);
    }
    template <class F>
    auto change(F f) {
        return space_ ? f(*space_, space_solution_) : f(*plane_, plane_solution_);
    }
    const PlaneBoundaryElements& plane() const { return *plane_; }
    const BoundarySolution<2>& plane_solution() const { return plane_solution_; }
    const SpaceBoundaryElements& space() const { return *space_; }

    Index element_count() const { return middles.cols(); }
    Index node_count() const { return nodes.cols(); }
    Index slot_count() const { return slot_normals.cols(); }
    Index unknowns() const { return dimension() * node_count(); }
    int nodes_per_element() const { return in_space() ? 3 : nodes_of(plan_.order); }
    Index node_of(Index element, int a) const {
        return with([&](const auto& bem, const auto&) { return bem.system().node_of_slot(bem.system().slot_of(element, a)); });
    }
    Index slot_of(Index element, int a) const {
        return with([&](const auto& bem, const auto&) { return bem.system().slot_of(element, a); });
    }
    // Which loop, or side of the outline, counted from 0.
    int arc(Index element) const;
    // The loop that is pressed: the hole's, the inner circle, the cavity.
    bool on_inner(Index element) const { return element >= inner_first_; }
    // On the hole or on the circles, at an angle from the x axis.
    OnBoundary inner_at(Real angle) const;
    Vec<3> place(const OnBoundary& at) const;         // m
    Vec<3> displacement(const OnBoundary& at) const;  // m
    Mat<3> stress(const OnBoundary& at) const;        // Pa

    bool contains(const Vec<3>& X) const;
    Real distance(const Vec<3>& X) const;  // from the nearest element, in its lengths

    const InsideMesh& inside() const { return inside_; }
    // Where the person looks: the last of the particles.
    Index point() const { return static_cast<Index>(inside_.particles.size()) - 1; }
    void set_point(const Vec<3>& X) { inside_.particles.back() = X; }

    Points<3> nodes, middles, normals, slot_normals;  // m
    VecX sizes;                                       // length of an element between its ends [m], or area [m²]

private:
    void measure_plane(), measure_space();

    BodyPlan plan_;
    std::unique_ptr<BoundaryCurve> curve_;
    std::unique_ptr<PlaneBoundaryElements> plane_;
    std::unique_ptr<SpaceBoundaryElements> space_;
    BoundarySolution<2> plane_solution_;
    BoundarySolution<3> space_solution_;
    Index inner_first_ = 0;
    InsideMesh inside_;
};

// Of the places inside such a body; the last is left for the person's.
InsideMesh inside_mesh(const Body& body);

// 2 × 2 in the corner of 3 × 3, and a pair with a third number 0.
inline Vec<3> in_three(const Vec<2>& v) { return {v.x(), v.y(), 0}; }
inline Vec<3> in_three(const Vec<3>& v) { return v; }
inline Mat<3> in_three(const Mat<2>& m) {
    Mat<3> all = Mat<3>::Zero();
    all.topLeftCorner<2, 2>() = m;
    return all;
}
inline Mat<3> in_three(const Mat<3>& m) { return m; }

}  // namespace pliant::bem
