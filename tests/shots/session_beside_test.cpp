// A pinned run, and a second run beside the first, without a picture.
#include "render/ghost.h"
#include "session/session.h"
#include "walker.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;

namespace {

void assign_b(Session& s, std::string_view key, Real value) { s.assign(s.companion()->lesson().parameter(key), value); }
Real wanted_b(const Session& s, std::string_view key) {
    return s.companion()->runner().wanted(s.companion()->lesson().parameter(key));
}

// Less than one step of B behind, and never ahead.
void check_linked(const Session& s) {
    const Runner& b = s.companion()->runner();
    CHECK(b.time() <= s.runner().time() + 1e-12);
    CHECK(s.runner().time() - b.time() < b.time_step() + 1e-12);
    CHECK_FALSE(b.inside_step());
}

}  // namespace

TEST_CASE("a second run starts as a copy of the first", "[session]") {
    Session s = walking({{"speed", "3"}, {"time_step", "0.25"}});
    for (int i = 0; i < 4; ++i) s.step();
    s.toggle_companion();
    REQUIRE(s.companion());
    CHECK(wanted_b(s, "speed") == 3);
    CHECK(wanted_b(s, "time_step") == 0.25);
    CHECK(differing(s.runner(), s.companion()->runner()).empty());
    // A keeps its place, and B has come there.
    CHECK(s.runner().place().step == 4);
    CHECK(s.companion()->runner().place().step == 4);
    for (int i = 0; i < 4; ++i) s.step();
    CHECK(state_hash(s.lesson()) == state_hash(s.companion()->lesson()));
    s.toggle_companion();
    CHECK_FALSE(s.companion());
}

TEST_CASE("the clocks of two runs are linked whatever moves the first", "[session]") {
    for (const Real dt : {0.1, 0.25, 0.7, 0.03125}) {
        CAPTURE(dt);
        Session s = walking({{"time_step", "0.25"}});
        s.toggle_companion();
        assign_b(s, "time_step", dt);
        CHECK(s.runner().time_step() == 0.25);
        for (int i = 0; i < 8; ++i) s.step(), check_linked(s);
        s.step_stage();
        check_linked(s);
        for (int i = 0; i < 5; ++i) s.step_back(), check_linked(s);
        s.playing = true;
        for (int i = 0; i < 30; ++i) s.update(0.1, 1e9), check_linked(s);
        CHECK(s.companion()->runner().time() > 2);
        CHECK_THAT(s.companion()->recorder().series(0).at().back(), WithinAbs(s.companion()->runner().time(), 0));
        s.reset();
        check_linked(s);
        CHECK(s.companion()->runner().place() == Place{});
        CHECK(s.companion()->recorder().series(0).at().size() == 1);
    }
}

TEST_CASE("what if leaves A where it stands, and compares nothing before B has come there", "[session]") {
    Session s = walking({{"time_step", "0.25"}});
    for (int i = 0; i < 40; ++i) s.step();
    const std::uint64_t hash = state_hash(s.lesson());
    s.colours = {"x", -1};
    s.sliced = true;
    s.beside_to_now({{"time_step", "0.05"}});
    REQUIRE(s.companion());
    REQUIRE(s.catching_up());
    CHECK(*s.catching_up() == 0);
    CHECK(s.under_way());
    CHECK_FALSE(s.has_difference());
    Real before = 0;
    for (int i = 0; i < 1000 && s.catching_up(); ++i) {
        CHECK(s.runner().place().step == 40);
        CHECK(*s.catching_up() >= before);
        before = *s.catching_up();
        s.update(0, Budget::of_passes(7));
    }
    CHECK(before > 0.5);
    while (s.under_way()) s.update(0, Budget::of_passes(7));
    check_linked(s);
    CHECK(s.has_difference());
    CHECK(state_hash(s.lesson()) == hash);
    CHECK(s.recorder().series(0).at().size() == 41);
    CHECK(s.companion()->runner().place().step == 200);
}

TEST_CASE("what if of a run that was changed on its way runs both again side by side, and says so", "[session]") {
    Session s = walking({{"time_step", "0.25"}});
    for (int i = 0; i < 20; ++i) s.step();
    s.assign(s.lesson().parameter("speed"), 3);
    for (int i = 0; i < 20; ++i) s.step();
    s.sliced = true;
    s.beside_to_now({{"time_step", "0.125"}});
    REQUIRE(s.message());
    CHECK_THAT(s.message()->text, ContainsSubstring("run again from the start"));
    CHECK(s.runner().place() == Place{});
    for (int i = 0; i < 1000 && s.under_way(); ++i) {
        s.update(0, Budget::of_passes(3));
        CHECK_FALSE(s.catching_up());
        CHECK(std::abs(s.runner().time() - s.companion()->runner().time()) < 0.25 + 0.125 + 1e-12);
    }
    CHECK(s.runner().place().step == 40);
    check_linked(s);
}

TEST_CASE("a move back by the first restores the second to the bit", "[session]") {
    Session s = walking({{"time_step", "0.25"}});
    s.toggle_companion();
    assign_b(s, "time_step", 0.1);
    for (int i = 0; i < 3; ++i) s.step();
    const auto hash = state_hash(s.companion()->lesson());
    for (int i = 0; i < 4; ++i) s.step();
    CHECK(state_hash(s.companion()->lesson()) != hash);
    for (int i = 0; i < 4; ++i) s.step_back();
    CHECK(state_hash(s.companion()->lesson()) == hash);
}

TEST_CASE("what goes wrong stops the second run alone", "[session]") {
    Session s = walking({{"time_step", "0.25"}});
    s.toggle_companion();
    assign_b(s, "speed", 90);  // beyond 100 m after 1.11 s
    for (int i = 0; i < 4; ++i) s.step();
    CHECK(s.companion()->stopped().empty());
    for (int i = 0; i < 4; ++i) s.step();
    CHECK_THAT(s.companion()->stopped(), ContainsSubstring("walk"));
    CHECK_THAT(s.companion()->stopped(), ContainsSubstring("100"));
    CHECK_FALSE(s.message());
    CHECK(s.runner().time() == 2);
    CHECK(s.companion()->runner().time() == 1);
    // Back before it, it goes on; and so it does when it is mended.
    for (int i = 0; i < 5; ++i) s.step_back();
    CHECK(s.companion()->stopped().empty());
    check_linked(s);
    for (int i = 0; i < 5; ++i) s.step();
    CHECK_FALSE(s.companion()->stopped().empty());
    assign_b(s, "speed", 1);
    CHECK(s.companion()->stopped().empty());
    check_linked(s);
}

TEST_CASE("each run has sliders of its own, and one undo serves both", "[session]") {
    Session s = walking();
    s.toggle_companion();
    CHECK(&s.addressed() == &s.runner());
    s.address(true);
    CHECK(&s.addressed() == &s.companion()->runner());
    assign_b(s, "speed", 4);
    s.assign(s.lesson().parameter("speed"), 2);
    CHECK(s.runner().wanted(s.lesson().parameter("speed")) == 2);
    const auto differ = differing(s.runner(), s.companion()->runner());
    REQUIRE(differ.size() == 1);
    CHECK(differ[0].a == 2);
    CHECK(differ[0].b == 4);
    s.undo();
    CHECK(s.runner().wanted(s.lesson().parameter("speed")) == 1);
    CHECK(wanted_b(s, "speed") == 4);
    s.undo();
    CHECK(wanted_b(s, "speed") == 1);
    // Without the second run nothing of it is left to undo, and the sliders set the first.
    assign_b(s, "speed", 5);
    s.toggle_companion();
    CHECK_FALSE(s.can_undo());
    CHECK(&s.addressed() == &s.runner());
}

TEST_CASE("a change that rebuilds one of two runs starts both again", "[session]") {
    Session s = walking({{"time_step", "0.25"}});
    s.toggle_companion();
    for (int i = 0; i < 4; ++i) s.step();
    assign_b(s, "start", 0.5);
    CHECK(s.runner().place() == Place{});
    CHECK(s.companion()->runner().place() == Place{});
    CHECK(*s.companion()->lesson().probe("x").value() == 0.5);
    for (int i = 0; i < 4; ++i) s.step();
    s.assign(s.lesson().parameter("start"), 1);
    CHECK(s.companion()->runner().place() == Place{});
    // A refused change changes nothing.
    assign_b(s, "start", 7);
    REQUIRE(s.message());
    CHECK(wanted_b(s, "start") == 0.5);
}

TEST_CASE("a static lesson runs both to rest on Step", "[session]") {
    Session s("elasticity/moduli");
    s.open_companion({{"resolution", "2"}, {"load_levels", "3"}});
    s.step();
    CHECK(s.lesson().at_rest());
    CHECK(s.companion()->lesson().at_rest());
    s.step_back();
    CHECK_FALSE(s.companion()->lesson().at_rest());
}

TEST_CASE("two runs of other sizes have no difference; of one size, they have", "[session]") {
    Session s("fluids/navier_stokes");
    s.open_companion({{"resolution", "16"}});
    CHECK_FALSE(s.has_difference());
    s.show_difference(true);
    CHECK_FALSE(s.shows_difference());
    REQUIRE(s.message());
    s.close_companion();
    s.open_companion({{"viscosity", "0.01"}});
    for (int i = 0; i < 5; ++i) s.step();
    s.show_difference(true);
    REQUIRE(s.shows_difference());
    const Scene shown = s.scene();
    s.show_difference(false);
    const Scene a = s.scene(), b = s.picture_beside()->scene;
    REQUIRE(shown.grids[0].values.size() == a.grids[0].values.size());
    float largest = 0;
    for (std::size_t i = 0; i < a.grids[0].values.size(); ++i) {
        const float difference = a.grids[0].values[i] - b.grids[0].values[i];
        CHECK(std::abs(shown.grids[0].values[i] - difference) <= 1e-4f);
        largest = std::max(largest, std::abs(difference));
    }
    CHECK(largest > 1e-3f);
    // One range of colours serves both pictures.
    for (const Scene* scene : {&a, &b})
        for (const float v : scene->grids[0].values) {
            CHECK(v >= s.range.scale.min - 1e-6);
            CHECK(v <= s.range.scale.max + 1e-6);
        }
}

TEST_CASE("a second run is not made in a walkthrough, and ends with the lesson", "[session]") {
    Session s("mesh/mass_spring");
    s.start_walkthrough();
    s.toggle_companion();
    CHECK_FALSE(s.companion());
    REQUIRE(s.message());
    s.end_walkthrough();
    s.toggle_companion();
    CHECK(s.companion());
    s.open_next(1);
    CHECK_FALSE(s.companion());
}

TEST_CASE("a pinned run keeps its picture, numbers and settings", "[session]") {
    Session s = walking({{"speed", "2"}});
    for (int i = 0; i < 10; ++i) s.step();
    s.toggle_pin();
    REQUIRE(s.pinned());
    s.assign(s.lesson().parameter("speed"), 5);
    s.reset();
    CHECK(s.pinned()->recorder.series(0).at().size() == 11);
    CHECK(s.pinned()->settings[0] == 2);
    CHECK(s.pinned()->step == 10);
    REQUIRE(s.pinned()->ghost.points.size() == 1);
    CHECK_THAT(s.pinned()->ghost.points[0].at[0][0], WithinAbs(0.02, 1e-6));
    CHECK_FALSE(s.pinned()->ghost.points[0].pick.pickable);
    s.toggle_pin();
    CHECK_FALSE(s.pinned());
}

TEST_CASE("the ghost of a heat map is its contours", "[session]") {
    Scene scene;
    GridMarks g{.nx = 8, .ny = 8, .lower = {0, 0, 0}, .upper = {1, 1, 0}, .values = {}};
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i) g.values.push_back(static_cast<float>(i));
    scene.grids.push_back(g);
    const Scene ghost = ghost_of(scene);
    CHECK(ghost.grids.empty());
    const auto& ends = ghost.lines.at(0).ends;
    REQUIRE(ends.size() == 5 * 7 * 2);
    // Values grow with x alone: every contour is upright.
    for (std::size_t i = 0; i < ends.size(); i += 2) CHECK_THAT(ends[i][0] - ends[i + 1][0], WithinAbs(0, 1e-6));
}

TEST_CASE("the ghost of a body is its outline", "[session]") {
    Scene scene;
    // A square of two triangles: the diagonal is no outline.
    scene.triangles.push_back({.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}, {0, 2, 3}}});
    scene.lines.push_back({.ends = {{0, 0, 0}, {1, 1, 0}}, .ink = Ink::ground});
    const Scene ghost = ghost_of(scene);
    CHECK(ghost.triangles.empty());
    CHECK(ghost.lines.at(0).ends.size() == 4 * 2);
    CHECK(ghost.lines.at(1).ends.empty());
    CHECK(ghost.lines.at(0).ink == Ink::rest);
}
