// The extremes of finite differences on the command line.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

const Arguments fdm_run{"run", "mesh/fdm", "--steps", "20"};

}  // namespace

TEST_CASE("fdm: numbers that make no body, no grid or no step are refused by name", "[process]") {
    for (const char* setting : {"resolution=0",
                                "resolution=-1",
                                "resolution=2.5",
                                "resolution=1e9",
                                "youngs_modulus=0",
                                "youngs_modulus=-1",
                                "youngs_modulus=nan",
                                "poisson_ratio=0.5",
                                "poisson_ratio=-1",
                                "poisson_ratio=0.6",
                                "density=0",
                                "density=-1",
                                "density=inf",
                                "length=0",
                                "body_force=nan",
                                "time_step=0",
                                "time_step=-1",
                                "damping=-1",
                                "integrator=implicit_euler",
                                "form=none"}) {
        const Outcome outcome = call(with(fdm_run, {"scene=block", setting}));
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, std::string(setting).substr(0, std::string(setting).find('='))));
    }
}

TEST_CASE("fdm: one or two cells across are a grid, in every scene and form", "[process]") {
    for (const char* scene : {"scene=rod", "scene=manufactured", "scene=block", "scene=disc"})
        for (const char* form : {"form=navier_lame", "form=metric_tensor"})
            for (const char* cells : {"resolution=1", "resolution=2"}) {
                const Json result = json_of(with(fdm_run, {scene, form, cells, "amplitude=0.03"}));
                CHECK(std::isfinite(value(result, "elastic_energy")));
                CHECK(value(result, "force_sum") < 1e-8);
            }
}

TEST_CASE("fdm: incompressible, weightless and widening bodies stay finite, zero steps change nothing", "[process]") {
    for (const char* nu : {"poisson_ratio=0.4999", "poisson_ratio=-0.9", "poisson_ratio=0"})
        for (const char* scene : {"scene=manufactured", "scene=disc"}) {
            const Json result = json_of(with(fdm_run, {scene, nu, "resolution=8"}));
            CHECK(std::isfinite(value(result, "nodal_error")));
        }
    const Json still = json_of(with(fdm_run, {"scene=block", "body_force=0"}));
    CHECK(value(still, "elastic_energy") == 0);
    CHECK(value(still, "u_y_corner") == 0);
    CHECK(value(json_of(with({"run", "mesh/fdm", "--steps", "0"}, {})), "tip") == 0.01);
    const Json rigid = json_of(with(fdm_run, {"scene=disc", "body_force=0", "resolution=8"}));
    CHECK(value(rigid, "nodal_error") == 0);
}

TEST_CASE("fdm: above the limit of the step a run is stopped with the limit by name", "[process]") {
    for (const char* scene : {"scene=rod", "scene=block"}) {
        Arguments asked = with({"run", "mesh/fdm", "--steps", "3000"}, {scene, "time_step=1"});
        asked.push_back("--json");
        const Outcome outcome = call(asked);
        INFO(sentence(asked) << "\n" << outcome.err);
        REQUIRE(outcome.exit_code == diverged);
        CHECK(contains(Json::parse(outcome.out)["failure"]["limit"], "stability limit of"));
    }
    const Outcome grows = call(with({"run", "mesh/fdm", "--steps", "20000"}, {"integrator=explicit_euler", "time_step=3e-3"}));
    CHECK(grows.exit_code == diverged);
    CHECK(contains(grows.err, "stable at no Δt"));
}

TEST_CASE("fdm: a load that no equilibrium bears is reported, not accepted", "[process]") {
    // Squeezed cells soften: Newton's method finds no way.
    const Outcome outcome = call(with(fdm_run, {"scene=manufactured", "form=metric_tensor", "amplitude=0.1"}));
    INFO(outcome.err);
    CHECK(outcome.exit_code == diverged);
    CHECK(contains(outcome.err, "Newton's method"));
    // Pressed inwards the disc turns by 180°, where the same forces pull it.
    CHECK(std::isfinite(value(json_of(with(fdm_run, {"scene=disc", "form=metric_tensor", "body_force=-1e5", "resolution=8"})),
                              "elastic_energy")));
    const Outcome huge = call(with(fdm_run, {"scene=block", "body_force=1e12"}));
    CHECK(huge.exit_code != refused);
}
