// Three bodies under a uniform stress, which linear elements reproduce exactly on any mesh: a round post that carries a weight, a
// rod that is pulled or pressed, and a block that is loaded on all sides and cut in thought.
#pragma once
#include <pliant/solids/linear_fem_static.h>

namespace pliant {

enum class LoadCase { disc, rod, cut };

struct LoadedBodySize {
    Real radius;         // m, of the post
    Real length, width;  // m: height of the post, or length and thickness of rod and block
    int resolution;      // cells across
};

class LoadedBody {
public:
    LoadedBody(LoadCase load, const IsotropicModuli& material, const LoadedBodySize& size);
    LoadedBody(const LoadedBody&) = delete;
    LoadedBody& operator=(const LoadedBody&) = delete;

    const SimplexMesh<3>& mesh() const { return mesh_; }
    const LinearFem<3>& body() const { return body_; }
    const StaticProblem<3>& problem() const { return problem_; }

    // Along it the post and the rod are loaded: 1 (up) and 0.
    int axis() const { return load_ == LoadCase::disc ? 1 : 0; }
    // Each node's share of the loaded faces [m^2], outward: a stress puts the force stress · share on the node.
    const Points<3>& loaded_area() const { return loaded_area_; }

    // --- read off the solution ---
    // Area of the face that is held [m^2].
    Real support_area() const;
    // Force with which the support pulls at the body along its axis [N]: positive in tension.
    Real support_force(const Points<3>& reaction) const;
    // dL [m]: how far the loaded face has moved from the one that is held.
    Real lengthening(const Points<3>& displacement) const;
    // Mean of the strain across the axis.
    Real transverse_strain(const Points<3>& displacement) const;
    // Mean over the volume of a tensor per element.
    Mat<3> mean(const Tensors<3>& tensors) const;

    // The faces at the ends of the axis.
    std::string held_face() const { return load_ == LoadCase::disc ? "y_min" : "x_min"; }
    std::string loaded_face() const { return load_ == LoadCase::disc ? "y_max" : "x_max"; }

private:
    LoadCase load_;
    SimplexMesh<3> mesh_;
    LinearFem<3> body_;
    StaticProblem<3> problem_;
    Points<3> loaded_area_;
};

}  // namespace pliant
