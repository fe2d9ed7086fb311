// The rod discretised from its energy, and its closed forms.
#include <pliant/math/error.h>
#include <pliant/math/line_fit.h>
#include <pliant/solids/rod.h>
#include <pliant/solids/rod_theory.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <vector>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const UniformRod steel{2, 30, 0.7};
constexpr Real g = 9.81;

// Displacement of the tip of a chain that hangs by its own weight.
Real hanging_tip(Index n, Real stiffness) {
    const Real m = steel.mass / static_cast<Real>(n);
    VecX tension, move;
    balance_chain(VecX::Constant(n, stiffness), VecX::Constant(n + 1, m * g), tension, move);
    return move[n];
}

// A bent rod of four segments, none at rest.
Points<2> bent() {
    Points<2> x(2, 5);
    x << 0, 0.4, 1.1, 1.3, 1.2,  //
        0, 0.1, -0.2, 0.4, 0.9;
    return x;
}

Real energy_of(const Points<2>& x) {
    Points<2> slope(2, 4);
    VecX strain(4);
    rod_slopes(0.5, x, slope);
    rod_strains(slope, strain);
    return rod_energy(30, 0.5, strain);
}

Points<2> forces_of(const Points<2>& x) {
    Points<2> slope(2, 4), force = Points<2>::Zero(2, 5);
    VecX strain(4);
    rod_slopes(0.5, x, slope);
    rod_strains(slope, strain);
    add_rod_forces(30, slope, strain, force);
    return force;
}

}  // namespace

TEST_CASE("rod: its forces are the negative gradient of its energy, and those of springs EA/Δs", "[rod]") {
    const Points<2> x = bent(), force = forces_of(x);
    constexpr Real h = 1e-6;
    for (Index n = 0; n < 5; ++n)
        for (int c = 0; c < 2; ++c) {
            Points<2> more = x, less = x;
            more(c, n) += h, less(c, n) -= h;
            CHECK_THAT(force(c, n), WithinAbs(-(energy_of(more) - energy_of(less)) / (2 * h), 1e-7));
        }
    const Springs springs = rod_springs(4, 0.5, 30 / 0.5);
    Points<2> of_springs = Points<2>::Zero(2, 5);
    add_spring_forces<2>(springs, x, of_springs);
    CHECK((force - of_springs).cwiseAbs().maxCoeff() < 1e-13);
    CHECK_THAT(energy_of(x), WithinRel(spring_energy<2>(springs, x), 1e-14));
    // A segment of no length has no direction.
    Points<2> folded = x;
    folded.col(2) = folded.col(1);
    CHECK(forces_of(folded).allFinite());
    CHECK_THROWS_AS(rod_springs(0, 1, 1), Refused);
}

TEST_CASE("rod: derived springs hang (N + 1)/N times as far as the continuum, picked ones ever further", "[rod]") {
    const Real continuum = steel.hanging_tip(g);
    CHECK_THAT(continuum, WithinRel(0.7 * g * 2 / (2 * 30), 1e-14));
    CHECK_THAT(hanging_tip(10, 30 * 10 / 2.0), WithinRel(1.1 * continuum, 1e-12));
    std::vector<Real> size, error;
    for (const Index n : {5, 10, 20, 40, 80, 160}) {
        const auto N = static_cast<Real>(n);
        size.push_back(std::log(1 / N));
        error.push_back(std::log(hanging_tip(n, 30 * N / 2) - continuum));
        CHECK_THAT(hanging_tip(n, 75), WithinRel(steel.mass * g * (N + 1) / (2 * 75), 1e-12));
        CHECK_THAT((MassChain{n, 75, steel.mass / N}.hanging_tip(g)), WithinRel(hanging_tip(n, 75), 1e-12));
    }
    CHECK_THAT(fit_line(size, error)->slope, WithinAbs(1, 1e-9));
}

TEST_CASE("rod: the frequencies of chains are those of the catalogue", "[rod]") {
    const VecX ones = VecX::Ones(11);
    const VecX free = chain_frequencies(ones.head(10), ones, false), fixed = chain_frequencies(ones.head(10), ones, true);
    CHECK_THAT(free[0], WithinAbs(0.14946019, 5e-9));
    CHECK_THAT(free[1], WithinAbs(0.44504187, 5e-9));
    CHECK_THAT(free[2], WithinAbs(0.73068205, 5e-9));
    REQUIRE(free.size() == 10);
    REQUIRE(fixed.size() == 9);
    const MassChain chain{10, 1, 1};
    for (Index j = 1; j <= 10; ++j) CHECK_THAT(free[j - 1], WithinRel(chain.frequency(j, RodEnd::free), 1e-12));
    for (Index j = 1; j <= 9; ++j) CHECK_THAT(fixed[j - 1], WithinRel(chain.frequency(j, RodEnd::fixed), 1e-12));
    CHECK(chain_frequencies(VecX::Ones(1), VecX::Ones(2), true).size() == 0);
    // Its long waves are those of the rod.
    const UniformRod rod{10, 10, 10};
    CHECK_THAT((MassChain{1000, 1000, 0.01}.frequency(2, RodEnd::free)), WithinRel(rod.frequency(2, RodEnd::free), 1e-3));
    CHECK_THAT((MassChain{1000, 1000, 0.01}.frequency(2, RodEnd::fixed)), WithinRel(rod.frequency(2, RodEnd::fixed), 1e-5));
}

TEST_CASE("rod: closed forms of motion fulfil the wave equation and their ends", "[rod]") {
    const Real c = steel.wave_speed(), h = 1e-4;
    CHECK_THAT(c, WithinRel(std::sqrt(30 * 2 / 0.7), 1e-14));
    const auto check_wave = [&](auto u, Real s, Real t, Real source) {
        const Real in_time = (u(s, t + h) - 2 * u(s, t) + u(s, t - h)) / (h * h);
        const Real in_space = (u(s + h, t) - 2 * u(s, t) + u(s - h, t)) / (h * h);
        CHECK_THAT(in_time, WithinAbs(c * c * in_space + source, 1e-4 * (1 + std::abs(in_time))));
    };
    const auto released = [&](Real s, Real t) { return steel.released_displacement(s, t, g); };
    for (const Real t : {0.05, 0.3, 0.55, 1.1}) {
        check_wave(released, 0.7, t, g);
        CHECK_THAT(released(0, t), WithinAbs(0, 1e-12));
        CHECK_THAT(released(2, t + 4 * 2 / c), WithinAbs(released(2, t), 1e-12));
    }
    // The tip falls freely until it learns of the support, and comes down to twice its rest.
    CHECK_THAT(released(2, 0.1), WithinRel(0.5 * g * 0.01, 1e-12));
    CHECK_THAT(released(2, 2 * 2 / c), WithinRel(2 * steel.hanging_tip(g), 1e-12));

    const RodEnd end = GENERATE(RodEnd::free, RodEnd::fixed);
    const RunningPulse pulse{0.1, 0.2, 0.7, 2, c, end};
    const auto u = [&](Real s, Real t) { return pulse.displacement(s, t); };
    for (const Real t : {0.02, 0.14, 0.2, 0.5}) {
        check_wave(u, 1.3, t, 0);
        CHECK_THAT(u(0, t), WithinAbs(0, 1e-12));
        CHECK_THAT(pulse.velocity(1.3, t), WithinAbs((u(1.3, t + h) - u(1.3, t - h)) / (2 * h), 1e-4));
        CHECK_THAT(pulse.strain(1.3, t), WithinAbs((u(1.3 + h, t) - u(1.3 - h, t)) / (2 * h), 1e-4));
        CHECK_THAT(end == RodEnd::free ? pulse.strain(2, t) : u(2, t), WithinAbs(0, 1e-12));
    }
    // Back where it was after the reflection, with its sign or the other; at the end itself twice as tall or nothing.
    const Real back = 2 * (2 - 0.7) / c, sign = end == RodEnd::free ? 1 : -1;
    CHECK_THAT(u(0.7, back), WithinRel(sign * 0.1, 1e-6));
    CHECK_THAT(u(2, (2 - 0.7) / c), WithinAbs(end == RodEnd::free ? 0.2 : 0, 1e-9));
}

TEST_CASE("rod: a pulse as wide as the rod keeps to both ends", "[rod]") {
    const RodEnd end = GENERATE(RodEnd::free, RodEnd::fixed);
    for (const Real width : {0.5, 1., 2., 4.}) {
        const RunningPulse pulse{.amplitude = 0.1, .width = width, .start = 0.7, .length = 2, .speed = 3, .end = end};
        for (const Real t : {0., 0.3, 2.9, 40.}) {
            INFO("width " << width << ", t " << t);
            CHECK_THAT(pulse.displacement(0, t), WithinAbs(0, 1e-15));
            CHECK_THAT(end == RodEnd::free ? pulse.strain(2, t) : pulse.displacement(2, t), WithinAbs(0, 1e-15));
        }
    }
}
