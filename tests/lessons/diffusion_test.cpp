// The diffusion lesson: each wave by its factor, both schemes and both forms, walls, and the limit of the explicit stencil.
#include "readings.h"

#include <fmt/format.h>
#include <pliant/text/format.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "why_checks.h"

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

Runner start_diffusion(const Runner::Assignments& parameters) { return Runner(find_lesson("fluids/diffusion"), parameters); }

Runner after(Index steps, const Runner::Assignments& parameters) {
    Runner runner = start_diffusion(parameters);
    for (Index k = 0; k < steps; ++k) runner.step();
    return runner;
}

}  // namespace

TEST_CASE("diffusion: the checkerboard of the square has the factors of the catalogue", "[diffusion]") {
    const auto factor = [](const char* r, const char* scheme) {
        const Runner runner = after(1, {{"dimension", "2"},
                                        {"start", "checkerboard"},
                                        {"resolution", "16"},
                                        {"mode", "8"},
                                        {"scheme", scheme},
                                        {"diffusion_number", r}});
        CHECK_THAT(value(runner, "factor_measured"), WithinAbs(value(runner, "factor_theory"), 1e-9));
        CHECK_THAT(value(runner, "max"), WithinAbs(std::abs(value(runner, "factor_theory")), 1e-9));
        return value(runner, "factor_measured");
    };
    CHECK_THAT(factor("0.2", "explicit"), WithinAbs(-0.6, 1e-12));
    CHECK_THAT(factor("0.25", "explicit"), WithinAbs(-1, 1e-12));
    CHECK_THAT(factor("0.26", "explicit"), WithinAbs(-1.08, 1e-12));
    CHECK_THAT(factor("10", "implicit"), WithinAbs(0.0123457, 1e-7));
}

TEST_CASE("diffusion: every mode that a random start holds is multiplied by its factor", "[diffusion]") {
    const char* boundary = GENERATE("periodic", "fixed", "insulated");
    const char* dimension = GENERATE("1", "2");
    const char* scheme = GENERATE("explicit", "implicit");
    const Runner runner = after(3, {{"boundary", boundary},
                                    {"dimension", dimension},
                                    {"scheme", scheme},
                                    {"start", "random"},
                                    {"resolution", "12"},
                                    {"tolerance", "1e-13"},
                                    {"diffusion_number", "0.2"},
                                    {"wall_low", "-0.5"}});
    INFO(boundary << " " << dimension << " " << scheme);
    const Line& factors = *std::ranges::find(runner.lesson().lines, "factors", &Line::name);
    const CompareCurve& theory = factors.others[std::string_view(scheme) == "explicit" ? 0 : 1];
    Curve measured, expected;
    factors.sample(measured);
    theory.sample(expected);
    CHECK(measured.position == expected.position);
    CHECK(measured.position.size() == (std::string_view(boundary) == "periodic" ? 7u : 12u));
    for (std::size_t k = 0; k < measured.value.size(); ++k) CHECK_THAT(measured.value[k], WithinAbs(expected.value[k], 1e-8));
}

TEST_CASE("diffusion: one mode decays as the equation says, with order 2 in space and 1 in time", "[diffusion]") {
    const char* boundary = GENERATE("periodic", "fixed", "insulated");
    const char* dimension = GENERATE("1", "2");
    const auto error = [&](const char* scheme, Index n, Real r, Index steps) {
        const Runner runner = after(steps, {{"boundary", boundary},
                                            {"dimension", dimension},
                                            {"scheme", scheme},
                                            {"mode", "2"},
                                            {"resolution", std::to_string(n)},
                                            {"wall_high", "0.3"},
                                            {"diffusion_number", format_exact(r)}});
        check_laws(runner);
        return value(runner, "error");
    };
    INFO(boundary << " " << dimension);
    // With r as it is, half the cell takes four times the steps: the errors of space and of time both fall by four.
    CHECK_THAT(std::log2(error("explicit", 16, 0.2, 10) / error("explicit", 32, 0.2, 40)), WithinAbs(2, 0.1));
    // Large steps on a fine grid: twice the steps, half the error.
    CHECK_THAT(std::log2(error("implicit", 32, 2, 8) / error("implicit", 32, 1, 16)), WithinAbs(1, 0.25));
}

TEST_CASE("diffusion: a channel starts up as the series solution says", "[diffusion]") {
    // u(1/2) at t = 0.2, 0.5 and 1 s.
    const std::array<std::pair<Real, Real>, 3> published = {{{0.2, 0.01241933}, {0.5, 0.11384420}, {1.0, 0.26275627}}};
    const char* scheme = GENERATE("explicit", "implicit");
    // Δt = r Δx²/ν = 1 ms.
    Runner runner = start_diffusion({{"start", "zero"},
                                     {"boundary", "fixed"},
                                     {"viscosity", "0.1"},
                                     {"resolution", "51"},
                                     {"cell_x", "25"},
                                     {"mode", "1"},
                                     {"scheme", scheme},
                                     {"diffusion_number", format_exact(0.1 * 1e-3 * 51 * 51)}});
    for (const auto& [time, exact] : published) {
        while (runner.time() < time - 1e-6) runner.step();
        CHECK_THAT(*runner.exact(runner.lesson().probe("u_selected")), WithinAbs(exact, 2e-8));
        CHECK_THAT(value(runner, "u_selected"), WithinAbs(exact, 4e-4));
        CHECK(value(runner, "error") < 2e-3);
        CHECK_THAT(value(runner, "amplitude"), WithinRel(*runner.exact(runner.lesson().probe("amplitude")), 0.005));
    }
}

TEST_CASE("diffusion: what is exchanged is neither made nor lost, and no new extreme appears", "[diffusion]") {
    const char* boundary = GENERATE("periodic", "insulated");
    const char* initial = GENERATE("spike", "step", "random", "checkerboard");
    const char* r = GENERATE("0.25", "30");
    const Runner runner = after(20, {{"dimension", "2"},
                                     {"boundary", boundary},
                                     {"start", initial},
                                     {"resolution", "9"},
                                     {"scheme", std::string_view(r) == "30" ? "implicit" : "explicit"},
                                     {"diffusion_number", r}});
    INFO(boundary << " " << initial << " " << r);
    CHECK(runner.holds(0) == Holds::yes);
    CHECK(runner.holds(1) == Holds::yes);
    CHECK(value(runner, "min") >= -1 - 1e-9);
}

TEST_CASE("diffusion: the formula of the slide keeps neither the mean nor the scale", "[diffusion]") {
    const Runner runner = after(1, {{"form", "lecture"}, {"start", "step"}, {"boundary", "insulated"}});
    CHECK_THAT(value(runner, "sum"), WithinAbs(0, 1e-15));
    // r Δx² times the jump of 1, on both sides of it.
    CHECK_THAT(value(runner, "max"), WithinRel(0.25 / 1024, 1e-12));
    CHECK_THAT(value(runner, "factor_measured"), WithinRel(value(runner, "factor_theory"), 1e-9));
    const Assumption& complete = assumption(runner, "the slide's formula is complete");
    CHECK(complete.value() > complete.limit());
    Runner mended = start_diffusion({{"form", "lecture"}});
    mended.assign(assumption(mended, "the slide's formula is complete").fix()->assign);
    CHECK_FALSE(assumption(mended, "the slide's formula is complete").in_use());
    // The implicit scheme has no such form.
    CHECK_FALSE(
        assumption(start_diffusion({{"form", "lecture"}, {"scheme", "implicit"}}), "the slide's formula is complete").in_use());
}

TEST_CASE("diffusion: beyond the limit a run blows up, names the limit and can be mended", "[diffusion]") {
    const char* dimension = GENERATE("1", "2");
    const bool square = std::string_view(dimension) == "2";
    Runner runner =
        start_diffusion({{"dimension", dimension}, {"start", "random"}, {"diffusion_number", square ? "0.28" : "0.56"}});
    const Assumption& limit = assumption(runner, "stability");
    CHECK(limit.limit() == (square ? 0.25 : 0.5));
    CHECK(limit.value() > limit.limit());
    CHECK_THROWS_AS(
        [&] {
            for (int k = 0; k < 200; ++k) runner.step();
        }(),
        Diverged);
    REQUIRE(runner.failure());
    CHECK(runner.place().step > 5);  // it could be watched
    CHECK_THAT(runner.failure()->limit, ContainsSubstring(square ? "1/4 in 2D" : "1/2 in 1D") && ContainsSubstring("implicit"));
    const auto fix = runner.lesson().fix(*runner.failure());
    REQUIRE(fix);
    Runner mended = start_diffusion({{"dimension", dimension}, {"start", "random"}});
    mended.assign(fix->assign);
    for (int k = 0; k < 200; ++k) mended.step();
    check_laws(mended);
    // At the limit itself nothing grows.
    const Runner at_limit =
        after(200, {{"dimension", dimension}, {"start", "random"}, {"diffusion_number", square ? "0.25" : "0.5"}});
    CHECK(value(at_limit, "max") <= 1);
}

TEST_CASE("diffusion: the solver's passes can be stopped after, and leave ever less", "[diffusion]") {
    Runner runner =
        start_diffusion({{"scheme", "implicit"}, {"start", "step"}, {"boundary", "insulated"}, {"diffusion_number", "20"}});
    CHECK(stage_names(runner) == std::vector<std::string>{"solve"});
    runner.step_pass();
    REQUIRE(runner.inside_step());
    CHECK(field(runner, "u")[15] != field(runner, "u_before")[15]);
    while (runner.inside_step()) runner.step_pass();
    CHECK(value(runner, "solver_iterations") > 3);
    for (const Real rho : field(runner, "residual")) CHECK(std::abs(rho) < 1e-9);
    CHECK(stage_names(start_diffusion({})) == std::vector<std::string>{"neighbours", "update"});
}

TEST_CASE("diffusion: without viscosity nothing moves, with a huge one all is even at once", "[diffusion]") {
    const char* scheme = GENERATE("explicit", "implicit");
    const Runner still = after(5, {{"viscosity", "0"}, {"scheme", scheme}});
    CHECK_THAT(value(still, "factor_measured"), WithinAbs(1, 1e-15));
    CHECK(still.time() == 5);
    const Runner even = after(2, {{"viscosity", "1e6"}, {"scheme", "implicit"}, {"start", "step"}, {"diffusion_number", "1e9"}});
    for (const Real u : field(even, "u")) CHECK_THAT(u, WithinAbs(0.5, 1e-6));
    CHECK_THROWS_WITH(start_diffusion({{"viscosity", "-1"}}), ContainsSubstring("viscosity"));
    CHECK_THROWS_WITH(start_diffusion({{"viscosity", "1e-300"}}), ContainsSubstring("time step"));
}

TEST_CASE("diffusion: a wave shorter than two cells is taken for a longer one", "[diffusion]") {
    const Runner runner = after(1, {{"mode", "29"}}), shown = after(1, {{"mode", "3"}});
    for (std::size_t i = 0; i < 32; ++i) CHECK_THAT(field(runner, "u")[i], WithinAbs(field(shown, "u")[i], 1e-12));
    const Assumption& resolved = assumption(runner, "mode resolved in space");
    CHECK(resolved.value() > resolved.limit());
    Runner mended = start_diffusion({{"mode", "29"}});
    mended.assign(resolved.fix()->assign);
    CHECK(assumption(mended, "mode resolved in space").value() <= 0.125);
}

TEST_CASE("diffusion: a mode that is 0 on every cell has no amplitude and no factor, measured or exact", "[diffusion]") {
    for (const char* dimension : {"1", "2"})
        for (const auto& [mode, boundary] : {std::pair{"0", "fixed"}, {"64", "fixed"}, {"32", "insulated"}})
            for (const char* begins : {"mode", "zero", "random"}) {
                INFO(dimension << "D, mode " << mode << ", " << boundary << ", " << begins);
                const Runner runner =
                    after(2, {{"dimension", dimension}, {"mode", mode}, {"boundary", boundary}, {"start", begins}});
                for (const char* name : {"amplitude", "factor_measured", "factor_theory", "factor_exact"}) {
                    const Probe& probe = runner.lesson().probe(name);
                    CHECK_FALSE(runner.value(probe));
                    CHECK_FALSE(runner.exact(probe));
                }
                Scene scene;
                runner.lesson().draw(scene);
                CHECK(
                    std::ranges::any_of(scene.notes, [](const std::string& note) { return note.ends_with("0 in every cell"); }));
            }
    CHECK(after(2, {{"mode", "0"}, {"boundary", "insulated"}}).lesson().probe("amplitude").value());
}

TEST_CASE("diffusion: a channel has its closed form from the first moment on", "[diffusion]") {
    // Long before the other wall is felt, u = U erfc(y/(2 √(νt))).
    const Runner runner = start_diffusion({{"start", "zero"},
                                           {"boundary", "fixed"},
                                           {"wall_low", "2"},
                                           {"wall_high", "-1"},
                                           {"viscosity", "1"},
                                           {"diffusion_number", "1e-5"},
                                           {"cell_x", "0"}});
    const Real cell = 1.0 / 32;
    for (const Real t : {1e-8, 1e-6, 1e-4})
        CHECK_THAT(*runner.lesson().probe("u_selected").exact(t), WithinAbs(2 * std::erfc(cell / 2 / (2 * std::sqrt(t))), 1e-14));
    CHECK_THAT(*runner.lesson().probe("u_selected").exact(0.3), WithinRel(1.9515070625310336, 1e-12));
}

TEST_CASE("diffusion: what a light offers mends what it shows", "[diffusion]") {
    const auto check = [](const Runner::Assignments& scene, std::string_view name) {
        Runner runner = start_diffusion(scene);
        const Assumption& broken = assumption(runner, name);
        INFO(name);
        REQUIRE(broken.in_use());
        CHECK(broken.value() > broken.limit());
        const auto fix = broken.fix();
        REQUIRE(fix);
        CHECK_FALSE(fix->label.empty());
        runner.assign(fix->assign);
        const Assumption& mended = assumption(runner, name);
        CHECK((!mended.in_use() || mended.value() <= mended.limit()));
    };
    const char* dimension = GENERATE("1", "2");
    check({{"dimension", dimension}, {"diffusion_number", "0.6"}}, "stability");
    check({{"dimension", dimension}, {"scheme", "implicit"}, {"diffusion_number", "10"}}, "mode resolved in time");
    check({{"dimension", dimension}, {"mode", "20"}}, "mode resolved in space");
    check({{"dimension", dimension}, {"boundary", "fixed"}, {"mode", "1000"}}, "mode resolved in space");
    check({{"dimension", dimension}, {"form", "lecture"}}, "the slide's formula is complete");
}

TEST_CASE("diffusion: the cell of the stencil is a handle", "[diffusion]") {
    Runner row = start_diffusion({{"length", "2"}});
    CHECK(row.lesson().can_pull() == On::handle);
    using Values = std::vector<std::pair<std::string, Real>>;
    CHECK(row.lesson().dragged({0, Vec<3>::Zero(), {1.01, 5, 0}}) == Values{{"cell_x", 16}});
    CHECK(row.lesson().dragged({0, Vec<3>::Zero(), {-3, 0, 0}}) == Values{{"cell_x", 0}});
    CHECK(row.lesson().dragged({-1, Vec<3>::Zero(), {1, 0, 0}}).empty());
    const Runner square = start_diffusion({{"dimension", "2"}});
    CHECK(square.lesson().dragged({0, Vec<3>::Zero(), {0.51, 7, 0}}) == Values{{"cell_x", 16}, {"cell_y", 31}});
    // A cell that a coarser grid lacks is its last one.
    CHECK_NOTHROW(after(1, {{"resolution", "4"}, {"cell_x", "200"}}).lesson().probe("u_selected").value());
}

TEST_CASE("diffusion: the numbers of a seed are its own", "[diffusion]") {
    const auto of = [](const char* seed) {
        const Runner runner = start_diffusion({{"start", "random"}, {"seed", seed}});
        return std::vector<Real>(field(runner, "u").begin(), field(runner, "u").end());
    };
    CHECK(of("1") == of("1"));
    CHECK(of("1") != of("2"));
}

TEST_CASE("why diffusion: every number is explained at every kind of end, in both schemes and forms", "[diffusion][why]") {
    const char* dimension = GENERATE("1", "2");
    const char* boundary = GENERATE("periodic", "fixed", "insulated");
    const auto look = [&](Runner::Assignments more) {
        more.insert(more.end(), {{"dimension", dimension}, {"boundary", boundary}, {"resolution", "6"}, {"wall_low", "0.4"}});
        Runner runner = start_diffusion(more);
        check_every_stage(runner, fmt::format("diffusion {} {}", dimension, boundary), 2, 1);
    };
    look({{"start", "random"}});
    look({{"start", "mode"}, {"mode", "2"}, {"form", "lecture"}});
    look({{"start", "step"}, {"scheme", "implicit"}, {"diffusion_number", "3"}});
    look({{"start", "zero"}, {"viscosity", "0"}});
    look({{"start", "zero"}, {"mode", "1"}, {"scheme", "implicit"}, {"diffusion_number", "1e4"}});
}
