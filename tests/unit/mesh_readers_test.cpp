// Mesh files of VTK, Wavefront and STL: the same cube in all of them, and what is refused.
#include <pliant/math/error.h>
#include <pliant/mesh_file/mesh_file.h>
#include <pliant/text/file.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <functional>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string readers_folder = PLIANT_SOURCE_DIR "/tests/unit/meshes/";

std::string reader_refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const Refused& e) {
        return e.what();
    }
    return "accepted";
}
std::string refused_bytes(const std::string& bytes, const std::string& name) {
    return reader_refusal([&] { surface_of(parse_mesh_file(bytes, name), name); });
}
std::string changed(std::string text, const std::string& part, const std::string& instead) {
    const auto at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), instead);
}

Real enclosed_volume(const TriangleSurface& s) {
    Real sum = 0;
    for (Index t = 0; t < s.triangles.cols(); ++t) {
        const auto x = [&](int k) -> Vec<3> { return s.points.col(s.triangles(k, t)); };
        sum += x(0).dot(x(1).cross(x(2))) / 6;
    }
    return sum;
}

}  // namespace

TEST_CASE("files of VTK hold the same body as that of Gmsh, with its named sets", "[mesh_file]") {
    const MeshFile first = read_mesh_file(readers_folder + "cube_41.msh");
    for (const char* name : {"cube_42.vtk", "cube_42_binary.vtk", "cube_51.vtk", "cube_51_binary.vtk", "cube_text.vtu",
                             "cube_zlib.vtu", "cube_raw.vtu", "cube_base64.vtu"}) {
        INFO(name);
        const std::string path = readers_folder + name;
        const MeshFile file = read_mesh_file(path);
        const auto mesh = simplex_mesh_of<3>(file, path);
        CHECK(mesh.node_count() == 14);
        CHECK(mesh.simplex_count() == 24);
        CHECK(std::abs(mesh.volume() - 1) < 1e-14);
        CHECK(file.points == first.points);
        CHECK(file.elements[3].nodes == first.elements[3].nodes);
        for (const auto& [group, x] : {std::pair{"fixed", 0.0}, {"loaded", 1.0}}) {
            const auto& facets = mesh.facets(group);
            CHECK(facets.size() == 4);
            for (const Index f : facets)
                for (int a = 0; a < 3; ++a) CHECK(mesh.points()(0, mesh.facets()(a, f)) == x);
        }
        CHECK_NOTHROW(require_facet_groups(mesh, {"fixed", "loaded"}, path));
    }
}

TEST_CASE("a file of VTK of second order gives its corners, in the order of Gmsh behind them", "[mesh_file]") {
    const MeshFile gmsh = read_mesh_file(readers_folder + "cube_quadratic.msh");
    const MeshFile vtk = read_mesh_file(readers_folder + "cube_quadratic.vtu");
    CHECK(vtk.elements[3].nodes == gmsh.elements[3].nodes);
    const auto mesh = simplex_mesh_of<3>(vtk, "cube_quadratic.vtu");
    CHECK(mesh.node_count() == 14);
    CHECK(std::abs(mesh.volume() - 1) < 1e-14);
    CHECK(mesh.facets("fixed").size() == 4);
}

TEST_CASE("surfaces of OBJ and STL are closed, point outward and keep their names", "[mesh_file]") {
    for (const char* name : {"cube.obj", "cube.stl", "cube_binary.stl", "cube_41.msh", "cube_zlib.vtu"}) {
        INFO(name);
        const TriangleSurface s = surface_of(read_mesh_file(readers_folder + name), name);
        CHECK(s.points.cols() == 14);
        CHECK(s.triangles.cols() == 24);
        CHECK(std::abs(enclosed_volume(s) - 1) < 1e-12);
        if (std::string_view(name).ends_with(".stl")) continue;
        CHECK(s.sets.at("fixed").size() == 4);
        CHECK(s.sets.at("loaded").size() == 4);
    }
}

TEST_CASE("a surface leaves out points of no triangle, and refuses a triangle without an area", "[mesh_file]") {
    const std::string obj = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\n";
    const TriangleSurface one = surface_of(parse_mesh_file(obj + "f 2 3 4\n", "a.obj"), "a.obj");
    CHECK(one.points.cols() == 3);
    CHECK_THAT(refused_bytes(obj + "f 2 3 5\n", "a.obj"),
               ContainsSubstring("a.obj: triangle 1 has two corners at the same point"));
    CHECK(surface_of(parse_mesh_file("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "q.obj"), "q.obj").triangles.cols() == 2);
}

TEST_CASE("what is no mesh of these kinds is refused with its place", "[mesh_file]") {
    CHECK_THAT(refused_bytes("v 0 0\n", "a.obj"), ContainsSubstring("a.obj:1: the file ends where a number should stand"));
    CHECK_THAT(refused_bytes("v 0 0 0\n\nf 1 2 3\n", "a.obj"),
               ContainsSubstring("a.obj:3: face 1 names point 2, and there are 1 so far"));
    CHECK_THAT(refused_bytes("v 0 0 x\n", "a.obj"), ContainsSubstring("a.obj:1: 'x' is not a number"));
    CHECK_THAT(refused_bytes("v 0 0 nan\n", "a.obj"), ContainsSubstring("a.obj:1: "));
    CHECK_THAT(refused_bytes("# nothing\n", "a.obj"), ContainsSubstring("no face"));
    CHECK_THAT(refused_bytes("solid s\nfacet normal 0 0 0\nouter loop\nvertex 1 2\nendloop", "a.stl"),
               ContainsSubstring("a.stl:5: "));
    CHECK_THAT(refused_bytes("solid s\nendsolid s\n", "a.stl"), ContainsSubstring("there is no triangle"));
    const std::string stl = read_file(readers_folder + "cube_binary.stl");
    CHECK_THAT(refused_bytes("x" + stl.substr(1, 600), "a.stl"), ContainsSubstring("the file is too short for them"));

    const std::string vtk = read_file(readers_folder + "cube_51.vtk");
    CHECK_THAT(refused_bytes(changed(vtk, "UNSTRUCTURED_GRID", "STRUCTURED_POINTS"), "a.vtk"),
               ContainsSubstring("a data set of the kind structured_points is not read"));
    CHECK_THAT(refused_bytes(changed(vtk, "CELL_TYPES 24\n10", "CELL_TYPES 24\n12"), "a.vtk"),
               ContainsSubstring("cell 0 is a hexahedron, which is not read"));
    CHECK_THAT(refused_bytes(changed(vtk, "POINTS 14", "POINTS 14000"), "a.vtk"),
               ContainsSubstring("the file is too short for them"));
    CHECK_THAT(refused_bytes(vtk.substr(0, 300), "a.vtk"), ContainsSubstring("a.vtk:"));
    CHECK_THAT(refused_bytes("hello\n", "a.vtk"), ContainsSubstring("a VTK file begins with"));

    const std::string vtu = read_file(readers_folder + "cube_text.vtu");
    CHECK_THAT(refused_bytes("<VTKFile", "a.vtu"), ContainsSubstring("this is no XML"));
    CHECK_THAT(refused_bytes("<a/>", "a.vtu"), ContainsSubstring("begins with <VTKFile>"));
    CHECK_THAT(refused_bytes(changed(vtu, "\"UnstructuredGrid\"", "\"PolyData\""), "a.vtu"),
               ContainsSubstring("'PolyData' is not read"));
    CHECK_THAT(refused_bytes(changed(vtu, "NumberOfPoints=\"14\"", "NumberOfPoints=\"13\""), "a.vtu"),
               ContainsSubstring("'points' has 42 numbers where 39 are announced"));
    const std::string raw = read_file(readers_folder + "cube_raw.vtu");
    CHECK_THAT(refused_bytes(raw.substr(0, raw.size() - 45), "a.vtu"),
               ContainsSubstring("the file ends in the middle of an array"));
    CHECK_THAT(refused_bytes(changed(raw, "offset=\"0\"", "offset=\"99999\""), "a.vtu"),
               ContainsSubstring("behind the end of the file"));
    CHECK_THAT(refused_bytes("x", "a.step"), ContainsSubstring("ends in .msh, .vtu, .vtk, .obj, .stl, not in '.step'"));
}

TEST_CASE("groups of one name and two dimensions keep all their nodes; a group inside the body is told apart from a missing one",
          "[mesh_file]") {
    // Two triangles of a square; "fixed" is an edge on the left and the point opposite, "loaded" the diagonal between them.
    const std::string text =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n0 4 \"fixed\"\n1 5 \"fixed\"\n1 6 \"loaded\"\n"
        "$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n5\n1 15 2 4 1 2\n2 1 2 5 4 4 1\n"
        "3 1 2 6 2 1 3\n4 2 2 7 1 1 2 3\n5 2 2 7 1 1 3 4\n$EndElements\n";
    const auto mesh = simplex_mesh_of<2>(parse_mesh_file(text, "s.msh"), "s.msh");
    CHECK(mesh.nodes("fixed") == std::vector<Index>{0, 1, 3});
    CHECK(mesh.facets("fixed").size() == 1);
    CHECK_THAT(reader_refusal([&] { require_facet_groups(mesh, {"loaded"}, "s.msh"); }),
               ContainsSubstring("s.msh: the group 'loaded' is there, but it is not made of edges on the boundary"));
    CHECK_THAT(
        reader_refusal([&] { require_facet_groups(mesh, {"pressed"}, "s.msh"); }),
        ContainsSubstring(
            "the group 'pressed' of edges on the boundary is missing; the file has fixed; of other elements group 7, loaded"));
}
