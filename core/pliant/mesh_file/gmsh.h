// Mesh files of Gmsh, .msh: version 2.2 and 4.1, as text and binary [Gmsh2009].
#pragma once
#include <pliant/mesh_file/mesh_file.h>

namespace pliant {

// What elements, nodes and physical groups a file has. Other sections are left out. Throws Refused naming the path and the line
// (of binary files: the byte) for another version, an element of a kind that is neither point, edge, triangle nor tetrahedron of
// first or second order, a node or a group that is not there, and for bytes that are no such file.
MeshFile parse_gmsh(std::string_view bytes, std::string_view path);

}  // namespace pliant
