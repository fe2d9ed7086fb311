// Boundary elements: Kirsch's and Inglis' hole, Lamé's ring, a pressed hole and cavity, orders, invariance, and what is refused.
#include "readings.h"

#include <pliant/run/runner.h>
#include <pliant/text/format.h>

#include "why_checks.h"

#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner solved(Runner::Assignments assignments, bool inside = false) {
    assignments.emplace_back("inside", inside ? "on" : "off");
    Runner runner(find_lesson("mesh/bem"), assignments);
    runner.step();
    return runner;
}
const Runner::Assignments kirsch{{"youngs_modulus", "1e4"}, {"elements", "64"}};

}  // namespace

TEST_CASE("bem: Kirsch's hole has three times the stress beside it, and moves as it should", "[bem]") {
    const Runner strain = solved(kirsch);
    CHECK_THAT(value(strain, "stress_at_a"), WithinRel(3, 2e-3));
    CHECK_THAT(value(strain, "stress_at_b"), WithinRel(-1, 5e-3));
    CHECK_THAT(value(strain, "u_y_at_b"), WithinRel(2.73e-4, 1e-4));
    CHECK_THAT(value(strain, "u_x_at_a"), WithinRel(-9.1e-5, 1e-3));
    CHECK_THAT(exact(strain, "u_y_at_b"), WithinRel(2.73e-4, 1e-12));
    Runner::Assignments thin = kirsch;
    thin.emplace_back("plane", "stress");
    CHECK_THAT(value(solved(thin), "u_y_at_b"), WithinRel(3e-4, 1e-4));
    CHECK_THAT(exact(solved(thin), "u_x_at_a"), WithinRel(-1e-4, 1e-12));
}

TEST_CASE("bem: an elliptic hole has 1 + 2a/b times the stress", "[bem]") {
    const Runner slit = solved({{"hole_b", "0.25"}, {"elements", "64"}});
    CHECK_THAT(value(slit, "stress_concentration"), WithinRel(9, 0.01));
    CHECK_THAT(exact(slit, "stress_at_a"), WithinAbs(9, 1e-12));
    CHECK(value(slit, "error") < 1e-3);
}

TEST_CASE("bem: a plate twenty times as wide as its hole has 3.02 times the stress", "[bem]") {
    const Runner plate = solved({{"scene", "plate_with_hole"}, {"half_width", "20"}, {"half_height", "20"}, {"elements", "32"}});
    CHECK_THAT(value(plate, "stress_at_a"), WithinAbs(3.021, 0.02));
    CHECK(!plate.lesson().probe("stress_at_a").exact(0));
}

TEST_CASE("bem: Lamé's ring", "[bem]") {
    const Runner ring = solved({{"scene", "ring"}, {"pressure", "1e6"}, {"youngs_modulus", "2e11"}, {"elements", "48"}});
    CHECK_THAT(value(ring, "hoop_inner"), WithinRel(1.6666667e6, 1e-3));
    CHECK_THAT(value(ring, "hoop_outer"), WithinRel(6.6666667e5, 1e-3));
    CHECK_THAT(value(ring, "u_inner"), WithinRel(9.5333333e-6, 1e-4));
    CHECK_THAT(value(ring, "u_outer"), WithinRel(6.0666667e-6, 1e-4));
    CHECK_THAT(exact(ring, "u_inner"), WithinRel(9.5333333e-6, 1e-7));
    CHECK(value(ring, "error") < 1e-4);
}

TEST_CASE("bem: a pressed hole widens by p a/(2 G), whatever the bulk modulus", "[bem]") {
    // G = 1 Pa each time.
    for (const Real nu : {0.0, 0.3, 0.49}) {
        const Runner hole = solved({{"remote_stress", "0"},
                                    {"pressure", "1"},
                                    {"elements", "32"},
                                    {"poisson_ratio", format_exact(nu)},
                                    {"youngs_modulus", format_exact(2 * (1 + nu))}});
        CHECK_THAT(value(hole, "u_x_at_a"), WithinRel(0.5, 2e-4));
        CHECK_THAT(value(hole, "u_y_at_b"), WithinRel(0.5, 2e-4));
    }
}

TEST_CASE("bem: a cavity widens by p a/(4 G)", "[bem]") {
    const Runner cavity = solved({{"scene", "cavity_3d"}, {"pressure", "1"}, {"youngs_modulus", "2.6"}, {"elements", "320"}});
    CHECK_THAT(value(cavity, "u_inner"), WithinRel(0.25, 0.014));
    CHECK_THAT(exact(cavity, "u_inner"), WithinRel(0.25, 1e-12));
    CHECK_THAT(value(cavity, "hoop_inner"), WithinRel(0.5, 0.03));
}

TEST_CASE("bem: errors fall with the order of the elements", "[bem]") {
    for (const auto& [element, order] : {std::pair{"constant", 1.0}, {"linear", 2.0}, {"quadratic", 3.0}}) {
        const auto error = [element = element](const char* n) {
            return value(solved({{"element", element}, {"elements", n}}), "error");
        };
        INFO(element << ": " << error("16") << ", " << error("32"));
        CHECK(std::log2(error("16") / error("32")) > order - 0.2);
    }
}

TEST_CASE("bem: the answer does not depend on units", "[bem]") {
    const auto answer = [](Real length, Real stress) {
        const Runner run = solved({{"hole_a", format_exact(length)},
                                   {"hole_b", format_exact(0.5 * length)},
                                   {"remote_stress", format_exact(stress)},
                                   {"youngs_modulus", format_exact(100 * stress)}});
        return Vec<2>(value(run, "stress_at_a") / stress, value(run, "u_y_at_b") / length);
    };
    const Vec<2> plain = answer(1, 1);
    for (const auto& [length, stress] : {std::pair{1e-5, 1.0}, {1e5, 1.0}, {1.0, 1e9}, {1.0, 1e-6}})
        CHECK((answer(length, stress) - plain).norm() < 1e-9 * plain.norm());
}

TEST_CASE("bem: points inside go with Kirsch's solution, and the point that is asked about is one of them", "[bem]") {
    const Runner run = solved({{"point_x", "2"}, {"point_y", "0"}, {"elements", "32"}}, true);
    CHECK_THAT(value(run, "point_stress_yy"), WithinRel(1 + 0.5 / 4 + 1.5 / 16, 2e-3));
    CHECK_THAT(value(run, "point_stress_xy"), WithinAbs(0, 1e-6));
    // Within the hole there is nothing to ask about.
    const Runner in_hole = solved({{"point_x", "0.2"}, {"point_y", "0"}}, true);
    CHECK(!in_hole.value(in_hole.lesson().probe("point_stress_yy")));
    // Near the wall it is finite, with a warning.
    const Runner near = solved({{"point_x", "1.001"}, {"point_y", "0"}}, true);
    CHECK(std::isfinite(value(near, "point_stress_yy")));
    CHECK(!holds(assumption(near, "point off the boundary")));
}

TEST_CASE("bem: the arm is in balance, and what holds it takes the load", "[bem]") {
    const Runner coarse = solved({{"scene", "outline"}, {"elements", "20"}}),
                 fine = solved({{"scene", "outline"}, {"elements", "80"}});
    INFO(value(coarse, "unbalanced") << " " << value(fine, "unbalanced"));
    CHECK(value(fine, "unbalanced") < value(coarse, "unbalanced"));
    CHECK(value(fine, "unbalanced") < 0.01);
    CHECK_THAT(value(coarse, "largest_displacement"), WithinRel(value(fine, "largest_displacement"), 0.05));
}

TEST_CASE("bem: a ring needs more triangles than boundary elements", "[bem]") {
    const Runner ring = solved({{"scene", "ring"}, {"pressure", "1"}, {"element", "linear"}, {"elements", "32"}});
    CHECK(value(ring, "unknowns") == 128);
    CHECK(value(ring, "matrix_entries") == 128 * 128);
    CHECK(value(ring, "finite_element_unknowns") > 2 * 128);
}

TEST_CASE("bem: outlines and numbers that make no body are refused, with what to do", "[bem]") {
    const Runner::Assignments outline{{"scene", "outline"}, {"corners", "4"}, {"held_side", "4"}, {"loaded_side", "2"}};
    const auto with_corners = [&](std::array<const char*, 8> xy) {
        Runner::Assignments all = outline;
        for (std::size_t k = 0; k < 4; ++k) {
            all.emplace_back("corner" + std::to_string(k + 1) + "_x", xy[2 * k]);
            all.emplace_back("corner" + std::to_string(k + 1) + "_y", xy[2 * k + 1]);
        }
        return all;
    };
    CHECK_NOTHROW(solved(with_corners({"0", "0", "1", "0", "1", "1", "0", "1"})));
    CHECK_THROWS_WITH(solved(with_corners({"0", "0", "0", "1", "1", "1", "1", "0"})),
                      ContainsSubstring("draw the outline anticlockwise"));
    CHECK_THROWS_WITH(solved(with_corners({"0", "0", "2", "0", "0", "1", "2", "1.5"})), ContainsSubstring("cross each other"));
    CHECK_THROWS_WITH(solved(with_corners({"0", "0", "1", "0", "1", "0", "0", "1"})), ContainsSubstring("no length"));
    CHECK_THROWS_WITH(solved({{"scene", "ring"}, {"outer_radius", "1"}}), ContainsSubstring("outer_radius"));
    CHECK_THROWS_WITH(solved({{"scene", "plate_with_hole"}, {"hole_a", "3"}}), ContainsSubstring("does not fit"));
    CHECK_THROWS_WITH(solved({{"elements", "2000"}}), ContainsSubstring("elements = 2000") && ContainsSubstring("unknowns"));
    CHECK_THROWS_WITH(solved({{"scene", "outline"}, {"held_side", "3"}}), ContainsSubstring("held or loaded"));
    CHECK_THROWS_WITH(solved({{"scene", "outline"}, {"loaded_side", "8"}}), ContainsSubstring("5 sides"));
}

TEST_CASE("bem: fixes mend", "[bem]") {
    for (const auto& [name, parameters] :
         {std::pair{"enough elements", Runner::Assignments{{"element", "constant"}, {"elements", "24"}}},
          {"small displacements", {{"youngs_modulus", "10"}}},
          {"point off the boundary", {{"point_x", "1.015"}, {"point_y", "0"}}}}) {
        INFO(name);
        Runner runner = solved(parameters, true);
        const Assumption& checked = assumption(runner, name);
        REQUIRE(!holds(checked));
        const auto fix = checked.fix();
        REQUIRE(fix);
        runner.assign(Runner::Assignments(fix->assign.begin(), fix->assign.end()));
        runner.step();
        CHECK(holds(checked));
    }
}
