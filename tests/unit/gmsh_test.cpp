// Mesh files of Gmsh: what is read, and what is refused with the place.
#include <pliant/math/error.h>
#include <pliant/mesh_file/gmsh.h>
#include <pliant/text/file.h>

#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <functional>
#include <numbers>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string folder = PLIANT_SOURCE_DIR "/tests/unit/meshes/";

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const Refused& e) {
        return e.what();
    }
    return "";
}

// Two triangles of a unit square, an edge on its left and one on its right.
std::string square(const std::string& nodes = "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n",
                   const std::string& triangles = "3 2 2 7 1 1 2 3\n4 2 2 7 1 1 3 4\n") {
    const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    return fmt::format(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 5 \"fixed\"\n1 6 \"loaded\"\n$EndPhysicalNames\n"
        "$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n1 1 2 5 4 4 1\n2 1 2 6 2 2 3\n{}$EndElements\n",
        lines(nodes), nodes, lines(triangles) + 2, triangles);
}

std::string refused_square(const std::string& text) {
    return refusal([&] { simplex_mesh_of<2>(parse_gmsh(text, "s.msh"), "s.msh"); });
}

std::string with(std::string text, const std::string& part, const std::string& instead) {
    const auto at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), instead);
}

}  // namespace

TEST_CASE("a Gmsh file is the same body in version 2.2 and 4.1, as text and binary", "[mesh_file]") {
    const MeshFile first = read_mesh_file(folder + "cube_41.msh");
    CHECK(first.dimension() == 3);
    for (const char* name : {"cube_22", "cube_22_binary", "cube_41", "cube_41_binary"}) {
        INFO(name);
        const std::string path = folder + name + ".msh";
        const MeshFile file = read_mesh_file(path);
        const auto mesh = simplex_mesh_of<3>(file, path);
        CHECK(mesh.node_count() == 14);
        CHECK(mesh.simplex_count() == 24);
        CHECK(std::abs(mesh.volume() - 1) < 1e-14);
        CHECK(file.points == first.points);
        CHECK(file.point_numbers == first.point_numbers);
        CHECK(file.elements[3].nodes == first.elements[3].nodes);
        // Four triangles on each of the two faces, and a group of one point.
        for (const auto& [group, x] : {std::pair{"fixed", 0.0}, {"loaded", 1.0}}) {
            const auto& facets = mesh.facets(group);
            CHECK(facets.size() == 4);
            Real area = 0;
            for (const Index f : facets) {
                area += mesh.facet_areas().col(f).norm();
                for (int a = 0; a < 3; ++a) CHECK(mesh.points()(0, mesh.facets()(a, f)) == x);
            }
            CHECK(std::abs(area - 1) < 1e-14);
        }
        REQUIRE(mesh.nodes("corner").size() == 1);
        CHECK(mesh.points().col(mesh.nodes("corner")[0]).norm() == 0);
        CHECK(mesh.nodes("body").size() == 14);
        CHECK_NOTHROW(require_facet_groups(mesh, {"fixed", "loaded"}, path));
    }
}

TEST_CASE("numbers of a machine with the other byte order are turned round", "[mesh_file]") {
    const std::string text = read_file(folder + "cube_22_binary.msh");
    const MeshFile usual = parse_gmsh(text, "usual.msh");
    std::string turned = text;
    const auto turn = [&](std::size_t at, std::size_t size) {
        std::reverse(turned.begin() + static_cast<std::ptrdiff_t>(at), turned.begin() + static_cast<std::ptrdiff_t>(at + size));
    };
    turn(text.find("2.2 1 8\n") + 8, 4);
    std::size_t at = text.find("$Nodes\n14\n") + 10;
    for (int n = 0; n < 14; ++n, at += 28) turn(at, 4), turn(at + 4, 8), turn(at + 12, 8), turn(at + 20, 8);
    at = text.find("$Elements\n33\n") + 13;
    for (const std::size_t end = text.find("\n$EndElements", at); at + 4 <= end; at += 4) turn(at, 4);
    const MeshFile other = parse_gmsh(turned, "other.msh");
    CHECK(other.points == usual.points);
    CHECK(other.elements[3].nodes == usual.elements[3].nodes);
    CHECK(other.elements[3].numbers == usual.elements[3].numbers);
}

TEST_CASE("elements of second order give their corners, and keep the middles of their edges", "[mesh_file]") {
    const MeshFile file = read_mesh_file(folder + "cube_quadratic.msh");
    REQUIRE(file.elements[3].nodes.rows() == 10);
    const auto mesh = simplex_mesh_of<3>(file, "cube_quadratic.msh");
    CHECK(mesh.node_count() == 14);
    CHECK(mesh.facets("fixed").size() == 4);
    // Of a body with straight edges each lies half way: the order of the edges is that of Gmsh.
    constexpr int edges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};
    const auto& nodes = file.elements[3].nodes;
    for (Index e = 0; e < nodes.cols(); ++e)
        for (int k = 0; k < 6; ++k) {
            const Vec<3> half = (file.points.col(nodes(edges[k][0], e)) + file.points.col(nodes(edges[k][1], e))) / 2;
            CHECK((file.points.col(nodes(4 + k, e)) - half).norm() < 1e-14);
        }
}

TEST_CASE("triangles alone make a plane body, with groups of edges", "[mesh_file]") {
    const auto mesh = simplex_mesh_of<2>(parse_gmsh(square(), "s.msh"), "s.msh");
    CHECK(mesh.node_count() == 4);
    CHECK(mesh.volume() == 1);
    REQUIRE(mesh.facets("fixed").size() == 1);
    CHECK(mesh.facet_areas().col(mesh.facets("fixed")[0]) == Vec<2>(-1, 0));
    CHECK(mesh.nodes("loaded") == std::vector<Index>{1, 2});
    // The group of the triangles has no name of its own.
    CHECK(mesh.nodes("group 7").size() == 4);
}

TEST_CASE("a mesh that makes no body is refused with the numbers of its file", "[mesh_file]") {
    CHECK(refused_square(square()) == "");
    const std::string corners = "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n", triangles = "3 2 2 7 1 1 2 3\n4 2 2 7 1 1 3 4\n";
    CHECK_THAT(refused_square(square(corners, triangles + "9 2 2 7 1 2 4 3\n")),
               ContainsSubstring("s.msh: element 9 (nodes 2, 4, 3) is inverted"));
    CHECK_THAT(refused_square(square(corners + "15 2 0 0\n", triangles + "9 2 2 7 1 1 2 15\n")),
               ContainsSubstring("s.msh: element 9 (nodes 1, 2, 15) is degenerate"));
    CHECK_THAT(refused_square(square(corners, triangles + "9 2 2 7 1 2 3 1\n")),
               ContainsSubstring("elements 3 and 9 are the same"));
    CHECK_THAT(refused_square(square(corners, triangles + "9 2 2 7 1 2 3 3\n")),
               ContainsSubstring("element 9 names node 3 twice"));
    CHECK_THAT(refused_square(square(corners + "15 2 0 0\n")), ContainsSubstring("node 15 of the mesh belongs to no element"));
    CHECK_THAT(refused_square(square("1 0 0 0\n2 1 0 0\n3 1 nan 0\n4 0 1 0\n")),
               ContainsSubstring("node 3 of the mesh has a coordinate that is not a finite number"));
    CHECK_THAT(refused_square(square("1 0 0 0\n2 1 inf 0\n3 1 1 0\n4 0 1 0\n")), ContainsSubstring("node 2"));
    CHECK_THAT(refused_square(square("1 0 0 0\n2 1 0 0\n3 1 1 2\n4 0 1 0\n")),
               ContainsSubstring("z of node 1 is 0 m and of node 3 2 m"));
    CHECK_THAT(refusal([] { simplex_mesh_of<3>(parse_gmsh(square(), "s.msh"), "s.msh"); }),
               ContainsSubstring("the mesh is of dimension 2, where one of 3"));
    const auto mesh = simplex_mesh_of<2>(parse_gmsh(square(), "s.msh"), "s.msh");
    CHECK_THAT(refusal([&] {
                   require_facet_groups(mesh, {"fixed", "held"}, "s.msh");
               }),
               ContainsSubstring("the group 'held' of edges on the boundary is missing; the file has fixed, loaded"));
}

TEST_CASE("what is no Gmsh file, or not a whole one, is refused with its line", "[mesh_file]") {
    const auto refused = [](const std::string& text) { return refusal([&] { parse_gmsh(text, "s.msh"); }); };
    CHECK_THAT(refused(""), ContainsSubstring("s.msh:1: a Gmsh file begins with $MeshFormat"));
    CHECK_THAT(refused(with(square(), "2.2 0 8", "4 0 8")),
               ContainsSubstring("s.msh:2: version 4 is not read; save the mesh as version 4.1 or 2.2"));
    CHECK_THAT(refused(with(square(), "2.2 0 8", "2.2 0 4")), ContainsSubstring("numbers of 4 bytes are not read"));
    CHECK_THAT(refused(with(square(), "3 2 2 7 1 1 2 3", "3 3 2 7 1 1 2 3 4")), ContainsSubstring("a quadrangle is not read"));
    CHECK_THAT(refused(with(square(), "3 2 2 7 1 1 2 3", "3 77 2 7 1 1 2 3")),
               ContainsSubstring("s.msh:20: element type 77 is not known"));
    CHECK_THAT(refused(with(square(), "1 1 2 3\n4", "1 1 2 33\n4")),
               ContainsSubstring("element 3 names node 33, which is not there"));
    CHECK_THAT(refused(with(square(), "4 0 1 0", "3 0 1 0")), ContainsSubstring("s.msh:14: node 3 is given twice"));
    CHECK_THAT(refused(with(square(), "3 1 1 0", "3 1 one 0")), ContainsSubstring("s.msh:13: 'one' is not a number"));
    CHECK_THAT(refused(with(square(), "$Nodes\n4", "$Nodes\n4000000000")),
               ContainsSubstring("4000000000 nodes are announced, but the file is too short"));
    CHECK_THAT(refused(with(square(), "$EndElements\n", "")), ContainsSubstring("'$EndElements' should stand here"));
    CHECK_THAT(refused(square().substr(0, square().find("$Elements"))), ContainsSubstring("the section $Elements is missing"));
    CHECK_THAT(refusal([] { parse_mesh_file("", "body.stp"); }),
               ContainsSubstring("body.stp: a mesh is read from a file that ends in .msh"));
    const std::string binary = read_file(folder + "cube_41_binary.msh");
    CHECK_THAT(refused(binary.substr(0, binary.size() / 2)), ContainsSubstring("s.msh:byte "));
}

TEST_CASE("every body of assets/meshes is whole, and has the groups that lessons need", "[mesh_file]") {
    for (const char* body : {"beam", "bracket", "hook", "dumbbell", "animal", "plate_with_hole", "gear"}) {
        Index coarse_elements = 0;
        for (const char* size : {"coarse", "fine"}) {
            const std::string path = fmt::format("{}/assets/meshes/{}_{}.msh", PLIANT_SOURCE_DIR, body, size);
            INFO(path);
            const MeshFile file = read_mesh_file(path);
            const auto check = [&](const auto& mesh) {
                CHECK_NOTHROW(require_facet_groups(mesh, {"fixed", "loaded"}, path));
                const auto parts = mesh.connected_parts();
                CHECK(std::ranges::all_of(parts, [](int p) { return p == 0; }));
                CHECK(mesh.simplex_count() > 2 * coarse_elements);
                coarse_elements = mesh.simplex_count();
            };
            file.dimension() == 3 ? check(simplex_mesh_of<3>(file, path)) : check(simplex_mesh_of<2>(file, path));
        }
    }
}
