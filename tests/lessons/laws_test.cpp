// What should be conserved is measured against how the run began: a run that blows up does not widen its own tolerance, and
// rounding alone breaks no law.
#include <pliant/document/report.h>
#include <pliant/document/summary.h>
#include <pliant/run/runner.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cmath>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

// A number that doubles in every step, under laws whose authors tolerate half of it.
class Doubling final : public Lesson {
    Number first{*this, {.key = "first", .initial = 1, .useful = {0, 10}}};
    Number offset{*this, {.key = "offset", .useful = {0, 1e9}, .accepted = Interval{0, 1e12}}};
    Number noise{*this, {.key = "noise", .useful = {0, 1}}};
    std::array<Real, 1> x_{};

    Real half() const { return std::abs(x_[0]) / 2; }

public:
    Doubling() {
        state = {state_array("x", "m", x_)};
        fields = {{.name = "x", .unit = "m", .view = view_of(x_)}};
        stages = {{.name = "double", .run = [this] { x_[0] *= 2; }, .writes = {"x"}}};
        probes = {{.name = "x", .unit = "m", .value = [this] { return x_[0]; }},
                  {.name = "difference", .unit = "m", .value = [this] { return Real{noise}; }}};
        conserved = {{.probe = "x", .law = Law::never_grows, .tolerance = [this] { return half(); }},
                     {.probe = "x", .law = Law::constant, .tolerance = [this] { return half(); }},
                     {.probe = "x", .law = Law::zero, .tolerance = [this] { return 2 * half(); }},
                     {.probe = "difference",
                      .law = Law::zero,
                      .tolerance = [] { return Real{0}; },
                      .cancels = [this] { return Real{offset}; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return 1; }
    void reset() override { x_[0] = first; }
    void draw(Scene&) const override {}
};
const LessonEntry doubling{{.id = "test/doubling", .title = "Doubling", .summary = ""},
                           [] { return std::unique_ptr<Lesson>(new Doubling); }};

std::size_t law_of(const Runner& runner, std::string_view probe) {
    const auto& laws = runner.lesson().conserved;
    return static_cast<std::size_t>(std::ranges::find(laws, probe, &Conserved::probe) - laws.begin());
}

}  // namespace

TEST_CASE("laws: what a run makes of itself does not widen what it is allowed") {
    Runner runner(doubling);
    for (const std::size_t i : {0u, 1u}) CHECK(runner.tolerance(i) == 0.5);
    for (int n = 0; n < 20; ++n) {
        runner.step();
        for (const std::size_t i : {0u, 1u}) {
            CHECK(runner.holds(i) == Holds::no);
            CHECK(runner.tolerance(i) == 0.5);
        }
        // What should be zero is a part of what cancels now.
        CHECK(runner.holds(2) == Holds::yes);
    }
    CHECK_THAT(run_text(runner), ContainsSubstring("violated") && ContainsSubstring("tolerated 500 mm"));
    CHECK_THAT(summary_text(runner), ContainsSubstring("should never grow, and this fails"));
    // Back where it began it holds again, and once more it does not.
    REQUIRE(runner.go_to({0, 0}));
    CHECK(runner.holds(0) == Holds::yes);
    REQUIRE(runner.go_to({3, 0}));
    CHECK(runner.holds(0) == Holds::no);
    // A slider that is moved is a new beginning.
    runner.assign({{"noise", "0.5"}});
    CHECK(runner.tolerance(0) == 4);
    CHECK(runner.holds(0) == Holds::yes);
}

TEST_CASE("laws: rounding of the terms that cancel breaks none") {
    Runner runner(doubling, {{"offset", "1e9"}, {"noise", "1e-3"}});
    CHECK(runner.holds(3) == Holds::yes);
    runner.assign({{"noise", "1"}});
    CHECK(runner.holds(3) == Holds::no);
    runner.assign({{"noise", "1e-3"}, {"offset", "0"}});
    CHECK(runner.holds(3) == Holds::no);
}

TEST_CASE("laws: energy that grows because a scheme is unstable is told, whatever the scheme") {
    for (const Runner::Assignments& scene : {Runner::Assignments{{"integrator", "explicit_euler"}, {"damping_mode", "none"}},
                                             {{"integrator", "semi_implicit_euler"}, {"time_step", "0.02"}},
                                             {{"integrator", "runge_kutta_4"}, {"time_step", "0.02"}}}) {
        Runner runner(find_lesson("mesh/mass_spring"), scene);
        const std::size_t energy = law_of(runner, "energy");
        bool failed = false;
        try {
            for (int n = 0; n < 2000 && !failed; ++n) runner.step(), failed = runner.holds(energy) == Holds::no;
        } catch (const Diverged&) {
            failed = runner.holds(energy) == Holds::no;
        }
        CHECK(failed);
    }
}

TEST_CASE("laws: they hold where nothing moves, and what does not swing has no frequency") {
    const auto check = [](std::string_view lesson, const Runner::Assignments& scene) {
        Runner runner(find_lesson(lesson), scene);
        for (int n = 0; n < 400; ++n) runner.step();
        for (std::size_t i = 0; i < runner.lesson().conserved.size(); ++i) {
            INFO(lesson << ", " << runner.lesson().conserved[i].probe << " is off by " << runner.drift(i));
            CHECK(runner.holds(i) != Holds::no);
        }
        for (const Probe& p : runner.lesson().probes)
            if (p.name == "frequency") CHECK_FALSE(runner.value(p));
    };
    for (const char* scheme : {"velocity_verlet", "semi_implicit_euler", "implicit_midpoint", "runge_kutta_4"}) {
        for (const char* scene : {"wave", "free_end", "fixed_end"})
            for (const char* amplitude : {"0", "1e-17"})
                check("mesh/rod", {{"scene", scene}, {"amplitude", amplitude}, {"gravity", "0"}, {"scheme", scheme}});
        check("mesh/rod", {{"scene", "released"}, {"gravity", "0"}, {"scheme", scheme}});
    }
    for (const char* integrator : {"semi_implicit_euler", "implicit_euler", "velocity_verlet"})
        for (const char* scene : {"drop", "hang", "spin"})
            check("mesh/mass_spring", {{"scene", scene},
                                       {"gravity", "0"},
                                       {"spin", "0"},
                                       {"damping_mode", "none"},
                                       {"cells_x", "2"},
                                       {"cells_y", "2"},
                                       {"cells_z", "2"},
                                       {"integrator", integrator}});
    check("mesh/cloth", {{"nodes", "5"}, {"gravity", "0"}});
    check("time/integration", {{"x0", "0"}, {"v0", "0"}});
    check("fluids/navier_stokes", {{"scene", "box"}, {"stirring", "0"}, {"resolution", "8"}});
}
