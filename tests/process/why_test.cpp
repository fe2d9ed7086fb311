// `pliant why`: the same answer for programs and for people.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

void check_shape(const Json& answer, int depth) {
    for (const char* key : {"field", "index", "value", "unit", "stage", "formula", "substituted", "inputs"})
        CHECK(answer.contains(key));
    if (depth == 0) CHECK(answer["inputs"].empty());
    for (const Json& input : answer["inputs"]) check_shape(input, depth - 1);
}

const Json& input_of(const Json& answer, const std::string& symbol) {
    for (const Json& input : answer["inputs"])
        if (input["symbol"] == symbol) return input;
    FAIL("no input " << symbol);
    return answer;
}

}  // namespace

TEST_CASE("why tells the stage, the formula and the inputs of a number", "[process]") {
    const Json a = json_of({"why", "navier_stokes", "--steps", "5", "--field", "pressure", "--index", "4000", "--depth", "2"});
    check_shape(a, 2);
    CHECK(a["field"] == "pressure");
    CHECK(a["index"] == 4000);
    CHECK(a["unit"] == "m²/s²");
    CHECK(a["stage"] == "projection");
    // The row of the pressure equation, evaluated here.
    const auto value = [&](const char* symbol) { return input_of(a, symbol)["value"].get<double>(); };
    const double dx = value("Δx"), p = (value("p_left") + value("p_right") + value("p_below") + value("p_above") -
                                        dx * dx * (value("d̃") - value("d")) / value("Δt")) /
                                       4;
    CHECK(std::abs(p - a["value"].get<double>()) <= 1e-9 * std::abs(p));
    CHECK(input_of(a, "Δt")["kind"] == "parameter");
    // How much each input matters: what a relative change of it changes.
    const double right_side = dx * dx * (value("d̃") - value("d")) / value("Δt") / 4;
    CHECK(a["unit_check"] == "ok");
    CHECK(contains(a["latex"].get<std::string>(), "\\frac"));
    CHECK(std::abs(input_of(a, "Δt")["sensitivity"].get<double>() - std::abs(right_side)) <= 1e-9 * std::abs(right_side));
    CHECK(std::abs(input_of(a, "p_left")["sensitivity"].get<double>() - std::abs(value("p_left")) / 4) <= 1e-12 * std::abs(p));
    CHECK(input_of(a, "d̃")["formula"].get<std::string>().find("u_right − u_left") != std::string::npos);
}

TEST_CASE("why goes inside a step, asks probes, and takes components", "[process]") {
    const Json a = json_of({"why", "navier_stokes", "--steps", "3", "--stage", "advection", "--field", "velocity", "--index",
                            "300", "--component", "1"});
    CHECK(a["stage"] == "advection");
    CHECK(a["component"] == 1);
    CHECK(json_of({"why", "navier_stokes", "--steps", "3", "--field", "max_divergence"})["inputs"].size() == 1);
    CHECK(json_of({"why", "mass_spring", "--steps", "3", "--field", "velocity", "--index", "7"})["inputs"].size() == 3);
    CHECK(json_of({"why", "moduli", "--field", "measured_modulus"})["value"].get<double>() > 0);
}

TEST_CASE("why says which slopes are differences: of what a function without a formula takes", "[process]") {
    const Json a = json_of({"why", "moduli", "--field", "strain_energy"});
    CHECK(a["unit_check"] == "ok");
    CHECK(!input_of(a, "λ").contains("sensitivity_by"));
    REQUIRE(a["inputs"].size() > 3);
    CHECK(a["inputs"][2]["sensitivity_by"] == "differences");
    CHECK(contains(a["substituted"].get<std::string>(), "kPa · "));
}

TEST_CASE("why in words shows the formula with its numbers", "[process]") {
    const std::string text = output_of({"why", "mass_spring", "--steps", "10", "--field", "tension", "--index", "3"});
    CHECK(contains(text, "tension[3]"));
    CHECK(contains(text, "N"));
    CHECK(contains(text, "k_structural"));
}

TEST_CASE("why shows that the slide's formula is wrong in its units", "[process]") {
    const Arguments slide{"why", "diffusion", "--set", "form=lecture", "--steps", "1", "--field", "u", "--index", "3"};
    CHECK(contains(output_of(slide), "The sides differ in their unit: m/s on the left, m³/s on the right."));
    const Arguments careful{"why", "diffusion", "--steps", "1", "--field", "u", "--index", "3"};
    CHECK_FALSE(contains(output_of(careful), "differ in their unit"));
}

TEST_CASE("why refuses what does not exist", "[process]") {
    for (const Arguments& arguments : std::vector<Arguments>{{"why", "navier_stokes", "--field", "presure"},
                                                             {"why", "navier_stokes", "--field", "pressure", "--index", "-1"},
                                                             {"why", "navier_stokes", "--field", "pressure", "--index", "99999"},
                                                             {"why", "navier_stokes", "--field", "pressure", "--component", "3"},
                                                             {"why", "navier_stokes", "--field", "pressure", "--depth", "99"},
                                                             {"why", "navier_stokes", "--field", "cfl", "--index", "3"},
                                                             {"why", "navier_stokes"},
                                                             {"why", "no_such_lesson", "--field", "x"}}) {
        const Outcome outcome = call(arguments);
        INFO(arguments.back());
        CHECK(outcome.exit_code == 2);
        CHECK(!outcome.err.empty());
        CHECK(outcome.out.empty());
    }
}
