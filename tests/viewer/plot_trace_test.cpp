// Curves as pixels.
#include "special_numbers.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include "plot/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// An area of 400 x 100 px that shows x from 0 to 4 and y from 0 to 1, growing upward.
const AxisMap x_map({0, 4}, AxisScale::linear, 0, 400), y_map({0, 1}, AxisScale::linear, 100, 0);

Runs traced(const std::vector<Real>& xs, const std::vector<Real>& ys, const AxisMap& x = x_map, const AxisMap& y = y_map) {
    Runs runs;
    trace(xs, ys, x, y, 0, runs);
    return runs;
}

bool finite(const Runs& runs) {
    return std::ranges::all_of(runs.points, [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

float length(const Runs& runs) {
    float sum = 0;
    for (std::size_t i = 0; i < runs.count(); ++i) {
        const auto run = runs.run(i);
        for (std::size_t k = 1; k < run.size(); ++k) sum += std::hypot(run[k].x - run[k - 1].x, run[k].y - run[k - 1].y);
    }
    return sum;
}

}  // namespace

TEST_CASE("A short curve keeps every sample") {
    const Runs runs = traced({0, 1, 2}, {0, 1, 0.5});
    REQUIRE(runs.count() == 1);
    CHECK(runs.points == std::vector<Point>{{0, 100}, {100, 0}, {200, 50}});
}

TEST_CASE("What is not finite leaves a gap, and a sample between two gaps stands alone") {
    const Runs runs = traced({0, 1, 1.5, 2, not_a_number, 3, 4}, {0.1, 0.2, not_a_number, 0.4, 0.5, infinity, 0.5});
    REQUIRE(runs.count() == 3);
    CHECK(runs.run(0).size() == 2);
    CHECK(runs.run(1).size() == 1);
    CHECK(runs.run(2).size() == 1);
    CHECK(finite(runs));
}

TEST_CASE("A log axis leaves out zero and negative values") {
    const AxisMap log({1e-3, 1}, AxisScale::log, 100, 0);
    const Runs runs = traced({0, 1, 2, 3, 4}, {0.1, 0, 0.01, 0.001, -1}, x_map, log);
    REQUIRE(runs.count() == 2);
    CHECK(runs.run(1)[0].y == Catch::Approx(200.0 / 3).margin(1e-3));
    CHECK(runs.run(1)[1].y == Catch::Approx(100).margin(1e-3));
}

TEST_CASE("Lines are cut at the edges, with their slope") {
    // From below to far above: enters at the bottom and leaves at the top.
    const Runs runs = traced({0, 4}, {-1, 3});
    REQUIRE(runs.count() == 1);
    CHECK(runs.points[0].x == Catch::Approx(100));
    CHECK(runs.points[0].y == Catch::Approx(100));
    CHECK(runs.points[1].x == Catch::Approx(200));
    CHECK(runs.points[1].y == Catch::Approx(0).margin(1e-3));
    CHECK(traced({0, 4}, {2, 3}).points.empty());
    // Samples on either side of the picture.
    CHECK(length(traced({-10, 10}, {0.5, 0.5})) == Catch::Approx(400));
    const Runs huge = traced({0, 2, 4}, {-1e300, 1e300, -1e300});
    CHECK(finite(huge));
    CHECK(huge.count() == 2);
}

TEST_CASE("A million samples become a few per pixel column and keep every peak") {
    const std::size_t count = 1000000;
    std::vector<Real> xs(count), ys(count);
    for (std::size_t i = 0; i < count; ++i) {
        xs[i] = 4.0 * static_cast<Real>(i) / static_cast<Real>(count);
        ys[i] = 0.5 + 0.1 * std::sin(0.7 * static_cast<Real>(i));
    }
    ys[123456] = 0.95;
    ys[765432] = 0.05;
    const Runs runs = traced(xs, ys);
    CHECK(runs.count() == 1);
    CHECK(runs.points.size() <= 2 * 402);
    CHECK(runs.points.size() >= 2 * 398);
    const auto [top, bottom] = std::ranges::minmax(runs.points, {}, &Point::y);
    CHECK(top.y == Catch::Approx(5));
    CHECK(top.x == Catch::Approx(49.38).margin(0.5));
    CHECK(bottom.y == Catch::Approx(95));
    CHECK(bottom.x == Catch::Approx(306.17).margin(0.5));
}

TEST_CASE("Among a million samples a gap stays a gap") {
    const std::size_t count = 1000000;
    std::vector<Real> xs(count), ys(count, 0.5);
    for (std::size_t i = 0; i < count; ++i) xs[i] = 4.0 * static_cast<Real>(i) / static_cast<Real>(count);
    std::fill(ys.begin() + 250000, ys.begin() + 500000, not_a_number);
    const Runs runs = traced(xs, ys);
    REQUIRE(runs.count() == 2);
    CHECK(runs.run(0).back().x == Catch::Approx(100).margin(1.5));
    CHECK(runs.run(1).front().x == Catch::Approx(200).margin(1.5));
    CHECK(length(runs) == Catch::Approx(300).margin(3));
}

TEST_CASE("A zoomed view of a million samples shows the same curve as its samples alone") {
    std::vector<Real> xs(200000), ys(200000);
    for (std::size_t i = 0; i < xs.size(); ++i) {
        xs[i] = 1e-3 * static_cast<Real>(i);
        ys[i] = 0.5 + 0.4 * std::sin(xs[i]);
    }
    const AxisMap zoomed({100, 100.2}, AxisScale::linear, 0, 400);
    const Runs all = traced(xs, ys, zoomed),
               part = traced({xs.begin() + 99990, xs.begin() + 100220}, {ys.begin() + 99990, ys.begin() + 100220}, zoomed);
    CHECK(all.points == part.points);
}

TEST_CASE("A curve that goes back in x is drawn whole") {
    std::vector<Real> xs, ys;
    for (int i = 0; i <= 100000; ++i) {
        const Real angle = 6.283185307179586 * i / 100000;
        xs.push_back(2 + std::cos(angle));
        ys.push_back(0.5 + 0.4 * std::sin(angle));
    }
    const Runs runs = traced(xs, ys);
    CHECK(runs.count() == 1);
    CHECK(runs.points.size() < 5000);
    // Ramanujan's approximation of the perimeter of an ellipse of half axes 100 and 40 px.
    CHECK(length(runs) == Catch::Approx(460.26).epsilon(0.01));
    CHECK(runs.points.front().x == Catch::Approx(runs.points.back().x).margin(0.3));
}

TEST_CASE("Points that cover each other are drawn once") {
    std::vector<Real> xs(10000, 2.0), ys(10000, 0.5);
    xs.push_back(3);
    ys.push_back(not_a_number);
    std::vector<Point> points;
    scatter(xs, ys, x_map, y_map, 2, points);
    CHECK(points == std::vector<Point>{{200, 50}});
    scatter(std::vector<Real>{-1, 5, 2}, std::vector<Real>{0.5, 0.5, 2}, x_map, y_map, 2, points);
    CHECK(points.empty());
}

TEST_CASE("Strokes and gaps follow their lengths around corners") {
    const Runs line{{{0, 0}, {30, 0}, {30, 70}}, {0}};
    const std::array<float, 2> pattern{6, 4};
    Runs strokes;
    dash(line, pattern, strokes);
    CHECK(strokes.count() == 10);
    CHECK(length(strokes) == Catch::Approx(60));
    for (std::size_t i = 0; i < strokes.count(); ++i) CHECK(strokes.run(i).size() >= 2);
}

TEST_CASE("Marks along a curve keep their distance") {
    Runs line{{}, {0}};
    for (int i = 0; i <= 400; ++i) line.points.push_back({static_cast<float>(i), 10});
    std::vector<Point> marks;
    spaced(line, 100, 30, false, marks);
    REQUIRE(marks.size() == 4);
    CHECK(marks[0].x == 30);
    CHECK(marks[3].x == 330);

    // A noisy curve has no more of them.
    for (std::size_t i = 0; i < line.points.size(); i += 2) line.points[i].y = 300;
    spaced(line, 100, 30, true, marks);
    CHECK(marks.size() == 4);
    spaced(line, 100, 30, false, marks);
    CHECK(marks.size() > 100);
}

TEST_CASE("The sample under the pointer is the closest one in pixels") {
    const std::vector<Real> xs{0, 1, 2, 3}, ys{0, 0.5, not_a_number, 0.5};
    CHECK(nearest_sample(xs, ys, x_map, y_map, {104, 52}, 20) == std::optional<std::size_t>(1));
    CHECK_FALSE(nearest_sample(xs, ys, x_map, y_map, {200, 50}, 20));
    CHECK_FALSE(nearest_sample({}, {}, x_map, y_map, {200, 50}, 20));
}

TEST_CASE("Pixels and values are inverse to each other") {
    for (const AxisMap& map : {x_map, y_map, AxisMap({1e-6, 10}, AxisScale::log, 50, 300)}) {
        for (const Real pixel : {0.0, 51.5, 99.0, 250.0}) CHECK(map.pixel(map.value(pixel)) == Catch::Approx(pixel).margin(1e-9));
    }
}
