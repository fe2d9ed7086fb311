// The lattices of the mass-spring lesson as materials and as chains, and all integrators on them.
#include "readings.h"
#include "why_checks.h"

#include <pliant/run/until.h>
#include <pliant/time/scheme.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using Assignments = Runner::Assignments;

Runner net(const Assignments& settings) { return Runner(find_lesson("mesh/mass_spring"), settings); }

Assignments joined(Assignments settings, const Assignments& more) {
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
}

const Assignments chain{{"scene", "swing"}, {"lattice", "chain"}, {"cells_y", "10"},        {"k_structural", "1"},
                        {"mass", "11"},     {"k_bending", "0"},   {"damping_mode", "none"}, {"time_step", "0.05"}};
const Assignments static_test{
    {"scene", "stretch_test"}, {"cells_x", "2"}, {"cells_y", "2"}, {"cells_z", "2"}, {"k_bending", "0"}};

}  // namespace

TEST_CASE("mass-spring: a chain swings at the frequencies of the closed form, with every integrator") {
    for (const SchemeInfo& scheme : schemes()) {
        if (scheme.scheme == Scheme::explicit_euler) continue;
        INFO(scheme.key);
        Runner runner = net(joined(chain, {{"integrator", std::string(scheme.key)}}));
        CHECK_THAT(exact(runner, "frequency"), WithinAbs(0.14946019, 5e-9));
        advance(runner, Until::after_time(100));
        CHECK_THAT(value(runner, "frequency"), WithinRel(0.14946019, 2e-4));
    }
    Runner third = net(joined(chain, {{"mode_number", "3"}}));
    CHECK_THAT(exact(third, "frequency"), WithinAbs(0.73068205, 5e-9));
    Runner both = net(joined(chain, {{"support", "both"}, {"mode_number", "2"}, {"cells_y", "11"}, {"mass", "12"}}));
    CHECK_THAT(exact(both, "frequency"), WithinRel(2 * std::sin(2 * 3.14159265358979 / 22), 1e-12));
    advance(both, Until::after_time(30));
    CHECK_THAT(value(both, "frequency"), WithinRel(exact(both, "frequency"), 1e-3));
    // Only chains swing, whatever lattice was chosen.
    CHECK(exact(net(joined(chain, {{"lattice", "square"}})), "frequency") == exact(net(chain), "frequency"));
    CHECK_THROWS_WITH(net(joined(chain, {{"mode_number", "11"}})), ContainsSubstring("mode = 11"));
}

TEST_CASE("mass-spring: every integrator goes back over its steps to the bit, through impacts") {
    for (const SchemeInfo& scheme : schemes()) {
        INFO(scheme.key);
        Runner runner = net({{"integrator", std::string(scheme.key)},
                             {"cells_x", "2"},
                             {"cells_y", "2"},
                             {"cells_z", "1"},
                             {"time_step", "0.005"},
                             {"drop_height", "0.02"},
                             {"k_structural", "100"}});
        for (int n = 0; n < 20; ++n) runner.step();
        const auto end = state_hash(runner.lesson());
        for (int n = 0; n < 9; ++n) REQUIRE(runner.step_back());
        for (int n = 0; n < 9; ++n) runner.step();
        CHECK(state_hash(runner.lesson()) == end);
    }
}

TEST_CASE("mass-spring: every pass of every integrator is explained, through an impact") {
    for (const SchemeInfo& scheme : schemes()) {
        Runner runner = net({{"integrator", std::string(scheme.key)},
                             {"lattice", "square"},
                             {"cells_x", "1"},
                             {"cells_y", "1"},
                             {"time_step", "0.005"},
                             {"drop_height", "0.005"}});
        // Up to the impact, and through what follows.
        while (value(runner, "touching_nodes") == 0 && runner.place().step < 20) runner.step();
        CHECK(value(runner, "touching_nodes") > 0);
        REQUIRE(runner.step_back());
        check_every_stage(runner, std::string(scheme.key), 2);
    }
}

TEST_CASE("mass-spring: the static test measures the lattice, and all of it is explained") {
    for (const char* lattice : {"cubic_face", "cubic_body", "square", "triangular"}) {
        INFO(lattice);
        Runner runner = net(joined(static_test, {{"lattice", lattice}, {"shared_edges", "true"}}));
        CHECK(runner.is_static());
        runner.step();
        CHECK(runner.lesson().at_rest());
        CHECK_THAT(value(runner, "youngs_modulus"), WithinRel(exact(runner, "youngs_modulus"), 1e-9));
        CHECK_THAT(value(runner, "poisson_ratio"), WithinRel(exact(runner, "poisson_ratio"), 1e-7));
        for (const char* kind : {"stretch", "shear", "bend"}) {
            Runner other = net(joined(static_test, {{"lattice", lattice}, {"test", kind}, {"k_bending", "20"}}));
            other.step();
            check_every_stage(other, lattice);
            CHECK(value(other, "stiffness_ratio") > 0.3);
            CHECK_THAT(value(other, "coupling_structural") + value(other, "coupling_shear") + value(other, "coupling_bending"),
                       WithinRel(1, 1e-12));
        }
    }
    Runner single = net(joined(static_test, {{"lattice", "chain"}}));
    single.step();
    CHECK_THAT(value(single, "test_stiffness"), WithinRel(100, 1e-12));
    Runner bent = net(joined(static_test, {{"lattice", "chain"}, {"test", "bend"}}));
    bent.step();
    CHECK(value(bent, "test_stiffness") == value(single, "test_stiffness"));
}

TEST_CASE("mass-spring: a solid of the lattice's own Poisson ratio stretches as the net does, if its outer springs are shared") {
    const Assignments isotropic = joined(static_test, {{"k_shear", "200"}, {"shared_edges", "true"}});
    Runner own = net(isotropic);
    own.step();
    CHECK_THAT(value(own, "stiffness_ratio"), WithinRel(1, 1e-9));
    const auto light = [](const Runner& runner) {
        const Assumption& a =
            *std::ranges::find(runner.lesson().assumptions, std::string_view("poisson_ratio"), &Assumption::name);
        return a.value() <= a.limit();
    };
    CHECK(light(own));
    Runner wished = net(joined(isotropic, {{"target_poisson", "0.45"}}));
    wished.step();
    CHECK_FALSE(light(wished));
}

TEST_CASE("mass-spring: a mechanism is reported, and motions of rest length 0 are finite") {
    Runner folds = net(joined(static_test, {{"k_shear", "0"}}));
    CHECK_THROWS_WITH(folds.step(), ContainsSubstring("singular") && ContainsSubstring("mechanisms unconstrained"));
    Runner collapses =
        net({{"rest_length_scale", "0"}, {"scene", "spin"}, {"lattice", "square"}, {"cells_x", "2"}, {"cells_y", "1"}});
    for (int n = 0; n < 50; ++n) collapses.step();
    check_every_stage(collapses, "rest length 0");
    CHECK(std::isfinite(value(collapses, "energy")));
}

TEST_CASE("mass-spring: a test of no springs at all is refused, one that folds says which springs are missing") {
    for (const char* lattice : {"cubic_face", "cubic_body", "square", "triangular", "chain"}) {
        INFO(lattice);
        const Assignments none = joined(static_test, {{"lattice", lattice}, {"k_structural", "0"}, {"k_shear", "0"}});
        CHECK_THROWS_AS(net(none), Refused);
        CHECK_THROWS_WITH(net(none), ContainsSubstring("no springs") && ContainsSubstring("k_structural"));
    }
    // Without a test they are masses that fall freely.
    CHECK_NOTHROW(net({{"k_structural", "0"}, {"k_shear", "0"}, {"k_bending", "0"}}));
    const auto told = [](const Assignments& settings) {
        Runner runner = net(joined(static_test, settings));
        try {
            advance(runner, Until::at_rest());
        } catch (const Diverged& d) {
            for (const Probe& p : runner.lesson().probes) CHECK_NOTHROW((runner.value(p), runner.exact(p)));
            return d.failure.limit;
        }
        return std::string("none");
    };
    CHECK_THAT(told({{"k_shear", "0"}}), ContainsSubstring("shear springs"));
    CHECK_THAT(told({{"k_structural", "0"}}), ContainsSubstring("structural springs"));
    CHECK_THAT(told({{"k_structural", "1e15"}, {"k_shear", "1e-3"}}), ContainsSubstring("nearer to each other"));
}

TEST_CASE("mass-spring: a solid beside the net that its elements cannot bear leaves the net's numbers") {
    for (const char* kind : {"stretch", "shear", "bend"})
        for (const char* ratio : {"0.4999999999999999", "-0.9999999999999999"}) {
            INFO(kind << " " << ratio);
            Runner runner = net(joined(static_test, {{"test", kind}, {"target_poisson", ratio}})),
                   usual = net(joined(static_test, {{"test", kind}}));
            advance(runner, Until::at_rest());
            advance(usual, Until::at_rest());
            const char* stiffness = std::string_view(kind) == "bend" ? "bending_stiffness" : "test_stiffness";
            CHECK(value(runner, stiffness) == value(usual, stiffness));
            Scene scene;
            runner.lesson().draw(scene);
        }
}
