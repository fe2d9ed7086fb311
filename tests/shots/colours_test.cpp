// One palette a field: from the first step to the last, and the bar says what there is to say.
#include "hand.h"
#include "session/session.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

TEST_CASE("the colours of a field that takes both signs diverge from its first step on", "[session]") {
    Session session("mesh/mass_spring");
    session.colours = {"tension", -1};
    session.view_changed();
    REQUIRE(session.lesson().field("tension").both_signs);
    for (int k = 0; k < 150; ++k) {
        CHECK(session.colour_scale().map == ColourMap::diverging);
        CHECK(session.colour_scale().min == -session.colour_scale().max);
        session.step();
    }
}

TEST_CASE("lengths keep the colours of one sign, components have those of two", "[session]") {
    Session session("fluids/navier_stokes");
    for (int k = 0; k < 3; ++k) session.step();
    for (const auto& [component, map] :
         {std::pair{-1, ColourMap::viridis}, {0, ColourMap::diverging}, {1, ColourMap::diverging}}) {
        session.colours = {"velocity", component};
        session.range = {};
        session.view_changed();
        CHECK(session.colour_scale().map == map);
    }
    session.colours = {"speed", -1};
    session.range = {};
    session.view_changed();
    CHECK(session.colour_scale().map == ColourMap::viridis);
    CHECK(session.colour_scale().min >= 0);
}

TEST_CASE("a range of rounding, or of numbers that no quantity has, is 0 everywhere", "[session]") {
    CHECK(scale_for({-2.69e-245, 1e-246}, true) == ColourScale{0, 0, ColourMap::diverging});
    CHECK(scale_for({0, 3e-101}, false) == ColourScale{0, 0, ColourMap::viridis});
    CHECK(scale_for({-1e-9, 2e-9}, true, 1e6).max == 0);
    CHECK(scale_for({-1e-9, 2e-9}, true).max == 2e-9);
    const ColourScale one = scale_for({1e5, 1e5 + 1e-10}, false);
    CHECK(one.min == one.max);
    CHECK(scale_for({1e5, 1e5 + 1e-3}, false).max > 1e5);
    // One number alone has the middle of its colours, in the picture of a grid too, also where 1 is nothing beside it.
    for (const Real number : {0.0, 1e30, -1e-30}) {
        const ColourScale scale{number, number, ColourMap::diverging};
        CHECK(scale.of(static_cast<float>(number)) == colour_at(ColourMap::diverging, 0.5));
        CHECK(scale.wide().first < number);
        CHECK(number < scale.wide().second);
    }
    // What has died away beside what it was; another quantity is measured by itself.
    ColourRange range;
    range.update({-1, 1}, true);
    range.update({-1e-14, 1e-14}, true);
    CHECK(range.scale.max == 0);
    range.forget_size();
    range.update({-1e-14, 1e-14}, true);
    CHECK(range.scale.max == 1e-14);
}

TEST_CASE("what no stage has computed yet is grey in the picture, which says which stage will", "[session]") {
    Hand hand("fluids/projection", {1280, 720}, Pixels::seen);
    Session& session = hand.lab.session();
    session.colours = {"pressure", -1};
    session.view_changed();
    const auto dashes = [&] {
        return std::ranges::any_of(session.scene().labels, [](const LabelMark& l) { return l.text == "—"; });
    };
    const auto greys = [&] {
        hand.lab.state().controls.clear();
        hand.frames(2);
        const Rectangle place = hand.place("scene");
        const Image image = hand.pixels();
        int count = 0;
        for (int y = static_cast<int>(place.y); y < static_cast<int>(place.y + place.height); ++y)
            for (int x = static_cast<int>(place.x); x < static_cast<int>(place.x + place.width); ++x) {
                const std::uint8_t* p = image.row(y).data() + 3 * x;
                count += p[0] == undefined_colour.r && p[1] == undefined_colour.g && p[2] == undefined_colour.b;
            }
        return count;
    };
    CHECK(session.scene().awaits("pressure"));
    CHECK_FALSE(session.scene().awaits("u_on_faces"));
    // The cell that is drawn large has no pressures of 0 either.
    CHECK(dashes());
    CHECK(greys() > 10000);
    CHECK(hand.lab.state().controls.contains("not computed yet"));
    session.step();
    CHECK_FALSE(session.scene().awaits("pressure"));
    CHECK_FALSE(dashes());
    CHECK(greys() < 1000);
    CHECK_FALSE(hand.lab.state().controls.contains("not computed yet"));
}
