#include <pliant/solids/static_tests.h>

#include <pliant/continuum/moduli.h>
#include <pliant/math/error.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/linear_fem_static.h>

#include <array>

namespace pliant {
namespace {

// The same plates as those of test_block. u_y of a node at x on the plate of that side (-1/2 or 1/2).
Real plate_height(BlockTest test, Real side, Real x) {
    return test == BlockTest::stretch ? side : test == BlockTest::bend ? side * x : 0;
}

template <int Dim>
DisplacementConstraints<Dim> plates(const SimplexMesh<Dim>& mesh, const std::array<int, Dim>& cells, BlockTest test) {
    DisplacementConstraints<Dim> held(mesh.node_count());
    const Real top = mesh.points().row(1).maxCoeff();
    for (Index n = 0; n < mesh.node_count(); ++n) {
        const Real y = mesh.points()(1, n);
        if (y != 0 && y != top) continue;
        const Real side = y == top ? 0.5 : -0.5;
        held.prescribe(n, 1, plate_height(test, side, mesh.points()(0, n)));
        if (test != BlockTest::shear) continue;
        held.prescribe(n, 0, side);
        if (Dim == 3) held.prescribe(n, Dim - 1, 0);
    }
    if (test == BlockTest::shear) return held;
    // Against drifting and turning between the plates.
    const Index layer = (cells[0] + 1) * (cells[1] + 1), row = Dim == 3 ? layer * (cells[Dim - 1] / 2) : 0;
    held.prescribe(row + cells[0] / 2, 0, 0);
    if (Dim == 3) {
        held.prescribe(row + cells[0] / 2, Dim - 1, 0);
        held.prescribe(row + cells[0], Dim - 1, 0);
    }
    return held;
}

template <int Dim>
ContinuumResponse test_box(const SpringLattice& lattice, const Lame& material, Real thickness, BlockTest test) {
    BlockShape<Dim> box;
    for (int axis = 0; axis < Dim; ++axis) {
        box.size[axis] = lattice.lengths()[axis];
        box.cells[static_cast<std::size_t>(axis)] = static_cast<int>(lattice.nodes().cells()[static_cast<std::size_t>(axis)]);
        box.origin[axis] = axis == 1 ? 0 : -0.5 * box.size[axis];
    }
    const SimplexMesh<Dim> mesh = block_mesh<Dim>(box);
    const LinearFem<Dim> body(mesh, material);
    const Points<Dim> u =
        solve_static<Dim>(body, plates<Dim>(mesh, box.cells, test), Points<Dim>::Zero(Dim, mesh.node_count())).displacement;
    ContinuumResponse response{2 * thickness * body.strain_energy(u), Points<3>::Zero(3, mesh.node_count())};
    response.displacement.topRows<Dim>() = u;
    return response;
}

}  // namespace

ContinuumResponse test_continuum(const SpringLattice& lattice, Real youngs_modulus, Real poisson_ratio, BlockTest test) {
    const IsotropicModuli moduli = IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio);
    switch (dimension_of(lattice.kind())) {
        case 3:
            return test_box<3>(lattice, moduli.lame(), 1, test);
        case 2:
            return test_box<2>(lattice, moduli.plane_stress_lame(), lattice.edge(), test);
        default:
            throw Refused("a chain has no cross-section: it has no continuum beside it; choose another lattice");
    }
}

Real StaticTests::modulus_in_pascal(Real modulus, const SpringLattice& lattice) const {
    return dimension_of(lattice.kind()) == 2 ? modulus / lattice.edge() : modulus;
}

const std::vector<Real>& StaticTests::modulus_by_cells() const {
    if (!key_ || dimension_of(key_->kind) == 1) {
        modulus_by_cells_.clear();
        return modulus_by_cells_;
    }
    Key wanted = *key_;
    wanted.cells = {}, wanted.test = BlockTest::stretch, wanted.poisson_ratio = 0;
    if (measured_key_ == wanted) return modulus_by_cells_;
    measured_key_ = wanted;
    modulus_by_cells_.clear();
    const Real endless = lattice_constants(wanted.kind, wanted.stiffness, 1).youngs_modulus();
    try {
        for (Index n = 1; n <= most_cells; ++n)
            modulus_by_cells_.push_back(
                test_block(SpringLattice(wanted.kind, {n, n, n}, 1), wanted.stiffness, BlockTest::stretch, wanted.shared)
                    .youngs_modulus /
                endless);
    } catch (const Diverged&) {
        modulus_by_cells_.clear();
    }
    return modulus_by_cells_;
}

// Empty where elements give up: next to a Poisson ratio of 1/2 their matrix is singular to rounding.
std::optional<ContinuumResponse> StaticTests::continuum_beside(const SpringLattice& lattice, Real youngs_modulus,
                                                               const Key& key) {
    try {
        return test_continuum(lattice, youngs_modulus, key.poisson_ratio, key.test);
    } catch (const Diverged&) {
        return std::nullopt;
    }
}

void StaticTests::run(const SpringLattice& lattice, const Key& key) {
    if (knows(key)) return;
    key_.reset();
    response_ = test_block(lattice, key.stiffness, key.test, key.shared);
    coupling_.setZero();
    continuum_.reset();
    for (const BlockTest test : {BlockTest::stretch, BlockTest::shear, BlockTest::bend}) {
        if (dimension_of(key.kind) == 1 && test != BlockTest::stretch) continue;
        try {
            const BlockResponse r = test == key.test ? response_ : test_block(lattice, key.stiffness, test, key.shared);
            coupling_.row(static_cast<int>(test)) = Eigen::Map<const Vec<3>>(r.coupling.data()).transpose();
        } catch (const Diverged&) {
        }
    }
    const Real modulus = lattice_constants(key.kind, key.stiffness, key.edge).youngs_modulus();
    if (dimension_of(key.kind) > 1 && modulus > 0)
        continuum_ = continuum_beside(lattice, modulus_in_pascal(modulus, lattice), key);
    key_ = key;
}

}  // namespace pliant
