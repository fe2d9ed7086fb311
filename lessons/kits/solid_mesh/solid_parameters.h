// The parameters that lessons about elastic bodies on a mesh share: material, shape, load. Each lesson says which of its scenes
// uses which.
#pragma once
#include "kits/material/material_parameters.h"
#include "solid.h"

#include <pliant/lesson/lesson.h>

namespace pliant::solid_mesh {

// When are they used? In terms of the parameters of the lesson alone.
struct Uses {
    std::function<bool()> law;         // a choice of the material law
    std::function<bool()> plane;       // a body that may be in the plane
    std::function<bool()> beam;        // a box with three sizes
    std::function<bool()> cells;       // cells along x and y; along z where `beam`
    std::function<bool()> load;        // along x and y
    std::function<bool()> space_load;  // along z
    std::function<bool()> panel = {};  // a rectangle with two sizes
};

// What the scene that a lesson opens with has.
struct Initial {
    Real youngs_modulus = 1e6, load_y = -200, height = 0.2, width = 0.2;  // Pa, N, m
    int cells_x = 8, cells_y = 2;
    Plane plane = Plane::stress;
};

struct SolidParameters {
    SolidParameters(Lesson& lesson, Uses uses, const Initial& initial = {});

    Choice<Law> law;
    Choice<Plane> plane;
    Number youngs_modulus, poisson_ratio;
    Number load_x, load_y, load_z;
    Number length, height, width;
    Whole cells_x, cells_y, cells_z;

    BodySettings settings(Shape shape, int order) const;
    Vec<3> load() const { return {load_x, load_y, load_z}; }  // N, in all
    // Refuses what no such body can be.
    void check(const BodySettings& s, bool in_plane, bool has_law) const;
};

}  // namespace pliant::solid_mesh
