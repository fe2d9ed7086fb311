// Loaded bodies against force over area, change over length, and the force on a plane.
#include "readings.h"

#include <pliant/run/runner.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner loaded(Runner::Assignments parameters) {
    Runner runner(find_lesson("elasticity/stress_strain"), parameters);
    runner.step();
    return runner;
}

}  // namespace

TEST_CASE("a weight on a disc gives m g over its area on every mesh", "[stress_strain]") {
    const auto [resolution, nu] =
        GENERATE(table<const char*, const char*>({{"1", "0.3"}, {"2", "-0.7"}, {"3", "0.49"}, {"5", "0"}}));
    const Runner runner = loaded({{"mass", "123"},
                                  {"radius", "0.037"},
                                  {"length", "0.11"},
                                  {"youngs_modulus", "3.3e6"},
                                  {"resolution", resolution},
                                  {"poisson_ratio", nu}});
    const Real stress = 123 * 9.81 / (std::numbers::pi * 0.037 * 0.037);
    CHECK_THAT(value(runner, "stress"), WithinRel(stress, 1e-9));
    CHECK_THAT(value(runner, "mean_stress"), WithinRel(-stress, 1e-9));
    CHECK_THAT(value(runner, "area"), WithinRel(std::numbers::pi * 0.037 * 0.037, 1e-12));
    CHECK_THAT(value(runner, "strain"), WithinRel(-stress / 3.3e6, 1e-9));
    CHECK_THAT(value(runner, "transverse_strain"), WithinAbs(std::stod(nu) * stress / 3.3e6, 1e-12));
}

TEST_CASE("a rod that is pressed has the negative of the strain of one that is pulled", "[stress_strain]") {
    const Runner pulled = loaded({{"scene", "rod"}, {"force", "77"}}), pressed = loaded({{"scene", "rod"}, {"force", "-77"}}),
                 left = loaded({{"scene", "rod"}, {"force", "0"}});
    CHECK_THAT(value(pulled, "strain"), WithinRel(77 / 0.01 / 1e6, 1e-9));
    CHECK_THAT(value(pressed, "strain"), WithinRel(-value(pulled, "strain"), 1e-12));
    CHECK(value(left, "strain") == 0);
}

TEST_CASE("the force on a cut follows its normal, and the principal cuts bear no shear", "[stress_strain]") {
    const Real xx = 2.5e4, yy = -0.7e4, xy = 1.3e4;
    const Real theta = GENERATE(-90., -33., 0., 17., 45., 90.), a = theta * std::numbers::pi / 180;
    const Runner runner = loaded({{"scene", "cut"},
                                  {"sigma_xx", "2.5e4"},
                                  {"sigma_yy", "-0.7e4"},
                                  {"sigma_xy", "1.3e4"},
                                  {"angle", std::to_string(theta)}});
    const Real mean = (xx + yy) / 2, half = (xx - yy) / 2;
    CHECK_THAT(value(runner, "normal_stress"), WithinAbs(mean + half * std::cos(2 * a) + xy * std::sin(2 * a), 1e-6));
    CHECK_THAT(value(runner, "shear_stress"), WithinAbs(-half * std::sin(2 * a) + xy * std::cos(2 * a), 1e-6));
    CHECK_THAT(value(runner, "largest_normal_stress"), WithinRel(mean + std::hypot(half, xy), 1e-9));
    CHECK(std::abs(value(runner, "force_imbalance")) < 1e-9);
}

TEST_CASE("the principal stresses are those of cuts upright on the picture", "[stress_strain]") {
    // The cut along the picture bears no stress, which is more than either of these.
    const Runner runner = loaded({{"scene", "cut"}, {"sigma_xx", "-1e4"}, {"sigma_yy", "-3e4"}, {"sigma_xy", "0"}});
    CHECK_THAT(value(runner, "largest_normal_stress"), WithinAbs(-1e4, 1e-6));
    CHECK_THAT(value(runner, "smallest_normal_stress"), WithinAbs(-3e4, 1e-6));
    for (const std::string_view name : {"largest_normal_stress", "smallest_normal_stress"})
        CHECK_THAT(std::string(runner.lesson().probe(name).help), ContainsSubstring("upright on the picture"));
}

TEST_CASE("the handles set the load that puts them where they are dragged", "[stress_strain]") {
    const auto dragged = [](const Runner& r, Index which, const Vec<3>& to) {
        return r.lesson().dragged({.index = which, .from = Vec<3>::Zero(), .to = to});
    };
    const auto place = [](const Runner& r, Index which) {
        Scene picture;
        r.lesson().draw(picture);
        for (const PointMarks& p : picture.points)
            if (p.pick.pickable && p.pick.first == which) return Vec<3>(p.at[0][0], p.at[0][1], p.at[0][2]);
        return Vec<3>(0, 0, 0);
    };
    for (const Runner::Assignments& scene : {Runner::Assignments{{"scene", "disc"}, {"mass", "70"}},
                                             {{"scene", "rod"}, {"force", "-220"}},
                                             {{"scene", "rod"}, {"force", "130"}},
                                             {{"scene", "cut"}, {"angle", "-25"}}}) {
        const Runner runner = loaded(scene);
        const auto found = dragged(runner, 0, place(runner, 0));
        REQUIRE(found.size() == 1);
        CHECK(found[0].first == scene[1].first);
        CHECK_THAT(found[0].second, WithinRel(std::stod(scene[1].second), 1e-4));
    }
    const Runner disc = loaded({{"radius", "0.13"}});
    CHECK_THAT(dragged(disc, 1, place(disc, 1))[0].second, WithinRel(0.13, 1e-5));
}

// On the plane of the largest normal stress its arrow has four fifths of the length of the normal, whatever the stress is.
TEST_CASE("the force on a cut is drawn to the scale of the largest principal stress", "[stress_strain]") {
    const struct {
        const char *xx, *yy, *xy, *angle;
    } principal[] = {{"1e5", "0", "0", "0"},      {"-3e5", "1e5", "0", "0"}, {"0", "2e5", "0", "90"},
                     {"0", "0", "1e5", "45"},     {"0", "0", "1e5", "-45"},  {"1e5", "1e5", "4e5", "45"},
                     {"-1e5", "-1e5", "0", "30"}, {"3e5", "-1e5", "0", "0"}};
    for (const auto& [xx, yy, xy, angle] : principal) {
        INFO(xx << " " << yy << " " << xy << " at " << angle);
        const Runner runner = loaded({{"scene", "cut"}, {"sigma_xx", xx}, {"sigma_yy", yy}, {"sigma_xy", xy}, {"angle", angle}});
        Scene scene;
        runner.lesson().draw(scene);
        const auto length = [&](Ink ink) {
            const ArrowMarks& arrow = *std::ranges::find(scene.arrows, ink, &ArrowMarks::ink);
            const auto &a = arrow.from.front(), &b = arrow.to.front();
            return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        };
        CHECK_THAT(length(Ink::force) / length(Ink::text), WithinAbs(0.8, 1e-5));
    }
}
