// What is written for other programs, read again by the reader of meshes.
#include <pliant/document/report.h>
#include <pliant/document/vtu.h>
#include <pliant/lesson/registry.h>
#include <pliant/lesson/unstructured_grid.h>
#include <pliant/mesh_file/mesh_file.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

#include <limits>

namespace pliant {
namespace {

using Catch::Matchers::ContainsSubstring;

// A tetrahedron with a scalar on its corners, a plane vector on them, a tensor on itself, and something on its edges.
struct Tetrahedron final : Lesson {
    VecX flag = (VecX(4) << 0, 1, 1, 1).finished(), plane = VecX::LinSpaced(8, 0, 7), tensor = VecX::LinSpaced(9, 1, 9),
         edges = VecX::Ones(6);
    Switch bodiless{*this, setting_of("bodiless", "", false)};
    Tetrahedron() {
        fields = {
            scalar_field("loaded", "l", "", On::node, flag, ""), plane_vector_field("plane", "v", "m/s", On::node, plane, ""),
            tensor_field("stress", "σ", "Pa", On::element, tensor, ""), scalar_field("edges", "e", "m", On::edge, edges, "")};
    }
    int dimension() const override { return 3; }
    void reset() override {}
    Real time_step() const override { return 0; }
    void draw(Scene&) const override {}
    std::optional<UnstructuredGrid> unstructured_grid() const override {
        if (bodiless) return std::nullopt;
        Points<3> x(3, 4);
        x << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
        return grid_of(x, CellKind::tetrahedron, Eigen::Vector4i(0, 1, 2, 3), {On::element});
    }
};
const Registration<Tetrahedron> tetrahedron{{.id = "time/tetrahedron", .title = "Tetrahedron", .summary = ""}};

}  // namespace

TEST_CASE("a state as VTU is a mesh, with each field where it lives") {
    Tetrahedron lesson;
    const LessonEntry& entry = find_lesson("time/tetrahedron");
    const std::string text = vtu_text(entry, lesson, 0.25);
    const auto mesh = simplex_mesh_of<3>(parse_mesh_file(text, "t.vtu"), "t.vtu");
    CHECK(mesh.node_count() == 4);
    CHECK(std::abs(mesh.volume() - 1.0 / 6) < 1e-15);
    CHECK(mesh.facets("loaded").size() == 1);
    const auto place = [&](const char* what) { return text.find(what); };
    CHECK(place("Name=\"plane\" unit=\"m/s\" NumberOfComponents=\"3\"") > place("<PointData>"));
    CHECK(place("Name=\"plane\"") < place("</PointData>"));
    CHECK(place("Name=\"stress\" unit=\"Pa\" NumberOfComponents=\"9\"") > place("<CellData>"));
    CHECK(place("Name=\"edges\"") < place("</FieldData>"));
    CHECK(place("Name=\"TimeValue\"") < place("</FieldData>"));
    lesson.edges[2] = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_AS(vtu_text(entry, lesson, 0), Refused);
    lesson.bodiless.set(1);
    try {
        require_grid(entry, lesson);
        FAIL("a lesson without a body is accepted");
    } catch (const Refused& e) {
        CHECK_THAT(e.what(), ContainsSubstring("time/tetrahedron has no body and no grid"));
    }
}

TEST_CASE("a regular grid has its cells in the order of the numbers on them") {
    const UnstructuredGrid flat = regular_grid({1, 2, 0}, {0.5, 0.25, 1}, 3, 2, 0, {On::cell});
    CHECK(flat.cell_count() == 6);
    CHECK(flat.of_cells(On::cell, 6));
    CHECK_FALSE(flat.of_cells(On::cell, 5));
    CHECK_FALSE(flat.of_points(On::node, 12));
    // Cell 4 is the second of the upper row; its corners go round.
    const auto corner = [&](int a) -> Vec<3> { return flat.points.col(flat.cells[0].nodes(a, 4)); };
    CHECK(corner(0) == Vec<3>(1.5, 2.25, 0));
    CHECK(corner(1) == Vec<3>(2, 2.25, 0));
    CHECK(corner(2) == Vec<3>(2, 2.5, 0));
    CHECK(corner(3) == Vec<3>(1.5, 2.5, 0));
    const UnstructuredGrid deep = regular_grid({0, 0, 0}, {1, 1, 1}, 2, 2, 3, {On::cell});
    CHECK(deep.cell_count() == 12);
    CHECK(nodes_of(deep.cells[0].kind) == 8);
    const Points<3> last = deep.points(Eigen::all, deep.cells[0].nodes.col(11));
    CHECK(last.col(0) == Vec<3>(1, 1, 2));
    CHECK(last.col(6) == Vec<3>(2, 2, 3));
}

TEST_CASE("fields go into the report as they are asked for") {
    const Runner run(find_lesson("time/tetrahedron"), {}, 0);
    const auto j = nlohmann::json::parse(run_json(run, {}, nullptr, {"plane", "loaded"}));
    CHECK(j["fields"].size() == 2);
    CHECK(j["fields"]["loaded"] == nlohmann::json{{"unit", ""}, {"on", "node"}, {"value", {0.0, 1.0, 1.0, 1.0}}});
    CHECK(j["fields"]["plane"]["value"] == nlohmann::json{{0.0, 1.0}, {2.0, 3.0}, {4.0, 5.0}, {6.0, 7.0}});
    CHECK_FALSE(nlohmann::json::parse(run_json(run, {})).contains("fields"));
    CHECK_THROWS_AS(run_json(run, {}, nullptr, {"plain"}), Refused);
}

TEST_CASE("a collection names its files and their times") {
    CHECK_THAT(pvd_text({{0, "a/step_000000.vtu"}, {0.5, "a/step_000001.vtu"}}),
               ContainsSubstring("<DataSet timestep=\"0.5\" part=\"0\" file=\"a/step_000001.vtu\"/>"));
}

}  // namespace pliant
