// Explanations of the virtual material tests, and the fixes of what goes wrong with them.
#include "readings.h"
#include "why_checks.h"

using namespace pliant;
using namespace pliant::test;

namespace {

Runner specimen(Runner::Assignments parameters) {
    parameters.insert(parameters.begin(), {{"resolution", "2"}, {"load_levels", "3"}});
    return Runner(find_lesson("elasticity/moduli"), parameters);
}

}  // namespace

TEST_CASE("every iterate of conjugate gradients is explained with what it left unbalanced") {
    for (const char* test : {"tension", "shear", "pressure"}) {
        Runner runner = specimen({{"test", test}});
        while (runner.place().step < 1) {
            runner.step_pass();
            if (runner.passes_in_stage() % 3 == 0) check_stage(runner, *runner.stages()[*runner.last_stage()], test);
        }
        check_probes(runner, test);
    }
}

TEST_CASE("a test without load, stopped early, or over already is explained") {
    for (const Runner::Assignments& parameters :
         {Runner::Assignments{{"load", "0"}}, {{"max_iterations", "2"}}, {{"load", "-20000"}, {"poisson_ratio", "-0.4"}}}) {
        Runner runner = specimen(parameters);
        check_every_stage(runner, "specimen");
        runner.step();
        check_probes(runner, "a test that is over");
    }
}

TEST_CASE("the fixes of a material test mend what they promise") {
    const std::vector<std::pair<std::string, Runner::Assignments>> broken{
        {"small strain", {{"load", "90000"}, {"test", "shear"}}},
        {"compressible enough", {{"poisson_ratio", "0.495"}}},
        {"solver converged", {{"max_iterations", "3"}}}};
    for (const auto& [name, parameters] : broken) {
        INFO(name);
        Runner runner = specimen(parameters);
        runner.step();
        const Assumption& checked = assumption(runner, name);
        REQUIRE(!holds(checked));
        for (int times = 0; times < 3 && !holds(checked); ++times) {
            const auto fix = checked.fix();
            REQUIRE(fix);
            runner.assign(Runner::Assignments(fix->assign.begin(), fix->assign.end()));
            runner.step();
        }
        CHECK(holds(checked));
    }
}
