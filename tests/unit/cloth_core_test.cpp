// Sheets of springs: implicit steps by conjugate gradients, the sphere, the air, the limit on strain.
#include <pliant/math/error.h>
#include <pliant/mesh/lattice.h>
#include <pliant/solids/point_masses.h>
#include <pliant/solids/sheet_wind.h>
#include <pliant/solids/sphere_contact.h>
#include <pliant/solids/springs_system.h>
#include <pliant/solids/strain_limiter.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <random>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// A level square sheet of n x n nodes, 1 m and 0.2 kg.
struct Sheet {
    explicit Sheet(Index n, std::vector<Index> fixed, Real stiffness = 500) : side(n) {
        const NodeLattice<3> lattice({n - 1, n - 1, 0}, Vec<3>::Constant(1 / Real(n - 1)));
        x = lattice.points();
        x.row(2).swap(x.row(1));
        std::vector<Spring> list;
        append_springs<3>(x, lattice.structural(), stiffness, 0.01, list);
        structural = static_cast<Index>(list.size());
        append_springs<3>(x, lattice.face_diagonals(), 0.2 * stiffness, 0.01, list);
        append_springs<3>(x, lattice.bending(), 1, 0.01, list);
        springs = Springs(lattice.node_count(), list);
        v = Points<3>::Zero(3, x.cols());
        mass = VecX::Constant(x.cols(), 0.2 / Real(x.cols()));
        inertia = DiagonalMass(mass, 3, fixed);
        system = std::make_unique<SpringSystem<3>>(springs, mass);
        system->load.gravity = {0, -9.81, 0};
        system->damping = SpringDamping::projected;
    }
    void shake(Real by) {
        std::mt19937 draw(7);
        for (Index n = 0; n < x.cols(); ++n)
            for (int c = 0; c < 3; ++c)
                x(c, n) += by * (static_cast<Real>(draw()) / static_cast<Real>(std::mt19937::max()) - 0.5);
    }
    void step(ImplicitSolver& solver, Real dt = 1.0 / 60) {
        implicit_euler(dt, flat(x), flat(v), solver.form());
        solver.begin(flat(x));
        while (solver.again()) solver.iterate();
        solver.finish(flat(x), flat(v));
    }
    Index side, structural;
    Points<3> x, v;
    Springs springs;
    VecX mass;
    DiagonalMass inertia;
    std::unique_ptr<SpringSystem<3>> system;
};

NewtonOptions by_gradients(Real tolerance, int newton_cap = 50) {
    return {.max_iterations = newton_cap, .linear_solve = LinearSolve::conjugate_gradients, .linear_tolerance = tolerance};
}

NewtonOptions one_iteration(int linear) {
    NewtonOptions options = by_gradients(1e-6, 1);
    options.at_cap = AtCap::accept;
    options.linear_iterations = linear;
    return options;
}

VecX random_vector(Index size) {
    std::mt19937 draw(3);
    VecX v(size);
    for (Real& a : v) a = static_cast<Real>(draw()) / static_cast<Real>(std::mt19937::max()) - 0.5;
    return v;
}

}  // namespace

TEST_CASE("cloth: the operator of a sheet is the assembled matrix, and its rows can be read") {
    Sheet sheet(6, {});
    sheet.shake(0.05);
    sheet.system->terms.drag.assign(36, Mat<3>::Identity() * 0.3);
    sheet.system->terms.planes.push_back({4, Vec<3>(0.6, 0.8, 0), 0.1, 900});
    sheet.system->load.pull = {7, Vec<3>::Zero(), 40};
    sheet.system->begin_step(flat(sheet.x));
    const VecX added = 3600 * sheet.inertia.mass(), d = random_vector(sheet.x.size());
    const LinearisedSystem* h = sheet.system->linearise(flat(sheet.x), 60, 3600, sheet.inertia);
    SparseMatrix whole = sheet.system->stiffness(flat(sheet.x), 60, SecondOrderSystem::Curvature::positive);
    for (Index k = 0; k < whole.cols(); ++k) whole.coeffRef(k, k) += added[k];
    VecX product(d.size());
    h->multiply(d, product);
    CHECK((product - whole * d).norm() < 1e-12 * product.norm());
    Real of_row = h->diagonal(13) * d[13];
    for (const auto& [column, value] : sheet.system->tangent().row(13)) of_row += value * d[column];
    CHECK_THAT(of_row, WithinAbs(product[13], 1e-11));
}

TEST_CASE("cloth: the preconditioner is symmetric and positive, and coarser sheets save most iterations") {
    const auto iterations = [](bool levels) {
        Sheet sheet(33, {0, 32});
        sheet.shake(0.002);
        if (levels) sheet.system->set_sheet(33, 33);
        ImplicitSolver solver(*sheet.system, sheet.inertia, one_iteration(5000));
        sheet.step(solver);
        const VecX a = random_vector(sheet.x.size()), b = a.reverse();
        VecX pa(a.size()), pb(a.size());
        solver.linearised()->precondition(a, pa);
        solver.linearised()->precondition(b, pb);
        CHECK_THAT(b.dot(pa), WithinAbs(a.dot(pb), 1e-11 * a.norm() * pb.norm()));
        CHECK(a.dot(pa) > 0);
        return solver.linear_iterations();
    };
    const int alone = iterations(false), helped = iterations(true);
    INFO(alone << " and " << helped);
    CHECK(3 * helped < alone);
}

TEST_CASE("cloth: conjugate gradients and sparse factors make the same implicit steps") {
    Sheet direct(9, {0, 8}), iterated(9, {0, 8});
    iterated.system->set_sheet(9, 9);
    ImplicitSolver by_factors(*direct.system, direct.inertia),
        by_products(*iterated.system, iterated.inertia, by_gradients(1e-8));
    for (int k = 0; k < 12; ++k) direct.step(by_factors), iterated.step(by_products);
    CHECK(by_products.converged());
    CHECK((direct.x - iterated.x).cwiseAbs().maxCoeff() < 1e-7);
    VecX left;
    by_products.imbalance(left);
    CHECK(left.cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("cloth: at the cap a step fails or is taken, as asked, and never ends with a higher potential") {
    Sheet sheet(9, {0, 8});
    NewtonOptions options = by_gradients(1e-6, 1);
    ImplicitSolver strict(*sheet.system, sheet.inertia, options);
    sheet.shake(0.05);
    Points<3> before = sheet.x;
    CHECK_THROWS_AS(sheet.step(strict), Diverged);
    CHECK(sheet.x == before);
    ImplicitSolver lenient(*sheet.system, sheet.inertia, one_iteration(20));
    for (int k = 0; k < 20; ++k) {
        implicit_euler(1.0 / 60, flat(sheet.x), flat(sheet.v), lenient.form());
        const auto phi = [&](const Points<3>& x) {
            const VecX moved = flat(x) - lenient.form().acceleration_origin, speed = 60 * (flat(x) - flat(sheet.x));
            return 1800 * moved.cwiseAbs2().dot(sheet.inertia.mass()) + sheet.system->potential(flat(x)) +
                   sheet.system->dissipation(speed) / 60;
        };
        lenient.begin(flat(sheet.x));
        const Real start = phi(sheet.x);
        while (lenient.again()) lenient.iterate();
        Points<3> reached = sheet.x;
        flat(reached) = lenient.position();
        CHECK(phi(reached) <= start + 1e-12);
        lenient.finish(flat(sheet.x), flat(sheet.v));
    }
    options.linear_solve = LinearSolve::conjugate_gradients;
    strict.form().lower_bound = VecX::Zero(sheet.x.size());
    CHECK_THROWS_AS(strict.begin(flat(sheet.x)), Refused);
}

TEST_CASE("cloth: a chain that hangs still bears at each spring what hangs below it") {
    constexpr Index n = 20;
    Points<3> x = Points<3>::Zero(3, n), v = x;
    for (Index k = 0; k < n; ++k) x(1, k) = -0.05 * Real(k);
    std::vector<std::array<Index, 2>> pairs;
    for (Index k = 0; k + 1 < n; ++k) pairs.push_back({k, k + 1});
    std::vector<Spring> list;
    append_springs<3>(x, pairs, 200, 0, list);
    const Springs springs(n, list);
    const VecX mass = VecX::Constant(n, 0.01);
    const DiagonalMass inertia(mass, 3, {0});
    SpringSystem<3> system(springs, mass);
    system.load.gravity = {0, -9.81, 0};
    ImplicitSolver solver(system, inertia, by_gradients(1e-10, 100));
    for (int k = 0; k < 60; ++k) {
        implicit_euler(1, flat(x), flat(v), solver.form());
        solver.begin(flat(x));
        while (solver.again()) solver.iterate();
        solver.finish(flat(x), flat(v));
    }
    VecX tension(springs.size());
    spring_tension<3>(springs, x, tension);
    for (Index s = 0; s < springs.size(); ++s) CHECK_THAT(tension[s], WithinRel(0.01 * 9.81 * Real(n - 1 - s), 1e-6));
}

TEST_CASE("cloth: strain limiting keeps the limit, the momentum and what is fixed") {
    Sheet sheet(9, {0, 8});
    StrainLimiter limiter(sheet.springs, sheet.structural);
    sheet.x *= 1.2;
    const Vec<3> held = sheet.x.col(0);
    sheet.x.col(8) = held + Vec<3>(1.02, 0, 0);
    for (int k = 0; k < 500; ++k) limiter.pass(sheet.inertia, 0.05, 0.01, sheet.x, sheet.v);
    CHECK(largest_stretch(sheet.springs, sheet.structural, sheet.x) < 0.053);
    CHECK(sheet.x.col(0) == held);
    CHECK(sheet.v.col(0).isZero(0));

    Sheet loose(9, {});
    loose.shake(0.1);
    const Vec<3> centre = centre_of_mass<3>(loose.mass, loose.x);
    const Real before = largest_stretch(loose.springs, loose.structural, loose.x);
    StrainLimiter free_limiter(loose.springs, loose.structural);
    for (int k = 0; k < 10; ++k) free_limiter.pass(loose.inertia, 0.02, 0.01, loose.x, loose.v);
    CHECK(largest_stretch(loose.springs, loose.structural, loose.x) < 0.3 * before);
    CHECK(momentum<3>(loose.mass, loose.v).norm() < 1e-14);
    CHECK((centre_of_mass<3>(loose.mass, loose.x) - centre).norm() < 1e-15);
    CHECK_THROWS_AS(StrainLimiter(loose.springs, loose.springs.size() + 1), Refused);
}

TEST_CASE("cloth: the wind pushes a plate by ½ρcAu², and slides along it") {
    Points<3> x(3, 4), v = Points<3>::Zero(3, 4);
    x << 0, 2, 0, 2, 0, 0, 3, 3, 0, 0, 0, 0;
    const std::vector<NodeTriple> triangles{{0, 1, 2}, {1, 3, 2}};
    std::vector<Mat<3>> drag;
    const auto force = [&](const Air& air) {
        wind_drag(triangles, air, x, v, drag);
        Vec<3> sum = Vec<3>::Zero();
        for (Index n = 0; n < 4; ++n) sum += drag[static_cast<std::size_t>(n)] * (air.velocity - v.col(n));
        return sum;
    };
    const Air air{.velocity = {0, 0, -5}, .density = 1.2, .drag = 1.5};
    CHECK((force(air) - Vec<3>(0, 0, -0.5 * 1.2 * 1.5 * 6 * 25)).norm() < 1e-12);
    CHECK(force({.velocity = {4, 3, 0}}).norm() == 0);
    v.row(2).setConstant(-5);
    CHECK(force(air).norm() == 0);
}

TEST_CASE("cloth: nodes rest on the sphere, stick or slide by Coulomb's law, and are let go") {
    const Sphere ball{.centre = {0, 0, 0}, .radius = 1, .friction = 0.5};
    const VecX mass = VecX::Constant(3, 2);
    const DiagonalMass inertia(mass, 3, {2});
    Points<3> x(3, 3), v(3, 3);
    x << 0, 0, 0, 0.9, 1.2, 0.5, 0, 0, 0;
    v << 3, 0, 0, -2, 1, 0, 0, 0, 0;
    VecX held = VecX::Zero(3), pressed = VecX::Zero(3);
    std::vector<SphereTouch> touches;
    CHECK(resolve_sphere_contact(ball, inertia, 0.1, held, x, v, pressed, touches) == 1);
    CHECK(x.col(0) == Vec<3>(0, 1, 0));
    CHECK_THAT(v(0, 0), WithinAbs(3 - 0.5 * 2, 1e-12));  // friction takes half of the normal change
    CHECK(v(1, 0) == 0);
    CHECK_THAT(pressed[0], WithinRel(2 * 2 / 0.1, 1e-12));
    CHECK(x(1, 1) == 1.2);  // outside
    CHECK(x(1, 2) == 0.5);  // fixed nodes touch nothing
    CHECK((touches[0].rubbed && !touches[0].centred));

    // A node in the very centre leaves it upwards; one that only rests there rubs against nothing.
    Points<3> middle = Points<3>::Zero(3, 3), still = Points<3>::Zero(3, 3);
    VecX pressed_there = VecX::Zero(3);
    std::vector<SphereTouch> there;
    CHECK(resolve_sphere_contact(ball, inertia, 0.1, held, middle, still, pressed_there, there) == 2);
    CHECK(middle.col(0) == Vec<3>(0, 1, 0));
    CHECK((there[0].centred && !there[0].rubbed));

    NodalTerms<3> terms;
    rest_on_sphere(ball, inertia, 0.1, x, v, pressed, 1e4, terms);
    REQUIRE(terms.planes.size() == 1);
    CHECK(terms.planes[0].node == 0);
    CHECK_THAT(terms.drag[0](0, 0), WithinRel(0.5 * pressed[0] / v(0, 0), 1e-12));
    CHECK(terms.drag[0](1, 1) == 0);
    x(1, 0) = 1.01;
    plane_forces(terms.planes, x, held);
    CHECK(held[0] == 0);  // it would have to pull
    CHECK_THROWS_AS(require_valid(Sphere{.centre = {}, .radius = -1}), Refused);
}
