// Probes that are what their formula gives.
#include <pliant/lesson/lesson.h>
#include <pliant/run/evaluation.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <limits>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

struct Masses : Lesson {
    Number mass{*this, quantity("mass", "m", "kg", 2, {1, 5}, "of each")};
    std::vector<Real> velocity{1, 2, 3, 4};  // two nodes in the plane
    Real clock = 3;

    Masses() {
        fields = {plane_vector_field("velocity", "v", "m/s", On::node, velocity, "")};
        probes = {probe_of("kinetic_energy", "K", "J", "")
                      .formula(*this, "K = ½ m Σ_n (v_x² + v_y²)",
                               {mass, Input::all_of("v_x", "velocity", 0), Input::all_of("v_y", "velocity", 1)}),
                  probe_of("power", "P", "W", "")
                      .formula(*this, "P = K / t",
                               {Input::now("K", "kinetic_energy", 0), Input::live("t", "s", "time", [this] { return clock; })}),
                  probe_of("first", "p", "kg m/s", "")
                      .formula(*this, "p = u m", {part("u = v_1", {Input::now("v_1", "velocity", 0, 1)}), mass}),
                  probe_of("beyond", "v", "m/s", "").formula(*this, "v = v_9", {Input::now("v_9", "velocity", 9)}),
                  probe_of("unknown", "v", "m/s", "").formula(*this, "v = w + v_1", {Input::now("v_1", "velocity", 0, 1)})};
    }
    int dimension() const override { return 2; }
    void reset() override {}
    Real time_step() const override { return 0; }
    void draw(Scene&) const override {}
};

}  // namespace

TEST_CASE("a probe's formula takes the numbers of now") {
    Masses l;
    CHECK(l.probe("kinetic_energy").value() == 30);
    CHECK(l.probe("power").value() == 10);
    CHECK(l.probe("first").value() == 4);
    l.mass.set(4);
    l.velocity[1] = 0;
    l.clock = 2;
    CHECK(l.probe("kinetic_energy").value() == 52);
    CHECK(l.probe("power").value() == 26);
    CHECK(l.probe("first").value() == 0);
    l.velocity = {1, 2};
    CHECK(l.probe("kinetic_energy").value() == 10);
    CHECK(l.probe("kinetic_energy").explain().inputs.size() == 3);
}

TEST_CASE("a probe's formula has no number where an input has none, nor where it is not finite") {
    Masses l;
    CHECK(!l.probe("beyond").value());
    l.clock = 0;
    CHECK(!l.probe("power").value());
    l.velocity[0] = std::numeric_limits<Real>::infinity();
    CHECK(!l.probe("kinetic_energy").value());
}

TEST_CASE("a probe's formula that cannot be read names its place in the sources") {
    Masses l;
    CHECK_THROWS_WITH(l.probe("unknown").value(),
                      ContainsSubstring("tests/unit/probe_formula_test.cpp:") && ContainsSubstring("no symbol 'w'"));
}
