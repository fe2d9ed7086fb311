// The advection lesson: its schemes against theory and the exact solution, its ends, and its explanations in corner cases.
#include "readings.h"
#include "why_checks.h"

#include <pliant/run/runner.h>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner start_advection(const Runner::Assignments& parameters) { return Runner(find_lesson("fluids/advection"), parameters); }

void run(Runner& runner, int steps) {
    for (int k = 0; k < steps; ++k) runner.step();
}

// After one turn of a solid rotation at Courant number 2.
Real difference_after_a_turn(const char* scheme, const char* resolution, int steps) {
    Runner runner =
        start_advection({{"blob", "smooth"}, {"radius", "0.2"}, {"resolution", resolution}, {"cfl", "2"}, {"scheme", scheme}});
    run(runner, steps);
    return value(runner, "difference");
}

}  // namespace

TEST_CASE("advection: a blob in a translation spreads as theory says, at any fraction of a cell", "[advection]") {
    const auto [cfl, steps] = GENERATE(std::pair{"0.5", 64}, std::pair{"0.25", 96}, std::pair{"2.3", 20});
    Runner runner = start_advection({{"field", "translation"}, {"blob", "hill"}, {"radius", "0.1"}, {"cfl", cfl}});
    run(runner, steps);
    // Exact for a sum over an endless grid; the blob's tails do not reach around the box yet.
    CHECK_THAT(value(runner, "measured_viscosity"), WithinRel(value(runner, "theory_viscosity"), 1e-6));
    check_laws(runner);
}

TEST_CASE("advection: a whole number of cells per step loses nothing", "[advection]") {
    for (const char* scheme : {"semi_lagrangian_linear", "monotone_cubic", "mac_cormack"}) {
        INFO(scheme);
        Runner runner = start_advection(
            {{"field", "translation"}, {"blob", "slotted_disc"}, {"cfl", "4"}, {"resolution", "32"}, {"scheme", scheme}});
        run(runner, 8);
        CHECK_THAT(value(runner, "turns"), WithinRel(1.0, 1e-12));
        CHECK(value(runner, "variance_left") == 1);
        CHECK(value(runner, "difference") == 0);
    }
}

TEST_CASE("advection: after a turn the better schemes are closer, and finer grids help them more", "[advection]") {
    const Real linear = difference_after_a_turn("semi_lagrangian_linear", "32", 50),
               corrected = difference_after_a_turn("mac_cormack", "32", 50),
               cubic = difference_after_a_turn("monotone_cubic", "32", 50);
    CHECK(corrected < 0.4 * linear);
    CHECK(cubic < 0.4 * linear);
    CHECK(difference_after_a_turn("semi_lagrangian_linear", "64", 101) > 0.45 * linear);
    CHECK(difference_after_a_turn("mac_cormack", "64", 101) < 0.4 * corrected);
}

TEST_CASE("advection: Euler's path throws the blob outward, the midpoint rule keeps it", "[advection]") {
    const auto far = [](const char* trace) {
        Runner runner = start_advection({{"back_trace", trace}, {"scheme", "mac_cormack"}, {"cfl", "4"}});
        run(runner, 25);
        return value(runner, "difference");
    };
    CHECK(far("euler") > 3 * far("midpoint"));
}

TEST_CASE("advection: the exact solution of the vortex follows closed streamlines", "[advection]") {
    // Where the blob is, the stream function of the fluid is that of where it was: compare ψ-sorted contents by the mean of ψ.
    Runner runner = start_advection({{"field", "vortex"}, {"blob", "smooth"}, {"resolution", "64"}, {"cfl", "1"}});
    const auto mean_psi = [&] {
        const auto q = field(runner, "exact");
        Real sum = 0, all = 0;
        for (std::size_t c = 0; c < q.size(); ++c) {
            const Real x = (static_cast<Real>(c % 64) + 0.5) / 64, y = (static_cast<Real>(c / 64) + 0.5) / 64;
            sum += q[c] * std::pow(std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y), 2);
            all += q[c];
        }
        return std::pair{sum / all, all};
    };
    run(runner, 1);
    const auto [psi, content] = mean_psi();
    run(runner, 80);
    CHECK_THAT(mean_psi().first, WithinRel(psi, 2e-3));
    CHECK_THAT(mean_psi().second, WithinRel(content, 2e-3));
    // The profile runs through the place that the middle has come to.
    Curve exact;
    std::ranges::find(runner.lesson().lines, "profile", &Line::name)->reference(exact);
    CHECK(std::ranges::max(exact.value) > 0.8);
}

TEST_CASE("advection: values stay between 0 and 1 at any Courant number, in every field and scheme", "[advection]") {
    const char* flow = GENERATE("translation", "rotation", "vortex");
    const char* cfl = GENERATE("0.1", "1", "5", "20", "100", "200");
    Runner runner = start_advection({{"field", flow},
                                     {"blob", "slotted_disc"},
                                     {"cfl", cfl},
                                     {"resolution", "24"},
                                     {"compare", "true"},
                                     {"direction", "30"},
                                     {"scheme", "mac_cormack"}});
    for (int k = 0; k < 6; ++k) {
        runner.step();
        check_laws(runner);
    }
    for (const char* name : {"quantity", "linear", "cubic", "mac_cormack", "exact"})
        for (const Real q : field(runner, name)) CHECK((q >= -1e-12 && q <= 1 + 1e-12));
    // The run that is compared is the run alone.
    CHECK(std::ranges::equal(field(runner, "quantity"), field(runner, "mac_cormack")));
}

TEST_CASE("advection: a blob between the cells, and one that is lost altogether, have no undefined numbers", "[advection]") {
    for (const Runner::Assignments& parameters :
         {Runner::Assignments{{"blob", "slotted_disc"}, {"radius", "0.01"}, {"resolution", "8"}, {"compare", "true"}},
          {{"blob", "slotted_disc"}, {"resolution", "24"}, {"cfl", "100"}},
          {{"blob", "slotted_disc"}, {"resolution", "24"}, {"cfl", "200"}, {"field", "vortex"}, {"back_trace", "euler"}}}) {
        Runner runner = start_advection(parameters);
        run(runner, 3);
        for (const Probe& probe : runner.lesson().probes)
            if (const auto x = runner.value(probe)) CHECK(std::isfinite(*x));
        check_every_stage(runner, "a lost blob", 1);
    }
}

TEST_CASE("advection: of a blob that no cell sees no number is measured, and none is exact", "[advection]") {
    Runner runner = start_advection({{"blob", "slotted_disc"}, {"radius", "0.01"}, {"resolution", "8"}});
    run(runner, 2);
    for (const char* name : {"variance_left", "loss_per_turn", "difference", "measured_viscosity"}) {
        INFO(name);
        const Probe& probe = runner.lesson().probe(name);
        CHECK_FALSE(runner.value(probe));
        CHECK_FALSE(runner.exact(probe));
    }
    CHECK_FALSE(runner.exact(runner.lesson().probe("peak")));
}

TEST_CASE("advection: the mark of a cell goes where the hand goes", "[advection]") {
    Runner runner = start_advection({{"resolution", "32"}});
    const auto values = runner.lesson().dragged(Pull{0, {0.5, 0.5, 0}, {0.26, 2.0, 0}});
    REQUIRE(values.size() == 2);
    CHECK(values[0] == std::pair<std::string, Real>{"cell_x", 8});
    CHECK(values[1] == std::pair<std::string, Real>{"cell_y", 31});
    CHECK(runner.lesson().dragged(Pull{-1, {0, 0, 0}, {1, 1, 0}}).empty());
}

TEST_CASE("advection: a scheme that is changed on the way takes effect with the next step, and going back restores the old one",
          "[advection]") {
    Runner runner = start_advection({{"resolution", "24"}});
    run(runner, 3);
    runner.assign("scheme", 2);
    runner.assign("cfl", 2);
    run(runner, 2);
    const std::vector<Real> there(field(runner, "quantity").begin(), field(runner, "quantity").end());
    REQUIRE(runner.step_back());
    runner.step();
    CHECK(std::ranges::equal(there, field(runner, "quantity")));
}

TEST_CASE("advection: every number is explained, in each scheme, over walls and around the box", "[advection]") {
    const char* flow = GENERATE("translation", "rotation", "vortex");
    const char* scheme = GENERATE("semi_lagrangian_linear", "monotone_cubic", "mac_cormack");
    const char* trace = GENERATE("euler", "midpoint");
    const char* cfl = GENERATE("0.7", "23");
    Runner runner = start_advection({{"field", flow},
                                     {"scheme", scheme},
                                     {"back_trace", trace},
                                     {"cfl", cfl},
                                     {"resolution", "12"},
                                     {"blob", "hill"},
                                     {"direction", "200"},
                                     {"compare", "true"}});
    check_every_stage(runner, std::string(flow) + " " + scheme + " " + trace, 2);
}

TEST_CASE("advection: the fixes mend what they promise", "[advection]") {
    const std::vector<std::pair<std::string, Runner::Assignments>> broken{{"path resolved", {{"cfl", "40"}}},
                                                                          {"path resolved", {{"back_trace", "euler"}}},
                                                                          {"blob resolved", {{"resolution", "16"}}}};
    for (const auto& [name, parameters] : broken) {
        INFO(name);
        Runner runner = start_advection(parameters);
        const Assumption& a = *std::ranges::find(runner.lesson().assumptions, name, &Assumption::name);
        REQUIRE(a.value() > a.limit());
        const auto fix = a.fix();
        REQUIRE(fix);
        runner.assign(Runner::Assignments(fix->assign.begin(), fix->assign.end()));
        runner.step();
        CHECK(a.value() <= a.limit());
    }
}
