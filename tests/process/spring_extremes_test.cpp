// The extremes of mass-spring nets on the command line: springs of no length, of none or negative stiffness, far too stiff ones,
// nets that nothing holds, nodes that everything holds.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

const Arguments springs_run{"run", "mesh/mass_spring", "--steps", "100"};
const std::vector<std::string> small{"cells_x=2", "cells_y=2", "cells_z=2"};

std::vector<std::string> joined(std::vector<std::string> settings, const std::vector<std::string>& more) {
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
}

Outcome outcome_of(const std::vector<std::string>& settings) {
    Arguments asked = with(springs_run, settings);
    asked.push_back("--json");
    return call(asked);
}

double probe(const Json& result, const char* name) { return result["probes"][name]["value"].get<double>(); }

}  // namespace

TEST_CASE("springs: rest length 0 and twice the distance stay finite with every damper and scheme", "[process]") {
    for (const char* scale : {"rest_length_scale=0", "rest_length_scale=2"})
        for (const char* integrator :
             {"integrator=semi_implicit_euler", "integrator=implicit_euler", "integrator=runge_kutta_4"}) {
            const Json result =
                json_of(with(springs_run, joined(small, {"scene=spin", scale, integrator, "damping_mode=projected"})));
            CHECK(std::isfinite(probe(result, "energy")));
            CHECK(std::abs(probe(result, "momentum")) < 1e-9);
        }
}

TEST_CASE("springs: negative stiffness, rest length and masses are refused by name", "[process]") {
    for (const auto& [setting, name] : {std::pair{"k_structural=-1", "k_structural"},
                                        {"k_shear=-1", "k_shear"},
                                        {"rest_length_scale=-0.5", "rest_length_scale"},
                                        {"damping=-1", "damping"},
                                        {"mass=0", "mass"},
                                        {"target_poisson=0.5", "target_poisson"},
                                        {"time_step=0", "time_step"}}) {
        const Outcome outcome = outcome_of({setting});
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, name));
    }
}

TEST_CASE("springs of 1e12 N/m on a gram: semi-implicit Euler is stopped with its limit, implicit Euler is finite", "[process]") {
    const std::vector<std::string> stiff = joined(small, {"k_structural=1e12", "mass=0.001", "time_step=0.01", "scene=hang"});
    const Outcome outcome = outcome_of(stiff);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == diverged);
    CHECK(contains(outcome.err, "stability limit"));
    const Json result = json_of(with(springs_run, joined(stiff, {"integrator=implicit_euler"})));
    CHECK(probe(result, "largest_strain") < 1e-3);
}

TEST_CASE("structural springs alone: finite in motion, and the static test reports the mechanisms", "[process]") {
    const std::vector<std::string> edges = joined(small, {"k_shear=0", "k_bending=0"});
    CHECK(std::isfinite(probe(json_of(with(springs_run, edges)), "energy")));
    for (const char* test : {"test=stretch", "test=shear", "test=bend"}) {
        const Outcome outcome = outcome_of(joined(edges, {"scene=stretch_test", test}));
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == diverged);
        CHECK(contains(outcome.err, "singular"));
        CHECK(contains(outcome.err, "mechanisms unconstrained"));
    }
}

TEST_CASE("springs: every node held, no spring at all, and a single spring are finite", "[process]") {
    const Json held = json_of(with(springs_run, {"lattice=chain", "scene=hang", "support=side", "integrator=implicit_euler"}));
    CHECK(probe(held, "kinetic_energy") == 0);
    const Json loose =
        json_of(with(springs_run, joined(small, {"k_structural=0", "k_shear=0", "k_bending=0", "drop_height=100"})));
    CHECK(std::abs(probe(loose, "height") - loose["probes"]["height"]["exact"].get<double>()) < 1e-3);
    const Json single =
        json_of(with(springs_run, {"lattice=chain", "cells_y=1", "scene=swing", "k_bending=0", "damping_mode=none"}));
    CHECK(std::abs(probe(single, "energy")) < 1);
}

TEST_CASE("a wished Poisson ratio that a lattice cannot have is reported", "[process]") {
    const std::vector<std::string> isotropic =
        joined(small, {"scene=stretch_test", "k_shear=200", "k_bending=0", "shared_edges=true"});
    const auto light = [&](const char* wish) {
        const Json result = json_of(with({"run", "mesh/mass_spring"}, joined(isotropic, {wish})));
        return result["assumptions"]["poisson_ratio"]["holds"].get<bool>();
    };
    CHECK(light("target_poisson=0.25"));
    CHECK_FALSE(light("target_poisson=0.45"));
}
