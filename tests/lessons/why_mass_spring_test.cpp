// Explanations of falling, bouncing and pulled blocks, and the fixes of what goes wrong with them.
#include "readings.h"
#include "why_checks.h"

#include <pliant/document/scene_file.h>

using namespace pliant;
using namespace pliant::test;

namespace {

using Assignments = Runner::Assignments;

const Assignments small_block{
    {"cells_x", "2"}, {"cells_y", "2"}, {"cells_z", "1"}, {"drop_height", "0.005"}, {"time_step", "0.002"}};

Runner block(Assignments more) {
    Assignments all = small_block;
    all.insert(all.end(), more.begin(), more.end());
    return Runner(find_lesson("mesh/mass_spring"), all);
}

bool any_touches(const Runner& runner) { return runner.value(runner.lesson().probe("touching_nodes")).value_or(0) > 0; }

// Steps until the block has met the ground, checks what follows.
void check_impact(const Assignments& parameters, const std::string& where) {
    Runner runner = block(parameters);
    for (int step = 0; step < 200 && !any_touches(runner); ++step) runner.step();
    REQUIRE(any_touches(runner));
    check_every_stage(runner, where);
    for (int step = 0; step < 30; ++step) runner.step();
    check_every_stage(runner, where + ", later");
}

void apply(Runner& runner, const Fix& fix) {
    CHECK(!fix.label.empty());
    Assignments assign;
    for (const auto& [key, value] : fix.assign) assign.emplace_back(key, value);
    runner.assign(assign);
}

}  // namespace

TEST_CASE("impacts are explained with every integrator, rebound and friction") {
    for (const char* integrator : {"explicit_euler", "semi_implicit_euler", "implicit_euler"})
        for (const auto& [restitution, friction] : {std::pair{"0", "0.5"}, {"0.7", "0"}, {"0.3", "0.01"}})
            check_impact({{"integrator", integrator}, {"restitution", restitution}, {"friction", friction}},
                         std::string(integrator) + ", e = " + restitution + ", μ = " + friction);
}

TEST_CASE("blocks of naive dampers, without springs, and pulled ones are explained") {
    for (const char* integrator : {"explicit_euler", "semi_implicit_euler", "implicit_euler"}) {
        const Assignments with{{"integrator", integrator}};
        for (const Assignments& more : {Assignments{{"damping_mode", "naive"}},
                                        {{"damping_mode", "none"}, {"gravity", "0"}},
                                        {{"k_structural", "0"}, {"k_shear", "0"}, {"k_bending", "0"}},
                                        {{"scene", "spin"}},
                                        {{"scene", "hang"}}}) {
            Assignments all = with;
            all.insert(all.end(), more.begin(), more.end());
            Runner runner = block(all);
            runner.step();
            check_every_stage(runner, integrator);
            runner.pull(Pull{.index = 4, .from = {0, 0, 0}, .to = {0.5, 0.8, 0.1}});
            runner.step();
            check_every_stage(runner, std::string(integrator) + ", pulled");
        }
    }
}

TEST_CASE("every iterate of a long Newton iteration is explained, searches included") {
    Runner runner = block({{"integrator", "implicit_euler"},
                           {"time_step", "0.05"},
                           {"k_structural", "20000"},
                           {"tilt", "40"},
                           {"drop_height", "0.3"},
                           {"damping_mode", "none"}});
    Index most = 0;
    while (runner.place().step < 12) {
        runner.step_pass();
        const Stage& stage = *runner.stages()[*runner.last_stage()];
        most = std::max(most, runner.passes_in_stage());
        if (stage.name == "integrate") check_stage(runner, stage, "a long step");
    }
    CHECK(most >= 4);
}

TEST_CASE("a velocity of implicit Euler is balanced by the forces at the end of the step") {
    Runner runner = block({{"integrator", "implicit_euler"}, {"scene", "hang"}});
    for (int step = 0; step < 5; ++step) runner.step();
    const Answer a = why(runner, "velocity", 3, 1, 1);
    REQUIRE(a.kind == Answer::Kind::computed);
    const auto residual = std::ranges::find(a.inputs, "r", &Answer::symbol);
    const auto weight = std::ranges::find(a.inputs, "fᵉ(x′)", &Answer::symbol);
    REQUIRE((residual != a.inputs.end() && weight != a.inputs.end()));
    CHECK(std::abs(residual->value) < 1e-6 * std::abs(weight->value));
}

TEST_CASE("the fix of an unstable step makes it stable, and a run that blew up goes on") {
    for (const Assignments& parameters : {Assignments{{"integrator", "semi_implicit_euler"}, {"time_step", "0.02"}},
                                          {{"integrator", "explicit_euler"}, {"time_step", "0.01"}},
                                          {{"integrator", "explicit_euler"}, {"time_step", "0.005"}, {"damping_mode", "none"}}}) {
        Runner broken(find_lesson("mesh/mass_spring"), parameters);
        const Assumption& stability = assumption(broken, "stability");
        REQUIRE(!holds(stability));
        REQUIRE(stability.fix());
        Runner fixed(find_lesson("mesh/mass_spring"), parameters);
        apply(fixed, *stability.fix());
        fixed.step();
        CHECK((!assumption(fixed, "stability").in_use() || holds(assumption(fixed, "stability"))));

        std::optional<Failure> failure;
        try {
            for (int step = 0; step < 5000; ++step) broken.step();
        } catch (const Diverged& diverged) {
            failure = diverged.failure;
        }
        REQUIRE(failure);
        const Real time = broken.time();
        const auto fix = broken.lesson().fix(*failure);
        REQUIRE(fix);
        Runner again(find_lesson("mesh/mass_spring"), parameters);
        apply(again, *fix);
        while (again.time() < time) REQUIRE_NOTHROW(again.step());
    }
}

TEST_CASE("the fixes of travel and of missing diagonals mend them") {
    Runner fast = block({{"scene", "spin"}, {"spin", "400"}, {"time_step", "0.01"}, {"integrator", "implicit_euler"}});
    REQUIRE(!holds(assumption(fast, "travel")));
    apply(fast, *assumption(fast, "travel").fix());
    CHECK(holds(assumption(fast, "travel")));
    Runner loose = block({{"k_shear", "0"}});
    REQUIRE(!holds(assumption(loose, "shear_mechanism")));
    apply(loose, *assumption(loose, "shear_mechanism").fix());
    CHECK(holds(assumption(loose, "shear_mechanism")));
}
