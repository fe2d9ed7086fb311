// Mesh files of VTK, with triangles or tetrahedra of first or second order: .vtk, as text or binary, and .vtu, with its numbers
// as text, base64 or raw, compressed by zlib or not [VTK2006]. Of a .vtk with polygons (POLYDATA) triangles are read.
#pragma once
#include <pliant/mesh_file/mesh_file.h>

namespace pliant {

// Arrays that are 0 or 1 everywhere are sets by their name: of points, or of the cells of each dimension. Points and cells count
// from 0. All throw Refused naming the path, and the line (or byte) of a .vtk or the array of a .vtu.
MeshFile parse_vtk_legacy(std::string_view bytes, std::string_view path);
MeshFile parse_vtu(std::string_view bytes, std::string_view path);

}  // namespace pliant
