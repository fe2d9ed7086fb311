// Chains, rods and lattices of springs against closed forms.
#include "spring_body.h"

#include <pliant/mesh/lattice.h>
#include <pliant/solids/springs_matrix.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <Eigen/Eigenvalues>

#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

// `free` masses in a row, joined by springs, with a fixed node before the first and, when both_ends, one after the last.
struct Chain {
    Chain(Index free, bool both_ends, Real stiffness, Real node_mass, Real spacing = 1)
        : lattice({free + (both_ends ? 1 : 0), 0}, {spacing, 1}),
          body(lattice.points(), springs(stiffness), VecX::Constant(lattice.node_count(), node_mass), fixed(both_ends)) {}
    std::vector<Spring> springs(Real stiffness) const {
        std::vector<Spring> list;
        append_springs<2>(lattice.points(), lattice.structural(), stiffness, 0, list);
        return list;
    }
    std::vector<Index> fixed(bool both_ends) const {
        return both_ends ? std::vector<Index>{0, lattice.node_count() - 1} : std::vector<Index>{0};
    }
    NodeLattice<2> lattice;
    SpringBody<2> body;
};

// Squares of the frequencies of small motions about x, rad²/s², ascending: the eigenvalues of M^-1/2 K M^-1/2.
template <int Dim>
VecX squared_frequencies(const Springs& springs, const DiagonalMass& mass, PointsIn<Dim> x) {
    SpringMatrix<Dim> stiffness(springs);
    stiffness.add_stiffness(springs, x, SpringCurvature::exact);
    std::vector<Index> free;
    for (Index d = 0; d < mass.size(); ++d)
        if (!mass.fixed(d)) free.push_back(d);
    const VecX root = mass.inverse()(free).cwiseSqrt();
    const MatX K = MatX(stiffness.matrix())(free, free);
    return Eigen::SelfAdjointEigenSolver<MatX>(root.asDiagonal() * K * root.asDiagonal(), Eigen::EigenvaluesOnly).eigenvalues();
}

// How many motions nothing resists.
Index without_stiffness(const VecX& squared) { return (squared.array().abs() <= 1e-12 * squared.cwiseAbs().maxCoeff()).count(); }

// Frequencies along the chain, rad/s, ascending: its nodes can also move across it, which no spring resists at rest.
VecX frequencies(const Chain& chain, Index free) {
    const VecX squared = squared_frequencies<2>(chain.body.springs, chain.body.inertia, chain.body.x);
    CHECK(without_stiffness(squared) == free);
    return squared.tail(free).cwiseSqrt();
}

}  // namespace

TEST_CASE("frequencies of a chain between two walls", "[springs]") {
    const Index n = 10;
    const Real k = 30, m = 0.2;
    const VecX measured = frequencies(Chain(n, true, k, m), n);
    for (Index j = 1; j <= n; ++j)
        CHECK_THAT(measured[j - 1], WithinRel(2 * std::sqrt(k / m) * std::sin(Real(j) * pi / (2 * (n + 1))), 1e-12));
}

TEST_CASE("frequencies of a chain with a free end", "[springs]") {
    const Index n = 10;
    const VecX measured = frequencies(Chain(n, false, 1, 1), n);
    for (Index j = 1; j <= n; ++j)
        CHECK_THAT(measured[j - 1], WithinRel(2 * std::sin(Real(2 * j - 1) * pi / (2 * (2 * n + 1))), 1e-12));
    CHECK_THAT(measured[0], WithinAbs(0.14946019, 5e-9));
    CHECK_THAT(measured[1], WithinAbs(0.44504187, 5e-9));
    CHECK_THAT(measured[2], WithinAbs(0.73068205, 5e-9));
}

TEST_CASE("a chain released in its first mode swings at that mode's frequency", "[springs]") {
    const Index n = 10;
    Chain chain(n, true, 1, 1);
    SpringBody<2>& body = chain.body;
    const Points<2> rest = body.x;
    for (Index i = 1; i <= n; ++i) body.x(0, i) += 0.01 * std::sin(Real(i) * pi / Real(n + 1));

    // Ten periods, each from one downward passage of the middle through its rest position to the next.
    const Real dt = 0.01, omega = 2 * std::sin(pi / (2 * (n + 1)));
    Real previous = body.x(0, 5) - rest(0, 5), first = 0, last = 0;
    for (int step = 1, passages = 0; passages < 11; ++step) {
        body.step(Scheme::semi_implicit_euler, dt);
        const Real now = body.x(0, 5) - rest(0, 5);
        if (previous > 0 && now <= 0) {
            last = dt * (step - 1 + previous / (previous - now));
            if (passages++ == 0) first = last;
        }
        previous = now;
    }
    CHECK_THAT(10 * 2 * pi / (last - first), WithinRel(omega, 1e-5));
}

TEST_CASE("power iteration comes up to the highest frequency from below", "[springs]") {
    const Index n = 10;
    Chain chain(n, false, 30, 0.2);
    const Real exact = frequencies(chain, n).maxCoeff();
    const Real estimate =
        spring_rate_estimates<2>(chain.body.springs, chain.body.inertia, SpringDamping::none, chain.body.x).omega;
    CHECK(estimate <= exact * (1 + 1e-12));
    CHECK(estimate > 0.99 * exact);

    // One mass on one spring, and a light mass beside a heavy one, whose limit the light one sets.
    SpringOscillator single(10, 0.25);
    single.position() = 1;
    for (const SpringDamping mode : {SpringDamping::naive, SpringDamping::projected}) {
        const SpringRates rates = spring_rate_estimates<2>(single.springs, single.inertia, mode, single.x);
        CHECK_THAT(rates.omega, WithinRel(10, 1e-12));
        CHECK_THAT(rates.damping, WithinRel(5, 1e-12));
        CHECK_THAT(rates.relaxation_time, WithinRel(0.05, 1e-12));
        CHECK_THAT(stability_limit(Scheme::semi_implicit_euler, rates),
                   WithinRel(stability_limit(Scheme::semi_implicit_euler, 10, 0.25), 1e-12));
        CHECK_THAT(stability_limit(Scheme::explicit_euler, rates), WithinRel(0.05, 1e-12));
    }

    SpringBody<2> pair(Points<2>::Identity(2, 2), {{0, 1, 1, 1e3}}, Vec<2>(1, 1e-6));
    const Real light = std::sqrt(1e3 * (1 + 1e6));
    CHECK_THAT(spring_rate_estimates<2>(pair.springs, pair.inertia, SpringDamping::none, pair.x).omega, WithinRel(light, 1e-6));
}

TEST_CASE("a block is stable below its limit, with every damping, and not far above it", "[springs]") {
    const SpringDamping mode = GENERATE(SpringDamping::none, SpringDamping::naive, SpringDamping::projected);
    const Scheme scheme = GENERATE(Scheme::explicit_euler, Scheme::semi_implicit_euler);
    if (mode == SpringDamping::none && scheme == Scheme::explicit_euler) return;
    const NodeLattice<3> lattice({2, 2, 2}, Vec<3>::Constant(0.1));
    std::vector<Spring> list;
    append_springs<3>(lattice.points(), lattice.structural(), 200, 2, list);
    append_springs<3>(lattice.points(), lattice.face_diagonals(), 100, 1, list);
    const auto energy_after = [&](Real factor) {
        SpringBody<3> body(lattice.points(), list, VecX::Constant(lattice.node_count(), 0.01));
        body.system.damping = mode;
        const SpringRates rates = spring_rate_estimates<3>(body.springs, body.inertia, mode, body.x, 2000);
        body.x(0, 0) += 1e-7, body.x(1, 5) -= 2e-7, body.x(2, 17) += 1e-7;
        const Real start = body.energy();
        body.run(scheme, factor * stability_limit(scheme, rates), 2000);
        return body.energy() / start;
    };
    CHECK(energy_after(0.97) < 60);
    CHECK_FALSE(energy_after(2.2) < 1e3);
}

TEST_CASE("a rod whose springs follow from its energy hangs consistently with N", "[springs]") {
    // N masses rho A L/N below as many springs E A N/L: the extension is rho g L^2/(2E) (N + 1)/N.
    const Real length = 2, youngs_area = 5e4, line_density = 3, g = 9.81;
    const Real continuum = line_density * g * length * length / (2 * youngs_area);
    Real previous = 0;
    for (const Index n : {5, 10, 20}) {
        const Real spring = youngs_area * Real(n) / length, mass = line_density * length / Real(n);
        Chain chain(n, false, spring, mass, length / Real(n));
        chain.body.system.load.gravity = {g, 0};
        // One very long implicit step has only the static equilibrium for a solution.
        chain.body.step(Scheme::implicit_euler, 1e6);
        const Real extension = chain.body.x(0, n) - length;
        CHECK_THAT(extension / continuum, WithinRel(Real(n + 1) / Real(n), 1e-6));
        const Real error = extension / continuum - 1;
        if (previous > 0) CHECK_THAT(std::log2(previous / error), WithinAbs(1, 1e-3));
        previous = error;
    }
}

TEST_CASE("a rod of hand-picked springs stretches the more the finer it is cut", "[springs]") {
    const Real total = 6, spring = 1e5, g = 9.81, length = 2;
    for (const Index n : {5, 10, 20, 40}) {
        Chain chain(n, false, spring, total / Real(n), length / Real(n));
        chain.body.system.load.gravity = {g, 0};
        chain.body.step(Scheme::implicit_euler, 1e6);
        CHECK_THAT(chain.body.x(0, n) - length, WithinRel(total * g * Real(n + 1) / (2 * spring), 1e-6));
    }
}

TEST_CASE("a loose block has six rigid motions, a held one none, and a compressed one buckles", "[springs]") {
    const NodeLattice<3> lattice({1, 2, 1}, Vec<3>::Constant(0.2));
    std::vector<Spring> list;
    append_springs<3>(lattice.points(), lattice.structural(), 200, 0, list);
    append_springs<3>(lattice.points(), lattice.face_diagonals(), 100, 0, list);
    const Springs springs(lattice.node_count(), list);
    const VecX mass = VecX::LinSpaced(lattice.node_count(), 0.1, 1);
    CHECK(without_stiffness(squared_frequencies<3>(springs, DiagonalMass(mass, 3), lattice.points())) == 6);
    const DiagonalMass held(mass, 3, {0, 1, 2});
    const VecX squared = squared_frequencies<3>(springs, held, lattice.points());
    CHECK(without_stiffness(squared) == 0);
    CHECK_THAT(spring_rate_estimates<3>(springs, held, SpringDamping::none, lattice.points(), 2000).omega,
               WithinRel(std::sqrt(squared.maxCoeff()), 1e-6));
    // A compressed spring pushes its nodes sideways.
    CHECK(squared_frequencies<3>(springs, held, 0.9 * lattice.points())[0] < 0);
}
