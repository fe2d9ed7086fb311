// A small beam of finite elements with everything that a time step needs, for tests.
#pragma once
#include <pliant/mesh/block_mesh.h>
#include <pliant/mesh/element_mass.h>
#include <pliant/solids/elastic_system.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/point_masses.h>

#include <cmath>
#include <vector>

namespace pliant::test {

inline constexpr Real moving_density = 1000;  // kg/m^Dim

template <int Dim>
SimplexMesh<Dim> small_beam() {
    BlockShape<Dim> shape;
    shape.cells.fill(1);
    shape.cells[0] = 3;
    shape.size[0] = 3;
    shape.split = CellSplit::diagonal;
    return block_mesh(shape);
}

template <int Dim, int Order = 1>
struct Moving {
    explicit Moving(Energy energy, const std::vector<Index>& fixed = {})
        : mesh(small_beam<Dim>()),
          body(mesh, energy, IsotropicModuli::from_young_poisson(1e5, 0.3).lame()),
          mass(lumped_mass(body.elements(), moving_density), Dim, fixed),
          system(body, body.elements().positions(), mass),
          x(body.elements().positions()),
          v(Points<Dim>::Zero(Dim, x.cols())) {}

    void shake(Real size) {
        for (Index k = 0; k < x.size(); ++k) {
            x.data()[k] += size * std::sin(3.0 * Real(k) + 1);
            v.data()[k] = std::cos(5.0 * Real(k));
        }
    }
    VecX force() const {
        VecX f(x.size());
        system.force(flat(x), flat(v), f);
        return f;
    }
    Real total_energy() const { return system.potential(flat(x)) + kinetic_energy<Dim>(system.node_mass(), v); }

    SimplexMesh<Dim> mesh;
    HyperelasticFem<Dim, Order> body;
    DiagonalMass mass;
    ElasticSystem<Dim> system;
    Points<Dim> x, v;
};

}  // namespace pliant::test
