// The same scene told in other units: metres or micrometres, seconds or minutes, kilograms or grams. A number in the code that
// has a unit and does not say so, such as an absolute tolerance, shows here.
#include "units.h"

#include "pliant.h"

#include <cmath>
#include <map>

using namespace pliant::test;

namespace {

struct UnitChange {
    std::string lesson;
    std::vector<std::string> settings;
    std::string steps;
    char base;      // 'm', 's' or 'k' for kg
    double factor;  // units of the new kind in one of the old: 1e6 turns metres into micrometres
};

void check_same_in_other_units(const UnitChange& c) {
    const Arguments run = with({"run", c.lesson, "--steps", c.steps}, c.settings);
    const Json parameters = parameters_of(c.lesson), here = json_of(run);
    std::vector<std::string> scaled = c.settings;
    for (const Json& p : parameters) {
        const int power = power_of(c.base, p["unit"]);
        if (p["kind"] != "number" || power == 0) continue;
        const double value = here["parameters"][p["key"].get<std::string>()].get<double>() * std::pow(c.factor, power);
        scaled.push_back(p["key"].get<std::string>() + "=" + exactly(value));
    }
    REQUIRE(scaled.size() > c.settings.size());
    const Json there = json_of(with({"run", c.lesson, "--steps", c.steps}, scaled));
    INFO(c.lesson << " with " << c.base << " × " << c.factor);
    // What is 0 but for rounding is small against other numbers of its unit, or, where there are none, against 1.
    std::map<std::string, double> largest;
    for (const auto& [name, probe] : here["probes"].items())
        if (!probe["value"].is_null()) {
            double& size = largest[probe["unit"]];
            size = std::max(size, std::abs(probe["value"].get<double>()));
        }
    for (const auto& [name, probe] : here["probes"].items()) {
        if (contains(name, "iterations")) continue;  // a pass more or less is a matter of rounding
        INFO(name);
        const Json& other = there["probes"][name]["value"];
        REQUIRE(other.is_null() == probe["value"].is_null());
        if (other.is_null()) continue;
        const std::string unit = probe["unit"];
        const double value = probe["value"], expected = other.get<double>() / std::pow(c.factor, power_of(c.base, unit));
        INFO(value << " and " << expected << " " << unit);
        CHECK(std::abs(value - expected) <= 1e-6 * std::abs(value) + 1e-9 * largest[unit] + 1e-12);
    }
}

}  // namespace

TEST_CASE("units are counted in powers of metre, second and kilogram", "[process]") {
    CHECK(power_of('m', "m") == 1);
    CHECK(power_of('m', "Pa") == -1);
    CHECK(power_of('s', "Pa") == -2);
    CHECK(power_of('k', "Pa") == 1);
    CHECK(power_of('s', "N s/m") == -1);
    CHECK(power_of('m', "N s/m") == 0);
    CHECK(power_of('m', "kg m²/s") == 2);
    CHECK(power_of('s', "kg m²/s") == -1);
    CHECK(power_of('m', "J/kg") == 2);
    CHECK(power_of('k', "J/kg") == 0);
    CHECK(power_of('s', "rad/s") == -1);
    CHECK(power_of('s', "1/s") == -1);
    CHECK(power_of('m', "") == 0);
    CHECK(power_of('m', "°") == 0);
    CHECK(power_of('k', "kg/m³") == 1);
    CHECK(power_of('m', "kg/m³") == -3);
}

TEST_CASE("the same scene in other units gives the same numbers", "[process]") {
    for (const char* test : {"test=tension", "test=shear", "test=pressure"})
        for (const auto& [base, factor] : {std::pair{'m', 1e6}, {'m', 1e-6}, {'k', 1e6}, {'k', 1e-6}, {'s', 1e5}, {'s', 1e-5}})
            check_same_in_other_units({"elasticity/moduli", {test, "resolution=2"}, "1", base, factor});
    for (const double factor : {1e5, 1e-5})
        for (const char* integrator : {"integrator=semi_implicit_euler", "integrator=implicit_euler"})
            for (const char base : {'m', 'k'})
                check_same_in_other_units({"mesh/mass_spring", {integrator, "scene=hang"}, "60", base, factor});
    for (const double factor : {1e2, 1e-2}) {
        check_same_in_other_units({"mesh/mass_spring", {"scene=hang"}, "60", 's', factor});
        // The stirrer and the vortices have a time of their own.
        for (const char* scene : {"scene=cavity", "scene=couette", "scene=karman", "scene=smoke"})
            for (const char base : {'m', 's'})
                check_same_in_other_units({"fluids/navier_stokes", {scene, "resolution=24"}, "8", base, factor});
    }
}
