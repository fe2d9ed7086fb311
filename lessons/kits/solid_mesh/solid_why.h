// Why the elements and nodes of an elastic body have the numbers that they have: from the material and the displacements of its
// nodes to F, strain, stress, the element's stiffness and the force on a node. For lessons whose fields are called displacement,
// rest_volume, deformation_gradient, rotation (of the corotational law), strain, stress, element_stiffness, internal_force.
#pragma once
#include "solid_parameters.h"

#include <pliant/lesson/explanation.h>

namespace pliant::solid_mesh {

struct SolidWhy {
    const Solid* solid;
    const SolidParameters* parameters;

    bool linear() const { return solid->settings().law == Law::linear; }
    bool first_order() const { return solid->settings().order == 1; }
    // Row and column of a component of a tensor that a field holds row by row.
    int row(int component) const { return component / solid->dim(); }
    int column(int component) const { return component % solid->dim(); }
    Input entry_now(std::string_view symbol, std::string_view field, Index element, int i, int j) const;

    Input mu() const, lambda() const;
    Explanation volume(Index element) const;
    Explanation deformation(Index element, int i, int j) const;
    Explanation rotation(Index element, int i, int j) const;
    Explanation strain(Index element, int i, int j) const;
    Explanation stress(Index element, int i, int j) const;
    Explanation von_mises(Index element) const;
    // Entry (i, j) of block (a, a) of K_e.
    Explanation stiffness(Index element, int a, int i, int j) const;
    // On a node, from its elements.
    Explanation internal_force(Index node, int component) const;
    // The same from the displacements of all nodes about it, at once.
    Explanation force_of_patch(Index node, int component) const;
    Input place_at_rest(Index node, int axis) const;

private:
    std::vector<Input> all_entries(std::string_view symbol, std::string_view field, Index element) const;
    Input hooke(std::string_view left, std::string_view strain_symbol, Index element, int i, int j) const;
};

}  // namespace pliant::solid_mesh
