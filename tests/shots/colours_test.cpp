// One palette a field: from the first step to the last, and the bar says what there is to say.
#include "session/session.h"

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
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
