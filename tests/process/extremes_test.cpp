// Extremes that a person may ask for on the command line: materials at the ends of what is possible, long time steps. Each is
// refused with the name of the parameter, or gives finite numbers, or is reported with the limit that was exceeded.
#include "pliant.h"

#include <cmath>
#include <set>

using namespace pliant::test;

namespace {

const Json* parameter_named(const Json& parameters, const std::string& key) {
    for (const Json& p : parameters)
        if (p["key"] == key) return &p;
    return nullptr;
}

bool accepts(const Json& parameter, double value) {
    const Json& a = parameter["accepted"];
    const double low = a["min"], high = a["max"];
    return (a["open_min"] ? value > low : value >= low) && (a["open_max"] ? value < high : value <= high);
}

// No probe, and no assumption, is other than a number or undefined.
void check_run(const Outcome& outcome) {
    REQUIRE(outcome.exit_code == 0);
    const Json run = Json::parse(outcome.out);
    check_finite(run);
    for (const auto& [name, assumption] : run["assumptions"].items()) {
        INFO(name);
        CHECK_FALSE(assumption["value"].is_null());
    }
}

void check_run(const Arguments& arguments) {
    const Outcome outcome = call(arguments);
    INFO(sentence(arguments) << "\n" << outcome.err);
    check_run(outcome);
}

// Refused in one line that names the parameter and what is accepted.
void check_refused(const Arguments& arguments, const std::string& key) {
    const Outcome outcome = call(arguments);
    INFO(sentence(arguments) << "\n" << outcome.out << outcome.err);
    CHECK(outcome.exit_code == refused);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, key + " = "));
}

// Finite to the end, or reported, with a limit that has a number in it.
void check_finite_or_reported(const Arguments& arguments) {
    const Outcome outcome = call(arguments);
    INFO(sentence(arguments) << "\n" << outcome.err);
    if (outcome.exit_code == 0) return check_run(outcome);
    REQUIRE(outcome.exit_code == diverged);
    const Json failure = Json::parse(outcome.out)["failure"];
    for (const char* key : {"stage", "what", "limit"}) CHECK_FALSE(failure[key].get<std::string>().empty());
    CHECK(failure["limit"].get<std::string>().find_first_of("0123456789") != std::string::npos);
}

// Or refused, since two values do not go together: then the message names this parameter or another.
void check_finite_reported_or_refused(const Arguments& arguments) {
    const Outcome outcome = call(arguments);
    INFO(sentence(arguments) << "\n" << outcome.err);
    if (outcome.exit_code == 0) return check_run(outcome);
    REQUIRE((outcome.exit_code == refused || outcome.exit_code == diverged));
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(outcome.err.find_first_of("0123456789") != std::string::npos);
}

bool is_mass(const std::string& unit) { return unit == "kg" || unit == "kg/m³" || unit == "kg/m²"; }

std::vector<std::string> lessons_with(const std::string& key) {
    auto names = every_lesson();
    std::erase_if(names, [&](const std::string& lesson) { return !parameter_named(parameters_of(lesson), key); });
    return names;
}

double measured(const std::string& test, const std::string& nu) {
    const Json run = json_of(with({"run", "elasticity/moduli"},
                                  {"test=" + test, "poisson_ratio=" + nu, "youngs_modulus=1e6", "load=1e3", "resolution=2"}));
    return run["probes"]["measured_modulus"]["value"];
}

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)); }

}  // namespace

TEST_CASE("the parameters that these tests look for are those of some lesson", "[process]") {
    std::set<std::string> keys;
    bool any_mass = false;
    for (const std::string& lesson : lesson_names())
        for (const Json& p : parameters_of(lesson)) {
            keys.insert(p["key"]);
            any_mass = any_mass || is_mass(p["unit"]);
        }
    for (const char* key : {"time_step", "youngs_modulus", "poisson_ratio"}) CHECK(keys.contains(key));
    CHECK(any_mass);
}

// ---------------------------------------------------------------------------------------------------------- time steps

TEST_CASE("a time step that is none is refused by every lesson that has one", "[process][every_lesson]") {
    for (const std::string& lesson : lessons_with("time_step"))
        for (const char* dt : {"0", "-0", "-1e-3"})
            check_refused({"run", lesson, "--steps", "1", "--set", std::string("time_step=") + dt}, "time_step");
}

TEST_CASE("a time step of a second, or of ten, is finite or reported with its limit", "[process][slow][every_lesson]") {
    for (const std::string& lesson : lessons_with("time_step")) {
        const Json parameters = parameters_of(lesson);
        for (const char* dt : {"1", "10"})
            if (accepts(*parameter_named(parameters, "time_step"), std::stod(dt)))
                check_finite_or_reported({"run", lesson, "--steps", "20", "--json", "--set", std::string("time_step=") + dt});
    }
}

TEST_CASE("stiff springs in a step of a second: implicit is finite, the others report their limit", "[process]") {
    const Arguments stiff = with({"run", "mesh/mass_spring", "--steps", "50", "--json"}, {"time_step=1", "k_structural=1e6"});
    check_run(with(stiff, {"integrator=implicit_euler"}));
    for (const char* method : {"explicit_euler", "semi_implicit_euler"}) {
        const Outcome outcome = call(with(stiff, {std::string("integrator=") + method}));
        INFO(method << "\n" << outcome.err);
        REQUIRE(outcome.exit_code == diverged);
        CHECK(contains(outcome.err, "time step"));
        CHECK(contains(outcome.err, "limit"));
    }
}

TEST_CASE("a thick fluid: implicit viscosity is finite, explicit viscosity is refused with its limit", "[process]") {
    const Arguments thick = with({"run", "fluids/navier_stokes", "--steps", "50", "--json"}, {"viscosity=1e6", "resolution=16"});
    check_run(with(thick, {"viscosity_scheme=implicit"}));
    const Arguments explicit_run = with(thick, {"viscosity_scheme=explicit"});
    check_refused(explicit_run, "time_step");
    CHECK(contains(call(explicit_run).err, "Δx²/(4ν)"));
    check_run(with({"run", "fluids/navier_stokes", "--steps", "3", "--json"}, {"viscosity=0", "resolution=16"}));
}

TEST_CASE("a solver that is stopped early says so, with its residual", "[process]") {
    const Json run = json_of({"run", "elasticity/moduli", "--set", "max_iterations=1", "--set", "resolution=2"});
    CHECK_FALSE(run["assumptions"]["solver converged"]["holds"].get<bool>());
    CHECK(run["assumptions"]["solver converged"]["value"].get<double>() > 1e-3);
    const Outcome outcome = call(with({"run", "mesh/mass_spring", "--steps", "50"},
                                      {"integrator=implicit_euler", "newton_iterations=1", "newton_tolerance=1e-14"}));
    CHECK(outcome.exit_code == diverged);
    CHECK(contains(outcome.err, "did not converge after 1 iterations: residual"));
}

// ---------------------------------------------------------------------------------------------------------- every end

TEST_CASE("every number at either end of what is accepted is finite, reported or refused", "[process][slow][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const Json& p : parameters_of(lesson)) {
            if (p["kind"] != "number") continue;
            const Json& a = p["accepted"];
            const double low = a["min"], high = a["max"];
            for (const double end :
                 {a["open_min"] ? std::nextafter(low, high) : low, a["open_max"] ? std::nextafter(high, low) : high})
                check_finite_reported_or_refused(
                    {"run", lesson, "--steps", "3", "--json", "--set", p["key"].get<std::string>() + "=" + exactly(end)});
        }
}

TEST_CASE("the least of everything that is counted is enough: one cell, one load, one iteration", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson()) {
        Arguments all{"run", lesson, "--steps", "3", "--json"};
        for (const Json& p : parameters_of(lesson))
            if (p["kind"] == "whole number") {
                const std::string least = p["key"].get<std::string>() + "=" + exactly(p["accepted"]["min"]);
                check_finite_reported_or_refused({"run", lesson, "--steps", "3", "--json", "--set", least});
                all.insert(all.end(), {"--set", least});
            }
        check_finite_reported_or_refused(all);
    }
}

// ----------------------------------------------------------------------------------------------------------- materials

TEST_CASE("a material without stiffness, or with less, is refused", "[process][every_lesson]") {
    for (const std::string& lesson : lessons_with("youngs_modulus"))
        for (const char* Y : {"0", "-1", "-1e6"})
            check_refused({"run", lesson, "--steps", "1", "--set", std::string("youngs_modulus=") + Y}, "youngs_modulus");
}

TEST_CASE("a body without mass, or with less, is refused", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const Json& p : parameters_of(lesson)) {
            const std::string unit = p["unit"];
            if (!is_mass(unit)) continue;
            for (const char* mass : {"=0", "=-1"})
                check_refused({"run", lesson, "--steps", "1", "--set", p["key"].get<std::string>() + mass}, p["key"]);
        }
}

TEST_CASE("Poisson's ratio is refused where the material is impossible, and finite up to there", "[process][every_lesson]") {
    for (const std::string& lesson : lessons_with("poisson_ratio")) {
        const Json parameters = parameters_of(lesson);
        const Json& nu = *parameter_named(parameters, "poisson_ratio");
        for (const char* value : {"0.5", "0.6", "-1", "-1.2", "0.4999", "-0.9", "0"}) {
            const Arguments run{"run", lesson, "--steps", "1", "--json", "--set", std::string("poisson_ratio=") + value};
            accepts(nu, std::stod(value)) ? check_run(run) : check_refused(run, "poisson_ratio");
        }
    }
}

TEST_CASE("moduli near the ends of Poisson's ratio are those of the closed forms", "[process]") {
    // K/G = (2/3)(1 + ν)/(1 − 2ν)
    CHECK(close(measured("pressure", "0.4999") / measured("shear", "0.4999"), 4999.0 + 2.0 / 3, 1e-6));
    CHECK(close(measured("shear", "-0.9"), 5e6, 1e-9));
    CHECK(close(measured("pressure", "-0.9"), 1e6 / 8.4, 1e-9));
    const Json cork = json_of(with({"run", "elasticity/moduli"}, {"poisson_ratio=0", "resolution=2"}));
    CHECK(std::abs(cork["probes"]["transverse_strain"]["value"].get<double>()) <
          1e-12 * cork["probes"]["strain"]["value"].get<double>());
    const Json foam = json_of(with({"run", "elasticity/moduli"}, {"poisson_ratio=-0.9", "resolution=2"}));
    CHECK(foam["probes"]["transverse_strain"]["value"].get<double>() > 0);  // pulled, it widens
}

TEST_CASE("a material that is almost incompressible breaks the assumption that says so", "[process]") {
    const auto holds = [](const char* nu) {
        const Json run =
            json_of({"run", "elasticity/moduli", "--set", std::string("poisson_ratio=") + nu, "--set", "resolution=2"});
        return run["assumptions"]["compressible enough"]["holds"].get<bool>();
    };
    CHECK(holds("0.3"));
    CHECK_FALSE(holds("0.4999"));
}

// ------------------------------------------------------------------------------------------------------- repeated runs

TEST_CASE("no step of any preset leaves the initial state, and the same preset twice gives the same bits",
          "[process][slow][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const std::string& name : presets_of(lesson)) {
            CAPTURE(lesson, name);
            const auto run = [&](const char* steps) {
                return without_cost(json_of({"run", lesson, "--preset", name, "--steps", steps}));
            };
            CHECK(run("2").dump() == run("2").dump());
            CHECK(run("0")["steps"] == 0);
            CHECK(run("0").dump() == run("0").dump());
        }
}
