// The extremes of diffusion on the command line: no viscosity, a huge one, less than none, steps far beyond the limit.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

const Arguments diffusion_run{"run", "fluids/diffusion", "--steps", "20"};

// Δt = rΔx²/ν: with ν = 1e6 m²/s and a step of 1 s on 32 cells of a metre, r = 1e6 · 32².
const std::vector<std::string> thick{"viscosity=1e6", "diffusion_number=1.024e9", "start=step"};

std::vector<std::string> joined(std::vector<std::string> settings, const std::vector<std::string>& more) {
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
}

}  // namespace

TEST_CASE("diffusion without viscosity leaves everything as it is", "[process]") {
    for (const char* scheme : {"scheme=explicit", "scheme=implicit"})
        for (const char* dimension : {"dimension=1", "dimension=2"}) {
            const Json result = json_of(with(diffusion_run, {"viscosity=0", "start=step", scheme, dimension}));
            CHECK(result["probes"]["max"]["value"] == 1);
            CHECK(result["probes"]["min"]["value"] == 0);
            CHECK(result["time"] == 20);
        }
}

TEST_CASE("diffusion with a huge viscosity: implicit is finite and even, and tells its iterations", "[process]") {
    for (const char* dimension : {"dimension=1", "dimension=2"}) {
        const Json probes = json_of(with(diffusion_run, joined(thick, {"scheme=implicit", dimension})))["probes"];
        CHECK(std::abs(probes["max"]["value"].get<double>() - 0.5) < 1e-6);
        CHECK(std::abs(probes["min"]["value"].get<double>() - 0.5) < 1e-6);
        CHECK(probes["solver_iterations"]["value"].is_number());
        const Json walls = json_of(
            with(diffusion_run, joined(thick, {"scheme=implicit", dimension, "boundary=fixed", "wall_high=0"})))["probes"];
        CHECK(std::abs(walls["max"]["value"].get<double>()) < 1e-6);
    }
}

TEST_CASE("diffusion with a huge viscosity: explicit is stopped, with the limit by name", "[process]") {
    for (const auto& [dimension, limit] : {std::pair{"dimension=1", "1/2 in 1D"}, {"dimension=2", "1/4 in 2D"}})
        for (const std::vector<std::string>& scene :
             {joined(thick, {dimension}), std::vector<std::string>{"start=random", "diffusion_number=1", dimension}}) {
            Arguments asked = with(diffusion_run, scene);
            asked.push_back("--json");
            const Outcome outcome = call(asked);
            INFO(sentence(asked) << "\n" << outcome.err);
            REQUIRE(outcome.exit_code == diverged);
            CHECK(contains(outcome.err, limit));
            const Json failure = Json::parse(outcome.out)["failure"];
            CHECK(contains(failure["limit"], "Lower r to 0."));
            CHECK(contains(failure["limit"], "choose the implicit scheme"));
        }
}

TEST_CASE("diffusion refuses what is none", "[process]") {
    for (const auto& [setting, key] : {std::pair{"viscosity=-1", "viscosity"},
                                       {"viscosity=-1e-9", "viscosity"},
                                       {"diffusion_number=0", "diffusion_number"},
                                       {"diffusion_number=-0.1", "diffusion_number"},
                                       {"length=0", "length"},
                                       {"resolution=1", "resolution"},
                                       {"viscosity=1e-300", "viscosity"},
                                       {"dimension=3", "dimension"}}) {
        const Outcome outcome = call(with(diffusion_run, {setting}));
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(outcome.out.empty());
        CHECK(contains(outcome.err, std::string(key) + " = "));
    }
}
