// What a slide hides until its answer: sliders that are covered, plots without their names, curves of theory.
#include <pliant/lecture/lecture.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>

#include "lab_hand.h"
#include "panels/companion_panel.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <fmt/format.h>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

// A slide on the stretched cube that hides what is given.
Lecture hiding(const std::string& hidden) {
    return parse_lecture(fmt::format("# T\n## One\n```show\nlesson elasticity/poisson\nset axial_strain=0.4\n```\n```ask\nHow "
                                     "long?\n```\n```do\nrun rest\n```\n```hide\n{}\n```\n```controls\naxial_strain "
                                     "method\n```\n",
                                     hidden),
                         "l.md");
}

}  // namespace

TEST_CASE("a slider that would give the answer away is covered until Next", "[hide]") {
    LabHand lab("elasticity/poisson");
    lab.session().open_lecture(hiding("axial_strain"));
    for (const Layout layout : {Layout::deck, Layout::lab}) {
        lab.state().layout = layout;
        lab.session().reset_slide();
        lab.frames(4);
        REQUIRE(lab.session().hides("axial_strain"));
        REQUIRE_FALSE(lab.session().hides("method"));
        lab.click("axial_strain", 0.9f);
        lab.frames(3);
        CHECK(lab.value("axial_strain") == 0.4);
        // Typed or undone, it is refused in words.
        lab.session().assign(lab.session().lesson().parameter("axial_strain"), 0.2);
        CHECK(lab.value("axial_strain") == 0.4);
        CHECK_THAT(lab.told(), ContainsSubstring("shown after Next"));
        lab.session().walkthrough_next();
        lab.frames(4);
        lab.click("axial_strain", 0.9f);
        lab.frames(3);
        CHECK(lab.value("axial_strain") > 0.4);
    }
}

TEST_CASE("a slide that hides titles names neither its plots nor what sets two runs apart", "[hide]") {
    LabHand lab("elasticity/poisson");
    lab.session().open_lecture(hiding("titles legends theory lights"));
    lab.frames(4);
    lab.session().toggle_companion();
    lab.session().address(true);
    lab.session().assign(lab.session().companion()->lesson().parameter("axial_strain"), 0.2);
    lab.frames(3);
    CHECK(run_name(lab.session(), true) == "B");
    lab.session().walkthrough_next();
    lab.frames(3);
    CHECK_THAT(run_name(lab.session(), true), ContainsSubstring("0.2"));
}

TEST_CASE("a slide that hides a field shows no number of it", "[hide]") {
    LabHand lab("elasticity/poisson");
    lab.session().open_lecture(hiding("displacement"));
    lab.frames(4);
    CHECK(lab.session().hides("displacement"));
    lab.session().walkthrough_next();
    CHECK_FALSE(lab.session().hides("displacement"));
}

TEST_CASE("a claim on a slide shows what the lectures say with its answer", "[hide]") {
    LabHand lab("elasticity/deformation_gradient");
    lab.session().open_lecture(parse_lecture("# T\n## One\n```show\nclaim E8\n```\n", "l.md"));
    lab.state().layout = Layout::deck;
    lab.frames(4);
    REQUIRE(lab.state().controls.contains("claim answer 0"));
    CHECK_FALSE(lab.state().controls.contains("claim statement"));
    lab.state().claims.book.measure_now(find_claim("E8"));
    lab.frames(3);
    CHECK(lab.state().controls.contains("claim statement"));
}
