// Why a parameter is greyed in the lab.
#include "session/usage.h"

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::viewer;

TEST_CASE("a greyed parameter tells what it is used with, and the reason follows the scene", "[lab]") {
    Runner runner(find_lesson("elasticity/energy_density"));
    UsageReasons usage;
    const auto reason = [&](const char* key) { return usage.reason(runner, runner.lesson().parameter(key)); };
    CHECK(reason("F11") == "Used when path is “any F”.");
    CHECK(reason("shear") == "Used when path is “shear”.");
    runner.assign({{"path", "shear"}});
    CHECK(reason("stretch") == "Used when path is “stretch, free across” or “stretch, held across” or “stretch on all sides”.");
    CHECK(reason("F11") == "Used when path is “any F”.");
    Runner cloth(find_lesson("mesh/cloth"), {{"nodes", "4"}});
    CHECK(usage.reason(cloth, cloth.lesson().parameter("gust")) == "Used when wind is above 0 m/s.");
    // What is wanted counts, though it takes effect with the next step.
    cloth.assign("air_drag", 0);
    CHECK(usage.reason(cloth, cloth.lesson().parameter("wind")) == "Used when air drag is above 0.");
    CHECK(usage.reason(cloth, cloth.lesson().parameter("gust")) == "Used when wind is above 0 m/s and air drag is above 0.");
}
