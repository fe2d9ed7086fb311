// Four bodies that are tried by finite differences on a grid, and by finite elements beside it. Plane strain.
#pragma once
#include <pliant/solids/elastic_grid.h>

#include <optional>

namespace pliant {

enum class GridShape {
    rod,           // held at x = 0, no node moves across: a strip of one row of cells, in which P_xx = Y E_xx alone
    manufactured,  // a square held all around under a force whose displacement is known, SinesInSquare
    block,         // a square held at its bottom, under its weight
    disc           // about the origin, free at its rim, under the force of SpinningDisc
};

struct GridBody {
    GridShape shape = GridShape::rod;
    Energy energy = Energy::linear;
    Real youngs_modulus = 1, poisson_ratio = 0;  // Pa; a rod has no use for the latter
    Real length = 1;                             // L, m: of the rod, of the sides of the squares, the radius of the disc
    Real body_force = 0;                         // N/m^3: along -y of the block, outwards at the rim of the disc
    int resolution = 1;                          // cells along L
    Real amplitude = 0.1;                        // A of SinesInSquare

    Lame material() const;
    Real spacing() const { return length / resolution; }  // m
    EnergyDensity<2> density() const { return {energy, material()}; }
    Vec<2> force_density(const Vec<2>& X) const;  // N/m^3
    // Of the equilibrium, m, where it is known: of a disc at small strains alone.
    bool has_exact() const;
    Vec<2> exact(const Vec<2>& X) const;
};

class GridProblem {
public:
    // Throws Refused as moduli and grid do.
    explicit GridProblem(const GridBody& body);
    GridProblem(const GridProblem&) = delete;
    GridProblem& operator=(const GridProblem&) = delete;

    const GridBody& body() const { return body_; }
    const ElasticGrid<2>& grid() const { return grid_; }
    const DisplacementConstraints<2>& supports() const { return supports_; }
    const Points<2>& force_density() const { return force_density_; }  // of the load at the nodes, N/m^3
    Points<2> nodal_force() const;                                     // the same times what a node stands for, N/m
    // Are all neighbours of a difference formula of second order there? Those along the rod; of a rod those across move alike.
    bool has_stencil(Index node) const;

    // Largest component of u - exact [m] at a node.
    Real error(const Points<2>& displacement) const;
    // Equilibrium by Newton's method, m. Throws Diverged.
    Points<2> equilibrium() const;
    // Of small motions about rest, rad/s, the fastest. density: kg/m^3.
    Real highest_frequency(Real density) const;

private:
    GridBody body_;
    ElasticGrid<2> grid_;
    DisplacementConstraints<2> supports_;
    Points<2> force_density_;
};

// The same body in equilibrium by finite elements: triangles of first order with as many along L for what has an exact solution,
// of second order for the block.
struct FemBeside {
    Points<2> positions, displacement;  // m
    Index nodes = 0;
    Real error = 0;  // largest component of u - exact at a node, m
};
// Throws Diverged. The rod has none.
FemBeside finite_elements_beside(const GridBody& body);

// Parts of the field equation at a node of the grid that has_stencil(), from differences of second order, 1/m: of the
// displacement's component along an axis, and the 4-point cross derivative.
Vec<2> second_difference(const ElasticGrid<2>& grid, const Points<2>& u, Index node, int axis);
Vec<2> cross_difference(const ElasticGrid<2>& grid, const Points<2>& u, Index node);

}  // namespace pliant
