// The scenes of the Navier-Stokes lesson that have a closed form or a known behaviour: channels, the cavity of any shape, the
// vortex street, smoke.
#include <pliant/fluids/channel_flow.h>
#include <pliant/run/runner.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include "readings.h"
#include "why_checks.h"

#include <algorithm>
#include <cmath>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner start_navier_stokes_scenes(const Runner::Assignments& parameters) {
    return Runner(find_lesson("fluids/navier_stokes"), parameters);
}

std::optional<Real> probe(const Runner& runner, std::string_view name) { return runner.value(runner.lesson().probe(name)); }

const Line& line(const Runner& runner, std::string_view name) {
    return *std::ranges::find(runner.lesson().lines, name, &Line::name);
}

Curve sampled(const std::function<void(Curve&)>& sample) {
    Curve curve;
    sample(curve);
    return curve;
}

void run_until(Runner& runner, Real time) {
    while (runner.time() < time - 1e-9) runner.step();
}

}  // namespace

TEST_CASE("navier_stokes: a channel that is pushed tends to Poiseuille's parabola") {
    Runner runner = start_navier_stokes_scenes(
        {{"scene", "poiseuille"}, {"viscosity", "0.1"}, {"body_force", "0.8"}, {"resolution", "24"}, {"time_step", "0.2"}});
    run_until(runner, 1);
    CHECK(*probe(runner, "profile_difference") < 0.05);
    run_until(runner, 40);
    const Curve measured = sampled(line(runner, "profile").sample), steady = sampled(line(runner, "profile").reference);
    REQUIRE(measured.position == steady.position);
    CHECK(measured.value.front() == 0);
    CHECK(measured.value.back() == 0);
    const Real middle = *std::ranges::max_element(measured.value);
    CHECK_THAT(middle, WithinAbs(1, 0.004));
    for (std::size_t k = 0; k < steady.value.size(); ++k) {
        CHECK_THAT(steady.value[k], WithinAbs(poiseuille_speed(steady.position[k], 1, 0.8, 0.1), 1e-12));
        CHECK_THAT(measured.value[k], WithinAbs(steady.value[k], 0.002));
    }
    check_laws(runner);
}

TEST_CASE("navier_stokes: a wall that starts to move drags the fluid along as the series says") {
    Runner runner =
        start_navier_stokes_scenes({{"scene", "couette"}, {"viscosity", "0.1"}, {"resolution", "40"}, {"time_step", "0.005"}});
    for (const auto& [time, expected] : {std::pair{0.2, 0.01241933}, {0.5, 0.11384420}, {1.0, 0.26275627}}) {
        run_until(runner, time);
        const Curve measured = sampled(line(runner, "profile").sample);
        const auto above = std::ranges::lower_bound(measured.position, 0.5) - measured.position.begin();
        const auto k = static_cast<std::size_t>(above);
        CHECK_THAT(0.5 * (measured.value[k - 1] + measured.value[k]), WithinAbs(expected, 2e-3));
        const Curve series = sampled(line(runner, "profile").reference);
        CHECK_THAT(0.5 * (series.value[k - 1] + series.value[k]), WithinAbs(expected, 5e-4));
        CHECK(*probe(runner, "profile_difference") < 5e-3);
    }
    check_laws(runner);
}

TEST_CASE("navier_stokes: the cavity has any shape, and its Reynolds number sets the viscosity") {
    Runner runner = start_navier_stokes_scenes({{"scene", "cavity"},
                                                {"aspect", "2"},
                                                {"resolution", "16"},
                                                {"reynolds", "50"},
                                                {"lid_speed", "2"},
                                                {"size", "0.5"},
                                                {"viscosity", "123"}});
    CHECK(field(runner, "pressure").size() == 16 * 32);
    CHECK_THAT(*probe(runner, "reynolds_number"), WithinRel(50.0, 1e-12));
    for (int k = 0; k < 20; ++k) runner.step();
    const Curve u = sampled(line(runner, "u_center").sample), v = sampled(line(runner, "v_center").sample);
    CHECK(u.position.back() == 1);
    CHECK(u.value.back() == 2);
    CHECK(v.position.back() == 0.5);
    CHECK(sampled(line(runner, "u_center").reference).position.empty());  // the table is that of a square
    CHECK(!probe(runner, "table_difference"));
    check_laws(runner);
}

TEST_CASE("navier_stokes: a cavity of another size is the same cavity in other units") {
    Runner one = start_navier_stokes_scenes({{"scene", "cavity"}, {"resolution", "16"}});
    Runner small =
        start_navier_stokes_scenes({{"scene", "cavity"}, {"resolution", "16"}, {"size", "1e-3"}, {"time_step", "2e-5"}});
    for (int k = 0; k < 10; ++k) one.step(), small.step();
    CHECK_THAT(*probe(small, "kinetic_energy"), WithinRel(*probe(one, "kinetic_energy"), 1e-6));
    const Curve u = sampled(line(one, "u_center").sample), w = sampled(line(small, "u_center").sample);
    for (std::size_t k = 0; k < u.value.size(); ++k) {
        CHECK_THAT(w.position[k], WithinAbs(1e-3 * u.position[k], 1e-15));
        CHECK_THAT(w.value[k], WithinAbs(u.value[k], 1e-6));
    }
}

TEST_CASE("navier_stokes: as much flows out behind the disc as in before it, and none through it") {
    Runner runner = start_navier_stokes_scenes({{"scene", "karman"}, {"resolution", "48"}});
    for (int k = 0; k < 10; ++k) runner.step();
    const Index nx = 96, ny = 36;
    const auto u = field(runner, "u_on_faces");
    for (const Index column : {Index{0}, Index{10}, Index{22}, Index{60}, nx}) {
        Real flux = 0;
        for (Index j = 0; j < ny; ++j) flux += u[static_cast<std::size_t>(column + (nx + 1) * j)] / 48;
        CHECK_THAT(flux, WithinAbs(0.75, 1e-3));
    }
    const Index middle = 21 + nx * 16;  // in the disc
    CHECK(field(runner, "speed")[static_cast<std::size_t>(middle)] == 0);
    check_laws(runner);
}

TEST_CASE("navier_stokes: behind a disc vortices are shed in a steady rhythm", "[slow]") {
    Runner runner = Runner(find_lesson("fluids/navier_stokes"),
                           {{"scene", "karman"}, {"reynolds", "150"}, {"resolution", "96"}, {"time_step", "0.015"}});
    run_until(runner, 15);
    REQUIRE(probe(runner, "strouhal"));
    CHECK(*probe(runner, "strouhal") > 0.15);
    CHECK(*probe(runner, "strouhal") < 0.3);
    Real largest = 0;
    for (int k = 0; k < 60; ++k) {
        runner.step();
        largest = std::max(largest, std::abs(*probe(runner, "wake_velocity")));
    }
    CHECK(largest > 0.2);
}

TEST_CASE("navier_stokes: smoke rises by its own lightness, and sinks where it is heavy") {
    const auto mean_height = [](const char* buoyancy) {
        Runner runner =
            start_navier_stokes_scenes({{"scene", "smoke"}, {"buoyancy", buoyancy}, {"resolution", "32"}, {"viscosity", "0"}});
        for (int k = 0; k < 50; ++k) runner.step();
        check_laws(runner);
        const auto s = field(runner, "smoke");
        Real volume = 0, moment = 0;
        for (Index j = 0; j < 32; ++j)
            for (Index i = 0; i < 32; ++i) {
                const Real here = s[static_cast<std::size_t>(i + 32 * j)];
                CHECK(here >= 0);
                CHECK(here <= 1 + 1e-12);
                volume += here, moment += here * (static_cast<Real>(j) + 0.5) / 32;
            }
        CHECK_THAT(*probe(runner, "smoke_volume"), WithinRel(volume / (32 * 32), 1e-12));
        return moment / volume;
    };
    const Real rising = mean_height("2"), floating = mean_height("0"), sinking = mean_height("-2");
    CHECK(rising > 1.5 * floating);
    CHECK(sinking < floating);
    CHECK_THAT(floating, WithinAbs(0.1, 0.01));
}

TEST_CASE("navier_stokes: the stage that carries smoke exists in its scene alone") {
    for (const char* scene : {"box", "cavity", "taylor_green", "poiseuille", "couette", "karman"}) {
        const Runner runner = start_navier_stokes_scenes({{"scene", scene}, {"resolution", "8"}});
        CHECK(std::ranges::none_of(runner.stages(), [](const Stage* s) { return s->name == "smoke"; }));
        const Field& smoke = *std::ranges::find(runner.lesson().fields, "smoke", &Field::name);
        CHECK(!smoke.in_use());
        CHECK(smoke.view().empty());
    }
    CHECK(start_navier_stokes_scenes({{"scene", "smoke"}, {"resolution", "8"}}).stages().back()->name == "smoke");
}

TEST_CASE("navier_stokes: more cells than a step could take are refused") {
    CHECK_THROWS_AS(start_navier_stokes_scenes({{"scene", "cavity"}, {"aspect", "10"}, {"resolution", "512"}}), Refused);
    Runner runner = start_navier_stokes_scenes({{"scene", "cavity"}, {"aspect", "10"}, {"resolution", "8"}});
    CHECK_THROWS_AS(runner.assign({{"resolution", "512"}}), Refused);
    runner.step();
    CHECK(field(runner, "pressure").size() == 8 * 80);
}

TEST_CASE("navier_stokes: the numbers that are read off every scene are explained") {
    for (const char* scene : {"box", "cavity", "taylor_green", "poiseuille", "couette", "karman", "smoke"})
        for (const char* cells : {"16", "17"}) {
            Runner runner = start_navier_stokes_scenes({{"scene", scene}, {"resolution", cells}, {"advection", "mac_cormack"}});
            for (int k = 0; k < 3; ++k) runner.step();
            check_probes(runner, std::string(scene) + " " + cells);
        }
}
