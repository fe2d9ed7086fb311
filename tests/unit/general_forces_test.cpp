// Time integrators on forces without a potential: across the velocity, and of a damper that drives the motion.
#include <pliant/math/error.h>
#include <pliant/time/time_integrator.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

class ForcesAlone : public SecondOrderSystem {
public:
    void begin_step(ConstDofs) override {}
    bool has_potential() const override { return false; }
    Real potential(ConstDofs) const override { throw std::logic_error("not asked for"); }
    Real dissipation(ConstDofs) const override { throw std::logic_error("not asked for"); }
    Real length_scale(ConstDofs) const override { return 1; }

protected:
    // Every entry, zeros too.
    const SparseMatrix& filled(const MatX& values) {
        matrix_.resize(values.rows(), values.cols());
        for (Index column = 0; column < values.cols(); ++column)
            for (Index row = 0; row < values.rows(); ++row) matrix_.insert(row, column) = values(row, column);
        return matrix_;
    }

private:
    SparseMatrix matrix_;
};

// A charge in a magnetic field: m a = q v x B, a circle at the angular frequency q B/m.
class Charge final : public ForcesAlone {
public:
    explicit Charge(Real field) : field_(field) {}
    void force(ConstDofs, ConstDofs v, Dofs f) const override { f << field_ * v[1], -field_ * v[0]; }
    const SparseMatrix& stiffness(ConstDofs, Real velocity_rate, Curvature) override {
        return filled(Mat<2>{{0, -velocity_rate * field_}, {velocity_rate * field_, 0}});
    }

private:
    Real field_;
};

// x'' = strength (1 - x^2) x' - x: its damper drives small motions and brakes large ones.
class VanDerPol final : public ForcesAlone {
public:
    explicit VanDerPol(Real strength) : strength_(strength) {}
    void force(ConstDofs x, ConstDofs v, Dofs f) const override { f[0] = strength_ * (1 - x[0] * x[0]) * v[0] - x[0]; }
    const SparseMatrix& stiffness(ConstDofs x, Real velocity_rate, Curvature) override {
        // The velocity of an iterate moves with its position.
        const Real v = velocity_rate * (x[0] - origin);
        return filled(Mat<1>{{1 + 2 * strength_ * x[0] * v - velocity_rate * strength_ * (1 - x[0] * x[0])}});
    }
    Real origin = 0;

private:
    Real strength_;
};

}  // namespace

TEST_CASE("a charge turns in a field at the order of each scheme", "[integrators]") {
    const SchemeInfo& info = GENERATE(from_range(schemes()));
    Charge charge(2);
    const DiagonalMass mass(VecX::Constant(1, 1), 2);
    const auto error = [&](int steps) {
        TimeIntegrator integrator(charge, mass, info.scheme);
        VecX x = Vec<2>(0, 0), v = Vec<2>(1, 0);
        for (int n = 0; n < steps; ++n) integrator.step(1.0 / steps, x, v);
        const Vec<2> exact_x(std::sin(2) / 2, (std::cos(2) - 1) / 2), exact_v(std::cos(2), -std::sin(2));
        return std::hypot((x - exact_x).norm(), (v - exact_v).norm());
    };
    const int steps = info.order == 4 ? 20 : 400;
    CHECK_THAT(std::log2(error(steps) / error(2 * steps)), WithinAbs(info.order, 0.1));
}

TEST_CASE("the midpoint rule keeps the speed of a charge, whatever the step", "[integrators]") {
    Charge charge(2);
    const DiagonalMass mass(VecX::Constant(1, 1), 2);
    for (const Real dt : {0.01, 1.0, 100.0}) {
        TimeIntegrator integrator(charge, mass, Scheme::implicit_midpoint);
        VecX x = Vec<2>(0, 0), v = Vec<2>(1, 0);
        for (int n = 0; n < 50; ++n) integrator.step(dt, x, v);
        CHECK_THAT(v.norm(), WithinRel(1.0, 1e-12));
        CHECK(integrator.solver().iterations() <= 2);
    }
}

TEST_CASE("an oscillator that drives itself reaches the limit cycle of amplitude 2", "[integrators]") {
    VanDerPol system(0.05);
    const DiagonalMass mass(VecX::Constant(1, 1), 1);
    TimeIntegrator integrator(system, mass, Scheme::implicit_midpoint);
    VecX x = VecX::Constant(1, 0.1), v = VecX::Zero(1);
    Real amplitude = 0;
    for (int n = 0; n < 6000; ++n) {
        system.origin = x[0];
        integrator.step(0.04, x, v);
        if (n > 5500) amplitude = std::max(amplitude, std::abs(x[0]));
    }
    CHECK_THAT(amplitude, WithinAbs(2, 0.005));
}

TEST_CASE("a bound on the positions is refused where there is no potential", "[integrators]") {
    Charge charge(2);
    const DiagonalMass mass(VecX::Constant(1, 1), 2);
    TimeIntegrator integrator(charge, mass, Scheme::implicit_euler);
    integrator.lower_bound() = VecX::Constant(2, -1);
    VecX x = Vec<2>(0, 0), v = Vec<2>(1, 0);
    CHECK_THROWS_AS(integrator.step(0.1, x, v), Refused);
}
