// Samples of a plot as comma-separated values.
#include <catch2/catch_test_macros.hpp>

#include "plot/csv.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        REQUIRE(line.ends_with('\r'));
        line.pop_back();
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

TEST_CASE("The header names every column with its unit, and series with the same x share its column") {
    const std::vector<Real> t{0, 0.1}, copy = t, e{1, 2}, f{3, 4}, other{5};
    const std::vector<CsvSeries> series{{"kinetic", t, e}, {"total", copy, f}, {"probe", other, other}};
    const auto lines = lines_of(to_csv("time t", "s", "J", series));
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "time t [s],kinetic [J],total [J],time t [s],probe [J]");
    CHECK(lines[1] == "0,1,3,5,5");
    CHECK(lines[2] == "0.1,2,4,,");
}

TEST_CASE("Numbers read back exactly, and one that is not finite leaves its cell empty") {
    const Real third = 1.0 / 3, tiny = std::numeric_limits<Real>::denorm_min();
    const std::vector<Real> x{third, 1e300, tiny},
        y{std::numeric_limits<Real>::quiet_NaN(), -std::numeric_limits<Real>::infinity(), -0.1};
    const auto lines = lines_of(to_csv("x", "", "", std::vector<CsvSeries>{{"y", x, y}}));
    REQUIRE(lines.size() == 4);
    CHECK(lines[0] == "x,y");
    CHECK(std::strtod(lines[1].c_str(), nullptr) == third);
    CHECK(lines[1].ends_with(','));
    CHECK(std::strtod(lines[2].c_str(), nullptr) == 1e300);
    CHECK(std::strtod(lines[3].c_str(), nullptr) == tiny);
    CHECK(std::strtod(lines[3].c_str() + lines[3].find(',') + 1, nullptr) == -0.1);
}

TEST_CASE("Names with commas and quotation marks are quoted") {
    const std::vector<Real> x{1};
    const auto lines = lines_of(to_csv("a, b", "m", "", std::vector<CsvSeries>{{"the \"exact\" one", x, x}}));
    CHECK(lines[0] == "\"a, b [m]\",\"the \"\"exact\"\" one\"");
}

TEST_CASE("A grid gives one line per cell") {
    const std::vector<Real> xs{0.5, 1.5}, ys{10, 20}, values{1, 2, 3, std::numeric_limits<Real>::quiet_NaN()};
    const auto lines = lines_of(grid_to_csv("x [m]", "y [m]", "p [Pa]", xs, ys, values));
    REQUIRE(lines.size() == 5);
    CHECK(lines[0] == "x [m],y [m],p [Pa]");
    CHECK(lines[2] == "1.5,10,2");
    CHECK(lines[3] == "0.5,20,3");
    CHECK(lines[4] == "1.5,20,");
}
