// What a run leaves for other programs: states as VTU, a run as PVD, fields in the JSON. Read by meshio, where it is installed.
#include "pliant.h"

using namespace pliant::test;

namespace {

// A Python that has meshio; "" for none.
std::string python_with_meshio() {
    for (const char* python : {"/usr/bin/python3", "python3"})
        if (run_process(python, {"-c", "import meshio"}, {}).exit_code == 0) return python;
    return "";
}

// All that meshio finds in a file, as JSON: points, and the lists of cells, of point arrays, of cell arrays and of other arrays.
constexpr const char* reads_with_meshio = R"(
import json, sys, meshio, numpy
m = meshio.read(sys.argv[1])
rows = lambda a: numpy.asarray(a).tolist()
print(json.dumps({"points": rows(m.points), "cells": {c.type: rows(c.data) for c in m.cells},
                  "on_points": {k: rows(v) for k, v in m.point_data.items()},
                  "on_cells": {k: rows(v[0]) for k, v in m.cell_data.items()},
                  "apart": {k: rows(v) for k, v in m.field_data.items()}}))
)";

Json read_by_meshio(const std::string& python, const std::string& path) {
    const Outcome outcome = run_process(python, {"-c", reads_with_meshio, path}, {});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return Json::parse(outcome.out);
}

std::vector<std::string> field_names(const std::string& lesson) {
    std::vector<std::string> names;
    const Json described = json_of({"describe", lesson});
    for (const Json& f : described["fields"]) names.push_back(f["name"]);
    return names;
}

// The lessons with a body or a grid: those that write one.
bool writes_grid(const std::string& lesson, const std::string& path) {
    const Outcome outcome = call({"run", lesson, "--steps", "1", "--vtu", path});
    if (outcome.exit_code == 0) return true;
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "no body and no grid"));
    return false;
}

}  // namespace

TEST_CASE("every lesson: its grid is read by another program, with every field", "[process][every_lesson]") {
    const std::string python = python_with_meshio();
    if (python.empty()) SKIP("python3-meshio is not installed: scripts/prepare");
    for (const std::string& lesson : every_lesson()) {
        INFO(lesson);
        const Scratch scratch;
        const std::string path = scratch.path("state.vtu");
        if (!writes_grid(lesson, path)) continue;
        const Json grid = read_by_meshio(python, path);
        CHECK_FALSE(grid["points"].empty());
        CHECK_FALSE(grid["cells"].empty());
        std::size_t read = grid["on_points"].size() + grid["on_cells"].size();
        // Those in use, one by one: the others are refused.
        std::size_t used = 0, found = 0;
        for (const std::string& name : field_names(lesson)) {
            const Outcome outcome = call({"run", lesson, "--steps", "1", "--json", "--fields", name});
            if (outcome.exit_code != 0) continue;
            ++used;
            const Json field = Json::parse(outcome.out)["fields"][name];
            const Json* const rows = grid["on_points"].contains(name)  ? &grid["on_points"][name]
                                     : grid["on_cells"].contains(name) ? &grid["on_cells"][name]
                                                                       : nullptr;
            if (!rows) continue;
            ++found;
            INFO(name);
            REQUIRE(rows->size() == field["value"].size());
            for (std::size_t r = 0; r < rows->size(); ++r) {
                const Json &a = (*rows)[r], &b = field["value"][r];
                if (b.is_array()) {
                    if (b.size() == 2) CHECK((a[0] == b[0] && a[1] == b[1] && a[2] == 0));
                    if (b.size() == 3 || b.size() == 9) CHECK(a == b);
                } else {
                    CHECK((a == b || a == Json::array({b})));
                }
            }
        }
        CHECK(used > 0);
        CHECK(found == read);
        CHECK(contains(contents_of(path), "TimeValue"));
    }
}

TEST_CASE("a run as PVD has the first frame, the physical time and every field in each file", "[process]") {
    const Scratch scratch;
    const std::string path = scratch.path("run.pvd");
    output_of({"run", "mesh/rod", "--steps", "3", "--set", "scene=wave", "--set", "time_step=1e-4", "--vtu", path});
    const std::string collection = contents_of(path);
    for (int step = 0; step <= 3; ++step) {
        const std::string name = "run/step_00000" + std::to_string(step) + ".vtu";
        INFO(name);
        CHECK(contains(collection, "file=\"" + name + "\""));
        const std::string state = contents_of(scratch.path(name)), first = contents_of(scratch.path("run/step_000000.vtu"));
        int arrays = 0;
        for (const std::string& field : field_names("mesh/rod")) {
            const std::string array = "Name=\"" + field + "\"";
            CHECK(contains(state, array) == contains(first, array));
            arrays += contains(state, array);
        }
        CHECK(arrays > 5);
    }
    CHECK(contains(collection, "timestep=\"0\""));
    CHECK(contains(collection, "timestep=\"0.0001\""));
    CHECK(scratch.names() == std::vector<std::string>{"run", "run.pvd"});

    // A static lesson has no clock: its solves are counted.
    output_of({"run", "elasticity/moduli", "--set", "resolution=1", "--vtu", scratch.path("solved.pvd")});
    CHECK(contains(contents_of(scratch.path("solved.pvd")), "timestep=\"1\""));
}

TEST_CASE("the points of a file are where the nodes of the run are", "[process]") {
    const std::string python = python_with_meshio();
    if (python.empty()) SKIP("python3-meshio is not installed: scripts/prepare");
    const Scratch scratch;
    const std::string path = scratch.path("s.vtu");
    const Json run = json_of({"run", "mesh/mass_spring", "--steps", "5", "--vtu", path, "--fields", "velocity"});
    const Json grid = read_by_meshio(python, path);
    CHECK(grid["on_points"]["velocity"] == run["fields"]["velocity"]["value"]);
    CHECK(run["fields"]["velocity"]["on"] == "node");
    CHECK(run["fields"]["velocity"]["unit"] == "m/s");
    CHECK(grid["points"].size() == run["fields"]["velocity"]["value"].size());
    CHECK(grid["cells"].contains("line"));
}

TEST_CASE("what cannot be written as a grid, and fields that are not there, are refused before the run", "[process]") {
    const Scratch scratch;
    refusal({"run", "mesh/rod", "--vtu", scratch.path("a.png")}, {"--vtu", "give a name that ends in .vtu or .pvd"});
    refusal({"run", "mesh/rod", "--vtu", scratch.path("none/a.vtu")}, {"cannot be written"});
    refusal({"run", "elasticity/strain_measures", "--vtu", scratch.path("a.vtu")}, {"no body and no grid"});
    refusal({"run", "mesh/rod", "--json", "--fields", "strian"}, {"strian", "did you mean 'strain'?"});
    CHECK(call({"run", "mesh/rod", "--fields", "strain"}).exit_code == 2);
    CHECK(scratch.names().empty());
}

TEST_CASE("a run that breaks down leaves the frames before it, and no last state", "[process]") {
    const Scratch scratch;
    const Arguments broken{"run",   "mesh/mass_spring", "--steps", "2000", "--set", "integrator=explicit_euler",
                           "--set", "time_step=0.05",   "--vtu"};
    for (const char* name : {"b.vtu", "b.pvd"}) {
        Arguments call_of = broken;
        call_of.push_back(scratch.path(name));
        const Outcome outcome = call(call_of);
        INFO(outcome.err);
        CHECK(outcome.exit_code == diverged);
    }
    CHECK_FALSE(fs::exists(scratch.path("b.vtu")));
    CHECK(contains(contents_of(scratch.path("b.pvd")), "step_000000.vtu"));
    CHECK_FALSE(contains(contents_of(scratch.path("b/step_000000.vtu")), "nan"));
}
