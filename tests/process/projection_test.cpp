// The extremes of a pressure projection from the command line: finite, or reported with the number that matters and exit code 3.
#include "pliant.h"

using namespace pliant::test;

namespace {

Outcome projected(const Arguments& settings) {
    Arguments arguments{"run", "fluids/projection", "--json"};
    for (const std::string& s : settings) arguments.insert(arguments.end(), {"--set", s});
    return call(arguments);
}

Json probes(const Arguments& settings) {
    const Outcome outcome = projected(settings);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return Json::parse(outcome.out);
}

const Arguments solvers{"solver=cg", "solver=jacobi", "solver=incomplete_cholesky", "solver=multigrid"};

}  // namespace

TEST_CASE("projection: all solid is a finite no-op, and so is one cell among solids", "[process][projection]") {
    for (const std::string obstacle : {"obstacle=all_solid", "obstacle=one_cell"}) {
        for (const std::string& solver : solvers) {
            const Json p = probes({"field=random", obstacle, solver});
            CHECK(value(p, "solver_iterations") == 0);
            CHECK(value(p, "max_divergence") == 0);
            CHECK(value(p, "kinetic_energy") == 0);
            CHECK(value(p, "cell_pressure") == 0);
        }
    }
}

TEST_CASE("projection: a closed box of fluid, and two closed rooms, to the tolerance", "[process][projection]") {
    for (const std::string obstacle : {"obstacle=none", "obstacle=two_rooms"}) {
        for (const std::string& solver : solvers) {
            const Json p = probes({"field=random", obstacle, solver, "tolerance=1e-8"});
            CHECK(value(p, "max_divergence") <= 1.01e-8 * value(p, "max_divergence_before"));
            CHECK(value(p, "null_dimension") == (obstacle == "obstacle=none" ? 1 : 2));
        }
    }
}

TEST_CASE("projection: a flow that does not balance is reported with its net flux", "[process][projection]") {
    const Outcome outcome = projected({"field=through_flow", "outflow=0.25"});
    CHECK(outcome.exit_code == diverged);
    CHECK(contains(outcome.err, "net 0.75 m^2/s"));
    const Json failure = Json::parse(outcome.out)["failure"];
    CHECK(failure["stage"] == "pressure");
    CHECK(failure["field"] == "velocity");
    // Balanced, but not in each of two rooms.
    const Outcome rooms = projected({"field=through_flow", "obstacle=two_rooms"});
    CHECK(rooms.exit_code == diverged);
    CHECK(contains(rooms.err, "net 1 m^2/s"));
    CHECK(projected({"field=through_flow"}).exit_code == 0);
}

TEST_CASE("projection: a solver at its cap ends with the residual and the divergence left", "[process][projection]") {
    for (const std::string& more : {solvers[0], solvers[1], solvers[2], solvers[3], std::string("grid=collocated")}) {
        const Outcome outcome = projected({"field=random", "max_iterations=1", more});
        INFO(more << "\n" << outcome.err);
        CHECK(outcome.exit_code == diverged);
        CHECK(contains(outcome.err, "after 1 iterations the residual is"));
        CHECK(contains(outcome.err, "the largest divergence left is"));
        const Json run = Json::parse(outcome.out);
        CHECK(run["failure"]["stage"] == "pressure");
        CHECK(contains(run["failure"]["limit"].get<std::string>(), "within 1 iterations"));
    }
}

TEST_CASE("projection: bad settings are refused by name", "[process][projection]") {
    for (const auto& [setting, key] : {std::pair{"tolerance=0", "tolerance"},
                                       {"tolerance=2", "tolerance"},
                                       {"max_iterations=0", "max_iterations"},
                                       {"resolution=0", "resolution"},
                                       {"time_step=0", "time_step"},
                                       {"solver=gauss", "solver"}}) {
        const Outcome outcome = projected({setting});
        INFO(setting);
        CHECK(outcome.exit_code == 2);
        CHECK(contains(outcome.err, key));
    }
}
