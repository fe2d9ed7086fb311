// Extremes of finite elements on the command line.
#include "pliant.h"

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace pliant::test;

namespace {

const Arguments fem_run{"run", "mesh/fem", "--steps", "1"};

// A file with these tetrahedra on a unit corner; the first three nodes fixed, another face loaded.
std::string mesh_with(const std::string& name, const std::string& nodes, int node_count, const std::string& tetrahedra,
                      int count) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / ("pliant_fem_" + name + ".msh");
    std::ofstream out(path);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"fixed\"\n2 2 \"loaded\"\n3 3 "
           "\"body\"\n$EndPhysicalNames\n"
        << "$Nodes\n"
        << node_count << "\n"
        << nodes << "$EndNodes\n$Elements\n"
        << count + 2 << "\n1 2 2 1 1 1 2 3\n2 2 2 2 2 1 2 4\n"
        << tetrahedra << "$EndElements\n";
    return path.string();
}

Outcome run_of(const std::string& file) {
    return call(with(fem_run, {"scene=own", "mesh_file=" + file, "model=linear", "load_y=-1"}));
}

}  // namespace

TEST_CASE("fem: numbers that make no body are refused by name", "[process]") {
    for (const char* setting :
         {"youngs_modulus=0", "youngs_modulus=-1", "youngs_modulus=nan", "poisson_ratio=0.5", "poisson_ratio=0.6",
          "poisson_ratio=-1", "poisson_ratio=-1.2", "poisson_ratio=inf", "length=0", "length=-1", "height=nan", "cells_x=0",
          "cells_x=1.5", "load_y=inf", "load_steps=0", "element=cubic", "model=rubber", "mesh_file=/nowhere/part.msh"}) {
        const Outcome outcome = call(with(fem_run, {setting}));
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, std::string(setting).substr(0, std::string(setting).find('='))));
    }
}

TEST_CASE("fem: extreme materials stay finite and say where they lock", "[process]") {
    for (const char* element : {"element=linear", "element=quadratic"}) {
        const Json almost = json_of(with(fem_run, {"model=linear", "poisson_ratio=0.4999", "cells_x=4", element}));
        CHECK(std::isfinite(value(almost, "tip_y")));
        const Json widening = json_of(with(fem_run, {"model=linear", "poisson_ratio=-0.9", "cells_x=4", element}));
        CHECK(value(widening, "tip_y") < 0);
    }
    const Json straight = json_of(with(fem_run, {"model=linear", "poisson_ratio=0", "load_y=0", "load_x=100"}));
    CHECK(std::abs(value(straight, "tip_x") - 100 / (0.04 * 1e6)) < 1e-9);
    CHECK(std::abs(value(straight, "tip_y")) < 1e-12);
    CHECK(value(json_of(with(fem_run, {"load_y=0"})), "tip_y") == 0);
}

TEST_CASE("fem: a load beyond every equilibrium is reported, and not written as a result", "[process]") {
    // St. Venant–Kirchhoff that is pressed below a stretch of 0.58 softens.
    const Outcome pressed = call(with(fem_run, {"model=stvk", "load_y=0", "load_x=-5e4"}));
    if (pressed.exit_code != 0) {
        CHECK(pressed.exit_code == diverged);
        CHECK(contains(pressed.err, "Newton"));
    }
    const Outcome crushed = call(with(fem_run, {"model=neo_hookean", "load_y=-1e12"}));
    CHECK(crushed.exit_code == diverged);
    CHECK(contains(crushed.err, "steps"));
    // A half turn of the whole is nothing to the corotational model.
    const Json turned = json_of(with(
        fem_run, {"scene=twist", "turned=support", "twist_angle=180", "load_steps=4", "cells_x=3", "cells_y=1", "cells_z=1"}));
    CHECK(value(turned, "strain_energy") <= 1e-12 * 1e6 * 0.04);
}

TEST_CASE("fem: files that hold no body are refused with their numbers", "[process]") {
    const std::string corner = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
    const Outcome good = run_of(mesh_with("good", corner, 4, "3 4 2 3 3 1 2 3 4\n", 1));
    INFO(good.err);
    CHECK(good.exit_code == 0);
    // Node 4 in the plane of the others.
    const Outcome flat = run_of(mesh_with("flat", "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n", 4, "3 4 2 3 3 1 2 3 4\n", 1));
    CHECK(flat.exit_code == refused);
    CHECK(contains(flat.err, "3"));
    const Outcome inverted = run_of(mesh_with("inverted", corner, 4, "3 4 2 3 3 1 3 2 4\n", 1));
    CHECK(inverted.exit_code == refused);
    const Outcome twice = run_of(mesh_with("twice", corner, 4, "3 4 2 3 3 1 2 3 3\n", 1));
    CHECK(twice.exit_code == refused);
    const Outcome missing = run_of(mesh_with("missing", corner, 4, "3 4 2 3 3 1 2 3 9\n", 1));
    CHECK(missing.exit_code == refused);
    const Outcome unused = run_of(mesh_with("unused", corner + "5 3 3 3\n", 5, "3 4 2 3 3 1 2 3 4\n", 1));
    CHECK(unused.exit_code == refused);
    CHECK(contains(unused.err, "5"));
}

TEST_CASE("fem: slivers and parts that nothing holds are computed or told", "[process]") {
    const std::string corner = "1 0 0 0\n2 1 0 0\n3 0 1 0\n", one = "3 4 2 3 3 1 2 3 4\n";
    // A tetrahedron of dihedral angles of a tenth of a degree bends, at rest and in motion.
    const std::string sliver = mesh_with("sliver", corner + "4 0.3 0.3 0.0005\n", 4, one, 1);
    CHECK(value(json_of(with(fem_run, {"scene=own", "mesh_file=" + sliver, "load_y=-1"})), "tip_y") < 0);
    const Json moving = json_of({"run", "mesh/fem", "--steps", "5", "--set", "scene=own", "--set", "mesh_file=" + sliver, "--set",
                                 "load_y=-1", "--set", "motion=dynamic"});
    CHECK(value(moving, "stable_time_step") > 0);
    CHECK(std::isfinite(value(moving, "tip_y")));

    // A second part that floats: no equilibrium, and said so.
    const Outcome parts =
        run_of(mesh_with("parts", corner + "4 0 0 1\n5 3 0 0\n6 4 0 0\n7 3 1 0\n8 3 0 1\n", 8, one + "4 4 2 3 3 5 6 7 8\n", 2));
    CHECK(parts.exit_code == refused);
    CHECK(contains(parts.err, "6 rigid modes unconstrained"));
}
