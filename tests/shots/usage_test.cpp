// Why a parameter is greyed in the lab.
#include "session/usage.h"

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::viewer;

TEST_CASE("a greyed parameter tells what it is used with, and the reason follows the scene", "[lab]") {
    Runner runner(find_lesson("elasticity/energy_density"));
    UsageReasons usage;
    const auto reason = [&](const char* key) { return usage.reason(runner, runner.lesson().parameter(key)); };
    CHECK(reason("F11") == "Used with path=free.");
    CHECK(reason("shear") == "Used with path=shear.");
    runner.assign({{"path", "shear"}});
    CHECK(reason("stretch") == "Used with path=uniaxial, held or volumetric.");
    CHECK(reason("F11") == "Used with path=free.");
    Runner cloth(find_lesson("mesh/cloth"), {{"nodes", "4"}});
    CHECK(usage.reason(cloth, cloth.lesson().parameter("gust")) == "Used with wind above 0.");
    // What is wanted counts, though it takes effect with the next step.
    cloth.assign("air_drag", 0);
    CHECK(usage.reason(cloth, cloth.lesson().parameter("wind")) == "Used with air_drag above 0.");
    CHECK(usage.reason(cloth, cloth.lesson().parameter("gust")) == "Used with wind above 0 and air_drag above 0.");
}
