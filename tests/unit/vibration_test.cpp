// Masses of elements, frequencies of a bar, and the time steps at which explicit schemes stay stable.
#include <pliant/math/dense_matrix.h>
#include <pliant/mesh/element_mass.h>
#include <pliant/solids/elastic_system.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/point_masses.h>
#include <pliant/time/stability.h>
#include <pliant/time/time_integrator.h>
#include <pliant/time/vibration.h>
#include "fem_body.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <memory>

using namespace pliant;

namespace {

constexpr Real bar_density = 1000, bar_modulus = 1e5;

template <int Dim>
SimplexMesh<Dim> bar_block(int cells_x, Real length, int cells) {
    BlockShape<Dim> shape;
    shape.cells.fill(cells);
    shape.cells[0] = cells_x;
    shape.size[0] = length;
    shape.split = CellSplit::diagonal;
    return block_mesh(shape);
}

// Frequencies squared, ascending, of what is not held.
VecX squared_frequencies(const SparseMatrix& stiffness, const SparseMatrix& mass, const std::vector<char>& held) {
    std::vector<Index> free;
    for (std::size_t d = 0; d < held.size(); ++d)
        if (!held[d]) free.push_back(static_cast<Index>(d));
    const MatX K = MatX(stiffness)(free, free), M = MatX(mass)(free, free);
    const DenseEigen m = dense_eigen(M);
    const MatX root = m.vectors * m.values.cwiseSqrt().cwiseInverse().asDiagonal() * m.vectors.transpose();
    return dense_eigen(root * K * root).values;
}

SparseMatrix diagonal_matrix(const DiagonalMass& mass) {
    SparseMatrix M(mass.size(), mass.size());
    for (Index d = 0; d < mass.size(); ++d) M.insert(d, d) = mass.mass()[d];
    return M;
}

// A bar of 1 m fixed at x = 0 whose nodes move along x alone, without Poisson's effect.
template <int Order>
struct HeldBar {
    explicit HeldBar(int cells) : mesh(bar_block<2>(cells, 1, 1)), body(mesh, Energy::linear, {0, bar_modulus / 2}) {
        const auto& X = body.elements().positions();
        held.assign(static_cast<std::size_t>(2 * X.cols()), 0);
        for (Index n = 0; n < X.cols(); ++n) {
            held[static_cast<std::size_t>(2 * n + 1)] = 1;
            if (X(0, n) < 1e-9) held[static_cast<std::size_t>(2 * n)] = 1;
        }
        stiffness = body.pattern();
        body.stiffness(Points<2>::Zero(2, X.cols()), false, stiffness);
    }
    DiagonalMass lumped() const { return DiagonalMass::with_held(lumped_mass(body.elements(), bar_density), 2, held); }
    SparseMatrix consistent() const { return consistent_mass(body.elements(), bar_density); }
    // First frequency over the exact one, (pi/2) sqrt(E/rho)/L, less 1.
    Real error(const SparseMatrix& mass) const {
        const Real exact = std::numbers::pi / 2 * std::sqrt(bar_modulus / bar_density);
        return std::sqrt(squared_frequencies(stiffness, mass, held)[0]) / exact - 1;
    }
    SimplexMesh<2> mesh;
    HyperelasticFem<2, Order> body;
    std::vector<char> held;
    SparseMatrix stiffness;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("masses of elements: totals, and the energy of a turning body", "[vibration]",
                       ((int Dim, int Order), Dim, Order), (2, 1), (2, 2), (3, 1), (3, 2)) {
    const SimplexMesh<Dim> mesh = bar_block<Dim>(2, 3, 2);
    const SimplexElements<Dim, Order> elements(mesh);
    const VecX lumped = lumped_mass(elements, bar_density);
    const SparseMatrix consistent = consistent_mass(elements, bar_density);
    CHECK(std::abs(lumped.sum() / (bar_density * mesh.volume()) - 1) < 1e-13);
    CHECK((lumped.array() > 0).all());
    CHECK(consistent.nonZeros() == (HyperelasticFem<Dim, Order>(mesh, Energy::linear, {0, 1}).pattern().nonZeros()));
    // A spin of 1 rad/s about an axis through the origin of a box of L × 1 (× 1): the integral of rho (x^2 + y^2).
    Points<Dim> v = Points<Dim>::Zero(Dim, elements.node_count());
    v.row(0) = -elements.positions().row(1);
    v.row(1) = elements.positions().row(0);
    const Real moment = bar_density * 3 * (9 + 1) / 3.0;
    CHECK(std::abs(flat(v).dot(consistent * flat(v)) / moment - 1) < 1e-12);
    CHECK_THROWS(lumped_mass(elements, 0));
    CHECK_THROWS(consistent_mass(elements, -1));
}

TEST_CASE("a bar's first frequency comes from below with a lumped mass and from above with a consistent one", "[vibration]") {
    std::array<Real, 2> lumped{}, consistent{};
    for (int k = 0; k < 2; ++k) {
        const HeldBar<1> bar(4 << k);
        lumped[static_cast<std::size_t>(k)] = bar.error(diagonal_matrix(bar.lumped()));
        consistent[static_cast<std::size_t>(k)] = bar.error(bar.consistent());
    }
    CHECK((lumped[1] < 0 && consistent[1] > 0));
    // Order 2 either way.
    CHECK(std::abs(std::log2(lumped[0] / lumped[1]) - 2) < 0.1);
    CHECK(std::abs(std::log2(consistent[0] / consistent[1]) - 2) < 0.1);
    // Elements of second order: order 4 with the consistent mass.
    const Real coarse = HeldBar<2>(2).error(HeldBar<2>(2).consistent()), fine = HeldBar<2>(4).error(HeldBar<2>(4).consistent());
    CHECK(fine > 0);
    CHECK(std::abs(std::log2(coarse / fine) - 4) < 0.3);
}

TEMPLATE_TEST_CASE_SIG("the fastest mode is that of the dense eigenproblem", "[vibration]", ((int Dim, int Order), Dim, Order),
                       (2, 1), (2, 2), (3, 1), (3, 2)) {
    const SimplexMesh<Dim> mesh = bar_block<Dim>(2, 1, 2);
    const HyperelasticFem<Dim, Order> body(mesh, Energy::linear, IsotropicModuli::from_young_poisson(bar_modulus, 0.3).lame());
    SparseMatrix K = body.pattern();
    body.stiffness(Points<Dim>::Zero(Dim, body.node_count()), false, K);
    std::vector<char> held(static_cast<std::size_t>(K.rows()), 0);
    for (const bool supported : {false, true}) {
        if (supported)
            for (const Index n : body.elements().nodes_of_facets("x_min"))
                for (int k = 0; k < Dim; ++k) held[static_cast<std::size_t>(Dim * n + k)] = 1;
        const DiagonalMass lumped = DiagonalMass::with_held(lumped_mass(body.elements(), bar_density), Dim, held);
        const CoupledMass consistent(consistent_mass(body.elements(), bar_density), held);
        for (const Mass* mass : {static_cast<const Mass*>(&lumped), static_cast<const Mass*>(&consistent)}) {
            const VecX exact = squared_frequencies(K, mass->matrix() ? *mass->matrix() : diagonal_matrix(lumped), held);
            const VibrationMode mode = fastest_mode(K, *mass);
            CHECK(std::abs(mode.omega / std::sqrt(exact[exact.size() - 1]) - 1) < 1e-9);
            CHECK(std::abs(mass->square(mode.shape) - 1) < 1e-9);
            for (Index d = 0; d < mass->size(); ++d)
                if (mass->fixed(d)) CHECK(mode.shape[d] == 0);
        }
    }
    SparseMatrix nothing = K;
    nothing.coeffs().setZero();
    CHECK(fastest_mode(nothing, DiagonalMass(lumped_mass(body.elements(), bar_density), Dim)).omega == 0);
    CHECK(fastest_mode(K, DiagonalMass::with_held(lumped_mass(body.elements(), bar_density), Dim,
                                                  std::vector<char>(static_cast<std::size_t>(K.rows()), 1)))
              .omega == 0);
}

TEST_CASE("explicit steps stay bounded just below the limit of the fastest mode and not just above it", "[vibration]") {
    const HeldBar<1> bar(6);
    const DiagonalMass lumped = bar.lumped();
    const CoupledMass consistent(bar.consistent(), bar.held);
    std::array<Real, 2> omegas{};
    for (const bool coupled : {false, true}) {
        const Mass& mass = coupled ? static_cast<const Mass&>(consistent) : lumped;
        for (const Real beta : {0.0, 0.002}) {
            ElasticSystem<2> system(bar.body, bar.mesh.points(), mass);
            system.stiffness_damping = beta;
            const VibrationMode mode = fastest_mode(bar.stiffness, mass);
            omegas[coupled] = mode.omega;
            const Real zeta = rayleigh_damping_ratio(mode.omega, 0, beta);
            const Real limit = stability_limit(Scheme::semi_implicit_euler, mode.omega, zeta);
            for (const Real share : {0.99, 1.01}) {
                Points<2> x = bar.mesh.points(), v = Points<2>::Zero(2, x.cols());
                flat(x) += 1e-6 * mode.shape;
                TimeIntegrator integrator(system, mass, Scheme::semi_implicit_euler);
                for (int k = 0; k < 500; ++k) integrator.step(share * limit, flat(x), flat(v));
                const Real grown = (x - bar.mesh.points()).norm() / (1e-6 * mode.shape.norm());
                CHECK((share < 1 ? grown < 20 : grown > 100));
            }
        }
    }
    // The consistent mass is faster, and takes shorter steps.
    CHECK(omegas[1] > 1.3 * omegas[0]);
}

TEST_CASE("a consistent mass moves a body under every scheme: momentum, and the energy of the midpoint rule", "[vibration]") {
    const SimplexMesh<3> mesh = bar_block<3>(2, 2, 1);
    const HyperelasticFem<3> body(mesh, Energy::linear, IsotropicModuli::from_young_poisson(bar_modulus, 0.3).lame());
    const CoupledMass mass(consistent_mass(body.elements(), bar_density));
    for (const SchemeInfo& info : schemes())
        for (const auto solve : {LinearSolve::direct, LinearSolve::conjugate_gradients}) {
            if (!info.implicit && solve == LinearSolve::conjugate_gradients) continue;
            INFO(info.name);
            ElasticSystem<3> system(body, mesh.points(), mass);
            system.mass_damping = info.scheme == Scheme::newmark ? 0.5 : 0;
            Points<3> x = mesh.points(), v = Points<3>::Zero(3, x.cols());
            for (Index n = 0; n < x.cols(); ++n) v.col(n) << 0.1 + 0.05 * std::sin(Real(n)), 0.2, 0.3;
            VecX Mv;
            const auto momentum_x = [&] {
                mass.multiply(flat(v), Mv);
                return Mv(Eigen::seqN(0, x.cols(), 3)).sum();
            };
            const auto energy = [&] { return system.potential(flat(x)) + mass.square(flat(v)) / 2; };
            const Real p = momentum_x(), e = energy();
            TimeIntegrator integrator(system, mass, info.scheme, {.linear_solve = solve, .linear_tolerance = 1e-6});
            for (int k = 0; k < 20; ++k) integrator.step(1e-3, flat(x), flat(v));
            const Real left = info.scheme == Scheme::newmark ? std::exp(-0.5 * 0.02) : 1;
            CHECK(std::abs(momentum_x() / p - left) < 1e-6);
            if (info.scheme == Scheme::implicit_midpoint) CHECK(std::abs(energy() / e - 1) < 1e-9);
            if (!info.implicit) CHECK(std::abs(energy() / e - 1) < 0.02);
        }
    CHECK_THROWS(CoupledMass(consistent_mass(body.elements(), bar_density), std::vector<char>(2)));
    SparseMatrix diagonal(6, 6);
    diagonal.setIdentity();
    CHECK_THROWS(ElasticSystem<3>(body, mesh.points(), CoupledMass(diagonal)));
}
