// The extremes of boundary elements on the command line.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

const Arguments bem_run{"run", "mesh/bem"};

}  // namespace

TEST_CASE("bem: numbers that make no body are refused by name", "[process]") {
    for (const char* setting :
         {"youngs_modulus=0", "youngs_modulus=-1", "youngs_modulus=nan", "poisson_ratio=0.5", "poisson_ratio=0.6",
          "poisson_ratio=-1", "hole_a=0", "hole_a=-1", "hole_b=nan", "elements=0", "elements=2.5", "elements=2000",
          "remote_stress=inf", "pressure=nan", "element=cubic", "scene=sphere", "point_x=nan"}) {
        const Outcome outcome = call(with(bem_run, {setting}));
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, std::string(setting).substr(0, std::string(setting).find('='))));
    }
    for (const Arguments& settings :
         {Arguments{"scene=ring", "inner_radius=2", "outer_radius=1"}, Arguments{"scene=plate_with_hole", "hole_a=5"},
          Arguments{"scene=cavity_3d", "elements=2000"}, Arguments{"scene=outline", "held_side=3", "loaded_side=3"},
          Arguments{"scene=outline", "corner2_x=0", "corner2_y=-1"}, Arguments{"scene=outline", "corner3_y=3"}}) {
        const Outcome outcome = call(with(bem_run, settings));
        INFO(settings.back() << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
    }
}

TEST_CASE("bem: what is extreme and sound stays finite", "[process]") {
    for (const Arguments& settings :
         {Arguments{"poisson_ratio=0.4999"}, Arguments{"poisson_ratio=-0.9"}, Arguments{"poisson_ratio=0", "plane=stress"},
          Arguments{"elements=3"}, Arguments{"remote_stress=0"}, Arguments{"hole_a=1e-6", "hole_b=1e-6"},
          Arguments{"hole_a=1e6", "hole_b=1e6"}, Arguments{"hole_b=0.01"}, Arguments{"point_x=1", "point_y=0"},
          Arguments{"point_x=1.000000001", "point_y=0"}, Arguments{"point_x=1e7"}, Arguments{"element=constant", "elements=3"},
          Arguments{"scene=ring", "pressure=1e9", "outer_radius=1.01"}, Arguments{"scene=outline", "load_y=0"},
          Arguments{"scene=outline", "elements=5"}, Arguments{"scene=cavity_3d", "elements=20", "pressure=1"}}) {
        const Json result = json_of(with(bem_run, settings));
        INFO(settings.front() << " " << settings.back());
        CHECK(std::isfinite(value(result, "largest_displacement")));
    }
}
