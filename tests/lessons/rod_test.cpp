// The rod: its statics, modes and waves against closed forms.
#include "readings.h"
#include "why_checks.h"

#include <pliant/math/line_fit.h>
#include <pliant/run/runner.h>
#include <pliant/text/format.h>
#include <pliant/time/scheme.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

Runner start_rod(const Runner::Assignments& parameters) { return Runner(find_lesson("mesh/rod"), parameters); }

Runner after(Index steps, const Runner::Assignments& parameters) {
    Runner runner = start_rod(parameters);
    for (Index k = 0; k < steps; ++k) runner.step();
    return runner;
}

Real error(const Runner& runner, std::string_view probe) { return std::abs(value(runner, probe) - exact(runner, probe)); }

const Line& line(const Runner& runner, std::string_view name) {
    return *std::ranges::find(runner.lesson().lines, name, &Line::name);
}

}  // namespace

TEST_CASE("rod: it hangs (N + 1)/N times as far as the continuum, with order 1", "[rod]") {
    const Real continuum = 9.81 / 40;
    CHECK_THAT(value(after(1, {}), "tip_displacement"), WithinRel(1.1 * continuum, 1e-10));
    std::vector<Real> size, off;
    for (const Index n : {1, 10, 20, 40, 80, 160, 200}) {
        const Runner runner = after(1, {{"segments", std::to_string(n)}});
        const auto N = static_cast<Real>(n);
        CHECK_THAT(exact(runner, "tip_displacement"), WithinRel(continuum, 1e-14));
        CHECK_THAT(value(runner, "tip_over_continuum"), WithinRel((N + 1) / N, 1e-10));
        CHECK(error(runner, "tip_over_continuum") < 1e-10);
        CHECK_THAT(value(runner, "tip_of_chain"), WithinRel(value(runner, "tip_displacement"), 1e-10));
        CHECK(runner.lesson().at_rest());
        check_laws(runner);
        size.push_back(std::log(1 / N)), off.push_back(std::log(error(runner, "tip_displacement")));
    }
    CHECK_THAT(fit_line(size, off)->slope, WithinAbs(1, 1e-6));
}

TEST_CASE("rod: springs picked by hand hang the further the more there are", "[rod]") {
    for (const Index n : {1, 10, 20, 200}) {
        const Runner runner =
            after(1, {{"spring_rule", "constant"}, {"segments", std::to_string(n)}, {"picked_stiffness", "150"}});
        const auto N = static_cast<Real>(n);
        CHECK_THAT(value(runner, "tip_displacement"), WithinRel(9.81 * (N + 1) / (2 * 150), 1e-10));
        CHECK_THAT(value(runner, "chain_axial_stiffness"), WithinRel(150 / N, 1e-12));
        check_laws(runner);
    }
    const Runner runner = start_rod({{"spring_rule", "constant"}, {"segments", "20"}});
    const Assumption& own = assumption(runner, "rod_of_its_own");
    CHECK(own.value() > own.limit());
    Runner mended = start_rod({{"spring_rule", "constant"}, {"segments", "20"}});
    mended.assign(own.fix()->assign);
    CHECK(assumption(mended, "rod_of_its_own").value() <= own.limit());
}

TEST_CASE("rod: the curves of the tip against N are those of rods that hang", "[rod]") {
    const Runner runner = after(1, {{"segments", "10"}});
    const Line& tips = line(runner, "tip_against_segments");
    Curve derived, picked, reference, mark;
    tips.others[0].sample(derived), tips.others[1].sample(picked), tips.reference(reference), tips.sample(mark);
    REQUIRE(derived.position.front() == 1);
    REQUIRE(derived.position.back() > 150);
    for (std::size_t k = 0; k < derived.position.size(); ++k) {
        const Real n = derived.position[k];
        CHECK_THAT(derived.value[k], WithinRel(9.81 / 40 * (n + 1) / n, 1e-12));
        CHECK_THAT(picked.value[k], WithinRel(9.81 * (n + 1) / 400, 1e-12));
    }
    CHECK_THAT(reference.value[0], WithinRel(9.81 / 40, 1e-14));
    CHECK(mark.value[0] == value(runner, "tip_displacement"));
}

TEST_CASE("rod: springs of 200 N/m hang as the continuum at 9 segments, and as the derived ones at 10", "[rod]") {
    const auto tip = [](const char* rule, const char* segments) {
        return value(after(1, {{"spring_rule", rule}, {"segments", segments}}), "tip_over_continuum");
    };
    CHECK_THAT(tip("constant", "9"), WithinRel(1, 1e-12));
    CHECK_THAT(tip("constant", "10"), WithinRel(tip("derived", "10"), 1e-12));
}

TEST_CASE("rod: in every stage stands what the lecture writes", "[rod]") {
    Runner runner = after(1, {});
    const auto field = [&](std::string_view name) { return runner.lesson().field(name).view(); };
    // Each segment carries what hangs below its upper end.
    for (std::size_t i = 0; i < 10; ++i) {
        const Real tension = 9.81 * static_cast<Real>(10 - i) / 10, strain = tension / 20;
        CHECK_THAT(field("tension")[i], WithinRel(tension, 1e-11));
        CHECK_THAT(field("strain")[i], WithinRel(strain, 1e-11));
        CHECK_THAT(field("energy_density")[i], WithinRel(10 * strain * strain, 1e-11));
        CHECK_THAT(field("segment_energy")[i], WithinRel(strain * strain, 1e-11));
        CHECK_THAT(field("spring_stiffness")[i], WithinRel(200, 1e-14));
        CHECK_THAT(field("spring_force")[2 * i + 3] + field("external_force")[2 * i + 3], WithinAbs(0, 1e-12));
        CHECK_THAT(field("gradient_force")[2 * i + 3], WithinAbs(field("spring_force")[2 * i + 3], 1e-12));
    }
    CHECK_THAT(exact(runner, "elastic_energy"), WithinRel(9.81 * 9.81 / 120, 1e-12));
    // A light that can go out: a rod whose springs are not those of its energy.
    CHECK(runner.holds(0) == Holds::yes);
    std::vector<std::string_view> names;
    for (const Stage* s : runner.stages()) names.push_back(s->name);
    CHECK(names == std::vector<std::string_view>{"positions", "strain", "energy_density", "discrete_energy", "springs", "forces",
                                                 "external_forces", "equilibrium"});
}

TEST_CASE("rod: a mode swings with the frequency of the catalogue", "[rod]") {
    // k = m = 1: EA = k Δs.
    const Runner::Assignments unit{{"scene", "wave"}, {"segments", "10"},    {"axial_stiffness", "0.1"}, {"mass", "10"},
                                   {"mode", "1"},     {"time_step", "0.05"}, {"amplitude", "0.001"}};
    Runner runner = after(2000, unit);
    CHECK_THAT(exact(runner, "frequency"), WithinAbs(0.14946019, 5e-9));
    CHECK_THAT(value(runner, "frequency_chain"), WithinAbs(0.14946019, 5e-9));
    CHECK_THAT(value(runner, "frequency"), WithinRel(exact(runner, "frequency"), 1e-4));
    check_laws(runner);
    for (const auto& [j, omega] : {std::pair{"2", 0.44504187}, {"3", 0.73068205}}) {
        runner.assign({{"mode", j}});
        CHECK_THAT(value(runner, "frequency_chain"), WithinAbs(omega, 5e-9));
    }
    // The long waves of a fine chain are those of the rod, of order 1 in 1/N.
    const auto off = [](const char* n) {
        const Runner fine = start_rod({{"scene", "wave"}, {"segments", n}});
        return 1 - value(fine, "frequency_chain") / value(fine, "frequency_continuum");
    };
    CHECK_THAT(off("100") / off("200"), WithinRel(2, 0.01));
}

TEST_CASE("rod: every scheme swings with its order, damped or not", "[rod]") {
    const SchemeInfo& scheme = schemes()[static_cast<std::size_t>(GENERATE(Catch::Generators::range(0, 8)))];
    const char* damping = GENERATE("0", "0.02");
    const auto off = [&](Real dt) {
        const Runner runner = after(static_cast<Index>(std::lround(0.4 / dt)), {{"scene", "wave"},
                                                                                {"scheme", std::string(scheme.key)},
                                                                                {"segments", "4"},
                                                                                {"damping", damping},
                                                                                {"time_step", format_exact(dt)}});
        CHECK(value(runner, "force_difference") < 1e-12);
        return error(runner, "mode_amplitude");
    };
    INFO(scheme.key << " " << damping);
    const Real order = std::log2(off(4e-3) / off(2e-3));
    CHECK(std::abs(order - scheme.order) < (scheme.order == 1 ? 0.35 : 0.25));
}

TEST_CASE("rod: a pulse runs with c, and comes back from a free end as it went, from a fixed one with its sign turned", "[rod]") {
    const char* scene = GENERATE("free_end", "fixed_end");
    const bool free = std::string_view(scene) == "free_end";
    Runner runner = after(60, {{"scene", scene}, {"segments", "100"}, {"time_step", "1e-3"}});
    CHECK_THAT(value(runner, "wave_speed"), WithinRel(std::sqrt(20), 0.02));
    CHECK_THAT(exact(runner, "wave_speed"), WithinRel(std::sqrt(20), 1e-14));
    CHECK(error(runner, "pulse_position") < 0.01);
    check_laws(runner);
    while (runner.time() < 0.65 / std::sqrt(20)) runner.step();
    CHECK_THAT(value(runner, "tip_displacement"), WithinAbs(free ? 0.06 : 0, 1e-3));
    while (runner.time() < 1.3 / std::sqrt(20)) runner.step();
    const Real back = runner.lesson().field("displacement").view()[35];
    CHECK_THAT(back, WithinAbs(free ? 0.03 : -0.03, 2e-3));
    CHECK(error(runner, "tip_displacement") < 2e-3);
    // Its speed is measured on the way back too, and not while it is at an end.
    CHECK_THAT(value(runner, "wave_speed"), WithinRel(std::sqrt(20), 0.02));
    CHECK(error(runner, "pulse_position") < 0.02);
    while (runner.time() < 1.65 / std::sqrt(20)) runner.step();
    CHECK_FALSE(runner.lesson().probe("wave_speed").value());
    check_laws(runner);
}

TEST_CASE("rod: let go, it falls to twice its rest and returns; damped, it comes to rest", "[rod]") {
    Runner runner = start_rod({{"scene", "released"}, {"segments", "100"}, {"time_step", "1e-3"}});
    Real off = 0, lowest = 0;
    while (runner.time() < 0.9) {
        runner.step();
        off = std::max(off, error(runner, "tip_displacement"));
        lowest = std::max(lowest, value(runner, "tip_displacement"));
    }
    CHECK(off < 0.05 * 9.81 / 40);
    CHECK_THAT(lowest, WithinRel(2 * 9.81 / 40, 0.02));
    check_laws(runner);
    const Runner damped =
        after(400, {{"scene", "released"}, {"damping", "0.1"}, {"scheme", "implicit_euler"}, {"time_step", "0.02"}});
    CHECK_THAT(value(damped, "tip_displacement"), WithinRel(value(damped, "tip_of_chain"), 1e-6));
    CHECK_FALSE(damped.exact(damped.lesson().probe("tip_displacement")));
    CHECK(damped.holds(1) == Holds::yes);
}

TEST_CASE("rod: the limit of stability is that of its fastest mode, on both sides", "[rod]") {
    const char* scheme = GENERATE("semi_implicit_euler", "velocity_verlet", "runge_kutta_4");
    const char* damping = GENERATE("0", "0.01");
    const Runner::Assignments scene{
        {"scene", "free_end"}, {"segments", "12"}, {"scheme", scheme}, {"damping", damping}, {"amplitude", "1e-3"}};
    const Real limit = assumption(start_rod(scene), "stability").limit();
    INFO(scheme << " " << damping << " " << limit);
    const auto run = [&](Real part) {
        Runner runner = start_rod(scene);
        runner.assign({{"time_step", format_exact(part * limit)}});
        for (int k = 0; k < 3000; ++k) runner.step();
        return value(runner, "energy");
    };
    CHECK(run(0.99) < 1e-2);
    CHECK_THROWS_AS(run(1.05), Diverged);
}

TEST_CASE("rod: what is above the limit names it, and what the lights offer mends", "[rod]") {
    const auto check = [](const Runner::Assignments& scene, std::string_view name) {
        Runner runner = start_rod(scene);
        if (name == "not_turned_over") runner.step();
        const Assumption& broken = assumption(runner, name);
        INFO(name);
        REQUIRE(broken.in_use());
        CHECK(broken.value() > broken.limit());
        const auto fix = broken.fix();
        REQUIRE(fix);
        runner.assign(fix->assign);
        runner.step();
        const Assumption& mended = assumption(runner, name);
        CHECK((!mended.in_use() || mended.value() <= mended.limit()));
    };
    check({{"scene", "wave"}, {"time_step", "0.03"}}, "stability");
    check({{"scene", "wave"}, {"scheme", "explicit_euler"}}, "stability");
    check({{"scene", "wave"}, {"axial_stiffness", "1e12"}}, "stability");
    check({{"scene", "free_end"}, {"pulse_width", "0.02"}, {"amplitude", "0.001"}}, "pulse_resolved");
    check({{"scene", "free_end"}, {"pulse_width", "0.002"}, {"amplitude", "0.0001"}}, "pulse_resolved");
    check({{"scene", "free_end"}, {"amplitude", "0.15"}}, "not_turned_over");
    CHECK_FALSE(assumption(start_rod({{"scene", "wave"}, {"scheme", "newmark"}}), "stability").in_use());
    CHECK_FALSE(assumption(start_rod({}), "stability").in_use());

    Runner runner = start_rod({{"scene", "free_end"}, {"time_step", "0.03"}});
    CHECK_THROWS_AS(
        [&] {
            for (int k = 0; k < 500; ++k) runner.step();
        }(),
        Diverged);
    REQUIRE(runner.failure());
    CHECK_THAT(runner.failure()->limit, ContainsSubstring("stability limit of 22.6 ms") && ContainsSubstring("implicit Euler"));
    const auto fix = runner.lesson().fix(*runner.failure());
    REQUIRE(fix);
    Runner mended = start_rod({{"scene", "free_end"}});
    mended.assign(fix->assign);
    for (int k = 0; k < 500; ++k) mended.step();
    check_laws(mended);
}

TEST_CASE("rod: a scheme can be changed in a run, and the run gone back", "[rod]") {
    Runner runner = after(3, {{"scene", "wave"}, {"scheme", "bdf2"}});
    const auto positions = [&] {
        const auto view = runner.lesson().field("position").view();
        return std::vector<Real>(view.begin(), view.end());
    };
    std::vector<std::vector<Real>> seen{positions()};
    for (const char* scheme : {"velocity_verlet", "bdf2", "runge_kutta_4"}) {
        runner.assign({{"scheme", scheme}});
        runner.step(), runner.step();
        seen.push_back(positions());
    }
    for (std::size_t k = 3; k-- > 0;) {
        REQUIRE(runner.step_back());
        REQUIRE(runner.step_back());
        CHECK(positions() == seen[k]);
    }
    for (std::size_t k = 1; k <= 3; ++k) {
        REQUIRE(runner.go_to({3 + 2 * static_cast<Index>(k), 0}));
        CHECK(positions() == seen[k]);
    }
}

TEST_CASE("rod: without weight, with one segment, beyond the modes that there are", "[rod]") {
    const Runner weightless = after(1, {{"gravity", "0"}});
    CHECK(value(weightless, "tip_displacement") == 0);
    CHECK_FALSE(weightless.lesson().probe("tip_over_continuum").value());
    CHECK_THAT(value(after(1, {{"segments", "1"}}), "tip_over_continuum"), WithinRel(2, 1e-12));
    const Runner highest = after(5, {{"scene", "wave"}, {"segments", "3"}, {"mode", "200"}});
    CHECK_THAT(value(highest, "frequency_chain"), WithinRel(2 * std::sqrt(180) * std::sin(5 * pi / 14), 1e-9));
    CHECK(value(after(5, {{"scene", "fixed_end"}, {"segments", "1"}}), "tip_displacement") == 0);
}

TEST_CASE("why rod: every number is explained in every scene, with both rules", "[rod][why]") {
    const char* rule = GENERATE("derived", "constant");
    const auto look = [&](Runner::Assignments more, Index steps) {
        more.insert(more.end(), {{"spring_rule", rule}, {"segments", "5"}});
        Runner runner = start_rod(more);
        check_every_stage(runner, fmt::format("rod {} {}", rule, more.front().second), steps, 1);
    };
    look({{"scene", "hanging"}}, 1);
    look({{"scene", "hanging"}, {"gravity", "0"}}, 1);
    look({{"scene", "released"}, {"damping", "0.01"}}, 2);
    look({{"scene", "wave"}, {"mode", "2"}, {"time_step", "0.03"}}, 60);
    look({{"scene", "fixed_end"}, {"damping", "0.01"}}, 2);
    look({{"scene", "free_end"}}, 2);
}

TEST_CASE("why rod: every scheme is explained", "[rod][why]") {
    const SchemeInfo& scheme = schemes()[static_cast<std::size_t>(GENERATE(Catch::Generators::range(0, 8)))];
    Runner runner =
        start_rod({{"scene", "released"}, {"damping", "0.01"}, {"segments", "4"}, {"scheme", std::string(scheme.key)}});
    check_every_stage(runner, fmt::format("rod {}", scheme.key), 3, 1);
}

TEST_CASE("rod: what would be turned over at the start is refused, with what is accepted", "[rod]") {
    for (const Runner::Assignments& scene : {Runner::Assignments{{"scene", "wave"}, {"mode", "10"}, {"amplitude", "0.09"}},
                                             {{"scene", "wave"}, {"mode", "3"}, {"amplitude", "1000"}},
                                             {{"scene", "free_end"}, {"amplitude", "0.5"}},
                                             {{"scene", "fixed_end"}, {"segments", "200"}, {"amplitude", "0.3"}}}) {
        INFO(scene.back().second);
        std::string told;
        try {
            start_rod(scene);
        } catch (const Refused& refused) {
            told = refused.what();
        }
        REQUIRE_THAT(told, ContainsSubstring("turned over") && ContainsSubstring("give at most "));
        // What it offers is taken.
        Runner::Assignments mended = scene;
        const std::string offered = told.substr(told.find("at most ") + 8);
        mended.back().second = format_exact(std::stod(offered) * (offered.find("mm") != std::string::npos ? 1e-3 : 1));
        CHECK_NOTHROW(start_rod(mended));
    }
    CHECK_THROWS_AS(start_rod({{"scene", "free_end"}, {"pulse_width", "3"}}), Refused);
    // One that turns over on the way is told by the light, whatever |∂x/∂s| says.
    Runner runner = start_rod({{"scene", "wave"}, {"amplitude", "1.5"}});
    CHECK(assumption(runner, "not_turned_over").value() <= 0.9);
    Real worst = 0;
    for (int k = 0; k < 300; ++k) runner.step(), worst = std::max(worst, assumption(runner, "not_turned_over").value());
    CHECK(worst > 1);
}
