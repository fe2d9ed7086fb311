// Explanations of cloth in its corner cases: inexact solves, passes of strain limiting, planes and friction, impacts, gusts.
#include "why_checks.h"

using namespace pliant;

namespace {

void check_after(const Runner::Assignments& settings, int steps_before, Index steps) {
    Runner::Assignments all{{"nodes", "5"}};
    all.insert(all.end(), settings.begin(), settings.end());
    Runner runner(find_lesson("mesh/cloth"), all);
    std::string where = "mesh/cloth";
    for (const auto& [key, value] : settings) where += " " + key + "=" + value;
    for (int k = 0; k < steps_before; ++k) runner.step();
    check_every_stage(runner, where, steps, 3);
}

}  // namespace

TEST_CASE("explanations of cloth: on the sphere, where nodes arrive, rest and slide") {
    check_after({{"scene", "drape"}}, 5, 4);
    check_after({{"scene", "drape"}, {"strain_limiting", "on"}, {"strain_limit", "0.002"}}, 10, 3);
    check_after({{"scene", "drape"}, {"scheme", "semi_implicit_euler"}, {"time_step", "0.001"}}, 70, 4);
    check_after({{"scene", "drape"}, {"air_drag", "0"}, {"friction", "0"}}, 12, 2);
}

TEST_CASE("explanations of cloth: every solver, with passes that can be stopped at") {
    check_after({{"newton_cap", "5"}}, 3, 2);
    check_after({{"newton", "full"}, {"linear_solver", "direct"}}, 3, 2);
    check_after({{"newton", "full"}}, 3, 2);
    check_after({{"scheme", "explicit_euler"}, {"time_step", "0.0001"}, {"damping_mode", "naive"}}, 3, 2);
}

TEST_CASE("explanations of cloth: gusts, a hand, springs without stiffness, drape test") {
    check_after({{"scene", "flag"}, {"wind", "9"}, {"gust", "0.8"}}, 9, 3);
    check_after({{"scene", "pedestal"}, {"k_bending", "0"}, {"damping_mode", "naive"}}, 4, 2);
    Runner runner(find_lesson("mesh/cloth"), {{"nodes", "7"}});
    runner.pull(Pull{.index = 3, .from = Vec<3>::Zero(), .to = Vec<3>(0, 0.2, 0.1)});
    check_every_stage(runner, "mesh/cloth pulled", 2);
}
