// Words at the pointer keep out of the way of what they are about.
#include "plot/free_place.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <vector>

using namespace pliant::viewer;

namespace {

constexpr Box whole_room{{100, 50}, {900, 650}};
constexpr Point words_size{200, 120};

std::vector<Point> disc(Point middle, float radius) {
    std::vector<Point> points;
    for (float x = -radius; x <= radius; x += radius / 8)
        for (float y = -radius; y <= radius; y += radius / 8)
            if (x * x + y * y <= radius * radius) points.push_back({middle.x + x, middle.y + y});
    return points;
}

long covered(Point corner, const std::vector<Point>& points) {
    const Box words_box{corner, {corner.x + words_size.x, corner.y + words_size.y}};
    return std::ranges::count_if(points, [&](Point p) { return words_box.contains(p); });
}

}  // namespace

TEST_CASE("words at the pointer stay in the room and leave the pointer free", "[free_place]") {
    const float x = GENERATE(100.f, 300.f, 500.f, 899.f), y = GENERATE(50.f, 200.f, 400.f, 649.f);
    const Point at = free_place({x, y}, words_size, 20, whole_room, {});
    CAPTURE(x, y, at.x, at.y);
    CHECK(at.x >= whole_room.min.x);
    CHECK(at.y >= whole_room.min.y);
    CHECK(at.x + words_size.x <= whole_room.max.x);
    CHECK(at.y + words_size.y <= whole_room.max.y);
    CHECK_FALSE(Box{at, {at.x + words_size.x, at.y + words_size.y}}.contains({x, y}));
}

TEST_CASE("words about a part of a body stand beside the body where there is room", "[free_place]") {
    const Point middle{GENERATE(250.f, 500.f, 750.f), GENERATE(180.f, 350.f, 500.f)};
    const auto body = disc(middle, 100);
    for (const Point on : {Point{-60, 0}, Point{60, 0}, Point{0, -60}, Point{0, 60}, Point{0, 0}}) {
        const Point at = free_place({middle.x + on.x, middle.y + on.y}, words_size, 20, whole_room, body);
        CAPTURE(middle.x, middle.y, on.x, on.y);
        CHECK(covered(at, body) <= static_cast<long>(body.size() / 16));
    }
}

TEST_CASE("a room that is too small for the words still begins with them", "[free_place]") {
    const Box narrow{{10, 10}, {60, 40}};
    CHECK(free_place({30, 20}, words_size, 20, narrow, {}) == narrow.min);
}
