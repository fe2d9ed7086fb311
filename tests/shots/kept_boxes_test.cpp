// What has been typeset is kept from frame to frame.
#include "app/lab.h"
#include "unseen.h"

#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::viewer;

TEST_CASE("the same text in the same size and width is laid out once, and others push it out in the end", "[session][typeset]") {
    const auto context = test::open_unseen({1280, 720});
    Lab lab(*context);
    lab.frame(0);
    const MathType& type = lab.state().fonts.mathematics;
    const MathBox* const kept = &type.sentence("an edge L and ε = ½", 15, 100);
    CHECK(kept == &type.sentence("an edge L and ε = ½", 15, 100));
    CHECK(kept != &type.sentence("an edge L and ε = ½", 15, 200));
    CHECK(kept != &type.formula("an edge L and ε = ½", 15, 100));
    const MathBox before = *kept;
    for (int k = 0; k < 500; ++k) type.label(fmt::format("k = {} N/m", k), 15);
    CHECK(kept == &type.sentence("an edge L and ε = ½", 15, 100));
    for (int k = 0; k < 2000; ++k) type.label(fmt::format("k = {} N/m", k), 15);
    const MathBox& again = type.sentence("an edge L and ε = ½", 15, 100);
    CHECK(again.letters.size() == before.letters.size());
    CHECK(again.width == before.width);
}

TEST_CASE("what is asked for in every frame stays the box that it is", "[session][typeset]") {
    const auto context = test::open_unseen({1280, 720});
    Lab lab(*context);
    for (int k = 0; k < 3; ++k) lab.frame(0), context->present();
    const MathType& type = lab.state().fonts.mathematics;
    const MathBox* const kept = &type.formula("F = R S", 20);
    for (int k = 0; k < 3; ++k) {
        for (int n = 0; n < 400; ++n) type.label(fmt::format("t = {} s", 400 * k + n), 15);
        CHECK(kept == &type.formula("F = R S", 20));
    }
}
