// Why nodes, supports and elements of a linear elastic body have the numbers that they have: one row of K u = f, the strain of an
// element, Hooke's law. For lessons whose fields are called displacement, load, residual, strain and stress.
#pragma once
#include <pliant/lesson/lesson.h>
#include <pliant/solids/linear_fem_static.h>

#include <array>
#include <functional>

namespace pliant::linear_body {

// Of the formulas of such a lesson: shape functions, areas, stiffness, Lamé's constants.
inline std::vector<Symbol> symbols_and(std::vector<Symbol> own) {
    own.insert(own.end(), {{"N"}, {"dA", "m²"}, {"K", "N/m"}, {"λ", "Pa"}, {"μ", "Pa"}});
    return own;
}

// Row `row` of K x = b, solved for its own unknown: x_a = (b_a − Σ K_ab x_b) / K_aa. The unknowns are the numbers of a field
// whose rows begin with the nodes' at `first_row`.
struct RowOfEquations {
    const SparseMatrix* matrix;
    Index row;
    std::string_view unknown, field;  // "u", "displacement"
    Index first_row = 0;
    Real added_to_diagonal = 0;  // N/m
};
// right: what stands on the right side; the first counts, others are subtracted.
template <int Dim>
Explanation why_unknown(const RowOfEquations& equations, std::vector<Input> right);

// What the solver has not balanced stands in the row as the residual, if the lesson has it.
Explanation why_displacement(const StaticProblem<3>& problem, Index node, int component, bool has_residual);
Explanation why_residual(const StaticProblem<3>& problem, Index node, int component);

// "ū_max", the mean over nodes of a face; their rows in the field of displacements begin at `first_row`.
Input mean_displacement(std::string_view face, const std::vector<Index>& nodes, int component, Index first_row = 0);

// From the corners' displacements and the slopes of the corners' shape functions.
Explanation why_strain(const SimplexMesh<3>& mesh, Index element, int row, int column);

// Hooke's law; from_displacement: where the field of strains is not evaluated yet.
struct Hooke {
    const SimplexMesh<3>* mesh;
    Input lambda, mu;
    Explanation why_stress(Index element, int row, int column, bool from_displacement = false) const;
};

// Summed over the elements of the node, each of which takes its stress times the slope of the node's shape function.
Explanation why_reaction(const StaticProblem<3>& problem, const Hooke& hooke, Index node, int component);

}  // namespace pliant::linear_body
