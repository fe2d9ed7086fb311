// The extremes of cloth on the command line: springs of steel, steps of seconds, hurricanes, sheets of four nodes.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

const Arguments cloth_run{"run", "mesh/cloth", "--steps", "20", "--set", "nodes=9"};

const std::vector<std::string> steel{"k_structural=1e12", "mass=1e-3", "time_step=1e-2"};

}  // namespace

TEST_CASE("cloth of steel threads: implicit is finite, explicit is stopped with its limit", "[process]") {
    Arguments stiff = with(cloth_run, steel);
    const Json result = json_of(stiff);
    CHECK(result["steps"] == 20);
    CHECK(std::isfinite(result["probes"]["imbalance"]["value"].get<double>()));
    CHECK(std::abs(result["probes"]["largest_strain"]["value"].get<double>()) < 1e-6);
    for (const char* scheme : {"scheme=explicit_euler", "scheme=semi_implicit_euler"}) {
        const Outcome outcome = call(with(stiff, {scheme}));
        INFO(outcome.err);
        CHECK(outcome.exit_code == diverged);
        CHECK(contains(outcome.err, "stability limit"));
        CHECK(contains(outcome.err, "implicit Euler"));
    }
}

TEST_CASE("cloth in steps of ten seconds is finite in every scene", "[process]") {
    for (const char* scene : {"hanging_corners", "hanging_edge", "drape", "flag", "pedestal"}) {
        INFO(scene);
        const Json result = json_of(with(cloth_run, {"time_step=10", std::string("scene=") + scene}));
        CHECK(result["time"] == 200);
    }
}

TEST_CASE("cloth in a hurricane of 10 km/s is finite or stopped in words", "[process]") {
    for (const char* scene : {"scene=flag", "scene=drape"})
        for (const char* scheme : {"scheme=implicit_euler", "scheme=semi_implicit_euler"}) {
            const Outcome outcome = call(with(cloth_run, {"wind=1e4", scene, scheme}));
            INFO(scene << " " << scheme << "\n" << outcome.err);
            CHECK((outcome.exit_code == 0 || outcome.exit_code == diverged));
            if (outcome.exit_code == diverged) CHECK(contains(outcome.err, "beyond the bound"));
            CHECK_FALSE(contains(outcome.out, "nan"));
        }
}

TEST_CASE("cloth of four nodes, without springs, on a sphere of no size", "[process]") {
    for (const std::vector<std::string>& settings : {std::vector<std::string>{"nodes=2"},
                                                     {"nodes=2", "scene=drape"},
                                                     {"k_shear=0", "k_bending=0"},
                                                     {"k_structural=0", "k_shear=0", "k_bending=0"},
                                                     {"scene=drape", "sphere_radius=0"},
                                                     {"scene=pedestal", "sphere_radius=5"},
                                                     {"strain_limiting=on", "strain_limit=0"}})
        CHECK(json_of(with(cloth_run, settings))["steps"] == 20);
    const Outcome too_large = call(with(cloth_run, {"nodes=64", "linear_solver=direct"}));
    CHECK(too_large.exit_code == refused);
    CHECK(contains(too_large.err, "conjugate_gradients"));
}
