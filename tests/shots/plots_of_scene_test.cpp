// Which plots are shown first.
#include "app/lab.h"
#include "unseen.h"

#include <catch2/catch_test_macros.hpp>

#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;

TEST_CASE("the plots are those of the scene until a person chooses", "[lab]") {
    const auto context = test::open_unseen({1280, 720});
    Lab lab(*context, "elasticity/stress_strain");
    Session& s = lab.session();
    const auto plots_with = [&](Runner::Assignments scene) {
        s.open(s.entry(), std::move(scene));
        lab.frame(0);
        return lab.state().plots.chosen;
    };
    using Names = std::vector<std::string>;
    CHECK(plots_with({}) == Names{"stress_by_radius"});
    CHECK(plots_with({{"scene", "cut"}}) == Names{"mohr_circle", "normal_stress_by_angle"});

    lab.state().plots.picked = true;
    lab.state().plots.chosen = {"strain"};
    CHECK(plots_with({{"scene", "disc"}}) == Names{"strain"});

    // Another lesson has its own.
    s.open(find_lesson("elasticity/poisson"));
    lab.frame(0);
    CHECK(lab.state().plots.chosen.front() == "narrowing_over_lengthening");
}
