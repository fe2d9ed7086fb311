// The Navier-Stokes lesson: its scenes against what is known of them, and its behaviour at the ends of its ranges.
#include "readings.h"

#include <pliant/run/runner.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner start_navier_stokes(const Runner::Assignments& parameters) {
    return Runner(find_lesson("fluids/navier_stokes"), parameters);
}

Real largest(std::span<const Real> numbers) {
    Real m = 0;
    for (const Real x : numbers) m = std::max(m, std::abs(x));
    return m;
}

}  // namespace

TEST_CASE("navier_stokes: the stages run in the lecture's order, and only those that the scene needs") {
    using Names = std::vector<std::string>;
    CHECK(stage_names(start_navier_stokes({})) == Names{"external_forces", "advection", "viscosity", "projection"});
    CHECK(stage_names(start_navier_stokes({{"viscosity", "0"}})) == Names{"external_forces", "advection", "projection"});
    CHECK(stage_names(start_navier_stokes({{"stirring", "0"}})) == Names{"advection", "viscosity", "projection"});
    CHECK(stage_names(start_navier_stokes({{"scene", "cavity"}})) == Names{"advection", "viscosity", "projection"});
    CHECK(stage_names(start_navier_stokes({{"scene", "cavity"}, {"lid_speed", "0"}})) == Names{"advection", "projection"});
    CHECK(stage_names(start_navier_stokes({{"scene", "taylor_green"}, {"viscosity", "0"}})) == Names{"advection", "projection"});
}

TEST_CASE("navier_stokes: a hand in the fluid is a force, until it lets go") {
    Runner runner = start_navier_stokes({{"stirring", "0"}, {"resolution", "32"}});
    runner.pull(Pull{-1, {0.25, 0.5, 0}, {0.5, 0.5, 0}});
    runner.step();
    CHECK(stage_names(runner).front() == "external_forces");
    const auto velocity = field(runner, "velocity");
    CHECK(velocity[2 * (8 + 32 * 16)] > 0.05);  // to the right, where the hand is
    runner.pull(std::nullopt);
    const Real energy = value(runner, "kinetic_energy");
    for (int k = 0; k < 20; ++k) runner.step();
    CHECK(stage_names(runner).front() == "advection");
    CHECK(value(runner, "kinetic_energy") < energy);
    check_laws(runner);
}

TEST_CASE("navier_stokes: each stage does what it says to the fields") {
    Runner runner = start_navier_stokes({{"resolution", "32"}});
    // The force acts near the stirrer alone; its divergence is what the projection gets.
    runner.run_to_stage("external_forces");
    const auto speed = [&](Index i, Index j) { return field(runner, "speed")[static_cast<std::size_t>(i + 32 * j)]; };
    CHECK(speed(16, 16) > 0.05);
    CHECK(speed(2, 2) == 0);
    runner.run_to_stage("viscosity");
    CHECK(speed(2, 2) < 1e-12);
    // Passes of the solver can be stopped after: what is left shrinks, and the velocity waits for the end.
    const Real before = value(runner, "kinetic_energy");
    runner.step_pass();
    const Real first = largest(field(runner, "divergence_after"));
    CHECK(value(runner, "kinetic_energy") == before);
    runner.step_pass();
    CHECK(largest(field(runner, "divergence_after")) < 0.5 * first);
    while (runner.inside_step()) runner.step_pass();
    CHECK(value(runner, "kinetic_energy") < before);
    CHECK(speed(2, 2) > 0);  // the pressure reaches every corner in one step
    CHECK(value(runner, "max_divergence") <= 1e-4 * value(runner, "max_divergence_before") * (1 + 1e-6));
    // Kinematic pressure of mean 0.
    const auto p = field(runner, "pressure");
    Real sum = 0;
    for (const Real x : p) sum += x;
    CHECK(std::abs(sum) < 1e-10 * largest(p) * static_cast<Real>(p.size()));
}

TEST_CASE("navier_stokes: divergence stays at the solver's tolerance and energy does not grow where nothing feeds it") {
    for (const char* scene : {"box", "cavity", "taylor_green"}) {
        INFO(scene);
        Runner runner = start_navier_stokes(
            {{"scene", scene}, {"resolution", "40"}, {"viscosity", "1e-3"}, {"time_step", "0.03"}, {"tolerance", "1e-6"}});
        for (int k = 0; k < 60; ++k) {
            runner.step();
            check_laws(runner);
        }
        // The stirrer stops: from then on the law for the energy holds in the box too.
        runner.assign("stirring", 0);
        for (int k = 0; k < 40; ++k) runner.step();
        check_laws(runner);
    }
}

TEST_CASE("navier_stokes: Taylor-Green vortices decay a little faster than exact, by the interpolation") {
    const auto excess = [](const char* resolution, const char* time_step) {
        Runner runner = start_navier_stokes(
            {{"scene", "taylor_green"}, {"viscosity", "0.01"}, {"resolution", resolution}, {"time_step", time_step}});
        while (runner.time() < 0.5 - 1e-9) runner.step();
        const Probe& energy = runner.lesson().probe("kinetic_energy");
        CHECK_THAT(runner.exact(energy).value(),
                   WithinRel(0.25 * std::exp(-16 * std::numbers::pi * std::numbers::pi * 0.01 * 0.5), 1e-12));
        CHECK(runner.value(energy).value() < runner.exact(energy).value());
        const Probe& nu = runner.lesson().probe("effective_viscosity");
        CHECK_THAT(runner.exact(nu).value(), WithinRel(0.01, 1e-12));
        return runner.value(nu).value() - 0.01;
    };
    CHECK_THAT(std::log2(excess("32", "0.02") / excess("64", "0.01")), WithinAbs(1, 0.25));
}

TEST_CASE("navier_stokes: what the advection adds to the viscosity is least with MacCormack's correction") {
    const auto excess = [](const char* scheme) {
        Runner runner = start_navier_stokes({{"scene", "taylor_green"},
                                             {"viscosity", "0.01"},
                                             {"resolution", "32"},
                                             {"time_step", "0.02"},
                                             {"advection", scheme}});
        while (runner.time() < 1 - 1e-9) runner.step();
        const Probe& energy = runner.lesson().probe("kinetic_energy");
        CHECK_THAT(runner.exact(energy).value(), WithinRel(0.25 * 0.20615299, 1e-7));
        check_laws(runner);
        return value(runner, "effective_viscosity") - 0.01;
    };
    const Real linear = excess("semi_lagrangian"), cubic = excess("monotone_cubic"), corrected = excess("mac_cormack");
    CHECK(corrected > 0);
    CHECK(cubic < 0.4 * linear);
    CHECK(corrected < 0.4 * linear);
}

TEST_CASE("navier_stokes: the scheme of advection can be changed on the way") {
    Runner runner = start_navier_stokes({{"resolution", "24"}}),
           other = start_navier_stokes({{"resolution", "24"}, {"advection", "mac_cormack"}});
    for (int k = 0; k < 5; ++k) runner.step(), other.step();
    CHECK(state_hash(runner.lesson()) != state_hash(other.lesson()));
    const auto before = state_hash(runner.lesson());
    runner.assign({{"advection", "mac_cormack"}, {"back_trace", "euler"}});
    runner.step();
    const auto after = state_hash(runner.lesson());
    runner.step_back();
    CHECK(state_hash(runner.lesson()) == before);
    runner.step();
    CHECK(state_hash(runner.lesson()) == after);
    check_laws(runner);
}

TEST_CASE("navier_stokes: the exact energy follows a viscosity that is changed on the way") {
    Runner runner =
        start_navier_stokes({{"scene", "taylor_green"}, {"viscosity", "0.01"}, {"resolution", "16"}, {"time_step", "0.125"}});
    runner.step();
    runner.assign("viscosity", 0.03);
    runner.step();
    const Real exponent = 16 * std::numbers::pi * std::numbers::pi * (0.01 + 0.03) * 0.125;
    CHECK_THAT(runner.exact(runner.lesson().probe("kinetic_energy")).value(), WithinRel(0.25 * std::exp(-exponent), 1e-12));
}

TEST_CASE("navier_stokes: the cavity at Re = 100 meets the published table, whichever way its lid moves", "[slow]") {
    for (const char* lid : {"1", "-2"})
        for (const char* scheme : {"semi_lagrangian", "monotone_cubic", "mac_cormack"}) {
            INFO(lid << " " << scheme);
            const bool fast = lid[0] == '-';
            Runner runner = start_navier_stokes({{"scene", "cavity"},
                                                 {"lid_speed", lid},
                                                 {"time_step", fast ? "0.025" : "0.05"},
                                                 {"resolution", "64"},
                                                 {"advection", scheme}});
            for (int k = 0; k < 500; ++k) runner.step();
            CHECK_THAT(value(runner, "reynolds_number"), WithinRel(100.0, 1e-12));
            // In units of the lid's speed: 0.011 with linear interpolation, 0.0075 with the methods of second order.
            const Real difference = value(runner, "table_difference") / (fast ? 2 : 1);
            CHECK(difference < (std::string(scheme) == "semi_lagrangian" ? 0.02 : 0.01));
            Curve measured, table;
            const Line& u = *std::ranges::find(runner.lesson().lines, "u_center", &Line::name);
            u.sample(measured);
            u.reference(table);
            CHECK(measured.value.front() == 0);
            CHECK(measured.value.back() == (fast ? -2 : 1));
            CHECK(table.value.back() == measured.value.back());
            check_laws(runner);
        }
}

TEST_CASE("navier_stokes: the lecture's explicit stencil is refused beyond its limit, which is named") {
    CHECK_THROWS_WITH(
        start_navier_stokes(
            {{"viscosity", "0.01"}, {"resolution", "64"}, {"viscosity_scheme", "explicit"}, {"time_step", "0.00611"}}),
        ContainsSubstring("time_step") && ContainsSubstring("0.006104 s") && ContainsSubstring("implicit"));
    CHECK_THROWS_AS(start_navier_stokes({{"viscosity", "1e6"}, {"viscosity_scheme", "explicit"}}), Refused);
    // Below it, both schemes agree to the order of the step.
    const Runner::Assignments vortices{
        {"scene", "taylor_green"}, {"viscosity", "0.01"}, {"resolution", "32"}, {"time_step", "0.005"}};
    Runner implicit = start_navier_stokes(vortices);
    Runner::Assignments with_stencil = vortices;
    with_stencil.emplace_back("viscosity_scheme", "explicit");
    Runner stencil = start_navier_stokes(with_stencil);
    for (int k = 0; k < 40; ++k) implicit.step(), stencil.step();
    CHECK_THAT(value(stencil, "kinetic_energy"), WithinRel(value(implicit, "kinetic_energy"), 0.01));
    CHECK(value(stencil, "kinetic_energy") < value(implicit, "kinetic_energy"));
    CHECK_THROWS_AS(start_navier_stokes({{"viscosity", "-1"}}), Refused);
}

TEST_CASE("navier_stokes: the ends of every range stay finite") {
    const char* scene = GENERATE("box", "cavity", "taylor_green", "poiseuille", "couette", "karman", "smoke");
    const char* scheme = GENERATE("semi_lagrangian", "mac_cormack");
    const char* resolution = GENERATE("1", "2", "3", "33");
    const char* viscosity = GENERATE("0", "1e-6", "1e6");
    const char* time_step = GENERATE("1e-6", "10");
    INFO(scene << " " << scheme << " " << resolution << " " << viscosity << " " << time_step);
    Runner runner = start_navier_stokes({{"scene", scene},
                                         {"resolution", resolution},
                                         {"viscosity", viscosity},
                                         {"time_step", time_step},
                                         {"lid_speed", "1000"},
                                         {"inflow", "1000"},
                                         {"advection", scheme},
                                         {"body_force", "1e6"},
                                         {"buoyancy", "-1e6"},
                                         {"stirring", "1e6"}});
    for (int k = 0; k < 8; ++k) runner.step();
    for (const Field& f : runner.lesson().fields) CHECK(std::ranges::all_of(f.view(), [](Real x) { return std::isfinite(x); }));
    check_laws(runner);
}
