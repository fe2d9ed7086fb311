// Handles of a static lesson in the lab: what is dragged sets parameters, as a slider would, and is answered at once.
#include "parameters.h"
#include "session/session.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::WithinAbs;

namespace {

Real probe(const Session& s, std::string_view name) { return *s.runner().value(s.lesson().probe(name)); }

}  // namespace

TEST_CASE("a material point that is dragged sets its coordinates, within what the sliders span", "[session]") {
    Session s("elasticity/deformation_gradient");
    s.step();
    const Vec<3> Q(wanted(s, "Q_x"), wanted(s, "Q_y"), wanted(s, "Q_z"));
    const Real before = probe(s, "taylor_error");
    s.pull(Pull{1, Q, {-0.1, 0.05, 0.1}});
    CHECK(s.lesson().at_rest());
    CHECK(probe(s, "taylor_error") < before);
    s.pull(Pull{1, Q, {-0.2, -0.05, 7}});
    CHECK_THAT(wanted(s, "Q_x"), WithinAbs(-0.2, 1e-15));
    CHECK_THAT(wanted(s, "Q_z"), WithinAbs(0.2, 1e-15));  // the body's surface
    CHECK_FALSE(s.runner().pulled());
    s.pull(std::nullopt);
    // One drag is one step of undo.
    s.undo();
    CHECK_THAT(wanted(s, "Q_x"), WithinAbs(Q[0], 1e-15));
    CHECK_THAT(wanted(s, "Q_z"), WithinAbs(Q[2], 1e-15));
}

TEST_CASE("the head of v turns about the middle of its circle", "[session]") {
    Session s("elasticity/strain_measures");
    s.step();
    s.pull(Pull{0, {0.9, 0.5, 0}, {0, 0.4, 0}});
    CHECK_THAT(wanted(s, "v_angle"), WithinAbs(90, 1e-9));
    CHECK(s.lesson().at_rest());
    CHECK_THAT(probe(s, "stretch_of_v"), WithinAbs(std::sqrt(0.9), 1e-12));  // √C₂₂
    s.pull(std::nullopt);
    // Looking is nothing to be undone.
    CHECK_FALSE(s.can_undo());
}

TEST_CASE("the cell of the diffusion stencil follows the hand, and the run goes on", "[session]") {
    Session s("fluids/diffusion");
    s.step();
    s.pull(Pull{0, {0.39, -0.29, 0}, {0.999, -0.29, 0}});
    CHECK(wanted(s, "cell_x") == 31);
    CHECK(s.runner().place().step == 1);
    s.pull(Pull{0, {0.39, -0.29, 0}, {0.51, 3, 0}});
    CHECK(wanted(s, "cell_x") == 16);
    CHECK(wanted(s, "cell_y") == 12);  // a row has no other
    s.pull(std::nullopt);
    s.step();
    CHECK(s.runner().place().step == 2);
    CHECK_FALSE(s.can_undo());
}

TEST_CASE("an arrow that is drawn is projected at once, and a click beside the handles moves nothing", "[session]") {
    Session s("fluids/projection");
    s.step();
    s.assign(s.lesson().parameter("field"), 6);  // drawn
    REQUIRE(s.lesson().at_rest());
    const Real before = probe(s, "kinetic_energy");
    // The head of the second arrow, handle 5, to twice its length.
    const Vec<3> base(wanted(s, "arrow2_x"), wanted(s, "arrow2_y"), 0), way(-0.18, 0.24, 0);
    s.pull(Pull{5, base + 0.5 * way, base + way});
    CHECK_THAT(wanted(s, "arrow2_u"), WithinAbs(-1.2, 1e-12));
    CHECK_THAT(wanted(s, "arrow2_v"), WithinAbs(1.6, 1e-12));
    CHECK(s.lesson().at_rest());
    CHECK(probe(s, "kinetic_energy") > before);
    s.pull(std::nullopt);
    // The large cell goes where its dot is dragged, to the edge and not beyond.
    s.pull(Pull{0, {0.34, 0.62, 0}, {1.4, 0.2, 0}});
    CHECK_THAT(wanted(s, "cell_x"), WithinAbs(1, 1e-15));
    CHECK_THAT(wanted(s, "cell_y"), WithinAbs(0.2, 1e-15));
    s.pull(std::nullopt);
    // What is undone is the arrow.
    s.undo();
    CHECK_THAT(wanted(s, "arrow2_u"), WithinAbs(-0.6, 1e-12));
    CHECK_THAT(wanted(s, "cell_x"), WithinAbs(1, 1e-15));
}

TEST_CASE("the cell of the projection is chosen inside a step, in both runs, and nothing starts again", "[session]") {
    Session s("fluids/projection");
    s.toggle_companion();
    s.step();
    s.step_stage();
    s.step_stage();
    const Place here = s.runner().place();
    REQUIRE(here.passes > 0);
    const int runs = s.run_count();
    s.pull(Pull{0, {0.34, 0.62, 0}, {0.9, 0.2, 0}});
    s.pull(std::nullopt);
    CHECK(s.runner().place() == here);
    CHECK(s.run_count() == runs);
    CHECK(wanted(s, "cell_x") == 0.9);
    CHECK(s.companion()->lesson().parameter("cell_x").value() == 0.9);
    s.assign(s.companion()->lesson().parameter("cell_y"), 0.7);
    CHECK(wanted(s, "cell_y") == 0.7);
    CHECK(s.runner().place() == here);
}

TEST_CASE("the cell whose way back is drawn follows the hand, and nothing starts again", "[session]") {
    Session s("fluids/advection");
    s.step();
    const Real peak = probe(s, "peak");
    s.pull(Pull{0, {0.35, 0.74, 0}, {0.26, 0.999, 0}});
    CHECK(wanted(s, "cell_x") == 16);
    CHECK(wanted(s, "cell_y") == 63);
    s.pull(Pull{0, {0.26, 0.999, 0}, {-3, 0.5, 0}});
    CHECK(wanted(s, "cell_x") == 0);
    CHECK(wanted(s, "cell_y") == 32);
    s.pull(std::nullopt);
    CHECK(s.runner().place().step == 1);
    CHECK(probe(s, "peak") == peak);
}
