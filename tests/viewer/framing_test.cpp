// Cameras that fill the picture with a scene and keep in it what moves.
#include "session/viewpoint.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Approx;

namespace {

// Where a point is in the picture, both from −1 to 1.
Eigen::Vector2f seen(const Camera& camera, int dimension, float aspect, const Position& p) {
    const Projection projection(camera, dimension, 1000 * aspect, 1000);
    const Eigen::Vector3f pixel = projection.pixel(p);
    REQUIRE(pixel.z() < 1);
    return {pixel.x() / (500 * aspect) - 1, pixel.y() / 500 - 1};
}

// The largest distance from the middle of the picture: 1 at an edge.
float outermost(const Camera& camera, int dimension, float aspect, const std::vector<Position>& points) {
    float most = 0;
    for (const Position& p : points) most = std::max(most, seen(camera, dimension, aspect, p).cwiseAbs().maxCoeff());
    return most;
}

std::vector<Position> corners(const Frame& f) {
    std::vector<Position> all;
    for (int i = 0; i < 8; ++i)
        all.push_back({(i & 1 ? f.upper : f.lower)[0], (i & 2 ? f.upper : f.lower)[1], (i & 4 ? f.upper : f.lower)[2]});
    return all;
}

// A block with its lower left corner at x.
std::vector<Position> block_at(float x, float size = 0.5f, float z = 0) {
    return corners({{x, 0, z}, {x + size, size, z + size}, 3});
}

const Frame stage_box{{-1, 0, -1}, {1, 1.5f, 1}, 3};

Sighting sighting(const std::vector<Position>& moving, Real seconds) {
    return {.frame = stage_box, .moving = moving, .aspect = 1.6f, .run = 1, .seconds = seconds};
}

}  // namespace

TEST_CASE("a framed scene fills the picture but for a margin, whatever the shape of either", "[framing]") {
    const int dimension = GENERATE(2, 3);
    const float aspect = GENERATE(0.4f, 1.f, 1.78f, 4.f);
    for (const Position& size :
         {Position{1, 1, 1}, Position{8, 1, 0.5f}, Position{0.01f, 2, 0.01f}, Position{3e-6f, 1e-6f, 2e-6f}}) {
        const Frame frame{{0, 0, 0}, {size[0], size[1], dimension == 2 ? 0 : size[2]}, dimension};
        CHECK(outermost(framing(frame, aspect), dimension, aspect, corners(frame)) == Approx(framed_part).epsilon(1e-3));
    }
}

TEST_CASE("a camera moves as little as it takes to keep points in sight", "[framing]") {
    const Camera framed = framing(stage_box, 1.6f);
    const Sight sight{1.6f, 0.95f, 100};
    CHECK(keeping_in_sight(framed, block_at(-0.25f), 3, sight) == framed);
    for (const float x : {3.f, -40.f, 1000.f}) {
        const auto block = block_at(x);
        const Camera moved = keeping_in_sight(framed, block, 3, sight);
        CAPTURE(x);
        CHECK(moved.distance == framed.distance);
        CHECK(moved.yaw == framed.yaw);
        CHECK(outermost(moved, 3, 1.6f, block) == Approx(0.95f).epsilon(1e-2));
    }
    // Towards the eye and away from it as well.
    for (const float z : {-30.f, 30.f}) {
        const auto block = block_at(0, 0.5f, z);
        const Camera moved = keeping_in_sight(framed, block, 3, sight);
        CHECK(outermost(moved, 3, 1.6f, block) <= 0.951f);
        CHECK(outermost(moved, 3, 1.6f, block) > 0.2f);
    }
}

TEST_CASE("what is too large is seen from farther away, up to a limit", "[framing]") {
    const Camera framed = framing(stage_box, 1.6f);
    const auto large = block_at(-4, 8);
    const Camera away = keeping_in_sight(framed, large, 3, {1.6f, 0.95f, 1000});
    CHECK(away.distance > framed.distance);
    CHECK(outermost(away, 3, 1.6f, large) == Approx(0.95f).epsilon(1e-2));
    CHECK(keeping_in_sight(framed, large, 3, {1.6f, 0.95f, 1.5 * framed.distance}).distance == 1.5 * framed.distance);
}

TEST_CASE("points without a place and pictures without points leave the camera alone", "[framing]") {
    const Camera framed = framing(stage_box, 1.6f);
    const float nowhere = std::numeric_limits<float>::quiet_NaN(), far = std::numeric_limits<float>::infinity();
    const std::vector<Position> points{{nowhere, 0, 0}, {0, far, 0}};
    CHECK(keeping_in_sight(framed, points, 3, {1.6f, 0.95f, 100}) == framed);
    CHECK(keeping_in_sight(framed, {}, 3, {1.6f, 0.95f, 100}) == framed);
}

TEST_CASE("the viewpoint follows smoothly, and what moves never leaves the picture", "[framing]") {
    Viewpoint viewpoint;
    viewpoint.look(sighting(block_at(0), 1.0 / 60));
    const Real distance = viewpoint.camera().distance;
    for (int frame = 0; frame < 600; ++frame) {
        const float x = 0.03f * static_cast<float>(frame);
        const Vec<3> before = viewpoint.camera().target;
        viewpoint.look(sighting(block_at(x), 1.0 / 60));
        CAPTURE(frame);
        REQUIRE(outermost(viewpoint.camera(), 3, 1.6f, block_at(x)) <= 0.991f);
        REQUIRE((viewpoint.camera().target - before).norm() < 0.05 * distance);
    }
    CHECK(viewpoint.moving());
    // It comes to rest with the body, and does not ask for pictures any longer.
    for (int frame = 0; frame < 300; ++frame) viewpoint.look(sighting(block_at(18), 1.0 / 60));
    CHECK_FALSE(viewpoint.moving());
    const Camera rest = viewpoint.camera();
    CHECK(viewpoint.look(sighting(block_at(18), 1.0 / 60)) == rest);
    // Without a clock the camera is where it belongs at once.
    Viewpoint still;
    CHECK(still.look(sighting(block_at(18), 0)) == rest);
}

TEST_CASE("another run is framed at once, and the way back is none", "[framing]") {
    Viewpoint viewpoint;
    Sighting s = sighting({}, 1.0 / 60);
    const auto far = block_at(18), near = block_at(0);
    s.moving = far;
    viewpoint.look(s);
    s.moving = near, s.run = 2;
    CHECK(viewpoint.look(s) == framing(stage_box, 1.6f));
    CHECK_FALSE(viewpoint.moving());
}

TEST_CASE("the viewpoint keeps the side from which the person looks, and stands still under a hand", "[framing]") {
    Viewpoint viewpoint;
    const auto near = block_at(0), far = block_at(18);
    viewpoint.look(sighting(near, 0));
    viewpoint.turn(100, -30);
    const Camera turned = viewpoint.camera();
    viewpoint.look(sighting(far, 0));
    CHECK(viewpoint.camera().yaw == turned.yaw);
    CHECK(viewpoint.camera().pitch == turned.pitch);
    CHECK(outermost(viewpoint.camera(), 3, 1.6f, far) <= 0.951f);

    Sighting held = sighting(far, 1.0 / 60);
    held.held = true;
    const Camera before = viewpoint.camera();
    CHECK(viewpoint.look(held) == before);
    held.frame.upper[1] = 9;  // a handle makes the scene larger
    CHECK(viewpoint.look(held) == before);
    // Once it is let go the camera goes to where all is seen, without a jump.
    held.held = false;
    CHECK((viewpoint.look(held).target - before.target).norm() < 0.2 * before.distance);
    CHECK(viewpoint.moving());

    viewpoint.turn_back();
    CHECK(viewpoint.look(sighting(near, 0)) == framing(stage_box, 1.6f));
}
