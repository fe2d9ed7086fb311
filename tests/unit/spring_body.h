// A body of point masses and springs with everything that a time step needs, for tests.
#pragma once
#include <pliant/solids/point_masses.h>
#include <pliant/solids/springs_frequency.h>
#include <pliant/solids/springs_system.h>
#include <pliant/time/time_integrator.h>

#include <array>
#include <complex>
#include <utility>

namespace pliant::test {

template <int Dim>
class SpringBody {
public:
    SpringBody(Points<Dim> points, const std::vector<Spring>& list, VecX masses, const std::vector<Index>& fixed = {})
        : x(std::move(points)),
          v(Points<Dim>::Zero(Dim, x.cols())),
          f(v),
          springs(x.cols(), list),
          mass(std::move(masses)),
          inertia(mass, Dim, fixed),
          system(springs, mass),
          integrator(system, inertia) {}
    SpringBody(const SpringBody&) = delete;
    SpringBody& operator=(const SpringBody&) = delete;

    void step(Scheme scheme, Real dt) {
        integrator.set_scheme(scheme);
        integrator.step(dt, flat(x), flat(v));
    }
    void run(Scheme scheme, Real dt, int steps) {
        for (int n = 0; n < steps; ++n) step(scheme, dt);
    }

    // Of the system, for contact.
    auto force() {
        return [this](ConstDofs at, ConstDofs with, Dofs sum) {
            system.begin_step(at);
            system.force(at, with, sum);
        };
    }

    Real energy() const {
        return kinetic_energy<Dim>(mass, v) + spring_energy<Dim>(springs, x) + external_energy<Dim>(system.load, mass, x);
    }

    // That of implicit Euler.
    ImplicitSolver& solver() {
        integrator.set_scheme(Scheme::implicit_euler);
        return integrator.solver();
    }

    Points<Dim> x, v, f;
    Springs springs;
    VecX mass;
    DiagonalMass inertia;
    SpringSystem<Dim> system;
    TimeIntegrator integrator;
};

// One mass on a spring of rest length 0 to a fixed node at the origin: x'' = -omega^2 x - 2 zeta omega x', exactly linear.
class SpringOscillator : public SpringBody<2> {
public:
    SpringOscillator(Real omega, Real zeta, Real node_mass = 1)
        : SpringBody<2>(Points<2>::Zero(2, 2), {{0, 1, 0, node_mass * omega * omega, 2 * zeta * omega * node_mass}},
                        VecX::Constant(2, node_mass), {0}) {
        system.damping = zeta > 0 ? SpringDamping::naive : SpringDamping::none;
    }
    Real& position() { return x(0, 1); }
    Real& velocity() { return v(0, 1); }

    // The matrix that one step multiplies (position, velocity) with, column by column.
    Mat<2> step_matrix(Scheme scheme, Real dt) {
        Mat<2> matrix;
        for (int column = 0; column < 2; ++column) {
            x.setZero(), v.setZero();
            integrator.forget();
            position() = column == 0, velocity() = column == 1;
            step(scheme, dt);
            matrix.col(column) << position(), velocity();
        }
        return matrix;
    }

    // What one step multiplies its two eigenvectors with, the larger one first: the roots of λ² − tr λ + det.
    std::array<std::complex<Real>, 2> step_factors(Scheme scheme, Real dt) {
        const Mat<2> A = step_matrix(scheme, dt);
        const Real middle = 0.5 * (A(0, 0) + A(1, 1)), half = 0.5 * (A(0, 0) - A(1, 1));
        const std::complex<Real> root = std::sqrt(std::complex<Real>(half * half + A(0, 1) * A(1, 0)));
        const std::complex<Real> larger = middle < 0 ? middle - root : middle + root;
        return {larger, middle < 0 ? middle + root : middle - root};
    }
    Real spectral_radius(Scheme scheme, Real dt) { return std::abs(step_factors(scheme, dt)[0]); }
};

}  // namespace pliant::test
