// The mass-spring lesson: what its scenes, dampers and integrators must show.
#include "readings.h"

#include <pliant/document/scene_file.h>
#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct Run : Runner {
    using Setting = std::pair<std::string, std::string>;
    explicit Run(std::initializer_list<Setting> settings = {}) : Runner(find_lesson("mesh/mass_spring"), Assignments(settings)) {}
    Run(const Run&) = delete;
    Real probe(std::string_view name) const { return value(lesson().probe(name)).value(); }
    bool has(std::string_view field) const { return lesson().find_field(field)->in_use(); }
    const Assumption& assumption(std::string_view name) const {
        for (const Assumption& a : lesson().assumptions)
            if (a.name == name) return a;
        throw Refused("no such assumption");
    }
    void run_time(Real seconds) { advance(*this, Until::after_time(seconds)); }
};

}  // namespace

TEST_CASE("mass-spring: the stages stand in the lecture's order, and only those that the scene needs") {
    Run run;
    CHECK(stage_names(run) == Names{"spring_forces", "damping_forces", "external_forces", "integrate", "contact"});
    Run bare({{"scene", "spin"}, {"damping_mode", "none"}});
    CHECK(stage_names(bare) == Names{"spring_forces", "integrate"});
    CHECK_FALSE(bare.has("damping_force"));
    CHECK_FALSE(bare.has("external_force"));
    CHECK(bare.lesson().find_field("damping_force")->view().empty());
}

TEST_CASE("mass-spring: terms and springs come and go while it runs") {
    Run run({{"scene", "hang"}});
    const auto springs = [&] { return run.lesson().field("tension").size(); };
    const Index all = springs();
    run.step();
    run.assign({{"k_bending", "0"}, {"damping_mode", "none"}});
    run.step();
    CHECK(springs() < all);
    CHECK_FALSE(run.has("damping_force"));
    run.assign({{"k_bending", "20"}, {"damping_mode", "naive"}, {"integrator", "implicit_euler"}});
    run.step();
    CHECK(springs() == all);
    CHECK(run.has("damping_force"));
    run.assign({{"k_structural", "0"}, {"k_shear", "0"}, {"k_bending", "0"}});
    run.step();
    CHECK(run.lesson().fields.back().view().empty());
    run.step();
}

TEST_CASE("mass-spring: the block falls freely, lands, and comes to rest on the ground") {
    const std::string integrator = GENERATE("semi_implicit_euler", "implicit_euler");
    Run run({{"integrator", integrator}, {"time_step", integrator == "implicit_euler" ? "0.01" : "0.001"}, {"damping", "0.2"}});
    const Real start = run.probe("height");
    run.run_time(0.3);
    CHECK_THAT(run.probe("height"), WithinAbs(start - 0.5 * 9.81 * 0.09, 0.5 * 9.81 * run.time_step() * 0.3 + 1e-9));
    advance(run, Until::at_rest());
    CHECK_THAT(run.probe("height"), WithinAbs(0.25, 0.01));
    CHECK(run.probe("touching_nodes") == 25);
    CHECK(run.probe("kinetic_energy") < 1e-6);
}

TEST_CASE("mass-spring: naive damping brakes a rotation, projected damping lets it go on") {
    const auto spun = [](std::string mode) {
        Run run({{"scene", "spin"}, {"damping_mode", mode}, {"damping", "0.05"}});
        const Real start = run.probe("angular_momentum");
        CHECK_THAT(start, WithinRel(10 * (0.25 * 2 / 4 + 0) * 0.5, 1e-12));
        run.run_time(1);
        return run.probe("angular_momentum") / start;
    };
    CHECK(spun("naive") < 1e-4);
    CHECK_THAT(spun("projected"), WithinAbs(1, 1e-12));
    CHECK_THAT(spun("none"), WithinAbs(1, 1e-12));
}

TEST_CASE("mass-spring: what should be conserved is, in every preset") {
    for (const std::string& name : preset_names("mesh/mass_spring")) {
        if (name == "explicit_blow_up") continue;
        INFO(name);
        Run run;
        run.load(preset(find_lesson("mesh/mass_spring"), name).parameters);
        const int steps = run.is_static() ? 1 : name == "stiff_implicit" ? 50 : 800;
        for (int n = 0; n < steps; ++n) {
            run.step();
            for (std::size_t c = 0; c < run.lesson().conserved.size(); ++c) {
                INFO("step " << n << ", " << run.lesson().conserved[c].probe << ", drift " << run.drift(c));
                REQUIRE(run.holds(c) != Holds::no);
            }
        }
    }
}

TEST_CASE("mass-spring: semi-implicit Euler is stable just below its limit and not above it") {
    const std::string mode = GENERATE("none", "projected", "naive");
    const auto largest_stretch = [&](Real factor) {
        Run run({{"scene", "spin"}, {"spin", "1"}, {"damping_mode", mode}});
        run.assign("time_step", factor * run.assumption("stability").limit());
        for (int n = 0; n < 1500; ++n) run.step();
        return run.probe("stretch");
    };
    CHECK(largest_stretch(0.97) < 0.01);
    // Naive damping is strongest on another mode than the springs, so that its limit errs on the safe side.
    CHECK_THROWS_AS(largest_stretch(mode == "naive" ? 1.1 : 1.03), Diverged);
}

TEST_CASE("mass-spring: a step above the limit is reported with the limit, and the state of before is kept") {
    Run run({{"k_structural", "1e12"}, {"mass", "1e-3"}, {"time_step", "1e-2"}});
    try {
        for (int n = 0; n < 100; ++n) run.step();
        FAIL("it should have diverged");
    } catch (const Diverged& e) {
        CHECK_THAT(e.what(), ContainsSubstring("stability limit") && ContainsSubstring("implicit Euler"));
        CHECK(e.failure.index >= 0);
    }
    CHECK(run.probe("stretch") < 100);

    Run none({{"scene", "spin"}, {"integrator", "explicit_euler"}, {"damping_mode", "none"}});
    CHECK(none.assumption("stability").limit() == 0);
    CHECK_THROWS_WITH(none.run_time(1), ContainsSubstring("stable at no Δt"));

    Run implicit({{"k_structural", "1e12"}, {"mass", "1e-3"}, {"time_step", "1e-2"}, {"integrator", "implicit_euler"}});
    implicit.run_time(1);
    CHECK(implicit.probe("stretch") < 1e-6);
    CHECK_THAT(implicit.probe("height"), WithinAbs(0.25, 1e-3));
}

TEST_CASE("mass-spring: every Newton iteration of an implicit step can be looked at") {
    Run run({{"integrator", "implicit_euler"}, {"time_step", "0.02"}, {"drop_height", "0"}});
    for (int n = 0; n < 3; ++n) run.step();
    run.run_to_stage("external_forces");
    Index passes = 0;
    for (; run.inside_step() && stage_names(run)[run.next_stage()] == "integrate"; ++passes) run.step_pass();
    CHECK(passes >= 2);
    CHECK(run.probe("newton_iterations_used") == passes);

    Run capped({{"integrator", "implicit_euler"}, {"time_step", "0.1"}, {"newton_iterations", "1"}, {"drop_height", "0"}});
    CHECK_THROWS_WITH(capped.step(), ContainsSubstring("did not converge") && ContainsSubstring("residual"));
}

TEST_CASE("mass-spring: implicit steps, gone back over and run again, give the same bits") {
    Run run({{"integrator", "implicit_euler"}, {"time_step", "0.02"}, {"drop_height", "0.01"}});
    for (int n = 0; n < 6; ++n) run.step();
    const auto end = state_hash(run.lesson());
    for (int n = 0; n < 4; ++n) REQUIRE(run.step_back());
    run.step_pass();
    for (int n = 0; n < 4; ++n) run.step();
    CHECK(run.place().step == 6);
    CHECK(state_hash(run.lesson()) == end);
}

TEST_CASE("mass-spring: a hand pulls a node, with every integrator") {
    const std::string integrator = GENERATE("explicit_euler", "semi_implicit_euler", "implicit_euler");
    Run run({{"scene", "hang"}, {"integrator", integrator}, {"time_step", "2e-4"}});
    const auto x = [&](Index node) { return run.lesson().field("position").view()[static_cast<std::size_t>(3 * node)]; };
    const Real before = x(0);
    run.pull(Pull{0, Vec<3>::Zero(), Vec<3>(before - 1, 0.5, 0)});
    for (int n = 0; n < 100; ++n) run.step();
    CHECK(x(0) < before - 0.05);
    run.pull(Pull{100000, Vec<3>::Zero(), Vec<3>::Zero()});
    CHECK_THROWS_WITH(run.step(), ContainsSubstring("node 100000"));
    run.pull(std::nullopt);
    run.step();
}

TEST_CASE("mass-spring: the same springs on a finer lattice make another body") {
    const auto sag = [](int cells) {
        const std::string n = std::to_string(cells);
        Run run({{"scene", "hang"},
                 {"cells_x", n},
                 {"cells_y", n},
                 {"cells_z", n},
                 {"k_structural", "20"},
                 {"k_shear", "10"},
                 {"k_bending", "0"},
                 {"integrator", "implicit_euler"},
                 {"time_step", "1"},
                 {"ground", "false"}});
        for (int i = 0; i < 30; ++i) run.step();
        return run.probe("sag");
    };
    const Real coarse = sag(1), middle = sag(2), fine = sag(4);
    CHECK(middle < 0.9 * coarse);
    CHECK(fine < 0.75 * middle);
}

TEST_CASE("mass-spring: without shear springs the block folds flat, and that is told") {
    Run run;
    run.load(preset(find_lesson("mesh/mass_spring"), "no_shear_springs").parameters);
    CHECK(run.assumption("shear_mechanism").value() > run.assumption("shear_mechanism").limit());
    run.run_time(1.5);
    CHECK(run.probe("height") < 0.05);
    CHECK(run.assumption("cell_inversion").value() > run.assumption("cell_inversion").limit());
}

TEST_CASE("mass-spring: another unit of length gives the same motion") {
    const Real unit = GENERATE(1e-5, 1e5);
    const auto stretch = [](Real length) {
        Run run;
        const Parameter& any = run.lesson().parameter("size");
        const auto text = [&](Real metres) { return any.text(metres * length); };
        run.assign({{"size", text(0.5)}, {"drop_height", text(0.5)}, {"gravity", text(9.81)}});
        run.run_time(0.4);
        return run.probe("stretch");
    };
    CHECK_THAT(stretch(unit), WithinRel(stretch(1), 1e-6));
}

TEST_CASE("mass-spring: bodies too large for a factorisation are refused by name") {
    CHECK_THROWS_WITH(Run({{"cells_x", "40"}, {"cells_y", "20"}, {"cells_z", "20"}, {"integrator", "implicit_euler"}}),
                      ContainsSubstring("cells_x = 40") && ContainsSubstring("3000 nodes"));
}
