// The extremes of finite volumes on the command line.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

const Arguments fvm_run{"run", "mesh/fvm", "--steps", "20"};

}  // namespace

TEST_CASE("fvm: numbers that make no body are refused by name", "[process]") {
    for (const char* setting :
         {"time_step=0", "time_step=-1", "time_step=nan",     "youngs_modulus=0",  "youngs_modulus=-1",  "youngs_modulus=inf",
          "density=0",   "density=-1",   "poisson_ratio=0.5", "poisson_ratio=0.6", "poisson_ratio=-1",   "poisson_ratio=-1.2",
          "length=0",    "height=-1",    "cells_x=0",         "cells_y=2.5",       "damping=-1",         "load_x=nan",
          "load_y=inf",  "gravity=-1",   "element_shown=-1",  "shrink=2",          "newton_iterations=0"}) {
        const Outcome outcome = call(with(fvm_run, {setting}));
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, std::string(setting).substr(0, std::string(setting).find('='))));
    }
    for (const Arguments& settings :
         {Arguments{"cells_x=200", "cells_y=200"}, Arguments{"length=1e6", "height=1"},
          Arguments{"integrator=implicit_euler", "cells_x=100", "cells_y=50"}, Arguments{"model=neo_hookean", "plane=stress"}}) {
        const Outcome outcome = call(with(fvm_run, settings));
        INFO(settings.back() << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
    }
}

TEST_CASE("fvm: what is extreme and sound stays finite, with the forces of finite elements", "[process]") {
    for (const Arguments& settings :
         {Arguments{"poisson_ratio=0.4999", "plane=strain", "time_step=1e-5"}, Arguments{"poisson_ratio=-0.9", "time_step=1e-4"},
          Arguments{"poisson_ratio=0"}, Arguments{"cells_x=1", "cells_y=1"},
          Arguments{"scene=beam", "cells_x=1", "cells_y=1", "cells_z=1"}, Arguments{"integrator=implicit_euler", "time_step=1"},
          Arguments{"integrator=implicit_euler", "time_step=10"}, Arguments{"integrator=implicit_euler", "damping=1e6"},
          Arguments{"length=1e-6", "height=1e-6", "time_step=1e-9"}, Arguments{"scene=free", "spin=0"}, Arguments{"load_y=0"}}) {
        const Json result = json_of(with(fvm_run, settings));
        INFO(settings.front() << " " << settings.back());
        CHECK(std::isfinite(value(result, "energy")));
        CHECK(value(result, "sum_of_faces") <= 1e-12 * (1e-3 + value(result, "largest_face_force")));
    }
    const Json still = json_of(with({"run", "mesh/fvm", "--steps", "0"}, {}));
    CHECK(value(still, "tip_y") == 0);
}

TEST_CASE("fvm: above the limit of stability a run is stopped with the limit by name", "[process]") {
    for (const char* setting : {"time_step=1", "time_step=0.012", "integrator=explicit_euler"}) {
        Arguments asked = with({"run", "mesh/fvm", "--steps", "1000"}, {setting});
        asked.push_back("--json");
        const Outcome outcome = call(asked);
        INFO(sentence(asked) << "\n" << outcome.err);
        REQUIRE(outcome.exit_code == diverged);
        CHECK(contains(outcome.out + outcome.err, setting[0] == 'i' ? "stable at no Δt" : "stability limit 8.7 ms"));
    }
}

// The others may rest inside out, and say so; the neo-Hookean law forbids it.
TEST_CASE("fvm: elements that are pressed through themselves are told", "[process]") {
    const Arguments pressed{"load_x=-2e5", "load_y=0", "plane=strain"};
    for (const char* law : {"model=corotational", "model=stvk", "model=linear"}) {
        Arguments settings = pressed;
        settings.push_back(law);
        const Json result = json_of(with({"run", "mesh/fvm", "--steps", "40"}, settings));
        INFO(law);
        CHECK(value(result, "smallest_volume") < 0.05);
        CHECK(std::isfinite(value(result, "energy")));
    }
    Arguments settings = pressed;
    settings.push_back("model=neo_hookean");
    const Outcome outcome = call(with({"run", "mesh/fvm", "--steps", "400"}, settings));
    INFO(outcome.err);
    CHECK((outcome.exit_code == 0 || contains(outcome.err, "det F")));
    CHECK((outcome.exit_code == 0 || outcome.exit_code == diverged));
}
