// Corotational elements by warped stiffness [Mueller2002, Mueller2004]: the stiffness K of each linear simplex is that of rest,
// and what turns with the element is left out of its strain,
//   f = R K (R^T x - X),
// with the rotation R nearest to the element's F. The energy 1/2 (R^T x - X)^T K (R^T x - X) is that of Energy::corotated, and f
// is its derivative, to rounding: a change of R does no work, because the stress is symmetric in the turned axes.
//
// The tangent is the lecture's, R K R^T, as if R stood still. Energy::corotated has the derivative of R too: its tangent is the
// exact one, which may be indefinite where an element is compressed. This one never is, and costs no derivative and no
// eigenvalues; Newton's method converges with it step by step in a fixed ratio instead of quadratically.
#pragma once
#include <pliant/solids/hyperelastic_fem.h>

#include <array>
#include <vector>

namespace pliant {

// In 2D per metre of thickness: IsotropicModuli::lame() for plane strain, plane_stress_lame() for plane stress.
template <int Dim>
class WarpedStiffness final : public ElasticBody<Dim> {
public:
    using Body = HyperelasticFem<Dim, 1>;
    using ElementMatrix = typename Body::ElementMatrix;

    // The mesh outlives this. Throws Refused, naming the element, for a material that is not stable.
    WarpedStiffness(const SimplexMesh<Dim>& mesh, const Lame& material) : body_(mesh, Energy::corotated, material) {}
    WarpedStiffness(const SimplexMesh<Dim>& mesh, const std::vector<Lame>& materials)
        : body_(mesh, Energy::corotated, materials) {}

    const SimplexMesh<Dim>& mesh() const { return body_.mesh(); }
    // The same energy as a function of F, with its stress and its exact tangent.
    const Body& hyperelastic() const { return body_; }

    // det R = 1 for every element, flat, inverted or a point.
    Mat<Dim> rotation(Index element, const Points<Dim>& displacement) const;
    // K of rest [N/m].
    ElementMatrix rest_stiffness(Index element) const;
    // R K R^T [N/m].
    ElementMatrix element_stiffness(Index element, const Points<Dim>& displacement) const {
        return turned_stiffness(element, rotation(element, displacement));
    }

    Index node_count() const override { return body_.node_count(); }
    void check_support(const DisplacementConstraints<Dim>& constraints) const override { body_.check_support(constraints); }
    Real energy(const Points<Dim>& displacement) const override;
    void internal_force(const Points<Dim>& displacement, Points<Dim>& force) const override;
    // Positive semi-definite either way.
    void stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const override;
    const SparseMatrix& pattern() const override { return body_.pattern(); }
    Real admissible_share(const Points<Dim>&, const Points<Dim>&) const override { return 1; }

private:
    ElementMatrix turned_stiffness(Index element, const Mat<Dim>& R) const;
    // The rotations of all elements, kept for the two latest places that were asked about: a step asks for energy, force and
    // stiffness at the same one.
    struct Rotations {
        Points<Dim> displacement;
        std::vector<Mat<Dim>> of;
    };
    const std::vector<Mat<Dim>>& rotations(const Points<Dim>& displacement) const;

    Body body_;
    mutable std::array<Rotations, 2> kept_;
    mutable std::size_t latest_ = 0;
};

}  // namespace pliant
