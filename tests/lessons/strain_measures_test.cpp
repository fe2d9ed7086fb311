// The strain measures lesson: the tensors of known deformations, component by component.
#include "readings.h"

#include <fmt/format.h>
#include <pliant/continuum/moduli.h>
#include <pliant/study/claims.h>
#include <pliant/text/format.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "why_checks.h"

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner done(const Runner::Assignments& assignments) {
    Runner runner(find_lesson("elasticity/strain_measures"), assignments);
    runner.step();
    return runner;
}

Mat<3> components(const Runner& runner, const char* name) {
    Mat<3> m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m(i, j) = value(runner, fmt::format("{}_{}{}", name, i + 1, j + 1));
    return m;
}

Curve curve_of(const Runner& runner, std::string_view name, bool reference = false) {
    Curve curve;
    const Line& line = *std::ranges::find(runner.lesson().lines, name, &Line::name);
    reference ? line.reference(curve) : line.sample(curve);
    return curve;
}

const Runner::Assignments mirror{{"map", "free"}, {"F11", "-1"}, {"F12", "0"}, {"F13", "0"}, {"F21", "0"},
                                 {"F22", "1"},    {"F23", "0"},  {"F31", "0"}, {"F32", "0"}, {"F33", "1"}};

}  // namespace

TEST_CASE("strain measures: the tensor case of the catalogue, to 1e-12 in every component", "[strain]") {
    const Runner runner = done({{"map", "free"},
                                {"F11", "1.2"},
                                {"F12", "0.3"},
                                {"F13", "0"},
                                {"F21", "0"},
                                {"F22", "0.9"},
                                {"F23", "0.1"},
                                {"F31", "0.05"},
                                {"F32", "0"},
                                {"F33", "1.1"}});
    Mat<3> C, green, cauchy;
    C << 1.4425, 0.36, 0.055, 0.36, 0.9, 0.09, 0.055, 0.09, 1.22;
    green << 0.22125, 0.18, 0.0275, 0.18, -0.05, 0.045, 0.0275, 0.045, 0.11;
    cauchy << 0.2, 0.15, 0.025, 0.15, -0.1, 0.05, 0.025, 0.05, 0.1;
    CHECK((components(runner, "c") - C).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((components(runner, "green") - green).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((components(runner, "cauchy") - cauchy).cwiseAbs().maxCoeff() < 1e-12);
    CHECK_THAT(value(runner, "volume_ratio"), WithinAbs(1.1895, 1e-12));
    // Hooke's law of Green's strain.
    const auto material = IsotropicModuli::from_young_poisson(1e6, 0.3);
    const Mat<3> stress = hooke_stress<3>(material.lame(), green);
    CHECK_THAT(value(runner, "stress_green_11"), WithinRel(stress(0, 0), 1e-12));
    CHECK_THAT(value(runner, "stress_green_23"), WithinRel(stress(1, 2), 1e-12));
    CHECK_THAT(value(runner, "stress_cauchy_12"), WithinRel(2 * material.mu() * 0.15, 1e-12));
}

TEST_CASE("strain measures: a rotation by 90 and 30 degrees is no Green strain, and Cauchy's is cos - 1", "[strain]") {
    for (const Runner::Assignments& turned :
         {Runner::Assignments{{"map", "translation"}, {"turn", "90"}}, {{"map", "rotation"}, {"angle", "90"}}}) {
        const Runner runner = done(turned);
        CHECK(components(runner, "green").cwiseAbs().maxCoeff() < 1e-15);
        CHECK_THAT(value(runner, "cauchy_11"), WithinAbs(-1, 1e-12));
        CHECK_THAT(value(runner, "cauchy_22"), WithinAbs(-1, 1e-12));
        CHECK(value(runner, "cauchy_33") == 0);
    }
    const Runner runner = done({{"map", "rotation"}, {"angle", "30"}});
    CHECK_THAT(value(runner, "cauchy_11"), WithinAbs(-0.1339746, 1e-7));
    CHECK_THAT(value(runner, "cauchy_11"), WithinAbs(std::sqrt(0.75) - 1, 1e-15));
}

TEST_CASE("strain measures: a turn afterwards changes Cauchy's strain and stress alone", "[strain]") {
    const char* map = GENERATE("stretch", "shear", "free");
    const Runner before = done({{"map", map}}), after = done({{"map", map}, {"turn", "73"}});
    for (const char* name : {"green", "c"})
        CHECK((components(before, name) - components(after, name)).cwiseAbs().maxCoeff() < 1e-14);
    CHECK((components(before, "cauchy") - components(after, "cauchy")).cwiseAbs().maxCoeff() > 0.1);
    CHECK_THAT(value(after, "stress_green_12"), WithinRel(value(before, "stress_green_12"), 1e-10) || WithinAbs(0, 1e-8));
    CHECK_THAT(value(after, "stretch_of_v"), WithinRel(value(before, "stretch_of_v"), 1e-12));
}

TEST_CASE("strain measures: every probe with a closed form meets it", "[strain]") {
    const char* map = GENERATE("translation", "rotation", "stretch", "shear", "free");
    const char* turn = GENERATE("0", "-130");
    const char* axis = GENERATE("z", "x");
    const Runner runner = done({{"map", map}, {"turn", turn}, {"axis", axis}, {"v_angle", "77"}, {"v_elevation", "-20"}});
    INFO(map << " " << turn << " " << axis);
    for (const Probe& probe : runner.lesson().probes) {
        INFO(probe.name);
        if (const auto closed = runner.exact(probe)) CHECK_THAT(runner.value(probe).value(), WithinAbs(*closed, 1e-12));
    }
    CHECK(runner.holds(0) == Holds::yes);
}

TEST_CASE("strain measures: the stretch of a direction is measured and foretold alike by C, not by Cauchy", "[strain]") {
    const Runner runner =
        done({{"map", "shear"}, {"shear", "1"}, {"v_angle", format_exact(-std::atan(2) * 180 / std::numbers::pi)}});
    CHECK_THAT(value(runner, "stretch_of_v"), WithinRel(1, 1e-12));
    CHECK_THAT(value(runner, "stretch_from_C"), WithinRel(1, 1e-12));
    CHECK_THAT(value(runner, "stretch_from_cauchy"), WithinRel(0.6, 1e-12));
    const Runner raised = done({{"map", "stretch"}, {"stretch_z", "1.7"}, {"v_elevation", "90"}});
    CHECK_THAT(value(raised, "stretch_of_v"), WithinRel(1.7, 1e-12));
}

TEST_CASE("strain measures: a mirror has C = I and is told by det F alone", "[strain]") {
    const Runner runner = done(mirror);
    CHECK((components(runner, "c") - Mat<3>::Identity()).isZero(0));
    CHECK(components(runner, "green").isZero(0));
    CHECK(value(runner, "volume_ratio") == -1);
    const auto& all = runner.lesson().assumptions;
    const Assumption& proper = *std::ranges::find(all, "not inside out", &Assumption::name);
    CHECK(proper.value() > proper.limit());
}

TEST_CASE("strain measures: over a turn Cauchy's strain is cos - 1, and the present turn is marked", "[strain]") {
    const Runner runner = done({{"map", "translation"}, {"turn", "60"}});
    const Curve small = curve_of(runner, "strain_over_turn"), marked = curve_of(runner, "strain_over_turn", true);
    for (std::size_t k = 0; k < small.position.size(); ++k)
        CHECK_THAT(small.value[k], WithinAbs(std::cos(small.position[k] * std::numbers::pi / 180) - 1, 1e-14));
    REQUIRE(marked.position.size() == 5);
    CHECK(marked.position[2] == 60);
    CHECK_THAT(marked.value[2], WithinAbs(-0.5, 1e-12));
    CHECK(marked.value[0] == 0);
}

TEST_CASE("strain measures: Cauchy's error reaches one per cent at a strain of 2.02 per cent", "[strain]") {
    const Runner runner = done({});
    const Curve error = curve_of(runner, "error_over_strain"), limit = curve_of(runner, "error_over_strain", true);
    CHECK_THAT(limit.position[1], WithinRel(0.02 / 0.99, 1e-12));
    for (std::size_t k = 0; k < error.position.size(); ++k) {
        const Real e = error.position[k];
        CHECK_THAT(error.value[k], WithinRel(e / 2 / (1 + e / 2), 1e-9));
    }
    const Runner at_limit =
        done({{"map", "stretch"}, {"stretch_x", format_exact(1 + 0.02 / 0.99)}, {"stretch_y", "1"}, {"stretch_z", "1"}});
    CHECK_THAT(value(at_limit, "strain_difference") / value(at_limit, "green_11"), WithinRel(0.01, 1e-9));
}

TEST_CASE("strain measures: operations are counted, not timed", "[strain]") {
    const Runner runner = done({});
    CHECK(value(runner, "operations_c") == 45);       // 9 entries of 3 products and 2 sums
    CHECK(value(runner, "operations_cauchy") == 18);  // a sum and a product for each entry
    CHECK(value(runner, "operations_green") == 72);
}

TEST_CASE("strain measures: the head of v is a handle", "[strain]") {
    const Runner runner = done({});
    CHECK(runner.lesson().can_pull() == On::particle);
    const auto values = runner.lesson().dragged({0, Vec<3>::Zero(), {0, 2, 0}});
    REQUIRE(values.size() == 1);
    CHECK(values[0].first == "v_angle");
    CHECK_THAT(values[0].second, WithinRel(90, 1e-12));
    CHECK(runner.lesson().dragged({0, Vec<3>::Zero(), Vec<3>::Zero()}).empty());
}

TEST_CASE("strain measures: stays finite at the ends of what is accepted", "[strain]") {
    const char* map = GENERATE("translation", "rotation", "stretch", "shear", "free");
    const LessonEntry& entry = find_lesson("elasticity/strain_measures");
    const auto made = entry.make();
    for (const bool high : {false, true}) {
        Runner::Assignments ends{{"map", map}};
        for (const Parameter* p : made->parameters)
            if (p->info.kind == Kind::number && p->info.key != "poisson_ratio")
                ends.emplace_back(p->info.key, p->text(high ? p->accepted().max : p->accepted().min));
        Runner runner(entry, ends);
        REQUIRE_NOTHROW(runner.step());
        for (const Probe& probe : runner.lesson().probes) REQUIRE_NOTHROW(runner.value(probe));
    }
}

TEST_CASE("strain measures: explained in every map, turned, tilted and mirrored", "[strain]") {
    for (const char* map : {"translation", "rotation", "stretch", "shear", "free"})
        for (const char* turn : {"0", "40", "90", "180"}) {
            Runner runner(find_lesson("elasticity/strain_measures"), {{"map", map}, {"turn", turn}, {"v_elevation", "35"}});
            check_every_stage(runner, fmt::format("{} {}", map, turn));
        }
    Runner runner(find_lesson("elasticity/strain_measures"), mirror);
    check_every_stage(runner, "mirror");
}

TEST_CASE("strain measures: its fixes mend what they promise", "[strain]") {
    const std::vector<std::pair<std::string, Runner::Assignments>> broken{
        {"small strain and small rotation", {}},
        {"small strain and small rotation", {{"map", "translation"}, {"turn", "10"}}},
        {"small strain and small rotation", {{"map", "rotation"}}},
        {"small strain and small rotation", {{"map", "stretch"}}},
        {"small strain and small rotation", {{"map", "shear"}}},
        {"not inside out", mirror},
        {"not inside out", {{"map", "stretch"}, {"stretch_x", "-1"}}}};
    for (const auto& [name, parameters] : broken) {
        Runner runner = done(parameters);
        const auto& all = runner.lesson().assumptions;
        const Assumption& checked = *std::ranges::find(all, name, &Assumption::name);
        INFO(name << " " << (parameters.empty() ? "" : parameters.front().second));
        REQUIRE(checked.value() > checked.limit());
        for (int times = 0; times < 4 && checked.value() > checked.limit(); ++times) {
            const auto fix = checked.fix();
            REQUIRE(fix);
            runner.assign(Runner::Assignments(fix->assign.begin(), fix->assign.end()));
            runner.step();
        }
        CHECK(checked.value() <= checked.limit());
    }
}

TEST_CASE("strain measures: the claims E10 to E13 are found as expected", "[strain]") {
    for (const char* id : {"E10", "E11", "E12", "E13"}) {
        const Claim& claim = find_claim(id);
        const Finding finding = claim.measure();
        INFO(id << ": " << finding.text);
        CHECK(finding.verdict == claim.expected);
        CHECK(finding.condition.empty() == (finding.verdict != Verdict::qualified));
        CHECK_NOTHROW(Runner(find_lesson(claim.lesson), claim.scene));
    }
}
