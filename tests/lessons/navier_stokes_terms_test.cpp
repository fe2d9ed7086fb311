// The terms of the Navier-Stokes equations switched off one by one, and put into another order.
#include "readings.h"

#include <pliant/run/runner.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinRel;

namespace {

Runner start_navier_stokes_terms(const Runner::Assignments& parameters) {
    return Runner(find_lesson("fluids/navier_stokes"), parameters);
}

bool light_holds(const Runner& runner) {
    const auto& lights = runner.lesson().assumptions;
    const Assumption& light = *std::ranges::find(lights, "divergence-free", &Assumption::name);
    REQUIRE(light.in_use());
    return light.value() <= light.limit();
}

}  // namespace

TEST_CASE("navier_stokes: a term that is off has no stage and no array") {
    CHECK(stage_names(start_navier_stokes_terms({{"with_forces", "off"}})) == Names{"advection", "viscosity", "projection"});
    CHECK(stage_names(start_navier_stokes_terms({{"with_advection", "off"}})) ==
          Names{"external_forces", "viscosity", "projection"});
    CHECK(stage_names(start_navier_stokes_terms({{"with_viscosity", "off"}})) ==
          Names{"external_forces", "advection", "projection"});
    Runner piling_up = start_navier_stokes_terms({{"with_projection", "off"}, {"resolution", "16"}});
    CHECK(stage_names(piling_up) == Names{"external_forces", "advection", "viscosity"});
    for (int k = 0; k < 5; ++k) piling_up.step();
    for (const char* name : {"pressure", "divergence_before", "divergence_after"}) {
        const Field& field = *std::ranges::find(piling_up.lesson().fields, name, &Field::name);
        CHECK(!field.in_use());
        CHECK(field.view().empty());
    }
    CHECK(!piling_up.value(piling_up.lesson().probe("max_divergence")));
    CHECK(value(piling_up, "divergence_left") > 0.1);
    CHECK(!light_holds(piling_up));
    CHECK_THAT(piling_up.time(), WithinRel(0.1, 1e-12));
}

TEST_CASE("navier_stokes: without any term nothing happens, and time goes on") {
    Runner runner = start_navier_stokes_terms({{"scene", "taylor_green"},
                                               {"with_forces", "off"},
                                               {"with_advection", "off"},
                                               {"with_viscosity", "off"},
                                               {"with_projection", "off"},
                                               {"resolution", "16"}});
    CHECK(stage_names(runner).empty());
    const Real energy = value(runner, "kinetic_energy");
    for (int k = 0; k < 3; ++k) runner.step();
    CHECK(value(runner, "kinetic_energy") == energy);
    CHECK(runner.exact(runner.lesson().probe("kinetic_energy")) == energy);
    CHECK(runner.place().step == 3);
}

TEST_CASE("navier_stokes: terms can be switched on the way") {
    Runner runner = start_navier_stokes_terms(
        {{"scene", "taylor_green"}, {"viscosity", "0.01"}, {"resolution", "16"}, {"with_advection", "off"}});
    for (int k = 0; k < 5; ++k) runner.step();
    runner.assign("with_viscosity", 0);
    const Real energy = value(runner, "kinetic_energy");
    for (int k = 0; k < 5; ++k) runner.step();
    CHECK_THAT(value(runner, "kinetic_energy"), WithinRel(energy, 1e-9));
    // The exact energy knows.
    const Real exponent = 16 * std::numbers::pi * std::numbers::pi * 0.01 * 0.1;
    CHECK_THAT(*runner.exact(runner.lesson().probe("kinetic_energy")), WithinRel(0.25 * std::exp(-exponent), 1e-9));
}

TEST_CASE("navier_stokes: only the lecture's order leaves a velocity without divergence") {
    const auto [order, names] =
        GENERATE(table<const char*, Names>({{"lecture", {"external_forces", "advection", "viscosity", "projection"}},
                                            {"projection_first", {"projection", "external_forces", "advection", "viscosity"}},
                                            {"advection_last", {"external_forces", "viscosity", "projection", "advection"}},
                                            {"forces_last", {"advection", "viscosity", "projection", "external_forces"}}}));
    INFO(order);
    Runner runner = start_navier_stokes_terms({{"order", order}, {"resolution", "32"}});
    CHECK(stage_names(runner) == names);
    for (int k = 0; k < 20; ++k) runner.step();
    const bool lecture = std::string(order) == "lecture";
    CHECK(light_holds(runner) == lecture);
    CHECK((value(runner, "divergence_left") > 1e-2) == !lecture);
    CHECK((value(runner, "divergence_left") == value(runner, "max_divergence")) == lecture);
    CHECK_THAT(runner.time(), WithinRel(0.4, 1e-12));
    // Going back and forward gives the same bits in every order.
    const auto hash = state_hash(runner.lesson());
    runner.step_back();
    runner.step();
    CHECK(state_hash(runner.lesson()) == hash);
    // Another order begins a run of its own, and the lecture's comes back.
    runner.assign({{"order", "lecture"}});
    CHECK(stage_names(runner) == Names{"external_forces", "advection", "viscosity", "projection"});
    CHECK(runner.place().step == (lecture ? 20 : 0));
}

TEST_CASE("navier_stokes: the light of the order offers what mends it") {
    for (const Runner::Assignments& wrong : {Runner::Assignments{{"order", "forces_last"}}, {{"with_projection", "off"}}}) {
        Runner::Assignments parameters = wrong;
        parameters.emplace_back("resolution", "24");
        Runner runner = start_navier_stokes_terms(parameters);
        for (int k = 0; k < 5; ++k) runner.step();
        REQUIRE(!light_holds(runner));
        const auto& lights = runner.lesson().assumptions;
        const auto fix = std::ranges::find(lights, "divergence-free", &Assumption::name)->fix();
        REQUIRE(fix);
        runner.assign(fix->assign);
        for (int k = 0; k < 5; ++k) runner.step();
        CHECK(light_holds(runner));
    }
}

TEST_CASE("navier_stokes: before and after of every stage are kept, of the velocity and of the smoke") {
    Runner runner = start_navier_stokes_terms({{"scene", "smoke"}, {"resolution", "16"}, {"viscosity", "0.01"}});
    for (int k = 0; k < 3; ++k) runner.step();
    StepTrace trace;
    runner.trace_to(&trace);
    runner.step();
    const Lesson& lesson = runner.lesson();
    REQUIRE(runner.stages().size() == 5);
    for (const Stage* stage : runner.stages())
        for (const char* name : {"u_on_faces", "v_on_faces", "smoke"}) {
            INFO(stage->name << " " << name);
            const auto before = trace.before(lesson, *stage, name), after = trace.after(lesson, *stage, name);
            REQUIRE(before.size() == lesson.field(name).view().size());
            REQUIRE(after.size() == before.size());
            const bool carries = stage->name == "smoke", lifts = stage->name == "external_forces";
            const bool changed = carries == (std::string(name) == "smoke") && !(lifts && name[0] == 'u');
            CHECK(std::equal(before.begin(), before.end(), after.begin()) == !changed);
        }
    runner.trace_to(nullptr);
}

TEST_CASE("navier_stokes: another order moves no stage, and each keeps its cost") {
    Runner runner = start_navier_stokes_terms({{"resolution", "16"}});
    const auto declared = [&] {
        Names names;
        for (const Stage& s : runner.lesson().stages) names.emplace_back(s.name);
        return names;
    };
    const Names names = declared();
    const Stage* projection = &*std::ranges::find(runner.lesson().stages, "projection", &Stage::name);
    runner.step();
    const Index passes = runner.cost(*projection).passes;
    CHECK(passes > 1);
    for (const auto& [order, first] :
         {std::pair{"projection_first", "projection"}, {"forces_last", "advection"}, {"lecture", "external_forces"}}) {
        INFO(order);
        runner.assign({{"order", order}});
        CHECK(declared() == names);
        CHECK(stage_names(runner).front() == first);
        CHECK(runner.cost(*projection).passes == 0);
        runner.step();
        CHECK(projection->name == "projection");
        CHECK(runner.cost(*projection).runs == 1);
        CHECK(runner.cost(*runner.stages().back()).runs == 1);
        CHECK_THAT(runner.time(), WithinRel(runner.time_step(), 1e-12));
    }
}
